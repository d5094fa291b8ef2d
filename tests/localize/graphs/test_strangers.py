"""Programs that use only the ONNX file and a runtime find the touches that our own stream finds."""

from __future__ import annotations

import itertools
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import onnx
import pytest
import scipy.io.wavfile

import studies
from localize.graphs import KEY

ROOT = Path(__file__).parents[3]
RECORDINGS = ROOT / "docs" / "examples" / "recordings"
EXAMPLES = ROOT / "docs" / "examples" / "onnx"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A decoder, its metadata, and a recording of twelve touches as a table."""
    folder = tmp_path_factory.mktemp("strangers")
    studies.export_decoder(RECORDINGS / "library.nc", folder / "decoder.onnx")
    (entry,) = onnx.load(folder / "decoder.onnx").metadata_props
    assert entry.key == KEY
    (folder / "about.json").write_text(entry.value)
    rate, samples = scipy.io.wavfile.read(RECORDINGS / "touches.wav")
    assert rate == 1000
    pressure = samples / np.iinfo(samples.dtype).max * 20
    np.savetxt(folder / "touches.csv", pressure, delimiter=",", header="A,B", comments="")
    return folder


def touches(lines: str) -> list[int]:
    """Points that at least eight decisions in a row name."""
    points = [int(line.split()[1]) for line in lines.splitlines()]
    changes = [0, *(np.flatnonzero(np.diff(points)) + 1), len(points)]
    return [points[a] for a, b in itertools.pairwise(changes) if b - a >= 8]


def true_points() -> list[int]:
    rows = np.loadtxt(RECORDINGS / "touches.csv", delimiter=",", skiprows=1)[:, 4].astype(int)
    return [int(b) for a, b in itertools.pairwise(rows) if b and b != a]


def run(command: list[str], folder: Path) -> str:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_python_without_our_packages(folder: Path) -> None:
    found = touches(run([sys.executable, str(EXAMPLES / "locate.py"), "decoder.onnx", "touches.csv"], folder))
    assert len(found) >= 10
    assert set(found) <= set(true_points())


@pytest.mark.slow
def test_javascript_decides_as_python_does(folder: Path) -> None:
    npm, node = shutil.which("npm"), shutil.which("node")
    if npm is None or node is None:
        pytest.skip("npm is not installed")
    # its script fetches what GPUs need from another registry
    words = [npm, "install", "--ignore-scripts", "--silent", "--no-audit", "--no-fund", "onnxruntime-node@1.30.0"]
    installed = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
    if installed.returncode:
        pytest.skip(f"npm install: {installed.stderr.strip()[-200:]}")
    shutil.copy(EXAMPLES / "locate.mjs", folder)
    python = run([sys.executable, str(EXAMPLES / "locate.py"), "decoder.onnx", "touches.csv"], folder)
    javascript = run([node, "locate.mjs", "decoder.onnx", "touches.csv", "about.json"], folder)
    assert javascript == python

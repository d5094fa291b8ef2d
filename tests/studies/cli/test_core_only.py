"""With the core alone, without CAD, 3-D, networks and plots: what works there, and the line of what does not."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from core_only import ROOT, acoustic_fem_of_core, link_core, megabytes_on_disk

import acoustic_fem
import localize
from acoustic_fem.library import export
from geometry.ground.extras import EXTRAS
from studies.cli.verbs import VERBS

RECORDINGS = ROOT / "docs" / "examples" / "recordings"
pytestmark = pytest.mark.end_to_end


@pytest.fixture(scope="module")
def core(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return link_core(tmp_path_factory.mktemp("core"))


@pytest.mark.slow
def test_the_core_takes_less_than_420_megabytes_on_disk(core: Path, tmp_path: Path) -> None:
    taken = megabytes_on_disk(core, tmp_path)
    print(f"the core on disk: {taken:.1f} MB")
    assert 200 < taken < 420


@pytest.mark.slow
def test_a_design_is_checked_without_its_parts_and_says_so(core: Path, tmp_path: Path) -> None:
    done = acoustic_fem_of_core(core, "check", "array-2x6", "--out", "found.json", folder=tmp_path)
    assert done.returncode == 3, done.stderr
    assert done.stdout.startswith("array-2x6: marginal")
    assert "torch is missing" in done.stdout.splitlines()[1]
    for extra in ("cad", "train"):
        assert f"pip install 'acoustic-fem[{extra}]'" in done.stdout
    found = json.loads((tmp_path / "found.json").read_text(encoding="utf-8"))
    assert found["printing"] is None
    assert found["quality"] is None
    assert found["coverage"] == pytest.approx(0.8, abs=0.05)


@pytest.mark.slow
@pytest.mark.parametrize("fidelity", ["lumped", "atlas"])
def test_a_design_is_solved_and_its_library_converted(core: Path, tmp_path: Path, fidelity: str) -> None:
    words = ("solve", "array-2x6", "--fidelity", fidelity, "--frequencies", "1:200:50", "--out", "library.nc")
    done = acoustic_fem_of_core(core, *words, folder=tmp_path)
    assert done.returncode == 0, done.stderr
    for kind in ("npz", "csv"):
        done = acoustic_fem_of_core(core, "convert", "library.nc", "--out", f"library.{kind}", folder=tmp_path)
        assert done.returncode == 0, done.stderr
        assert (tmp_path / f"library.{kind}").stat().st_size > 1000
    done = acoustic_fem_of_core(core, "convert", "library.nc", "--out", "library.sofa", folder=tmp_path)
    assert done.stderr == "acoustic-fem: what writes SOFA is not installed: pip install 'acoustic-fem[sofa]'\n"


@pytest.mark.slow
def test_a_library_in_sofa_is_read_without_what_writes_it(core: Path, tmp_path: Path) -> None:
    export(acoustic_fem.load(RECORDINGS / "library.nc"), tmp_path / "library.sofa")
    done = acoustic_fem_of_core(core, "convert", "library.sofa", "--out", "library.npz", folder=tmp_path)
    assert done.returncode == 0, done.stderr


@pytest.mark.slow
def test_touches_are_located_and_tracked(core: Path, tmp_path: Path) -> None:
    heard = (RECORDINGS / "library.nc", RECORDINGS / "touches.wav", "--full-scale", "20")
    done = acoustic_fem_of_core(core, "locate", *heard, "--out", "touches.jsonl", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert re.search(r"\d+ touch", done.stdout + done.stderr)
    done = acoustic_fem_of_core(core, "track", *heard, "--out", "path.csv", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "path.csv").read_text(encoding="utf-8").count("\n") > 2


@pytest.mark.slow
def test_touches_are_located_by_a_graph_without_torch(tmp_path: Path) -> None:
    library = acoustic_fem.load(RECORDINGS / "library.nc")
    localize.export_onnx(localize.BayesDecoder(library, "design"), tmp_path / "decoder.onnx")
    with_onnx = link_core(tmp_path / "site", "onnx")
    assert not (with_onnx / "torch").exists()
    heard = (RECORDINGS / "touches.wav", "--full-scale", "20")
    done = acoustic_fem_of_core(with_onnx, "locate", "decoder.onnx", *heard, folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert re.search(r"\d+ touch", done.stdout + done.stderr)


STUDY = """
base = "array-2x6"
fidelity = "lumped"
frequency = "1:100:16"
metrics = ["METRIC"]
[vary]
"tube.length" = [10, 12]
"""


@pytest.mark.slow
def test_a_sweep_needs_torch_for_predicted_accuracies_alone(tmp_path: Path) -> None:
    with_studies = link_core(tmp_path / "site", "studies")
    for metric, code in (("sensitivity_force", 0), ("predicted_top1", 1)):
        (tmp_path / "study.toml").write_text(STUDY.replace("METRIC", metric), encoding="utf-8")
        words = ("sweep", "study.toml", "--out", f"{metric}.zarr", "--workers", "1")
        done = acoustic_fem_of_core(with_studies, *words, folder=tmp_path)
        assert done.returncode == code, done.stderr
    assert "acoustic-fem[train]" in done.stderr
    assert not (tmp_path / "predicted_top1.zarr").exists()
    assert acoustic_fem_of_core(with_studies, "best", "sensitivity_force.zarr", folder=tmp_path).returncode == 0


@pytest.mark.parametrize(
    ("words", "extras"),
    [
        ("parts array-2x6 --out parts", "cad"),
        ("solve array-2x6 --out library.nc", "fem"),
        ("check array-2x6 --picture array.png", "plots"),
        ("wiring 4 36 --out wiring.png", "plots"),
        ("train library.nc --out trained", "train"),
        ("pulse library.nc recording.wav", "train"),
        ("sweep study.toml --out results.zarr", "studies"),
        ("run array-2x6 --out demo", "fem,train,studies"),
        ("studio array-2x6", "fem,train,studies,studio"),
        ("live library.nc", "live"),
        ("live library.nc --serial COM3", "serial"),
        ("record --serial COM3 --out r.wav", "serial"),
        ("locate decoder.onnx touches.wav --full-scale 20", "onnx"),
    ],
)
@pytest.mark.slow
def test_what_is_not_installed_is_told_in_one_line_before_any_work(
    core: Path, tmp_path: Path, words: str, extras: str
) -> None:
    for name in ("library.nc", "touches.wav"):
        (tmp_path / name).write_bytes((RECORDINGS / name).read_bytes())
    (tmp_path / "decoder.onnx").write_bytes(b"\x08\x0a\x12")  # as such a file begins
    words = words.replace("--out library.nc", "--out new.nc")
    done = acoustic_fem_of_core(core, *words.split(), folder=tmp_path)
    assert done.returncode == 1
    (line,) = done.stderr.strip().splitlines()
    assert re.search(rf"is not installed[:;] pip install 'acoustic-fem\[{extras}\]'", line)


def test_help_of_a_verb_needs_nothing(core: Path, tmp_path: Path) -> None:
    done = acoustic_fem_of_core(core, "optimize", "--help", folder=tmp_path)
    assert done.returncode == 0
    assert "Example" in done.stdout


def test_what_verbs_need_are_extras() -> None:
    assert {extra for entry in VERBS.values() for extra in entry.needs} <= set(EXTRAS)

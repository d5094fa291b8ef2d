"""Ten minutes in real time at 2 x 36 points. ``python benchmarks/live.py [--seconds 600] [--json]``.

A WAV file with a touch every two seconds is played by ``acoustic-fem live --replay`` in a process of its own, with the
Bayes decoder and with a network as an ONNX file. Its lines are compared with those of the same file decoded at
once. The latency runs from the moment when the last sample of a frame is there to the line that is put out; the memory
is the resident set of the process after a tenth of the time (a minute of ten) and at the end.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import threading
from pathlib import Path
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
from rich.console import Console
from rich.table import Table

import acoustic_fem
import geometry
import localize
import studies
from acoustic_fem.sound.sound_file import write_wav
from localize.live.listener import Latencies
from localize.signals.array_response import response_of

ROOT = Path(__file__).parents[1]
DESIGN = "line-2"
NOISE = 1e-3
FULL_SCALE = 4.0
PLAN = localize.TrainingPlan(seconds_per_point=1, epochs=1, microphone_noise=NOISE)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=int, default=600)
    parser.add_argument("--json", action="store_true")
    wanted = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        rows = [measured(title, Path(folder), wanted.seconds) for title in ("Bayes decoder", "network, ONNX")]
    if wanted.json:
        print(json.dumps(rows))
        return
    table = Table(title=f"{wanted.seconds} s of {DESIGN}, played in real time")
    for name in rows[0]:
        table.add_column(name, justify="left" if name == "decoder" else "right")
    for row in rows:
        table.add_row(*(f"{value:.1f}" if isinstance(value, float) else str(value) for value in row.values()))
    Console(width=160).print(table)


def measured(title: str, folder: Path, seconds: int) -> dict[str, Any]:
    """Play the file with one decoder; latencies in ms, memory in MB."""
    library = acoustic_fem.solve(geometry.prototype(DESIGN), np.arange(1.0, 201.0), fidelity="lumped")
    response = response_of(library)
    recording, out = folder / "recording.wav", folder / "lines.jsonl"
    write_wav(recording, _signals(response, seconds) / FULL_SCALE, 1000, 24)
    noise: localize.signals.NoiseChoice = "design"
    options: list[str] = []
    if title == "Bayes decoder":
        model = folder / "library.nc"
        acoustic_fem.save(library, model)
        noise, options = NOISE, ["--noise", str(NOISE)]
    else:
        model = folder / "network.onnx"
        localize.export_onnx(localize.train(response, PLAN), model)
    command = [sys.executable, "-m", "studies.cli", "live", model, "--replay", recording, "--out", out]
    command += ["--full-scale", str(FULL_SCALE), *options]
    paths = [str(ROOT), *filter(None, [os.environ.get("PYTHONPATH")])]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(paths)}
    with subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        memory, lines = _watched(process, seconds)
        if process.wait():
            raise RuntimeError(process.stderr.read().decode() if process.stderr else "")
    told = [json.loads(line) for line in lines]
    latencies = Latencies()
    for line in told:
        late = line.pop("latency", None)  # of a touch it is what the frames took as well
        if late is not None and "state" in line:
            latencies.add(late)
    at_once = folder / f"{model.stem}.jsonl"
    studies.locate_recording(
        model, recording, at_once, full_scale=FULL_SCALE, decoding=studies.Decoding(microphone_noise=noise)
    )
    offline = [json.loads(line) for line in at_once.read_text(encoding="utf-8").splitlines()]
    for line in offline:
        line.pop("latency", None)
    return {
        "decoder": title,
        "decisions": sum("state" in line for line in told),
        "offline": sum("state" in line for line in offline),
        "same": told == offline,
        "faults": sum("fault" in line or "notice" in line for line in told),
        "p50": 1e3 * latencies.percentile(50),
        "p99": 1e3 * latencies.percentile(99),
        "max": 1e3 * latencies.largest,
        "memory at first": memory[0],
        "memory at the end": memory[1],
    }


def _watched(process: subprocess.Popen[bytes], seconds: int) -> tuple[tuple[float, float], list[bytes]]:
    """MB after a tenth of the time and with the last line, and all lines."""
    lines: list[bytes] = []
    assert process.stdout is not None
    stop = threading.Event()
    sizes: list[float] = []

    def watch() -> None:
        while not stop.wait(0.25):
            if lines and json.loads(lines[-1])["time"] >= seconds / 10:
                size = _memory(process.pid)
                sizes.extend([] if size is None else [size])

    watcher = threading.Thread(target=watch)
    watcher.start()
    for line in process.stdout:
        lines.append(line)  # one by one: the watcher looks at the last
    stop.set()
    watcher.join()
    return (sizes[0], sizes[-1]), lines


def _memory(pid: int) -> float | None:
    """MB of the resident set of a process; None of one that has just ended."""
    for line in Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1]) / 1024
    return None


def _signals(response: localize.ArrayResponse, seconds: int) -> np.ndarray:
    """(n_microphone, n) Pa: a second of noise, a second of touch with it, the points in turn."""
    touches = localize.TouchGenerator(response, 0, "evaluation", 0.0).samples(0, max(1, seconds // 2)).signals
    signals = NOISE * np.random.default_rng(0).standard_normal((len(response.microphones), 1000 * seconds))
    for turn, touch in enumerate(touches.double().numpy()):
        signals[:, 2000 * turn + 500 : 2000 * turn + 1500] += touch
    return signals


if __name__ == "__main__":
    main()

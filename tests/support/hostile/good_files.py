"""One good file of every kind that a verb reads, all of one small sensor: three points, two microphones."""

from __future__ import annotations

from pathlib import Path

import cadquery as cq
import numpy as np
import scipy.io
import scipy.io.wavfile
from small_run import small_design

import acoustic_fem
import geometry
from hostile.commands import Commands
from localize import TouchGenerator
from localize.signals.array_response import response_of
from studies import Rig
from studies.run.file_list import write_file_list
from studies.test_rig import Recorder
from studies.test_rig.rig_touches import TouchSession, record_touches

STUDY = """
name = "bores"
base = "design.toml"
fidelity = "lumped"
frequency = "1:100:8"
metrics = ["distance_smallest", "sensitivity_force"]
sampling = "random"
cases = 12
seed = 1
keep = "responses"

[vary]
"tube.inner_diameter" = { from = 0.3, to = 0.8 }
"tube.length" = { from = 8, to = 30 }
"""
SEARCH = (
    STUDY.replace("sampling", "#")
    .replace("cases", "#")
    .replace("keep", "#")
    .replace(
        "[vary]",
        '[optimize]\ntrials = 8\nbatch = 4\n[[optimize.objectives]]\nmetric = "distance_smallest"\n\n[vary]',
    )
)
PROCESS = """
base = "sla-resin"
title = "the printer in room 12"
source = "test pieces of March"
hole = 0.3
hole_advised = 0.4
build_volume = [120.0, 68.0, 150.0]
"""
TOLERANCES = """
[membrane_thickness]
deviation = 0.02
source = "40 discs of our mold, measured"

[bore]
deviation = 0.03
kind = "relative"
"""
LIBRARIES = ("library.nc", "library.sofa", "library.npz", "library.csv")


def make(folder: Path, commands: Commands) -> None:
    """Fill an empty folder; each file is made by the verb that makes it for a user, where one does."""
    design = small_design()
    geometry.save_design(design, folder / "design.toml")
    for name, text in (
        ("study.toml", STUDY),
        ("search.toml", SEARCH),
        ("process.toml", PROCESS),
        ("tolerances.toml", TOLERANCES),
    ):
        (folder / name).write_text(text)
    lines = [("solve", "design.toml", "--out", "library.nc", "--fidelity", "lumped", "--frequencies", "1:500:500")]
    lines += [("convert", "library.nc", "--out", name) for name in LIBRARIES[1:]]
    lines += [
        ("train", "library.nc", "--out", "localizer", "--epochs", "1"),
        ("onnx", "library.nc", "--out", "decoder.onnx"),
        ("onnx", "localizer", "--out", "network.onnx"),
        ("sweep", "study.toml", "--out", "results.zarr", "--workers", "1"),
        ("optimize", "search.toml", "--out", "found", "--workers", "1"),
    ]
    for line in lines:
        ended = commands.run(list(line), folder, limit=600)
        assert ended.code == 0, (line, ended.err)

    _write_touches(folder)
    rig = Rig(design, 1, fidelity="lumped")
    rig.record(folder / "calibration", [1, 2, 3], Recorder(seconds=20))
    record_touches(rig, folder / "session", range(1, 4), TouchSession(takes=2, seconds=4.0, parts=("taps",)))
    _write_solids(folder)
    _write_run(folder / "ran")


def _write_touches(folder: Path) -> None:
    """Two touches in five seconds, in every format of a recording."""
    library = acoustic_fem.load(folder / "library.nc")
    drawn = TouchGenerator(response_of(library), 0, "evaluation", 0.0).samples(0, 4).signals.numpy()
    signals = 2e-4 * np.random.default_rng(0).standard_normal((2, 5000))
    for turn in range(2):
        signals[:, 500 + 2000 * turn : 1500 + 2000 * turn] += drawn[turn]
    scipy.io.wavfile.write(folder / "touches.wav", 1000, signals.T.astype(np.float32))
    names = list(library.design.microphones)
    table = np.column_stack([np.arange(5000) / 1000, signals.T])
    head = ",".join(("time", *names))
    np.savetxt(folder / "touches.csv", table, delimiter=",", header=head, comments="")
    np.savez(folder / "touches.npz", signals=signals, sample_rate=1000.0)
    scipy.io.savemat(folder / "touches.mat", {"signals": signals, "sample_rate": 1000.0})


def _write_run(folder: Path) -> None:
    """Two files of a run with their list."""
    (folder / "parts").mkdir(parents=True)
    (folder / "design.toml").write_text('name = "row"\n')
    (folder / "parts" / "lid.stl").write_bytes(b"solid")
    write_file_list(folder, ("design.toml", "parts"))


def _write_solids(folder: Path) -> None:
    """A solid of air as a user would hand it in."""
    cq.exporters.export(cq.Workplane().box(4, 3, 2), str(folder / "box.step"))

"""Good files used wrongly: options out of range, what does not belong together, outputs over inputs; bad solids."""

from __future__ import annotations

import random
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import tomlkit

from geometry.design.array_design import ArrayDesign
from geometry.schema.declared_fields import fields_of
from hostile.damage import Change

Words = tuple[str, ...]


def untouched(folder: Path, draw: random.Random) -> None:
    """Leave the files as they are: the command itself is wrong."""


# -- designs --------------------------------------------------------------------------------------------------
_VALUES = ("nan", "inf", "-1", "0", "1e300", '"text"', "[]", "true")


def design_values() -> Iterator[tuple[str, str]]:
    """Fields of the small design with values that most of them cannot have."""
    names = [field.name for field in fields_of(ArrayDesign)]
    for number, name in enumerate(names):
        for step in range(3):
            yield name.replace("*", "0"), _VALUES[(number + 3 * step) % len(_VALUES)]


def design_with(field: str, value: str) -> Change:
    """Sets a field of the design file to a value written in TOML."""

    def change(folder: Path, draw: random.Random) -> None:
        path = folder / "design.toml"
        held: Any = tomlkit.parse(path.read_text(encoding="utf-8"))
        place = held
        *above, last = field.split(".")
        for step in above:
            if isinstance(place, list):
                if not place:
                    place.append(tomlkit.inline_table())
                place = place[int(step)]
            else:
                place = place.setdefault(step, tomlkit.table())
        place[last] = tomlkit.value(value)
        path.write_text(tomlkit.dumps(held), encoding="utf-8")

    return change


# -- options --------------------------------------------------------------------------------------------------
_SOLVE = ("solve", "design.toml", "--out", "new.nc", "--fidelity", "lumped")
_GRIDS = (
    "nan:1:2",
    "1:nan:5",
    "1:100:0",
    "1:100:-5",
    "1:100:1000000000",
    "100:1:5",
    "-1:5:5",
    "0:100:5",
    "1:1e9:5",
    "1:inf:5",
    "1:100",
    "a:b:c",
    "",
    "1:100:2.5",
    "1:2:3:4",
    "1e-300:1:5",
    "9" * 4000 + ":1:2",
)


def _options() -> Iterator[Words]:
    for grid in _GRIDS:
        yield (*_SOLVE, "--frequencies", grid)
        yield ("calibrate", "calibration", "--out", "made.nc", "--fidelity", "lumped", "--frequencies", grid)
    for fidelity in ("exact", "", "LUMPED ", "1"):
        yield (*_SOLVE[:4], "--fidelity", fidelity)
    for option, values in (
        ("--epochs", ("0", "-1", "1e9", "nan", "99999999999999999999")),
        ("--seconds", ("0", "-1", "nan")),
        ("--noise", ("-1", "nan", "inf", "a", "1e300")),
        ("--seed", ("-1", "1e30", "99999999999999999999", "a")),
        ("--network", ("none", "", "1")),
        ("--stimuli", ("none", "")),
        ("--recordings", ("nowhere.toml", "design.toml", "touches.wav", "session")),
    ):
        for value in values:
            yield ("train", "library.nc", "--out", "trained", option, value)
    for option, values in (
        ("--touches", ("0", "-1", "99999999999999")),
        ("--seed", ("-1", "1.5")),
        ("--noise", ("-1", "nan", "inf")),
    ):
        for value in values:
            yield ("evaluate", "localizer", "library.nc", option, value)
    for option, values in (
        ("--full-scale", ("0", "-1", "nan", "inf", "1e300")),
        ("--noise", ("-1", "nan", "inf", "1e300")),
        ("--ambient", ("-1", "nan", "500", "a")),
        ("--reject", ("-1", "2", "nan", "0")),
        ("--library", ("nowhere.nc", "touches.wav", "design.toml", "localizer")),
    ):
        for value in values:
            yield ("locate", "library.nc", "touches.wav", option, value)
            yield ("live", "library.nc", "--replay", "touches.wav", option, value)
    for value in ("A=0", "A=1,A=2", "C=1", "A=1", "A=1,B=1", "A=9,B=99", "=", "A=x", "A=1,B=2,C=3"):
        yield ("live", "library.nc", "--channels", value)
    for option, values in (
        ("--samples", ("0", "-1", "99999999999999", "nan")),
        ("--base", ("-1", "99999999999999")),
        ("--library", ("-1", "99999999999999")),
        ("--seed", ("-1", "1.5")),
        ("--noise", ("nan", "-1")),
        ("--tolerances", ("nowhere.toml", "design.toml")),
    ):
        for value in values:
            yield ("tolerance", "design.toml", "--out", "scatter", option, value)
    for option, values in (
        ("--angles", ("", "a", "nan", "1e9", "0,,90", "-5", "0,inf")),
        ("--bore", ("0", "-1", "nan", "1e9", "inf")),
        ("--length", ("0", "-1", "nan", "1e9")),
        ("--diameter", ("0", "-1", "nan", "0.1")),
        ("--outside", ("0", "0.1", "nan", "-1")),
        ("--end", ("none", "")),
    ):
        for value in values:
            yield ("bend", "--out", "bent", "--fidelity", "lumped", option, value)
    for value in ("0", "-1", "a", "1e3", "99999999999"):
        yield ("sweep", "study.toml", "--out", "new.zarr", "--workers", value)
        yield ("optimize", "search.toml", "--out", "searched", "--workers", value)
    for value in ("0", "-1", "a", "1e3"):
        yield ("best", "results.zarr", "--count", value)
    for value in ("nowhere", "tcp://256.256.256.256:99999", "http://x", ""):
        yield ("sweep", "study.toml", "--out", "new.zarr", "--scheduler", value)
    for value in ("none", "", "tube.length"):
        yield ("best", "results.zarr", "--by", value)
    for value in ("-1", "99", "a", "1e3", "1.5"):
        yield ("best", "results.zarr", value, "--out", "one.toml")
    for value in ("sls", "nowhere.toml", "", "touches.wav"):
        yield ("parts", "design.toml", "--out", "printed", "--process", value)
    yield ("parts", "design.toml", "--out", "printed", "--format", "obj")
    for name in ("none", "", "../design", "array-2x6 ", "ARRAY-2X6", "line"):
        yield ("check", name)
        yield ("prototypes", name)
    yield ()
    yield ("nonsense",)
    yield ("solve",)
    yield ("solve", "design.toml")
    yield ("solve", "design.toml", "--out")


OPTIONS: tuple[Words, ...] = tuple(words for words in _options() if words)


# -- what does not belong together ----------------------------------------------------------------------------
def _of_another_design(folder: Path, draw: random.Random) -> None:
    """A library of four points beside that of three."""
    import acoustic_fem
    import geometry

    design = geometry.load_design(folder / "design.toml")
    other = design.with_values({"name": "row-4", "lines.0.points": 4, "layout.columns": 4})
    grid = acoustic_fem.load(folder / "library.nc").frequency
    acoustic_fem.save(acoustic_fem.solve(other, grid, "lumped"), folder / "other.nc")


def _of_three_microphones(folder: Path, draw: random.Random) -> None:
    import acoustic_fem
    import geometry

    grid = acoustic_fem.load(folder / "library.nc").frequency
    acoustic_fem.save(acoustic_fem.solve(geometry.prototype("glove"), grid, "lumped"), folder / "other.nc")


def _mismatched() -> Iterator[tuple[str, Words, Change]]:
    for what, change in (("four points", _of_another_design), ("another array", _of_three_microphones)):
        for model in ("localizer", "decoder.onnx", "network.onnx"):
            yield f"{model} judged by a library of {what}", ("evaluate", model, "other.nc"), change
            words = ("locate", model, "touches.wav", "--library", "other.nc", "--ambient", "60")
            yield f"{model} with a library of {what}", words, change
    yield "a recording of another array", ("locate", "other.nc", "touches.wav"), _of_three_microphones
    yield "a recording of another array, live", ("live", "other.nc", "--replay", "touches.wav"), _of_three_microphones
    yield (
        "recordings of another array",
        ("recalibrate", "other.nc", "touches.wav", "--out", "n.nc"),
        _of_three_microphones,
    )
    words = ("train", "other.nc", "--out", "trained", "--recordings", "session/touches.toml")
    yield "recorded touches of another array", words, _of_three_microphones
    for kind in ("touches.wav", "design.toml", "study.toml", "decoder.onnx", "localizer", "box.step"):
        yield f"{kind} for a library", ("train", kind, "--out", "trained"), untouched
        yield f"{kind} for a sweep", ("best", kind), untouched
    for kind in ("library.nc", "design.toml", "localizer", "decoder.onnx"):
        yield f"{kind} for a recording", ("locate", "library.nc", kind), untouched
        yield f"{kind} for a study", ("sweep", kind, "--dry-run"), untouched
    for kind in ("touches.wav", "design.toml", "box.step", "results.zarr", "calibration"):
        yield f"{kind} for a model", ("locate", kind, "touches.wav"), untouched


MISMATCHED = tuple(_mismatched())


# -- outputs --------------------------------------------------------------------------------------------------
#: Command without its output, and outputs that it must leave alone.
_OUTPUTS: tuple[tuple[Words, tuple[str, ...]], ...] = (
    (
        ("locate", "library.nc", "touches.wav"),
        (
            "touches.wav",
            "library.nc",
            "./touches.wav",
            "link.wav",
            "hard.wav",
            "link.nc",
            "localizer",
            ".",
            "mine/../touches.wav",
        ),
    ),
    (("locate", "localizer", "touches.wav"), ("localizer/localizer.json", "localizer")),
    (("locate", "decoder.onnx", "touches.wav"), ("decoder.onnx", "touches.wav")),
    (("solve", "design.toml", "--fidelity", "lumped"), ("design.toml", ".", "localizer")),
    (("convert", "library.nc"), ("library.nc", "./library.nc", "link.nc", "design.toml", ".")),
    (("convert", "library.sofa"), ("library.sofa", "./library.sofa")),
    (("train", "library.nc"), (".", "..", "mine", "calibration", "results.zarr", "found", "library.nc")),
    (("run", "design.toml"), (".", "..", "mine", "calibration", "results.zarr", "localizer", "design.toml")),
    (("rig", "design.toml"), ("..", "mine", "results.zarr", "localizer", "design.toml")),
    (("parts", "design.toml"), ("design.toml", "library.nc")),
    (
        ("tolerance", "design.toml", "--samples", "2", "--base", "0"),
        ("..", "mine", "calibration", "results.zarr", "design.toml"),
    ),
    (("optimize", "search.toml", "--workers", "1"), (".", "..", "mine", "results.zarr", "search.toml")),
    (("sweep", "study.toml", "--workers", "1"), ("mine", "design.toml", "library.nc", "study.toml", "localizer")),
    (("onnx", "localizer"), ("localizer", "library.nc", "touches.wav", "localizer/localizer.json")),
    (("onnx", "library.nc"), ("library.nc", "new.txt", "design.toml")),
    (
        ("calibrate", "calibration", "--fidelity", "lumped"),
        ("library.nc", "touches.wav", "calibration/calibration.toml", "calibration/point-1.wav", "calibration"),
    ),
    (("recalibrate", "library.nc", "touches.wav"), ("library.nc", "touches.wav", "./library.nc")),
    (("evaluate", "localizer", "library.nc", "--touches", "2"), ("library.nc", "localizer", "mine")),
    (("report", "results.zarr"), ("results.zarr", "results.zarr/zarr.json", "study.toml")),
    (("best", "results.zarr", "1"), ("results.zarr", "results.zarr/zarr.json", "study.toml")),
    (("live", "library.nc", "--replay", "touches.wav"), ("touches.wav", "library.nc")),
    (("check", "design.toml"), ("design.toml", "mine")),
    (("prototypes", "glove"), ("design.toml", "mine")),
)


def _full(folder: Path, draw: random.Random) -> None:
    """A folder of somebody's own, and other names for files."""
    (folder / "mine").mkdir()
    (folder / "mine" / "thesis.tex").write_text("years of work")
    shutil.copy(folder / "touches.wav", folder / "mine" / "touches.wav")
    (folder / "link.wav").symlink_to(folder / "touches.wav")
    (folder / "hard.wav").hardlink_to(folder / "touches.wav")
    (folder / "link.nc").symlink_to(folder / "library.nc")


def _overwriting() -> Iterator[tuple[Words, Change]]:
    for words, outputs in _OUTPUTS:
        for out in outputs:
            yield (*words, "--out", out), _full
    for out in ("touches.wav", "library.nc", "link.wav"):
        yield ("live", "library.nc", "--replay", "touches.wav", "--record", out), _full


OVERWRITING = tuple(_overwriting())


# -- solids ---------------------------------------------------------------------------------------------------
_SOLVED = """
import cadquery as cq
import numpy as np
from acoustic_fem import Medium
from acoustic_fem.cell import port_admittance
def solve(solid, ports, **options):
    print(port_admittance(solid, ports, np.array([10.0]), Medium.at(20.0, 0.5, 101325.0), **options))
tube = cq.Workplane().cylinder(10, 0.5)
ends = {"in": (0, 0, -5), "out": (0, 0, 5)}
"""
_SOLIDS = (
    ("a box of 1e6 mm", "solve(cq.Workplane().box(1e6, 1e6, 1e6), {'in': (0, 0, 5e5)})"),
    ("a sliver", "solve(cq.Workplane().box(10, 1e-5, 1), {'in': (5, 0, 0)})"),
    ("a needle", "solve(cq.Workplane().box(1000, 0.001, 0.001), {'in': (500, 0, 0)})"),
    ("a tiny hole", "solve(cq.Workplane().box(9, 9, 9).faces('>Z').workplane().hole(1e-4), {'in': (3, 3, 4.5)})"),
    (
        "many faces",
        "solve(cq.Workplane().polygon(3000, 20).extrude(1), {'in': (0, 0, 1)})",
    ),
    ("no solid", "solve(cq.Workplane(), ends)"),
    ("an empty compound", "solve(cq.Compound.makeCompound([]), ends)"),
    ("two solids", "solve(cq.Workplane().box(1, 1, 1).add(cq.Workplane().box(1, 1, 1).translate((5, 0, 0))), ends)"),
    ("a number", "solve(5, ends)"),
    ("nothing", "solve(None, ends)"),
    ("a STEP file that is none", "open('no.step', 'w').write('hello'); solve('no.step', ends)"),
    ("a STEP file that is missing", "solve('nowhere.step', ends)"),
    ("an IGES file", "solve('box.igs', ends)"),
    ("a face", "solve(cq.Workplane().box(1, 1, 1).faces('>Z').val(), ends)"),
    ("not a number in a port", "solve(tube, {'in': (float('nan'), 0, 0)})"),
    ("an infinite port", "solve(tube, {'in': (float('inf'), 0, 0)})"),
    ("a port beside the faces", "solve(tube, {'in': (7, 7, 7)})"),
    ("no ports", "solve(tube, {})"),
    ("a port twice", "solve(tube, {'in': (0, 0, 5), 'out': (0, 0, 5)})"),
    ("a thousand ports", "solve(tube, {str(k): (0, 0, 5) for k in range(1000)})"),
    ("accuracy 0", "solve(tube, ends, accuracy=0.0)"),
    ("accuracy of no number", "solve(tube, ends, accuracy=float('nan'))"),
    ("an unknown fidelity", "solve(tube, ends, fidelity='exact')"),
    ("a solid of no number", "solve(cq.Workplane().box(1, 1, 1).val().scale(float('nan')), ends)"),
    ("an infinite solid", "solve(cq.Workplane().box(1, 1, 1).val().scale(1e90), ends)"),
    (
        "a solid turned inside out",
        "solve(cq.Shape.cast(cq.Workplane().box(1, 1, 1).val().wrapped.Reversed()), {'in': (0, 0, 0.5)})",
    ),
    ("a solid 1e-9 mm large", "solve(cq.Workplane().box(1, 1, 1).val().scale(1e-9), {'in': (0, 0, 5e-10)})"),
)
#: What is wrong, and Python that hands it in.
SOLIDS = tuple((what, _SOLVED + code) for what, code in _SOLIDS)

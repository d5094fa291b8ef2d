"""Whoever needs a library of the system that is missing says what to install, whichever way it is asked for."""

from __future__ import annotations

import importlib
import json
import os
import pickle
import subprocess
import sys
from importlib.machinery import SourceFileLoader
from importlib.util import find_spec
from pathlib import Path

import pytest

from geometry.ground import missing_packages
from geometry.ground.extras import EXTRAS, MissingExtra
from geometry.ground.missing_packages import MissingLibrary
from geometry.ground.refusal import Kind, Refusal

ROOT = Path(__file__).parents[3]
FILE = "cannot open shared object file: No such file or directory"
STUDY = """
base = "array-2x6"
fidelity = "navier-stokes"
frequency = "1:100:4"
metrics = ["distance_smallest"]
[vary]
"tube.length" = [10, 12]
"""
#: Each way is a call that must be refused; what came of it is printed as JSON.
ASK = """
import json, sys, geometry, acoustic_fem
from studies.cli import app

design = geometry.prototype("array-2x6")

def verb(*arguments):
    sys.argv = ["acoustic-fem", *arguments]
    app.main()

def sweep():
    verb("sweep", "study.toml", "--out", "results.zarr", "--workers", "1")

def solid():
    import cadquery
    air = acoustic_fem.Medium.at(20, 0.5)
    box = cadquery.Workplane().box(1, 1, 1).val()
    acoustic_fem.cell.port_admittance(box, {"a": (0, 0, 0.5)}, [10.0], air, fidelity="helmholtz", accuracy=3e-3)

ways = {
    "solve, from Python": lambda: acoustic_fem.solve(design, [1.0, 2.0], fidelity="navier-stokes"),
    "a solid": solid,
    "sweep": sweep,
    "parts, from Python": lambda: geometry.build_parts(design),
    "check": lambda: verb("check", "array-2x6"),
}
reported = {}
for name in json.loads(sys.argv[1]):
    try:
        ways[name]()
    except geometry.Refusal as refusal:
        reported[name] = str(refusal)
    except SystemExit as ended:
        reported[name] = f"exit code {ended.code}"
print(json.dumps(reported))
"""
SOLVING = ["solve, from Python", "a solid", "sweep"]


@pytest.mark.slow
@pytest.mark.end_to_end
@pytest.mark.parametrize(
    ("module", "error", "library", "ways"),
    [
        ("gmsh", OSError, "libGLU.so.1", SOLVING),
        ("OCP", ImportError, "libGL.so.1", [*SOLVING, "parts, from Python", "check"]),
    ],
    ids=["gmsh", "OCP"],
)
def test_every_way_ends_in_one_line(
    module: str, error: type[Exception], library: str, ways: list[str], tmp_path: Path
) -> None:
    (tmp_path / "system").mkdir()
    (tmp_path / "system" / f"{module}.py").write_text(f"raise {error.__name__}({f'{library}: {FILE}'!r})\n")
    (tmp_path / "study.toml").write_text(STUDY)
    done = subprocess.run(
        [sys.executable, "-c", ASK, json.dumps(ways)],
        cwd=tmp_path,
        env={
            **os.environ,
            "PYTHONPATH": os.pathsep.join([str(tmp_path / "system"), str(ROOT)]),
            "ACOUSTIC_FEM_CACHE": str(tmp_path / "cache"),
        },
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr
    lines = [line for line in done.stderr.splitlines() if line.startswith("acoustic-fem: ")]
    reported = json.loads(done.stdout.splitlines()[-1])
    for name in ways:
        line = lines.pop(0).removeprefix("acoustic-fem: ") if reported[name] == "exit code 1" else reported[name]
        assert line.startswith(f"{library}: this library of the system is missing; on Debian and Ubuntu type: "), name


def test_it_travels_between_processes() -> None:
    error = pickle.loads(pickle.dumps(MissingLibrary("libGL.so.1: missing", kind=Kind.OUT_OF_RANGE)))
    assert isinstance(error, Refusal)
    assert isinstance(error, ImportError)  # who can do without the package goes on
    assert str(error) == "libGL.so.1: missing"


def test_other_mistakes_and_other_packages_are_left_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "drawn_by_nobody.py").write_text("raise ImportError('no such thing')\n")
    (tmp_path / "somebody_elses.py").write_text(f"raise OSError('libGL.so.1: {FILE}')\n")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(missing_packages, "PACKAGES", frozenset({"drawn_by_nobody"}))
    with pytest.raises(ImportError, match=r"^no such thing$") as found:
        importlib.import_module("drawn_by_nobody")
    assert not isinstance(found.value, Refusal)
    with pytest.raises(OSError, match=r"^libGL"):
        importlib.import_module("somebody_elses")


def test_a_module_keeps_its_own_loader(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Others look there for its source and its data."""
    (tmp_path / "drawn_by_nobody.py").write_text("")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(missing_packages, "PACKAGES", frozenset({"drawn_by_nobody"}))
    monkeypatch.delitem(sys.modules, "drawn_by_nobody", raising=False)
    module = importlib.import_module("drawn_by_nobody")
    assert isinstance(module.__loader__, SourceFileLoader)
    assert module.__spec__ is not None
    assert module.__spec__.loader is module.__loader__


def test_a_package_that_is_not_there_is_told_to_modules_of_ours_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Others look whether it is there, and do without it."""
    monkeypatch.setitem(EXTRAS, "plots", ("nobodys_pencil",))
    line = r"^nobodys_pencil, which this needs, is not installed: pip install 'acoustic-fem\[plots\]'$"
    with pytest.raises(MissingExtra, match=line):
        exec("import nobodys_pencil.lines", {"__name__": "studies.output.response_figures"})
    with pytest.raises(ModuleNotFoundError, match="No module named 'nobodys_pencil'"):
        exec("import nobodys_pencil", {"__name__": "xarray.plot"})
    with pytest.raises(ModuleNotFoundError, match=r"No module named .geometry\.nobodys_pencil"):
        exec("import geometry.nobodys_pencil", {"__name__": "geometry.solids"})
    assert find_spec("nobodys_pencil") is None


@pytest.mark.slow
def test_the_renderer_starts_after_the_compiler_of_pytorch(tmp_path: Path) -> None:
    """A second LLVM beside that of Mesa would end the program: a stand-in writes when it was loaded."""
    (tmp_path / "triton.py").write_text("print('triton')\n", "utf-8")
    ask = (
        "import pyvista\nstart = pyvista.Plotter\n"
        "def plotter(*given, **named):\n    print('renderer')\n    return start(*given, **named)\n"
        "pyvista.Plotter = plotter\n"
        "from geometry.pictures.canvas import open_plotter\nopen_plotter((64, 64)).close()\n"
    )
    path = os.pathsep.join([str(tmp_path), str(ROOT)])
    done = subprocess.run(
        [sys.executable, "-c", ask],
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        encoding="utf-8",
        check=False,
        timeout=300,
    )
    assert done.stdout.split() == ["triton", "renderer"], done.stderr

"""What the command line says of itself: help, versions, and that saying so loads nothing heavy."""

from __future__ import annotations

import inspect
import itertools
import subprocess
import sys
from pathlib import Path

import pytest
from command import Command
from typer.testing import CliRunner

import acoustic_fem
from studies.cli import app, verbs

ROOT = Path(__file__).parents[3]
VERBS = ("prototypes", "check", "solve", "parts", "train", "evaluate", "onnx", "locate", "live", "run")


@pytest.mark.parametrize("verb", VERBS)
def test_the_help_of_every_verb_has_an_example_and_out(command: Command, verb: str) -> None:
    told = command(verb, "--help")
    assert told.code == 0
    assert f"acoustic-fem {verb}" in told.out.partition("Example:")[2]
    assert "--out" in told.out


@pytest.mark.parametrize("verb", verbs.VERBS)
def test_help_fills_the_lines_of_a_terminal(verb: str) -> None:
    told = CliRunner().invoke(app.app, [verb, "--help"], env={"COLUMNS": "80"})
    lines = [line.rstrip() for line in told.output.splitlines()]
    assert max(map(len, lines)) <= 80
    words = lines[: next(k for k, line in enumerate(lines) if line.startswith("╭"))]
    for line, after in itertools.pairwise(words):
        assert not line or not after or len(line) + 1 + len(after.split()[0]) > 79, f"{line} | {after}"


def test_the_help_lists_every_verb_in_the_order_of_work(command: Command) -> None:
    told = command("--help")
    assert [told.out.index(f"│ {verb} ") for verb in VERBS] == sorted(told.out.index(f"│ {verb} ") for verb in VERBS)
    assert command("--version").out.startswith("acoustic-fem")


@pytest.mark.parametrize("verb", verbs.VERBS)
def test_the_line_of_a_verb_is_the_first_of_its_docstring(verb: str) -> None:
    doc = inspect.getdoc(verbs.verb_named(verb)) or ""
    assert verbs.VERBS[verb].help == " ".join(doc.partition("\n\n")[0].split())


def test_help_of_a_search_names_its_section(command: Command) -> None:
    assert "A study file with a section [optimize]." in command("optimize", "--help").out


def test_help_loads_nothing_heavy() -> None:
    code = (
        "import sys\n"
        "from studies.cli.app import app\n"
        "try:\n    app(['--help'])\nexcept SystemExit:\n    pass\n"
        "heavy = {'OCP', 'cadquery', 'gmsh', 'matplotlib', 'numpy', 'pyvista', 'scipy', 'skfem', 'torch', 'xarray'}\n"
        "print(sorted(heavy & set(sys.modules)), file=sys.stderr)"
    )
    told = subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=True, capture_output=True, encoding="utf-8")
    assert told.stderr.strip() == "[]"
    assert "Usage" in told.stdout


def test_run_takes_a_design_and_a_folder_and_nothing_else(command: Command, tmp_path: Path) -> None:
    assert command("run", "array-2x6", "--out", tmp_path, "--fidelity", "lumped").code == 2
    told = command("run", "--help")
    options = [word for word in told.out.split() if word.startswith("--")]
    assert set(options) == {"--out", "--allow-overlaps", "--help"}


def test_the_fidelities_of_the_command_are_those_of_the_library(command: Command, tmp_path: Path) -> None:
    told = command("solve", "array-2x6", "--out", str(tmp_path / "library.nc"), "--fidelity", "exact")
    assert told.code == 2
    offered = " ".join(told.err.replace("│", " ").split())
    assert ", ".join(map(repr, acoustic_fem.FIDELITIES)) in offered

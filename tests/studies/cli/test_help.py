"""Help of the command line: texts, versions, and that saying so loads nothing heavy."""

from __future__ import annotations

import inspect
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from command import Command
from typer.main import get_command

import acoustic_fem
from studies.cli import app, verbs

ROOT = Path(__file__).parents[3]


def parsed(verb: str) -> Any:
    """The command of a verb, with its help and its options, as click has it."""
    return verbs.command_of(verb)


def options(verb: str) -> set[str]:
    """Long options of a verb."""
    return {name for each in parsed(verb).params for name in each.opts if name.startswith("--")}


@pytest.mark.parametrize("verb", verbs.VERBS)
def test_the_help_of_every_verb_has_an_example_in_paragraphs_of_one_line(verb: str) -> None:
    paragraphs = parsed(verb).help.split("\n\n")
    assert f"acoustic-fem {verb}" in paragraphs[-1].partition("Example:")[2]
    assert not any("\n" in each for each in paragraphs)  # a terminal has its own width


def test_the_help_lists_every_verb_in_the_order_of_work(command: Command) -> None:
    told = command("--help")
    assert list(get_command(app.app).commands) == list(verbs.VERBS)  # type: ignore[attr-defined]
    assert all(verb in told.out.split() for verb in verbs.VERBS)
    assert command("--version").out.startswith("acoustic-fem")


@pytest.mark.parametrize("verb", verbs.VERBS)
def test_the_line_of_a_verb_is_the_first_of_its_docstring(verb: str) -> None:
    doc = inspect.getdoc(verbs.verb_named(verb)) or ""
    assert verbs.VERBS[verb].help == " ".join(doc.partition("\n\n")[0].split())


def test_help_of_a_search_names_its_section(command: Command) -> None:
    assert "[optimize]" in command("optimize", "--help").out


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
    assert "--fidelity" in command("run", "array-2x6", "--out", tmp_path, "--fidelity", "lumped").refusal(code=2)
    assert options("run") == {"--out", "--allow-overlaps"}


def test_the_fidelities_of_the_command_are_those_of_the_library(command: Command, tmp_path: Path) -> None:
    line = command("solve", "array-2x6", "--out", tmp_path / "library.nc", "--fidelity", "exact").refusal(code=2)
    assert all(fidelity in line for fidelity in acoustic_fem.FIDELITIES)

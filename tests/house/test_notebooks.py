"""The notebooks run as they are printed, each draws, and what the site shows is made from the script beside it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

FOLDER = Path(__file__).parents[2] / "docs" / "notebooks"
SCRIPTS = sorted(FOLDER.glob("*.py"))
#: They take 2.5 s and more.
LONG = {"made_sensor", "many_sensors", "surrogate", "sweep", "wristband"}


def test_there_are_notebooks() -> None:
    assert len(SCRIPTS) >= 6


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.stem)
def test_a_notebook_has_the_cells_of_its_script_and_shows_pictures(script: Path) -> None:
    jupytext = pytest.importorskip("jupytext")
    cells = jupytext.read(script).cells
    shown = json.loads(script.with_suffix(".ipynb").read_text(encoding="utf-8"))["cells"]
    assert [(each["cell_type"], "".join(each["source"])) for each in shown] == [
        (each.cell_type, each.source) for each in cells
    ], f"python docs/make_notebooks.py {script.stem}"
    pictures = [out for cell in shown for out in cell.get("outputs", ()) if "image/png" in out.get("data", {})]
    assert len(pictures) == script.read_text(encoding="utf-8").count("plt.show()") > 0


@pytest.mark.parametrize(
    "script",
    [pytest.param(each, id=each.stem, marks=pytest.mark.slow if each.stem in LONG else ()) for each in SCRIPTS],
)
def test_a_notebook_runs(script: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    import matplotlib as mpl
    import matplotlib.pyplot as plt

    shown: list[int] = []
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(plt, "show", lambda: shown.extend(plt.get_fignums()))
    with mpl.rc_context({"backend": "agg"}):
        exec(compile(script.read_text(encoding="utf-8"), str(script), "exec"), {"__name__": "__notebook__"})
        plt.close("all")
    assert shown

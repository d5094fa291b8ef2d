"""Objects show themselves in a few lines, as text and as a table; designs are not changed in place."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from refusals import refused
from small_run import small_run

import acoustic_fem
import geometry
import localize
import studies
from geometry.ground.refusal import Kind
from geometry.ground.shown import LONGEST_LINE, MOST_LINES, Shown

DESIGN = geometry.prototype("array-2x6")
#: Three places are detected, one between them is not.
TRACK = localize.tracking.Track(
    time=np.array([0.0, 0.016, 0.032, 0.048]),
    place=np.array([[0.0, 0.0], [10.0, 0.0], [20.0, 0.0], [30.0, 0.0]]),
    deviation=np.full(4, 1.0),
    speed=np.full(4, 625.0),
    force=np.array([0.1, np.nan, 0.1, 0.1]),
    detected=np.array([True, False, True, True]),
    pitch=12.0,
)


class Many(Shown):
    """An object with more facts than are shown, one of them long and one of several lines."""

    def shown(self) -> tuple[str, dict[str, object]]:
        return "Many <b>", {"empty": "", **{f"fact {k}": "x\ny" * (1 + 50 * k) for k in range(20)}}


def test_a_text_has_at_most_twelve_lines_and_a_table_no_markup_of_its_facts() -> None:
    lines = repr(Many()).splitlines()
    assert len(lines) == MOST_LINES
    assert lines[1] == "  fact 0: x y"
    assert "empty" not in repr(Many())
    assert max(map(len, lines)) <= LONGEST_LINE
    assert "<b>Many &lt;b&gt;</b>" in Many()._repr_html_()


@pytest.fixture(scope="module")
def objects(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Shown]:
    study = studies.Study(DESIGN, {"tube.length": [12.0, 14.0]}, metrics=["volume", "mass"], fidelity="lumped")
    library = acoustic_fem.solve(DESIGN, "1:500:500", "lumped")
    decoder = localize.BayesDecoder(library, 1e-3)
    with pytest.MonkeyPatch.context() as core:
        core.setattr("studies.run.check.is_installed", lambda extra: extra != "cad")  # to draw takes seconds
        check = studies.check_design(DESIGN)
    return {
        "design": DESIGN,
        "library": library,
        "study": study,
        "sweep": studies.run_sweep(study, tmp_path_factory.mktemp("shown") / "r.zarr", workers=1),
        "evaluation": localize.evaluate(decoder, library, 2, 1e-3),
        "check": check,
        "run": small_run(),
        "localizer": localize.load_localizer(small_run().folder / "localizer"),
        "model": localize.open_model(library, tolerances=False),
        "track": TRACK,
    }


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("design", "inner diameter 0.44 mm"),
        ("library", "12 points, 2 microphones, 500 frequencies"),
        ("study", "tube.length: 12.0, 14.0"),
        ("sweep", "2: 2 done, 0 failed, 0 waiting"),
        ("evaluation", "top-1 accuracy"),
        ("check", "12"),
        ("run", "Bayes decoder"),
        ("localizer", "points"),
        ("model", "model-based decoder"),
        ("track", "30 mm"),
    ],
)
def test_an_object_says_what_it_is(name: str, words: str, objects: dict[str, Shown]) -> None:
    text = repr(objects[name])
    assert 3 <= len(text.splitlines()) <= MOST_LINES
    assert max(map(len, text.splitlines())) <= LONGEST_LINE
    assert words in text
    assert words in objects[name]._repr_html_()


def test_objects_draw_themselves(objects: dict[str, Shown], tmp_path: Path) -> None:
    library, sweep, evaluation = (objects[name] for name in ("library", "sweep", "evaluation"))
    assert isinstance(library, acoustic_fem.Library)
    assert isinstance(sweep, studies.Sweep)
    assert isinstance(evaluation, localize.Evaluation)
    level = library.plot("level", microphones=["B"])
    (axes,) = level.axes
    assert len(axes.lines) == 12
    h = library.transfer_function.sel(microphone="B").transpose("point", "frequency").values
    np.testing.assert_allclose(axes.lines[3].get_ydata(), 20 * np.log10(np.abs(h[3])))
    difference = library.plot("ipd").axes
    assert len(difference) == 1
    with refused(Kind.OUT_OF_RANGE, "quantity", "loudness"):
        library.plot("loudness")  # type: ignore[arg-type]
    with refused(Kind.UNKNOWN, "microphones", "C"):
        library.plot("level", ["C"])
    with refused(Kind.OUT_OF_RANGE, "microphones"):
        library.plot("ild", ["A"])
    effects = sweep.plot("mass")
    assert effects.axes[0].get_xlabel() == "tube.length  (mm)"
    assert len(sweep.plot("mass", "volume").axes[0].lines) == 2
    with refused(Kind.UNKNOWN, "against", "cost"):
        sweep.plot("mass", "cost")
    confusion = evaluation.plot()
    assert confusion.axes[0].images[0].get_array().shape == (12, 12)
    plan = DESIGN.draw()
    assert len(plan.axes[0].patches) == 12
    for figure in (level, effects, confusion, plan):
        figure.savefig(tmp_path / "figure.png")
        assert (tmp_path / "figure.png").stat().st_size > 5000


def test_a_path_draws_where_its_contact_was_and_when(tmp_path: Path) -> None:
    figure = TRACK.plot()
    axes, colours = figure.axes
    (dots,) = axes.collections
    np.testing.assert_array_equal(dots.get_offsets(), TRACK.place[TRACK.detected])
    np.testing.assert_array_equal(dots.get_array(), TRACK.time[TRACK.detected])
    assert (axes.get_xlabel(), axes.get_ylabel(), colours.get_ylabel()) == ("x  (mm)", "y  (mm)", "time  (s)")
    (line,) = axes.lines
    np.testing.assert_array_equal(line.get_xydata(), TRACK.place)
    figure.savefig(tmp_path / "figure.png")
    assert (tmp_path / "figure.png").stat().st_size > 5000


def test_a_path_without_a_contact_says_so() -> None:
    nothing = replace(TRACK, detected=np.zeros(4, bool))
    assert repr(nothing) == "Path\n  contact: none detected"


def test_a_design_lists_its_fields_and_our_methods_alone() -> None:
    names = dir(DESIGN)
    assert {"tube", "membrane", "with_values", "draw", "point_count"} <= set(names)
    assert not [name for name in names if name.startswith(("_", "model_")) or name in ("copy", "json", "dict")]
    assert {"length", "inner_diameter"} <= set(dir(DESIGN.tube))


def test_a_field_that_is_set_in_place_is_refused_with_what_to_write() -> None:
    with refused(Kind.UNSUITABLE, "tube.length", 3) as found:
        DESIGN.tube.length = 3
    assert 'with_values({"tube.length": 3})' in str(found.value)
    with refused(Kind.UNSUITABLE, "name", "mine"):
        DESIGN.name = "mine"

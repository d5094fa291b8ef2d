"""Designs, runs, libraries and cases side by side: what they share with their sources, and what is not compared."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from libraries import library_of, three_points
from refusals import check_messages, refused
from small_run import small_design, small_run

import acoustic_fem
import geometry
import studies
from geometry import Kind
from studies.comparison import Comparison
from studies.comparison.level_curves import level_curves
from studies.comparison.quantities import Quantity, quantity_named
from studies.comparison.subjects import MOST_SUBJECTS, read_subject
from studies.run.quality import design_quality
from studies.study.metric_registry import METRICS
from studies.verdict.accuracies import accuracies
from studies.verdict.rules import OUTCOMES

ARRAY = geometry.prototype("array-2x6")
SHORT = small_design()
STUDY = {
    "base": SHORT,
    "vary": {"tube.length": [10.0, 20.0]},
    "fidelity": "lumped",
    "frequency": "1:100:12",
    "metrics": ["distance_smallest", "volume"],
}

SEARCH = """
base = "array-2x6"
fidelity = "lumped"
stock = "off"
frequency = "1:100:12"
metrics = ["volume"]
[vary]
"tube.length" = { from = 12.0, to = 14.0 }
[optimize]
trials = 3
[[optimize.objectives]]
metric = "volume"
"""


def row(found: Comparison, name: str) -> list:
    """Values of a figure."""
    return next(list(each.values) for each in found.figures if each.quantity.name == name)


def better(found: Comparison, name: str) -> list[str]:
    """Names of the subjects that are better in a figure."""
    return [found.names[place] for each in found.figures if each.quantity.name == name for place in each.best]


@pytest.fixture(scope="module")
def two() -> Comparison:
    """A design and the same with longer and narrower tubes."""
    longer = SHORT.with_values({"name": "longer", "tube.length": 20.0, "tube.inner_diameter": 0.4})
    return studies.compare(SHORT, longer, printing=False)


@pytest.fixture(scope="module")
def store(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Results of a sweep of two cases that keeps libraries."""
    out = tmp_path_factory.mktemp("sweep") / "results.zarr"
    studies.run_sweep(studies.Study(**STUDY, keep="libraries"), out, workers=1)
    return out


# -- figures and fields ------------------------------------------------------------------------------------
def test_the_fields_that_differ_are_those_that_were_changed(two: Comparison) -> None:
    changed = {each.name: each.values for each in two.fields}
    assert changed["tube.length"] == (12.5, 20.0)
    assert changed["tube.inner_diameter"] == (0.44, 0.4)
    assert SHORT.with_values({name: after for name, (_, after) in changed.items()}).tube == two.subjects[1].design.tube
    assert not {"name", "description"} & changed.keys()


def test_the_same_design_twice_differs_in_nothing_and_neither_is_better() -> None:
    found = studies.compare(SHORT, SHORT, printing=False)
    assert found.names == ("row-3 (1)", "row-3 (2)")
    assert found.fields == ()
    assert not any(each.best for each in found.figures)
    assert found.differences[0].largest is not None
    assert found.differences[0].largest.magnitude < 1e-12


def test_the_figures_are_those_of_the_quick_answers(two: Comparison) -> None:
    quality = design_quality(SHORT)
    assert quality is not None
    (accuracy,) = accuracies([SHORT])
    assert not isinstance(accuracy, str)
    assert row(two, "as_built_taps")[0] == accuracy.as_built["taps"].mean
    assert row(two, "nominal_multi_sines")[0] == accuracy.designed["multi-sines"].mean
    assert row(two, "noise_equivalent_force")[0] == pytest.approx(quality.force, rel=0.02)
    assert row(two, "cost")[0] == quality.cost
    assert row(two, "hardest_pair")[0] == " and ".join(map(str, quality.hardest))


@pytest.mark.slow
def test_the_verdict_is_that_of_check_and_names_the_rule_that_is_broken_worst() -> None:
    found = studies.compare("array-2x6", "glove", "line-2", printing=False)
    for name, (outcome, reason) in zip(found.names, found.verdicts, strict=True):
        verdict = studies.Verdict(name)
        assert outcome == verdict.outcome
        assert reason == (verdict.reasons[0].words if verdict.reasons else "")
        assert row(found, "smallest_force")[found.names.index(name)] == verdict.figures.smallest_force
    assert len({outcome for outcome, _ in found.verdicts}) > 1
    best = min(found.verdicts, key=lambda each: OUTCOMES.index(each[0]))[0]
    assert better(found, "verdict") == [
        name for name, each in zip(found.names, found.verdicts, strict=True) if each[0] == best
    ]


def test_longer_tubes_make_a_longer_and_dearer_array_whose_points_differ_more(two: Comparison) -> None:
    assert better(two, "length") == better(two, "cost") == ["row-3"]
    assert better(two, "distance_smallest") == ["longer"]
    assert better(two, "points") == []


@pytest.mark.slow
def test_fields_of_three_designs_stand_in_the_order_of_a_file() -> None:
    found = studies.compare("array-2x6", "glove", "line-2", printing=False)
    tables = [each.name.split(".")[0] for each in found.fields]
    order = list(type(ARRAY).model_fields)
    assert tables == sorted(tables, key=order.index)
    lines = [each.name for each in found.fields if each.name.startswith("lines.")]
    assert lines == sorted(lines, key=lambda name: int(name.split(".")[1]))
    assert found.mark == "best"


@pytest.mark.parametrize(
    ("quantity", "values", "best"),
    [
        (Quantity("x", "", "", better="larger"), (1.0, 2.0, None), (1,)),
        (Quantity("x", "", "", better="smaller"), (1.0, 2.0, 1.001), (0, 2)),
        (Quantity("x", "", "", better="larger"), (1.0, 1.001), ()),
        (Quantity("x", "", "", better="larger", step=0.01), (0.5, 0.505), ()),
        (Quantity("x", "", "", better="smaller"), (-3.0, -1.0), (0,)),
        (Quantity("x", "", "", better="larger"), (None, 1.0), ()),
        (Quantity("x", "", ""), (1.0, 2.0), ()),
        (quantity_named("printing"), ("fail", "warn", "warn"), (1, 2)),
        (quantity_named("printing"), ("fail", None), ()),
    ],
)
def test_the_better_of_values_is_marked_and_of_equal_ones_none(
    quantity: Quantity, values: tuple[float | str | None, ...], best: tuple[int, ...]
) -> None:
    assert quantity.best(values) == best


def test_forces_of_a_row_have_one_prefix() -> None:
    assert quantity_named("noise_equivalent_force").written([2e-6, 3.4e-8, None]) == ["2 µN", "0.034 µN", ""]
    assert quantity_named("coverage").written([0.5, 1.0]) == ["50.0 %", "100 %"]


# -- runs, libraries and cases -----------------------------------------------------------------------------
def test_a_run_has_its_trained_accuracies_print_verdict_and_manifest(tmp_path: Path) -> None:
    run = small_run()
    content = json.loads((run.folder / "results.json").read_text(encoding="utf-8"))
    found = studies.compare(str(run.folder), SHORT, printing=False)
    assert found.names == ("row-3 (run)", "row-3 (design)")
    trained = f"trained.trained localizer, {content['network']['signals']}"
    assert row(found, trained) == [content["network"]["top1"], None]
    taps = next(each for each in content["bayes"]["beside"] if each["signals"] == "taps")
    assert row(found, f"trained.Bayes decoder, taps on {taps['sensors']} as-built sensors")[0] == taps["top1"]
    assert row(found, "printing") == [content["printing"]["verdict"], None]
    assert found.verdicts[0][0] == content["verdict"]["outcome"]
    assert row(found, "fact.files")[0].endswith("all as the run wrote them")
    assert row(found, "frequencies")[0] == "500 from 1 to 500 Hz"
    assert found.differences[0].largest is not None  # the design is solved at the frequencies of the run

    copy = tmp_path / "copy"
    shutil.copytree(run.folder, copy)
    (copy / "report.html").write_text("changed", encoding="utf-8")
    again = studies.compare(run, copy, printing=False)
    assert row(again, "fact.files")[1] == "1 changed"
    assert again.names == (f"row-3 ({run.folder.name})", "row-3 (copy)")
    assert again.fields == ()


def test_a_library_is_compared_by_its_own_responses(tmp_path: Path) -> None:
    library = acoustic_fem.solve(SHORT, np.linspace(1, 100, 30), "lumped")
    library.save(tmp_path / "own.nc")
    found = studies.compare(tmp_path / "own.nc", SHORT, printing=False)
    assert row(found, "distance_smallest")[0] == METRICS["distance_smallest"].of_library(library)
    assert row(found, "fidelity") == ["lumped", "atlas"]
    assert any("different models" in note for note in found.notes)
    expected = studies.metrics.disagreement(
        acoustic_fem.solve(SHORT, library.frequency, "atlas").transfer_function, library.transfer_function
    )
    assert found.differences[0].largest == expected


def test_frequencies_outside_the_band_change_no_figure() -> None:
    wide, narrow = (acoustic_fem.solve(SHORT, np.arange(1.0, last), "lumped") for last in (301, 101))
    found = studies.compare(wide, narrow, printing=False)
    for name in ("bandwidth", "noise_equivalent_force", "predicted_top1", "distance_smallest"):
        one, other = row(found, name)
        assert one == pytest.approx(other, rel=1e-9), name
    assert found.differences[0].largest is None
    assert "300 frequencies from 1 to 300 Hz" in found.differences[0].why


def test_cases_of_a_sweep_have_its_metrics_and_libraries(store: Path) -> None:
    found = studies.compare(f"{store}#0", f"{store}#1", printing=False)
    sweep = studies.open_sweep(store)
    assert [each.values for each in found.fields if each.name == "tube.length"] == [(10.0, 20.0)]
    assert row(found, "stored.volume") == [float(value) for value in sweep.values["volume"]]
    assert row(found, "fidelity") == ["lumped", "lumped"]
    assert found.subjects[1].library is not None
    assert np.array_equal(found.subjects[1].library.transfer_function, sweep.library(1).transfer_function)
    assert better(found, "stored.volume") == [found.names[0]]
    base = studies.compare(f"{store}#0", SHORT, printing=False)  # which states no built-in material
    assert [each.name for each in base.fields] == ["tube.length"]


@pytest.mark.slow
def test_a_design_of_a_search_is_named_by_its_number(tmp_path: Path) -> None:
    study, out = tmp_path / "search.toml", tmp_path / "found"
    study.write_text(SEARCH, encoding="utf-8")
    front = studies.optimize(study, out, workers=1).result.front[0]
    found = studies.compare(f"{out}#{front.number}", "array-2x6", printing=False)
    assert row(found, "stored.volume") == [front.metrics["volume"], None]
    assert [each.values[0] for each in found.fields] == [front.values["tube.length"]]


def test_curves_reach_from_the_strongest_to_the_weakest_point() -> None:
    library = three_points()
    levels = 20 * np.log10(np.abs(library.transfer_function.transpose("point", "microphone", "frequency").values))
    found = level_curves("x", library)
    assert np.allclose(found.loudest[0], levels.max(axis=(0, 1)))
    assert np.allclose(found.loudest[1], levels.max(axis=1).min(axis=0))
    assert found.second is not None
    assert np.allclose(found.second[1], levels.min(axis=(0, 1)))  # of two microphones the second is the quieter one
    assert found.difference is not None
    assert np.allclose(found.difference[0], abs(levels[:, 0] - levels[:, 1]).max(axis=0))


# -- what is not compared ----------------------------------------------------------------------------------
@pytest.mark.slow
def test_other_numbers_of_points_and_microphones_are_named() -> None:
    found = studies.compare("array-2x6", "line-2", "glove", printing=False)
    assert [bool(each.why) for each in found.differences] == [True, True]
    assert "2 points" not in found.differences[1].why
    assert "3 microphones" in found.differences[1].why
    assert all(any(each.why in note for note in found.notes) for each in found.differences)


def test_a_design_with_one_point_has_no_figures_of_pairs() -> None:
    one = SHORT.with_values({"name": "one", "lines.0.points": 1, "layout.columns": 1})
    found = studies.compare(SHORT, one, printing=False)
    assert row(found, "predicted_top1")[1] is None
    assert row(found, "hardest_pair")[1] is None
    assert row(found, "cost")[1] is not None
    assert any(note.startswith("one: ") and "at least two points" in note for note in found.notes)


def test_a_library_that_ends_below_the_band_says_what_it_lacks() -> None:
    short = acoustic_fem.solve(SHORT, np.linspace(1, 50, 20), "lumped")
    found = studies.compare(short, SHORT, printing=False)
    assert row(found, "predicted_top1")[0] is None
    assert row(found, "level_10_hz")[0] is not None
    assert row(found, "level_100_hz")[0] is None
    assert any("1 to 50 Hz" in note for note in found.notes)


def test_measured_libraries_have_no_as_built_accuracy() -> None:
    found = studies.compare("docs/examples/recordings/library.nc", "array-2x6", printing=False)
    assert row(found, "as_built_taps")[0] is None
    assert found.verdicts[0] == ("", "")
    assert row(found, "predicted_top1")[0] is not None


# -- files and bad input -----------------------------------------------------------------------------------
def test_json_and_page_hold_what_was_compared(two: Comparison, tmp_path: Path) -> None:
    found = studies.compare(*(each.design for each in two.subjects), out=tmp_path / "x.json", printing=False)
    content = json.loads((tmp_path / "x.json").read_text(encoding="utf-8"))
    assert content == json.loads(json.dumps(found.to_dict()))
    assert {each["name"] for each in content["figures"]} == set(found.to_dataframe().index) - {
        each.name for each in found.fields
    }
    studies.compare(*(each.design for each in two.subjects), out=tmp_path / "x.html", printing=False)
    page = (tmp_path / "x.html").read_text(encoding="utf-8")
    assert "<svg" in page
    assert not [word for word in ("http://", "https://") if word in page.replace("http://www.w3.org/", "")]
    for each in found.fields:
        assert f">{each.name}</th>" in page
    assert page.count('class="best"') == sum(len(each.best) for rows in found.groups.values() for each in rows)
    assert "prefers-color-scheme: dark" in page


def test_a_data_frame_has_a_column_for_each_subject(two: Comparison) -> None:
    table = two.to_dataframe()
    assert table.loc["tube.length", "longer"] == 20.0
    assert table.loc["length", "better"] == "row-3"
    assert table.loc["predicted_top1", "row-3"] == row(two, "predicted_top1")[0]
    assert "row-3 | " not in repr(two)
    assert "longer" in two._repr_html_()


@pytest.mark.slow
def test_print_rules_are_checked_where_parts_are_drawn() -> None:
    thin = SHORT.with_values({"name": "thin", "printing.port_lip": 0.1})
    found = studies.compare(SHORT, thin)
    checked = [studies.check_design(each, quality=False) for each in (SHORT, thin)]
    assert row(found, "printing") == [each.printing and each.printing.verdict for each in checked]
    assert row(found, "printing")[1] == "fail"
    assert row(found, "problems") == [float(len(each.problems)) for each in checked]
    assert better(found, "printing") == ["row-3"]


def test_what_cannot_be_compared_is_refused(tmp_path: Path, store: Path) -> None:
    with refused(Kind.OUT_OF_RANGE, "subjects", 1):
        studies.compare(ARRAY)
    with refused(Kind.OUT_OF_RANGE, "subjects", MOST_SUBJECTS + 1):
        studies.compare(*[ARRAY] * (MOST_SUBJECTS + 1))
    with refused(Kind.WRONG_TYPE, "subjects"):
        studies.compare(ARRAY, 3)  # type: ignore[arg-type]
    with refused(Kind.UNKNOWN, file="nowhere"):
        read_subject("nowhere")
    with refused(Kind.WRONG_TYPE, file=str(store)):
        read_subject(store)
    with refused(Kind.UNKNOWN, "case", 7, file=str(store)):
        read_subject(f"{store}#7")
    with refused(Kind.OUT_OF_RANGE, "out", file="x.png"):
        studies.compare(ARRAY, SHORT, out=tmp_path / "x.png")


def test_a_damaged_run_is_refused(tmp_path: Path) -> None:
    copy = tmp_path / "copy"
    shutil.copytree(small_run().folder, copy)
    results = copy / "results.json"
    content = json.loads(results.read_text(encoding="utf-8"))
    del content["network"]["top1"]
    results.write_text(json.dumps(content), encoding="utf-8")
    with refused(Kind.UNREADABLE, file=str(copy)):
        studies.compare(copy, SHORT, printing=False)
    results.unlink()
    with refused(Kind.MISSING, file="results.json"):
        read_subject(copy)


def test_messages_of_comparisons(tmp_path: Path, store: Path) -> None:
    study, text, empty = (tmp_path / name for name in ("study.toml", "notes.txt", "empty"))
    studies.Study(**{**STUDY, "base": "array-2x6"}).save(study)
    text.write_text("notes", encoding="utf-8")
    empty.mkdir()
    check_messages(
        Path(__file__).with_name("messages.txt"),
        {
            "one": lambda: studies.compare(ARRAY),
            "type": lambda: read_subject(3),  # type: ignore[arg-type]
            "nowhere": lambda: read_subject("nowhere"),
            "study": lambda: read_subject(study),
            "text": lambda: read_subject(text),
            "folder": lambda: read_subject(empty),
            "store": lambda: read_subject(store),
            "case": lambda: read_subject(f"{store}#7"),
            "no number": lambda: read_subject(f"{store}#best"),
            "case of a folder": lambda: read_subject(f"{empty}#1"),
            "picture": lambda: studies.compare(ARRAY, SHORT, out=tmp_path / "x.png"),
            "itself": lambda: studies.compare(text, ARRAY, out=text.with_suffix(".html").with_name("study.toml")),
        },
        {str(tmp_path): "FOLDER", str(store.parent): "SWEEP"},
    )


def test_libraries_of_coarse_grids_are_compared_as_far_as_they_go() -> None:
    coarse = library_of("array-2x6")
    found = studies.compare(coarse, "array-2x6", printing=False)
    assert row(found, "distance_smallest")[0] is not None
    assert found.curves[0].frequency.tolist() == coarse.frequency.tolist()

"""Searches: what they propose can be printed, what they find is better, and killed ones go on."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from optuna.trial import FixedTrial
from refusals import check_messages, refused
from small_run import small_design

import acoustic_fem
from geometry import Kind, prototype
from geometry.design.design_file import load_design
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import buildability_notes
from geometry.stock import catalogue
from studies.findings.search_files import read_search, save_search
from studies.optimization.journal import JOURNAL, opened, read_only, seal
from studies.optimization.printable import Demand, PrintDemand, measures
from studies.optimization.problem import Limit, Optimization, read_optimization
from studies.optimization.search import (
    Candidate,
    OptimizationResult,
    _proposed,
    found_so_far,
    pareto_front,
    refusal_of,
    search_designs,
)
from studies.study.metric_registry import metrics_named
from studies.study.parameter import StudyError

STUDY = """
name = "small"
base = "fingertip-3x4"
fidelity = "lumped"
frequency = "1:100:12"
seed = 3
metrics = ["distance_mean"]
stock = "off"

[vary]
"tube.length" = { from = 2.4, to = 5.0 }
"tube.inner_diameter" = { from = 0.05, to = 0.3 }
"resonator.cavity_height" = { from = 1.1, to = 2.2 }

"""
OPTIMIZE = """
[optimize]
trials = 96
batch = 24

[[optimize.objectives]]
metric = "distance_smallest"

[[optimize.objectives]]
metric = "sensitivity_force"

[[optimize.limits]]
metric = "ild_smallest"
least = 1.5
"""
SEARCH = STUDY + OPTIMIZE


@pytest.fixture(scope="module")
def problem() -> Optimization:
    return read_optimization(SEARCH)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("search")


@pytest.fixture(scope="module")
def found(problem: Optimization, folder: Path) -> OptimizationResult:
    return search_designs(problem, folder)


def test_every_computed_design_can_be_printed_and_laid_out(problem: Optimization, found: OptimizationResult) -> None:
    assert len(found.candidates) > 40
    for each in found.candidates:
        design = problem.study.base.with_values(each.values)
        assert buildability_notes(design, lay_out(design)) == ()
        assert design.tube.inner_diameter >= 0.18 - 1e-9  # the base's: below what is advised, above what fails
        assert all(measure.value >= measure.rule.limit - 1e-6 for measure in measures(design))
    assert len(found.candidates) + sum(count for _, count in found.refused) == problem.trials


def test_the_front_keeps_the_limits_and_nothing_beats_it(found: OptimizationResult) -> None:
    def figures(each: Candidate) -> np.ndarray:
        return np.array([each.metrics["distance_smallest"], each.metrics["sensitivity_force"]])

    assert found.front
    assert all(each.metrics["ild_smallest"] >= 1.5 for each in found.front)
    for own in found.front:
        for other in found.candidates:
            if other.feasible:
                assert not ((figures(other) >= figures(own)).all() and (figures(other) > figures(own)).any())
    assert found.front[0].metrics["distance_smallest"] > 1.05 * found.base.metrics["distance_smallest"]


def test_the_figures_of_a_search_are_those_of_the_design(problem: Optimization, found: OptimizationResult) -> None:
    best = found.front[0]
    library = acoustic_fem.solve(problem.study.base.with_values(best.values), problem.study.frequency, "lumped")
    for metric in metrics_named(best.metrics):
        assert best.metrics[metric.name] == pytest.approx(metric.of_library(library), rel=1e-6, abs=0)


def test_a_search_that_was_cut_short_ends_as_one_that_was_not(
    problem: Optimization, found: OptimizationResult, folder: Path, tmp_path: Path
) -> None:
    text = (folder / JOURNAL).read_bytes()
    (tmp_path / JOURNAL).write_bytes(text[: int(0.6 * len(text))])  # in the middle of a batch and of a line
    again = search_designs(problem, tmp_path)
    assert [(c.number, c.values, c.metrics) for c in again.candidates] == [
        (c.number, c.values, c.metrics) for c in found.candidates
    ]
    assert again.refused == found.refused


@pytest.mark.slow
def test_a_search_killed_for_real_goes_on(tmp_path: Path, problem: Optimization, found: OptimizationResult) -> None:
    study = tmp_path / "study.toml"
    study.write_text(SEARCH, encoding="utf-8")
    code = (
        "import sys; from pathlib import Path; from studies.optimization.search import search_designs; "
        "from studies.optimization.problem import load_optimization; "
        f"search_designs(load_optimization({str(study)!r}), Path({str(tmp_path)!r}))"
    )
    child = subprocess.Popen([sys.executable, "-c", code], cwd=Path(__file__).parents[3])
    journal = tmp_path / JOURNAL
    while child.poll() is None and (not journal.is_file() or journal.stat().st_size < 20_000):
        time.sleep(0.02)
    os.kill(child.pid, signal.SIGKILL)
    child.wait()
    (tmp_path / f"{JOURNAL}.lock").unlink(missing_ok=True)  # Optuna waits half a minute for its owner
    again = search_designs(problem, tmp_path)
    assert [(c.number, c.values) for c in again.candidates] == [(c.number, c.values) for c in found.candidates]


@pytest.mark.slow
def test_what_is_on_disk_is_what_was_found(problem: Optimization, found: OptimizationResult, folder: Path) -> None:
    save_search(problem, found, folder)
    _, again = read_search(folder)
    assert again.front == found.front
    first = load_design(folder / "best.toml")
    assert first.tube.inner_diameter == found.front[0].values["tube.inner_diameter"]
    assert len(list((folder / "front").glob("*.toml"))) == min(len(found.front), 10)
    number = found.front[-1].number
    out = folder / "one.toml"
    command = [sys.executable, "-m", "studies.cli", "best", str(folder), str(number), "--out", str(out)]
    subprocess.run(command, cwd=Path(__file__).parents[3], check=True, capture_output=True)
    assert load_design(out).tube == problem.study.base.with_values(found.front[-1].values).tube


@pytest.mark.parametrize("damage", ["a bit", "its end", "the seal"])
def test_a_damaged_search_is_refused_by_name_and_reading_writes_nothing(
    damage: str, problem: Optimization, found: OptimizationResult, folder: Path, tmp_path: Path
) -> None:
    broken = tmp_path / "search"
    shutil.copytree(folder, broken)
    save_search(problem, found, broken)
    read_search(broken)
    journal = bytearray((broken / JOURNAL).read_bytes())
    place = journal.rfind(b'"value":0.') + len(b'"value":0.')
    match damage:
        case "a bit":
            journal[place] = ord("1") if journal[place] != ord("1") else ord("2")
            (broken / JOURNAL).write_bytes(journal)
        case "its end":
            (broken / JOURNAL).write_bytes(journal[:-200])
        case _:
            (broken / "trials.seal").write_text("acoustic-fem search 2\nmany")
    before = {path: path.read_bytes() for path in broken.rglob("*") if path.is_file()}
    with refused(Kind.DAMAGED, file="trials.seal" if damage == "the seal" else JOURNAL, error=StudyError):
        read_search(broken)
    with pytest.raises(StudyError):
        search_designs(problem, broken)
    assert {path: path.read_bytes() for path in broken.rglob("*") if path.is_file()} == before


def test_designs_whose_parts_failed_stay_out(
    problem: Optimization, found: OptimizationResult, folder: Path, tmp_path: Path
) -> None:
    again = tmp_path / "search"
    shutil.copytree(folder, again)
    save_search(problem, found, again)
    first = found.front[0].number
    seal(again, {first: "drawn and measured: thinnest wall"})
    _, read = read_search(again)
    assert first not in {each.number for each in read.candidates}
    assert dict(read.refused)["drawn and measured: thinnest wall"] == 1


def test_a_search_is_not_continued_with_another_table_of_the_atlas(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    few = SEARCH.replace('"lumped"', '"atlas"').replace("trials = 96", "trials = 8").replace("batch = 24", "batch = 8")
    problem, digest = read_optimization(few), acoustic_fem.atlas.cell_atlas().digest
    first = search_designs(problem, tmp_path)
    table = replace(acoustic_fem.atlas.cell_atlas(), digest="0123456789ab")
    monkeypatch.setattr("acoustic_fem.atlas.cell_atlas", lambda: table)
    with pytest.raises(StudyError) as error:
        search_designs(problem, tmp_path)
    assert str(error.value) == (
        f"{tmp_path / JOURNAL}: is not continued: its cells are of table {digest} of the atlas, not of 0123456789ab, "
        "which is installed; give a new folder"
    )
    assert len(found_so_far(problem, tmp_path).candidates) == len(first.candidates)  # what is there can be read


def test_a_folder_of_another_search_is_refused(found: OptimizationResult, folder: Path) -> None:
    other = read_optimization(SEARCH.replace("least = 1.5", "least = 1.6"))
    with pytest.raises(StudyError, match="another problem"):
        search_designs(other, folder)


def test_a_front_is_what_no_other_beats() -> None:
    values = np.array([[1.0, 3.0], [2.0, 2.0], [1.0, 2.0], [3.0, 1.0], [3.0, 1.0], [0.0, 3.0]])
    assert pareto_front(values).tolist() == [True, True, False, True, True, False]


@pytest.mark.parametrize(("demand", "bore"), [("least", 0.1), ("advised", 0.2), ("base", 0.18)])
def test_a_demand_gives_the_narrowest_bore(demand: Demand, bore: float) -> None:
    rules = PrintDemand(prototype("fingertip-3x4"), demand)
    assert rules.least_value("tube.inner_diameter") == pytest.approx(bore)
    assert rules.least_value("tube.length") is None
    thin = prototype("fingertip-3x4").with_values({"tube.inner_diameter": bore - 0.01})
    assert "tube.inner_diameter" in rules.refusals(thin)[0]


def test_shells_that_collide_are_refused(problem: Optimization) -> None:
    design, reason = refusal_of(problem, {"tube.length": 12.0})
    assert design is None
    assert "tube" in reason


#: What is changed in the file of a search -> kind and field of the refusal.
WRONG = (
    (OPTIMIZE, "", Kind.MISSING, "optimize"),
    ('metric = "distance_smallest"', 'metric = "distance"', Kind.UNKNOWN, "optimize.objectives.0.metric"),
    ('metric = "sensitivity_force"', 'metric = "distance_smallest"', Kind.CONFLICT, "optimize.objectives.1.metric"),
    ("least = 1.5", "", Kind.MISSING, "optimize.limits.0"),
    ("least = 1.5", "least = 1.5\nmost = 1.0", Kind.CONFLICT, "optimize.limits.0.least"),
    ("trials = 96", "trials = 0", Kind.OUT_OF_RANGE, "optimize.trials"),
    ("to = 0.3 }", "to = 0.1 }", Kind.OUT_OF_RANGE, "vary.tube.inner_diameter"),
    ("trials = 96", "trials = 96\nrefine = 30", Kind.UNKNOWN, "optimize.refine"),
    ("1:100:12", "5:50:10", Kind.UNSUITABLE, "frequency"),
    ("1:100:12", "1:100:2", Kind.UNSUITABLE, "frequency"),
)


@pytest.mark.parametrize(("old", "new", "kind", "field"), WRONG)
def test_a_bad_file_is_refused_by_name(old: str, new: str, kind: Kind, field: str) -> None:
    assert old in SEARCH
    with refused(kind, field, file="study.toml", error=StudyError):
        read_optimization(SEARCH.replace(old, new), "study.toml")


def test_a_limit_is_said_with_its_unit_where_it_has_one() -> None:
    top1, force = metrics_named(["predicted_top1", "sensitivity_force"])
    assert str(Limit(top1, 0.99, None)) == "predicted_top1 at least 0.99"
    assert str(Limit(force, 1.0, 2e4)) == "sensitivity_force at least 1 and at most 20000 Pa/N"


def test_the_example_of_the_docs_is_better_than_its_base() -> None:
    """Clearly: the figures docs/optimize.md gives, at the lumped fidelity."""
    best = load_design(Path(__file__).parents[3] / "docs" / "examples" / "fingertip-12.toml")
    base = prototype("fingertip-3x4")
    rules = PrintDemand(base, "base")
    assert rules.refusals(best) == []
    assert best.layout.pitch == base.layout.pitch
    assert best.printing == base.printing
    frequency = np.linspace(1, 100, 64)
    names = ("distance_smallest", "distance_mean", "sensitivity_force")
    figures = np.array(
        [
            [metric.of_library(acoustic_fem.solve(design, frequency, "lumped")) for metric in metrics_named(names)]
            for design in (base, best)
        ]
    )
    assert (figures[1, :2] > 1.4 * figures[0, :2]).all()
    assert figures[1, 2] >= 40000


def test_a_search_takes_only_sizes_that_can_be_bought() -> None:
    sheets = STUDY.replace(
        '"resonator.cavity_height" =',
        '"membrane.thickness" = { from = 0.3, to = 0.75, step = 0.1 }\n"resonator.cavity_height" =',
    )
    found = read_optimization(sheets + OPTIMIZE)
    drawn = {"tube.length": 3.0, "tube.inner_diameter": 0.2, "resonator.cavity_height": 1.5}
    for proposed, bought in ((0.3, 0.3), (0.42374060602614, 0.4), (0.75, 0.7)):
        trial: Any = FixedTrial({**drawn, "membrane.thickness": proposed})
        assert _proposed(trial, found)["membrane.thickness"] == bought


BOUGHT = """
base = "array-2x6"
fidelity = "lumped"
frequency = "1:100:12"
metrics = ["sensitivity_force"]

[vary]
"tube.inner_diameter" = { from = 0.3, to = 0.7 }
"membrane.thickness" = { from = 0.3, to = 0.8 }
"resonator.cavity_height" = { from = 2.0, to = 5.0 }

[optimize]
trials = 24
batch = 8
method = "%s"

[[optimize.objectives]]
metric = "scatter_detection"
"""


@pytest.mark.parametrize("method", ["random", "nsga2", "tpe", "gradient"])
def test_every_design_of_a_search_is_made_of_parts_that_can_be_bought(method: str, tmp_path: Path) -> None:
    problem = read_optimization(BOUGHT % method, base=small_design())
    found = search_designs(problem, tmp_path)
    assert len(found.candidates) > 12
    stock = catalogue()
    for each in found.candidates:
        fit = stock.fit(problem.study.base.with_values(each.values))
        assert fit.bought, (each.values, fit.changes, fit.missing)
        assert each.values["tube.inner_diameter"] >= 0.44  # the base's, below which the process is not advised
    assert len({each.values["resonator.cavity_height"] for each in found.candidates}) > 8


def test_a_search_has_no_list_of_which_nothing_can_be_printed() -> None:
    with refused(Kind.OUT_OF_RANGE, "vary.tube.inner_diameter", error=StudyError):
        read_optimization((BOUGHT % "random").replace("to = 0.7", "to = 0.42"))


# -- along slopes -------------------------------------------------------------------------------------------
DESCENT = """
base = "array-2x6"
fidelity = "lumped"
frequency = "1:100:12"
metrics = ["sensitivity_force"]
stock = "off"

[vary]
"tube.inner_diameter" = { from = 0.3, to = 0.7 }
"resonator.cavity_height" = { from = 2.0, to = 5.0 }

[optimize]
trials = 12
batch = 4
method = "gradient"

[[optimize.objectives]]
metric = "scatter_detection"
"""


@pytest.mark.slow
def test_a_search_along_slopes_goes_down_and_ends_as_one_that_was_not_cut_short(tmp_path: Path) -> None:
    problem = read_optimization(DESCENT, base=small_design())
    whole, cut = tmp_path / "whole", tmp_path / "cut"
    whole.mkdir(), cut.mkdir()
    found = search_designs(problem, whole)
    values = [each.metrics["scatter_detection"] for each in found.candidates]
    assert len(values) == 12
    assert values[0] == pytest.approx(found.base.metrics["scatter_detection"], rel=0.1)
    assert values == sorted(values, reverse=True)
    assert found.front[0].metrics["scatter_detection"] == min(values) < 0.99 * values[0]

    text = (whole / JOURNAL).read_bytes()
    (cut / JOURNAL).write_bytes(text[: int(0.6 * len(text))])
    again = search_designs(problem, cut)
    assert [each.values for each in again.candidates] == [each.values for each in found.candidates]


#: What is changed in the file of a search along slopes -> field of the refusal.
NOT_FREE = (
    ('"scatter_detection"', '"distance_smallest"', "optimize.method"),
    ("{ from = 0.3, to = 0.7 }", "[0.3, 0.5]", "vary.tube.inner_diameter"),
    ("to = 0.7 }", "to = 0.7, step = 0.1 }", "vary.tube.inner_diameter"),
)


@pytest.mark.parametrize(("old", "new", "field"), NOT_FREE)
def test_what_cannot_be_searched_along_slopes_is_refused(old: str, new: str, field: str) -> None:
    with refused(Kind.CONFLICT, field, error=StudyError):
        read_optimization(DESCENT.replace(old, new))


def test_the_messages_of_searches() -> None:
    calls = {f"{old.strip()} -> {new}": (SEARCH, old, new) for old, new, _, _ in WRONG[1:]}
    calls |= {f"{old} -> {new}": (DESCENT, old, new) for old, new, _ in NOT_FREE} | {"nothing": (SEARCH, OPTIMIZE, "")}
    texts = {name.replace("\n", " "): text.replace(old, new) for name, (text, old, new) in calls.items()}
    messages = {name: partial(read_optimization, text, "study.toml") for name, text in texts.items()}
    check_messages(Path(__file__).parent / "messages.txt", messages)


BEGUN = '{"op_code": 0, "worker_id": "a", "study_name": "acoustic-fem", "directions": [1]}\n'
TRIAL = '{"op_code": 4, "worker_id": "a", "study_id": 0, "datetime_start": "2026-01-01T00:00:00"}\n'
SET = (
    '{"op_code": 5, "worker_id": "a", "trial_id": 0, "param_name": "x", "param_value_internal": 1, '
    '"distribution": "%s"}\n'
)
LINES = {
    "an operation that there is not": '{"op_code": 99}\n',
    "an operation below 0": '{"op_code": -1}\n',
    "deep": "[" * 100_000 + "\n",
    "deep in a text": BEGUN + TRIAL + SET % ("[" * 100_000),
    "a number of 5000 digits": f'{{"op_code": {"9" * 5000}}}\n',
    "a number": "1\n",
    "a list": "[]\n",
    "no time": BEGUN + TRIAL.replace("2026-01-01T00:00:00", "soon"),
    "a range the wrong way round": BEGUN
    + TRIAL
    + SET % r"{\"name\": \"FloatDistribution\", \"attributes\": {\"low\": 2, \"high\": 1}}",
    "a direction that there is not": BEGUN.replace("[1]", "[7]"),
    "no text": "\udcff\udcfe\n",
}


@pytest.mark.parametrize("line", LINES)
def test_a_line_of_no_journal_is_refused_by_the_file(line: str, tmp_path: Path) -> None:
    (tmp_path / JOURNAL).write_bytes(LINES[line].encode(errors="surrogateescape"))
    with refused(Kind.UNREADABLE, file=tmp_path / JOURNAL, error=StudyError):
        opened(tmp_path, ["minimize"], {}, "")
    with refused(Kind.UNREADABLE, file=tmp_path / JOURNAL, error=StudyError), read_only(tmp_path, ["minimize"], {}):
        pass


@pytest.mark.parametrize("name", [JOURNAL, "trials.seal"])
@pytest.mark.parametrize("kind", ["pipe", "device", "circle", "folder", "link"])
def test_a_journal_that_is_no_file_is_refused_before_it_is_opened(kind: str, name: str, tmp_path: Path) -> None:
    opened(tmp_path, ["minimize"], {}, "")
    path = tmp_path / name
    path.unlink()
    match kind:
        case "pipe":
            os.mkfifo(path)
        case "folder":
            path.mkdir()
        case _:
            path.symlink_to({"device": "/dev/zero", "circle": path, "link": tmp_path / "nothing"}[kind])
    with pytest.raises(StudyError) as found:
        opened(tmp_path, ["minimize"], {}, "")
    assert found.value.file == str(path)
    assert found.value.kind in (Kind.EXISTS, Kind.UNREADABLE, Kind.MISSING)


@pytest.mark.parametrize("target", ["trials.journal", "nothing"])
def test_the_lock_of_a_search_that_was_killed_keeps_nobody_waiting(target: str, tmp_path: Path) -> None:
    opened(tmp_path, ["minimize"], {}, "")
    (tmp_path / f"{JOURNAL}.lock").symlink_to(target)
    assert len(opened(tmp_path, ["minimize"], {}, "").trials) == 0

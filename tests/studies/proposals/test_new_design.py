"""Designs that answer a question, what would work where none does, and the three jobs of a designer."""

from types import SimpleNamespace

import pytest
from refusals import refused

import geometry
import studies
from geometry import Kind
from geometry.layout import array_size, buildability_notes, lay_out
from geometry.schema.print_processes import find_process
from geometry.stock import catalogue
from studies.metrics.build import smallest_wall
from studies.proposals import design_search as searching, proposing
from studies.proposals.candidates import Candidates
from studies.proposals.design_search import Effort, Found
from studies.proposals.design_writing import write_proposal
from studies.proposals.designer_question import question
from studies.proposals.drawn_designs import drawn_findings
from studies.proposals.grids import Grid, grids
from studies.proposals.most_points import grid_counts
from studies.proposals.other_questions import _budgets, _counts, _freed, _sizes, _targets
from studies.verdict import Drawn, Measured

#: Enough for a small array.
SMALL = Effort(draws=40, judged=2, near=20, rounds=2)


@pytest.fixture
def quick(monkeypatch):
    """A search that tries little."""
    monkeypatch.setattr(proposing, "thorough", lambda points: SMALL)


def proposal(outcome, taps, cost, force, height, level=-6.0):
    """A found design as the choice of proposals sees it."""
    figures = SimpleNamespace(taps=taps, cost=cost, smallest_force=force, size=(30.0, 30.0, height))
    values = {name: Measured(taps, "") for name in ("taps", "presses", "multi-sines")}
    return Found(
        object(), SimpleNamespace(outcome=outcome, figures=figures, values=values, above_overload=level), {}, None
    )


def test_the_best_three_differ_in_what_they_are_best_at():
    best, cheap, light, bad = (
        proposal("works", 0.99, 9.0, 2e-5, 9.0), proposal("works", 0.97, 4.0, 3e-5, 9.5),
        proposal("works", 0.96, 8.0, 1e-6, 9.5), proposal("marginal", 0.8, 1.0, 1e-7, 1.0),
    )  # fmt: skip
    chosen = proposing._chosen([best, cheap, light, bad])
    assert [each.design for each in chosen] == [best.design, cheap.design, light.design]
    assert [each.strength for each in chosen] == ["most accurate", "cheapest", "lightest touch"]
    assert proposing._chosen([]) == ()


def test_of_designs_that_work_the_ones_whose_taps_are_not_clipped_come_first():
    clipped, whole = proposal("works", 0.99, 4.0, 2e-5, 8.0, level=3.0), proposal("works", 0.96, 4.0, 2e-5, 8.0)
    assert sorted([clipped, whole], key=lambda each: each.merit) == [whole, clipped]
    assert (clipped.is_whole, whole.is_whole) == (False, True)
    marginal = proposal("marginal", 0.9, 4.0, 2e-5, 8.0)
    assert not marginal.is_whole


def test_every_strength_is_true_of_all_that_are_proposed():
    best, light, other = (
        proposal("works", 0.99, 4.0, 2e-5, 8.0), proposal("works", 0.97, 6.0, 1e-6, 9.0),
        proposal("works", 0.96, 5.0, 3e-5, 9.0),
    )  # fmt: skip
    chosen = proposing._chosen([best, light, other])
    assert [each.design for each in chosen] == [best.design, light.design, other.design]
    assert [each.strength for each in chosen] == ["most accurate, cheapest", "lightest touch", "next best"]
    sure, sharp = proposal("works", 0.9, 4.0, 2e-5, 8.0), proposal("marginal", 0.95, 5.0, 3e-5, 9.0)
    assert [each.strength for each in proposing._chosen([sure, sharp])] == [
        "cheapest, lightest touch", "most accurate",
    ]  # fmt: skip


def test_a_design_whose_drawn_parts_do_not_go_together_is_not_proposed(monkeypatch):
    first, second = proposal("works", 0.99, 4.0, 2e-5, 8.0), proposal("works", 0.97, 6.0, 1e-6, 9.0)
    bad = {id(first.design)}
    monkeypatch.setattr(
        proposing, "drawn_findings", lambda design: Drawn(("in the way",)) if id(design) in bad else Drawn()
    )
    told = []
    assert proposing._sound([first, second], lambda *step: told.append(step)) == [second]
    assert len(told) == 2
    design = geometry.prototype("array-2x6")
    bad.add(id(design))
    alone = Found(design, first.verdict, {}, None)
    (only,) = proposing._sound([alone], lambda *step: None)
    assert only.verdict.outcome == "does not work"
    assert only.verdict.values["buildable"].value == 1


@pytest.mark.slow
def test_findings_on_drawn_parts_are_those_of_a_check():
    design = geometry.prototype("array-2x6")
    assert drawn_findings(design) == Drawn()
    seat = {"microphone.chamber_height": 2.18, "microphone.wall_thickness": 2.0, "microphone_tube.outer_diameter": 1.62}
    (found,) = drawn_findings(design.with_values(seat)).failures
    assert (found.part, found.rule) == ("microphone-housing", "thinnest wall")
    assert found.value == pytest.approx(0.1)


@pytest.mark.physics
@pytest.mark.usefixtures("quick")
@pytest.mark.slow
def test_a_new_design_works_can_be_built_and_bought_and_fits(tmp_path):
    told = []
    made = studies.new_design(
        "mine", tmp_path / "mine.toml", size="50x25", points=8, progress=lambda *step: told.append(step)
    )
    assert geometry.load_design(tmp_path / "mine.toml") == made
    assert made.point_count == 8
    assert made.target.size == (50.0, 25.0)
    assert buildability_notes(made, lay_out(made)) == ()
    assert catalogue().fit(made).bought
    verdict = studies.Verdict(made)
    assert verdict.outcome == "works"
    assert verdict.above_overload < 0
    length, width, _ = array_size(made)
    assert length <= 50.01
    assert width <= 25.01
    steps, done = zip(*told, strict=True)
    assert any("round 1" in step and "verdict 2" in step for step in steps)
    assert list(done) == sorted(done)


@pytest.mark.slow
@pytest.mark.usefixtures("quick")
def test_proposals_are_the_same_every_time_and_a_number_chooses(tmp_path):
    found, again = (studies.propose_designs("mine", size="50x25", points=8) for _ in range(2))
    assert [each.design for each in found.designs] == [each.design for each in again.designs]
    assert len(found.designs) > 1
    made = studies.new_design("mine", tmp_path / "mine.toml", size="50x25", points=8, choose=2)
    assert made == found.designs[1].design
    with refused(Kind.OUT_OF_RANGE, "choose", 4):
        write_proposal(found, tmp_path / "other.toml", 4)


@pytest.mark.slow
def test_what_cannot_work_says_why_and_what_would(tmp_path, monkeypatch):
    monkeypatch.setattr(proposing, "thorough", lambda points: SMALL)
    with refused(Kind.CONFLICT, "points", 36) as found:
        studies.new_design("mine", tmp_path / "mine.toml", size="900x900", points=36, microphones=4)
    assert {"size", "target"} & set(found.value.remedy)
    assert list(tmp_path.iterdir()) == []


def test_drawn_designs_leave_walls_that_can_be_printed_around_every_socket():
    asked = question(around=160, points=10)
    drawn = Candidates(asked, "band", grids(asked, 10)[0]).drawn(60)
    assert len(drawn) > 20
    assert min(smallest_wall(design) for design, _ in drawn) >= find_process(asked.printer).wall.limit


def test_a_size_below_the_diameter_without_room_for_a_part_of_a_turn_is_refused_by_its_name(tmp_path):
    with refused(Kind.CONFLICT, "size", "30x30"):
        studies.new_design("mine", tmp_path / "mine.toml", around=160, size="30x30")


def test_numbers_of_points_that_have_room_are_full_grids():
    counts = grid_counts(question(points="most", size="30x30"))
    assert 16 in counts
    assert max(counts) < 60
    assert grid_counts(question(points="most", size="30x30", rows=2)) != counts


@pytest.mark.physics
def test_a_design_that_cannot_be_built_is_no_answer():
    design = geometry.prototype("array-2x6")
    assert searching.can_be_built(design)
    assert not searching.can_be_built(geometry.prototype("line-4"))  # drawn schematically


def test_a_line_along_fingers_ends_at_the_palm_where_the_next_one_begins():
    asked = question(place="hand", points=15)
    lines = grids(asked, 15)[0].lines(["A", "B", "C"])
    assert [line["points"] for line in lines] == [6, 9]
    assert [line["points"] for line in Grid("hand", 9, 3, "ends").lines(["A", "B", "C"])] == [6, 3]
    assert [line["points"] for line in Grid("area", 15, 3, "ends").lines(["A", "B", "C"])] == [9, 6]


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        ({"size": "6x6", "points": 12}, "no tube of the catalogue"),
        ({"size": "30x30", "points": 16, "tubes_below": 2.0}, "mm below the shells, and there are 2 mm"),
        ({"rows": 3, "columns": 5, "points": 15, "size": "12x12"}, "do not fit on 12 x 12 mm"),
    ],
    ids=str,
)
def test_a_question_without_any_design_is_told_the_obstacle(asked, words):
    assert words in searching.obstacle(question(**asked))


def test_what_would_work_starts_from_the_rule_that_is_broken():
    mat = question(size="1000x1000", points=100, microphones=4)
    assert all(max(step[0]["size"]) < 1000 for step in _sizes(mat, {"coverage"}))
    assert all(max(step[0]["size"]) > 1000 for step in _sizes(mat, {"separate"}))
    assert _counts(100) == [3, 5, 6, 11]
    assert _counts(13) == [3, 4, 6, 8, 11, 16]  # a prime number of points
    poor = question(points=12, budget=2.0)
    assert [step[0]["budget"] for step in _budgets(poor, {"affordable"})] == [2.5, 3.2, 5.0, 8.0]
    assert list(_budgets(poor, {"taps"})) == []
    foot = question(points=20, size="1000x1000", target="foot 100 N")
    assert [step[0]["touch"] for step in _targets(foot, {"bottoming"})][:2] == ["foot 50 N", "foot 20 N"]
    assert [step[1] for step in _freed(question(points=16, pitch=5.0, rows=4))] == [
        ("without ", "pitch"), ("without ", "rows"),
    ]  # fmt: skip

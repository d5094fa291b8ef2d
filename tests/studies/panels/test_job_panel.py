"""The dialogue of a job: what it offers, what it asks, and the cards of what is proposed."""

from __future__ import annotations

from typing import Any

import pytest

from geometry import Refusal, prototype, prototype_names
from geometry.layout.arrangement import lay_out
from studies.panels import job_panel
from studies.panels.form import stated_values
from studies.panels.job_panel import ANSWERS, job_words, plan_of, proposals_for
from studies.proposals import PLACES, Proposal, Proposals, Question
from studies.verdict import Verdict, figure_rows

ARRAY = prototype("array-2x6")


def test_a_plan_has_every_membrane_microphone_and_line() -> None:
    design = prototype("line-4")
    plan, layout = plan_of(design), lay_out(design)
    for (x, y, radius), point in zip(plan["points"], layout.points, strict=True):
        assert (x, y) == pytest.approx(point.position[:2], rel=1e-3)
        assert radius == design.resonator.cavity_diameter / 2
    assert [*plan["microphones"]] == [pytest.approx(each.position[:2], rel=1e-3) for each in layout.microphones]
    assert [number for line in plan["lines"] for number in line] == [*range(1, design.point_count + 1)]
    assert [len(line) for line in plan["lines"]] == [line.points for line in design.lines]


def test_the_dialogue_offers_every_place_and_prototype(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(job_panel, "plan_of", lambda design: design.name)
    words = job_words()
    assert [*words["places"]] == [*PLACES]
    assert words["prototypes"] == {name: name for name in prototype_names()}
    assert words["printer"] in words["printers"]
    assert words["target"].split()[0] in words["contacts"]


@pytest.mark.parametrize(
    ("asked", "field"),
    [
        ({"colour": "red"}, "requirement"),
        ({"points": 16}, "points"),
        ({"microphones": "2"}, "microphones"),
        ({"budget": True}, "budget"),
        ({"place": "moon"}, "moon"),
        ({"size": "small"}, "small"),
    ],
)
def test_an_answer_that_is_none_is_refused(asked: dict[str, Any], field: str) -> None:
    with pytest.raises(Refusal, match=field):
        proposals_for("mine", asked)


def test_a_card_has_the_figures_of_the_verdict_and_the_design_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[str] = []
    verdict = Verdict(ARRAY)

    def propose(wished: Question, name: str, progress: Any) -> Proposals:
        progress("figures of 3 designs", 0.5)
        return Proposals(wished, (Proposal(ARRAY, verdict, "the smallest"),), ())

    monkeypatch.setattr(job_panel, "propose", propose)
    shown = proposals_for("mine", {"points": "12", "budget": 20}, told.append)
    assert told == ["figures of 3 designs, 50%"]
    (card,) = shown["designs"]
    assert (card["outcome"], card["points"], card["strength"]) == (verdict.outcome, 12, "the smallest")
    assert card["rows"] == [list(row) for row in figure_rows(verdict)]
    assert card["stated"] == stated_values(ARRAY)
    assert shown["problem"] == ""
    assert {"points", "budget"} <= {*ANSWERS}

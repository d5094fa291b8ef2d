"""The verdict: designs that work, and one that fails for each kind of reason, with remedies that help."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from functools import lru_cache

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
import geometry
from acoustic_fem.library.noise_floor import detection_limits
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Kind
from geometry.printing.print_rules import Finding
from geometry.schema.target import Target
from geometry.stock import catalogue
from localize.contacts import loudest_outputs
from studies.metrics.predicted_accuracy import SweptAccuracies
from studies.verdict import (
    OUTCOMES,
    RULES,
    Drawn,
    Remedies,
    Remedy,
    Verdict,
    measure,
    overload_lines,
    points_in_words,
    reason_lines,
    remedy_in_words,
    rule_rows,
    worse_lines,
)
from studies.verdict.candidate_changes import CHOICES, changes_of
from studies.verdict.part_rules import stiffened
from studies.verdict.remedy_search import CHOICES_OF
from studies.verdict.rules import rule_named
from studies.verdict.swept_verdicts import swept_outcomes
from studies.verdict.tap_levels import loudest_taps, tap_levels

#: Thick membranes give even the uncalibrated sensor its accuracy.
ARRAY = geometry.prototype("array-2x6").with_values({"membrane.thickness": 1.0})
#: Designs that break one rule above all, by its name.
BROKEN = {
    "heard": {"lines.0.points": 40, "tube.length": 600.0, "layout.columns": 8},
    "fits": {"target.size": (30.0, 30.0)},
    "buyable": {"tube.spring_outer_diameter": 0.28, "tube.wire_diameter": 0.05, "tube.sheath_wall": 0.135},
    "printable": {"resonator.wall_thickness": 0.3, "membrane.rim_width": 0.3, "printing.port_lip": 0.15},
    "affordable": {"target.budget": 2.0},
    "slow": {"tube.length": 6.0, "resonator.wall_thickness": 1.5, "membrane.thickness": 3.0},
    "separate": {"target.contact_radius": 25.0},
    "bottoming": {"target.force": 20.0},
    "coverage": {"target.contact_radius": 0.1, "tube.length": 60.0},
}


def broken(rule: str) -> ArrayDesign:
    return ARRAY.with_values(BROKEN[rule])


@lru_cache
def verdict_on(rule: str) -> Verdict:
    return Verdict(broken(rule) if rule else ARRAY)


def test_a_design_that_works_has_no_reason_and_four_figures() -> None:
    verdict = verdict_on("")
    assert (verdict.outcome, verdict.reasons, verdict.fixes) == ("works", (), ())
    assert verdict.fixed() == ARRAY
    assert verdict.figures.taps > 0.95
    assert 0 < verdict.figures.smallest_force < ARRAY.target.force
    assert verdict.figures.size == geometry.layout.array_size(ARRAY)
    assert verdict.figures.cost > 0


@pytest.mark.parametrize("rule", BROKEN)
def test_each_rule_finds_the_design_that_breaks_it(rule: str) -> None:
    values = measure([broken(rule)], [rule])[0]
    assert rule_named(rule).outcome(values[rule].value) != "works"
    assert rule_named(rule).outcome(measure([ARRAY], [rule])[0][rule].value) == "works"


def test_a_deaf_line_says_which_points_and_how_much_sound_is_lost() -> None:
    design = broken("heard")
    found = measure([design], ["heard"])[0]["heard"]
    assert {1, 40} <= set(found.points)
    assert found.points == tuple(sorted(found.points))
    assert "dB of loss at 10 Hz through 40 tubes" in found.words
    assert found.words.startswith(points_in_words(found.points))


def test_the_signal_to_noise_ratio_is_that_of_the_matched_filter_of_a_library() -> None:
    level = tap_levels([ARRAY])[0].second.min()
    library = acoustic_fem.solve(ARRAY, np.geomspace(1, 100, 40), fidelity="lumped")
    both = detection_limits(library, (1.0, 100.0))["force"].values.max()
    # Twice the force is 6 dB, and the second-loudest microphone alone detects less than both together.
    harder = tap_levels([ARRAY.with_values({"target.force": 0.2})])[0].second.min()
    assert harder - level == pytest.approx(20 * math.log10(2), abs=1e-6)
    smallest = Verdict(ARRAY).design.target.force * 10 ** (-level / 20)
    assert both < 100 * smallest
    assert smallest < 100 * both


def test_many_designs_have_the_values_that_each_has_alone() -> None:
    rules = [rule.name for rule in RULES if rule.name not in ("designed", "taps", "presses", "multi-sines")]
    designs = [ARRAY, broken("heard"), geometry.prototype("glove")]
    for design, values in zip(designs, measure(designs, rules), strict=True):
        alone = measure([design], rules)[0]
        for name in rules:
            assert values[name].value == pytest.approx(alone[name].value, rel=1e-9, nan_ok=True)
            assert values[name].words == alone[name].words


@pytest.mark.parametrize("rule", ["heard", "slow", "fits", "separate", "bottoming", "affordable", "coverage"])
@pytest.mark.slow
def test_a_remedy_gives_what_it_promises_and_breaks_no_other_rule(rule: str) -> None:
    design = broken(rule)
    values = measure([design])[0]
    remedy = Remedies(design, values).best(rule)
    assert remedy is not None
    own, before, after = rule_named(rule), remedy.gain[0], remedy.gain[1]
    assert before == values[rule].value
    assert own.gain(before, after) > 0
    changed = measure([design.with_values(remedy.changes)])[0]
    assert changed[rule].value == pytest.approx(after, rel=1e-9)
    order = ("works", "marginal", "does not work")
    for other in RULES:
        if other.name != rule:
            now, then = (order.index(other.outcome(each[other.name].value)) for each in (values, changed))
            assert then <= now, other.name


def test_a_design_of_a_bore_that_nobody_sells_is_fixed_to_one_that_can_be_bought() -> None:
    design = ARRAY.with_values({"membrane.thickness": 0.96})
    verdict = Verdict(design)
    assert [rule.name for rule in verdict.broken] == ["buyable"]
    assert verdict.outcome == "marginal"
    fixed = verdict.fixed()
    assert fixed.membrane.thickness in catalogue().sizes("membrane.thickness")
    assert Verdict(fixed).outcome == "works"
    assert [list(remedy.changes) for remedy in verdict.fixes] == [["membrane.thickness"]]


def test_an_accuracy_that_is_not_known_is_marginal_and_says_why() -> None:
    many = ARRAY.with_values({"lines.0.points": 300})
    found = measure([many], ["taps", "presses"])[0]
    assert found["taps"].outcome(rule_named("taps")) == "marginal"
    assert "256 points" in found["taps"].words
    assert math.isnan(found["presses"].value)


def test_a_target_of_the_caller_replaces_that_of_the_design() -> None:
    verdict = Verdict(ARRAY, Target(size=(30.0, 30.0)))
    assert [rule.name for rule in verdict.broken] == ["fits"]
    assert Verdict(ARRAY, Target(size=(30.0, 120.0))).outcome == "works"  # turned by 90 degrees


def test_what_does_not_apply_is_not_judged() -> None:
    assert {"fits", "affordable"} <= set(verdict_on("").not_judged)
    one = ARRAY.with_values({"lines.0.points": 1})
    assert {"designed", "taps", "presses", "multi-sines", "separate"} <= set(Verdict(one).not_judged)


def test_findings_on_the_drawn_parts_count_and_have_no_remedy_that_was_not_computed_for_them() -> None:
    failed = Finding("shell", "thinnest wall", 0.1, 0.2, "mm", "fail", "drawn")
    verdict = Verdict(ARRAY, drawn=Drawn(("tube 1 and shell 2 are in each other's way",), (failed,)))
    assert [(reason.rule, reason.outcome, reason.remedy) for reason in verdict.reasons] == [
        ("buildable", "does not work", None),
        ("printable", "does not work", None),
    ]
    assert "tube 1 and shell 2" in verdict.reasons[0].words
    assert verdict.reasons[1].value == pytest.approx(0.5)


def test_the_verdict_is_json_and_lines() -> None:
    verdict = Verdict(broken("fits"))
    found = json.loads(json.dumps(verdict.to_dict(), allow_nan=False))
    assert found["outcome"] == "does not work"
    assert found["reasons"][0]["rule"] == "fits"
    assert found["rules"]["affordable"] == {"value": None, "unit": "1", "outcome": None}
    lines = list(reason_lines(verdict))
    assert "30 x 30 mm" in lines[0]
    assert ("  try " in lines[1]) == (verdict.reasons[0].remedy is not None)


def test_every_rule_has_choices_limits_in_order_and_a_row() -> None:
    assert [row[0] for row in rule_rows()] == [rule.name for rule in RULES]
    for rule in RULES:
        assert rule.gain(rule.marginal, rule.works) >= 0
        assert (rule.outcome(rule.works), rule.outcome(math.nan)) == ("works", "works")
        assert set(CHOICES_OF[rule.name]) <= set(CHOICES)
    with refused(Kind.UNKNOWN, field="rule", value="hear"):
        rule_named("hear")


@pytest.mark.parametrize("choice", CHOICES)
def test_every_choice_gives_valid_designs_that_differ(choice: str) -> None:
    base = broken("printable") if choice in ("lip", "wall") else ARRAY
    for change in changes_of(base, (choice,)):
        assert change.design == base.with_values(change.values)
        assert change.design != base


def test_points_are_listed_in_ranges() -> None:
    assert points_in_words((3,)) == "point 3"
    assert points_in_words((3, 5, 6, 7)) == "points 3 and 5 to 7"
    assert points_in_words((1, 2, 9)) == "points 1, 2 and 9"
    assert points_in_words(tuple(range(1, 30, 2))) == "15 points, such as 1"


def test_a_membrane_that_stretches_yields_less_than_a_plate() -> None:
    assert stiffened(1e-4, 0.5) == pytest.approx(1e-4, rel=1e-5)
    deflection = stiffened(2.0, 0.5)
    assert deflection + 0.443 * deflection**3 / 0.25 == pytest.approx(2.0)
    assert deflection < 1.2


@pytest.mark.slow
def test_a_fix_buys_the_nearest_parts_first_even_if_an_accuracy_becomes_marginal(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    design = ARRAY.with_values({"membrane.thickness": 0.96})
    real = measure([design.with_values({"membrane.thickness": 1.0})])[0]

    def measured(designs, rules=tuple(rule.name for rule in RULES), **about):
        """The figures with an accuracy that only the design as it was keeps."""
        found = measure(designs, rules, **about)
        for own, values in zip(designs, found, strict=True):
            if "taps" in values and own.membrane.thickness != 0.96:
                values["taps"] = replace(real["taps"], value=0.94)
        return found

    for module in ("verdict", "remedy_search"):
        monkeypatch.setattr(f"studies.verdict.{module}.measure", measured)
    verdict = Verdict(design)
    assert [rule.name for rule in verdict.broken] == ["buyable"]
    assert verdict.reasons[0].remedy is None
    assert verdict.fixes[0].changes == {"membrane.thickness": 1.0}


def test_progress_names_each_rule_whose_remedies_are_tried_and_only_rises() -> None:
    told: list[tuple[str, float]] = []
    verdict = Verdict(broken("fits"))
    verdict.compute(lambda message, fraction: told.append((message, fraction)))
    assert told[0] == ("figures of all rules", 0.0)
    assert any(message.startswith("fits: ") for message, _ in told)
    assert [fraction for _, fraction in told] == sorted(fraction for _, fraction in told)
    assert told[-1][1] <= 1


def test_a_remedy_says_what_becomes_of_its_rule_and_not_of_the_design() -> None:
    remedy = Remedy({}, "a change", (8.0, 83.8), "works", 2)
    assert remedy_in_words("heard", remedy) == "a change: 8 dB becomes 83.8 dB (keeps the rule)"


def test_equal_parts_of_a_chain_are_one_number() -> None:
    words = [change.words for change in changes_of(ARRAY, ("microphones",))]
    assert "3 microphones in place of 2, 6 points between two" in words
    assert "6 microphones in place of 2, 2 to 3 points between two" in words


def test_figures_that_a_fix_makes_worse_are_said() -> None:
    sparse = Verdict(ARRAY.with_values({"tube.length": 25.0}))
    lines = list(worse_lines(Verdict(ARRAY), sparse))
    assert any(line.startswith("worse by the change: coverage, ") for line in lines)
    assert not list(worse_lines(sparse, sparse))


def test_a_clipped_tap_is_said_beside_the_reasons_and_a_louder_microphone_ends_it() -> None:
    verdict = verdict_on("")
    library = acoustic_fem.solve(ARRAY, np.arange(1.0, 201.0), fidelity="lumped")
    # a force at which membranes are linear
    loudest = loudest_outputs(library, 1e-4, contact_radius_mm=ARRAY.target.contact_radius)
    ratio = loudest_taps([ARRAY.with_values({"target.force": 1e-4})])[0] / loudest
    assert ratio == pytest.approx(np.ones(loudest.shape), rel=0.02)
    assert verdict.loudest_tap == pytest.approx(1e3 * loudest.max(), rel=0.02)
    (line,) = overload_lines(verdict)
    assert line in list(reason_lines(verdict))
    assert f"{20 * math.log10(verdict.loudest_tap / 28.3):.1f} dB above the overload" in line
    louder = Verdict(ARRAY.with_values({"microphone.overload": 2 * verdict.loudest_tap}))
    assert louder.above_overload == pytest.approx(20 * math.log10(0.5))
    assert list(overload_lines(louder)) == []


def test_a_sweep_has_the_outcomes_of_the_verdicts() -> None:
    rules = ("", "buyable", "slow", "separate", "coverage", "affordable")
    designs = [broken(rule) if rule else ARRAY for rule in rules]
    expected = [verdict_on(rule).outcome for rule in rules]
    assert set(expected) == set(OUTCOMES)
    assert swept_outcomes(designs, SweptAccuracies(designs, 24)) == expected


def test_a_sweep_computes_no_accuracy_of_a_design_that_does_not_fit() -> None:
    none = SweptAccuracies([], 24)  # would raise if it were asked
    assert swept_outcomes([broken("fits")], none) == ["does not work"]

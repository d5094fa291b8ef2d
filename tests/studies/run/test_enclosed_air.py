"""The check says what enclosed air does to a design and which vent would help."""

from __future__ import annotations

import json

import pytest

import acoustic_fem
from acoustic_fem import LocalAir
from acoustic_fem.enclosed import enclosed_air
from geometry import prototype
from geometry.design.array_design import ArrayDesign
from studies.run.enclosed_air import EnclosedFindings, enclosed_findings

ARRAY = prototype("array-2x6")


def findings(design: ArrayDesign = ARRAY) -> EnclosedFindings:
    return enclosed_findings(design, acoustic_fem.solve(design, [1.0, 10.0, 100.0], "lumped"))


def test_a_sealed_design_is_told_its_states_their_time_and_the_vent_that_would_help() -> None:
    found = findings()
    worn, sweating, climbed = found.changes
    expected = enclosed_air(ARRAY, LocalAir(temperature_c=32.0))
    assert worn.overpressure == pytest.approx(expected.overpressure)
    assert worn.compliance == pytest.approx(100 * (expected.compliance_ratio - 1))
    assert worn.overpressure < sweating.overpressure < climbed.overpressure
    assert 0 > worn.compliance > sweating.compliance > climbed.compliance
    assert 20 < worn.response < sweating.response
    assert found.hours == pytest.approx(3.5, rel=0.05)
    assert found.vent is not None
    assert found.vent.time_constant == pytest.approx(10.0)
    content = json.loads(json.dumps(found.to_dict(), allow_nan=False))
    assert content["leak_seconds"] is None
    assert content["vent"]["diameter"] == pytest.approx(0.043, abs=0.001)


def test_a_vented_design_is_told_how_long_its_leak_takes() -> None:
    found = findings(ARRAY.with_values({"resonator.leak_diameter": 0.05}))
    assert found.vent is None
    assert 0.1 < found.leak_seconds < 1
    # What the air would do if it could not leave is that of the sealed design.
    assert found.changes[0].overpressure == pytest.approx(findings().changes[0].overpressure)


def test_a_membrane_whose_bulge_is_not_known_is_named() -> None:
    elastic = ARRAY.material(ARRAY.membrane.material).model_copy(update={"loss_factor": 0.0})
    stretched = {"materials": {"elastic": elastic}, "membrane.material": "elastic", "membrane.stretch": 1.1}
    found = findings(ARRAY.with_values(stretched))
    assert found.changes == ()
    assert "membrane.stretch" in found.unknown
    assert len(found.rows) == 1

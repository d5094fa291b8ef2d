"""Findings of ``check`` for a membrane whose law is not causal."""

from __future__ import annotations

import pytest

import geometry
from acoustic_fem.quantities.medium import Medium
from studies.run.validity import model_validity

WHAT = "stiffening of the membrane"


@pytest.mark.parametrize(("law", "lacks"), [("spring-pot", 0.0), ("constant", 34.0)])
def test_check_says_that_a_constant_loss_factor_is_not_causal(law: str, lacks: float) -> None:
    design = geometry.prototype("array-2x6").completed().with_values({"materials.silicone-shore-a-30.law": law})
    (found,) = [item for item in model_validity(design, Medium.at(), -20.0) if item.assumption.startswith(WHAT)]
    assert found.value == pytest.approx(lacks, abs=0.5)
    assert found.holds == (law == "spring-pot")
    assert ("not causal" in found.meaning) == (law == "constant")

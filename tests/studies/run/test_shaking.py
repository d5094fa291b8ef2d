"""The check says which touch a waved hand and a knock on the table look like."""

from __future__ import annotations

import json

import pytest

import acoustic_fem
from geometry import prototype
from geometry.design.array_design import ArrayDesign
from studies.run.shaking import ShakenFindings, shaken_findings
from studies.run.worst_findings import worst_of_motion


def findings(design: ArrayDesign) -> ShakenFindings:
    return shaken_findings(design, acoustic_fem.solve(design, [1.0, 10.0, 100.0], "lumped"))


@pytest.mark.parametrize(
    ("name", "pressure", "least", "most"),
    [("array-2x6", 0.31, 0.07, 0.09), ("fingertip-3x4", 0.11, 0.002, 0.003), ("line-2", 0.42, 0.8, 1.6)],
)
def test_a_waved_hand_looks_like_the_touch_that_an_independent_network_gave(
    name: str, pressure: float, least: float, most: float
) -> None:
    waved = findings(prototype(name)).states[0]
    assert waved.acceleration == 5.0
    assert waved.pressure == pytest.approx(5 * pressure, abs=0.05)
    assert least < 1e3 * waved.force / 5 < most  # mN per m/s2


def test_a_strong_touch_is_clear_of_motion_and_a_light_one_is_told_what_would_help() -> None:
    strong = findings(prototype("array-2x6"))
    assert all(each.clear for each in strong.states)
    assert strong.thinner is None
    assert "ok" in strong.rows[0][1]
    light = findings(prototype("array-2x6").with_values({"target.force": 1e-3}))
    assert not light.states[0].clear
    # the inertia halves, and a light membrane gives more air to a force than to a pressure alike
    assert light.thinner is not None
    assert light.thinner == pytest.approx(0.5, abs=0.15)
    assert "warn" in light.rows[0][1]
    assert "--motion" in light.rows[-1][1]
    assert "looks like a touch of" in worst_of_motion(light)
    content = json.loads(json.dumps(light.to_dict(), allow_nan=False))
    assert [each["state"] for each in content["states"]] == ["a waved hand", "a knock on the table"]

"""Words on how to hold an array while it is glued: heights and distances read again from the solids and the table."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

import geometry
from geometry.assembly.model import ArrayModel, array_model
from geometry.pictures import views
from studies.kit.holding import holding_words, shim_height


@pytest.fixture(scope="module")
def model() -> ArrayModel:
    return array_model("array-2x6")


def test_the_shim_is_the_height_of_the_housings_above_the_shells(model: ArrayModel) -> None:
    # The axis of the chamber is half its height above its floor, that of a port of a shell as high as the design says;
    # both floors are 1 mm thick, so the housings stand higher by the difference.
    design = model.design
    higher = design.resonator.port_axis_height - design.microphone.chamber_height / 2
    assert shim_height(model) == pytest.approx(higher, abs=0.01)
    assert f"{higher:.2f} mm under the housings" in holding_words(model)


def test_the_distance_of_neighbours_is_that_of_the_layout(model: ArrayModel) -> None:
    assert "18.5 mm apart" in holding_words(model)


def test_distances_at_bent_tubes_are_stated_apart_from_those_at_straight_ones() -> None:
    model = array_model("glove")
    places = [point.position for point in model.layout.points]
    apart = [math.dist(one, other) for one, other in pairwise(places[:6])]
    # A glove's fingers are joined at their tips, between points 3 and 4, by a bow.
    bent, straight = apart[2], apart[:2] + apart[3:]
    assert max(straight) - bent > 0.1
    words = holding_words(model)
    assert f"straight tube are {straight[0]:.4g} mm apart" in words
    assert f"bent tube are {bent:.4g} mm apart" in words
    assert [tube.label for tube in model.layout.tubes if not tube.is_straight] == [
        "tube 4 of line 1",
        "tube 4 of line 2",
    ]


def test_the_pitch_in_the_picture_is_that_of_a_straight_tube(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    written: list[str] = []
    drawn = views.draw_dimension

    def noted(plotter: Any, ends: Any, aside: Any, words: str, pixel: float) -> None:
        written.append(words)
        drawn(plotter, ends, aside, words, pixel)

    monkeypatch.setattr(views, "draw_dimension", noted)
    views.top_view("glove", tmp_path / "glove.png", (400, 300))
    assert written[-1] == "pitch 21 mm"


def test_a_base_plate_holds_the_array_itself(model: ArrayModel) -> None:
    design = geometry.prototype("array-2x6").with_values({"base.kind": "plate"})
    assert holding_words(array_model(design)) == ""

"""A design of one's own: what was asked for, in a layout that can be built, or one line that says why not."""

from __future__ import annotations

import math
from functools import partial
from pathlib import Path

import pytest
from refusals import check_messages, refused

import geometry
import studies
from geometry import Kind
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import overlaps
from studies.run.starting import PLACES

SIZES = [
    {"place": "fingertip", "points": 24, "pitch": 5.0},
    {"place": "wrist", "points": 16, "pitch": 15.0, "diameter": 50.0},
    {"place": "hand", "points": 15},
    {"points": 64, "microphones": 4},
    {"points": 13, "pitch": 11.0},
    {"points": 97, "microphones": 3},
    {"place": "fingertip", "points": 23},
]


@pytest.mark.parametrize("asked", [*({"place": place} for place in PLACES), *SIZES], ids=str)
def test_a_new_design_has_what_was_asked_for_and_can_be_built(asked, tmp_path):
    made = studies.new_design("mine", tmp_path / "mine.toml", **asked)
    design = geometry.load_design(tmp_path / "mine.toml")
    assert design == made
    usual = PLACES[asked.get("place", "flat")]
    assert design.point_count == asked.get("points", usual.points)
    assert len(design.microphones) == asked.get("microphones", usual.microphones)
    layout = lay_out(design)
    assert overlaps(design, layout) == ()
    assert not any(tube.schematic for tube in layout.tubes)
    pitch = asked.get("pitch", usual.pitch)
    first, second = layout.points[:2]
    frames = [layout.frame(point).origin for point in (first, second)]
    apart = sum((a - b) ** 2 for a, b in zip(*frames, strict=True)) ** 0.5
    if usual.layout == "cylinder":
        assert 0.9 * pitch < apart < pitch  # around it the shells lean towards each other
    else:
        assert apart == pytest.approx(pitch)


@pytest.mark.parametrize(("points", "rows"), [(7, 1), (11, 3), (12, 3), (13, 2), (64, 4), (97, 7), (997, 27)])
def test_a_number_that_fills_no_rows_leaves_the_last_one_short_in_the_plane(points, rows, tmp_path):
    made = studies.new_design("mine", tmp_path / "mine.toml", points=points)
    assert math.ceil(points / made.layout.columns) == rows
    assert -points % made.layout.columns <= 2  # places without a point


@pytest.mark.parametrize(
    ("asked", "others"),
    [
        ({"place": "wrist", "points": 37}, [{"points": 36}, {"points": 39}, {"pitch": 8}]),
        ({"place": "hand", "points": 20, "pitch": 10}, [{"pitch": 24}]),
        ({"place": "fingertip", "points": 500}, [{"points": 90}]),
    ],
    ids=str,
)
def test_what_a_refusal_names_instead_can_be_built(asked, others, tmp_path):
    with refused(Kind.CONFLICT, "points", asked["points"]) as found:
        studies.new_design("mine", tmp_path / "mine.toml", **asked)
    for number, other in enumerate(others):
        for field, value in other.items():
            assert field in found.value.remedy
            assert str(value) in "".join(found.value.remedy).split(field + " = ")[-1]
        studies.new_design("mine", tmp_path / f"{number}.toml", **asked | other)


#: What is asked for -> kind, field and value of the refusal.
REFUSED = (
    ({"place": "moon"}, Kind.UNKNOWN, "place", "moon"),
    ({"name": "../up"}, Kind.OUT_OF_RANGE, "name", "../up"),
    ({"points": 1}, Kind.OUT_OF_RANGE, "points", 1),
    ({"points": 12.5}, Kind.OUT_OF_RANGE, "points", 12.5),
    ({"pitch": 2.5}, Kind.OUT_OF_RANGE, "pitch", 2.5),
    ({"place": "fingertip", "points": 24, "microphones": 3}, Kind.CONFLICT, "points", 24),
    ({"place": "fingertip", "pitch": 100}, Kind.CONFLICT, "points", 12),
    ({"place": "wrist", "points": 37}, Kind.CONFLICT, "points", 37),
    ({"place": "wrist", "points": 1000}, Kind.CONFLICT, "points", 1000),
    ({"place": "hand", "points": 500}, Kind.CONFLICT, "points", 500),
    ({"place": "hand", "points": 2}, Kind.CONFLICT, "microphones", 3),
    ({"points": 3, "microphones": 16}, Kind.CONFLICT, "microphones", 16),
)


@pytest.mark.parametrize(("asked", "kind", "field", "value"), REFUSED, ids=str)
def test_what_cannot_be_is_refused_and_nothing_is_written(asked, kind, field, value, tmp_path):
    with refused(kind, field, value):
        studies.new_design(**{"name": "mine", "out": tmp_path / "mine.toml"} | asked)
    assert list(tmp_path.iterdir()) == []


def test_the_messages_of_designs_that_do_not_fit(tmp_path):
    out = {"name": "mine", "out": tmp_path / "mine.toml"}
    calls = {str(asked): partial(studies.new_design, **out | asked) for asked, *_ in REFUSED}
    check_messages(Path(__file__).parent / "messages.txt", calls)

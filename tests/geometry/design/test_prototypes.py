"""The prototypes carry the paper's figures, and say of every value whether it is one."""

from __future__ import annotations

import re

import pytest
from built import built

import geometry
from geometry.design.design_file import prototype_text
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import buildability_notes
from geometry.plan.wiring_graph import wiring_counts

NAMES = ["array-2x6", "fingertip-3x4", "fingertip-4x6", "glove", "large-area-64", "line-2", "line-3", "line-4"]


def test_the_prototypes_are_those_of_the_paper() -> None:
    assert geometry.prototype_names() == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_every_value_is_marked_published_or_assumed(name: str) -> None:
    values = [line for line in prototype_text(name).splitlines() if re.match(r"\s*[A-Za-z_-]+\s*=", line)]
    assert len(values) > 35
    for line in values:
        comment = line.rpartition("  # ")[2]
        assert len(re.findall(r"\b(?:published|assumed)\b", comment)) == 1, line


@pytest.mark.parametrize("name", NAMES)
def test_the_name_of_a_prototype_is_the_name_of_its_file(name: str) -> None:
    assert geometry.prototype(name).name == name


#: name: microphones, points per line, membrane, bore of the segments, their length
PUBLISHED = {
    "array-2x6": (2, [12], "silicone-shore-a-30", [0.44], [12.5]),
    "fingertip-3x4": (2, [12], "silicone-blend-5-1-shore-a-0-5", [0.18], [4.0]),
    "fingertip-4x6": (2, [24], "silicone-shore-a-5", [0.18], [4.0]),
    "glove": (3, None, "silicone-shore-a-30", [0.64], None),
    "large-area-64": (4, [16, 14, 16, 18], "silicone-shore-a-30", [0.54, 0.64], [12.0, 14.0]),
    "line-2": (2, [36], None, None, None),
    "line-3": (3, [36] * 3, None, None, None),
    "line-4": (4, [36] * 6, None, None, None),
}


@pytest.mark.parametrize("name", NAMES)
def test_a_prototype_has_the_published_figures(name: str) -> None:
    design = geometry.prototype(name)
    microphones, points, membrane, bores, lengths = PUBLISHED[name]
    tubes = sorted(
        {tube for line in design.lines for tube in design.inner_tubes_of(line)}, key=lambda tube: tube.length
    )
    assert len(design.microphones) == microphones
    assert design.microphone.model == "SPH1878LR5H-C"
    assert points is None or [line.points for line in design.lines] == points
    assert membrane is None or design.membrane.material == membrane
    assert bores is None or [tube.inner_diameter for tube in tubes] == pytest.approx(bores)
    assert lengths is None or [tube.length for tube in tubes] == lengths


def test_the_reference_array_has_the_cavity_of_the_reference_cell() -> None:
    design = geometry.prototype("array-2x6")
    assert (design.resonator.cavity_diameter, design.resonator.cavity_height) == (6.0, 2.5)
    assert design.tube.outer_diameter == 0.9
    assert design.microphone.chamber_volume == pytest.approx(5.0, rel=0.05)


def test_fingertip_tubes_are_longer_than_the_pitch_leaves() -> None:
    for name in ("fingertip-3x4", "fingertip-4x6"):
        design = geometry.prototype(name)
        assert design.layout.pitch == 4.0
        assert design.tube.length > design.layout.pitch - design.resonator.cavity_diameter
        assert design.tube.outer_diameter == 0.55
        assert design.microphone_tube.length == 12.0
        assert design.microphone_tube.outer_diameter == pytest.approx(0.8)


@pytest.mark.parametrize("count", [2, 3, 4])
def test_simulated_studies_are_fully_connected(count: int) -> None:
    design = geometry.prototype(f"line-{count}")
    counts = wiring_counts(count, [line.points for line in design.lines])
    assert counts.lines == counts.most_lines == count * (count - 1) // 2
    assert design.point_count == 36 * counts.lines
    assert design.resonator.cavity_volume == pytest.approx(150.0, rel=0.01)


def test_three_lines_are_a_ring_drawn_as_it_is_built() -> None:
    design = geometry.prototype("line-3")
    assert design.layout.kind == "ring"
    assert buildability_notes(design, lay_out(design)) == ()
    parts = built("line-3")
    # Lines are straight, so that all shells are; a chamber has one port along each of its two sides.
    assert parts.counts["microphone-housing-60"] == len(design.microphones)
    assert sum(count for part, count in parts.counts.items() if part.startswith("shell-straight")) == design.point_count

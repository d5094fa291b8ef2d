"""The drawn membranes: dimensions, draft, seat on the shell."""

import math

import cadquery as cq
import pytest

import geometry
from geometry.schema.ports import Port
from geometry.solids.membrane import build_membrane, membrane_radius
from geometry.solids.shell import build_shell

SLOPE = math.tan(math.radians(1.0))
BOSS = {"membrane.shape": "boss", "membrane.boss_diameter": 2.0, "membrane.boss_height": 0.6}
RIM = {"membrane.shape": "rim", "membrane.rim_height": 0.4}


def array(**changes):
    """The 2 x 6 array: cavity radius 3, rim 1.5, thickness 0.5, draft 1 degree."""
    return geometry.prototype("array-2x6").with_values(changes)


def frustum(lower, upper, height):
    return math.pi * height / 3 * (lower**2 + lower * upper + upper**2)


@pytest.mark.parametrize(
    ("changes", "volume", "height"),
    [
        ({}, frustum(4.5, 4.5 - 0.5 * SLOPE, 0.5), 0.5),
        ({"mold.draft": 0.0}, math.pi * 4.5**2 * 0.5, 0.5),
        ({"membrane.stretch": 1.2, "mold.draft": 0.0}, math.pi * (4.5 / 1.2) ** 2 * 0.5, 0.5),
        (BOSS, frustum(4.5, 4.5 - 0.5 * SLOPE, 0.5) + frustum(1, 1 - 0.6 * SLOPE, 0.6), 1.1),
        (RIM, frustum(4.5, 4.5 - 0.9 * SLOPE, 0.9) - frustum(3, 3 + 0.4 * SLOPE, 0.4), 0.9),
    ],
    ids=["flat", "no draft", "stretched", "boss", "rim"],
)
def test_a_membrane_has_the_volume_of_its_section(changes, volume, height):
    membrane = build_membrane(array(**changes)).val()
    assert membrane.isValid()
    assert membrane.Volume() == pytest.approx(volume, rel=1e-9)
    assert membrane.BoundingBox().zlen == pytest.approx(height, abs=1e-6)


@pytest.mark.parametrize("changes", [{}, BOSS, RIM], ids=["flat", "boss", "rim"])
def test_the_glued_face_is_flat_and_exactly_as_wide_as_the_design_says(changes):
    design = array(**changes)
    (glued,) = (face for face in build_membrane(design).val().Faces() if face.Center().z < 1e-9)
    assert glued.Area() == pytest.approx(math.pi * 4.5**2, rel=1e-9)
    assert membrane_radius(design.resonator, design.membrane) == 4.5


@pytest.mark.parametrize("changes", [{}, BOSS, RIM], ids=["flat", "boss", "rim"])
def test_the_membrane_sits_on_the_rim_inside_the_ledge(changes):
    design = array(**changes)
    ports = [Port(angle, design.tube.inner_diameter, design.tube.outer_diameter) for angle in (0.0, 180.0)]
    shell = build_shell(design.resonator, design.membrane, design.printing, ports).val()
    top = design.resonator.cavity_height
    seated = build_membrane(design).val().moved(cq.Location(cq.Vector(0, 0, top)))
    assert shell.intersect(seated).Volume() < 1e-9
    assert shell.distance(seated) < 1e-9
    # Moved down by a hair it meets exactly the annulus of the rim.
    pressed = seated.moved(cq.Location(cq.Vector(0, 0, -1e-4)))
    assert shell.intersect(pressed).Volume() == pytest.approx(1e-4 * math.pi * (4.5**2 - 3**2), rel=1e-5)

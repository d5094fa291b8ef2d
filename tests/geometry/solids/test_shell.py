"""Shells: ports, glue groove, feet, numbers, and carriers that join them."""

import math
from functools import partial
from pathlib import Path

import cadquery as cq
import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, given, settings, strategies as st
from refusals import check_messages, refused
from thorough import many

import geometry
from geometry import Kind, Refusal
from geometry.assembly.part_list import build_parts, part_counts
from geometry.schema.cavity_shapes import web
from geometry.schema.field_errors import DesignError
from geometry.schema.manufacture import Printing
from geometry.schema.part_fields import Membrane, Resonator, Shell
from geometry.schema.ports import Port, largest_gap
from geometry.solids.carrier import array_carrier, build_carrier, carrier_places
from geometry.solids.measure import hole_diameters, tessellate
from geometry.solids.round_solids import cylinder, one_solid
from geometry.solids.shell import build_shell

RESONATOR = Resonator(cavity_diameter=6, cavity_height=2.5, wall_thickness=2)
MEMBRANE = Membrane(material="silicone-shore-a-30", thickness=0.5, rim_width=1.5)
PRINTING = Printing(port_lip=0.5)
STRAIGHT = (Port(0.0, 0.44, 0.9), Port(180.0, 0.44, 0.9))


def shell(features=None, label=None, ports=STRAIGHT, resonator=RESONATOR):
    return build_shell(resonator, MEMBRANE, PRINTING, ports, features, label).val()


def inside(solid, radius, angle, height):
    turn = math.radians(angle)
    return solid.isInside(cq.Vector(radius * math.cos(turn), radius * math.sin(turn), height), 1e-6)


def facets(solid):
    surface = tessellate(solid, 0.01)
    return trimesh.Trimesh(surface.vertices, surface.triangles, process=False)


@settings(max_examples=60, deadline=None)
@given(
    starts=st.tuples(st.floats(1, 3), st.floats(1, 3)),
    radii=st.tuples(st.floats(0.1, 0.6), st.floats(0.1, 0.6)),
    turn=st.floats(5, 110),
)
def test_the_wall_between_two_holes_is_that_of_the_kernel(starts, radii, turn):
    along = cq.Vector(math.cos(math.radians(turn)), math.sin(math.radians(turn)), 0)
    first = cq.Solid.makeCylinder(radii[0], 40, cq.Vector(starts[0], 0, 0), cq.Vector(1, 0, 0))
    second = cq.Solid.makeCylinder(radii[1], 40, along * starts[1], along)
    found = web((starts[0], radii[0]), (starts[1], radii[1]), turn)
    assert max(found, 0) == pytest.approx(first.distance(second), abs=1e-6)


# -- ports ------------------------------------------------------------------------------------------
@pytest.mark.slow
@pytest.mark.parametrize("count", range(1, 7))
def test_one_to_six_ports_open_the_cavity_and_nothing_else(count):
    ports = [Port(360 / count * k, 0.44, 0.9) for k in range(count)]
    mesh = facets(shell(ports=ports))
    assert mesh.is_volume
    # A cup is a ball; every port is a handle more.
    assert mesh.euler_number == 2 - 2 * count


def test_a_port_lies_at_its_own_height():
    deep = Resonator(cavity_diameter=6, cavity_height=5, wall_thickness=2)
    solid = shell(ports=(Port(0.0, 0.44, 0.9, 1.0), Port(0.0, 0.44, 0.9, 3.8), Port(90.0, 0.44, 0.9)), resonator=deep)
    for angle, height in ((0, 1.0), (0, 3.8), (90, 2.5)):
        for radius, free in ((3.1, 0.22), (4.5, 0.5)):
            assert not inside(solid, radius, angle, height)
            assert not inside(solid, radius, angle, height + 0.95 * free)
            assert inside(solid, radius, angle, height + 1.1 * free)
    assert inside(solid, 3.1, 0, 2.5)


def test_the_counterbore_is_the_tube_with_a_glue_gap_on_either_side():
    holes = hole_diameters(shell())
    assert pytest.approx(0.9 + 2 * PRINTING.glue_gap) in holes
    assert pytest.approx(0.44) in holes


PORTS = [
    ((), Kind.OUT_OF_RANGE, "ports"),
    ([Port(50.0 * k, 0.3, 0.6) for k in range(7)], Kind.OUT_OF_RANGE, "ports"),
    ((Port(0.0, 0.44, 0.9, 2.3),), Kind.CONFLICT, "ports.0.height"),
    ((Port(0.0, 0.44, 0.9), Port(10.0, 0.44, 0.9)), Kind.CONFLICT, "ports"),
    ((Port(0.0, 0.44, 0.9), Port(17.0, 0.44, 0.9)), Kind.CONFLICT, "ports"),
    ((Port(30.0, 0.9, 0.44),), Kind.CONFLICT, "ports.0.bore_diameter"),
]


@pytest.mark.parametrize(("ports", "kind", "field"), PORTS)
def test_ports_without_room_are_refused(ports, kind, field):
    with refused(kind, field):
        shell(ports=ports)


def test_a_port_on_the_flat_part_of_a_bowl_or_in_a_collar_is_refused():
    bowl = RESONATOR.model_copy(update={"shape": "dome", "dome_depth": 2.0})
    with refused(Kind.CONFLICT, "ports.0.height", 0.5):
        shell(ports=(Port(0.0, 0.44, 0.9, 0.5),), resonator=bowl)
    box = RESONATOR.model_copy(update={"shape": "box", "collar_height": 1.0})
    with refused(Kind.CONFLICT, "ports.0.height", 1.25):
        shell(resonator=box)


# -- glue groove, feet, numbers ---------------------------------------------------------------------
def test_the_glue_groove_takes_a_ring_out_of_the_seat():
    plain, grooved = shell(), shell(Shell(groove_width=0.5, groove_depth=0.3))
    removed = plain.cut(grooved)
    assert removed.Volume(1e-8) == pytest.approx(0.3 * math.pi * (4.0**2 - 3.5**2), rel=1e-6)
    assert grooved.cut(plain).Volume() < 1e-9
    assert removed.BoundingBox().zmax == pytest.approx(2.5, abs=1e-6)


def test_feet_stand_between_the_tubes_with_a_hole_each_and_leave_the_air_alone():
    features = Shell(feet=2, foot_length=4.0, foot_hole=1.6)
    plain, footed = shell(), shell(features)
    feet = footed.cut(plain).Solids()
    assert len(feet) == 2
    for foot, side in zip(sorted(feet, key=lambda f: f.Center().y), (-1, 1), strict=True):
        box = foot.BoundingBox()
        assert (box.zmin, box.zmax) == pytest.approx((-1, 0), abs=1e-6)
        assert max(box.ymax, -box.ymin) == pytest.approx(5 + 4, abs=1e-6)
        assert side * foot.Center().y > 5
    assert plain.cut(footed).Volume() < 1e-9
    assert pytest.approx(1.6) in hole_diameters(footed)
    for angle in (90, 270):
        assert not inside(footed, 9 - 1.8, angle, -0.5)
        assert inside(footed, 9 - 0.5, angle, -0.5)


@pytest.mark.parametrize(
    ("angles", "gap"),
    [
        ((0, 180), (90, 180)),
        ((0, 90), (225, 270)),
        ((350, 20), (185, 330)),
        ((40,), (220, 360)),
        ((0, 120, 240), (60, 120)),
    ],
)
def test_the_widest_gap_between_directions(angles, gap):
    assert largest_gap(angles) == pytest.approx(gap)


@pytest.mark.parametrize("kind", ["raised", "engraved"])
def test_a_number_is_read_from_outside_left_to_right_and_keeps_off_the_seat(kind):
    plain, marked = shell(), shell(Shell(label=kind, label_height=2.0), "17")
    added, removed = marked.cut(plain), plain.cut(marked)
    digits = added if kind == "raised" else removed
    assert (removed if kind == "raised" else added).Volume() < 1e-9
    # 1 is two strokes, 7 three, joined: two digits, the first of them to the left of who looks at the wall from +y.
    pieces = sorted(digits.Solids(), key=lambda piece: -piece.Center().x)
    assert len(pieces) == 2
    assert pieces[0].Volume() < 0.75 * pieces[1].Volume()
    box = digits.BoundingBox()
    assert box.ymin > 4
    assert box.zmax - box.zmin == pytest.approx(2.0, abs=1e-6)
    assert box.zmin > 0  # above the floor, where a carrier has its webs
    assert box.zmax < 2.5
    radius = 5.1 if kind == "raised" else 4.9
    width = 2.0 * 0.55
    # The upper bar of the 7, none below.
    middle = 90 + math.degrees(math.asin((width / 2 + 0.2) / radius))
    centre = 2.75 / 2
    for height, drawn in ((centre + 0.9, True), (centre - 0.9, False)):
        assert inside(marked, radius, middle, height) is (drawn if kind == "raised" else not drawn)


def test_a_number_stands_above_a_foot():
    small = Resonator(cavity_diameter=2, cavity_height=2, wall_thickness=1)
    membrane = Membrane(material="x", thickness=0.3, rim_width=1.0)
    marked = Shell(feet=1, foot_length=3.0, foot_hole=1.0, label="engraved")
    solids = [
        build_shell(small, membrane, Printing(port_lip=0.15), [Port(0.0, 0.2, 0.5)], features, "0").val()
        for features in (marked, marked.model_copy(update={"label": "none"}))
    ]
    assert facets(solids[0]).is_volume
    assert solids[1].cut(solids[0]).BoundingBox().zmin > 0


def test_numbers_need_no_font(monkeypatch):
    monkeypatch.setattr(cq.Compound, "makeText", None)
    assert shell(Shell(label="raised"), "0123").isValid()


@pytest.mark.parametrize("label", ["", "12a", "-1", "12345", "²"])
def test_labels_that_are_no_number_are_refused(label):
    with refused(Kind.WRONG_TYPE, "label", label):
        shell(Shell(label="raised"), label)


def test_digits_that_do_not_fit_are_refused():
    with refused(Kind.CONFLICT, "shell.label_height", 5.0):
        shell(Shell(label="raised", label_height=5.0), "8")
    six = tuple(Port(60.0 * k, 0.44, 0.9) for k in range(6))
    small = Resonator(cavity_diameter=2.4, cavity_height=2.5, wall_thickness=0.9)
    membrane = Membrane(material="x", thickness=0.3, rim_width=0.5)
    with refused(Kind.CONFLICT, "shell.label_height"):
        build_shell(small, membrane, PRINTING, six, Shell(label="raised"), "2345")


BOX = {"resonator.shape": "box"}
IMPOSSIBLE = [
    ({"resonator.box_length": 3.0}, "resonator.box_length"),
    ({**BOX, "resonator.box_length": 5.5}, "resonator.box_length"),
    ({**BOX, "resonator.corner_radius": 2.6}, "resonator.corner_radius"),
    ({**BOX, "resonator.collar_height": 2.2}, "resonator.collar_height"),
    ({**BOX, "resonator.collar_height": 1.0}, "resonator.port_height"),
    ({"resonator.shape": "dome", "resonator.dome_depth": 2.6}, "resonator.dome_depth"),
    ({"shell.groove_width": 1.3}, "shell.groove_width"),
    ({"shell.groove_width": 0.4, "shell.groove_depth": 0.8}, "shell.groove_depth"),
    ({"shell.feet": 2, "shell.foot_length": 2.0}, "shell.foot_length"),
    ({"shell.feet": 2, "shell.foot_length": 5.0}, "shell.foot_length"),
    ({"shell.label": "raised"}, "shell.label"),
    ({"printing.carrier": "row", "shell.feet": 2}, "printing.carrier"),
    ({"printing.carrier": "row", "printing.carrier_neck": 1.5}, "printing.carrier_neck"),
    ({"microphone.sound_hole_diameter": 1.5, "microphone.package_width": 1.2}, "microphone.sound_hole_diameter"),
    ({"microphone.board_length": 3.0}, "microphone.board_length"),
    ({"microphone.gasket_width": 0.8, "microphone.board_width": 5.0}, "microphone.board_width"),
    ({"microphone.gasket_width": 0.8, "microphone.gasket_depth": 0.5}, "microphone.gasket_depth"),
]


@pytest.mark.parametrize(("values", "field"), IMPOSSIBLE)
def test_designs_whose_shells_or_housings_cannot_be_built_are_refused_by_name(values, field):
    with refused(Kind.CONFLICT, field, error=DesignError):
        geometry.prototype("array-2x6").with_values(values)


def test_messages():
    design = geometry.prototype("array-2x6")
    cases = {str(values): partial(design.with_values, values) for values, _ in IMPOSSIBLE}
    cases |= {f"ports {k + 1}": partial(shell, ports=ports) for k, (ports, *_) in enumerate(PORTS)}
    halves = cq.Solid.makeBox(3, 1, 1).cut(cq.Solid.makeBox(1, 1, 1, cq.Vector(1, 0, 0)))
    cases |= {
        "a label": partial(shell, Shell(label="raised"), "12345"),
        "a high label": partial(shell, Shell(label="raised", label_height=5.0), "8"),
        "no shells": partial(build_carrier, RESONATOR, carrier_printing("row"), []),
        "two pieces": partial(one_solid, halves, "shell"),
    }
    check_messages(Path(__file__).with_name("messages.txt"), cases)


# -- carriers ---------------------------------------------------------------------------------------
def carrier_printing(kind, **values):
    return Printing(port_lip=0.5, carrier=kind, **values)


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "links"), [("row", 4), ("sheet", 5)])
def test_a_carrier_is_one_watertight_piece_open_at_the_top(kind, links):
    one = cq.Workplane(shell())
    carrier = build_carrier(RESONATOR, carrier_printing(kind), [one] * 5)
    mesh = facets(carrier.part.val())
    assert mesh.is_volume
    assert carrier.necks == 2 * links
    # Two ports per shell; every link that closes a loop of a sheet is one hole more.
    assert mesh.euler_number == 2 - 2 * (2 * 5 + links - 4)
    for x, y in carrier.places:
        above = cylinder(3.0, 0.0, 10.0, (x, y))
        assert carrier.part.val().intersect(above).Volume() < 1e-9


def test_only_the_necks_join_a_shell_to_the_webs():
    printing = carrier_printing("row", carrier_neck=0.6)
    carrier = build_carrier(RESONATOR, printing, [cq.Workplane(shell())] * 2)
    (x, _), gap = carrier.places[1], printing.carrier_gap
    assert x == pytest.approx(2 * 5 + gap)
    solid = carrier.part.val()
    slice_of = cq.Solid.makeBox(0.2, 20, 20, cq.Vector(5 + 0.2, -10, -10))
    assert solid.intersect(slice_of).Volume() == pytest.approx(0.2 * 0.6**2, rel=1e-6)
    # Snapped at the necks, shells and web fall apart.
    cuts = [cq.Solid.makeBox(0.3, 20, 20, cq.Vector(at, -10, -10)) for at in (5.1, 5 + gap - 0.4)]
    pieces = sorted(solid.cut(*cuts).Solids(), key=lambda piece: piece.Center().x)
    assert len(pieces) == 3
    stump = pieces[0].cut(shell()).Volume()
    assert 0 <= stump < 0.6**2 * 0.15


def test_a_sheet_is_about_as_many_rows_as_columns():
    assert carrier_places(5, "sheet", 10.0) == ((0, 0), (10, 0), (20, 0), (0, -10), (10, -10))
    assert carrier_places(3, "row", 10.0) == ((0, 0), (10, 0), (20, 0))


def test_the_shells_of_a_carrier_carry_the_numbers_of_their_points():
    design = geometry.prototype("fingertip-3x4").with_values(
        {"printing.carrier": "row", "shell.label": "engraved", "shell.label_relief": 0.1}
    )
    ports = [Port(0.0, 0.18, 0.55), Port(180.0, 0.18, 0.55)]
    numbered = array_carrier(design, [ports] * 3)
    bare = array_carrier(design.with_values({"shell.label": "none"}), [ports] * 3)
    cut = bare.part.val().cut(numbered.part.val())
    sizes = [
        sum(piece.Volume() for piece in cut.Solids() if abs(piece.Center().x - x) < 1.5) for x, _ in numbered.places
    ]
    # 1 has two strokes, 2 and 3 have five.
    assert sizes[0] < 0.6 * sizes[1]
    assert sizes[1] == pytest.approx(sizes[2], rel=0.1)


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["raised", "engraved"])
@pytest.mark.parametrize("carrier", ["row", "sheet"])
def test_the_numbers_in_a_carrier_keep_clear_of_its_webs_and_necks(kind, carrier):
    """Also where they stand at 90 degrees, above the web to the next row."""
    design = geometry.prototype("array-2x6").with_values({"printing.carrier": carrier, "shell.label": kind})
    ports = [Port(0.0, 0.44, 0.9), Port(180.0, 0.44, 0.9)]
    numbered = array_carrier(design, [ports] * 4)
    bare = array_carrier(design.with_values({"shell.label": "none"}), [ports] * 4)
    first, second = (numbered, bare) if kind == "raised" else (bare, numbered)
    digits = first.part.val().cut(second.part.val())
    outer = design.resonator.outer_diameter / 2
    shells = [cylinder(outer, -5.0, 5.0, place) for place in bare.places]
    links = bare.part.val().cut(*shells)
    assert digits.Volume() > 4 * 0.02
    # The shell itself is 0.6 mm from its web; digits of 0.2 mm stand above it.
    assert digits.distance(links) > 0.45


def test_an_array_with_a_carrier_has_it_among_its_parts():
    design = geometry.prototype("array-2x6").with_values({"printing.carrier": "sheet"})
    parts = build_parts(design)
    assert part_counts(design)["carrier"] == parts.counts["carrier"] == 1
    assert parts.parameters["carrier"]["shells"] == 12
    single = part_counts(design.with_values({"printing.carrier": "none"}))
    shells = sum(parts[name].val().Volume() * single[name] for name in parts if name.startswith("shell"))
    webs = parts["carrier"].val().Volume() - shells
    # Of 17 links each: a web of 2.8 x 1.5 x 1 mm and two necks of 0.6 x 0.5 x 0.5 mm.
    assert webs == pytest.approx(17 * (2.8 * 1.5 + 2 * 0.6 * 0.25), rel=0.01)


def test_carriers_that_cannot_be_made_are_refused():
    one = cq.Workplane(shell())
    with refused(Kind.CONFLICT, "printing.carrier", "none"):
        build_carrier(RESONATOR, PRINTING, [one])
    with refused(Kind.MISSING, "shells"):
        build_carrier(RESONATOR, carrier_printing("row"), [])
    with refused(Kind.CONFLICT, "printing.carrier_neck", 2.0):
        build_carrier(RESONATOR, carrier_printing("row", carrier_neck=2.0), [one])
    footed = cq.Workplane(shell(Shell(feet=2, foot_hole=1.6)))
    with refused(Kind.CONFLICT, "shells.0"):
        build_carrier(RESONATOR, carrier_printing("row"), [footed])


# -- random shells ----------------------------------------------------------------------------------
features = st.fixed_dictionaries(
    {
        "groove_width": st.none() | st.floats(0.2, 1.0),
        "feet": st.integers(0, 4),
        "foot_length": st.floats(2.5, 8.0),
        "foot_hole": st.floats(0.5, 2.5),
        "label": st.sampled_from(["none", "raised", "engraved"]),
    }
)
sizes = st.fixed_dictionaries(
    {
        "cavity_diameter": st.floats(1.2, 12.0),
        "cavity_height": st.floats(1.2, 8.0),
        "wall_thickness": st.floats(0.6, 3.0),
        "floor_thickness": st.floats(0.4, 2.0),
        "shape": st.sampled_from(["cylinder", "box", "dome"]),
    }
)


def build_random(size, extra, rim, count, label):
    resonator = Resonator(**size)
    membrane = Membrane(material="x", thickness=0.3, rim_width=max(0.2, rim * size["wall_thickness"]))
    ports = [Port(360.0 * k / count, 0.2, 0.5) for k in range(count)]
    try:
        solid = build_shell(resonator, membrane, Printing(port_lip=0.15), ports, Shell(**extra), str(label)).val()
    except Refusal as error:
        if error.kind is Kind.NO_RESULT:
            raise
        return False
    mesh = facets(solid)
    assert mesh.is_volume
    assert mesh.euler_number == 2 - 2 * count - 2 * extra["feet"]
    assert mesh.volume == pytest.approx(solid.Volume(), rel=5e-3)
    return True


def test_engraved_digits_of_a_small_shell_do_not_break_into_its_sockets():
    size = {"cavity_diameter": 1.25, "cavity_height": 2.0, "wall_thickness": 0.625, "floor_thickness": 1.0}
    extra = {"groove_width": None, "feet": 0, "foot_length": 3.0, "foot_hole": 1.0, "label": "engraved"}
    for label in (1, 10):
        build_random({**size, "shape": "cylinder"}, extra, 1.0, 3, label)


@pytest.mark.slow
def test_random_shells_are_watertight_or_refused_by_name():
    built, examples = [], many(30)

    @settings(max_examples=examples, derandomize=True, deadline=None, suppress_health_check=list(HealthCheck))
    @given(sizes, features, st.floats(0.1, 1.0), st.integers(1, 4), st.integers(0, 250))
    def build(size, extra, rim, count, label):
        built.append(build_random(size, extra, rim, count, label))

    build()
    assert np.mean(built) > 0.2

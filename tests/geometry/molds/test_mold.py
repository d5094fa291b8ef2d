"""Molds: they enclose exactly the membrane, open without interference, and have what casting needs."""

import dataclasses
import math

import cadquery as cq
import pytest
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.GeomAbs import GeomAbs_Cone, GeomAbs_Cylinder
from refusals import refused

import geometry
from geometry import Kind
from geometry.molds.mold import build_mold, mold_counts
from geometry.molds.mold_parts import base_block, mark, mark_text
from geometry.molds.mold_plan import CORNER, plan_mold
from geometry.solids.measure import hole_diameters
from geometry.solids.membrane import build_membrane
from geometry.solids.round_solids import cylinder, revolved

PHYSICAL = ["array-2x6", "fingertip-3x4", "fingertip-4x6", "glove", "large-area-64"]
ONE = {"mold.rows": 1, "mold.columns": 1}
TRAY = {"mold.rows": 2, "mold.columns": 3}
BOSS = {"membrane.shape": "boss", "membrane.boss_diameter": 1.0, "membrane.boss_height": 0.6}
RIM = {"membrane.shape": "rim", "membrane.rim_height": 0.4}
VARIANTS = [BOSS, RIM, {**TRAY, "mold.sockets": "blind", "mold.draft": 5.0}, {"mold.draft": 0.0}]


def moved(part, x=0.0, y=0.0, z=0.0):
    return part.val().moved(cq.Location(cq.Vector(x, y, z)))


def overlap(first, second):
    return first.intersect(second).Volume()


def voids(*shapes):
    """Volume that shapes leave free in the box around them."""
    box = cq.Compound.makeCompound(list(shapes)).BoundingBox()
    block = cq.Solid.makeBox(box.xlen, box.ylen, box.zlen, cq.Vector(box.xmin, box.ymin, box.zmin))
    return block.cut(*shapes).Solids(), box


@pytest.fixture(scope="module")
def molds():
    """Molds and membranes by prototype and variant, drawn once, without the mark below: it only costs time here.

    They have one cavity unless the variant says otherwise.
    """
    made = {}

    def get(name, **changes):
        design = geometry.prototype(name).with_values({**ONE, **changes})
        key = design.membrane, design.mold, design.resonator.cavity_diameter
        if key not in made:
            mold = build_mold(design)
            marked = "mold-plugs" if "mold-plugs" in mold.parts else "mold-base"
            solid, (x, y) = mold.parts[marked].val(), mold.plan.half
            above = cq.Solid.makeBox(2 * x, 2 * y, 50.0, cq.Vector(-x, -y, solid.BoundingBox().zmin + 0.3))
            parts = {**mold.parts, marked: cq.Workplane(solid.intersect(above).Solids()[0])}
            made[key] = design, dataclasses.replace(mold, parts=parts), build_membrane(design)
        return made[key]

    return get


CASES = [(name, {}) for name in PHYSICAL]
CASES += [("array-2x6", variant) for variant in VARIANTS]


@pytest.mark.slow
@pytest.mark.parametrize(("name", "changes"), CASES)
def test_the_cavity_of_the_closed_mold_is_the_compensated_membrane(name, changes, molds):
    design, mold, membrane = molds(name, **changes)
    base, lid, plugs = (mold.parts[f"mold-{name}"].val() for name in ("base", "lid", "plugs"))
    assert overlap(base, lid) < 1e-9
    assert overlap(base, plugs) < 1e-9
    left, box = voids(base, lid, plugs)
    casts = [cast.val() for cast in mold.cast(membrane)]
    assert len(casts) == design.mold.rows * design.mold.columns
    # A plug stands in its hole with a gap all round; below, the hole is wider.
    pin = mold.plan.ejector
    wide = pin.hole + 0.3
    cone = math.pi / 3 * 0.3 * (wide**2 + wide * pin.hole + pin.hole**2) - math.pi * pin.hole**2 * 0.3
    sleeve = math.pi * (pin.hole**2 - pin.radius**2) * (pin.top - mold.plan.bottom) + cone
    cavities = []
    for cast in casts:
        # Compensated: larger than the membrane by the shrinkage of the silicone, 0.1 %, in every direction.
        assert cast.Volume() == pytest.approx(membrane.val().Volume() / (1 - 0.001) ** 3, rel=1e-9)
        (cavity,) = (void for void in left if overlap(void, cast) > 0.5 * cast.Volume())
        assert cast.cut(cavity).Volume() < 1e-3 * cast.Volume()
        assert cavity.cut(cast).Volume() == pytest.approx(len(pin.spots) * sleeve, abs=1e-3 * cast.Volume())
        cavities.append(cavity)
    # Whatever else is hollow - gap, grooves, vents, sockets, mark - has a way out.
    for void in left:
        if not any(void is cavity for cavity in cavities):
            outer = void.BoundingBox()
            sides = [
                abs(getattr(outer, side) - getattr(box, side))
                for side in ("xmin", "xmax", "ymin", "ymax", "zmin", "zmax")
            ]
            assert min(sides) < 1e-6 or "blind" in changes.values()


@pytest.mark.parametrize(("name", "changes"), CASES)
def test_the_halves_and_the_membranes_come_apart_along_the_axis(name, changes, molds):
    _, mold, membrane = molds(name, **changes)
    base, lid = mold.parts["mold-base"].val(), mold.parts["mold-lid"]
    casts = mold.cast(membrane)[:1]
    for opening in (0.01, 1.0):
        assert overlap(moved(lid, z=opening), base) < 1e-9
        for cast in casts:
            assert overlap(moved(cast, z=opening), base) < 1e-9
    # Sideways the pins hold: not even their clearance and a little more.
    aside = mold.plan.mold.pin_clearance + 0.05
    assert overlap(moved(lid, x=aside), base) > 1e-4
    assert overlap(moved(lid, x=mold.plan.mold.pin_clearance - 0.01), base) < 1e-9


@pytest.mark.parametrize("upside_down", [False, True])
@pytest.mark.parametrize("turn", [0, 90, 180, 270])
def test_the_lid_fits_in_one_way_only(turn, upside_down, molds):
    _, mold, _ = molds("array-2x6")
    base, lid = mold.parts["mold-base"].val(), mold.parts["mold-lid"]
    if upside_down:
        height = lid.val().BoundingBox().zmax
        lid = lid.rotate((0, 0, 0), (1, 0, 0), 180).translate((0, 0, height))
    lid = lid.rotate((0, 0, 0), (0, 0, 1), turn).val()
    fits = turn == 0 and not upside_down
    assert overlap(base, lid) < 1e-9 if fits else overlap(base, lid) > 1


@pytest.mark.parametrize("changes", [{}, TRAY], ids=["one", "tray"])
def test_the_halves_touch_on_the_lands_only(changes, molds):
    design, mold, _ = molds("array-2x6", **changes)
    base, lid = mold.parts["mold-base"].val(), mold.parts["mold-lid"]
    depth = 1e-3
    pressed = overlap(moved(lid, z=-depth), base) / depth
    inner = 4.5 * design.mold.scale
    ring = math.pi * ((inner + 0.6) ** 2 - inner**2)
    assert pressed == pytest.approx(len(mold.plan.centres) * ring, rel=1e-3)


@pytest.mark.parametrize("draft", [0.0, 1.0, 5.0])
def test_the_walls_of_cavity_land_and_groove_have_the_draft(draft, molds):
    _, mold, _ = molds("array-2x6", **{"mold.draft": draft})
    leaning, upright = [], []
    for face in mold.parts["mold-base"].val().Faces():
        surface, box = BRepAdaptor_Surface(face.wrapped), face.BoundingBox()
        if box.xlen < 8 or box.zlen > 2 or surface.GetType() not in (GeomAbs_Cone, GeomAbs_Cylinder):
            continue  # the mark, the pins, flat faces
        if surface.GetType() == GeomAbs_Cone:
            leaning.append(abs(math.degrees(surface.Cone().SemiAngle())))
        else:
            upright.append(face)
    walls = upright if draft == 0 else leaning
    assert len(walls) in (3, 4)  # cavity, groove outside, and land with groove inside in one or two faces
    assert len(upright if draft else leaning) == 0
    assert leaning == pytest.approx([draft] * len(leaning), rel=1e-6)


@pytest.mark.parametrize("changes", [{}, BOSS, RIM], ids=["flat", "boss", "rim"])
def test_with_draft_a_membrane_that_is_lifted_leaves_every_wall_at_once(changes, molds):
    lift = 0.1
    for draft in (0.0, 1.0):
        _, mold, membrane = molds("array-2x6", **changes, **({"mold.draft": 0.0} if draft == 0 else {}))
        gap = moved(mold.cast(membrane)[0], z=lift).distance(mold.parts["mold-base"].val())
        assert gap == pytest.approx(lift * math.sin(math.radians(draft)), rel=1e-4, abs=1e-9)


@pytest.mark.parametrize("changes", [{}, TRAY], ids=["one", "tray"])
def test_every_groove_has_two_vents_through_the_lid(changes, molds):
    _, mold, _ = molds("array-2x6", **changes)
    base, lid = mold.parts["mold-base"].val(), mold.parts["mold-lid"].val()
    holes = hole_diameters(lid)
    cavities = len(mold.plan.centres)
    assert holes == pytest.approx([1.0] * 2 * cavities + [2.7] * 3)
    # A probe goes down each vent from above the lid to the floor of the groove and meets nothing.
    middle = sum(mold.plan.groove) / 2
    for x, y in mold.plan.centres:
        for side in (-1, 1):
            probe = cylinder(0.45, mold.plan.groove_bottom + 1e-6, 20.0, (x + side * middle, y))
            assert overlap(probe, lid) < 1e-9
            assert overlap(probe, base) < 1e-9
            deeper = cylinder(0.45, mold.plan.groove_bottom - 0.1, 20.0, (x + side * middle, y))
            assert overlap(deeper, base) > 0.05


@pytest.mark.parametrize("sockets", ["through", "blind"])
def test_pins_fit_their_sockets_with_the_clearance(sockets, molds):
    _, mold, _ = molds("array-2x6", **{"mold.sockets": sockets, "mold.pin_clearance": 0.15})
    base, lid = mold.parts["mold-base"].val(), mold.parts["mold-lid"].val()
    pins = [face for face in base.Faces() if face.geomType() == "CYLINDER" and face.BoundingBox().zmax > 1]
    assert len(pins) == 3
    for (x, y), pin in zip(
        sorted(mold.plan.pins), sorted(pins, key=lambda f: tuple(f.Center().toTuple()[:2])), strict=True
    ):
        assert pin.Center().toTuple()[:2] == pytest.approx((x, y), abs=1e-6)
        assert pin.BoundingBox().xlen == pytest.approx(2.5, abs=1e-4)
        slice_ = pin.BoundingBox()
        around = cylinder(2.5 / 2 + 0.3, slice_.zmax - 0.6, slice_.zmax - 0.5, (x, y))
        assert around.cut(base, lid).Volume() == pytest.approx(math.pi * ((1.25 + 0.15) ** 2 - 1.25**2) * 0.1, rel=1e-6)
        assert lid.BoundingBox().zmax - base.BoundingBox().zmax == pytest.approx(0.5 if sockets == "through" else 1.3)
    (top,) = (face for face in lid.Faces() if face.Center().z > lid.BoundingBox().zmax - 1e-6)
    assert len(top.innerWires()) == 2 + (3 if sockets == "through" else 0)  # vents, and sockets where they go through


def test_shims_raise_the_lid_step_by_step(molds):
    _, mold, _ = molds("array-2x6", **{"mold.shim_step": 0.05, "mold.shim_count": 3})
    base, lid = mold.parts["mold-base"].val(), mold.parts["mold-lid"]
    shims = {f"mold-shim-{step}": 3 for step in (1, 2, 3)}
    assert mold.counts == {"mold-base": 1, "mold-lid": 1, **shims, "mold-plugs": 1}
    for step in (1, 2, 3):
        shims = [moved(mold.parts[f"mold-shim-{step}"], x, y, mold.plan.gap) for x, y in mold.plan.pins]
        raised = moved(lid, z=0.05 * step)
        for shim in shims:
            assert overlap(shim, base) < 1e-9
            assert overlap(shim, raised) < 1e-9
            assert shim.distance(raised) < 1e-9
            assert overlap(shim.moved(cq.Location(cq.Vector(0, 0, -1e-3))), base) > 1e-3
        # Held there, the lid is that much above the lands, and the pins are still deep in their sockets.
        land = cylinder(mold.plan.land[1], -0.01, 0.0)
        assert raised.distance(land) == pytest.approx(0.05 * step)
        assert base.BoundingBox().zmax - 0.05 * step > 2


@pytest.mark.slow
@pytest.mark.parametrize("pin", [1.0, 2.5])
def test_a_shim_has_as_many_notches_as_steps(pin, molds):
    _, mold, _ = molds("array-2x6", **{"mold.shim_count": 10, "mold.pin_diameter": pin})
    for step in range(1, 11):
        shim = mold.parts[f"mold-shim-{step}"].val()
        outer, height = shim.BoundingBox().xmax, shim.BoundingBox().zmax
        rim = cylinder(outer - 0.1, 0, height).cut(cylinder(outer - 0.3, 0, height))
        assert len(rim.cut(shim).Solids()) == step


@pytest.mark.parametrize(("changes", "thicker"), [({}, 0.0), ({"mold.silicone_shrinkage": 0.01}, 0.01)])
def test_shrinkage_of_silicone_and_resin_is_compensated(changes, thicker, molds):
    """Prints shrink by the resin's fraction, casts in them by the silicone's: the design's size results."""
    design, mold, membrane = molds("array-2x6", **{"mold.resin_shrinkage": 0.02, **changes})
    cast = mold.cast(membrane)[0].val()
    left = cast.scale((1 - 0.02) * (1 - (thicker or 0.001)))
    assert left.Volume() == pytest.approx(membrane.val().Volume(), rel=1e-9)
    assert left.BoundingBox().zlen == pytest.approx(design.membrane.thickness, rel=1e-4)


@pytest.mark.slow
@pytest.mark.parametrize("changes", [{}, TRAY, RIM], ids=["one", "tray", "rim"])
def test_the_scraper_rides_on_the_lands_of_an_open_mold(changes, molds):
    design, mold, membrane = molds(
        "fingertip-3x4" if changes is TRAY else "array-2x6", **{"mold.kind": "open-face"}, **changes
    )
    assert set(mold.parts) == set(mold_counts(design)) == {"mold-base", "mold-scraper", "mold-plugs"}
    base, scraper = mold.parts["mold-base"].val(), mold.parts["mold-scraper"]
    assert base.BoundingBox().zmax == pytest.approx(0, abs=1e-6)
    casts = [cast.val() for cast in mold.cast(membrane)]
    half = mold.plan.half[0]
    for x in (-0.4 * half, half):
        blade = moved(scraper, x=x)
        assert overlap(blade, base) < 1e-9
        assert all(overlap(blade, cast) < 1e-9 for cast in casts)
        assert overlap(moved(scraper, x=x, z=-0.01), base) > 1e-4
        assert overlap(moved(scraper, x=x, y=0.15), base) > 1e-3
    # What is filled to the height of the lands is the membrane.
    for cast in casts:
        assert overlap(cast, base) < 1e-9
        assert overlap(cast.scale(1.001).moved(cq.Location(cq.Vector(0, 0, -1e-3))), base) > 0


def engraved(part, plan):
    """The volume cut out of the lowest 0.3 mm, without the corner that a mold lacks."""
    x, y = plan.half
    low = part.BoundingBox().zmin
    lowest = cq.Solid.makeBox(2 * x, 2 * y, 0.3, cq.Vector(-x, -y, low)).cut(part)
    return cq.Compound.makeCompound([cut for cut in lowest.Solids() if cut.BoundingBox().xmax < x - 1e-6])


@pytest.mark.slow
def test_the_mark_tells_thickness_and_material_and_is_engraved_below():
    design = geometry.prototype("array-2x6")
    assert mark_text(design) == ("0.5MM", "A30")
    blind = design.with_values({"mold.ejector": "none"})
    for part, mold in (("mold-plugs", build_mold(design)), ("mold-base", build_mold(blind))):
        solid, plan = mold.parts[part].val(), mold.plan
        letters = engraved(solid, plan)
        assert len(letters.Solids()) == len("0.5MMA30")
        assert letters.BoundingBox().zlen == pytest.approx(0.3)
        x, y = plan.half
        above = cq.Solid.makeBox(2 * x, 2 * y, 0.2, cq.Vector(-x, -y, solid.BoundingBox().zmin + 0.3))
        assert overlap(above, solid) == pytest.approx(0.2 * (4 * x * y - 3**2 / 2))


@pytest.mark.parametrize(
    ("texts", "letters", "stroke"),
    [
        (("0.2MM", "A5"), 7, 0.5),
        (("0.2MM", "5-1-A0-5"), 13, 0.5),
        (("0.2MM", "5-1-A0-5-AND-MORE"), 18, 0.4),
        (("0.1555MM", "A5"), 10, None),
    ],
)
def test_a_long_mark_is_drawn_smaller_then_cut_and_stays_on_the_block(texts, letters, stroke):
    plan = plan_mold(geometry.prototype("fingertip-3x4").with_values({**ONE, "mold.ejector": "none"}))
    found = engraved(mark(base_block(plan), plan, texts), plan)
    assert len(found.Solids()) == letters
    box = found.BoundingBox()
    assert box.xlen <= 2 * 0.85 * plan.half[0] + 1e-6
    assert box.ylen <= 2 * 0.85 * plan.half[1] + 1e-6
    if stroke is not None:
        # A hyphen or the point is one stroke high.
        assert min(solid.BoundingBox().ylen for solid in found.Solids()) == pytest.approx(stroke)


@pytest.mark.parametrize("changes", [{}, BOSS, RIM])
def test_the_volume_of_a_cavity_is_that_of_its_solid(changes):
    plan = plan_mold(geometry.prototype("array-2x6").with_values({**ONE, **changes}))
    assert plan.cavity_volume == pytest.approx(revolved(plan.profile).Volume(), rel=1e-9)


@pytest.mark.parametrize("trim", [0.04, -0.06])
def test_a_measured_trim_moves_the_floors_of_the_cavities_and_nothing_else(trim):
    design = geometry.prototype("array-2x6").with_values({**ONE, "mold.ejector": "none"})
    plain, trimmed = plan_mold(design), plan_mold(design.with_values({"mold.trim": trim}))
    assert min(z for _, z in trimmed.profile) == pytest.approx(min(z for _, z in plain.profile) - trim)
    assert (trimmed.land, trimmed.half, trimmed.pins) == (plain.land, plain.half, plain.pins)
    # By the solids: the base has that much less material, and as much more below as its cavity is deeper.
    block = 4 * plain.half[0] * plain.half[1] - CORNER**2 / 2
    deeper = base_block(trimmed).Volume() - base_block(plain).Volume() - block * (plain.bottom - trimmed.bottom)
    radius = math.sqrt(max(r for r, _ in plain.profile) * min(r for r, z in plain.profile if z < 0 < r))
    assert -deeper == pytest.approx(math.pi * radius**2 * trim, rel=2e-3)


@pytest.mark.parametrize(
    ("changes", "kind", "field"),
    [
        ({"mold.draft": 11.0}, Kind.OUT_OF_RANGE, "mold.draft"),
        ({"mold.draft": 10.0, "membrane.thickness": 5.0}, Kind.CONFLICT, "mold.draft"),
        ({"mold.shim_count": 10, "mold.shim_step": 0.2}, Kind.CONFLICT, "mold.shim_count"),
        ({"mold.vent_diameter": 1.5}, Kind.CONFLICT, "mold.vent_diameter"),
        ({"mold.trim": -0.3}, Kind.CONFLICT, "mold.trim"),
        ({"mold.trim": 1.5}, Kind.OUT_OF_RANGE, "mold.trim"),
        ({"membrane.shape": "boss", "membrane.boss_height": 1.0}, Kind.MISSING, "membrane.boss_diameter"),
        ({"membrane.rim_height": 1.0}, Kind.CONFLICT, "membrane.rim_height"),
        ({**RIM, "membrane.stretch": 1.1}, Kind.CONFLICT, "membrane.stretch"),
        ({**BOSS, "membrane.boss_diameter": 5.5}, Kind.CONFLICT, "membrane.boss_diameter"),
        ({**BOSS, "membrane.boss_height": 7.0}, Kind.CONFLICT, "membrane.boss_height"),
        ({**BOSS, "mold.draft": 10.0, "membrane.boss_height": 3.0}, Kind.CONFLICT, "mold.draft"),
    ],
)
def test_a_mold_or_membrane_that_cannot_be_made_is_refused_by_name(changes, kind, field):
    with refused(kind, field, error=geometry.DesignError):
        geometry.prototype("array-2x6").with_values(changes)

"""Molds of many cavities: rays see them open, their volumes balance, and a blade opens them."""

import math

import numpy as np
import pytest

import geometry
from geometry.molds import build_mold, mold_counts, molds_of, plan_mold
from geometry.molds.mold_filling import closed_film, overflow, room_for_overflow
from geometry.molds.mold_forces import ALLOWED_STRESS, opening_forces
from geometry.solids.membrane import build_membrane

SMALL_PRINTER = {"printing.rules.build_volume": [120.0, 68.0, 150.0]}


def facets_of(solid, tolerance, near=None, angle=0.3):
    """Corners of the facets of a solid (n, 3, 3), mm; near a spot only those within 6 mm."""
    vertices, triangles = solid.tessellate(tolerance, angle)
    corners = np.array([vertex.toTuple() for vertex in vertices])[np.array(triangles)]
    if near is None:
        return corners
    low, high = corners.min(axis=1)[:, :2], corners.max(axis=1)[:, :2]
    return corners[((low < np.add(near, 6)) & (high > np.subtract(near, 6))).all(axis=1)]


def heights(corners, spots):
    """Lowest and highest height (mm) at which vertical lines through spots (n, 2) meet facets; nan where they miss.

    It is computed from facets alone, so it knows nothing of how the solids were drawn.
    """
    low, high = np.full(len(spots), np.inf), np.full(len(spots), -np.inf)
    edges = corners[:, 1:, :2] - corners[:, :1, :2]
    area = edges[:, 0, 0] * edges[:, 1, 1] - edges[:, 1, 0] * edges[:, 0, 1]
    corners, edges, area = (part[np.abs(area) > 1e-12] for part in (corners, edges, area))
    for start in range(0, len(corners), 1000):
        a, along, over = (part[start : start + 1000] for part in (corners, edges, area))
        x, y = (spots[None] - a[:, :1, :2]).transpose(2, 0, 1)
        second = (x * along[:, 1, 1:] - y * along[:, 1, :1]) / over[:, None]
        third = (y * along[:, 0, :1] - x * along[:, 0, 1:]) / over[:, None]
        rise = a[:, 1:, 2] - a[:, :1, 2]
        z = a[:, :1, 2] + second * rise[:, :1] + third * rise[:, 1:]
        hit = (second >= 0) & (third >= 0) & (second + third <= 1)
        low = np.fmin(low, np.where(hit, z, np.inf).min(axis=0))
        high = np.fmax(high, np.where(hit, z, -np.inf).max(axis=0))
    low[np.isinf(low)], high[np.isinf(high)] = np.nan, np.nan
    return low, high


@pytest.fixture(scope="module")
def mold():
    """Mold of the 2 x 6 array for a printer of 120 x 68 mm."""
    design = geometry.prototype("array-2x6").with_values(SMALL_PRINTER)
    return build_mold(design), build_membrane(design)


def test_rays_see_every_part_leave_the_mold_upwards(mold):
    made, membrane = mold
    base, lid, plugs = (made.parts[f"mold-{name}"].val() for name in ("base", "lid", "plugs"))
    casts = [cast.val() for cast in made.cast(membrane)]
    x, y = made.plan.half
    spots = np.random.default_rng(0).uniform((-x, -y), (x, y), (1500, 2))
    of_base, of_lid, of_plugs = (heights(facets_of(solid, 0.02), spots) for solid in (base, lid, plugs))
    of_casts = heights(np.concatenate([facets_of(cast, 0.02) for cast in casts]), spots)
    # Nothing of the base is above the lid or a membrane on any upright line, and nothing of the plugs above the base.
    assert np.nanmin(of_lid[0] - of_base[1]) > -1e-6
    assert np.nanmin(of_casts[0] - of_base[1]) > -1e-6
    assert np.nanmin(of_base[0] - np.where(np.isnan(of_casts[0]), of_plugs[1], np.nan)) > -1e-6
    assert np.isfinite(of_casts[0]).sum() > 300
    # The lines would see an undercut: a lid that hangs half a millimetre lower meets the lands.
    assert np.nanmin(of_lid[0] - 0.5 - of_base[1]) < -0.49


@pytest.mark.slow
def test_rays_find_the_volume_of_the_membrane_in_every_cavity(mold):
    made, membrane = mold
    base, lid, plugs = (made.parts[f"mold-{name}"].val() for name in ("base", "lid", "plugs"))
    outer, pin = made.plan.land[0], made.plan.ejector
    nodes, weights = np.polynomial.legendre.leggauss(24)
    radii, steps = [], []
    # The leaning wall has nodes of its own.
    for start, end in ((0, outer - 0.05), (outer - 0.05, outer)):
        radii.append(start + (nodes + 1) * (end - start) / 2)
        steps.append(weights * (end - start) / 2)
    angles = 2 * math.pi * (np.arange(24) + 0.5) / 24
    radius, angle = np.meshgrid(np.concatenate(radii), angles, indexing="ij")
    share = (radius * np.concatenate(steps)[:, None] * 2 * math.pi / 24).ravel()
    wanted = membrane.val().Volume() / 0.999**3
    for centre in (made.plan.centres[0], made.plan.centres[-1]):
        spots = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=-1).reshape(-1, 2) + centre
        of_base, of_plugs, of_lid = (heights(facets_of(part, 1e-3, centre, 0.03), spots) for part in (base, plugs, lid))
        depth = of_lid[0] - np.fmax(of_base[1], of_plugs[1])
        # What goes down beside a plug is the gap around it, no part of the membrane.
        gap = depth > 0.6
        assert share[gap].sum() == pytest.approx(2 * math.pi * (pin.hole**2 - pin.radius**2), rel=0.4)
        depth[gap] = -pin.top
        assert (share * depth).sum() == pytest.approx(wanted, rel=1e-3)


@pytest.mark.parametrize(
    ("name", "changes", "cavities", "casts"),
    [
        ("array-2x6", SMALL_PRINTER, 12, 1),
        ("fingertip-4x6", {}, 24, 1),
        ("large-area-64", {}, 24, 3),
        ("array-2x6", {"printing.rules.build_volume": [50.0, 40.0, 100.0]}, 2, 6),
        ("array-2x6", {"mold.rows": 2}, 12, 1),
        ("array-2x6", {"mold.rows": 1, "mold.columns": 2}, 2, 6),
    ],
)
def test_a_mold_has_a_cavity_for_every_membrane_as_far_as_the_printer_has_room(name, changes, cavities, casts):
    design = geometry.prototype(name).with_values(changes)
    plan = plan_mold(design)
    assert len(plan.centres) == plan.rows * plan.columns == cavities
    assert math.ceil(design.point_count / cavities) == casts
    width, depth, _ = design.printing.rules.build_volume or (145.0, 145.0, 0.0)
    assert 2 * plan.half[0] <= width - 10
    assert 2 * plan.half[1] <= depth - 10
    assert plan.forces.holds
    assert overflow(plan) < room_for_overflow(plan)
    assert closed_film(plan) < 0.01


def test_each_kind_of_membrane_has_cavities_for_its_own_points():
    design = geometry.prototype("array-2x6").with_values({
        "point_kinds": {"stiff": {}, "well": {"cavity_height": 4.0, "membrane_thickness": 0.8}},
        "lines": [{"between": ["A", "B"], "points": 5,
            "pattern": {"points": ["stiff", "well", "stiff", "stiff", "well"]}}],
    })  # fmt: skip
    own = [design.of_kind(design.kinds[kind]).membrane.thickness for kind in design.kind_of_point]
    molds = molds_of(design)
    assert len(molds) == 2
    for alike in molds.values():
        needed = own.count(alike.membrane.thickness)
        assert needed <= alike.mold.rows * alike.mold.columns <= needed + 1
        assert mold_counts(alike)["mold-plugs"] == 1


def test_the_stress_of_opening_is_that_of_the_beam_formulas():
    forces = opening_forces(10, 5.0, (60.0, 40.0), 10.0)
    # Air on ten lands of 5 mm, 0.101325 MPa: 79.58 N, half of it at the blade.
    assert forces.suction == pytest.approx(79.58, rel=1e-4)
    assert forces.blade == pytest.approx(39.79, rel=1e-4)
    # Roof of 2.1 mm, 10 mm wide, bent at 3 mm: 6 F a / (b t^2). Lid of 3 mm, 40 mm wide: 6 (F L / 8) / (b t^2).
    assert forces.roof_stress == pytest.approx(6 * 39.79 * 3 / (10 * 2.1**2), rel=1e-4)
    assert forces.lid_stress == pytest.approx(6 * 79.58 * 60 / 8 / (40 * 9), rel=1e-4)
    assert forces.holds
    assert not opening_forces(40, 5.0, (60.0, 40.0), 10.0).holds
    assert opening_forces(40, 5.0, (60.0, 40.0), 10.0).roof_stress > ALLOWED_STRESS


def test_ejector_pins_lie_under_the_rim_or_where_it_is_narrow_in_the_middle():
    wide, narrow = plan_mold("array-2x6").ejector, plan_mold("fingertip-3x4").ejector
    cavity = geometry.prototype("array-2x6").resonator.cavity_diameter / 2
    for x, y in wide.spots:
        assert math.hypot(x, y) - wide.hole > cavity
        assert math.hypot(x, y) + wide.hole < 4.5
    assert wide.on_rim
    assert narrow.spots == ((0.0, 0.0),)
    assert plan_mold(geometry.prototype("array-2x6").with_values({"mold.ejector": "none"})).ejector is None

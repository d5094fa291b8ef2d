"""Discs with a thicker rim or a boss: their limits, what grows with the height, convergence, bad input."""

import numpy as np
import pytest
from coarse_discs import coarse_discs
from refusals import refused

from acoustic_fem.membrane.design_discs import design_disc
from acoustic_fem.membrane.disc import DiscOptions, solve_disc
from acoustic_fem.membrane.elasticity import solve_dimensionless
from acoustic_fem.membrane.half_section import DiscShape
from geometry.design.design_file import prototype
from geometry.ground.refusal import Kind

H = 1 / 6


@pytest.fixture
def coarse():
    """For what does not hang on the last digits."""
    with coarse_discs():
        yield


def glued(raised=None, contact=0.25, poisson_ratio=0.49):
    return DiscShape(H, poisson_ratio, 0.5, 0.5, 0.0, contact, raised)


def figures(disc):
    return np.array([disc.compliance, disc.volume_per_force, disc.displacement_per_force, disc.eigenvalues[0]])


@pytest.mark.parametrize(("raised", "tolerance"), [((0.0, 0.4, 1e-5), 1e-3), ((1.0, 1.5, 1e-5), 2e-4)])
def test_a_rim_or_boss_of_no_height_is_the_flat_disc(raised, tolerance):
    """To first order in the height h the difference is a few h / thickness and more where a corner is made."""
    flat, shaped = (figures(solve_dimensionless(glued(part), 3)) for part in (None, raised))
    assert shaped == pytest.approx(flat, rel=tolerance, abs=0)


def test_a_clamped_boss_as_wide_as_the_disc_is_a_thicker_disc():
    thick = solve_dimensionless(DiscShape(2 * H, 0.49, 0.0, 0.0, 0.0, 0.25))
    boss = solve_dimensionless(DiscShape(H, 0.49, 0.0, 0.0, 0.0, 0.25, (0.0, 1.0, H)))
    assert figures(boss) == pytest.approx(figures(thick), rel=3e-4, abs=0)
    assert boss.swept_above[0] == pytest.approx(thick.swept_above[0], rel=2e-4, abs=0)


@pytest.mark.slow
@pytest.mark.usefixtures("coarse")
@pytest.mark.parametrize("part", [(0.0, 0.4), (1.0, 1.5)], ids=["boss", "rim"])
def test_a_higher_rim_or_boss_makes_a_stiffer_disc(part):
    heights = (0.1 * H, H, 3 * H)
    discs = [solve_dimensionless(glued((*part, height)), 3) for height in heights]
    values = [solve_dimensionless(glued(), 3).compliance, *(disc.compliance for disc in discs)]
    assert np.all(np.diff(values) < 0)


@pytest.mark.usefixtures("coarse")
def test_a_rigid_boss_is_an_annular_plate_on_a_rigid_centre():
    """A high boss holds the slope at its edge at zero: a thin clamped annulus b < r < a with a piston in it.

    Thin plate: lap lap w = p / D, w = w' = 0 at a, w' = 0 at b and the shear at b carries p pi b^2.
    """
    h, b, ratio = 0.02, 0.4, 0.3
    stiffness = h**3 / (12 * (1 - ratio**2))
    # w = r^4 / 64 + A ln r + B r^2 + C + E r^2 ln r (per p / D); a total load pi r^2 inside r leaves E = 0.
    a, c, d = np.linalg.solve([[0.0, 1.0, 1.0], [1.0, 2.0, 0.0], [1 / b, 2 * b, 0.0]], [-1 / 64, -1 / 16, -(b**3) / 16])
    r = np.linspace(b, 1, 20001)
    w = r**4 / 64 + a * np.log(r) + c * r**2 + d
    compliance = 2 * np.pi * (np.trapezoid(w * r, r) + w[0] * b**2 / 2) / stiffness
    disc = solve_dimensionless(DiscShape(h, ratio, 0.0, 0.0, 0.0, 0.25, (0.0, b, 0.5)))
    # The plate's root in the boss and in the clamp yields: of the order of the thickness over the span.
    assert disc.compliance == pytest.approx(compliance, rel=0.06)
    assert disc.compliance > compliance


@pytest.mark.parametrize("part", [(0.0, 0.4, H), (0.0, 0.4, 1.0)])
def test_what_an_incompressible_clamped_disc_sweeps_below_it_sweeps_above(part):
    """The faces and the upright wall of the boss together."""
    disc = solve_dimensionless(DiscShape(H, 0.49999, 0.0, 0.0, 0.0, 0.25, part), 3)
    assert disc.swept_above[:2] == pytest.approx(disc.swept[:2], rel=2e-4, abs=0)


@pytest.mark.slow
@pytest.mark.parametrize("part", [(0.0, 0.4, H), (1.0, 1.5, H)], ids=["boss", "rim"])
def test_shaped_discs_are_converged(part):
    coarse, fine = (figures(solve_dimensionless(glued(part), refinement)) for refinement in (4, 5))
    assert coarse == pytest.approx(fine, rel=1.5e-4, abs=0)


@pytest.mark.usefixtures("coarse")
def test_a_heavy_boss_lowers_the_resonance_and_a_rim_raises_it():
    flat = solve_disc(3e-3, 0.5e-3, 1e6, rim_width=1.5e-3).first_frequency
    assert (
        solve_disc(
            3e-3, 0.5e-3, 1e6, rim_width=1.5e-3, options=DiscOptions(boss_radius=1e-3, boss_height=3e-3)
        ).first_frequency
        < flat
    )
    assert solve_disc(3e-3, 0.5e-3, 1e6, rim_width=1.5e-3, options=DiscOptions(rim_height=1e-3)).first_frequency > flat


@pytest.mark.usefixtures("coarse")
def test_the_touch_takes_the_whole_boss_unless_told_otherwise():
    disc = solve_disc(3e-3, 0.5e-3, 1e6, rim_width=1.5e-3, options=DiscOptions(boss_radius=1.2e-3, boss_height=1e-3))
    assert disc.contact_radius == pytest.approx(1.2e-3, rel=1e-12, abs=0)
    smaller = solve_disc(
        3e-3,
        0.5e-3,
        1e6,
        rim_width=1.5e-3,
        options=DiscOptions(boss_radius=1.2e-3, boss_height=1e-3, contact_radius=0.6e-3),
    )
    assert smaller.displacement_per_force > disc.displacement_per_force


def test_a_design_gives_its_shape_to_the_acoustics():
    design = prototype("array-2x6")
    boss = design.with_values({"membrane.shape": "boss", "membrane.boss_diameter": 2.0, "membrane.boss_height": 0.6})
    rim = design.with_values({"membrane.shape": "rim", "membrane.rim_height": 0.4})
    material = design.material(design.membrane.material)
    same = {"rim_width": 1.5e-3, "density": material.density}
    given = (3e-3, 0.5e-3, material.youngs_modulus * 1e6, material.poisson_ratio)
    expected = solve_disc(*given, **same, options=DiscOptions(boss_radius=1e-3, boss_height=0.6e-3)).static_compliance
    assert design_disc(boss).static_compliance == pytest.approx(expected, rel=1e-9, abs=0)
    expected = solve_disc(*given, **same, options=DiscOptions(rim_height=0.4e-3)).static_compliance
    assert design_disc(rim).static_compliance == pytest.approx(expected, rel=1e-9, abs=0)
    assert design_disc(rim).static_compliance < 0.97 * design_disc(design).static_compliance
    # A rim that cannot move is no stiffer for being thick.
    clamped = {"membrane.mounting": "clamped"}
    assert (
        design_disc(rim.with_values(clamped)).static_compliance
        == design_disc(design.with_values(clamped)).static_compliance
    )


@pytest.mark.parametrize(
    ("changes", "field", "kind"),
    [
        ({"rim_height": 1e-3}, "rim_height", Kind.CONFLICT),
        ({"rim_width": 1e-3, "rim_height": 7e-3}, "rim_height", Kind.OUT_OF_RANGE),
        ({"boss_height": 1e-3}, "boss_radius", Kind.CONFLICT),
        ({"boss_radius": 2.8e-3, "boss_height": 1e-3}, "boss_radius", Kind.OUT_OF_RANGE),
        ({"boss_radius": 1e-3, "boss_height": 1e-3, "contact_radius": 1.1e-3}, "contact_radius", Kind.OUT_OF_RANGE),
        ({"rim_width": 1e-3, "rim_height": 1e-3, "stretch": 1.1}, "rim_height", Kind.CONFLICT),
        ({"boss_radius": 1e-3, "boss_height": 1e-3, "tension": 1.0}, "boss_height", Kind.CONFLICT),
    ],
)
def test_a_shape_that_cannot_be_solved_is_refused_by_name(changes, field, kind):
    with refused(kind, field):
        solve_disc(3e-3, 0.5e-3, 1e6, rim_width=changes.pop("rim_width", 0.0), options=DiscOptions(**changes))

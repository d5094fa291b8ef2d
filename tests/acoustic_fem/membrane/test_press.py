"""Large deflections: values of another program, the linear law, a thin membrane, convergence, bad input."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from reference_data import PressedMembrane
from refusals import refused

from acoustic_fem.membrane import (
    FlatPunch,
    MountedMembrane,
    SoftPatch,
    Sphere,
    bulge,
    design_disc,
    design_membrane,
    press,
    press_curve,
    press_table,
    solve_disc,
)
from acoustic_fem.membrane.disc import DiscOptions
from acoustic_fem.membrane.equilibrium import Equilibrium, LoadedDisc, Punching, Setup
from acoustic_fem.membrane.finite_elasticity import Section
from acoustic_fem.membrane.half_section import DiscShape
from geometry import Kind, prototype

ARRAY = DiscShape(1 / 6, 0.49, 0.5, 0.5, 0.0, 0.25)


@pytest.fixture
def coarse(monkeypatch: pytest.MonkeyPatch) -> None:
    """Tables of larger elements, for what holds on any mesh."""
    solved = press_table.solved_press
    monkeypatch.setattr(
        "acoustic_fem.membrane.large_deflection.solved_press", lambda shape, setup: solved(shape, setup, 1)
    )


def equilibria(setup: Setup, loads: list[float], refinement: int = 1, shape: DiscShape = ARRAY) -> list[Equilibrium]:
    disc = LoadedDisc(Section(shape, refinement), setup)
    found, state = [], disc.relaxed
    for load in loads:
        each = disc.solve(load, state)
        assert each is not None, load
        state = each.state
        found.append(each)
    return found


# -- another program ------------------------------------------------------------------------------------------
@pytest.mark.parametrize(("design", "largest", "within"), [("array-2x6", 0.3, 0.03), ("fingertip-4x6", 0.03, 0.05)])
@pytest.mark.slow
def test_volume_under_a_soft_patch_agrees_with_another_program(design, largest, within):
    force, volume = PressedMembrane(design).patch(largest)
    assert len(force) >= 5
    assert force[-1] == pytest.approx(largest, rel=1e-3)
    assert press(design_membrane(design), SoftPatch(), force).volume == pytest.approx(volume, rel=within, abs=0)


@pytest.mark.slow
@pytest.mark.parametrize("radius", [1.5e-3, 8e-3])
def test_volume_under_a_sphere_agrees_with_another_program(radius):
    force, volume = PressedMembrane("array-2x6").sphere(radius, 0.3)
    assert len(force) >= 7
    # The other program's row of 1.5 mm at 1.5 mm depth lies beyond 0.3 N here, and 0.15 N off its own sequence.
    assert press(design_membrane("array-2x6"), Sphere(radius), force).volume == pytest.approx(volume, rel=0.03, abs=0)


@pytest.mark.slow
@pytest.mark.parametrize("design", ["array-2x6", "fingertip-4x6"])
def test_compliance_under_a_dead_pressure_agrees_with_another_program(design):
    pressure, volume = PressedMembrane(design).bulge()
    ours = bulge(design_membrane(design), pressure, dead_load=True).volume
    assert (ours / ours[0]) == pytest.approx(volume / volume[0], rel=0.02, abs=0)
    assert np.diff(ours) / ours[0] == pytest.approx(np.diff(volume) / volume[0], rel=0.02, abs=0)


# -- the linear law --------------------------------------------------------------------------------------------
@pytest.mark.parametrize("design", ["array-2x6", pytest.param("fingertip-4x6", marks=pytest.mark.slow)])
def test_small_forces_displace_the_volume_of_the_linear_law(design):
    disc, membrane = design_disc(design), design_membrane(design)
    force = np.array([1e-8, 1e-6, 1e-5]) * membrane.youngs_modulus * membrane.radius**2
    response = press(membrane, SoftPatch(), force)
    assert response.volume == pytest.approx(disc.volume_per_force * force, rel=1e-3, abs=0)
    assert response.compliance[:2] == pytest.approx(np.full(2, disc.static_compliance), rel=1e-3, abs=0)
    assert response.indentation == pytest.approx(disc.displacement_per_force * force, rel=2e-3, abs=0)
    small = np.array([1e-6, -1e-6]) * membrane.youngs_modulus
    assert bulge(membrane, small).volume == pytest.approx(disc.static_compliance * small, rel=1e-3, abs=0)
    assert bulge(membrane, 0.0).compliance == pytest.approx(disc.static_compliance, rel=1e-3)


@pytest.mark.slow
def test_a_small_sphere_acts_as_a_force_on_a_point():
    membrane = design_membrane("array-2x6")
    sizes = membrane.radius, membrane.thickness, membrane.youngs_modulus, membrane.poisson_ratio, membrane.rim_width
    point = solve_disc(*sizes, options=DiscOptions(contact_radius=0.02 * membrane.radius))
    force = 1e-5 * membrane.youngs_modulus * membrane.radius**2
    assert press(membrane, Sphere(1.5e-3), force).volume == pytest.approx(point.volume_per_force * force, rel=1e-3)


def test_volume_under_a_small_force_converges_with_the_smallest_step():
    """The stress at the edge of the glue is singular: the error falls with the first power of the step there."""
    exact = solve_disc(3.0, 0.5, 1.0, 0.49, 1.5).volume_per_force / 3.0
    errors = []
    for refinement in (1, 2, 3, 4):
        (state,) = equilibria(Setup("force"), [1e-6], refinement)
        errors.append(1 - state.volume / 1e-6 / exact)
    assert 0 < errors[3] < 1e-3
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert orders == pytest.approx(np.ones(3), abs=0.25)


def test_volume_under_a_large_force_converges():
    """At 0.1 N on array-2x6, multiplied by the linear solution's ratio as tables are."""
    exact = solve_disc(3.0, 0.5, 1.0, 0.49, 1.5).volume_per_force / 3.0
    volumes = []
    for refinement in (1, 2, 3):
        disc = LoadedDisc(Section(ARRAY, refinement), Setup("force"))
        state = equilibria(Setup("force"), [1e-3, 3e-3, 6e-3, 0.01], refinement)[-1]
        volumes.append(state.volume * exact / disc.linear_answers()[1])
    steps = np.abs(np.diff(volumes)) / volumes[-1]
    assert steps[0] < 2e-3
    assert steps[1] < 1e-3


# -- consistency -----------------------------------------------------------------------------------------------
def test_the_tangent_is_the_derivative_of_the_residual():
    section = Section(ARRAY, 1)
    random = np.random.default_rng(3)
    state = equilibria(Setup("force"), [1e-3, 4e-3])[-1].state + 1e-4 * random.standard_normal(section.size)
    way = random.standard_normal(section.size)
    size = 1e-7
    strains = [section.strain(state + sign * size * way) for sign in (1, -1)]
    strain = section.strain(state)
    assert strain is not None
    assert all(strains)
    difference = (section.residual(strains[0]) - section.residual(strains[1])) / (2 * size)
    product = np.zeros(section.size)
    for block in section.tangent(strain):
        np.add.at(product, block.rows, np.einsum("eij,ej->ei", block.values, way[block.columns]))
    assert product == pytest.approx(difference, rel=1e-6, abs=1e-6 * np.abs(difference).max())


@pytest.mark.parametrize(
    "setup",
    [
        Setup("force"),
        Setup("depth", Punching(0.0, 1.0)),
        Setup("depth", Punching(0.3, 0.1)),
        Setup("pressure"),
        Setup("suction"),
    ],
    ids=lambda setup: f"{setup.load} {setup.punch and setup.punch.flat}",
)
def test_slopes_are_the_derivatives_in_the_load(setup):
    middle, size = (0.2, 1e-4) if setup.load == "depth" else (0.004, 1e-6)
    loads = [middle / 20, middle / 4, middle / 2, middle, middle - size, middle + size]
    *_, here, below, above = equilibria(setup, loads)
    assert (above.volume - below.volume) / (2 * size) == pytest.approx(here.volume_slope, rel=1e-3)
    assert (above.force - below.force) / (2 * size) == pytest.approx(here.force_slope, rel=1e-3, abs=1e-12)
    if setup.punch is None and setup.load != "force":
        sign = 1 if setup.load == "suction" else -1
        assert here.compliance == pytest.approx(sign * here.volume_slope, rel=1e-9)


def test_a_punch_touches_without_entering_and_bears_the_force():
    disc = LoadedDisc(Section(ARRAY, 1), Setup("depth", Punching(0.0, 2.5)))
    state = disc.relaxed
    for depth in (0.02, 0.05, 0.1, 0.15):
        found = disc.solve(depth, state)
        assert found is not None
        state = found.state
    (face, first, body), *_ = disc._bodies(0.15)
    pressure = state[first : first + len(face.corners)]
    gaps = face.gaps(state[: disc.section.size], pressure, body).mean / face.area
    touching = pressure > 0
    assert 3 < touching.sum() < len(touching)
    assert np.abs(gaps[touching]).max() < 1e-9
    assert gaps[~touching].min() > 0
    assert pressure.min() >= 0
    # the glue bears what the punch gives
    strain = disc.section.strain(state[: disc.section.size])
    assert strain is not None
    basis = disc.section.displacement
    held = np.setdiff1d(np.flatnonzero(basis.doflocs[1] == 0), disc.free)
    axial = [np.unique(dofs) for dofs, (f, *_) in zip(basis.element_dofs, basis.basis, strict=True) if f[1].any()]
    reaction = disc.section.residual(strain)[np.intersect1d(held, np.concatenate(axial))].sum()
    assert reaction == pytest.approx(found.force, rel=1e-6)


def test_the_floor_stops_the_membrane():
    loads = [1e-3, 5e-3, 0.01, 0.02, 0.03, 0.04]
    free = equilibria(Setup("force"), loads)[-1]
    stopped = equilibria(Setup("force", floor=0.4), loads)[-1]
    assert free.deepest > 0.45
    assert free.floor_force == 0
    assert stopped.deepest == pytest.approx(0.4, abs=0.02)
    assert 0 < stopped.floor_force < stopped.force
    assert stopped.volume < free.volume
    assert stopped.compliance < free.compliance


def hencky(load: float, poisson_ratio: float) -> float:
    """Middle deflection / a of a membrane without bending stiffness under q = p a / (E h), its edge held.

    H. Hencky, Z. Math. Phys. 63 (1915) 311; series as in J. D. Campbell, Q. J. Mech. Appl. Math. 9 (1956) 84.
    """
    stress = [(-1.0, 2), (-2 / 3, 5), (-13 / 18, 8), (-17 / 18, 11), (-37 / 27, 14), (-1205 / 567, 17)]
    deflection = [(1.0, 1), (1 / 2, 4), (5 / 9, 7), (55 / 72, 10), (7 / 6, 13), (205 / 108, 16)]

    def edge(b: float) -> float:
        terms = ((2 * n + 3 - poisson_ratio) * factor / b**power for n, (factor, power) in enumerate(stress))
        return float((1 - poisson_ratio) * b + sum(terms))

    low, high = 1.3, 3.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if edge(middle) < 0 else (low, middle)
    return float(sum(factor / low**power for factor, power in deflection) * load ** (1 / 3))


def test_a_thin_clamped_membrane_follows_hencky():
    assert hencky(1.0, 0.3) == pytest.approx(0.653, abs=2e-3)  # his own figure
    thin = DiscShape(0.02, 0.49, 0.0, 0.0, 0.0, 0.25)
    load = 4e-4  # q = 0.02: strain of 3 %, bending stiffness of half a percent
    states = equilibria(Setup("pressure"), [load / 100, load / 20, load / 5, load / 2, load], 1, thin)
    assert -states[-1].deepest == pytest.approx(hencky(load / 0.02, 0.49), rel=0.03)


# -- curves ----------------------------------------------------------------------------------------------------
def test_volume_rises_with_force_and_its_slope_is_the_derivative(coarse):
    curve = press_curve(design_membrane("fingertip-4x6"), SoftPatch())
    force = np.geomspace(1e-6, curve.largest_force, 400)
    response = curve.response(force)
    assert (np.diff(response.volume) > 0).all()
    steps = np.diff(response.volume) / np.diff(force)
    middle = curve.response((force[1:] + force[:-1]) / 2).volume_per_force
    assert steps == pytest.approx(middle, rel=5e-3)
    assert curve.volume_fraction(0.0) == 1
    assert curve.response(0.0).stretch == 1
    assert curve.volume_fraction([0.001, 0.03]) == pytest.approx([1.08, 0.395], abs=0.01)


@pytest.mark.slow
def test_a_press_finds_the_floor_of_the_cavity(coarse):
    curve = press_curve(design_membrane("array-2x6"), SoftPatch())
    at_floor = curve.force_at_floor
    assert 0.8 < at_floor < 1.1
    before, behind = curve.response([0.9 * at_floor, 1.1 * at_floor]).floor_force
    assert before == 0
    assert behind > 0
    shallow = press_curve(
        design_membrane(prototype("array-2x6").with_values({"resonator.cavity_height": 2.0})), SoftPatch()
    )
    assert shallow.force_at_floor < at_floor


def test_a_blunt_indenter_saturates_on_the_rim(coarse):
    membrane = design_membrane("fingertip-4x6")
    finger = press(membrane, Sphere(8e-3), [1e-4, 0.06])
    patch = press(membrane, SoftPatch(), [1e-4, 0.03])
    assert finger.volume[0] == pytest.approx(patch.volume[0], rel=0.05)
    assert finger.volume[1] < 0.4 * patch.volume[1]
    assert finger.contact_radius[1] > membrane.radius


def test_a_pressed_membrane_is_stiffer_and_stiffer_still_when_held(coarse):
    response = press(design_membrane("array-2x6"), FlatPunch(1.5e-3), [1e-4, 0.3])
    assert response.compliance[1] < 0.5 * response.compliance[0]
    assert (response.held_compliance < 0.3 * response.compliance[0]).all()


@pytest.mark.slow
def test_pressure_inside_bulges_out_and_stiffens(coarse):
    membrane = design_membrane("array-2x6")
    response = bulge(membrane, [-100.0, 0.0, 100.0, 1500.0])
    assert (np.diff(response.volume) > 0).all()
    assert response.deepest[0] > 0 > response.deepest[2]
    relaxed = response.compliance[1]
    # the glue lies on one face: a membrane that is drawn in softens at first
    assert response.compliance[0] > relaxed > response.compliance[2]
    assert response.compliance[3] / relaxed == pytest.approx(0.81, abs=0.01)
    for sign in (-1, 1):
        near = bulge(membrane, sign * np.array([700.0, 701.0]))
        assert np.diff(near.volume)[0] * sign == pytest.approx(near.compliance.mean(), rel=5e-3)


def test_a_solved_press_is_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path))
    solved: list[Setup] = []
    original = press_table.solve_press

    def counted(shape: DiscShape, setup: Setup, refinement: int) -> press_table.PressTable:
        solved.append(setup)
        return original(shape, setup, refinement)

    monkeypatch.setattr(press_table, "solve_press", counted)
    found = press_table.solved_press.__wrapped__
    first, again = (found(replace(ARRAY, thickness=0.3), Setup("force"), 0) for _ in range(2))
    assert len(solved) == 1
    assert first.end == again.end
    assert all(np.array_equal(column, again.rows[name]) for name, column in first.rows.items())


# -- bad input -------------------------------------------------------------------------------------------------
RELAXED = MountedMembrane(3e-3, 0.5e-3, 1.1424e6, 0.49, 1.5e-3)


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"radius": 0.0}, "radius"),
        ({"thickness": 4e-3}, "thickness"),
        ({"youngs_modulus": np.nan}, "youngs_modulus"),
        ({"poisson_ratio": 0.49999}, "poisson_ratio"),
        ({"rim_width": -1e-3}, "rim_width"),
        ({"cavity_depth": 0.0}, "cavity_depth"),
    ],
)
def test_a_membrane_out_of_range_is_refused_by_field(change, field):
    with refused(Kind.OUT_OF_RANGE, field):
        press_curve(replace(RELAXED, **change), SoftPatch())


@pytest.mark.parametrize(
    ("indenter", "field"),
    [
        (Sphere(0.0), "indenter.radius"),
        (Sphere(1.0), "indenter.radius"),
        (FlatPunch(3e-3), "indenter.radius"),
        (FlatPunch(1e-3, 2e-3), "indenter.edge_radius"),
        (SoftPatch(3e-3), "contact_radius"),
    ],
)
def test_an_indenter_out_of_range_is_refused_by_field(indenter, field):
    with refused(Kind.OUT_OF_RANGE, field):
        press_curve(RELAXED, indenter)


def test_forces_and_pressures_beyond_the_solution_are_refused(coarse):
    membrane = design_membrane("fingertip-4x6")
    with refused(Kind.OUT_OF_RANGE, "force", 10.0):
        press(membrane, SoftPatch(), [0.01, 10.0])
    with refused(Kind.OUT_OF_RANGE, "force", -1.0):
        press(membrane, SoftPatch(), -1.0)
    for pressure in (1e6, -1e6):
        with refused(Kind.OUT_OF_RANGE, "pressure", pressure):
            bulge(membrane, pressure)
    with refused(Kind.OUT_OF_RANGE, "pressure", -1.0):
        bulge(membrane, -1.0, dead_load=True)


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"membrane.stretch": 1.1}, "membrane.stretch"),
        ({"membrane.shape": "rim", "membrane.rim_height": 0.5}, "membrane.shape"),
    ],
)
def test_a_stretched_or_shaped_membrane_is_refused(change, field):
    with refused(Kind.OUT_OF_RANGE, field):
        design_membrane(prototype("array-2x6").with_values(change))

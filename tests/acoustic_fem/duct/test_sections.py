"""Sections: closed forms against each other and against finite elements, limits, orders, bad meshes."""

import mpmath
import numpy as np
import pytest
import skfem
from hypothesis import given, strategies as st
from reference_data import AIR
from refusals import refused

from acoustic_fem.duct import plane_wave
from acoustic_fem.duct.meshed_section import MeshedSection
from acoustic_fem.duct.sections import CircularSection, RectangularSection, SlitSection, TriangularSection
from geometry.ground.refusal import Kind

SIDES = st.floats(1e-4, 5e-3)
FREQUENCIES = st.floats(1e-2, 2e4)
EQUILATERAL = np.array([[0, 0], [1, 0], [0.5, np.sqrt(0.75)]])


def error(section, exact, rate):
    """Relative error of <Psi> at real rates (the imaginary parts of s)."""
    rate = 1j * np.asarray(rate)
    return np.abs(section.mean_field(rate) / exact.mean_field(rate) - 1)


def test_a_circular_section_is_the_duct_of_its_radius():
    frequency = np.geomspace(0.01, 2e4, 7)
    section = CircularSection(3e-4)
    np.testing.assert_array_equal(
        section.series_impedance(frequency, AIR), plane_wave.series_impedance(3e-4, frequency, AIR)
    )
    np.testing.assert_array_equal(
        section.shunt_admittance(frequency, AIR), plane_wave.shunt_admittance(3e-4, frequency, AIR)
    )


@pytest.mark.parametrize(
    ("section", "resistance"),
    [
        (CircularSection(1e-3), 8 / (np.pi * 1e-12)),
        (SlitSection(1e-3, 2e-2), 12 / (2e-2 * 1e-9)),
        # White, Viscous Fluid Flow (2006), eq. 3-48: the square, R = 28.4541 mu / h^4
        (RectangularSection(1e-3, 1e-3), 28.45413 / 1e-12),
        (TriangularSection(1e-3), 320 / (np.sqrt(3) * 1e-12)),
    ],
)
def test_resistance_at_low_frequency_is_that_of_poiseuille_flow(section, resistance):
    assert section.series_impedance(1e-4, AIR).real == pytest.approx(resistance * AIR.viscosity, rel=1e-6, abs=0)
    isothermal = 2 * np.pi * 1e-4 * section.area / AIR.pressure
    assert section.shunt_admittance(1e-4, AIR).imag == pytest.approx(isothermal, rel=1e-6, abs=0)


@pytest.mark.parametrize(("width", "height"), [(1, 1), (1, 2), (50, 1)])
@pytest.mark.parametrize("rate", [1e-4, 1.0, 30.0, 1e4])
def test_the_rectangle_agrees_with_its_series_summed_to_25_digits(width, height, rate):
    with mpmath.workdps(25):
        long, short, s = mpmath.mpf(max(width, height)), mpmath.mpf(min(width, height)), mpmath.mpc(0, rate)

        def term(k):
            wave = mpmath.sqrt(((2 * k + 1) * mpmath.pi / short) ** 2 + s)
            drag = mpmath.tanh(wave * long / 2) / (wave * long / 2)
            return 8 / (mpmath.pi * (2 * k + 1)) ** 2 * s / wave**2 * drag

        half = mpmath.sqrt(s) * short / 2
        exact = complex(1 - mpmath.tanh(half) / half - mpmath.nsum(term, [0, mpmath.inf]))
    value = RectangularSection(width, height).mean_field(np.array(1j * rate))
    assert value == pytest.approx(exact, rel=1e-13, abs=0)


def test_a_flat_rectangle_tends_to_the_slit():
    flat, slit, rate = RectangularSection(1e3, 1.0), SlitSection(1.0, 1e3), [1e-3, 10.0, 1e3]
    assert (error(flat, slit, rate) < 0.7e-3).all()


@given(SIDES, SIDES, FREQUENCIES)
def test_a_rectangle_does_not_care_which_side_is_called_width(width, height, frequency):
    one, other = RectangularSection(width, height), RectangularSection(height, width)
    assert one.series_impedance(frequency, AIR) == other.series_impedance(frequency, AIR)


@given(SIDES, SIDES, FREQUENCIES, st.floats(1e-4, 0.1))
def test_every_section_is_passive_and_a_thinner_one_resists_more(width, height, frequency, length):
    for make in (
        lambda scale: CircularSection(width * scale),
        lambda scale: SlitSection(width * scale, height),
        lambda scale: RectangularSection(width * scale, height * scale),
        lambda scale: TriangularSection(width * scale),
    ):
        section = make(1.0)
        admittance = section.port_admittance(length, frequency, AIR)
        assert admittance[0, 1] == admittance[1, 0]
        assert np.linalg.eigvalsh(admittance.real).min() >= -1e-12 * abs(admittance[0, 0])
        resistance = section.series_impedance(frequency, AIR).real
        assert make(0.9).series_impedance(frequency, AIR).real > resistance


def orders(sections, exact, rate):
    errors = np.array([error(section, exact, rate) for section in sections])
    return np.log2(errors[:-1] / errors[1:]), errors[-1]


@pytest.mark.parametrize(
    ("make", "exact", "expected"),
    [
        (lambda n: MeshedSection.circle(1.0, n), CircularSection(1.0), 3.4),
        (lambda n: MeshedSection.rectangle(2.0, 1.0, 2 * n, n), RectangularSection(2.0, 1.0), 3.5),
        (lambda n: MeshedSection.triangle(EQUILATERAL, n), TriangularSection(1.0), 3.9),
    ],
    ids=["circle", "rectangle", "triangle"],
)
def test_the_mean_field_converges_with_twice_the_order_of_the_elements(make, exact, expected):
    """Order 4, less the r^2 log r of right-angled corners and the seams of the circle's mesh."""
    order, last = orders([make(n) for n in (4, 8, 16)], exact, [1e-3, 1.0, 10.0])
    assert (order > expected).all()
    assert (order < 4.2).all()
    assert (last < 2e-5).all()


def test_a_circle_of_96_triangles_is_within_0_014_percent():
    section = MeshedSection.circle(1e-3, 4)
    assert len(section.triangles) == 96
    assert error(section, CircularSection(1e-3), [1.0, 1e6, 1e7]).max() < 1.4e-4


def test_a_mesh_of_scikit_fem_serves_as_section():
    """64 triangles, some of them clockwise."""
    section = MeshedSection.from_mesh(skfem.MeshTri2.init_circle(2))
    assert len(section.triangles) == 64
    assert error(section, CircularSection(1.0), [1e-3, 1.0, 10.0]).max() < 5e-4
    straight = MeshedSection.from_mesh(skfem.MeshTri.init_tensor(np.linspace(0, 1, 9), np.linspace(0, 1, 9)))
    assert error(straight, RectangularSection(1.0, 1.0), [1.0, 10.0]).max() < 5e-4


def test_straight_facets_cost_more_than_a_percent():
    """Why second-order geometry is mandatory: the same 96 triangles with straight edges."""
    curved = MeshedSection.circle(1.0, 4)
    points = curved.points.copy()
    for k, (i, j) in enumerate([(0, 1), (1, 2), (2, 0)]):
        points[curved.triangles[:, 3 + k]] = (points[curved.triangles[:, i]] + points[curved.triangles[:, j]]) / 2
    straight = MeshedSection(points, curved.triangles)
    rate = np.array([1e-3j])
    resistance = [1 / (s.area * s.mean_field(rate)[0].imag) for s in (straight, curved)]
    assert resistance[0] / resistance[1] > 1.01


def test_one_mesh_serves_all_frequencies_of_a_grid_at_once():
    frequency = np.geomspace(0.1, 2e3, 40)
    section, exact = MeshedSection.circle(2.5e-4, 8), CircularSection(2.5e-4)
    np.testing.assert_allclose(
        section.series_impedance(frequency, AIR), exact.series_impedance(frequency, AIR), rtol=2e-4
    )
    np.testing.assert_allclose(
        section.shunt_admittance(frequency, AIR), exact.shunt_admittance(frequency, AIR), rtol=2e-4
    )
    one = section.series_impedance(frequency[17], AIR)
    assert one == pytest.approx(section.series_impedance(frequency, AIR)[17], rel=1e-8, abs=0)


def test_a_layer_thinner_than_the_wall_elements_is_warned_about():
    with pytest.warns(UserWarning, match=r"wall layer of .* is thinner than the elements"):
        MeshedSection.circle(2.5e-3, 2).series_impedance(2e4, AIR)


def test_an_inverted_triangle_is_refused_with_its_place():
    section = MeshedSection.rectangle(1.0, 1.0, 3, 3)
    points = section.points.copy()
    inner = np.flatnonzero(np.all((points > 0.2) & (points < 0.4), axis=1))
    corner = next(k for k in inner if k in section.triangles[:, :3])
    points[corner] = [0.9, 0.9]
    with refused(Kind.UNSUITABLE, "triangles"):
        MeshedSection(points, section.triangles)


def test_a_curved_edge_that_folds_its_triangle_is_refused():
    points = np.array([[0, 0], [1, 0], [0, 1], [0.5, 0.6], [0.5, 0.5], [0, 0.5]])
    with refused(Kind.UNSUITABLE, "triangles"):
        MeshedSection(points, np.array([[0, 1, 2, 3, 4, 5]]))


@pytest.mark.parametrize(
    ("make", "field", "kind"),
    [
        (lambda: CircularSection(-1e-3), "radius", Kind.OUT_OF_RANGE),
        (lambda: SlitSection(1e-3, float("nan")), "width", Kind.OUT_OF_RANGE),
        (lambda: RectangularSection(1e-3, 0.0), "height", Kind.OUT_OF_RANGE),
        (lambda: TriangularSection(float("inf")), "side", Kind.OUT_OF_RANGE),
        (lambda: MeshedSection.circle(1e-3, 0), "rings", Kind.OUT_OF_RANGE),
        (lambda: MeshedSection(np.zeros((6, 3)), np.arange(6)[None]), "points", Kind.WRONG_TYPE),
        (lambda: MeshedSection(np.zeros((6, 2)), np.arange(3)[None]), "triangles", Kind.WRONG_TYPE),
        (lambda: MeshedSection(np.zeros((5, 2)), np.arange(6)[None]), "triangles", Kind.OUT_OF_RANGE),
        (lambda: CircularSection(1e-3).series_impedance(0.0, AIR), "frequency", Kind.OUT_OF_RANGE),
    ],
)
def test_impossible_sections_are_refused_by_name(make, field, kind):
    with refused(kind, field):
        make()

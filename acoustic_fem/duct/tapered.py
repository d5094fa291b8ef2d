r"""Ducts whose section varies along the axis: finite elements in one dimension.

Find p with :math:`\int \frac{1}{Z'} p' v' + Y' p\, v\,dx = q_1 v(0) + q_2 v(L)` for every v, which is
d/dx (1/Z' dp/dx) = Y' p with the volume velocities q into the duct at its ends (Webster's equation with
losses). Z' and Y' are those of the local section, so the slope of the wall must be small: the neglected
terms are of the order of slope^2 (Kinsler et al., Fundamentals of Acoustics (2000), section 14.8, for the
lossless horn). Elements of degree 4 are condensed to their ends, then joined; all frequencies at once.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.polynomial.legendre import leggauss

from acoustic_fem.duct.plane_wave import Line
from acoustic_fem.quantities.checks import FrequencyLike, frequencies
from acoustic_fem.quantities.medium import Medium
from geometry.ground.argument_checks import check_range, check_shape, out_of_range, positive_numbers
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.ground.typed import Array, ComplexArray

#: Polynomial degree of the elements; the two-port converges with twice that order.
DEGREE = 4

_MAX_ELEMENTS = 4096


class TaperError(Refusal):
    """The two-port did not settle to the accuracy asked for."""


@dataclass(frozen=True, eq=False)
class TaperedTwoPort:
    """The two-port of a duct of varying section, and how far it has settled."""

    admittance: ComplexArray
    """Volume velocity into each end per pressure at each end, (n_freq, 2, 2) complex128, m^3/(Pa s)."""
    elements: int
    """Number of elements used for it."""
    error: float
    """Change at the last halving of the elements: of Y12 and of the row sums (the compliance, at low frequency), each
    relative to its own size.
    """


def port_admittance(
    section: Callable[[float], Line],
    length: float,
    frequency: FrequencyLike,
    medium: Medium,
    breaks: Sequence[float] = (),
    accuracy: float = 1e-9,
) -> ComplexArray:
    """The two-port of :func:`solve` alone; errors as there.

    Args:
        section: the line at a place x (m) from the first end, 0 < x < length.
        length: of the duct, m.
        frequency: (n_freq,) float64, Hz.
        medium: the gas.
        breaks: places (m) where the section jumps or has a kink, ascending.
        accuracy: of Y12 and of the row sums of the two-port, of one; 1e-12 to 0.1.

    Returns:
        (n_freq, 2, 2) complex128, m^3/(Pa s).
    """
    return solve(section, length, frequency, medium, breaks, accuracy).admittance


def solve(
    section: Callable[[float], Line],
    length: float,
    frequency: FrequencyLike,
    medium: Medium,
    breaks: Sequence[float] = (),
    accuracy: float = 1e-9,
) -> TaperedTwoPort:
    """Volume velocities into a duct of varying section per pressure at its ends.

    The elements are halved until the two-port changes by less than ``accuracy``.

    Args:
        section: the line at a place x (m) from the first end, 0 < x < length.
        length: of the duct, m.
        frequency: (n_freq,) float64, Hz.
        medium: the gas.
        breaks: places (m) where the section jumps or has a kink, ascending; element ends are put there.
        accuracy: of Y12 and of the row sums of the two-port, of one; 1e-12 to 0.1.

    Raises:
        Refusal: length, a frequency, a break or the accuracy out of range.
        TaperError: 4096 elements do not reach the accuracy (a break may be missing).
    """
    whole = float(positive_numbers("length", length, "m"))
    grid = np.atleast_1d(frequencies(frequency))
    check_shape("frequency", grid, ("n_freq",))
    check_range("accuracy", accuracy, 1e-12, 0.1)
    nodes = np.array([0.0, *breaks, whole])
    if not (np.diff(nodes) > 0).all():
        raise out_of_range("breaks", list(breaks), f"places in m that ascend between 0 and {whole:g} m")
    nodes = _halved(_halved(nodes))
    previous, error = None, np.inf
    while len(nodes) - 1 <= _MAX_ELEMENTS:
        circuit = assemble(section, nodes, grid, medium)
        if previous is not None:
            transfer, shunts = np.abs(circuit - previous)[0], np.abs(circuit - previous)[1:].max(axis=0)
            scales = np.abs(circuit[0]), np.abs(circuit[1:]).sum(axis=0)
            error = float(max((transfer / np.maximum(*scales)).max(), (shunts / scales[1]).max()))
            if error <= accuracy:
                own, far, other = circuit[0] + circuit[1], circuit[0] + circuit[2], -circuit[0]
                admittance = np.stack([np.stack([own, other], -1), np.stack([other, far], -1)], -2)
                return TaperedTwoPort(admittance, len(nodes) - 1, error)
        previous = circuit
        nodes = _halved(nodes)
    raise TaperError(
        f"{_MAX_ELEMENTS} elements leave a change of {error:.2g}, above the accuracy {accuracy:g}",
        kind=Kind.NO_RESULT,
        remedy=("give the places where the section jumps as ", Field("breaks")),
    )


def _halved(nodes: Array) -> Array:
    return np.sort(np.concatenate([nodes, (nodes[1:] + nodes[:-1]) / 2]))


def assemble(
    section: Callable[[float], Line], nodes: Array, frequency: Array, medium: Medium, degree: int = DEGREE
) -> ComplexArray:
    """The duct on given elements as a Pi circuit.

    Args:
        section: the line at a place (m) from the first end.
        nodes: (n_node,) float64, ends of the elements, ascending, m.
        frequency: (n_freq,) float64, Hz.
        medium: the gas.
        degree: of the elements.

    Returns:
        (3, n_freq) complex128, m^3/(Pa s): -Y12, Y11 + Y12 and Y22 + Y12.
    """
    points, weights = leggauss(degree + 2)
    values, slopes = _shapes(degree, points)
    steps = np.diff(nodes)
    places = nodes[:-1, None] + steps[:, None] * (points + 1) / 2
    lines = [section(float(x)) for x in places.ravel()]
    shape = (*places.shape, len(frequency))
    conductance = 1 / np.stack([line.series_impedance(frequency, medium) for line in lines]).reshape(shape)
    shunt = np.stack([line.shunt_admittance(frequency, medium) for line in lines]).reshape(shape)
    # (n_freq, n_element, degree + 1, degree + 1)
    stiffness = np.einsum("eqf,qij,e->feij", conductance, _products(slopes, 2 * weights), 1 / steps)
    storage = np.einsum("eqf,qij,e->feij", shunt, _products(values, weights / 2), steps)
    return _joined(_condensed(stiffness + storage, storage.sum(axis=-1)))


def _products(functions: Array, weights: Array) -> Array:
    """Weighted products of pairs of shape functions, (n_point, degree + 1, degree + 1)."""
    return functions[:, :, None] * functions[:, None, :] * weights[:, None, None]


def _condensed(element: ComplexArray, uniform: ComplexArray) -> ComplexArray:
    """Elements with their inner unknowns eliminated, as Pi circuits: (3, n_freq, n_element).

    A transfer -Y12 and the shunts Y11 + Y12, Y22 + Y12, which are the response to a uniform pressure: taken
    from what the elements store then (``uniform``), they are not lost as differences of large conductances.
    """
    ends, inner = element[..., [0, -1], :], element[..., 1:-1, 1:-1]
    coupling = ends[..., 1:-1]
    transfer, shunt = -ends[..., 0, -1], uniform[..., [0, -1]]
    if inner.shape[-1]:
        right = np.concatenate([coupling.swapaxes(-1, -2), uniform[..., 1:-1, None]], axis=-1)
        moved = coupling @ np.linalg.solve(inner, right)
        transfer, shunt = transfer + moved[..., 0, 1], shunt - moved[..., 2]
    return np.stack([transfer, shunt[..., 0], shunt[..., 1]])


def _joined(chain: ComplexArray) -> ComplexArray:
    """Pi circuits (3, n_freq, n) in a row joined into one, neighbours first: (3, n_freq)."""
    while chain.shape[-1] > 1:
        odd = chain[..., -1:] if chain.shape[-1] % 2 else chain[..., :0]
        pairs = chain[..., : chain.shape[-1] // 2 * 2]
        (t, first, near), (u, far, last) = pairs[..., ::2], pairs[..., 1::2]
        middle = near + far
        between = t + u + middle
        chain = np.concatenate(
            [np.stack([t * u / between, first + t * middle / between, last + u * middle / between]), odd], axis=-1
        )
    return chain[..., 0]


def _shapes(degree: int, points: Array) -> tuple[Array, Array]:
    """Lagrange polynomials on equal steps of [-1, 1], first and last at the ends, and slopes: (n_point, degree+1)."""
    nodes = np.linspace(-1, 1, degree + 1)
    to_powers = np.linalg.inv(np.vander(nodes, increasing=True))
    powers = np.vander(points, degree + 1, increasing=True)
    slopes = np.zeros_like(powers)
    slopes[:, 1:] = powers[:, :-1] * np.arange(1, degree + 1)
    return powers @ to_powers, slopes @ to_powers

"""Score that ranks designs by how often points of as-built sensors are confused, with slopes.

A sensor that nobody calibrated differs from its library by the deviations of its parts. To first order these move the
logarithms of the ratios of microphones by a Gaussian with covariance S = J J^T + noise; J is had from differences, one
sensor with one part off for each column, whose parts are computed once for all of them. Two points i and j differ by
D_ij, the logarithm of the ratio of their ratios. A decoder that goes by the nominal design weighs each frequency and
pair of microphones by the pressures that it has there, |H_a|^2 |H_b|^2 over the sum of all |H|^2, which is what is left
of a frame besides the direction of its own point. Its score falls short of the decision by half of D.W.D, with the
standard deviation sqrt(W D.S.W D), so that j is the likelier with probability

    e_ij = erfc(d / sqrt 8) / 2,    d = D.W.D / sqrt(W D.S.W D).

All pairs count: neighbours alone make arrays in which points far apart are taken for each other.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields
from operator import itemgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.batch.elements import Conditions, Points, chambers, points, tubes
from acoustic_fem.batch.network import join_parts
from acoustic_fem.batch.numpy_or_torch import namespace
from acoustic_fem.batch.one_part_off import PartsOff, one_part_off
from acoustic_fem.batch.parameters import PART, ArrayParameters
from acoustic_fem.batch.topology import Topology
from acoustic_fem.membrane.disc import KnownDiscs
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.scatter.tolerances import UNCALIBRATED
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import value_of
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from geometry.schema.array_fields import Air
from geometry.schema.field_errors import DesignError
from geometry.schema.part_fields import Microphone
from localize.signals.noise_model import microphone_noise

FREQUENCIES = np.geomspace(1.5, 90.0, 8)
"""Hz, at which responses are compared."""
UNKNOWN = 0.02
"""Uncertainty of a ratio that always remains, nepers and radians."""
WORST = 0.2
"""Exponent of the worst pairs, by their mean fourth power, beside the mean of all."""
TOUCH_LEVEL, BINS = 0.25, 25
"""Level of the touches that noise is compared with, Pa rms, flat from 1 to 100 Hz; and how many independent values a
frame of 250 ms has in that band."""
#: Deviation of each part, a fraction.
_DEVIATIONS = {each.quantity: each.deviation for each in UNCALIBRATED}
#: Values of sensors worked on at once (designs x sensors x points x frequencies).
_CHUNK = 100_000
#: Step by which a field of the design is changed for a slope, as a fraction.
_STEP = 1e-3


def scatter_detection(
    designs: Sequence[ArrayDesign], known: KnownDiscs | None = None, parameters: ArrayParameters | None = None
) -> Array:
    """Predicted ranking score under scatter of each design.

    Args:
        designs: the arrays.
        known: membranes that need not be solved.
        parameters: numbers of the designs, where they are known already.

    Returns:
        (n_design,) float64: the error of a point over all others, mean over the points, to the power 1 / 1.2, by that
        of the worst pairs to the power 0.2 / 1.2.

    Raises:
        Refusal: fewer than two points or microphones, a cavity that is not a cylinder, or a pre-stretched membrane with
            loss.
    """
    alike: dict[tuple[Topology, Air], list[int]] = {}
    for number, design in enumerate(designs):
        alike.setdefault((Topology.of(design), design.air), []).append(number)
    found = np.empty(len(designs))
    for (topology, _), numbers in alike.items():
        own = [designs[number] for number in numbers]
        if parameters is None:
            numbers_of_own = ArrayParameters.from_designs(own, known=known)
        else:
            numbers_of_own = parameters.map(itemgetter(numbers))
        found[numbers] = np.exp(_logarithms(topology, numbers_of_own, design_air(own[0]), _noise(own)))
    return found


def scatter_slopes(design: ArrayDesign, names: Sequence[str], known: KnownDiscs | None = None) -> tuple[float, Array]:
    """The logarithm of :func:`scatter_detection`, and its derivatives by the logarithms of fields of the design.

    Derivatives by the numbers of the lumped batch are exact; of these by the fields they are central differences, or
    one-sided ones at the end of what a design may have.

    Args:
        design: the array.
        names: dotted names of fields that are lengths above 0 or moduli.
        known: as for :func:`scatter_detection`.

    Returns:
        The logarithm, and (n_name,) float64.

    Raises:
        Refusal: as :func:`scatter_detection`.
    """
    parameters = _parameters(design, known)
    followed = parameters.tensors(requires_grad=True)
    found = _logarithms(Topology.of(design), followed, design_air(design), _noise([design]))[0]
    found.backward()
    slopes = []
    for name in names:
        ends = [_changed(design, name, factor, parameters, known) for factor in (1 + _STEP, 1 - _STEP)]
        width = sum(end is not parameters for end in ends) * _STEP
        rise = 0.0
        for field in fields(followed):
            own = getattr(followed, field.name).grad
            if own is not None:
                rise += float((own.numpy() * (getattr(ends[0], field.name) - getattr(ends[1], field.name))).sum())
        slopes.append(rise / width if width else 0.0)
    return float(found.detach()), np.array(slopes)


def _parameters(design: ArrayDesign, known: KnownDiscs | None) -> ArrayParameters:
    return ArrayParameters.from_design(design, known=known)


def _changed(
    design: ArrayDesign, name: str, factor: float, parameters: ArrayParameters, known: KnownDiscs | None
) -> ArrayParameters:
    """The numbers with a field changed; those given where no design may have that."""
    try:
        return _parameters(design.with_values({name: value_of(design, name) * factor}), known)
    except DesignError:
        return parameters


def _logarithms(topology: Topology, parameters: ArrayParameters, air: Medium, noise: Array) -> Any:
    """Logarithms of the scores, (n_design,), from arrays or tensors in the columns of the topology.

    Args:
        topology: the wiring of all designs.
        parameters: of the designs.
        air: of all designs.
        noise: (n_design, n_freq), that of :func:`_noise`.
    """
    count = topology.point_count
    if count < 2:
        allowed = "at least 2, because one point alone is never confused"
        raise Refusal(kind=Kind.UNSUITABLE, field="lines.0.points", value=count, allowed=allowed)
    xp = parameters.namespace
    parts, designed = _parts(parameters, air)
    step = max(1, _CHUNK // ((4 * count + 3) * count * len(FREQUENCIES)))
    with np.errstate(divide="ignore"):  # where nothing is confused
        pieces = [
            _of_responses(
                *_responses(topology, parts, designed, slice(first, first + step)), noise[first : first + step]
            )
            for first in range(0, len(noise), step)
        ]
    return xp.concatenate(pieces)


def _parts(nominal: ArrayParameters, air: Medium) -> tuple[PartsOff, Points]:
    """Parts as designed and with each of their deviations, and the points as designed."""
    xp = nominal.namespace
    columns = {"tube": 2, "point": 4, "microphone": 2}
    wide: dict[str, Any] = {}
    for field in fields(nominal):
        values = getattr(nominal, field.name)
        wide[field.name] = xp.concatenate([values] * columns[PART[field.name]], 1)

    def factors(name: str, *deviations: str | None) -> Any:
        size = getattr(nominal, name).shape[1]
        one = [1 + _DEVIATIONS[each] if each else 1.0 for each in deviations]
        return xp.asarray(np.repeat(one, size)[None])

    modulus = factors("cavity_height", None, None, "modulus_of_part", "modulus_of_batch")
    wide["tube_radius"] = wide["tube_radius"] * factors("tube_radius", None, "bore")
    wide["cavity_height"] = wide["cavity_height"] * factors("cavity_height", None, "cavity_height", None, None)
    wide["membrane_compliance"] = wide["membrane_compliance"] / modulus
    wide["membrane_frequency"] = wide["membrane_frequency"] * xp.sqrt(modulus)[..., None]
    wide["chamber_height"] = wide["chamber_height"] * factors("chamber_height", None, "chamber_height")
    made = ArrayParameters(**wide)
    conditions = Conditions.of(xp.asarray(2 * np.pi * FREQUENCIES), air)
    tube, point, chamber = tubes(made, conditions), points(made, conditions), chambers(made, conditions)

    def groups(part: Any, count: int) -> Any:
        """The parts as designed, then with each deviation."""
        size = part[0].shape[1] // count
        return tuple(
            type(part)(*(None if values is None else values[:, start : start + size] for values in part))
            for start in range(0, size * count, size)
        )

    of_points = groups(point, columns["point"])
    shunts = tuple(each.shunt for each in of_points)
    return PartsOff(groups(tube, columns["tube"]), shunts, groups(chamber, columns["microphone"])), of_points[0]


def _responses(topology: Topology, parts: PartsOff, designed: Points, own: slice) -> tuple[Any, Any]:
    """Transfer functions of some designs, (n_design, n_point, n_microphone, n_freq), and what their sensors hear."""

    def cut(part: Any) -> Any:
        return type(part)(*(None if values is None else values[own] for values in part))

    tube, chamber = (tuple(cut(each) for each in both) for both in (parts.tubes, parts.chambers))
    off = PartsOff(tube, tuple(shunt[own] for shunt in parts.shunts), chamber)
    nominal = join_parts(topology, tube[0], cut(designed), chamber[0], len(off.shunts[0]))
    return nominal.transfer_function, one_part_off(topology, off)


def _of_responses(h: Any, heard: Sequence[Any], noise: Array) -> Any:
    """Logarithms of the scores, (n_design,).

    Args:
        h: (n_design, n_point, n_microphone, n_freq), those of :func:`_responses`.
        heard: what its sensors hear, as :func:`acoustic_fem.batch.one_part_off.one_part_off` has it.
        noise: (n_design, n_freq).
    """
    xp = namespace(h)
    first, second = np.triu_indices(h.shape[2], 1)
    ratio = xp.stack([heard[a] / heard[b] for a, b in zip(first.tolist(), second.tolist(), strict=True)], 3)
    power = h.real**2 + h.imag**2
    weight = power[:, :, first] * power[:, :, second] / power.sum(2)[:, :, None]
    unknown = UNKNOWN**2 + xp.asarray(noise)[:, None, None] * (1 / power[:, :, first] + 1 / power[:, :, second])
    weight, unknown = (xp.concatenate([values, values], -1)[:, :, None] for values in (weight, unknown))
    # of logarithms real and imaginary parts, one after the other in the last axis
    apart = _logarithm_of(ratio[:, :1] / ratio[:, 0][:, :, None])  # from the row's point to the column's
    weighed = weight * apart
    gains = xp.asarray(_of_gains(first, second))[None, :, None]
    gains = xp.broadcast_to(gains, (len(h), len(gains[0]), *apart.shape[2:]))
    jacobian = xp.concatenate([_logarithm_of(ratio[:, 1:] / ratio[:, :1]), gains], 1)
    seen, moves = (values.reshape(*values.shape[:3], -1) for values in (weighed, jacobian))
    moved = seen @ xp.moveaxis(moves, 1, 3)
    spread = (moved * moved).sum(-1) + (weighed * weighed * unknown).sum((3, 4))
    distance = (weighed * apart).sum((3, 4))
    others = ~np.eye(h.shape[1], dtype=bool)
    argument = distance[:, others] / xp.sqrt(8 * spread[:, others])
    if xp is np:
        from scipy.special import erfc
    else:
        erfc = xp.special.erfc
    error = erfc(argument).reshape(len(h), h.shape[1], -1) / 2
    mean, worst = error.sum(2).mean(1), (error**4).sum(2).mean(1) ** 0.25
    return (xp.log(mean) + WORST * xp.log(worst)) / (1 + WORST)


def _logarithm_of(values: Any) -> Any:
    """Real and imaginary parts of logarithms, (..., 2 n_freq); ten times as fast as the complex function of NumPy."""
    xp = namespace(values)
    real, imaginary = values.real, values.imag
    return xp.concatenate([xp.log(real * real + imaginary * imaginary) / 2, xp.arctan2(imaginary, real)], -1)


def _of_gains(first: NDArray[np.intp], second: NDArray[np.intp]) -> Array:
    """Derivatives of the logarithms of ratios by the gain of each microphone, (n_microphone, n_pair, 2 n_freq)."""
    moved = np.zeros((int(second.max()) + 1, len(first), 2 * len(FREQUENCIES)))
    pairs, count = np.arange(len(first)), len(FREQUENCIES)
    moved[first, pairs, :count] = _DEVIATIONS["microphone_gain"]
    moved[second, pairs, :count] = -_DEVIATIONS["microphone_gain"]
    return moved


def _noise(designs: Sequence[ArrayDesign]) -> Array:
    """Mean square of the noise of a microphone, per real value of a ratio, by that of the touch in its cavity.

    (n_design, n_freq); all designs in the same air.
    """
    found: dict[Microphone, Array] = {}
    for design in designs:
        if design.microphone not in found:
            power = microphone_noise(design.microphone, design_air(design)).power
            level = np.interp(FREQUENCIES, np.arange(len(power)), power) / (TOUCH_LEVEL**2 / 99.0)
            found[design.microphone] = level / 2 / (BINS / len(FREQUENCIES))
    return np.stack([found[design.microphone] for design in designs])

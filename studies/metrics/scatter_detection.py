"""How often neighbours, and all others, will be named in place of the touched point of a mis-made sensor: with slopes.

A sensor that nobody calibrated differs from its library by the deviations of its parts. To first order these move the
logarithms of the ratios of microphones by a Gaussian with covariance S = J J^T + noise; J is had from differences, one
design with one part off for each column, all in one call of the lumped batch. Two points i and j differ by D_ij, the
logarithm of the ratio of their ratios. A decoder that goes by the nominal design weighs each frequency and pair of
microphones by the pressures that it has there, |H_a|^2 |H_b|^2 over the sum of all |H|^2, which is what is left of a
frame besides the direction of its own point. Its score falls short of the decision by half of D.W.D, with the standard
deviation sqrt(W D.S.W D), so that j is the likelier with probability

    e_ij = erfc(d / sqrt 8) / 2,    d = D.W.D / sqrt(W D.S.W D).

All pairs count: neighbours alone make arrays in which points far apart are taken for each other.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import fields, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.batch.topology import Topology
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter.tolerances import UNCALIBRATED
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import value_of
from geometry.refusal import Refusal
from geometry.stated.fields import DesignError

if TYPE_CHECKING:
    from torch import Tensor

    from acoustic_fem.membrane.disc import KnownDiscs

Array = NDArray[np.float64]

FREQUENCIES = np.geomspace(1.5, 90.0, 8)
"""Hz, at which responses are compared."""
UNKNOWN = 0.02
"""What is never known of a ratio, nepers and radians."""
WORST = 0.2
"""Exponent of the worst pairs, by their mean fourth power, beside the mean of all."""
TOUCH_LEVEL, BINS = 0.25, 25
"""Level of the touches that noise is compared with, Pa rms, flat from 1 to 100 Hz; and how many independent values a
frame of 250 ms has in that band."""
#: Deviation of each part, a fraction.
_DEVIATIONS = {each.quantity: each.deviation for each in UNCALIBRATED}
#: Step by which a field of the design is changed for a slope, as a fraction.
_STEP = 1e-3


def scatter_detection(designs: Sequence[ArrayDesign], known: KnownDiscs | None = None) -> Array:
    """Predicted error under scatter of each design.

    Args:
        designs: the arrays.
        known: membranes that need not be solved.

    Returns:
        (n_design,) float64: the error of a point over all others, mean over the points, to the power 1 / 1.2, by that
        of the worst pairs to the power 0.2 / 1.2.

    Raises:
        Refusal: fewer than two points or microphones, a cavity that is no cylinder, or a pre-stretched membrane with
            loss.
    """
    import torch

    with torch.no_grad():
        return np.array(
            [math.exp(float(_logarithm(design, _parameters(design, known).tensors()))) for design in designs]
        )


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
    found = _logarithm(design, followed)
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


def _logarithm(design: ArrayDesign, parameters: ArrayParameters) -> Tensor:
    """Logarithm of the predicted error, from tensors of one design in the columns of its topology."""
    import torch

    shared = Topology.of(design)
    if shared.point_count < 2:
        raise Refusal(f"lines.0.points = {shared.point_count} must be at least 2: of one point nothing is confused")
    made = _made(parameters.individual(shared))
    h = batch_transfer_function(made, shared.individual(), FREQUENCIES, design_air(design))
    first, second = np.triu_indices(len(shared.microphones), 1)
    ratio = h[:, :, first] / h[:, :, second]  # (design, point, pair, frequency)
    power = h[0].real ** 2 + h[0].imag ** 2
    weight = power[:, first] * power[:, second] / power.sum(1, keepdim=True)
    apart = torch.log(ratio[0][None] / ratio[0][:, None])  # from the row's point to the column's
    weighed = weight[:, None] * apart
    jacobian = torch.cat([torch.log(ratio[1:] / ratio[:1]), _of_gains(ratio[0], first, second)])

    def joined(values: Tensor) -> Tensor:
        return torch.cat([values.real.flatten(2), values.imag.flatten(2)], -1)

    moved = joined(weighed) @ joined(jacobian).permute(1, 2, 0)
    unknown = UNKNOWN**2 + _noise(design) * (1 / power[:, first] + 1 / power[:, second])
    spread = moved.square().sum(-1) + ((weighed.real**2 + weighed.imag**2) * unknown[:, None]).sum((2, 3))
    distance = (weighed.real * apart.real + weighed.imag * apart.imag).sum((2, 3))
    others = ~torch.eye(len(distance), dtype=torch.bool)
    error = torch.erfc(distance[others] / torch.sqrt(8 * spread[others])).reshape(len(distance), -1) / 2
    mean, worst = error.sum(1).mean(), (error**4).sum(1).mean() ** 0.25
    return (torch.log(mean) + WORST * torch.log(worst)) / (1 + WORST)


def _made(nominal: ArrayParameters) -> ArrayParameters:
    """The nominal sensor, and one for each part with that part one deviation off: tensors, one row each."""
    import torch

    tubes, points, chambers = (
        getattr(nominal, name).shape[1] for name in ("tube_radius", "cavity_height", "chamber_height")
    )
    sizes = {"bore": tubes, "cavity_height": points, "modulus_of_part": points, "chamber_height": chambers}
    count = 2 + sum(sizes.values())
    factors: dict[str, Tensor] = {}
    row = 1
    for quantity, size in sizes.items():
        factor = torch.ones(count, size, dtype=torch.float64)
        factor[row : row + size].fill_diagonal_(1 + _DEVIATIONS[quantity])
        factors[quantity] = factor
        row += size
    modulus = factors["modulus_of_part"]
    modulus[row] = 1 + _DEVIATIONS["modulus_of_batch"]
    return replace(
        nominal,
        tube_radius=nominal.tube_radius * factors["bore"],
        cavity_height=nominal.cavity_height * factors["cavity_height"],
        membrane_compliance=nominal.membrane_compliance / modulus,
        membrane_frequency=nominal.membrane_frequency * torch.sqrt(modulus)[..., None],
        chamber_height=nominal.chamber_height * factors["chamber_height"],
    )


def _of_gains(ratio: Tensor, first: NDArray[np.intp], second: NDArray[np.intp]) -> Tensor:
    """What the gain of each microphone changes of the logarithms of ratios, shaped as these behind the microphone."""
    import torch

    moved = torch.zeros(int(second.max()) + 1, *ratio.shape, dtype=ratio.dtype)
    for pair, (a, b) in enumerate(zip(first, second, strict=True)):
        moved[a, :, pair] += _DEVIATIONS["microphone_gain"]
        moved[b, :, pair] -= _DEVIATIONS["microphone_gain"]
    return moved


def _noise(design: ArrayDesign) -> Tensor:
    """Mean square of the noise of a microphone, per real value of a ratio, by that of the touch in its cavity."""
    import torch

    from localize.signals.noise import microphone_noise

    power = microphone_noise(design.microphone, design_air(design)).power
    level = np.interp(FREQUENCIES, np.arange(len(power)), power) / (TOUCH_LEVEL**2 / 99.0)
    return torch.from_numpy(level / 2 / (BINS / len(FREQUENCIES)))

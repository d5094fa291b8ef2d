"""The lumped array on torch tensors: figures of merit with derivatives by the lengths of a design.

The figures are smooth stand-ins: a p-norm takes the place of a minimum.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import fields
from itertools import combinations, product
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.batch.parameters import ArrayParameters, design_air
from acoustic_fem.batch.topology import Topology
from acoustic_fem.quantities.units import metres
from studies.metrics.pairs import BAND, DECIBEL, trapezoidal_weights

if TYPE_CHECKING:
    from torch import Tensor

    from acoustic_fem.membrane.elasticity import ElasticDisc
    from geometry import ArrayDesign

#: A minimum of many becomes a p-norm with -p: 66 equal distances come out 30 % too small, one alone exactly.
_HARDNESS = 12.0
#: Fields of a design with their column of :class:`ArrayParameters` and what they are divided by.
_POINT = {"resonator.cavity_diameter": ("cavity_radius", 2), "resonator.cavity_height": ("cavity_height", 1)}
_CHAMBER = {
    "microphone.chamber_diameter": ("chamber_radius", 2),
    "microphone.chamber_height": ("chamber_height", 1),
    "microphone.sound_hole_diameter": ("hole_radius", 2),
    "microphone.sound_hole_length": ("hole_length", 1),
}
_DISC = ("resonator.cavity_diameter", "membrane.thickness", "membrane.rim_width")


#: Metrics with a smooth stand-in.
DIFFERENTIABLE = (
    *("distance_smallest", "distance_mean", "ild_smallest", "ild_mean", "ipd_smallest", "ipd_mean"),
    "sensitivity_force",
)


class SmoothDiscs:
    """Membranes of one material and mounting for any size in a range: Chebyshev polynomials through exact solutions.

    Args:
        design: gives material and mounting.
        thickness: smallest and largest ratio of thickness to radius of the opening.
        rim: the same of the rim's width; not used for clamped membranes.
        nodes: exact solutions along each of the two.
    """

    def __init__(
        self,
        design: ArrayDesign,
        thickness: tuple[float, float],
        rim: tuple[float, float],
        nodes: tuple[int, int] = (6, 4),
    ) -> None:
        import torch

        from acoustic_fem.membrane.disc import solve_disc

        material = design.material(design.membrane.material)
        self._axes = [(math.log(thickness[0]), math.log(thickness[1])), rim]
        counts = [nodes[0] if thickness[1] > thickness[0] else 1, nodes[1] if rim[1] > rim[0] else 1]
        if design.membrane.mounting == "clamped":
            self._axes[1], counts[1] = (0.0, 0.0), 1
        at = [
            (low + high) / 2 + (high - low) / 2 * np.cos(np.pi * (np.arange(count) + 0.5) / count)
            for (low, high), count in zip(self._axes, counts, strict=True)
        ]
        rows = []
        for ratio, width in product(np.exp(at[0]), at[1]):
            disc: ElasticDisc = solve_disc(1.0, ratio, 1.0, material.poisson_ratio, width, 1.0).model
            share = disc.swept**2 / disc.eigenvalues
            logs = [math.log(share.sum()), math.log(disc.volume_per_force), *np.log(disc.eigenvalues)]
            rows.append([*logs, *(share / share.sum())])
        self._counts = counts
        self._modes = (len(rows[0]) - 2) // 2
        basis = np.kron(*(np.polynomial.chebyshev.chebvander(_unit(a, axis), count - 1)
                          for a, axis, count in zip(at, self._axes, counts, strict=True)))  # fmt: skip
        self._coefficients = torch.from_numpy(np.linalg.solve(basis, np.array(rows)))
        self._modulus = material.youngs_modulus * 1e6
        self._density = material.density

    def __call__(self, radius: Tensor, thickness: Tensor, rim: Tensor) -> dict[str, Tensor]:
        """Parameters ``membrane_*`` of :class:`ArrayParameters` and volume per force of discs.

        Args:
            radius: (n,) of the opening, m.
            thickness: (n,) m.
            rim: (n,) width of the rim, m; not used for clamped membranes.

        Returns:
            By name: ``membrane_compliance`` (n, 1), m^3/Pa; ``membrane_share`` (n, 1, n_mode); ``membrane_frequency``
            (n, 1, n_mode), Hz; ``volume_per_force`` (n,), m^3/N.
        """
        import torch

        ratios = (torch.log(thickness / radius), rim / radius)
        basis = [
            torch.stack(_chebyshev(_unit(ratio, axis), count), dim=-1)
            for ratio, axis, count in zip(ratios, self._axes, self._counts, strict=True)
        ]
        values = (basis[0][:, :, None] * basis[1][:, None, :]).flatten(1) @ self._coefficients
        eigenvalues = torch.exp(values[:, 2 : 2 + self._modes])
        share = values[:, 2 + self._modes :].clamp(min=0)  # of high modes nearly zero, where polynomials swing
        frequency = torch.sqrt(eigenvalues * (self._modulus / self._density)) / (2 * math.pi * radius[:, None])
        return {
            "membrane_compliance": (torch.exp(values[:, 0]) * radius**3 / self._modulus)[:, None],
            "membrane_share": (share / share.sum(1, keepdim=True))[:, None],
            "membrane_frequency": frequency[:, None],
            "volume_per_force": torch.exp(values[:, 1]) * radius / self._modulus,
        }


def _unit(value: Any, axis: tuple[float, float]) -> Any:
    """The range to -1 to 1; a range of no width to 0."""
    low, high = axis
    return (2 * value - low - high) / (high - low) if high > low else 0 * value


def _chebyshev(x: Tensor, count: int) -> list[Tensor]:
    terms = [x * 0 + 1, x]
    while len(terms) < count:
        terms.append(2 * x * terms[-1] - terms[-2])
    return terms[:count]


class SmoothModel:
    """Lumped array as a function of some fields of its design, with derivatives.

    Args:
        design: gives everything else.
        names: fields, in millimetres; others than these change nothing acoustic or are not continuous.
        ranges: (n_name, 2) float64, lowest and highest value of each, mm.
        frequency: (n_freq,) float64, Hz, at least two of them in the band.
    """

    def __init__(
        self, design: ArrayDesign, names: Sequence[str], ranges: NDArray[np.float64], frequency: NDArray[np.float64]
    ) -> None:
        import torch

        self.names, self._design = tuple(names), design
        self._topology, self._medium = Topology.of(design), design_air(design)
        self._base = ArrayParameters.from_design(design).tensors()
        inside = (frequency >= BAND[0] - 1e-9) & (frequency <= BAND[1] + 1e-9)
        self._frequency = frequency[inside]
        self._weight = torch.from_numpy(trapezoidal_weights(self._frequency))
        now = [design.resonator.cavity_diameter, design.membrane.thickness, design.membrane.rim_width]
        spans = [
            tuple(ranges[self.names.index(name)]) if name in self.names else (value, value)
            for name, value in zip(_DISC, now, strict=True)
        ]
        (small, wide), *others = spans
        thickness, rim = ((2 * low / wide, 2 * high / small) for low, high in others)
        within = (max(thickness[0], 0.01), min(thickness[1], 2.0))
        self._discs = SmoothDiscs(design, within, (max(rim[0], 0.05 * within[0]), rim[1]))
        self._now = dict(zip(_DISC, now, strict=True))
        self._loss = design.material(design.membrane.material).loss_factor

    @staticmethod
    def knows(name: str, design: ArrayDesign) -> bool:
        """Whether the figures have a derivative by this field."""
        tube, _, field = name.rpartition(".")
        in_tube = field in ("length", "inner_diameter") and tube in Topology.of(design).tube_names
        return name in _POINT or name in _CHAMBER or name in _DISC or in_tube

    def parameters(self, values: Tensor) -> tuple[ArrayParameters, Tensor]:
        """Parameters of the network and the volume per force.

        Args:
            values: (n_design, n_name), mm.

        Returns:
            The parameters, and (n_design,) float64, m^3/N.
        """
        import torch

        count = len(values)
        given = {name: values[:, k] * 1e-3 for k, name in enumerate(self.names)}
        named = {field.name: getattr(self._base, field.name) for field in fields(ArrayParameters)}
        named = {key: value.expand(count, *value.shape[1:]) for key, value in named.items()}
        for name, value in given.items():
            tube, _, field = name.rpartition(".")
            if name in _POINT or name in _CHAMBER:
                key, divisor = (_POINT | _CHAMBER)[name]
                named[key] = (value / divisor)[:, None].expand_as(named[key])
            elif tube in self._topology.tube_names:
                key = "tube_length" if field == "length" else "tube_radius"
                column = self._topology.tube_names.index(tube)
                columns = list(named[key].unbind(1))
                columns[column] = value if field == "length" else value / 2
                named[key] = torch.stack(columns, 1)
        disc = [given.get(name, torch.full((count,), metres(self._now[name]), dtype=torch.float64)) for name in _DISC]
        membrane = self._discs(disc[0] / 2, disc[1], disc[2])
        per_force = membrane.pop("volume_per_force")
        return ArrayParameters(**(named | membrane)), per_force

    def figures(self, values: Tensor) -> dict[str, Tensor]:
        """Figures of merit, all of :data:`DIFFERENTIABLE`.

        Args:
            values: (n_design, n_name), mm.

        Returns:
            By name (n_design,) float64, in the unit of the metric.
        """
        import torch

        from acoustic_fem.batch.network import batch_response

        parameters, per_force = self.parameters(values)
        response = batch_response(parameters, self._topology, self._frequency, self._medium)
        log = torch.log(response.transfer_function)
        pairs = list(combinations(range(log.shape[2]), 2))
        level = phase = torch.zeros(1, dtype=torch.float64)
        first, second = np.triu_indices(log.shape[1], 1)
        for a, b in pairs:
            ratio = log[:, :, a] - log[:, :, b]
            difference = ratio[:, first] - ratio[:, second]
            turn = difference.imag - 2 * math.pi * torch.round(difference.imag / (2 * math.pi)).detach()
            level = level + difference.real**2 @ self._weight / len(pairs)
            phase = phase + turn**2 @ self._weight / len(pairs)
        figures: dict[str, Tensor] = {}
        for name, squared, unit in (
            ("distance", level + phase, 1.0),
            ("ild", level, DECIBEL),
            ("ipd", phase, 180 / math.pi),
        ):
            distance = torch.sqrt(squared + 1e-24) * unit
            figures |= {f"{name}_smallest": _softmin(distance), f"{name}_mean": distance.mean(1)}
        omega = torch.from_numpy(2 * math.pi * self._frequency)
        pressure = (
            torch.abs(response.source_response) * omega * (per_force / math.hypot(1, self._loss))[:, None, None, None]
        )
        rms = torch.sqrt((pressure**2 @ self._weight).amax(2))
        return figures | {"sensitivity_force": _softmin(rms)}


def _softmin(values: Tensor) -> Tensor:
    """A smooth minimum over the last axis: p-norm with p = -12 of values above zero."""
    import torch

    return torch.exp(-torch.logsumexp(-_HARDNESS * torch.log(values), -1) / _HARDNESS)

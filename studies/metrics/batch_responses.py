"""Input of the metrics: the responses of a batch of designs of one topology, and the designs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from acoustic_fem import Medium
from geometry import ArrayDesign
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import ComplexArray

if TYPE_CHECKING:
    from acoustic_fem import Library
    from acoustic_fem.batch.parameters import ArrayParameters
    from acoustic_fem.membrane.disc import KnownDiscs

_T = TypeVar("_T")


@dataclass(frozen=True, eq=False)
class Responses:
    """Responses of several designs with equally many points and microphones; what is None is not known.

    Shapes are checked against the transfer function.
    """

    frequency: NDArray[np.float64]
    """Frequencies, ascending; (n_freq,) float64, Hz."""
    transfer_function: ComplexArray
    """Pressure at a microphone over pressure in the touched cavity; (n_design, n_point, n_microphone, n_freq)
    complex128, Pa/Pa."""
    designs: Sequence[ArrayDesign] | None = None
    """Designs, one for each of the first axis."""
    medium: Sequence[Medium] | None = None
    """Air of each design."""
    source_response: ComplexArray | None = None
    """Pressure at a microphone per volume velocity injected at a point; (n_design, n_point, n_microphone, n_freq)
    complex128, Pa s/m^3."""
    point_impedance: ComplexArray | None = None
    """Pressure in a cavity per volume velocity injected there; (n_design, n_point, n_freq) complex128, Pa s/m^3."""
    microphone_impedance: ComplexArray | None = None
    """Pressure at a microphone per volume velocity injected at a microphone; (n_design, n_microphone, n_microphone,
    n_freq) complex128, Pa s/m^3."""
    discs: KnownDiscs | None = None
    """Membranes that need not be solved."""
    parameters: ArrayParameters | None = None
    """Numbers of all designs, where they were computed as a batch."""

    def __post_init__(self) -> None:
        h = self.transfer_function
        if h.ndim != 4 or h.shape[3] != len(self.frequency):
            raise shape_error("transfer_function", h, f"(n_design, n_point, n_microphone, {len(self.frequency)})")
        designs, points, microphones, count = h.shape
        for name, shape in (
            ("source_response", h.shape),
            ("point_impedance", (designs, points, count)),
            ("microphone_impedance", (designs, microphones, microphones, count)),
        ):
            values = getattr(self, name)
            if values is not None and values.shape != shape:
                raise shape_error(name, values, str(shape))
        for name in ("designs", "medium"):
            given = getattr(self, name)
            if given is not None and len(given) != designs:
                problem = f"has {counted(len(given), 'entry')} for {counted(designs, 'design')}"
                raise Refusal(problem, kind=Kind.MISMATCH, field=name, remedy="give one for each design")

    @property
    def design_count(self) -> int:
        """Number of designs."""
        return len(self.transfer_function)

    @classmethod
    def of_library(cls, library: Library) -> Responses:
        """Responses of one design: all that its library holds."""
        order = ("point", "microphone", "frequency")
        mutual = library.microphone_impedance
        return cls(
            frequency=np.asarray(library.frequency, np.float64),
            transfer_function=_one(library.transfer_function.transpose(*order).values),
            designs=(library.design,),
            medium=(library.medium,),
            source_response=_one(library.source_response.transpose(*order).values),
            point_impedance=_one(library.point_impedance.transpose("point", "frequency").values),
            microphone_impedance=None
            if mutual is None
            else _one(mutual.transpose("microphone", "microphone_2", "frequency").values),
        )


def shape_error(name: str, values: NDArray[Any], wanted: str) -> Refusal:
    """The error of an array of another shape than is wanted."""
    return Refusal(f"has shape {values.shape}; it must be {wanted}", kind=Kind.WRONG_TYPE, field=name)


def required(values: _T | None) -> _T:
    """The values, which :attr:`studies.study.metric_registry.Metric.needs` has made sure of."""
    assert values is not None
    return values


def _one(values: ComplexArray) -> ComplexArray:
    return np.asarray(values, np.complex128)[None]

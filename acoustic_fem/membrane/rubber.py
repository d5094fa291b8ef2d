"""The complex modulus of silicone rubber over frequency: the one place that evaluates it, for every solver.

A material whose loss factor is the same at all frequencies must stiffen with frequency: storage and loss modulus are
two faces of one relaxation (Kramers-Kronig; R. L. Bagley and P. J. Torvik, "A theoretical basis for the application of
fractional calculus to viscoelasticity", J. Rheol. 27 (1983) 201). The element that does so is the spring-pot,

    E*(f) = E (1 + j eta) (f / f_0)^alpha,    alpha = (2 / pi) atan eta,

proportional to (j f)^alpha, with the storage modulus E at the stated frequency f_0. A measured table of
relaxations is a generalised Maxwell solid (J. D. Ferry, Viscoelastic Properties of Polymers (1980), chapter 3),

    E*(f) = E_0 + sum_k E_k j w tau_k / (1 + j w tau_k),    w = 2 pi f,

with the equilibrium modulus E_0. A constant E (1 + j eta) belongs to no material: a membrane of it would move before it
is pushed. It stays for comparison.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from acoustic_fem.quantities.checks import FrequencyLike, frequencies
from geometry.ground.argument_checks import check_range, mismatch, positive_numbers
from geometry.ground.typed import ComplexArray, NumpyOrTorch
from geometry.schema.materials import Material


def causal_slope(loss: Any) -> Any:
    """Exponent of frequency, (2 / pi) atan eta, that a loss factor eta asks for; arrays or tensors of any shape."""
    return (loss.arctan() if hasattr(loss, "arctan") else np.arctan(loss)) * (2 / np.pi)


def modulus_ratio(frequency: NumpyOrTorch, loss: Any, slope: Any, reference: Any, strength: Any, time: Any) -> Any:
    """Complex modulus by the stated one; NumPy arrays or torch tensors, float64, whose shapes are broadcast.

    Args:
        frequency: (n_freq,) or of any other shape, array or tensor, above 0, Hz.
        loss: loss factor eta, without that of the relaxations.
        slope: exponent of frequency, 0 to 1; 0 beside a loss is not causal.
        reference: frequency of the stated modulus, Hz; without a slope it does not matter.
        strength: relaxing moduli by the stated one, in the last axis, which is not broadcast; may be empty.
        time: relaxation times, s, shaped as ``strength``.

    Returns:
        Complex128 of the broadcast shape.
    """
    rate = 2j * np.pi * frequency[..., None] * time
    return (1 + 1j * loss) * (frequency / reference) ** slope + (strength * (rate / (1 + rate))).sum(-1)


@dataclass(frozen=True)
class Rubber:
    """Law of a rubber: its complex modulus over frequency by the stated one. By default it is elastic."""

    loss_factor: float = 0.0
    """Loss factor eta, 0 to 1, the same at all frequencies."""
    slope: float = 0.0
    """Exponent of frequency of the modulus: :func:`causal_slope`, or 0 for one that stays, which is not causal."""
    reference: float = 1.0
    """Frequency of the stated modulus, Hz."""
    strengths: tuple[float, ...] = ()
    """Relaxing moduli by the stated one, ratios."""
    times: tuple[float, ...] = ()
    """Relaxation times, s."""

    def __post_init__(self) -> None:
        check_range("loss_factor", self.loss_factor, 0, 1)
        positive_numbers("reference", self.reference, "Hz")
        if len(self.strengths) != len(self.times):
            raise mismatch(
                "strengths", f"has {len(self.strengths)} values, times {len(self.times)}; they must be as many"
            )

    @classmethod
    def spring_pot(cls, loss_factor: float, reference: float) -> Rubber:
        """The causal law of one loss factor, a ratio, at all frequencies, its modulus stated at ``reference``, Hz."""
        return cls(loss_factor, float(causal_slope(loss_factor)), reference)

    @classmethod
    def of(cls, material: Material) -> Rubber:
        """The law that a material states."""
        if material.law == "prony":
            moduli, times = material.relaxation_moduli or (), material.relaxation_times or ()
            return cls(strengths=tuple(value / material.youngs_modulus for value in moduli), times=times)
        loss = material.loss_factor or 0.0
        return cls(loss) if material.law == "constant" else cls.spring_pot(loss, material.modulus_frequency)

    @property
    def elastic(self) -> bool:
        """True if its modulus is real and the same at all frequencies."""
        return self.loss_factor == 0 and self.slope == 0 and not any(self.strengths)

    def ratio(self, frequency: FrequencyLike) -> ComplexArray:
        """Complex modulus by the stated one.

        Args:
            frequency: Hz, any shape.

        Returns:
            Complex128 of the shape of the frequency.

        Raises:
            Refusal: a frequency that is not finite and positive.
        """
        grid = frequencies(frequency)
        found = modulus_ratio(
            grid, self.loss_factor, self.slope, self.reference, np.array(self.strengths), np.array(self.times)
        )
        return np.asarray(found, dtype=np.complex128)


ELASTIC = Rubber()
"""A material without loss."""

"""Curves of a design over frequency: level and phase at every microphone, their differences between two."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations

import numpy as np
import xarray as xr
from numpy.typing import NDArray

import acoustic_fem
from acoustic_fem import Library
from acoustic_fem.atlas import QuickFidelity, quick_fidelity
from acoustic_fem.quantities.checks import FrequencyLike
from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_choice
from localize.signals.stimulus import BAND
from studies.metrics.pairs import microphone_ratios

#: Frequencies of the curves: so many, equally far apart on a logarithmic axis, over the band of the paper's sensors.
FREQUENCY_COUNT = 56


@dataclass(frozen=True)
class Curves:
    """Curves of one quantity, by point, then by microphone or pair of microphones."""

    quantity: str
    """Name of the quantity, of :data:`CURVES`."""
    unit: str
    """Unit of the values."""
    frequency: NDArray[np.float64]
    """Frequencies of the values; (n_freq,) float64, Hz."""
    points: tuple[int, ...]
    """Numbers of the points."""
    heard_by: tuple[str, ...]
    """Names of the microphones, or of pairs of them."""
    values: NDArray[np.float64]
    """Values in the unit; (n_point, n_heard_by, n_freq) float64."""


@dataclass(frozen=True)
class _Quantity:
    title: str
    unit: str
    compared: bool
    compute: Callable[[NDArray[np.complex128]], NDArray[np.float64]]


def _level(values: NDArray[np.complex128]) -> NDArray[np.float64]:
    return np.asarray(20 * np.log10(np.abs(values)))


def _phase(values: NDArray[np.complex128]) -> NDArray[np.float64]:
    return np.asarray(np.degrees(np.unwrap(np.angle(values))))


#: What can be drawn, by name: of the transfer functions, or of the ratios of two microphones.
_QUANTITIES = {
    "level": _Quantity("level", "dB", False, _level),
    "phase": _Quantity("phase, unwrapped", "degrees", False, _phase),
    "ild": _Quantity("level difference (ILD)", "dB", True, _level),
    "ipd": _Quantity("phase difference (IPD), unwrapped", "degrees", True, _phase),
}
#: Names of the curves -> their titles.
CURVES: dict[str, str] = {name: quantity.title for name, quantity in _QUANTITIES.items()}


def curve_frequencies() -> NDArray[np.float64]:
    """The frequencies of the curves, (n_freq,) float64, Hz."""
    return np.geomspace(*BAND, FREQUENCY_COUNT)


def quick_library(design: ArrayDesign, frequency: FrequencyLike | None = None) -> tuple[Library, QuickFidelity]:
    """The library of a design and its fidelity: ``atlas`` in milliseconds if that covers the design, otherwise 3-D.

    Args:
        design: the array.
        frequency: (n_freq,) Hz, ascending, or FIRST:LAST:COUNT; by default those of the curves.
    """
    grid = curve_frequencies() if frequency is None else frequency
    fidelity = quick_fidelity(design, grid)
    return acoustic_fem.solve(design, grid, fidelity=fidelity.name), fidelity


def curves_of(transfer_function: xr.DataArray, quantity: str) -> Curves:
    """Curves of one quantity.

    Args:
        transfer_function: (n_point, n_microphone, n_freq) complex, Pa/Pa; dimensions point, microphone, frequency (Hz).
        quantity: of :data:`CURVES`.

    Raises:
        Refusal: there is no such quantity.
    """
    check_choice("quantity", quantity, CURVES)
    chosen = _QUANTITIES[quantity]
    names = [str(name) for name in transfer_function["microphone"].values]
    ordered = transfer_function.transpose("point", "microphone", "frequency")
    heard_by = [f"{a} / {b}" for a, b in combinations(names, 2)] if chosen.compared else names
    return Curves(
        quantity,
        chosen.unit,
        np.asarray(ordered["frequency"].values, np.float64),
        tuple(int(number) for number in ordered["point"].values),
        tuple(heard_by),
        chosen.compute(microphone_ratios(ordered) if chosen.compared else np.asarray(ordered.values, np.complex128)),
    )

"""Curves of a comparison: levels of the strongest and the weakest point, and differences of transfer functions."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator

import acoustic_fem
from acoustic_fem import Library
from acoustic_fem.atlas.fidelity_choice import quick_fidelity
from geometry.ground.figures import new_figure
from geometry.ground.refusal import counted
from localize.signals.stimulus import BAND
from studies.comparison.subjects import Subject
from studies.metrics.pairs import Disagreement, disagreement

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Colours of the subjects in their order, told apart by readers who do not see red or green (Okabe and Ito, 2008).
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7a7a7a", "#b8a100")
#: Titles of the panels, and their axes.
PANELS = {
    "loudest": ("each point at its loudest microphone", "20 log |H|  (dB)"),
    "second": ("each point at its second-loudest microphone", "20 log |H|  (dB)"),
    "difference": ("level difference of these two (ILD)", "ILD  (dB)"),
}


@dataclass(frozen=True, eq=False)
class LevelCurves:
    """Levels of a sensor over frequency, for the strongest and for the weakest of its points at each frequency."""

    name: str
    """Name of the subject."""
    frequency: NDArray[np.float64]
    """Frequencies; (n_freq,) float64, Hz."""
    loudest: NDArray[np.float64]
    """Level 20 log |H| at a point's loudest microphone, of the strongest and of the weakest point; (2, n_freq) float64,
    dB."""
    second: NDArray[np.float64] | None
    """The same at a point's second-loudest microphone; (2, n_freq) float64, dB; None with one microphone."""
    difference: NDArray[np.float64] | None
    """Level difference (ILD) of a point's two loudest microphones, of the point where it is largest and where it is
    smallest; (2, n_freq) float64, dB; None with one microphone."""

    def to_dict(self) -> dict[str, Any]:
        """Curves as JSON can hold them."""
        return {
            "name": self.name,
            "frequency_hz": self.frequency.tolist(),
            **{f"{name}_db": None if (values := getattr(self, name)) is None else _finite(values) for name in PANELS},
        }


@dataclass(frozen=True)
class ResponseDifference:
    """Largest difference of the transfer functions of a subject from those of the first one."""

    name: str
    """Name of the subject."""
    largest: Disagreement | None
    """Largest deviations in magnitude and phase from 1 to 100 Hz; None if they were not compared."""
    why: str = ""
    """Reason why they were not compared; empty where they were."""

    @property
    def words(self) -> str:
        """Deviations, or the reason, as a sentence without its subject."""
        if self.largest is None:
            return f"not compared: {self.why}"
        found = self.largest
        where = f"point {found.magnitude_at[0]}, microphone {found.magnitude_at[1]}, {found.magnitude_at[2]:.3g} Hz"
        return f"at most {100 * found.magnitude:.3g} % in magnitude ({where}) and {found.phase:.3g} degrees in phase"

    def to_dict(self) -> dict[str, Any]:
        """Difference as JSON can hold it."""
        found = self.largest
        return {
            "name": self.name,
            "magnitude": None if found is None else found.magnitude,
            "phase_degrees": None if found is None else found.phase,
            "why": self.why,
        }


def level_curves(name: str, library: Library) -> LevelCurves:
    """Levels of the strongest and the weakest point of a library between 1 and 100 Hz, or over its own grid if that has
    no frequency there.

    Args:
        name: name of the subject.
        library: its library.
    """
    frequency = np.asarray(library.frequency, np.float64)
    h = library.transfer_function.transpose("point", "microphone", "frequency").values
    inside = (frequency >= BAND[0] - 1e-9) & (frequency <= BAND[1] + 1e-9)
    if inside.any():
        frequency, h = frequency[inside], h[..., inside]
    with np.errstate(divide="ignore"):
        levels = np.sort(20 * np.log10(np.abs(h)), axis=1)[:, ::-1]  # by microphone, the loudest first
    if levels.shape[1] < 2:
        return LevelCurves(name, frequency, _ends(levels[:, 0]), None, None)
    loudest, second = levels[:, 0], levels[:, 1]
    return LevelCurves(name, frequency, _ends(loudest), _ends(second), _ends(loudest - second))


def _finite(values: NDArray[np.float64]) -> list[list[float | None]]:
    """Values as JSON can hold them: the level of a transfer function of zero is None."""
    return [[value if np.isfinite(value) else None for value in row] for row in values.tolist()]


def _ends(levels: NDArray[np.float64]) -> NDArray[np.float64]:
    """Largest and smallest level over the points; (2, n_freq) float64."""
    return np.stack([levels.max(axis=0), levels.min(axis=0)])


def response_differences(subjects: Sequence[Subject], libraries: Sequence[Library]) -> tuple[ResponseDifference, ...]:
    """Largest differences of the transfer functions of all other subjects from those of the first.

    A design that has no stored library is solved at the frequencies of the library it is compared with.

    Args:
        subjects: at least two.
        libraries: of each.
    """
    return tuple(
        _difference(other.name, (subjects[0], libraries[0]), (other, library))
        for other, library in zip(subjects[1:], libraries[1:], strict=True)
    )


def _difference(name: str, one: tuple[Subject, Library], other: tuple[Subject, Library]) -> ResponseDifference:
    for noun, counts in (
        ("point", [subject.design.point_count for subject, _ in (one, other)]),
        ("microphone", [len(subject.design.microphones) for subject, _ in (one, other)]),
    ):
        if counts[0] != counts[1]:
            return ResponseDifference(name, None, f"it has {counted(counts[1], noun)}, and {one[0].name} {counts[0]}")
    reference, found = (_on_grid(*each, grid.frequency) for each, (_, grid) in ((one, other), (other, one)))
    if not np.array_equal(reference.frequency, found.frequency):
        words = f"its library has {_grid(found)}, and that of {one[0].name} {_grid(reference)}"
        return ResponseDifference(name, None, words)
    inside = (found.frequency >= BAND[0] - 1e-9) & (found.frequency <= BAND[1] + 1e-9)
    if not inside.any():
        return ResponseDifference(name, None, f"the libraries have no frequency from {BAND[0]:g} to {BAND[1]:g} Hz")
    h = found.transfer_function
    # Microphones of two designs may have other names: they are compared in their order.
    same = {key: reference.transfer_function[key].values for key in ("point", "microphone")}
    return ResponseDifference(name, disagreement(h.assign_coords(same), reference.transfer_function))


def _on_grid(subject: Subject, library: Library, frequency: NDArray[np.float64]) -> Library:
    """Library of a subject, solved at other frequencies if it was not stored."""
    if subject.library is not None or np.array_equal(library.frequency, frequency):
        return library
    return acoustic_fem.solve(subject.design, frequency, fidelity=quick_fidelity(subject.design, frequency).name)


def _grid(library: Library) -> str:
    grid = library.frequency
    return f"{counted(len(grid), 'frequency')} from {grid[0]:g} to {grid[-1]:g} Hz"


def draw_levels(curves: Sequence[LevelCurves]) -> Figure:
    """Figure with a panel each for the loudest microphone, the second-loudest one and their level difference.

    A band reaches from the strongest to the weakest point, in the colour of its subject.

    Args:
        curves: of each subject, in the order of the colours.

    Raises:
        MissingExtra: matplotlib is not installed.
    """
    shown = [name for name in PANELS if any(getattr(each, name) is not None for each in curves)]
    figure = new_figure(6.8, 0.7 + 2.2 * len(shown))
    grid = figure.subplots(len(shown), 1, squeeze=False, sharex=True)[:, 0]
    for axes, name in zip(grid, shown, strict=True):
        title, label = PANELS[name]
        for colour, each, values in _drawn(curves, name):
            frequency, (high, low) = _smooth(each.frequency, values)
            axes.fill_between(frequency, low, high, color=colour, alpha=0.14, linewidth=0)
            axes.semilogx(frequency, high, color=colour, label=each.name)
            axes.semilogx(frequency, low, color=colour, linestyle=(0, (4, 2)))
        axes.set(title=title, ylabel=label)
        axes.grid(visible=True, color="#dddddd", linewidth=0.6)
        axes.spines[["top", "right"]].set_visible(False)
    grid[-1].xaxis.set_major_formatter("{x:g}")
    grid[-1].xaxis.set_minor_formatter("")
    grid[-1].set_xlabel("frequency  (Hz)")
    figure.legend(
        *grid[0].get_legend_handles_labels(),
        title="solid: strongest or largest; dashed: weakest or smallest",
        loc="outside upper center",
        ncols=3,
        frameon=False,
    )
    return figure


def _drawn(curves: Sequence[LevelCurves], name: str) -> Iterator[tuple[str, LevelCurves, NDArray[np.float64]]]:
    for colour, each in zip(COLOURS, curves, strict=False):
        values = getattr(each, name)
        if values is not None:
            yield colour, each, values


def _smooth(
    frequency: NDArray[np.float64], values: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Frequencies and curves with values between those of the grid, by a spline without overshoot over the logarithm
    of the frequency.
    """
    if len(frequency) < 4 or not np.isfinite(values).all():
        return frequency, values
    fine = np.geomspace(frequency[0], frequency[-1], 200)
    fine[[0, -1]] = frequency[[0, -1]]
    return fine, PchipInterpolator(np.log(frequency), values, axis=-1)(np.log(fine))

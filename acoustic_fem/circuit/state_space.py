"""A library as a state space: all its responses as sums of the same few stable poles.

The poles come from vector fitting (:mod:`acoustic_fem.numerics.vector_fitting`) of the responses that are asked for and
of the impedances at the same ports. Passive means that the impedance matrix of a point and all microphones, made of the
fitted impedances, gives energy at no frequency. It is checked far outside the band, because nothing there was fitted,
and an order at which the fit gives energy is passed over.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from acoustic_fem.library.closed_form import ClosedForm
from acoustic_fem.library.transfer_functions import VARIABLES, Library
from acoustic_fem.network.microphone import response
from acoustic_fem.numerics.vector_fitting import RationalFit, VectorFitError, fit_poles
from geometry.ground.argument_checks import check_choice, check_range, real_numbers
from geometry.ground.refusal import Field, Kind, Refusal, Text
from geometry.ground.typed import Array, ComplexArray

#: What drives a membrane, and its unit: a force on the patch of ``Library.force_response``, or a volume velocity.
INPUTS = {"force": "N", "volume-velocity": "m^3/s"}
#: What a microphone gives, and its unit: the pressure in front of its diaphragm, or the voltage at its output.
OUTPUTS = {"pressure": "Pa", "voltage": "V"}
#: Frequencies at which passivity is checked, Hz.
PASSIVE_BAND = 1e-3, 1e5
#: Largest order that is tried.
LARGEST_ORDER = 60
#: Smallest eigenvalue, by the largest entry, at which an impedance counts as passive in spite of rounding.
ROUNDING = 1e-9
#: Errors that can be asked for.
TOLERANCES = 1e-6, 0.1
#: Lowest frequency at which a band may begin, Hz.
SLOWEST = 1e-3
#: Smallest order that is tried.
SMALLEST_ORDER = 6
#: Number of frequencies of a library that a fit needs at least.
FEWEST_FREQUENCIES = 2 * SMALLEST_ORDER
#: Frequency at which a microphone's sensitivity is stated, Hz.
STATED_AT = 1000.0
_FITTED, _CHECKED = 240, 600
#: Most pairs of poles from one order to the next that is tried.
_MOST_PAIRS = 6
#: Number of orders in turn that keep the error and give energy, after which no larger one is tried.
_IN_TURN = 3
#: Number of poles that lower the error by a tenth, or no more are tried.
_NO_GAIN = 16
#: Responses from which the poles are found; the others have them too, and their errors count as well.
_POLES_FROM = 96
_FIELDS = {"point_impedance": "point", "source_response": "source", "microphone_impedance": "microphones"}
_SLOW_COUNT = 48


@dataclass(frozen=True, eq=False)
class SensorModel:
    """State space of a sensor, x' = A x + B u, y = C x + D u: an input per point, an output per microphone."""

    fit: RationalFit
    """Poles and residues; the responses are (n_point, n_microphone), output per input."""
    impedances: Mapping[str, RationalFit]
    """Impedances with the same poles, by their names in :class:`acoustic_fem.Library`; empty where passivity is not
    asked for."""
    touch: str
    """Inputs, one of :data:`INPUTS`."""
    output: str
    """Outputs, one of :data:`OUTPUTS`."""
    name: str
    """Name of the design."""
    microphones: tuple[str, ...]
    """Names of the microphones, in the order of the outputs."""
    band: tuple[float, float]
    """Band over which the error holds, Hz."""
    error: float
    """Largest error over the band, relative to the magnitude of each response at each frequency."""
    margin: float | None
    """Least eigenvalue of the real part of the impedances of a point and the microphones from 1e-3 to 1e5 Hz, by their
    largest entry; not negative: passive. None where it is not checked, or where the library has no impedance between
    microphones."""

    @property
    def order(self) -> int:
        """Number of poles."""
        return self.fit.order

    @property
    def inputs(self) -> tuple[str, ...]:
        """Names of the inputs, points from 1."""
        return tuple(f"point {point + 1}" for point in range(len(self.fit.constant)))

    @property
    def matrices(self) -> tuple[Array, Array, Array, Array]:
        """A (n, n), B (n, n_point), C (n_microphone, n), D (n_microphone, n_point), float64, in SI units.

        Each microphone has a block of the poles, so n is the order times the number of microphones.
        """
        poles, microphones = self.fit.poles, len(self.microphones)
        block, entry = np.diag(poles.real), self.fit.residues.real.copy()
        leaving = np.ones(len(poles))
        for first in np.flatnonzero(poles.imag > 0):
            pole, residue = poles[first], self.fit.residues[..., first]
            block[first, first + 1], block[first + 1, first] = -pole.imag, pole.imag
            entry[..., first], entry[..., first + 1] = 2 * residue.real, 2 * residue.imag
            leaving[first + 1] = 0.0
        system = np.kron(np.eye(microphones), block)
        drive = entry.transpose(1, 2, 0).reshape(microphones * len(poles), -1)
        out = np.kron(np.eye(microphones), leaving)
        return np.asarray(system), drive, np.asarray(out), self.fit.constant.T.copy()

    def at(self, frequency: Array) -> ComplexArray:
        """Responses.

        Args:
            frequency: (n,) float64, Hz.

        Returns:
            (n_point, n_microphone, n) complex128, output per input.
        """
        return self.fit.at(np.asarray(frequency, np.float64))

    def simulate(self, signals: Any, rate: float) -> Array:
        """Outputs over time for inputs that run straight from sample to sample and were 0 before the first.

        Frequencies of the inputs above :attr:`band` go through poles that were fitted to nothing there, so inputs must
        be smooth enough. :meth:`acoustic_fem.Library.simulate` checks this.

        Args:
            signals: (n_point, n_sample) real numbers in the unit of the input.
            rate: samples per second, Hz; any.

        Returns:
            (n_microphone, n_sample) float64, in the unit of the output.

        Raises:
            Refusal: signals of another shape or that are not finite, or a rate that is not positive.
        """
        values = real_numbers("signals", signals)
        if values.ndim != 2 or len(values) != len(self.inputs) or not values.shape[1]:
            raise Refusal(
                f"has shape {values.shape}, must be (n_point, n_sample) = ({len(self.inputs)}, n)",
                kind=Kind.WRONG_TYPE,
                field="signals",
            )
        if not np.isfinite(values).all():
            raise Refusal("must be finite", kind=Kind.UNSUITABLE, field="signals")
        check_range("rate", rate, 1e-3, 1e6, "Hz")
        return self.fit.through(values, rate)


def fit_sensor(
    library: Library,
    *,
    touch: str = "force",
    output: str = "pressure",
    tolerance: float = 1e-3,
    band: tuple[float, float] | None = None,
    passive: bool = True,
) -> SensorModel:
    """State space of a small order that keeps an error and is passive.

    Args:
        library: of the sensor.
        touch: "force" (N) or "volume-velocity" (m^3/s) at each membrane.
        output: "pressure" (Pa) in front of the diaphragm of each microphone, or its "voltage" (V).
        tolerance: largest error, relative to the magnitude of each response at each frequency, 1e-6 to 0.1.
        band: lowest and highest frequency, Hz, from 1 mHz on; by default those of the library. Below the library's
            lowest frequency the closed forms of the design carry on.
        passive: False: the impedances are neither fitted nor checked, so the order may be smaller.

    Raises:
        Refusal: an unknown input or output, a value out of range.
        VectorFitError: no order up to 60 keeps the error and is passive; the message has the error that one reaches.
    """
    check_choice("touch", touch, tuple(INPUTS))
    check_choice("output", output, tuple(OUTPUTS))
    check_range("tolerance", tolerance, *TOLERANCES)
    grid = _grid(library, band)
    wanted = _Wanted.of(library, touch, output, grid)
    return _smallest(wanted, library, touch, output, tolerance, passive)


@dataclass(frozen=True, eq=False)
class _Wanted:
    """Values that are fitted."""

    frequency: Array
    responses: ComplexArray
    point: ComplexArray
    source: ComplexArray
    microphones: ComplexArray | None

    @classmethod
    def of(cls, library: Library, touch: str, output: str, grid: Array) -> _Wanted:
        known = {
            name: getattr(library, name).transpose(*VARIABLES[name][0]).values
            for name in ("transfer_function", "point_impedance", "microphone_impedance")
            if getattr(library, name) is not None
        }
        if touch == "force":
            known["cavity_response"] = library.cavity_response.transpose("point", "frequency").values
        form = ClosedForm(library.design, library.medium)
        found = form.between(known, library.frequency, grid, tuple(library.design.microphones))
        transfer, impedance = found["transfer_function"], found["point_impedance"]
        source = transfer * impedance[:, None]
        responses = transfer * found["cavity_response"][:, None] if touch == "force" else source
        if output == "voltage":
            responses = responses * voltage_per_pascal(library, grid)
        return cls(grid, responses, impedance, source, found.get("microphone_impedance"))

    def rows(self, impedances: bool) -> ComplexArray:
        """All that shares the poles, (n, n_freq), with the impedances or without."""
        parts = [self.responses]
        if impedances:
            parts += [self.point, self.source, *([] if self.microphones is None else [self.microphones])]
        return np.concatenate([part.reshape(-1, len(self.frequency)) for part in parts])

    def at(self, chosen: Array) -> _Wanted:
        """At some of the frequencies."""
        front = None if self.microphones is None else self.microphones[..., chosen]
        at = (self.responses[..., chosen], self.point[..., chosen], self.source[..., chosen])
        return _Wanted(self.frequency[chosen], *at, front)

    def impedances(self, fit: RationalFit) -> dict[str, RationalFit]:
        """Impedances by their names in a library, with the poles of a fit."""
        named = {"point_impedance": self.point, "source_response": self.source}
        if self.microphones is not None:
            named["microphone_impedance"] = self.microphones
        return {name: fit.of_responses(values, self.frequency) for name, values in named.items()}


def voltage_per_pascal(library: Library, frequency: Array) -> ComplexArray:
    """Voltage of the design's microphone per pressure in front of it.

    Its vent's high-pass, and the sensitivity that is stated at 1 kHz.

    Args:
        library: of the design.
        frequency: (n,) float64, Hz.

    Returns:
        (n,) complex128, V/Pa.
    """
    microphone, medium = library.design.microphone, library.medium
    stated = abs(response(microphone, np.array([STATED_AT]), medium)[0])
    return np.asarray(10 ** (microphone.sensitivity / 20) / stated * response(microphone, frequency, medium))


def _grid(library: Library, band: tuple[float, float] | None) -> Array:
    """Frequencies that count: those of the library within the band, and below them logarithmic ones."""
    known = library.frequency
    low, high = (float(known[0]), float(known[-1])) if band is None else band
    check_range("band: its highest frequency", high, float(known[0]), float(known[-1]), "Hz")
    check_range("band: its lowest frequency", low, SLOWEST, high, "Hz")
    inside = known[(known >= low) & (known <= high)]
    slow = np.geomspace(low, known[0], _SLOW_COUNT, endpoint=False) if low < known[0] else np.empty(0)
    grid = np.concatenate([slow, inside])
    if len(inside) < FEWEST_FREQUENCIES:
        raise Refusal(
            f"holds {len(inside)} frequencies of the library; a fit needs at least {FEWEST_FREQUENCIES}",
            kind=Kind.OUT_OF_RANGE,
            field="band",
        )
    return grid


def passivity_margin(impedances: Mapping[str, RationalFit]) -> float | None:
    """Least eigenvalue of the real part of the impedances of a point and the microphones, by their largest entry.

    Looked for from 1e-3 to 1e5 Hz and at every resonance. None without impedances between microphones.

    Args:
        impedances: as :attr:`SensorModel.impedances`.
    """
    front_fit = impedances.get("microphone_impedance")
    if front_fit is None:
        return None
    resonances = np.abs(front_fit.poles.imag[front_fit.poles.imag > 0]) / (2 * np.pi)
    at = np.concatenate([np.geomspace(*PASSIVE_BAND, _CHECKED), resonances])
    point, source = impedances["point_impedance"].at(at), impedances["source_response"].at(at)
    front = front_fit.at(at)
    count = 1 + len(front)
    matrix = np.empty((len(point), len(at), count, count))
    matrix[..., 0, 0] = point.real
    matrix[..., 0, 1:] = matrix[..., 1:, 0] = source.real.transpose(0, 2, 1)
    matrix[..., 1:, 1:] = (front + front.transpose(1, 0, 2)).real.transpose(2, 0, 1) / 2
    largest = np.maximum(np.abs(point), np.abs(np.einsum("mmf->mf", front)).max(axis=0))
    return float((np.linalg.eigvalsh(matrix)[..., 0] / largest).min())


def _smallest(
    wanted: _Wanted, library: Library, touch: str, output: str, tolerance: float, passive: bool
) -> SensorModel:
    grid = wanted.frequency
    even = np.searchsorted(grid, np.geomspace(grid[0], grid[-1], _FITTED))
    fitted = wanted.at(np.unique(np.minimum(even, len(grid) - 1)))
    rows = fitted.rows(passive)
    rows = rows[:: -(-len(rows) // _POLES_FROM)]
    largest = min(LARGEST_ORDER, len(fitted.frequency) // 2)
    order, tried = SMALLEST_ORDER, list[_Tried]()
    while order <= largest and not _is_hopeless(tried, tolerance):
        poles = fit_poles(rows, fitted.frequency, order)
        fit = poles.of_responses(wanted.responses, grid)
        impedances = wanted.impedances(poles) if passive else {}
        errors = [fit.error(wanted.responses, grid)]
        errors += [each.error(getattr(wanted, _FIELDS[name]), grid) for name, each in impedances.items()]
        now = _Tried(order, max(errors), passivity_margin(impedances))
        if now.error <= tolerance and now.is_passive:
            return SensorModel(
                fit=fit,
                impedances=impedances,
                touch=touch,
                output=output,
                name=library.design.name,
                microphones=tuple(library.design.microphones),
                band=(float(grid[0]), float(grid[-1])),
                error=now.error,
                margin=now.margin,
            )
        tried.append(now)
        # Each pair of poles takes about a factor of four off the error.
        order += 2 * int(np.clip(np.log(now.error / tolerance) / np.log(16.0), 1, _MOST_PAIRS))
    raise _unreached(library.design.name, tried, tolerance)


@dataclass(frozen=True)
class _Tried:
    """Order that was tried."""

    order: int
    error: float
    margin: float | None

    @property
    def is_passive(self) -> bool:
        """True if the fit gives energy at no frequency, or nobody can know."""
        return self.margin is None or self.margin >= -ROUNDING


def _is_hopeless(tried: list[_Tried], tolerance: float) -> bool:
    """True if more poles will not help, by the orders that were tried.

    Once three orders in turn keep the error and give energy, all poles that are added lie outside the band, where
    nothing holds them. An error that poles no longer lower is that of the values themselves.
    """
    kept = [each.error <= tolerance for each in tried[-_IN_TURN:]]
    if len(kept) == _IN_TURN and all(kept):
        return True
    if not tried:
        return False
    before = [each.error for each in tried if each.order <= tried[-1].order - _NO_GAIN]
    return bool(before) and min(before) < 1 and min(each.error for each in tried) > 0.9 * min(before)


def _unreached(name: str, tried: list[_Tried], tolerance: float) -> VectorFitError:
    """Refusal of an error that no passive fit keeps, with the smallest one that a passive fit has."""
    if any(each.error <= tolerance for each in tried):
        last = tried[-1]
        problem = f"is kept for {name} only by fits that give energy, such as that of {last.order} poles"
    else:
        least = min(tried, key=lambda each: each.error)
        problem = f"is not reached for {name}: the smallest error is {least.error:.2g}, with {least.order} poles"
    passive = min((each for each in tried if each.is_passive), key=lambda each: each.error, default=None)
    remedy: Text = "use a library of more frequencies or less noise, or a smaller band of it"
    if passive is not None and passive.error <= TOLERANCES[1]:
        remedy = ("give ", Field("tolerance"), f" {_rounded_up(passive.error)}, which {passive.order} poles reach")
    return VectorFitError(problem, kind=Kind.NO_RESULT, field="tolerance", value=tolerance, remedy=remedy)


def _rounded_up(value: float) -> str:
    """A positive number in two digits that is not below it."""
    step = 10.0 ** (np.floor(np.log10(value)) - 1)
    return f"{np.ceil(value / step) * step:.2g}"

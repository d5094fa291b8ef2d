"""Diagnosis of a built sensor from ordinary touches: sound, one fault named, or faults that cannot be told apart."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from itertools import zip_longest
from typing import Any, Literal, TypeAlias

import numpy as np
import scipy.special
from numpy.typing import ArrayLike, NDArray

from acoustic_fem import Library
from acoustic_fem.sound.estimate import TransferEstimate
from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array, ComplexArray
from localize.decoders.hypotheses import bare_library
from localize.diagnosis.as_built_estimates import AsBuiltEstimate, as_built_estimates
from localize.diagnosis.bench_advice import bench_advice, most_telling_point
from localize.diagnosis.diagnosis_options import DiagnosisOptions
from localize.diagnosis.fault_libraries import FaultLibraries, Tables
from localize.diagnosis.fault_likelihood import Fitted, TouchLikelihood
from localize.diagnosis.fault_search import FaultSearch
from localize.diagnosis.faults import SensorFault
from localize.diagnosis.known_touches import KnownPoints, KnownTouches, known_touches
from localize.diagnosis.touch_spectra import TouchSpectra, touch_spectra
from localize.signals.array_response import response_of
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from localize.signals.threads import one_thread

#: Outcomes of a diagnosis, as :attr:`Diagnosis.verdict` has them.
Verdict: TypeAlias = Literal["sound", "fault", "one of several", "unexplained"]

LEAST_ERROR = 1e-3
"""Error of measured transfer functions that is assumed at least, a fraction of their mean over the points."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Diagnosis:
    """Result of a diagnosis."""

    verdict: Verdict
    """Sound, one fault, one of several faults that cannot be told apart, or touches that no single fault explains."""
    faults: tuple[SensorFault, ...]
    """Faults that explain the touches, the likeliest first, each with its likeliest amount; none if it is sound."""
    probabilities: tuple[float, ...]
    """Probability of each of these faults, if the sensor has one fault at most; none if no fault explains the
    touches."""
    probability: float | None
    """Probability that the verdict is right, if the sensor has one fault at most; None if it is unexplained."""
    not_excluded: tuple[SensorFault, ...]
    """Faults that explain the touches of a sound sensor as well as no fault does."""
    gain: float
    """Log-likelihood of the likeliest fault over that of a sound sensor, nats."""
    misfit: float
    """Mean square of the residual over the expected one, for the likeliest explanation; about 1 or less if it fits."""
    start: Array
    """Time at which each touch begins, (n_touch,) float64, s."""
    point: NDArray[np.int64]
    """Point of each touch, from 1, as given or as the likeliest explanation has it; (n_touch,) int64."""
    known: NDArray[np.bool_]
    """True for each touch whose point was given; (n_touch,) bool."""
    matching: str
    """Sentence about stated points whose touches were missed or doubled; empty if there are none."""
    next_point: int | None
    """Point, from 1, whose touch would best distinguish what is left; None if nothing is left to distinguish."""
    advice: tuple[str, ...]
    """Work at the bench, in sentences."""
    parameters: tuple[AsBuiltEstimate, ...]
    """As-built parameters with 95 % intervals, as the likeliest explanation has them."""
    design: ArrayDesign
    """Design of the sensor."""

    @property
    def text(self) -> str:
        """Verdict as a sentence."""
        names = [fault.described(self.design) for fault in self.faults]
        if self.verdict == "sound":
            return f"no fault was found in {counted(len(self.start), 'touch')}"
        if self.verdict == "unexplained":
            return (
                f"no single fault explains the touches, because their residual is {self.misfit:.3g} times the expected "
                f"one; the likeliest single fault is that {names[0]}"
            )
        return names[0] if self.verdict == "fault" else "one of these faults: " + "; or ".join(names)

    @property
    def names_a_fault(self) -> bool:
        """True if the verdict is a fault, or one of several."""
        return self.verdict in ("fault", "one of several")

    @property
    def to_do(self) -> str:
        """Work at the bench in one text: for each fault, and the touch that tells several apart."""
        several = len(self.faults) > 1
        texts = [
            f"if {fault.described(self.design)}: {advice}" if several else advice
            for fault, advice in zip(self.faults, self.advice, strict=False)
        ]
        if several and self.next_point is not None:
            texts.insert(0, f"record touches again, one of them at point {self.next_point}, and run diagnose with it.")
        return " ".join([*texts, "Then record again."])

    def summary(self) -> dict[str, Any]:
        """Figures of the diagnosis as plain values, for a file of JSON."""

        def plain(fault: SensorFault) -> dict[str, Any]:
            return {"kind": fault.kind, "part": list(fault.part), "amount": round(fault.amount, 4),
                    "text": fault.described(self.design)}  # fmt: skip

        touches = zip(self.start.tolist(), self.point.tolist(), self.known.tolist(), strict=True)
        return {
            "design": self.design.name,
            "verdict": self.verdict,
            "text": self.text,
            "faults": [
                plain(fault) | {"probability": probability}
                for fault, probability in zip_longest(self.faults, [round(each, 4) for each in self.probabilities])
            ],
            "probability": None if self.probability is None else round(self.probability, 4),
            "not_excluded": [plain(fault) for fault in self.not_excluded],
            "gain": round(self.gain, 2),
            "misfit": round(self.misfit, 4),
            "matching": self.matching,
            "next_point": self.next_point,
            "advice": list(self.advice),
            "parameters": [asdict(each) for each in self.parameters],
            "touches": [{"start": round(start, 3), "point": point, "known": known} for start, point, known in touches],
        }


class Diagnoser:
    """Diagnoses of sensors of one library, whose tables are computed once.

    Args:
        library: of the design, or a calibrated one; it covers 1 to 100 Hz.
        microphone_noise: of the microphones, white, Pa rms over 0 to 500 Hz, or "design".
        options: numbers that tune it.

    Raises:
        Refusal: bare transfer functions, or a design whose scatter is not known.
    """

    def __init__(
        self, library: Library, microphone_noise: NoiseChoice = "design", options: DiagnosisOptions | None = None
    ) -> None:
        if not hasattr(library, "fidelity"):
            raise bare_library()
        self.options = options or DiagnosisOptions()
        response = response_of(library)
        noise = response.noise(microphone_noise)
        self._noise = noise.rms if isinstance(noise, NoiseSpectrum) else noise
        self.libraries = FaultLibraries(library, self.options)

    @one_thread()
    def diagnose(self, signals: ArrayLike, points: KnownPoints | None = None) -> Diagnosis:
        """Diagnosis from a recording of touches, one at a time, spread over the array.

        Args:
            signals: (n_microphone, n_sample), Pa, at 1 kHz, from 0.5 s before the first touch on.
            points: of the touches, as far as they are known.

        Raises:
            Refusal: signals of another number of microphones, too few touches, or points that do not fit the touches.
        """
        heard = np.asarray(signals, np.float64)
        count = len(self.libraries.design.microphones)
        if heard.ndim != 2 or len(heard) != count:
            problem = f"has shape {heard.shape}; it must be ({count}, n_sample), one row for each microphone"
            raise Refusal(problem, kind=Kind.WRONG_TYPE, field="signals")
        if not np.isfinite(heard).all():
            raise Refusal("must be finite", kind=Kind.UNSUITABLE, field="signals")
        spectra = touch_spectra(heard, self.libraries.frequency, self._noise)
        if len(spectra.start) < self.options.fewest:
            raise Refusal(
                f"holds {counted(len(spectra.start), 'touch')} with quiet between them; a diagnosis needs at least "
                f"{self.options.fewest}, better 24",
                kind=Kind.UNSUITABLE,
                field="signals",
            )
        return self._found(spectra, known_touches(points, spectra, self.libraries, self.options))

    @one_thread()
    def diagnose_measured(self, frequency: Array, estimates: Mapping[int, TransferEstimate]) -> Diagnosis:
        """Diagnosis from transfer functions that were measured with a calibration microphone.

        Args:
            frequency: (n_freq,) Hz, of the estimates, ascending.
            estimates: by number of the point, from 1. Each counts as a touch of that point.

        Raises:
            Refusal: frequencies that do not cover the band, or fewer than two points.
        """
        points, grid = sorted(estimates), self.libraries.frequency
        check_range("points", len(points), 2, why="the measured points that a diagnosis needs")
        for edge in (grid[0], grid[-1]):
            check_range("frequency", float(edge), float(frequency[0]), float(frequency[-1]), "Hz")
        measured = np.stack([_at(grid, frequency, estimates[number].transfer_function) for number in points])
        deviation = np.stack([_at(grid, frequency, estimates[number].deviation).real for number in points])
        noise = np.asarray(np.sqrt(2 * (deviation**2).mean(0)) + LEAST_ERROR * np.abs(measured).mean(0), np.float64)
        number = np.arange(len(points))
        spectra = TouchSpectra(
            number.astype(np.float64), (number + 1).astype(np.float64), number, measured / noise, noise
        )
        return self._found(spectra, KnownTouches(np.array(points, np.int64) - 1))

    def _found(self, spectra: TouchSpectra, known: KnownTouches) -> Diagnosis:
        likelihood = TouchLikelihood(spectra, known.point, self.options.mismatch, self.options.evidence_temperature)
        return self._decided(FaultSearch(self.libraries, likelihood, self.options).found(), spectra, known)

    def _decided(self, found: list[tuple[Tables, Fitted]], spectra: TouchSpectra, known: KnownTouches) -> Diagnosis:
        options, design = self.options, self.libraries.design
        (sound, as_designed), *others = found
        best = others[0][1]
        gain = best.evidence - as_designed.evidence
        is_sound = gain < options.believed
        fit = as_designed if is_sound else best
        near = [each for each in others if each[1].evidence > fit.evidence - options.apart]
        alike = [] if is_sound else near
        verdict: Verdict = "sound" if is_sound else "fault" if len(alike) == 1 else "one of several"
        if fit.misfit > options.explained:
            verdict, alike = "unexplained", others[:1]
        faults = tuple(_with_found_amount(*each) for each in alike)
        of_sound, of_faults = _probabilities(as_designed, [each for _, each in others], options)
        listed = () if verdict == "unexplained" else tuple(of_faults[: len(alike)].tolist())
        left = [(sound, as_designed), *near[:3]] if is_sound else near if len(near) > 1 else others[:2]
        next_point = None
        if verdict != "unexplained" and len(left) > 1:
            next_point = 1 + most_telling_point([tables.at(each.deviations) for tables, each in left], options.mismatch)
        return Diagnosis(
            verdict=verdict,
            faults=faults,
            probabilities=listed,
            probability=None if verdict == "unexplained" else of_sound if is_sound else float(sum(listed)),
            not_excluded=tuple(_with_found_amount(*each) for each in near) if is_sound else (),
            gain=gain,
            misfit=fit.misfit,
            start=spectra.start,
            point=fit.point + 1,
            known=known.point >= 0,
            matching=known.note,
            next_point=next_point,
            advice=tuple(bench_advice(self.libraries, fault) for fault in faults if verdict != "unexplained"),
            parameters=as_built_estimates(self.libraries, fit),
            design=design,
        )


def diagnose(
    library: Library,
    signals: ArrayLike,
    points: KnownPoints | None = None,
    microphone_noise: NoiseChoice = "design",
    options: DiagnosisOptions | None = None,
) -> Diagnosis:
    """Fault of a built sensor, found from ordinary touches.

    Args:
        library: of the sensor's design, or its calibrated one.
        signals: (n_microphone, n_sample), Pa, at 1 kHz: 20 to 30 touches, one at a time, spread over the array, each
            with quiet before and after it.
        points: of the touches, as far as they are known, from 1: one for each touch, or {time in s: point} of some.
        microphone_noise: of the microphones, white, Pa rms over 0 to 500 Hz, or "design".
        options: numbers that tune the diagnosis.

    Raises:
        Refusal: bare transfer functions, a design whose scatter is not known, signals of another number of
            microphones, too few touches, or points that do not fit the touches.
    """
    return Diagnoser(library, microphone_noise, options).diagnose(signals, points)


def _at(grid: NDArray[np.int64], frequency: Array, values: Array | ComplexArray) -> ComplexArray:
    """Values (n_microphone, n_freq) at other frequencies (n_grid,), interpolated."""
    return np.stack([np.interp(grid, frequency, row) for row in np.asarray(values, np.complex128)])


def _probabilities(
    as_designed: Fitted, faults: Sequence[Fitted], options: DiagnosisOptions
) -> tuple[float, NDArray[np.float64]]:
    """Probabilities of a sound sensor, and of each fault, (n_fault,) float64; together they are 1.

    The evidence counts residuals of all frequencies and touches as independent, which they are not, so it is divided
    by a temperature.
    """
    evidence = np.array([as_designed.evidence + options.believed, *(each.evidence for each in faults)])
    found = scipy.special.softmax(evidence / options.evidence_temperature)
    return float(found[0]), found[1:]


def _with_found_amount(tables: Tables, fit: Fitted) -> SensorFault:
    assert tables.fault is not None
    return tables.fault.with_amount(float(fit.deviations[-1]))

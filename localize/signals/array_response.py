"""Transfer functions of an array as plain arrays: what the localizer takes from a library.

Between the library's frequencies and below them, simulated signals take the closed forms of the design, by which the
library differs slowly over frequency (:mod:`acoustic_fem.library.closed_form`). Bare transfer functions have no design:
they are interpolated by a cubic spline, which runs on to 0 Hz. A long line bends there within a fraction of a hertz, so
give bare transfer functions in steps of 0.25 Hz where taps matter.
"""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, replace
from typing import Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from acoustic_fem import Library
from acoustic_fem.library.closed_form import ClosedForm
from acoustic_fem.library.transfer_functions import MEASURED
from acoustic_fem.network.microphone import vent_ratio
from acoustic_fem.numerics.frequency_splines import interpolated, interpolated_from_zero
from acoustic_fem.quantities.medium import Medium
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import write_design
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.layout.arrangement import place_housings
from geometry.layout.placement import point_places
from localize.signals.array_facts import ArrayFacts
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum, check_noise_choice, microphone_noise
from localize.signals.stimulus import BAND, SAMPLE_RATE


@dataclass(frozen=True, eq=False)
class ArrayResponse:
    """The transfer functions of one array as plain arrays: what the localizer takes from a library."""

    transfer_function: NDArray[np.complex128]
    """Pressure at a microphone over pressure in the touched cavity; (n_point, n_microphone, n_freq) complex128,
    Pa/Pa."""
    frequency: NDArray[np.float64]
    """Frequencies of the transfer functions, increasing, covering 1 to 100 Hz; (n_freq,) float64, Hz."""
    line: NDArray[np.int64]
    """Line of each point, as the library numbers it; (n_point,) int64."""
    place: NDArray[np.int64]
    """Place of each point along its line, as the library numbers it; (n_point,) int64."""
    microphones: tuple[str, ...]
    """Names of the microphones, in the order of the transfer functions."""
    name: str = "array"
    """Name of the design."""
    provenance: Mapping[str, Any] = field(default_factory=dict)
    """Design, fidelity, air, frequencies and versions that the transfer functions come from, as JSON can hold them."""
    own_noise: NoiseSpectrum | None = None
    """Noise of the design's microphone; None without a design."""
    ambient_response: NDArray[np.complex128] | None = None
    """Pressure at a microphone per pressure outside, the same on all membranes; (n_microphone, n_freq) complex128,
    Pa/Pa; None without a design."""
    sealed: bool = False
    """True if all pressures of the array are equal at 0 Hz, as those of a design without leaks are; if not, the spline
    is left to itself there."""
    closed_form: ClosedForm | None = None
    """Closed forms of the design, which give the responses between and below the frequencies; None without a design,
    or where the transfer functions are not those of its points."""
    vent_ratio: NDArray[np.complex128] | None = None
    """Admittance of the microphone's compliances over that of its vent, see
    :func:`acoustic_fem.network.microphone.vent_ratio`; (n_freq,) complex128; None without a design."""
    cavity_response: NDArray[np.complex128] | None = None
    """Pressure in the touched cavity per force on its membrane, on the patch of
    :attr:`acoustic_fem.Library.force_response`; (n_point, n_freq) complex128, Pa/N; None without a design."""
    position: NDArray[np.float64] | None = None
    """Middle of each membrane in plan, of an array on a cylinder in its plan unrolled at the height of the ports;
    (n_point, 2) float64, mm; None without a design."""
    membrane_radius: NDArray[np.float64] | None = None
    """Radius of the opening that each membrane closes; (n_point,) float64, mm; None without a design."""

    def __post_init__(self) -> None:
        h, f = self.transfer_function, self.frequency
        if h.ndim != 3 or h.shape[1:] != (len(self.microphones), len(f)):
            raise Refusal(
                f"has shape {h.shape}, must be (n_point, n_microphone, n_freq) = "
                f"(n, {len(self.microphones)}, {len(f)})",
                kind=Kind.WRONG_TYPE,
                field="transfer_function",
            )
        if len(self.line) != len(h) or len(self.place) != len(h):
            raise Refusal(
                f"line and place must each have one value for each of the {len(h)} points", kind=Kind.MISMATCH
            )
        form = self.closed_form
        if form is not None and not (
            len(h) == form.design.point_count and set(self.microphones) <= set(form.design.microphones)
        ):
            raise Refusal(
                f"is of {counted(form.design.point_count, 'point')} and the microphones "
                f"{', '.join(form.design.microphones)}, the transfer functions are not",
                kind=Kind.MISMATCH,
                field="closed_form",
            )
        if len(h) < 2 or len(self.microphones) < 2:
            raise Refusal(
                f"{counted(len(h), 'point')} and {counted(len(self.microphones), 'microphone')} are too few; "
                "localizing needs at least 2 of each",
                kind=Kind.UNSUITABLE,
            )
        if len(f) < 4 or f[0] <= 0 or np.any(np.diff(f) <= 0):
            raise Refusal(
                "must hold at least 4 increasing values above 0 Hz", kind=Kind.OUT_OF_RANGE, field="frequency"
            )
        if f[0] > BAND[0] + 1e-6 or f[-1] < BAND[1] - 1e-6:
            raise Refusal(
                f"runs from {f[0]:g} to {f[-1]:g} Hz; it must cover {BAND[0]:g} to {BAND[1]:g} Hz, "
                "the band of the stimuli",
                kind=Kind.OUT_OF_RANGE,
                field="frequency",
            )
        for name, expected in (
            ("ambient_response", h.shape[1:]),
            ("vent_ratio", f.shape),
            ("cavity_response", (len(h), len(f))),
            ("position", (len(h), 2)),
            ("membrane_radius", (len(h),)),
        ):
            value = getattr(self, name)
            if value is not None and (value.shape != expected or not np.isfinite(value).all()):
                raise Refusal(
                    f"has shape {value.shape}; it must hold finite values of shape {expected}",
                    kind=Kind.WRONG_TYPE,
                    field=name,
                )
        bad = np.argwhere(~np.isfinite(h))
        if len(bad):
            point, microphone, k = bad[0]
            raise Refusal(
                f"of point {point + 1} at microphone {self.microphones[microphone]} is not finite at {f[k]:g} Hz",
                kind=Kind.UNSUITABLE,
                field="transfer_function",
            )

    @property
    def point_count(self) -> int:
        """Number of sensing points."""
        return len(self.transfer_function)

    @property
    def array(self) -> ArrayFacts:
        """Facts of the array, as a localizer for it keeps them."""
        return ArrayFacts(self.name, self.microphones, self.line, self.place, self.provenance)

    @property
    def force_response(self) -> NDArray[np.complex128] | None:
        """Pressure at a microphone per force on a membrane, (n_point, n_microphone, n_freq) complex128, Pa/N, as
        :attr:`acoustic_fem.Library.force_response`; None without a design.
        """
        return None if self.cavity_response is None else self.transfer_function * self.cavity_response[:, None]

    def heard_by(self, microphones: tuple[str, ...]) -> ArrayResponse:
        """Response of the array at some of its microphones.

        Args:
            microphones: names of two or more.

        Raises:
            Refusal: a name that the array does not have.
        """
        for name in microphones:
            if name not in self.microphones:
                raise Refusal(kind=Kind.UNKNOWN, field="microphones", value=name, allowed=self.microphones)
        kept = [self.microphones.index(name) for name in microphones]
        sound = self.ambient_response
        return replace(
            self,
            microphones=microphones,
            transfer_function=self.transfer_function[:, kept],
            ambient_response=None if sound is None else sound[kept],
        )

    def of_sensor(self, transfer_function: NDArray[np.complex128], frequency: NDArray[np.float64]) -> ArrayResponse:
        """The array with the transfer functions of another sensor, at frequencies of their own.

        Other data at the former frequencies, on ambient sound, vents and forces, are left out.

        Args:
            transfer_function: (n_point, n_microphone, n) complex128, Pa/Pa.
            frequency: (n,) float64, Hz.

        Raises:
            Refusal: as of the class.
        """
        return replace(
            self,
            transfer_function=transfer_function,
            frequency=frequency,
            ambient_response=None,
            vent_ratio=None,
            cavity_response=None,
        )

    def noise(self, choice: NoiseChoice) -> float | NoiseSpectrum:
        """Noise that is added to every microphone: white, in Pa rms over 0 to 500 Hz, or that of the design.

        Raises:
            Refusal: "design" without a design, neither "design" nor one number, or a number that is not finite or
                below zero.
        """
        check_noise_choice(choice)
        if isinstance(choice, str):
            if self.own_noise is None:
                raise Refusal(
                    "needs a library with a design",
                    kind=Kind.MISMATCH,
                    field="microphone_noise",
                    value=choice,
                    remedy="give the noise in Pa rms",
                )
            return self.own_noise
        return float(choice)

    def at(self, frequency: NDArray[np.float64]) -> NDArray[np.complex128]:
        """Transfer functions interpolated by a spline to frequencies inside the library's range.

        Args:
            frequency: (n,) float64, Hz.

        Returns:
            (n_point, n_microphone, n) complex128, Pa/Pa.
        """
        return interpolated_from_zero(self.transfer_function, self.frequency, frequency, self.sealed)

    def between(self, frequency: NDArray[np.float64]) -> tuple[NDArray[np.complex128], NDArray[np.complex128] | None]:
        """Transfer functions and cavity responses at frequencies from 0 Hz to the end of the library.

        They follow :attr:`closed_form` where there is one, and a spline elsewhere.

        Args:
            frequency: (n,) float64, Hz.

        Returns:
            (n_point, n_microphone, n) complex128, Pa/Pa, and (n_point, n) complex128, Pa/N, or None where the array has
            no :attr:`cavity_response`.
        """
        cavity = self.cavity_response
        if self.closed_form is not None:
            known = {"transfer_function": self.transfer_function}
            if cavity is not None:
                known["cavity_response"] = cavity
            found = self.closed_form.between(known, self.frequency, frequency, self.microphones)
            return found["transfer_function"], found.get("cavity_response")
        return self.at(frequency), None if cavity is None else interpolated(cavity, self.frequency, frequency)


class TransferFunctionSource(Protocol):
    """Transfer functions of many sensors of one design, read as they are needed."""

    @property
    def frequency(self) -> NDArray[np.float64]:
        """Frequencies of the transfer functions; (n_freq,) float64, Hz."""

    @property
    def sensor_count(self) -> int:
        """Number of sensors."""

    def sensors(self, first: int, count: int) -> NDArray[np.complex128]:
        """Transfer functions of consecutive sensors; (count, n_point, n_microphone, n_freq) complex128, Pa/Pa."""


@runtime_checkable
class FactorSource(TransferFunctionSource, Protocol):
    """Source that gives factors of the array's own transfer functions at any frequency, which nobody interpolates."""

    def factors(self, first: int, count: int, frequency: NDArray[np.float64]) -> NDArray[np.complex64]:
        """Transfer functions of consecutive sensors over those of the array; (count, n_point, n_microphone, n)
        complex64.
        """


class UncoveredWarning(UserWarning):
    """Warning of a library that ends below the frequencies that touches reach."""


def warn_of_uncovered(response: ArrayResponse) -> None:
    """Warn, before a localizer is made of it, of a library that ends below half the sample rate of the signals.

    There is no warning for a measured library: it usually ends with the sweep that was played, which the calibration
    reports.
    """
    last, half = response.frequency[-1], SAMPLE_RATE / 2
    if last < half - 1e-6 and response.provenance.get("fidelity") != MEASURED:
        warnings.warn(
            f"{response.name}: its library ends at {last:g} Hz, touches may reach {half:g} Hz: above {last:g} Hz every "
            f"touch is taken to be silent, and any signal to be noise; 1:{half:g}:{half:g} covers all",
            UncoveredWarning,
            stacklevel=2,
        )


def response_of(library: Library | ArrayResponse) -> ArrayResponse:
    """Transfer functions of a library as plain arrays; those that are plain already are handed back.

    Raises:
        Refusal: the library's frequencies do not cover 1 to 100 Hz, or a value is not finite.
    """
    if isinstance(library, ArrayResponse):
        return library
    h = np.asarray(library.transfer_function.transpose("point", "microphone", "frequency").values, np.complex128)
    provenance = {
        "design": write_design(library.design.completed()),
        "fidelity": library.fidelity,
        "medium": asdict(library.medium),
        "frequency": [float(f) for f in library.frequency],
        "library": dict(library.provenance),
    }
    return replace(
        response_of_design(library.design, h, library.frequency, library.medium, provenance),
        ambient_response=np.asarray(library.touch_response("pressure").sum("point").values, np.complex128),
        cavity_response=np.asarray(library.cavity_response.values, np.complex128),
    )


def response_of_design(
    design: ArrayDesign,
    transfer_function: NDArray[np.complex128],
    frequency: NDArray[np.float64],
    medium: Medium,
    provenance: Mapping[str, Any],
) -> ArrayResponse:
    """Array of a design from its bare transfer functions, without its responses to forces and to sound outside.

    Args:
        design: the array.
        transfer_function: (n_point, n_microphone, n_freq) complex128, Pa/Pa.
        frequency: (n_freq,) float64, Hz.
        medium: the air.
        provenance: what the transfer functions come from, as JSON can hold it.

    Raises:
        Refusal: as of :class:`ArrayResponse`.
    """
    line, place = zip(*point_places(design), strict=True)
    radius = [design.of_kind(kind).resonator.cavity_diameter / 2 for kind in design.kinds]
    closed_form = ClosedForm(design, medium)
    return ArrayResponse(
        transfer_function=transfer_function,
        frequency=np.asarray(frequency, np.float64),
        line=np.array(line, np.int64),
        place=np.array(place, np.int64),
        microphones=tuple(design.microphones),
        name=design.name,
        provenance=provenance,
        own_noise=microphone_noise(design.microphone, medium),
        sealed=closed_form.sealed,
        closed_form=closed_form,
        vent_ratio=vent_ratio(design.microphone, frequency, medium),
        position=np.array([placed.position for placed in place_housings(design).points]),
        membrane_radius=np.array(radius)[list(design.kind_of_point)],
    )

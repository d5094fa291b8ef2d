"""Transfer functions of an array as plain arrays: what the localizer takes from a library.

Between the library's frequencies the complex values are interpolated by a cubic spline. Below the lowest one it runs on
to 0 Hz, where all pressures of a sealed array are equal. A long line bends there within a fraction of a hertz: where
taps matter, whose spectrum begins at 0 Hz, take a library in steps of 0.25 Hz.
"""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, replace
from typing import Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from acoustic_fem import Library
from acoustic_fem.library.transfer_functions import MEASURED
from acoustic_fem.network.microphone import vent_ratio
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
    """True if all pressures of the array are equal at 0 Hz, as those of a design are; if not, the spline is left to
    itself there."""
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
        """Transfer functions interpolated to frequencies inside the library's range.

        Args:
            frequency: (n,) float64, Hz.

        Returns:
            (n_point, n_microphone, n) complex128, Pa/Pa.
        """
        return interpolated_from_zero(self.transfer_function, self.frequency, frequency, self.sealed)


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


def interpolated(
    values: NDArray[np.complex128], grid: NDArray[np.float64], frequency: NDArray[np.float64]
) -> NDArray[np.complex128]:
    """Values of a real system, whose response at -f is the conjugate of that at f, by a cubic spline through them.

    Few values on many frequencies take a hundredth of the time of the matrices of :func:`interpolation`.

    Args:
        values: (..., n_freq) complex128, in any unit.
        grid: (n_freq,) float64, Hz, increasing, zero or above.
        frequency: (n,) float64, Hz.

    Returns:
        (..., n) complex128, in the unit of the values.
    """
    mirrored = grid > 0
    both = np.concatenate([-grid[mirrored][::-1], grid])
    mirror = np.conj(values[..., mirrored][..., ::-1])
    return np.asarray(CubicSpline(both, np.concatenate([mirror, values], -1), axis=-1)(frequency))


def interpolated_from_zero(
    values: NDArray[np.complex128], grid: NDArray[np.float64], frequency: NDArray[np.float64], sealed: bool
) -> NDArray[np.complex128]:
    """Values by the spline of :func:`interpolated`; where an array is sealed, its value at 0 Hz counts below the grid.

    Args:
        values: (..., n_freq) complex128, Pa/Pa.
        grid: (n_freq,) float64, Hz, increasing, above zero.
        frequency: (n,) float64, Hz.
        sealed: whether all pressures are equal at 0 Hz.

    Returns:
        (..., n) complex128, Pa/Pa.
    """
    found = interpolated(values, grid, frequency)
    is_below = frequency < grid[0]
    if sealed and is_below.any():
        found[..., is_below] = interpolated(
            from_zero(values, sealed), np.concatenate([[0.0], grid]), frequency[is_below]
        )
    return found


def interpolation(
    grid: NDArray[np.float64], frequency: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Matrices of the spline of :func:`interpolated`: of real parts, which are even about 0 Hz, and of imaginary ones,
    odd.

    Args:
        grid: (n_freq,) float64, Hz, increasing, zero or above.
        frequency: (n,) float64, Hz.

    Returns:
        Two of (n, n_freq) float64: values on ``frequency`` are either times values on the grid.
    """
    # Continued to negative frequencies, where the response of a real system is the conjugate: the spline then
    # needs no end condition near 0 Hz, where the response bends most.
    unit, mirrored = np.eye(len(grid)), grid > 0
    both = np.concatenate([-grid[mirrored][::-1], grid])
    even, odd = (CubicSpline(both, np.concatenate([sign * unit[mirrored][::-1], unit]))(frequency) for sign in (1, -1))
    return even, odd


def interpolation_from_zero(
    grid: NDArray[np.float64], frequency: NDArray[np.float64], sealed: bool
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Matrices as of :func:`interpolation`, for values to which :func:`from_zero` has prepended the value at 0 Hz.

    The value at 0 Hz counts only below the grid.

    Args:
        grid: (n_freq,) float64, Hz, increasing, above zero.
        frequency: (n,) float64, Hz.
        sealed: whether the value at 0 Hz is there.

    Returns:
        Two of (n, n_freq) float64, or of (n, n_freq + 1) where an array is sealed: of real and of imaginary parts.
    """
    even, odd = interpolation(grid, frequency)
    if not sealed:
        return even, odd
    below = interpolation(np.concatenate([[0.0], grid]), frequency)
    widened = (np.pad(matrix, ((0, 0), (1, 0))) for matrix in (even, odd))
    is_below = frequency[:, None] < grid[0]
    even, odd = (np.where(is_below, low, high) for low, high in zip(below, widened, strict=True))
    return even, odd


def from_zero(transfer_function: NDArray[np.complex128], sealed: bool) -> NDArray[np.complex128]:
    """Transfer functions with the one at 0 Hz before them where it is known.

    Args:
        transfer_function: (..., n_freq) complex128, Pa/Pa.
        sealed: whether all pressures are equal at 0 Hz.

    Returns:
        (..., n_freq + 1) complex128 where the array is sealed, else the same, (..., n_freq); Pa/Pa.
    """
    if not sealed:
        return transfer_function
    return np.concatenate([np.ones_like(transfer_function[..., :1]), transfer_function], -1)


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
    return ArrayResponse(
        transfer_function=transfer_function,
        frequency=np.asarray(frequency, np.float64),
        line=np.array(line, np.int64),
        place=np.array(place, np.int64),
        microphones=tuple(design.microphones),
        name=design.name,
        provenance=provenance,
        own_noise=microphone_noise(design.microphone, medium),
        sealed=True,
        vent_ratio=vent_ratio(design.microphone, frequency, medium),
        position=np.array([placed.position for placed in place_housings(design).points]),
        membrane_radius=np.array(radius)[list(design.kind_of_point)],
    )

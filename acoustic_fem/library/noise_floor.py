"""Thermal noise of the array with that of its microphones, and the smallest touch that stands out of it.

Passive parts at temperature T make a pressure noise between microphones of one-sided spectral density
2 k T (Z + Z*^T), which for reciprocal networks is 4 k T Re Z (Nyquist, Phys. Rev. 32 (1928) 110; Twiss,
J. Appl. Phys. 26 (1955) 599). Viscous and thermal losses of the air, the loss factor of the membranes and
the vents of the microphones are all in Re Z; the microphones add their own noise, each independent of the
others. Everything is linear and in equilibrium at one temperature; sound and vibration from outside, hum and
quantisation are not in it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, get_args

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike

from acoustic_fem.library.touch_pressure import TOUCHES
from acoustic_fem.library.transfer_functions import Library
from acoustic_fem.network.microphone import noise_density as own_noise_density, noise_density_behind_vent
from acoustic_fem.quantities.local_air import AirLike, medium_of
from geometry.ground.argument_checks import check_choice, check_range, positive_numbers, wrong_type
from geometry.ground.caller_warnings import warn_caller
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array, ComplexArray

#: J/K, exact (SI 2019).
BOLTZMANN = 1.380649e-23


#: Where the noise figures of the microphone hold: pressure in front of it, or its output over its sensitivity.
NoiseAt = Literal["front", "output"]

_FEWEST_FREQUENCIES = 8


def gas_temperature(air: AirLike) -> float:
    """Temperature of the ideal gas, gamma p / ((gamma - 1) rho cp), K."""
    medium = medium_of(air)
    return medium.gamma * medium.pressure / ((medium.gamma - 1) * medium.density * medium.heat_capacity)


def thermal_covariance(impedance: ArrayLike, temperature: ArrayLike) -> ComplexArray:
    """Spectral density of thermal pressure noise between the ports of a passive network.

    2 k T (Z + Z*^T), one-sided, Pa^2/Hz (Twiss 1955, eq. 4).

    Args:
        impedance: (..., n, n) complex128, Pa s/m^3.
        temperature: K, scalar or one per matrix, (...,).

    Returns:
        (..., n, n) complex128, Pa^2/Hz, Hermitian; the diagonal is the power density of each port.

    Raises:
        Refusal: matrices that are not square, or a temperature that is not finite and positive.
    """
    matrix = np.asarray(impedance, dtype=np.complex128)
    if matrix.ndim < 2 or matrix.shape[-1] != matrix.shape[-2]:
        raise wrong_type("impedance", f"has shape {matrix.shape}; it must be (..., n, n)")
    factor = 2 * BOLTZMANN * positive_numbers("temperature", temperature, "K")
    return np.asarray(factor[..., None, None] * (matrix + matrix.swapaxes(-1, -2).conj()))


def port_noise(impedance: ArrayLike, temperature: ArrayLike, own: ArrayLike) -> ComplexArray:
    """Thermal noise between ports with what each adds of its own, independent of the others.

    Args:
        impedance: (..., n, n) complex, Pa s/m^3.
        temperature: K, of a shape that broadcasts with that of the stack of matrices.
        own: densities of the ports' own noise, the same for all of them, of the shape of the stack, Pa/sqrt(Hz).

    Returns:
        (..., n, n) complex128, one-sided, Pa^2/Hz.

    Raises:
        Refusal: as :func:`thermal_covariance`.
    """
    covariance = thermal_covariance(impedance, temperature)
    ports = np.arange(covariance.shape[-1])
    covariance[..., ports, ports] += np.asarray(own)[..., None] ** 2
    return covariance


def combined_snr(signal: ComplexArray, noise: ComplexArray) -> Array:
    """Ratio of signal to noise, of powers, behind the best linear combination of all microphones: h^H N^-1 h.

    Args:
        signal: (..., n_freq, n_microphone, n_point) complex128, h.
        noise: (..., n_freq, n_microphone, n_microphone) complex128, N, per hertz.

    Returns:
        (..., n_point, n_freq) float64, Hz.
    """
    # unit diagonal: the noise spans decades
    scale = np.sqrt(np.einsum("...mm->...m", noise).real)
    scaled = signal / scale[..., None]
    whitened = np.linalg.solve(noise / (scale[..., :, None] * scale[..., None, :]), scaled)
    return np.asarray(np.einsum("...fmp,...fmp->...pf", scaled.conj(), whitened).real)


def noise_covariance(library: Library, noise_at: NoiseAt = "front") -> ComplexArray:
    """Spectral density of thermal and own noise of the microphones, one-sided.

    The noise of the vents is in the thermal part; if the figures of the microphone were measured on a
    whole microphone they hold it too, and the sum is that much too high.

    Args:
        library: with its microphone impedance.
        noise_at: "front": the noise figures of the design are pressures in front of the microphone;
            "output": its output over its sensitivity, which below the corner of the vent is worth more
            (:func:`acoustic_fem.network.microphone.noise_density_behind_vent`).

    Returns:
        (n_freq, n_microphone, n_microphone) complex128, Pa^2/Hz.

    Raises:
        Refusal: a library without microphone impedance, or an unknown ``noise_at``.
    """
    return port_noise(_impedance(library), gas_temperature(library.medium), _own_density(library, noise_at))


def noise_density(library: Library, noise_at: NoiseAt = "front") -> xr.Dataset:
    """Pressure noise at every microphone, Pa/sqrt(Hz), one-sided.

    Arguments and errors as :func:`noise_covariance`.

    Returns:
        Variables ``thermal``, ``own`` and ``total``, each (microphone, frequency) float64, Pa/sqrt(Hz).
    """
    thermal = thermal_covariance(_impedance(library), gas_temperature(library.medium))
    power = np.einsum("fmm->mf", thermal).real
    own = np.broadcast_to(_own_density(library, noise_at), power.shape)
    parts = {"thermal": np.sqrt(power), "own": own, "total": np.sqrt(power + own**2)}
    coords = {name: library.transfer_function.coords[name] for name in ("microphone", "frequency")}
    return xr.Dataset(
        {
            name: xr.DataArray(
                values,
                dims=("microphone", "frequency"),
                coords=coords,
                attrs={"units": "Pa/sqrt(Hz)", "long_name": f"{name} pressure noise"},
            )
            for name, values in parts.items()
        }
    )


def detectable_density(
    library: Library,
    touch: str,
    snr_db: float = 0.0,
    *,
    microphones: Sequence[str] | None = None,
    noise_at: NoiseAt = "front",
    contact_radius: float | None = None,
) -> xr.DataArray:
    """Smallest spectral density of a touch that stands out by ``snr_db`` at each frequency, per sqrt(Hz).

    1/sqrt(h^H N^-1 h), h the responses of the microphones and N their noise covariance: the best linear
    combination of all of them (Van Trees, Optimum Array Processing (2002), section 6.2).

    Args:
        library: with its microphone impedance.
        touch: "displacement" (m), "force" (N) or "pressure" (Pa).
        snr_db: required ratio of signal to noise, -100 to 200 dB.
        microphones: names of those that listen; by default all.
        noise_at: as for :func:`noise_covariance`.
        contact_radius: as for :meth:`acoustic_fem.Library.touch_response`.

    Returns:
        (point, frequency) float64, in the unit of the touch per sqrt(Hz).

    Raises:
        Refusal: an unknown touch or microphone, a value out of range, no microphone impedance.
    """
    ratio = 10 ** (check_range("snr_db", snr_db, -100, 200, "dB") / 20)
    density = ratio * _snr_density(library, touch, microphones, noise_at, contact_radius) ** -0.5
    units = f"{TOUCHES[touch]}/sqrt(Hz)"
    return density.rename(touch).assign_attrs({"units": units, "long_name": f"smallest detectable {touch}"})


def detection_limits(
    library: Library,
    band: tuple[float, float],
    snr_db: float = 0.0,
    *,
    microphones: Sequence[str] | None = None,
    noise_at: NoiseAt = "front",
    contact_radius: float | None = None,
) -> xr.Dataset:
    """Smallest rms displacement, force and outside pressure in a band, per point.

    A touch of flat spectrum over the band and rms x has the density x^2 / (f2 - f1); its ratio of signal to
    noise is that of the densities averaged over the band, each frequency and microphone combined as in
    :func:`detectable_density`. Integrated by the trapezoidal rule on the library's grid; fewer than 8
    frequencies in the band bring a warning.

    Args:
        library: with its microphone impedance.
        band: (f1, f2) Hz, within the library's grid.
        snr_db: required ratio of signal to noise, -100 to 200 dB.
        microphones: names of those that listen; by default all.
        noise_at: as for :func:`noise_covariance`.
        contact_radius: as for :meth:`acoustic_fem.Library.touch_response`.

    Returns:
        Variables ``displacement`` (m), ``force`` (N) and ``pressure`` (Pa), each (point,) float64.

    Raises:
        Refusal: a band outside the grid; the rest as :func:`detectable_density`.
    """
    ratio = 10 ** (check_range("snr_db", snr_db, -100, 200, "dB") / 20)
    limits = {}
    for touch, unit in TOUCHES.items():
        density = _snr_density(library, touch, microphones, noise_at, contact_radius)
        width = band[1] - band[0]
        limits[touch] = (ratio * width * _integrated(density, band) ** -0.5).assign_attrs(
            {"units": unit, "long_name": f"smallest detectable rms {touch}, {band[0]:g} to {band[1]:g} Hz"}
        )
    return xr.Dataset(limits)


def matched_filter_snr(
    library: Library,
    touch: str,
    spectrum: ArrayLike,
    band: tuple[float, float],
    *,
    microphones: Sequence[str] | None = None,
    noise_at: NoiseAt = "front",
    contact_radius: float | None = None,
) -> xr.DataArray:
    """Ratio of signal to noise (of powers) of one known transient behind the best linear filter, per point.

    4 int |X|^2 h^H N^-1 h df over the band, with X(f) = int x(t) exp(-j w t) dt and the one-sided noise N
    (North 1943; Turin, IRE Trans. Inf. Theory 6 (1960) 311). Integrated as :func:`detection_limits`.

    Args:
        library: with its microphone impedance.
        touch: "displacement", "force" or "pressure".
        spectrum: X, a scalar for a flat one (the impulse in N s for a short blow) or (n_freq,), in the unit
            of the touch times s.
        band: (f1, f2) Hz, within the library's grid.
        microphones: names of those that listen; by default all.
        noise_at: as for :func:`noise_covariance`.
        contact_radius: as for :meth:`acoustic_fem.Library.touch_response`.

    Returns:
        (point,) float64; 10 log10 of it is in dB.

    Raises:
        Refusal: a spectrum of another length; the rest as :func:`detection_limits`.
    """
    grid = library.frequency
    given = np.asarray(spectrum, dtype=np.complex128)
    if given.shape not in ((), grid.shape) or not np.all(np.isfinite(given)):
        raise wrong_type("spectrum", f"has shape {given.shape}; it must be one finite value or {grid.shape} of them")
    power = xr.DataArray(np.broadcast_to(np.abs(given) ** 2, grid.shape), dims="frequency")
    density = _snr_density(library, touch, microphones, noise_at, contact_radius)
    snr = 4 * _integrated(density * power, band)
    return snr.rename("snr").assign_attrs({"units": "1", "long_name": "matched-filter ratio of signal to noise"})


def _impedance(library: Library) -> ComplexArray:
    """(n_freq, n_microphone, n_microphone)."""
    if library.microphone_impedance is None:
        raise Refusal(
            "is missing in the library, which was measured or made from other data, so its thermal noise is unknown",
            kind=Kind.MISSING,
            field="microphone_impedance",
            remedy="solve its design again",
        )
    return np.asarray(library.microphone_impedance.transpose("frequency", "microphone", "microphone_2").values)


def _own_density(library: Library, noise_at: NoiseAt) -> Array:
    if noise_at == "front":
        return own_noise_density(library.design.microphone, library.frequency)
    if noise_at == "output":
        return noise_density_behind_vent(library.design.microphone, library.frequency, library.medium)
    raise Refusal(kind=Kind.OUT_OF_RANGE, field="noise_at", value=noise_at, allowed=get_args(NoiseAt))


def _snr_density(
    library: Library, touch: str, microphones: Sequence[str] | None, noise_at: NoiseAt, contact_radius: float | None
) -> xr.DataArray:
    """h^H N^-1 h, (point, frequency), Hz per square unit of the touch."""
    response = library.touch_response(touch, contact_radius=contact_radius)
    names = [str(name) for name in response["microphone"].values]
    for name in microphones or ():
        check_choice("microphones", name, names, kind=Kind.UNKNOWN)
    if microphones is not None and len(set(microphones)) != max(len(microphones), 1):
        raise Refusal(
            "must name at least one, and none twice", kind=Kind.OUT_OF_RANGE, field="microphones", value=[*microphones]
        )
    chosen = [names.index(name) for name in (names if microphones is None else microphones)]
    noise = noise_covariance(library, noise_at)[:, chosen][:, :, chosen]
    signal = response.transpose("frequency", "microphone", "point").values[:, chosen]
    return response.isel(microphone=0, drop=True).copy(data=combined_snr(signal, noise))


def _integrated(density: xr.DataArray, band: tuple[float, float]) -> xr.DataArray:
    """Integral over the band by the trapezoidal rule, linear between the frequencies of the grid."""
    grid = density["frequency"].values
    low, high = (float(positive_numbers("band", edge, "Hz")) for edge in band)
    if not grid[0] <= low < high <= grid[-1]:
        problem = f"Hz must ascend and lie within the grid of the library, {grid[0]:g} to {grid[-1]:g} Hz"
        raise Refusal(problem, kind=Kind.OUT_OF_RANGE, field="band", value=(low, high))
    inside = grid[(grid > low) & (grid < high)]
    if len(inside) < _FEWEST_FREQUENCIES:
        warn_caller(
            f"noise: within {low:g} to {high:g} Hz the library has only {counted(len(inside), 'frequency')}; the "
            "integral over the band is rough",
        )
    points = np.concatenate([[low], inside, [high]])
    return density.interp(frequency=points).integrate("frequency")

"""Frames of touches in a few frequency bins, from which :mod:`studies.metrics.predicted_accuracy` predicts decisions.

The touches are those that a run is evaluated on (:mod:`localize.evaluation.held_out`), from fixed seeds: taps and
presses behind the high-pass of a stream, multi-sines unfiltered. A bin is the last frame of a touch times a sine
window and a wave. The pressure in a cavity is a sum of spectral lines, so that its bins are one matrix product.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Literal

import numpy as np
import scipy.signal
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from geometry.ground.typed import Array, ComplexArray
from localize.decoders.frame_covariance import HUM, HUM_LINES, SOURCE_RMS
from localize.live.front_end import high_pass_sections
from localize.live.stream_options import HIGH_PASS
from localize.signals.disturbances import MAINS
from localize.signals.frames import FRAME
from localize.signals.noise_model import NoiseSpectrum
from localize.signals.stimulus import BAND, LINE_SPACING, SAMPLE_LENGTH, SAMPLE_RATE

Touch = Literal["taps", "presses", "multi_sines"]
TOUCHES: tuple[Touch, ...] = ("taps", "presses", "multi_sines")
"""Kinds of touches."""
BINS = np.arange(2.0, BAND[1], SAMPLE_RATE / FRAME)
"""Frequencies of the bins, one frame's line apart, Hz."""
NODES = np.geomspace(2.5, 104.0, 12)
"""Frequencies at which transfer functions are computed, Hz; between them they are splines."""
REACH = 4.0
"""Distance of the lines that a bin counts, Hz, that of the next bin. Lines farther away leak into the bin by the
transfer functions of their own frequency. The decoder knows the frame's edges and takes the leak away, but for
:data:`studies.metrics.predicted_accuracy.LEAK_LEFT`."""
COUNT = 512
"""Number of different touches of each kind."""
_SEED = 20161
_LINES = LINE_SPACING * np.arange(1.0, 521.0, dtype=np.float64)
"""Spectral lines that reach the bins, Hz."""


def source_density() -> float:
    """Mean square of a bin of the touch that decoders assume at power 1, Pa^2: flat from 1 to 100 Hz."""
    return SOURCE_RMS**2 / (BAND[1] - BAND[0]) * SAMPLE_RATE / 2


def touch_frames(touch: Touch, cavity: ComplexArray, force: float | None) -> tuple[ComplexArray, Array]:
    """Pressures in a cavity by touches, bin by bin.

    Args:
        touch: their kind; multi-sines are pressures, whatever the cavity.
        cavity: what a stroke goes through, at :data:`NODES`, (n_node,): Pa/Pa by that at 30 Hz, or Pa/N with a force.
        force: peak of every stroke, N; None for strokes of the peaks that a run has, in Pa.

    Returns:
        Pressure in each bin, (COUNT, n_bin) complex64, Pa, and amplitude of what leaks into it from lines farther away
        than :data:`REACH`, (COUNT, n_bin) float32, Pa.
    """
    if touch == "multi_sines":
        return _multi_sine_frames()
    forth, back = _stroke_frames(touch, force is not None)
    through = (cavity * (1.0 if force is None else force)).astype(np.complex64)
    frames = through @ forth.reshape(len(through), -1) + through.conj() @ back.reshape(len(through), -1)
    near, leaked = np.split(frames.reshape(COUNT, -1), 2, axis=1)
    return near, np.abs(leaked)


@lru_cache(maxsize=1)
def _multi_sine_frames() -> tuple[ComplexArray, Array]:
    """Frames of the multi-sines, as of :func:`touch_frames`."""
    forth, back = _analysis(False)
    spectrum = _spectra("multi_sines", False)
    near, leaked = np.split(spectrum @ forth + spectrum.conj() @ back, 2, axis=1)
    return near, np.abs(leaked)


@lru_cache(maxsize=4)
def _stroke_frames(touch: Touch, of_force: bool) -> tuple[NDArray[np.complex64], NDArray[np.complex64]]:
    """Frames of strokes per value of the cavity at each node, and per its conjugate; (n_node, COUNT, 2 n_bin) each.

    Strokes of a force have a peak of 1 N, others the peaks of a run.

    A cavity is a cubic spline in log f between the nodes, so that only the nodes of a design are multiplied.
    """
    forth, back = _analysis(True)
    spectrum = _spectra(touch, of_force)
    parts = [spectrum * part for part in from_nodes(np.clip(_LINES, NODES[0], NODES[-1])).astype(np.float32)]
    return np.stack([part @ forth for part in parts]), np.stack([part.conj() @ back for part in parts])


def from_nodes(frequency: Array) -> Array:
    """Matrix from values at :data:`NODES` to those at frequencies, (n_node, n_freq): a cubic spline in log f."""
    return np.asarray(CubicSpline(np.log(NODES), np.eye(len(NODES)))(np.log(frequency)).T)


def noise_in_bins(noise: NoiseSpectrum) -> Array:
    """Mean square of a microphone's noise in each bin, (n_bin,) float64, Pa^2."""
    return np.asarray(noise.power @ _passed_noise(), np.float64)


@lru_cache(maxsize=1)
def _passed_noise() -> Array:
    """Noise of each hertz that reaches a bin, (n_hertz, n_bin)."""
    time, hertz = np.arange(FRAME) / SAMPLE_RATE, np.arange(int(SAMPLE_RATE) // 2)
    seen = _window()[:, None] * np.exp(-2j * np.pi * time[:, None] * BINS)
    forth, back = (np.exp(sign * 2j * np.pi * hertz[:, None] * time) @ seen for sign in (1, -1))
    return np.asarray(0.5 * (np.abs(forth) ** 2 + np.abs(back) ** 2))


@lru_cache(maxsize=1)
def hum_in_bins() -> Array:
    """Mean square of the mains hum that decoders expect in each bin, (n_bin,) float64, Pa^2."""
    lines = np.outer(np.arange(1, HUM_LINES + 1), MAINS).ravel()
    waves = np.exp(2j * np.pi * np.arange(FRAME) / SAMPLE_RATE * (lines[:, None, None] - BINS[:, None]))
    return np.asarray(0.5 * HUM**2 * (np.abs((waves * _window()).sum(-1)) ** 2).sum(0))


def _window() -> Array:
    """The first sine window, of energy 1; (FRAME,)."""
    window = np.sin(np.pi * (np.arange(FRAME) + 0.5) / FRAME)
    return np.asarray(window / np.linalg.norm(window))


@lru_cache(maxsize=2)
def _analysis(is_filtered: bool) -> tuple[NDArray[np.complex64], NDArray[np.complex64]]:
    """Matrices from the lines of a spectrum, and from their conjugates, to the bins of the last frame of a second.

    The first half of the columns has the lines within :data:`REACH` of a bin, the second half all others.
    """
    time = np.arange(SAMPLE_LENGTH - FRAME, SAMPLE_LENGTH) / SAMPLE_RATE
    seen = _window()[:, None] * np.exp(-2j * np.pi * np.arange(FRAME)[:, None] / SAMPLE_RATE * BINS)
    waves = np.exp(2j * np.pi * _LINES[:, None] * time)
    passed = np.ones(len(_LINES), complex)
    if is_filtered:
        _, passed = scipy.signal.sosfreqz(high_pass_sections(HIGH_PASS), _LINES, fs=SAMPLE_RATE)
    forth, back = (
        np.concatenate([through * is_near, through * ~is_near], axis=1).astype(np.complex64)
        for sign, values, wave in ((1, passed, waves), (-1, passed.conj(), waves.conj()))
        for through, is_near in [(values[:, None] * (wave @ seen), np.abs(sign * _LINES[:, None] - BINS) <= REACH)]
    )
    return forth, back


@lru_cache(maxsize=8)
def _spectra(touch: Touch, of_force: bool) -> ComplexArray:
    """Spectra of touches on the lines that reach the bins, (COUNT, n_line) complex64."""
    from localize.signals.finger_strokes import press_strokes, tap_strokes
    from localize.signals.stimulus import multi_sines

    band = (LINE_SPACING, SAMPLE_RATE / 2)
    if touch == "multi_sines":
        made = multi_sines(_SEED, "evaluation", 0, COUNT, band)
    else:
        strokes = {"taps": tap_strokes, "presses": press_strokes}[touch]
        peak = {"peak": (1.0, 1.0)} if of_force else {}
        made = strokes(_SEED, "evaluation", 0, COUNT, band, "cpu", **peak)
    return np.ascontiguousarray(made.spectrum[:, 1 : 1 + len(_LINES)].numpy())

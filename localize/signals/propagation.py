"""From the pressure in the touched cavity to the microphones: exactly, and as the paper does it.

Exactly: the stimulus is periodic in four seconds, its spectral lines are multiplied by the transfer functions and
transformed back over the whole period. The result is the steady state of the array. For a stimulus x that is silent
outside the first second it is at the same time the linear convolution with the impulse response h, the inverse
transform of the same transfer functions:

    y[n] = sum_m h[n - m] x[m],    0 <= n, m < 1000,

in which n - m lies between -999 and 999, so that no two of these taps fall on the same one of the 4000. The period
cannot hold responses that last longer than two seconds; :func:`late_energy` gives their fraction of the energy.

Products of short-window transforms alias circularly as soon as the impulse response is longer than the window;
:func:`short_window_signals` is there to compare with, and never to check an inverse made the same way.
"""

from __future__ import annotations

from collections.abc import Iterator

import torch
from torch import Tensor

from localize.signals.stimulus import LINE_COUNT, PERIOD, SAMPLE_LENGTH, TOGETHER, time_signal

WINDOW, HOP = 32, 16
"""Window and hop of the short-window transform, samples: those that the paper states for reconstruction. For its data
it states none; that they are the same is our assumption."""


def microphone_signals(
    spectrum: Tensor, transfer_function: Tensor, sample_count: int = SAMPLE_LENGTH, start: int = 0
) -> Tensor:
    """Exact steady state at the microphones; for stimuli of one second and silence also the exact convolution.

    Args:
        spectrum: (n, n_line) complex amplitudes of the cavity pressure on the lowest spectral lines, Pa.
        transfer_function: (n, n_microphone, n_line) complex, on the same lines, Pa/Pa; with ``start`` of any number.
        sample_count: at most ``stimulus.PERIOD``.
        start: index of the transfer function of the first spectrum, the next ones having the next, and behind the last
            of them the first; any number, of which what is left by their number counts.

    Returns:
        (n, n_microphone, sample_count) real, Pa.
    """
    several = TOGETHER if spectrum.device.type == "cpu" else max(len(spectrum), 1)
    shape = len(spectrum), transfer_function.shape[1], sample_count
    signals = torch.empty(shape, dtype=spectrum.real.dtype, device=spectrum.device)
    product = spectrum.new_zeros((min(several, len(spectrum)), transfer_function.shape[1], LINE_COUNT + 1))
    stop = min(spectrum.shape[-1], LINE_COUNT + 1)
    for first in range(0, len(spectrum), several):
        part = spectrum[first : first + several, None, :]
        made = product[: len(part)]
        for run, rows in _runs(start + first, len(part), len(transfer_function)):
            torch.mul(transfer_function[rows], part[run], out=made[run, :, :stop])
        signals[first : first + several] = time_signal(made, sample_count)
    return signals


def _runs(start: int, count: int, rows: int) -> Iterator[tuple[slice, slice]]:
    """Runs of ``count`` things to which rows belong in turn, and their rows: slices, for an index would copy them."""
    done = 0
    while done < count:
        row = (start + done) % rows
        run = min(rows - row, count - done)
        yield slice(done, done + run), slice(row, row + run)
        done += run


def impulse_response(transfer_function: Tensor) -> Tensor:
    """Impulse response at 1 kHz, limited to the band of the lines given.

    Args:
        transfer_function: (..., n_line) complex, on the lowest spectral lines, 0 Hz included, Pa/Pa.

    Returns:
        (..., PERIOD) real, Pa/Pa; what comes before time zero, by the limited band alone, stands at the end.
    """
    return time_signal(transfer_function, PERIOD) / PERIOD


def late_energy(transfer_function: Tensor) -> float:
    """Largest share of the energy of an impulse response that lies more than a second from time zero.

    Touches never show that part, for they last a second; but what lies beyond two seconds is folded back onto it, so
    that a share that is not small means transfer functions of an array that remembers for too long.

    Args:
        transfer_function: (..., n_line) complex, on the lowest spectral lines, 0 Hz included, Pa/Pa. A band that ends
            abruptly rings, see :func:`localize.signals.finger_stimuli.top_faded`.
    """
    power = impulse_response(transfer_function).square()
    return float((power[..., SAMPLE_LENGTH:-SAMPLE_LENGTH].sum(-1) / power.sum(-1)).max())


def short_window_signals(spectrum: Tensor, transfer_function: Tensor) -> Tensor:
    """Signals in the paper's way: short-window transform, times the transfer function, and back.

    The window is ours, 32 samples with a hop of 16: the paper states it for reconstruction only. Its
    error is that of the window, whatever the noise. Against the exact steady state, both microphones together, signal
    over error is -0.1 to 10.4 dB over the points of ``line-2`` (4.9 in the median, 0 in mid-line, where a
    touch is farthest from both), and 9.7 to 11.7 dB over those of ``array-2x6``.

    Args:
        spectrum: (n, n_line) complex amplitudes of the cavity pressure on the lowest spectral lines, Pa.
        transfer_function: (n, n_microphone, n_line) complex, on the same lines, Pa/Pa, of which every 125th is used;
            where the lines end, so do the signals.

    Returns:
        (n, n_microphone, SAMPLE_LENGTH) real, Pa.
    """
    pressure = time_signal(spectrum)
    window = torch.hann_window(WINDOW, dtype=pressure.dtype, device=pressure.device)
    short = torch.stft(pressure, WINDOW, HOP, window=window, return_complex=True)
    bins = transfer_function[..., :: PERIOD // WINDOW]
    product = short.new_zeros((*bins.shape[:2], *short.shape[1:]))
    product[:, :, : bins.shape[-1]] = short[:, None, : bins.shape[-1]] * bins[..., None]
    signals = torch.istft(product.flatten(0, 1), WINDOW, HOP, window=window, length=SAMPLE_LENGTH)
    return signals.unflatten(0, bins.shape[:2])

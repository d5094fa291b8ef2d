"""Frames of recordings: the 250 samples that one decision is made from, and checks of what comes in."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import softmax

from geometry.ground.argument_checks import real_numbers
from geometry.ground.refusal import Kind, Refusal, counted
from localize.signals.stimulus import SAMPLE_RATE

if TYPE_CHECKING:
    from torch import Tensor

FRAME = 250
"""Length of a frame, samples."""


def cut_frames(signals: NDArray[np.float64]) -> NDArray[np.float64]:
    """Frames of 250 samples, one after the other, the last one ending with the signal.

    Args:
        signals: (n, n_microphone, n_sample), n_sample at least 250, in any unit.

    Returns:
        (n, n_frame, n_microphone, 250) float64, a view in the unit of the signals.
    """
    kept = signals[..., signals.shape[-1] % FRAME :]
    return kept.reshape(*kept.shape[:2], -1, FRAME).swapaxes(1, 2)


def checked_signals(signals: ArrayLike | Tensor, microphones: Sequence[str]) -> tuple[NDArray[np.float64], bool]:
    """Signals as a batch, refused where no touch could be read from them.

    Args:
        signals: (n_microphone, n_sample) or (n, n_microphone, n_sample), Pa, at 1 kHz.
        microphones: names of the array's microphones.

    Returns:
        (n, n_microphone, n_sample) float64, and whether the batch dimension was there.

    Raises:
        Refusal: no real numbers, wrong number of dimensions or channels, fewer than 250 samples, a value that is not
            finite, or a channel that never changes.
    """
    # Tensors may lie on another device, or keep what their gradients need.
    given = signals.numpy(force=True) if hasattr(signals, "numpy") else signals
    batch = np.ascontiguousarray(real_numbers("signals", given))
    if batch.ndim not in (2, 3):
        raise Refusal(
            f"has shape {batch.shape}, must be (n_microphone, n_sample) or (n, n_microphone, n_sample)",
            kind=Kind.WRONG_TYPE,
            field="signals",
        )
    batched = batch.ndim == 3
    batch = batch if batched else batch[None]
    if batch.shape[1] != len(microphones):
        raise Refusal(
            f"has {counted(batch.shape[1], 'channel')}, must have {len(microphones)}: {', '.join(microphones)}",
            kind=Kind.MISMATCH,
            field="signals",
        )
    if batch.shape[2] < FRAME:
        raise Refusal(
            f"has {counted(batch.shape[2], 'sample')}, must have at least {FRAME} "
            f"({FRAME / SAMPLE_RATE:g} s at {SAMPLE_RATE:g} Hz)",
            kind=Kind.UNSUITABLE,
            field="signals",
        )
    # One look at all values: of a single frame checks take as long as some decoders.
    span = batch.max(-1) - batch.min(-1)
    if not ((span > 0) & (span < np.inf)).all():
        _refuse_channels(batch, microphones, batched)
    return batch, batched


def _refuse_channels(batch: NDArray[np.float64], microphones: Sequence[str], batched: bool) -> None:
    """Refuse the first channel that is not finite, or else that never changes; an infinite span alone is allowed."""
    for broken, what in (
        (~np.isfinite(batch).all(-1), "holds values that are not finite"),
        (batch.max(-1) == batch.min(-1), "is silent: its value never changes"),
    ):
        if broken.any():
            sample, channel = np.argwhere(broken)[0].tolist()
            where = f" of signal {sample}" if batched else ""
            raise Refusal(f"channel {microphones[channel]}{where} {what}", kind=Kind.UNSUITABLE, field="signals")


def combined_probability(log_probability: NDArray[np.float64]) -> NDArray[np.float64]:
    """Probabilities of one touch from several frames, taken as independent observations of the same point.

    Args:
        log_probability: (n, n_frame, n_point), nats, normalised per frame or not.

    Returns:
        (n, n_point) float64, each row summing to 1.
    """
    return np.asarray(softmax(log_probability.sum(1), axis=-1))

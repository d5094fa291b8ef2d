"""The paths of a recording: the front end of a stream, and a tracker behind it."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np
from numpy.typing import NDArray

from acoustic_fem import Library
from localize.decoders.bayes import BayesDecoder
from localize.decoders.surroundings import sound_levels
from localize.live.stream import TouchStream
from localize.live.stream_options import MOVING, StreamOptions
from localize.signals.array_response import response_of
from localize.signals.noise_model import NoiseChoice
from localize.tracking.path import PathTracker, Track

BLOCK = 1000
"""Number of samples that are taken at once: decisions carry their frames, and those of an hour take memory."""


def track(
    library: Library,
    signals: NDArray[np.float64],
    contact_radius_mm: float = MOVING,
    microphone_noise: NoiseChoice = "design",
    ambient: float | None = None,
) -> list[Track]:
    """Paths of contacts over the surface of an array.

    Args:
        library: with a design.
        signals: (n_microphone, n_sample) float64, Pa, at 1 kHz, as :func:`localize.read_recording` gives them.
        contact_radius_mm: radius of the contact, mm.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        ambient: level of room sound, dB SPL; None for a quiet room.

    Returns:
        Paths in the order of time.

    Raises:
        Refusal: as :class:`localize.tracking.PathTracker` and :class:`localize.TouchStream`.
    """
    response = response_of(library)
    decoder = BayesDecoder(response, microphone_noise, sound_levels(ambient))
    stream = TouchStream(decoder, options=StreamOptions(frames=True))
    return tracks_of(stream, PathTracker(response, contact_radius_mm, microphone_noise, ambient), signals)


def tracks_of(
    stream: TouchStream,
    tracker: PathTracker,
    signals: NDArray[np.float64],
    hear: Callable[[Iterable[object]], None] | None = None,
) -> list[Track]:
    """Paths that a tracker finds behind a stream, both new.

    Args:
        stream: with ``StreamOptions(frames=True)``.
        tracker: of the same array.
        signals: (n_microphone, n_sample) float64, Pa, at 1 kHz.
        hear: called with the events of the stream, some at a time.
    """
    for first in range(0, signals.shape[1], BLOCK):
        events = stream.push(signals[:, first : first + BLOCK])
        if hear is not None:
            hear(events)
        for event in events:
            tracker.take(event)
    tracker.finish()
    return tracker.tracks

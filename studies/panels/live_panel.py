"""Live input of an array: the microphones' signals and what the decoder makes of them, as they come."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from typing import Any

from geometry.design.array_design import ArrayDesign
from localize.live.listener import Heard
from localize.live.sound_device import input_devices
from studies.inference.live import LiveInput, LiveSession, listen
from studies.panels.touching import decoder_of

#: Significant digits of the pressures that are sent.
_DIGITS = 4


def sound_cards() -> list[dict[str, Any]]:
    """Devices that can record: ``number``, ``name``, ``channels``, and whether each is the system's ``default``.

    Raises:
        Refusal: what a sound card needs is not installed, with what to install.
    """
    return [
        {
            "number": each.number,
            "name": each.label,
            "channels": each.channels,
            "default": each.default,
        }
        for each in input_devices()
    ]


def listen_live(
    design: ArrayDesign,
    device: int | None,
    full_scale: float,
    replay: str | os.PathLike[str] | None,
    notify: Callable[[str], None],
) -> dict[str, Any]:
    """Listen to an array until the source ends, as ``acoustic-fem live`` does with its quick library.

    Args:
        design: the array.
        device: number of the sound card; by default that of the system.
        full_scale: pressure at full scale of it, Pa.
        replay: a WAV file to play in real time in place of a sound card.
        notify: called with a line of JSON for every event: what :func:`studies.listen` writes, and beside each decision
            ``samples``: those of each microphone since the decision before, Pa at 1 kHz.

    Returns:
        ``seconds`` of input, ``touches`` and ``samples_lost``.

    Raises:
        Refusal: no such sound card, or a design that cannot be decoded.
    """
    before = 0.0

    def hear(session: LiveSession, heard: Heard, line: str) -> None:
        nonlocal before
        event = json.loads(line)
        if "state" in event:
            count = min(max(round(1000 * (event["time"] - before)), 0), session.recent.shape[1])
            newest = session.recent[:, session.recent.shape[1] - count :]
            event["samples"] = [[float(f"{value:.{_DIGITS}g}") for value in each] for each in newest]
            event["microphones"] = list(session.array.microphones)
            before = event["time"]
        notify(json.dumps(event, separators=(",", ":")))

    given = LiveInput(device=device, replay=replay, full_scale=full_scale)
    found = listen(decoder_of(design).model, given, hear=hear)
    return {"seconds": found.seconds, "touches": found.touches, "samples_lost": found.samples_lost}

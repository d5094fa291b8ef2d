"""Loudest outputs of the microphones under taps of a stated force, to compare with their overload."""

from __future__ import annotations

import math

import numpy as np

from acoustic_fem import Library
from acoustic_fem.network.microphone_output import output_response
from acoustic_fem.quantities.local_air import AirLike, design_air
from acoustic_fem.quantities.medium import Medium
from geometry.design.design_file import read_completed
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.contacts.contact import Contact
from localize.contacts.finger_gestures import TAP_SECONDS
from localize.contacts.simulated_recording import ContactRecorder
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.stimulus import SAMPLE_RATE

#: Length of the tap unless it is given, s: the geometric mean of the shortest and the longest tap of a finger.
TAP = math.sqrt(math.prod(TAP_SECONDS))
#: Silence before and after the tap, s.
_AROUND = 0.1, 0.5
#: Frequency that stands for 0 Hz in the response of a microphone, Hz.
_LEAST = 1e-3


def loudest_outputs(
    array: Library | ArrayResponse,
    force: float,
    *,
    contact_radius_mm: float = 5.0,
    seconds: float = TAP,
) -> Array:
    """Largest output of every microphone while a tap of a stated force is on each point.

    The force rises and falls as sin^2 and lies in the middle of the point. Membranes that the contact covers take their
    part of it, and large presses displace by the law of :class:`localize.contacts.LargePresses`. The output has the
    high-pass of the microphone's vent and no clipping: where it is above ``microphone.overload``, the tap is clipped.

    Args:
        array: a library, or a response, with a design.
        force: largest force of the tap, N.
        contact_radius_mm: radius of the contact, mm.
        seconds: length of the tap, s, 0.004 to 2.

    Returns:
        (n_point, n_microphone) float64, Pa at 1 kHz.

    Raises:
        Refusal: an array without a design, or a value out of range.
    """
    check_range("force", force, 0, unit="N", excluded="both")
    check_range("seconds", seconds, 0.004, 2.0, "s")
    response = response_of(array)
    stated = response.provenance.get("design")
    if not isinstance(stated, str) or response.position is None:
        raise Refusal("has no design, which states its microphones", kind=Kind.UNSUITABLE, field="array")
    design = read_completed(stated, "design")
    known = response.provenance.get("medium")
    air: AirLike = Medium(**known) if known else design_air(design)
    time = np.arange(round((sum(_AROUND) + seconds) * SAMPLE_RATE)) / SAMPLE_RATE
    inside = (time >= _AROUND[0]) & (time <= _AROUND[0] + seconds)
    course = np.where(inside, force * np.sin(np.pi * (time - _AROUND[0]) / seconds) ** 2, 0.0)
    recorder = ContactRecorder(response, microphone_noise=0.0)
    length = 4 * len(time)
    grid = np.maximum(np.fft.rfftfreq(length, 1 / SAMPLE_RATE), _LEAST)
    of_microphone = output_response(design.microphone, grid, air)
    loudest = []
    for place in response.position:
        contact = Contact(time, np.tile(place, (len(time), 1)), course, contact_radius_mm)
        spectrum = np.fft.rfft(recorder.take(contact).signals, length)
        loudest.append(np.abs(np.fft.irfft(spectrum * of_microphone, length)).max(axis=1))
    return np.array(loudest)

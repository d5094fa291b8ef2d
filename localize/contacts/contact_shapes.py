"""Contacts that touch an array: fingers, styluses, feathers, brushes, balls, insects, grains, puffs; each drawn anew.

Forces are light ones, under which membranes stay linear or nearly so: a cap of 6 mm of Shore A 30 gives way by a third
of its thickness under 15 mN, one of the fingertip arrays under 1 mN, and what presses harder rests on the shells around
it. The finger of a hand that explores presses with 0.5 N (Smith, Gosselin and Houde 2002, Experimental Brain Research
147, 209). Where no source is named, ranges are ours.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Unpack

import numpy as np
from numpy.typing import ArrayLike

from geometry.ground.argument_checks import check_range, real_numbers
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.contacts.contact import Contact
from localize.contacts.draws import Draws, Stream
from localize.signals.random_streams import StreamKind

Place = tuple[float, float]

RATE = 1000.0
"""Times per second of the contacts made here, Hz."""
QUIET = (0.1, 0.3)
"""Time before and after what presses, s: the latter for the responses to end in."""
SPEEDS = (0.1, 2000.0)
"""Lowest and highest speed of a contact, mm/s."""
LANDING = 0.03
"""Time in which a contact that moves is put down, and lifted, s."""
_GRAVITY = 9.81
_SILICONE = 1.3e6
"""Plane-strain modulus of a soft silicone membrane, Pa: Shore A 30."""


@dataclass(frozen=True)
class Tool:
    """Tool that is pressed on the array and moved: ranges from which each contact draws its own."""

    name: str
    """Name of it, the label of its strokes."""
    contact_radius_mm: tuple[float, float]
    """Smallest and largest radius of its contact, mm."""
    force: tuple[float, float]
    """Lowest and highest force, N; the logarithm is evenly spread."""
    roughness: tuple[float, float]
    """Least and most fluctuation of the force while it moves, shares, as :attr:`Contact.roughness`."""
    unsteadiness: float
    """Rms by which the hand's force moves about its mean, as a share."""


FINGER = Tool("finger", (3.0, 6.0), (2e-3, 2e-2), (0.05, 0.3), 0.15)
"""Pad of a finger: finger pads are 10 to 14 mm wide (Dandekar, Raju and Srinivasan 2003, Journal of Biomechanical
Engineering 125, 682), a light touch covers 3 to 6 mm around its middle."""
STYLUS = Tool("stylus", (0.5, 1.0), (1e-3, 1e-2), (0.02, 0.1), 0.1)
"""Tip of a stylus, of 1 to 2 mm diameter as those for screens are."""
FEATHER = Tool("feather", (2.0, 5.0), (5e-5, 5e-4), (0.3, 0.8), 0.4)
"""Edge of a feather, whose barbs let go one after the other."""
BRUSH = Tool("brush", (3.0, 6.0), (5e-4, 5e-3), (0.2, 0.5), 0.2)
"""Soft brush of 6 to 12 mm."""


def stroke(path: ArrayLike, speed: ArrayLike, tool: Tool = FINGER, **stream: Unpack[Stream]) -> Contact:
    """A stroke along a path, put down at its first place and lifted at its last: what handwriting is made of.

    Args:
        path: corners of the path, (k, 2) mm; k at least 2.
        speed: mm/s, 0.1 to 2000: one, or (k - 1,) of the pieces between corners.
        tool: what is moved; each sample draws its radius, force, roughness and unsteadiness.
        stream: ``seed``, ``purpose`` and ``sample`` of its random numbers, as of :class:`localize.contacts.Stream`.

    Raises:
        Refusal: a path of one place, or of no length; a speed out of range.
    """
    return _moved("stroke", path, speed, tool, stream)


def finger(path: ArrayLike, speed: ArrayLike, **stream: Unpack[Stream]) -> Contact:
    """A :data:`FINGER` that moves along a path, (n, 2) mm, at a speed, mm/s.

    Arguments and errors as for :func:`stroke`.
    """
    return _moved("finger", path, speed, FINGER, stream)


def stylus(path: ArrayLike, speed: ArrayLike, **stream: Unpack[Stream]) -> Contact:
    """A :data:`STYLUS` that moves along a path, (n, 2) mm, at a speed, mm/s.

    Arguments and errors as for :func:`stroke`.
    """
    return _moved("stylus", path, speed, STYLUS, stream)


def feather(path: ArrayLike, speed: ArrayLike, **stream: Unpack[Stream]) -> Contact:
    """A :data:`FEATHER` that moves along a path, (n, 2) mm, at a speed, mm/s.

    Arguments and errors as for :func:`stroke`.
    """
    return _moved("feather", path, speed, FEATHER, stream)


def brush(path: ArrayLike, speed: ArrayLike, **stream: Unpack[Stream]) -> Contact:
    """A :data:`BRUSH` that moves along a path, (n, 2) mm, at a speed, mm/s.

    Arguments and errors as for :func:`stroke`.
    """
    return _moved("brush", path, speed, BRUSH, stream)


def rolling_ball(path: ArrayLike, speed: ArrayLike, **stream: Unpack[Stream]) -> Contact:
    """A steel ball of 2 to 5 mm that rolls along a path, (n, 2) mm, at a speed, mm/s, under its own weight; arguments
    and errors as for :func:`stroke`.

    Its contact has the radius (3 F R / (4 E))^(1/3) of Hertz on silicone; it wobbles once a turn, by 5 to 20 %.
    """
    draws = Draws("rolling ball", **stream)
    size = draws.between((2.0, 5.0)) / 2e3  # m
    weight = 7800 * 4 / 3 * math.pi * size**3 * _GRAVITY
    time, places, pressed = _along_path(path, speed)
    turns = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(places, axis=0).T))]) / (2e3 * math.pi * size)
    wobble = draws.between((0.05, 0.2)) * np.sin(2 * np.pi * (turns + draws.between((0.0, 1.0))))
    radius = 1e3 * (0.75 * weight * size / _SILICONE) ** (1 / 3)
    return Contact(time, places, weight * pressed * (1 + wobble), radius, 0.02, "rolling ball")


def insect(path: ArrayLike, speed: ArrayLike, **stream: Unpack[Stream]) -> Contact:
    """An insect of 2 to 50 mg that walks along a path, (n, 2) mm, at a speed, mm/s; arguments and errors as for
    :func:`stroke`.

    Three of its six feet, 1 to 2.5 mm around its middle, carry it by turns (the alternating tripod of Wilson 1966,
    Annual Review of Entomology 11, 103): its weight moves by 20 to 60 % twice a stride, strides being 3 to 6 mm long.
    """
    draws = Draws("insect", **stream)
    weight = draws.log_between((2e-6, 50e-6)) * _GRAVITY
    time, places, pressed = _along_path(path, speed)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(places, axis=0).T))])
    steps = 2 * along / draws.between((3.0, 6.0)) + draws.between((0.0, 1.0))
    gait = 1 + draws.between((0.2, 0.6)) * np.sin(2 * np.pi * steps)
    return Contact(time, places, weight * pressed * gait, draws.between((1.0, 2.5)), 0.3, "insect")


def falling_grain(place: Place, **stream: Unpack[Stream]) -> Contact:
    """A grain of 2 to 20 mg that falls on the array from 5 to 20 mm and bounces up to four times.

    The paper lets 5 mg fall from 10 mm. Each impact is half a sine of 1 to 3 ms that turns the grain's velocity round;
    it comes back with 30 to 60 % of it, and at last lies there with its weight.

    Args:
        place: where, mm.
        stream: ``seed``, ``purpose`` and ``sample`` of its random numbers, as of :class:`localize.contacts.Stream`.
    """
    draws = Draws("falling grain", **stream)
    mass, lasts = draws.log_between((2e-6, 20e-6)), draws.between((1e-3, 3e-3))
    back = draws.between((0.3, 0.6))
    velocity = math.sqrt(2 * _GRAVITY * draws.log_between((5e-3, 20e-3)))
    time = np.arange(QUIET[0], QUIET[0] + 0.6, 1e-4) - QUIET[0]
    force = np.zeros_like(time)
    at = QUIET[0]
    for _ in range(5):
        phase = (time - at) / lasts
        impact = np.where((phase > 0) & (phase < 1), np.sin(np.pi * phase), 0.0)
        force += mass * velocity * (1 + back) * np.pi / (2 * lasts) * impact
        velocity *= back
        at += lasts + 2 * velocity / _GRAVITY
    force += np.where(time >= at, mass * _GRAVITY, 0.0)
    return Contact(time, still(place, len(time)), force, draws.between((0.1, 0.3)), 0.0, "falling grain")


def air_puff(place: Place, **stream: Unpack[Stream]) -> Contact:
    """A puff of air of 50 to 300 ms on a spot of 4 to 12 mm radius, with 1 to 10 mN and turbulence of 20 to 40 %.

    Arguments as for :func:`falling_grain`.
    """
    draws = Draws("air puff", **stream)
    lasts, force = draws.log_between((0.05, 0.3)), draws.log_between((1e-3, 1e-2))
    radius, turbulence = draws.between((4.0, 12.0)), draws.between((0.2, 0.4))
    time = times(QUIET[0] + lasts + QUIET[1])
    phase = (time - QUIET[0]) / lasts
    blown = np.where((phase > 0) & (phase < 1), np.sin(np.pi * np.clip(phase, 0, 1)) ** 2, 0.0)
    moved = np.maximum(1 + turbulence * draws.noise(time, (10.0, 200.0), 24), 0.0)
    return Contact(time, still(place, len(time)), force * blown * moved, radius, 0.0, "air puff")


def times(seconds: float) -> Array:
    """Times of a contact of a length, 1 ms apart from 0 on; (n,) float64, s."""
    return np.arange(round(seconds * RATE) + 1) / RATE


def held(kind: StreamKind, place: Place, time: Array, pressed: Array, tool: Tool, draws: Draws) -> Contact:
    """A tool that is held to one place.

    Args:
        kind: what is done with it, the label.
        place: where, mm.
        time: (n,) float64, s.
        pressed: (n,) float64, course of the force, 1 at its height.
        tool: what is held.
        draws: of the contact.
    """
    radius, force = draws.between(tool.contact_radius_mm), draws.log_between(tool.force)
    roughness = draws.between(tool.roughness)
    return Contact(
        time, still(place, len(time)), force * pressed * draws.hand(time, tool.unsteadiness), radius, roughness, kind
    )


def joined(contacts: list[Contact], label: str = "") -> Contact:
    """Contacts one after the other, as the strokes of a letter are: between two nothing presses.

    Each begins 1 ms after the one before has ended; quiet times at their ends count. All take the radius and the
    roughness of the first.

    Args:
        contacts: at least one.
        label: of the whole; that of the first where it is empty.

    Raises:
        Refusal: no contacts.
    """
    if not contacts:
        raise Refusal("is empty: at least one is needed to join", kind=Kind.MISSING, field="contacts")
    first = contacts[0]
    begin, time = float(first.time[0]), []
    for each in contacts:
        time.append(each.time - each.time[0] + begin)
        begin = float(time[-1][-1]) + 1 / RATE
    return replace(
        first,
        time=np.concatenate(time),
        path=np.concatenate([each.path for each in contacts]),
        force=np.concatenate([each.force for each in contacts]),
        label=label or first.label,
    )


def _moved(kind: StreamKind, path: ArrayLike, speed: ArrayLike, tool: Tool, stream: Stream) -> Contact:
    draws = Draws(kind, **stream)
    time, places, pressed = _along_path(path, speed)
    radius, force = draws.between(tool.contact_radius_mm), draws.log_between(tool.force)
    roughness = draws.between(tool.roughness)
    label = tool.name if kind == "stroke" else kind
    return Contact(time, places, force * pressed * draws.hand(time, tool.unsteadiness), radius, roughness, label)


def _along_path(path: ArrayLike, speed: ArrayLike) -> tuple[Array, Array, Array]:
    """Times (n,) s, places (n, 2) mm and the course of the force (n,) of what moves along a path."""
    corners = real_numbers("path", path)
    if corners.ndim != 2 or corners.shape[1:] != (2,) or len(corners) < 2 or not np.isfinite(corners).all():
        raise Refusal(
            f"has shape {corners.shape}; it must be at least two places (x, y) of finite numbers, mm",
            kind=Kind.WRONG_TYPE,
            field="path",
        )
    lengths = np.hypot(*np.diff(corners, axis=0).T)
    speeds = real_numbers("speed", speed)
    if speeds.shape not in ((), lengths.shape):
        raise Refusal(
            f"has shape {speeds.shape}; it must be one number, or {lengths.shape}, one for each piece of the path",
            kind=Kind.WRONG_TYPE,
            field="speed",
        )
    for value in speeds.flat:
        check_range("speed", value, *SPEEDS, "mm/s")
    if lengths.sum() <= 0:
        raise Refusal("has no length", kind=Kind.UNSUITABLE, field="path", remedy="press a contact that stands still")
    kept = np.concatenate([[True], lengths > 0])
    at = np.concatenate([[0.0], np.cumsum(lengths / speeds)])[kept]
    lasts = float(at[-1])
    check_range("path: time to go along it", lasts, 0.0, 1000.0, "s")
    time = times(QUIET[0] + lasts + QUIET[1])
    since = time - QUIET[0]
    places = np.column_stack([np.interp(since, at, along) for along in corners[kept].T])
    landing = min(LANDING, lasts / 2)
    edge = np.clip(np.minimum(since, lasts - since) / landing, 0.0, 1.0)
    return time, places, np.sin(np.pi / 2 * edge) ** 2


def still(place: Place, count: int) -> Array:
    """A path that stays at one place, mm: (count, 2) float64, mm."""
    spot = real_numbers("place", place)
    if spot.shape != (2,) or not np.isfinite(spot).all():
        raise Refusal(kind=Kind.WRONG_TYPE, field="place", value=place, allowed="(x, y), two finite numbers, mm")
    return np.tile(spot, (count, 1))

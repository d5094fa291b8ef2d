"""Handwriting: capital letters as strokes, and a contact that writes one.

The strokes are drawn by us, as a hand draws them: round where it is round, from the top, left to right. (Those of
:mod:`geometry.solids.stroke_font` are made to be printed: angular, and some in lower case.)
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from geometry.ground.typed import Array
from localize.contacts import FINGER, Contact, Tool, joined, stroke
from localize.contacts.contact import surface_of
from localize.signals.array_response import ArrayResponse
from localize.signals.random_streams import PURPOSES, Purpose

Stroke = list[tuple[float, float]]

LETTERS = tuple("ABCDEFGHIJKLMNOPQRSTUVWXYZ")
"""The letters that are written."""
WIDTH = 0.75
"""Width of a letter, in its heights."""


def _arc(x: float, y: float, rx: float, ry: float, begin: float, end: float) -> Stroke:
    """Piece of an ellipse about (x, y), from one angle to another, degrees, against the clock from the right."""
    angles = np.radians(np.linspace(begin, end, max(4, round(abs(end - begin) / 20) + 1)))
    return [(x + rx * math.cos(angle), y + ry * math.sin(angle)) for angle in angles]


_FONT: dict[str, list[Stroke]] = {
    "A": [[(0, 0), (0.37, 1), (0.75, 0)], [(0.15, 0.38), (0.6, 0.38)]],
    "B": [
        [(0.05, 1), (0.05, 0)],
        [(0.05, 1), *_arc(0.35, 0.76, 0.3, 0.24, 90, -90), (0.05, 0.52)],
        [(0.05, 0.52), *_arc(0.4, 0.26, 0.33, 0.26, 90, -90), (0.05, 0)],
    ],
    "C": [_arc(0.4, 0.5, 0.38, 0.5, 50, 310)],
    "D": [[(0.05, 1), (0.05, 0)], [(0.05, 1), *_arc(0.25, 0.5, 0.48, 0.5, 90, -90), (0.05, 0)]],
    "E": [[(0.65, 1), (0.05, 1), (0.05, 0), (0.65, 0)], [(0.05, 0.52), (0.55, 0.52)]],
    "F": [[(0.65, 1), (0.05, 1), (0.05, 0)], [(0.05, 0.52), (0.55, 0.52)]],
    "G": [[*_arc(0.4, 0.5, 0.38, 0.5, 50, 330), (0.74, 0.42), (0.42, 0.42)]],
    "H": [[(0.05, 1), (0.05, 0)], [(0.7, 1), (0.7, 0)], [(0.05, 0.5), (0.7, 0.5)]],
    "I": [[(0.37, 1), (0.37, 0)]],
    "J": [[(0.6, 1), (0.6, 0.28), *_arc(0.34, 0.28, 0.26, 0.28, 0, -170)]],
    "K": [[(0.05, 1), (0.05, 0)], [(0.68, 1), (0.05, 0.45)], [(0.25, 0.6), (0.72, 0)]],
    "L": [[(0.05, 1), (0.05, 0), (0.68, 0)]],
    "M": [[(0, 0), (0.08, 1), (0.37, 0.3), (0.67, 1), (0.75, 0)]],
    "N": [[(0.05, 0), (0.05, 1), (0.7, 0), (0.7, 1)]],
    "O": [_arc(0.375, 0.5, 0.375, 0.5, 90, 450)],
    "P": [[(0.05, 1), (0.05, 0)], [(0.05, 1), *_arc(0.36, 0.74, 0.32, 0.26, 90, -90), (0.05, 0.48)]],
    "Q": [_arc(0.375, 0.5, 0.375, 0.5, 90, 450), [(0.45, 0.3), (0.78, -0.05)]],
    "R": [
        [(0.05, 1), (0.05, 0)],
        [(0.05, 1), *_arc(0.36, 0.74, 0.32, 0.26, 90, -90), (0.05, 0.48), (0.3, 0.48), (0.72, 0)],
    ],
    "S": [[*_arc(0.38, 0.75, 0.32, 0.25, 40, 270), *_arc(0.38, 0.25, 0.34, 0.25, 90, -140)]],
    "T": [[(0, 1), (0.75, 1)], [(0.37, 1), (0.37, 0)]],
    "U": [[(0.05, 1), (0.05, 0.33), *_arc(0.375, 0.33, 0.325, 0.33, 180, 360), (0.7, 1)]],
    "V": [[(0, 1), (0.37, 0), (0.75, 1)]],
    "W": [[(0, 1), (0.17, 0), (0.37, 0.7), (0.58, 0), (0.75, 1)]],
    "X": [[(0.03, 1), (0.72, 0)], [(0.72, 1), (0.03, 0)]],
    "Y": [[(0.02, 1), (0.37, 0.5), (0.73, 1)], [(0.37, 0.5), (0.37, 0)]],
    "Z": [[(0.03, 1), (0.72, 1), (0.03, 0), (0.72, 0)]],
}
"""Strokes of each letter, in its heights."""


PAD = replace(FINGER, contact_radius_mm=(5.0, 8.0))
"""Pad of a finger that writes, laid flat: as wide as finger pads are, 10 to 14 mm and a little more."""


@dataclass(frozen=True)
class Hand:
    """How letters are written: ranges from which each letter draws its own."""

    speed: tuple[float, float] = (25.0, 60.0)
    """Slowest and fastest speed, mm/s; within a letter it moves by a tenth about its own."""
    size: tuple[float, float] = (0.75, 0.95)
    """Smallest and largest letter, a share of the largest that the surface takes."""
    slant: float = 0.15
    """Standard deviation of the slant, width per height, a ratio."""
    turn: float = 5.0
    """Standard deviation of the turn, degrees."""
    aspect: tuple[float, float] = (0.85, 1.2)
    """Narrowest and widest letter, ratios of its usual width."""
    wobble: float = 0.02
    """Deviation of the line, rms, in heights of the letter; it moves smoothly along the line."""
    tool: Tool = PAD
    """Tool that writes."""


def strokes_of(letter: str, hand: Hand, random: np.random.Generator) -> list[Array]:
    """Strokes of one written letter.

    Args:
        letter: one of :data:`LETTERS`.
        hand: how it is written.
        random: draws the letter.

    Returns:
        (n, 2) float64 of each stroke, in heights of the letter, about its middle, y upwards.
    """
    slant = hand.slant * float(np.clip(random.standard_normal(), -2, 2))
    turn = math.radians(hand.turn * float(np.clip(random.standard_normal(), -2, 2)))
    aspect = random.uniform(*hand.aspect)
    turned = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])
    shape = turned @ np.array([[aspect, slant], [0.0, 1.0]])
    waves = random.standard_normal((2, 2, 3))
    made = []
    for corners in _FONT[letter]:
        line = _resampled(np.array(corners) - [WIDTH / 2, 0.5])
        along = np.linspace(0, 1, len(line))[:, None] * np.array([1.0, 2.0, 3.0]) * math.pi + random.uniform(0, 6.3, 3)
        bent = np.stack([np.sin(along) @ waves[0, k] + np.cos(along) @ waves[1, k] for k in (0, 1)], 1) / math.sqrt(3)
        made.append(line @ shape.T + hand.wobble * bent)
    return made


def written(
    letter: str, response: ArrayResponse, hand: Hand, seed: int = 0, purpose: Purpose = "evaluation", sample: int = 0
) -> Contact:
    """A contact that writes a letter over the surface of an array, lifted between its strokes.

    Args:
        letter: one of :data:`LETTERS`.
        response: the array, with the places of its points.
        hand: how it is written.
        seed: any non-negative integer.
        purpose: streams of different purposes never share a number.
        sample: index of the letter in the stream.

    Raises:
        Refusal: an array without places.
    """
    random = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(PURPOSES.index(purpose), 1, sample)))
    strokes = strokes_of(letter, hand, random)
    place, _ = surface_of(response)
    low, high = place.min(0), place.max(0)
    room = high - low
    extent = np.ptp(np.concatenate(strokes), axis=0)
    height = random.uniform(*hand.size) * float((room / np.maximum(extent, 0.3)).min())
    slack = (room - height * extent).clip(0) / 2
    ends = np.concatenate(strokes)
    middle = (low + high) / 2 - height * (ends.max(0) + ends.min(0)) / 2 + slack * random.uniform(-1, 1, 2)
    speed = math.exp(random.uniform(*np.log(hand.speed)))
    pieces = []
    for line in strokes:
        speeds = speed * (1 + 0.1 * np.clip(random.standard_normal(len(line) - 1), -2, 2))
        pieces.append(
            stroke(middle + height * line, speeds, hand.tool, seed=seed, purpose=purpose, sample=sample)
        )  # one draw of the tool for the whole letter
    return joined(pieces, letter)


def _resampled(corners: Array, step: float = 0.04) -> Array:
    """Points of a line about ``step`` apart, its corners kept."""
    kept = [corners[:1]]
    for begin, end in pairwise(corners):
        count = max(1, round(float(np.hypot(*(end - begin))) / step))
        kept.append(begin + (end - begin) * np.arange(1, count + 1)[:, None] / count)
    return np.concatenate(kept)

"""Handwriting: a contact that writes a letter of an alphabet, as a hand would."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from geometry.ground.typed import Array
from localize.contacts import FINGER, Contact, Tool, joined, stroke
from localize.contacts.contact import surface_of
from localize.recognition.letter_shapes import HAND, PRINT, SCRIPT, Alphabet
from localize.recognition.recognition_options import OTHER_HANDS, VariantOptions
from localize.recognition.stroke_fonts import alphabet_of
from localize.signals.array_response import ArrayResponse
from localize.signals.random_streams import PURPOSES, Purpose

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
    alphabets: tuple[Alphabet, ...] = (HAND,)
    """Alphabets of which each letter draws one, and in it one shape."""
    reordered: float = 0.0
    """Fraction of the letters whose strokes are written in any order and direction."""
    connected: float = 0.0
    """Fraction of the letters that are written without lifting the finger between strokes."""
    hooks: float = 0.0
    """Fraction of the ends of strokes that have a hook."""
    bend: float = 0.0
    """Standard deviation of the smooth waves by which the whole letter is bent, in its heights."""
    variants: VariantOptions = VariantOptions()
    """How much the variants of its letters differ that a network is trained on."""


def training_hands(speed: tuple[float, float], fonts: tuple[str, ...]) -> tuple[Hand, ...]:
    """Hands that a network learns letters from: ours, others in print and in school script, and fonts.

    Args:
        speed: slowest and fastest speed, mm/s.
        fonts: names of :data:`localize.recognition.stroke_fonts.FONTS`; none for our shapes alone.

    Raises:
        Refusal: an unknown font.
        MissingExtra: fonts, and the package that has them is not installed.
    """
    usual = Hand(speed=speed)
    other = replace(
        usual, slant=0.25, turn=8.0, reordered=0.3, connected=0.1, hooks=0.15, bend=0.03, variants=OTHER_HANDS
    )
    printed, script = replace(other, alphabets=(PRINT,)), replace(other, alphabets=(SCRIPT,))
    if not fonts:
        return (usual, printed, script, usual, printed, script, usual)
    drawn = replace(other, alphabets=tuple(map(alphabet_of, fonts)), reordered=0.0, connected=0.0, hooks=0.05)
    return (usual, printed, script, drawn, usual, printed, script, usual, usual)


def strokes_of(letter: str, hand: Hand, random: np.random.Generator) -> list[Array]:
    """Strokes of one written letter.

    Args:
        letter: one of :data:`localize.recognition.LETTERS`.
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
    for line in _drawn(letter, hand, random):
        along = np.linspace(0, 1, len(line))[:, None] * np.array([1.0, 2.0, 3.0]) * math.pi + random.uniform(0, 6.3, 3)
        bent = np.stack([np.sin(along) @ waves[0, k] + np.cos(along) @ waves[1, k] for k in (0, 1)], 1) / math.sqrt(3)
        made.append(line @ shape.T + hand.wobble * bent)
    return made


def _drawn(letter: str, hand: Hand, random: np.random.Generator) -> list[Array]:
    """Strokes of one shape of a letter, in heights, about its middle, in the order in which they are written."""
    shapes = hand.alphabets[_one_of(len(hand.alphabets), random)][letter]
    strokes = [np.array(each) for each in shapes[_one_of(len(shapes), random)]]
    ends = np.concatenate(strokes)
    strokes = [each - [(ends[:, 0].min() + ends[:, 0].max()) / 2, 0.5] for each in strokes]
    if random.random() < hand.reordered:
        order = random.permutation(len(strokes))
        strokes = [strokes[k][:: random.choice([-1, 1])] for k in order]
    if random.random() < hand.connected:
        strokes = [np.concatenate(strokes)]
    strokes = [_hooked(each, hand, random) for each in strokes]
    lines = [_resampled(each) for each in strokes]
    if hand.bend:
        knots = hand.bend * random.standard_normal((2, 3, 3))
        lines = [each + smooth_bend(each, knots) for each in lines]
    return lines


def _one_of(count: int, random: np.random.Generator) -> int:
    """Number below ``count``; nothing is drawn where there is one."""
    return int(random.integers(count)) if count > 1 else 0


def _hooked(corners: Array, hand: Hand, random: np.random.Generator) -> Array:
    """A stroke with a hook at either end, or without."""
    for _ in range(2):  # the end, then the begin
        corners = corners[::-1]
        if random.random() < hand.hooks:
            length = random.uniform(0.06, 0.2)
            angle = random.uniform(0, 2 * math.pi)
            bow = random.uniform(-2.0, 2.0) + angle + np.linspace(0, 1, 5)[:, None] * random.uniform(-2.5, 2.5)
            steps = length / 5 * np.concatenate([np.cos(bow), np.sin(bow)], 1)
            corners = np.concatenate([(corners[0] + steps.cumsum(0))[::-1], corners])
    return corners


def smooth_bend(places: Array, knots: Array) -> Array:
    """Displacement of places of a letter by a smooth field, of one to two half waves over the letter.

    Args:
        places: (n, 2), in heights of the letter, about its middle.
        knots: (2, 3, 3) amplitudes of the waves in either direction, in heights.

    Returns:
        (n, 2) float64, in heights.
    """
    waves = np.stack([np.sin(math.pi * places * k + k) for k in (1.0, 1.5, 2.0)])  # (3, n, 2)
    return np.stack([np.einsum("in,jn,ij->n", waves[..., 0], waves[..., 1], each) for each in knots], 1)


def written(
    letter: str, response: ArrayResponse, hand: Hand, seed: int = 0, purpose: Purpose = "evaluation", sample: int = 0
) -> Contact:
    """A contact that writes a letter over the surface of an array, lifted between its strokes.

    Args:
        letter: one of :data:`localize.recognition.LETTERS`.
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

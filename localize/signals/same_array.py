"""Check that a localizer and a library are of one array: the same microphones, points and design."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from geometry.design.design_file import read_completed
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import PathLike
from localize.signals.array_facts import ArrayFacts

_NOT_OF_THE_ARRAY = ("name", "description", "air", "printing", "target")
"""Fields that may differ: what an array is called, where it is, and how its parts are printed."""


def check_same_array(localizer: ArrayFacts, library: ArrayFacts, source: PathLike) -> None:
    """Refuse a library whose microphones or points are not those of a localizer.

    Args:
        localizer: array of what names points.
        library: array of the library.
        source: the library's file, put before the message.

    Raises:
        Refusal: other microphones, or points that lie or are numbered otherwise.
    """
    own, other = (", ".join(each.microphones) for each in (localizer, library))
    if own != other:
        raise Refusal(
            f"is of another array than the localizer: its microphones are {other}, must be {own}",
            kind=Kind.MISMATCH,
            file=source,
        )
    if len(localizer.line) != len(library.line):
        raise Refusal(
            f"is of another array than the localizer: it has {len(library.line)} points, must have "
            f"{len(localizer.line)}",
            kind=Kind.MISMATCH,
            file=source,
        )
    different = (np.asarray(localizer.line) != library.line) | (np.asarray(localizer.place) != library.place)
    if different.any():
        point = int(np.flatnonzero(different)[0])
        here, there = (f"place {each.place[point]} of line {each.line[point]}" for each in (library, localizer))
        raise Refusal(
            f"is of another array than the localizer, or its points are numbered otherwise: point {point + 1} is "
            f"{here}, must be {there}",
            kind=Kind.MISMATCH,
            file=source,
        )


def check_same_design(localizer: ArrayFacts, library: ArrayFacts, source: PathLike) -> None:
    """Refuse a library of another design than a localizer's, as far as both say of which they are.

    Args:
        localizer: as of :func:`check_same_array`.
        library: the same.
        source: the same.

    Raises:
        Refusal: as :func:`check_same_array`, or a field of the designs differs.
    """
    check_same_array(localizer, library, source)
    difference = design_difference(localizer, library)
    if difference:
        raise Refusal(f"is of another design than the localizer: {difference}", kind=Kind.MISMATCH, file=source)


def design_difference(localizer: ArrayFacts, library: ArrayFacts) -> str | None:
    """First field in which the designs of a localizer and a library differ, in words; None where none is known.

    Raises:
        Refusal: one of the two was made by a version of the program whose designs are not read any more.
    """
    texts = [each.provenance.get("design") for each in (localizer, library)]
    if not all(isinstance(text, str) for text in texts):
        return None
    try:
        own, other = (read_completed(str(text), "design").completed().model_dump(mode="json") for text in texts)
    except Refusal as error:
        remedy = "compute the library and train the localizer anew with this version of the program"
        raise Refusal.of(error, kind=Kind.MISMATCH, remedy=remedy) from None
    for name, mine, theirs in _differences(own, other):
        if name.split(".")[0] not in _NOT_OF_THE_ARRAY:
            return f"{name} = {theirs}, must be {mine}"
    return None


def _differences(own: Any, other: Any, name: str = "") -> Iterator[tuple[str, Any, Any]]:
    if isinstance(own, dict) and isinstance(other, dict):
        for key in dict.fromkeys((*own, *other)):
            yield from _differences(own.get(key), other.get(key), f"{name}.{key}".lstrip("."))
    elif isinstance(own, list) and isinstance(other, list) and len(own) == len(other):
        for index, (mine, theirs) in enumerate(zip(own, other, strict=True)):
            yield from _differences(mine, theirs, f"{name}.{index}")
    elif own != other:
        yield name, own, other

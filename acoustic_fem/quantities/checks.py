"""Checks of frequencies and ports that come in from outside."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from geometry.ground.argument_checks import check_range, positive_numbers, real_numbers, wrong_type
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.text_files import read_text
from geometry.ground.typed import Array

_BAND = (1e-3, 2e3)
"""Lowest and highest frequency of a grid, Hz."""
#: Beginning of a text whose frequencies have a constant ratio.
_LOGARITHMIC = "log:"
#: Endings of files that list frequencies.
_LISTS = (".txt", ".csv")
_MOST_FREQUENCIES = 100_000

MOST_PORTS = 50
"""Most ports of a cell: each takes a solve of its own at every frequency."""


def port_points(ports: Mapping[str, ArrayLike]) -> dict[str, tuple[float, float, float]]:
    """Point (x, y, z) in mm on each port by its name: ``ports`` as (3,) float64 each.

    Raises:
        Refusal: no mapping, no port or too many, a name that is not a text, empty or ``wall`` (every face that is no
            port), or a point that is not three finite numbers.
    """
    if not isinstance(ports, Mapping):
        raise Refusal(f"must map names to points, not be a {type(ports).__name__}", kind=Kind.WRONG_TYPE, field="ports")
    if not 1 <= len(ports) <= MOST_PORTS:
        problem = f"has {counted(len(ports), 'port')}; it must have 1 to {MOST_PORTS}"
        raise Refusal(problem, kind=Kind.OUT_OF_RANGE, field="ports")
    points = {}
    for name, place in ports.items():
        if not isinstance(name, str) or name in ("", "wall"):
            raise Refusal(
                f"has the name {name!r}; it must be a text, not empty and not 'wall'",
                kind=Kind.WRONG_TYPE if not isinstance(name, str) else Kind.OUT_OF_RANGE,
                field="ports",
            )
        point = real_numbers(f"ports.{name}", place)
        if point.shape != (3,) or not np.isfinite(point).all():
            raise Refusal(
                kind=Kind.WRONG_TYPE if point.shape != (3,) else Kind.OUT_OF_RANGE,
                field=f"ports.{name}",
                value=place,
                allowed="a point of three finite numbers, mm",
            )
        points[name] = (float(point[0]), float(point[1]), float(point[2]))
    return points


FrequencyLike: TypeAlias = ArrayLike | str
"""An argument ``frequency``: numbers in Hz, or a text. The text ``FIRST:LAST:COUNT`` gives evenly spaced frequencies,
``log:FIRST:LAST:COUNT`` those of a constant ratio, and one that ends with ``.txt`` or ``.csv`` is a file that lists
them.
"""


def frequencies(frequency: FrequencyLike) -> Array:
    """The frequencies as an array, same shape as given, float64, Hz, in any order.

    Raises:
        Refusal: not real numbers, not finite or not above 0; a text of another form; a list that cannot be read.
    """
    if not isinstance(frequency, str):
        return positive_numbers("frequency", frequency, "Hz")
    stated = _stated(frequency)
    with _named(frequency):
        return positive_numbers("frequency", stated, "Hz")


def frequency_grid(frequency: FrequencyLike) -> Array:
    """The grid as an array, (n_freq,) float64, Hz, ascending within 0.001 to 2000 Hz.

    Frequency 0 is refused: a sealed network has no impedance there. All its pressures become equal as the
    frequency falls.

    Args:
        frequency: (n_freq,) Hz, or a text of :data:`FrequencyLike`, such as ``"1:500:500"`` or ``"log:1:500:100"``.

    Raises:
        Refusal: not real numbers, empty, not 1-D, not ascending, not finite or out of range, with the value; a text of
            another form; a list that cannot be read.
    """
    if not isinstance(frequency, str):
        return _ascending(real_numbers("frequency", frequency))
    stated = _stated(frequency)
    with _named(frequency):
        return _ascending(stated)


@contextmanager
def _named(text: str) -> Iterator[None]:
    """Refusals of numbers name the file that lists them, if a text names a file."""
    try:
        yield
    except Refusal as error:
        if not _is_list(text):
            raise
        raise Refusal.of(error, file=text) from None


def _ascending(grid: Array) -> Array:
    """The grid, if it is one."""
    if grid.ndim != 1 or grid.size == 0:
        raise wrong_type("frequency", f"has shape {grid.shape}; it must be a 1-D array of at least one value in Hz")
    low, high = _BAND
    for value in grid[~((grid >= low) & (grid <= high))]:
        check_range("frequency", float(value), low, high, "Hz")
    falling = np.flatnonzero(np.diff(grid) <= 0)
    if falling.size:
        problem = f"must ascend: {grid[falling[0] + 1]:g} Hz follows {grid[falling[0]]:g} Hz"
        raise Refusal(problem, kind=Kind.OUT_OF_RANGE, field="frequency")
    return grid


def _stated(text: str) -> Array:
    """The frequencies that a text names, in Hz."""
    if _is_list(text):
        return _listed(text)
    rest = text.removeprefix(_LOGARITHMIC)
    allowed = (
        "FIRST:LAST:COUNT or log:FIRST:LAST:COUNT in Hz with COUNT from 1 to 100000, or a .txt or .csv file that lists "
        "frequencies"
    )
    try:
        first, last, count = rest.split(":")
        start, stop, number = float(first), float(last), int(count)
    except ValueError:
        raise Refusal(kind=Kind.WRONG_TYPE, field="frequency", value=text, allowed=allowed) from None
    if not 1 <= number <= _MOST_FREQUENCIES:
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="frequency", value=text, allowed=allowed)
    if number == 1 and start != stop:
        problem = "needs a COUNT of at least 2, because FIRST and LAST differ"
        raise Refusal(problem, kind=Kind.OUT_OF_RANGE, field="frequency", value=text)
    if rest == text:
        return np.linspace(start, stop, number)
    if not (start > 0 and stop > 0):
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="frequency", value=text, allowed="FIRST and LAST above 0 Hz")
    return np.geomspace(start, stop, number)


def _is_list(text: str) -> bool:
    """True if a text names a file that lists frequencies."""
    return text.lower().endswith(_LISTS)


def _listed(path: str) -> Array:
    """The numbers in a text file, separated by white space or commas; what follows # in a line is a remark.

    The first line may be a heading. Then each line below it holds one frequency, because a second column would hold
    something else.
    """
    text = read_text(path, "a list of frequencies", Refusal)
    contents = (line.partition("#")[0].replace(",", " ").strip() for line in text.splitlines())
    lines = [content for content in contents if content]
    if lines and _is_heading(lines[0]):
        for line in lines[1:]:
            if len(line.split()) > 1:
                allowed = "one frequency in Hz, because the file has a heading"
                raise Refusal(kind=Kind.WRONG_TYPE, file=path, field="frequency", value=line, allowed=allowed)
        del lines[0]
    words = " ".join(lines).split()
    if not 1 <= len(words) <= _MOST_FREQUENCIES:
        problem = f"holds {counted(len(words), 'frequency')}; it must hold 1 to {_MOST_FREQUENCIES}"
        raise Refusal(problem, kind=Kind.OUT_OF_RANGE, file=path)
    values = np.empty(len(words))
    for k, word in enumerate(words):
        try:
            values[k] = float(word)
        except ValueError:
            allowed = "numbers in Hz, separated by white space or commas, below at most one heading without digits"
            raise Refusal(kind=Kind.WRONG_TYPE, file=path, field="frequency", value=word, allowed=allowed) from None
    return values


def _is_heading(line: str) -> bool:
    """True if a line has no digit, and no word such as ``nan`` that is read as a number."""
    return not any(each.isdigit() for each in line) and not any(_is_number(word) for word in line.split())


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True

"""Files that are often given in place of a library: their content, and what to give instead."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

from acoustic_fem.library.netcdf_file import LibraryError
from geometry.ground.refusal import Kind

_SOURCE = "convert the library that it was made from"
#: Option line or first keyword of a Touchstone file, behind its remarks.
_TOUCHSTONE = re.compile(rb"(\s*!.*\n)*\s*(#\s*([kmgt]?hz|[syzgh]|ri|ma|db|r)\b|\[version\])", re.I)
#: Beginnings of files: what each is, and what to do.
_BEGINNINGS = (
    (re.compile(rb"\*.*as a circuit, by acoustic-fem"), "is a circuit that convert wrote", _SOURCE),
    (
        re.compile(rb"\*|\.subckt\b", re.I),
        "is a SPICE netlist",
        "give a library: convert reads no netlists",
    ),
    (_TOUCHSTONE, "is a Touchstone file", "give a library, or the measurement as SOFA or CSV: docs/formats.md"),
    (re.compile(rb"RIFF|fLaC|FORM"), "is a recording of sound", "make a library of recordings with calibrate"),
    (re.compile(rb"\s*\{"), "holds JSON", "give a library"),
)
#: Arrays of a file by which its content is known, what it is, and what to do.
_ARRAYS = (
    ({"A", "B", "C", "D", "poles"}, "is a state space that convert wrote", _SOURCE),
    ({"A", "B", "C", "D"}, "is a state space", "give a library: convert reads no state spaces"),
    ({"signals"}, "is a recording", "make a library of recordings with calibrate"),
)


def refuse_other_content(path: Path, head: bytes) -> None:
    """Reject a file whose first bytes are those of something else than a library.

    Args:
        path: of the file.
        head: its first bytes.

    Raises:
        LibraryError: a circuit, a Touchstone file, sound, JSON, a design.
    """
    if path.suffix.lower() == ".toml":
        raise _not_a_library(path, "is a design, a study or a manifest", "compute the library of a design with solve")
    for beginning, what, remedy in _BEGINNINGS:
        if beginning.match(head):
            raise _not_a_library(path, what, remedy)


def refuse_other_arrays(path: Path, names: Iterable[str]) -> None:
    """Reject a file of arrays whose names are those of something else than a library.

    Args:
        path: of the file.
        names: of its arrays.

    Raises:
        LibraryError: a state space or a recording.
    """
    found = set(names)
    for known, what, remedy in _ARRAYS:
        if known <= found and "frequency" not in found:
            raise _not_a_library(path, what, remedy)


def _not_a_library(path: Path, what: str, remedy: str) -> LibraryError:
    return LibraryError(f"{what}, not a library", kind=Kind.UNSUITABLE, file=path, remedy=remedy)

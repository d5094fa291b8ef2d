"""Write docs/architecture.md and print the tables of its rooms: ``python docs/make_architecture.py``.

The face of a room, its ``__init__.py``, says in one sentence what lives there and on which rooms of its package it
stands. These sentences are the one table of the house: the site shows them, and tests/house holds the imports of all
modules against them.
"""

from __future__ import annotations

import ast
import re
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
#: Each may import from those before it.
PACKAGES = ("geometry", "acoustic_fem", "localize", "studies")
PAGE = ROOT / "docs" / "architecture.md"

_HEAD = """# Architecture

<!-- `python docs/make_architecture.py` writes this page and prints its tables, which the site makes from the faces. -->

One design file in; trusted transfer functions, a trained localizer and printable parts out:

```text
design.toml -> ArrayDesign -> CAD parts -------------------------> STL / 3MF / STEP + print report
                   |-> air of each distinct cell -> mesh -> FEM -> port admittances
                   |-> tubes (plane wave), membranes (elastic FEM), microphones
                                   \\-> network -> library -> data set -> features -> localizer -> ONNX, live stream
                   study = many of these, in parallel, resumable -> table of figures, plots, report
```

An array of 216 points has two or three *distinct* cells. Each is solved once in 3-D, condensed to its ports and kept
on disk; the network of ports is solved for all points, microphones and frequencies at once. A change of tube length,
membrane or wiring needs no new 3-D solve.

Four packages, each of which may import from those before it: `geometry` (what the sensor is, in mm), `acoustic_fem`
(what it does, in SI), `localize` (what the signals say), `studies` (what the designer asks). Each is a house of
rooms: folders of modules with one subject, a dozen as a habit. A room's face, its `__init__.py` with a stub beside it,
says what lives there, lists its public names, imported when first used, and names the rooms it stands on: within a
package its modules import from these alone, also inside functions and for types, and never in a circle. Below, a room
stands on rooms above it. Every error raised on purpose derives from
`geometry.Refusal`, in `geometry.ground`.

Public are the names of the faces; everything else may move without notice. The site has a page of every room.
"""


@dataclass(frozen=True)
class Room:
    """A folder of modules with one subject."""

    package: str
    name: str
    purpose: str
    """What lives there: the face's first sentence."""
    stands_on: tuple[str, ...]
    """Rooms of the same package from which its modules may import."""
    modules: tuple[tuple[str, str], ...]
    """Name and first sentence of each module but the face."""

    @property
    def path(self) -> str:
        """Dotted path of the room."""
        return f"{self.package}.{self.name}"


def read_rooms(root: Path = ROOT) -> tuple[Room, ...]:
    """The rooms of the packages below a folder, packages in the order of imports, rooms from the ground up.

    Raises:
        ValueError: a face that does not say what its room stands on, or stands on a room that there is not.
    """
    rooms = []
    for package in PACKAGES:
        found = {}
        for face in sorted((root / package).glob("*/__init__.py")):
            text = ast.get_docstring(ast.parse(face.read_text(encoding="utf-8"))) or ""
            stated = re.search(r"^Stands on: ([\w, ]+)\.$", text, re.MULTILINE)
            if stated is None:
                raise ValueError(f"{face}: does not say which rooms it stands on: 'Stands on: stated, design.'")
            names = () if stated.group(1) == "nothing" else tuple(stated.group(1).split(", "))
            purpose = " ".join(text[: stated.start()].split())
            modules = tuple(
                (path.stem, _first_sentence(path)) for path in sorted(face.parent.glob("*.py")) if path != face
            )
            found[face.parent.name] = Room(package, face.parent.name, purpose, names, modules)
        rooms += _from_the_ground_up(found)
    return tuple(rooms)


def _from_the_ground_up(rooms: dict[str, Room]) -> list[Room]:
    """Every room after those it stands on."""
    placed: dict[str, Room] = {}
    while len(placed) < len(rooms):
        ready = [room for name, room in rooms.items() if name not in placed and {*room.stands_on} <= placed.keys()]
        if not ready:
            left = {name: room.stands_on for name, room in rooms.items() if name not in placed}
            raise ValueError(f"these rooms stand on each other in a circle, or on none that there is: {left}")
        placed |= {room.name: room for room in ready}
    return list(placed.values())


def _first_sentence(path: Path) -> str:
    text = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or ""
    return " ".join(text.split("\n\n")[0].split())


def architecture_page() -> str:
    """The page as Markdown, in which the site puts a table of rooms per package."""
    return _HEAD + "".join(f"\n## {package}\n\n```{{rooms}} {package}\n```\n" for package in PACKAGES)


def room_table(rooms: tuple[Room, ...], package: str) -> str:
    """Markdown table of the rooms of a package: name, what lives there, on which rooms it stands."""
    rows = (
        f"| `{room.name}` | {room.purpose} | {', '.join(room.stands_on) or '-'} |\n"
        for room in rooms
        if room.package == package
    )
    return "| room | what lives there | stands on |\n|---|---|---|\n" + "".join(rows)


if __name__ == "__main__":
    PAGE.write_text(architecture_page(), encoding="utf-8")
    for name in PACKAGES:
        print(f"{name}\n\n{room_table(read_rooms(), name)}")

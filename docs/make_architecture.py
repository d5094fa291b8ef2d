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

This page is for you if you want to change the program or find your way in its code. It shows how a design becomes
results, and which part of the code may use which other part.

A design file is the only input. From it come transfer functions, a trained localizer, and parts that you can print:

```text
design.toml -> ArrayDesign -> CAD parts -------------------------> STL / 3MF / STEP + print report
                   |-> air of each distinct cell -> mesh -> FEM -> port admittances
                   |-> tubes (plane wave), membranes (elastic FEM), microphones
                                   \\-> network -> library -> data set -> features -> localizer -> ONNX, live stream
                   study = many of these, in parallel, resumable -> table of figures, plots, report
```

A *cell* is a cavity with the first piece of each of its tubes. An array of 216 points has only two or three distinct
cells, so each of these is solved once in 3-D. The solution is reduced to the admittances between the cell's ports and
kept on disk. A network of these ports is then solved for all points, microphones and frequencies at once. If you change
the length of a tube, a membrane or the wiring, no new 3-D solution is needed.

## Packages and rooms

There are four packages. Each may import from those before it, but never from those after it:

| package | subject |
|---|---|
| `geometry` | the sensor as it is built, in millimetres |
| `acoustic_fem` | its acoustics, in SI units |
| `localize` | touches from the signals of its microphones |
| `studies` | the questions of a designer, and the command line |

A package consists of rooms. A room is a folder of modules with one subject, usually about a dozen. Its `__init__.py`,
with a stub beside it, is the *face* of the room. The face says what lives there, and it lists the public names, which
are imported when they are first used. Everything else may move without notice, so import only from a face. The site has
a page for each room.

A face also lists the rooms of its package on which the room stands. Its modules import only from these. The rule also
holds inside functions and for types. Imports never form a circle. In the tables below, a room stands only on rooms
above it.

Every error that the program raises on purpose derives from `geometry.Refusal`, which lives in `geometry.ground`.
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
            stated = re.search(r"^Stands on: ([\w,\s]+)\.$", text, re.MULTILINE)
            if stated is None:
                raise ValueError(f"{face}: does not say which rooms it stands on: 'Stands on: stated, design.'")
            names = () if stated.group(1) == "nothing" else tuple(re.split(r",\s+", stated.group(1)))
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

"""Everything to print, in the numbers needed, laid out on the plates of a machine: one 3MF file per plate."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, get_args

import numpy as np

from geometry.assembly.part_list import part_set
from geometry.formats.part_files import SharedShape, tessellate_distinct
from geometry.formats.three_mf import Body, read_3mf, write_3mf
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from geometry.ground.whole_files import whole_file
from geometry.molds.mold import MoldKind
from geometry.printing.pose import MARGIN, Pose, find_pose
from geometry.schema.print_processes import PrintProcess

if TYPE_CHECKING:
    import cadquery as cq


#: End of the name of a plate of molds.
_OF_MOLDS = "-molds"


@dataclass(frozen=True, eq=False)
class Plate:
    """A plate of a machine and what lies on it."""

    path: Path
    """Path of its 3MF file."""
    places: dict[str, tuple[Array, ...]]
    """Matrix that lays each copy of each part, by name, (4, 4) float64 each, mm."""

    @property
    def copies(self) -> dict[str, int]:
        """How many copies of each part lie on it, by name."""
        return {name: len(places) for name, places in self.places.items()}

    @property
    def holds_molds(self) -> bool:
        """True for a plate of molds, which are printed before the array."""
        return self.path.stem.endswith(_OF_MOLDS)


@dataclass(frozen=True)
class Plates:
    """All plates of a job."""

    plates: tuple[Plate, ...]
    """Every plate, in order."""
    too_large: tuple[str, ...]
    """Names of parts that lie on no plate, since they are wider than it."""
    spares: Mapping[str, int] = field(default_factory=dict)
    """How many spare copies of each part lie on the plates, by name."""


def export_plates(
    parts: Mapping[str, cq.Workplane],
    folder: str | os.PathLike[str],
    process: PrintProcess,
    shapes: Sequence[SharedShape] | None = None,
    spares: Mapping[str, int] | None = None,
) -> Plates:
    """Write ``folder/plate-1.3mf``, ...: every printed part as often as it is needed, in rows, none over another.

    Parts of molds come first, on plates of their own, ``plate-1-molds.3mf``: a mold serves many arrays, and its
    membranes cure while the array is printed. Each shape is stored once however often it lies there, in its own
    coordinates, and laid on the plate, z = 0, in the pose in which the report judges it.

    Args:
        parts: as of :func:`geometry.print_report`; cast and bought ones are left out.
        folder: exists.
        process: its build volume is the size of a plate.
        shapes: of :func:`geometry.formats.part_files.tessellate_distinct`, where they exist already.
        spares: spare copies of parts, by name; those are laid beside the others that take no further plate.

    Raises:
        Refusal: nothing is printed, or nothing fits.
    """
    known = part_set(parts)
    molds: Copies = []
    others: Copies = []
    too_large: list[str] = []
    for shape in tessellate_distinct(parts) if shapes is None else shapes:
        if known.origin(shape.names[0]) != "printed":
            continue
        pose = find_pose(shape.facets, process)
        if not pose.fits:
            too_large += shape.names
            continue
        copies = molds if known.kinds.get(shape.names[0]) in get_args(MoldKind) else others
        copies += [(shape, pose)] * sum(known.counts.get(name, 1) for name in shape.names)
    spare_copies = _with_spares(others, spares or {}, process)
    others += spare_copies
    if not molds and not others:
        problem = f"none of {', '.join(parts) or 'none'} can be laid on the plate of {process.name}"
        raise Refusal(problem, kind=Kind.UNSUITABLE)
    plates = []
    jobs = [(_OF_MOLDS, placed) for placed in _packed(molds, process)]
    jobs += [("", placed) for placed in _packed(others, process)]
    for number, (suffix, placed) in enumerate(jobs, start=1):
        distinct = {shape.names[0]: shape for shape, _ in placed}
        bodies = [
            Body(
                name,
                shape.facets,
                known.parameters.get(name, {}),
                tuple(place for other, place in placed if other.names == shape.names),
            )
            for name, shape in distinct.items()
        ]
        path = Path(folder) / f"plate-{number}{suffix}.3mf"
        with whole_file(path) as beside:
            write_3mf(bodies, path.stem, beside, design_toml=known.design_toml)
            if (read := sorted(read_3mf(beside))) != sorted(distinct):
                problem = f"has the parts {', '.join(read)} instead of {', '.join(sorted(distinct))}"
                raise Refusal(problem, kind=Kind.NO_RESULT, file=path)
        plates.append(Plate(path, {body.name: tuple(body.places) for body in bodies}))
    laid = Counter(shape.names[0] for shape, _ in spare_copies)
    return Plates(tuple(plates), tuple(too_large), dict(laid))


Placed = list[tuple[SharedShape, Array]]
Copies = list[tuple[SharedShape, Pose]]


def _with_spares(copies: Copies, spares: Mapping[str, int], process: PrintProcess) -> Copies:
    """Spare copies that fit beside the others on as many plates, one by one, those of each part in turn."""
    distinct = {shape.names[0]: (shape, pose) for shape, pose in copies}
    left = {name: sum(spares.get(each, 0) for each in shape.names) for name, (shape, _) in distinct.items()}
    most, added = _plates_taken(copies, process), Copies()
    while any(left.values()):
        for name in [name for name, number in left.items() if number]:
            if _plates_taken([*copies, *added, distinct[name]], process) > most:
                left[name] = 0
            else:
                added.append(distinct[name])
                left[name] -= 1
    return added


def _plates_taken(copies: Copies, process: PrintProcess) -> int:
    return 1 + max((plate for *_, plate in _rows(copies, process)), default=-1)


def _rows(copies: Copies, process: PrintProcess) -> Iterator[tuple[SharedShape, Pose, float, float, int]]:
    """Copies in rows from the deepest on, each with its corner on its plate (mm) and the number of the plate.

    A new plate begins where the next row does not fit. A margin of MARGIN stays free for a brim and supports, except
    beside a part that needs it.
    """
    width, depth, _ = process.build_volume
    x = y = row = 0.0
    plate = 0
    for shape, pose in sorted(copies, key=lambda copy: -copy[1].size[1]):
        size = pose.size
        if x > 0 and x + size[0] > width - 2 * MARGIN:
            x, y, row = 0.0, y + row + MARGIN, 0.0
        if y > 0 and y + size[1] > depth - 2 * MARGIN:
            plate += 1
            x = y = row = 0.0
        yield shape, pose, x, y, plate
        x += size[0] + MARGIN
        row = max(row, size[1])


def _packed(copies: Copies, process: PrintProcess) -> list[Placed]:
    """Copies as they lie on each plate, in its middle."""
    width, depth, _ = process.build_volume
    plates: list[Placed] = [[] for _ in range(_plates_taken(copies, process))]
    for shape, pose, x, y, plate in _rows(copies, process):
        matrix = np.eye(4)
        matrix[:3, :3] = pose.rotation
        matrix[:3, 3] = np.array([x, y, 0.0]) - (shape.facets.vertices @ pose.rotation.T).min(axis=0)
        plates[plate].append((shape, matrix))
    for placed in plates:
        _centre(placed, (width, depth))
    return plates


def _centre(placed: Placed, plate: tuple[float, float]) -> None:
    """Move all copies of a plate to its middle."""
    corners = [shape.facets.vertices @ place[:3, :3].T + place[:3, 3] for shape, place in placed]
    used = np.max([each.max(axis=0) for each in corners], axis=0)[:2]
    for _, place in placed:
        place[:2, 3] += (plate - used) / 2

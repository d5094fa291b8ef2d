"""How the lines of a batch are wired: what all its designs have in common."""

from __future__ import annotations

from dataclasses import dataclass, replace

from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.schema.part_fields import Tube


@dataclass(frozen=True)
class LineWiring:
    """A chain of points between two microphones; tubes and points are columns of the parameters."""

    first: int
    """Index of the microphone at its first end."""
    last: int
    """Index of the microphone at its second end."""
    tubes: tuple[int, ...]
    """Columns of its n_point + 1 tubes, from the first microphone to the second."""
    points: tuple[int, ...]
    """Columns of its n_point points, from the first microphone to the second."""


@dataclass(frozen=True)
class Topology:
    """The wiring of an array; points are numbered line by line."""

    microphones: tuple[int, ...]
    """Column of the parameters of each microphone."""
    lines: tuple[LineWiring, ...]
    """Every line, in the order of the points."""
    tube_names: tuple[str, ...]
    """Name of each column of tubes."""

    def __post_init__(self) -> None:
        count = len(self.microphones)
        reached = {0}
        for number, line in enumerate(self.lines, 1):
            if not (0 <= line.first < count and 0 <= line.last < count) or line.first == line.last:
                raise Refusal(
                    f"joins microphones {line.first + 1} and {line.last + 1}; it must be two different ones of 1 to "
                    f"{count}",
                    kind=Kind.OUT_OF_RANGE,
                    field=f"lines.{number}",
                )
            if not line.points or len(line.tubes) != len(line.points) + 1:
                raise Refusal(
                    f"has {counted(len(line.points), 'point')} and {counted(len(line.tubes), 'tube')}; it must have at "
                    "least one point and one tube more than points",
                    kind=Kind.MISMATCH,
                    field=f"lines.{number}",
                )
        for _ in self.lines:
            reached |= {
                end for line in self.lines if reached & {line.first, line.last} for end in (line.first, line.last)
            }
        if len(reached) < count:
            raise Refusal(
                f"leave microphone {min(set(range(count)) - reached) + 1} without a connection to microphone 1",
                kind=Kind.CONFLICT,
                field="lines",
            )

    @classmethod
    def of(cls, design: ArrayDesign) -> Topology:
        """The wiring of a design.

        One column for each tube of the design file that is in use, one for each kind of points, one for all
        microphones.
        """
        names = tuple(tubes_in_use(design))
        columns = {name: column for column, name in enumerate(names)}
        kinds, start = design.kind_of_point, 0
        lines = []
        for number, line in enumerate(design.lines):
            tubes = tuple(columns[name] for name in design.tube_fields_of(number))
            first, last = (design.microphones.index(name) for name in line.between)
            lines.append(LineWiring(first, last, tubes, kinds[start : start + line.points]))
            start += line.points
        return cls((0,) * len(design.microphones), tuple(lines), names)

    @property
    def point_count(self) -> int:
        """Number of points."""
        return sum(len(line.points) for line in self.lines)

    def individual(self) -> Topology:
        """The same wiring with a column for every tube, point and microphone, in the order of the lines."""
        lines, names = [], []
        tube = point = 0
        for number, line in enumerate(self.lines):
            size = len(line.points)
            tubes, points = tuple(range(tube, tube + size + 1)), tuple(range(point, point + size))
            lines.append(replace(line, tubes=tubes, points=points))
            names += [f"tube {k} of line {number + 1}" for k in range(1, size + 2)]
            tube, point = tube + size + 1, point + size
        return Topology(tuple(range(len(self.microphones))), tuple(lines), tuple(names))


def tubes_in_use(design: ArrayDesign) -> dict[str, Tube]:
    """The tubes in use, by the name of the field that states them."""
    tubes: dict[str, Tube] = {}
    for number, line in enumerate(design.lines):
        tubes |= zip(design.tube_fields_of(number), design.tubes_of(line), strict=True)
    return tubes

"""Lines as chains of two-ports, condensed from both of their ends point by point, all frequencies at once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import ComplexArray


class TwoPort(NamedTuple):
    """A reciprocal two-port: volume velocities into its ends per pressure there."""

    first: ComplexArray
    """Y11, (n_freq,) complex128, m^3/(Pa s)."""
    transfer: ComplexArray
    """Y12 = Y21, (n_freq,) complex128, m^3/(Pa s)."""
    last: ComplexArray
    """Y22, (n_freq,) complex128, m^3/(Pa s)."""


def join(left: TwoPort, right: TwoPort) -> TwoPort:
    """Two two-ports in series, their common node eliminated; any shapes that broadcast."""
    between = left.last + right.first
    share = left.transfer / between
    return TwoPort(
        left.first - share * left.transfer,
        -share * right.transfer,
        right.last - right.transfer**2 / between,
    )


class PointCell(NamedTuple):
    """The cell of a point between its two tubes and its membrane, what loads the membrane included.

    Entries of its symmetric nodal admittance, (n, n_freq) complex128, m^3/(Pa s); the membrane is node 3.
    """

    y11: ComplexArray
    """Admittance of the tube towards the first microphone, (n, n_freq)."""
    y12: ComplexArray
    """Between the tubes, (n, n_freq)."""
    y22: ComplexArray
    """Admittance of the tube towards the second microphone, (n, n_freq)."""
    y13: ComplexArray
    """Between the first tube and the membrane, (n, n_freq)."""
    y23: ComplexArray
    """Between the second tube and the membrane, (n, n_freq)."""
    y33: ComplexArray
    """Admittance at the membrane, (n, n_freq)."""

    def passed(self) -> TwoPort:
        """The cell as a two-port between its tubes."""
        first, last = self.y13 / self.y33, self.y23 / self.y33
        return TwoPort(self.y11 - first * self.y13, self.y12 - first * self.y23, self.y22 - last * self.y23)

    def at_membrane(self, before: ComplexArray, after: ComplexArray) -> tuple[ComplexArray, ComplexArray, ComplexArray]:
        """Pressures at the tubes and at the membrane per volume velocity injected there.

        Args:
            before: admittance that loads the first tube, (n, n_freq) complex128, m^3/(Pa s).
            after: admittance that loads the second tube, shape as before.

        Returns:
            At the first tube, the second and the membrane, (n, n_freq) complex128 each, Pa s/m^3.
        """
        # the last column of the inverse, by elimination in the order of the nodes
        first = 1 / (self.y11 + before)
        between, outer = self.y12 * first, self.y13 * first
        second = self.y22 + after - between * self.y12
        coupling = (self.y23 - between * self.y13) / second
        membrane = 1 / (self.y33 - outer * self.y13 - coupling * coupling * second)
        last = -coupling * membrane
        return -outer * membrane - between * last, last, membrane


@dataclass(frozen=True, eq=False)
class Chain:
    """A line between its two microphone chambers, membranes included."""

    whole: TwoPort
    """The line as a two-port, (n_freq,)."""
    own: ComplexArray
    """Impedance at each membrane while both ends of the line are held at zero pressure, (n_point, n_freq) complex128,
    Pa s/m^3.
    """
    share: tuple[ComplexArray, ComplexArray]
    """Cavity pressure per pressure at the first end of the line and at the second, (n_point, n_freq) complex128 each.

    By reciprocity also the volume velocity out of that end, held at zero, per volume velocity injected.
    """


def chains_of(cells: PointCell, ducts: TwoPort, lines: Sequence[tuple[Sequence[int], Sequence[int]]]) -> list[Chain]:
    """Condense lines.

    Args:
        cells: those that differ, (n_cell, n_freq).
        ducts: those that differ, (n_duct, n_freq).
        lines: per line the index of the cell of each point, and of the ducts between them and at both ends.
    """
    chains: dict[int, Chain] = {}
    for count in {len(points) for points, _ in lines}:
        alike = [index for index, (points, _) in enumerate(lines) if len(points) == count]
        points, tubes = (np.array([lines[index][part] for index in alike]) for part in (0, 1))
        chains |= dict(zip(alike, _equally_long(cells, ducts, points, tubes), strict=True))
    return [chains[index] for index in range(len(lines))]


def _equally_long(
    cells: PointCell, ducts: TwoPort, points: NDArray[np.intp], tubes: NDArray[np.intp]
) -> Iterator[Chain]:
    """Lines of equally many points, with indices of their cells (n_line, n_point) and ducts (n_line, n_point + 1)."""
    # A line seen from its other end is a line: both ways side by side, a cell and the duct behind it at every step.
    passes = cells.passed()
    there = _steps(passes, ducts, points, tubes[:, 1:])
    back = _steps(_turned(passes), _turned(ducts), points[:, ::-1], tubes[:, -2::-1])
    ahead = [_both(_at(ducts, tubes[:, 0]), _at(_turned(ducts), tubes[:, -1]))]
    for forth, home in zip(there, back, strict=True):
        ahead.append(join(ahead[-1], _both(forth, home)))
    for line, places in enumerate(points):
        before, before_way = (np.stack([part[k][0, line] for part in ahead[:-1]]) for k in (2, 1))
        after, after_way = (np.stack([part[k][1, line] for part in ahead[-2::-1]]) for k in (2, 1))
        first, last, own = PointCell(*(entry[places] for entry in cells)).at_membrane(before, after)
        yield Chain(TwoPort(*(part[0, line] for part in ahead[-1])), own, (-first * before_way, -last * after_way))


def _steps(passes: TwoPort, ducts: TwoPort, points: NDArray[np.intp], tubes: NDArray[np.intp]) -> Iterator[TwoPort]:
    """At each place of lines (n_line, n_point) the cell joined with the duct behind it, (n_line, n_freq)."""
    count = len(ducts.first)
    pairs, which = np.unique(points * count + tubes, return_inverse=True)
    joined = join(_at(passes, pairs // count), _at(ducts, pairs % count))
    return (_at(joined, place) for place in which.reshape(points.shape).T)


def _at(two_ports: TwoPort, index: NDArray[np.intp]) -> TwoPort:
    return TwoPort(*(part[index] for part in two_ports))


def _turned(two_port: TwoPort) -> TwoPort:
    """As seen from its second end."""
    return TwoPort(two_port.last, two_port.transfer, two_port.first)


def _both(there: TwoPort, back: TwoPort) -> TwoPort:
    return TwoPort(*(np.stack(pair) for pair in zip(there, back, strict=True)))

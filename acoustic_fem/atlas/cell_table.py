"""The table of the atlas: what 3-D adds to cells in closed form, within which bounds, and how well it is known.

Made by ``benchmarks/atlas`` from cells solved in 3-D. Everything in it is a number without units: lengths count in
each other, impedances of openings in mu / a^3, inertances of cavities in rho / R, compliances in a^3 / p.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.atlas.polynomial import ShapePolynomial, layer_number
from geometry.ground.caller_warnings import warn_caller
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import parse_json, read_text
from geometry.ground.typed import Array, NumpyOrTorch

#: Enclosure that a cavity belongs to: its tubes open under a membrane or into the chamber of a microphone.
Enclosure = Literal["resonator", "microphone"]

#: Parts of the table on which answers depend.
_DECISIVE = ("bounds", "openings", "storage", "passage", "to_membrane")
#: The table that comes with the package.
FILE = Path(__file__).with_name("cell_atlas.json")


class OutsideAtlas(Refusal):
    """A cell, its air or a frequency lies outside the bounds of the atlas; the message says which and where."""


TOUCHES_UP_TO = 500.0
"""Highest frequency of the signals of touches, Hz: half their sample rate."""


@dataclass(frozen=True, eq=False)
class Opening:
    """Shapes of openings of tubes into cavities, as arrays or tensors that broadcast with each other."""

    radius: NumpyOrTorch
    """Radius a of the bore, scalar or (n_design, 1, 1) float64, m."""
    cavity_radius: NumpyOrTorch
    """Radius R of the cavity, scalar or (n_design, 1, 1) float64, m."""
    cavity_height: NumpyOrTorch
    """Height of the cavity, scalar or (n_design, 1, 1) float64, m."""
    port_height: NumpyOrTorch
    """Height of the bore's axis above the floor, scalar or (n_design, 1, 1) float64, m."""
    hole_radius: NumpyOrTorch | None = None
    """Radius of the sound hole of a chamber, scalar or (n_design, 1, 1) float64, m; None under a membrane."""

    @property
    def ratios(self) -> tuple[NumpyOrTorch, NumpyOrTorch, NumpyOrTorch]:
        """A by R, by the distance to the floor, and by that to the ceiling; shape of the radius, float64."""
        above = self.cavity_height - self.port_height
        return self.radius / self.cavity_radius, self.radius / self.port_height, self.radius / above


@dataclass(frozen=True, eq=False)
class CellAtlas:
    """The atlas: corrections by shape, bounds and errors."""

    digest: str
    """First 12 hexadecimal digits of the SHA-256 of what decides answers: other answers, another digest."""
    openings: Mapping[Enclosure, ShapePolynomial]
    """Resistance, and inertance by s^2, of an opening in mu / a^3, over a/R, the sum and the product of a by the
    distances to floor and ceiling."""
    storage: ShapePolynomial
    """Compliance that an opening adds to its cavity, in a^3 / p, over a/R."""
    passage: Array
    """Inertance that two openings share, in rho / R, over powers 0 to 2 of R/H and 0 to 1 of the port's place,
    (3, 2) float64."""
    to_membrane: Array
    """Inertance that an opening and the membrane have in common, as ``passage``, (3, 2) float64."""
    bounds: Mapping[Enclosure, Mapping[str, tuple[float, float]]]
    """Least and greatest value of each ratio."""
    errors: Mapping[str, float]
    """Largest relative errors that were found on cells and designs which took no part in the making."""
    provenance: Mapping[str, Any]
    """How it was made: versions, meshes, seeds, date."""

    @property
    def known_up_to(self) -> float:
        """Frequency up to which the errors were found, Hz."""
        return float(self.provenance["held-out designs"]["highest"])

    def warn_above(self, frequency: Array) -> None:
        """Warn that errors are not known at the highest of frequencies, where that is above those of touches.

        The default grid of libraries ends at 500 Hz, half the sample rate of touches, and the band of use at 100 Hz:
        there the provenance of a library states up to where errors are known, and nobody is warned.

        Args:
            frequency: (n_freq,) Hz, ascending.
        """
        if frequency[-1] > max(self.known_up_to, TOUCHES_UP_TO):
            warn_caller(
                f"atlas of cells: its errors were found up to {self.known_up_to:g} Hz; above they are not known",
            )

    @property
    def known_from(self) -> float:
        """Angle between the tubes of a point from which on the errors were found, degrees."""
        return float(self.provenance["held-out designs"]["least angle"])

    def warn_below(self, angle: float) -> None:
        """Warn that errors are not known at the smallest angle between the tubes of a point, degrees."""
        if angle < self.known_from:
            warn_caller(
                f"atlas of cells: its errors were found for tubes of a point at {self.known_from:g} degrees and more; "
                f"of some at {angle:g} they are not known",
            )

    def impedance(self, enclosure: Enclosure, opening: Opening, square: NumpyOrTorch) -> NumpyOrTorch:
        """Impedance of openings in series with their tubes, in mu / a^3.

        Args:
            enclosure: of the cavity.
            opening: their shapes, which broadcast with ``square``.
            square: square of the shear number, a^2 w / nu, a ratio; float64 that broadcasts with the shapes.

        Returns:
            Broadcast shape, complex128.
        """
        by_radius, by_floor, by_ceiling = opening.ratios
        ratios = (by_radius, by_floor + by_ceiling, by_floor * by_ceiling)
        resistance, inertance = self.openings[enclosure](ratios, layer_number(square))
        return resistance + 1j * (square * inertance)

    def compliance(self, opening: Opening, square: NumpyOrTorch) -> NumpyOrTorch:
        """Compliance that openings add to their cavity, in a^3 / p.

        Their shapes and ``square`` broadcast, as for :meth:`impedance`.

        Returns:
            Broadcast shape, complex128.
        """
        real, imag = self.storage((opening.ratios[0],), layer_number(square) ** 0.5)
        return real + 1j * imag

    def inertances(self, opening: Opening) -> tuple[NumpyOrTorch, NumpyOrTorch]:
        """Inertances in rho / R that two openings of a cavity share, and that an opening and the membrane share.

        The openings lie opposite each other; the angle between them changes little of a chain. Both are float64 of the
        shape of the radius of the cavity.
        """
        flatness = opening.cavity_radius / opening.cavity_height
        place = opening.port_height / opening.cavity_height - 0.5
        powers = [[flatness**m * place**n if n else flatness**m for n in range(2)] for m in range(3)]

        def total(coefficients: Array) -> NumpyOrTorch:
            return sum(float(coefficients[m, n]) * powers[m][n] for m in range(3) for n in range(2))

        return total(self.passage), total(self.to_membrane)

    def check(self, enclosure: Enclosure, opening: Opening, square: NumpyOrTorch, where: str) -> None:
        """Refuse openings outside the bounds.

        Args:
            enclosure: of the cavity.
            opening: shapes as NumPy arrays.
            square: largest square of a shear number, a^2 w / nu, a ratio; a NumPy array that broadcasts with them.
            where: what is refused, for the message.

        Raises:
            OutsideAtlas: names the ratio, its value and its range.
        """
        for name, value, (low, high) in self._bounded(enclosure, opening, square):
            outside = value[_beyond(value, low, high)]
            if outside.size:
                raise OutsideAtlas(
                    kind=Kind.NO_RESULT,
                    field=f"{where}: {name}",
                    value=float(f"{outside.flat[0]:.4g}"),
                    allowed=f"{low:g} to {high:g} in the atlas of cells",
                    remedy='fidelity "navier-stokes" solves it in 3-D',
                )

    def is_outside(self, enclosure: Enclosure, opening: Opening, square: NumpyOrTorch) -> NDArray[np.bool_]:
        """Openings that :meth:`check` would refuse, from shapes and a ``square`` that broadcasts with them, as there.

        Returns:
            Broadcast shape, bool.
        """
        found = [_beyond(value, *bounds) for _, value, bounds in self._bounded(enclosure, opening, square)]
        return np.asarray(np.any(np.broadcast_arrays(*found), axis=0))

    def _bounded(
        self, enclosure: Enclosure, opening: Opening, square: NumpyOrTorch
    ) -> Iterator[tuple[str, Array, tuple[float, float]]]:
        """Names, values and bounds of what :meth:`check` looks at."""
        by_radius, by_floor, by_ceiling = opening.ratios
        values = {
            "bore by cavity diameter": by_radius,
            "bore radius by height of its axis above the floor": by_floor,
            "bore radius by distance of its axis from the ceiling": by_ceiling,
            "cavity height by radius": opening.cavity_height / opening.cavity_radius,
            "shear number a sqrt(w/nu) at the highest frequency": square**0.5,
        }
        if opening.hole_radius is not None:
            values["sound hole by chamber diameter"] = opening.hole_radius / opening.cavity_radius
        for name, value in values.items():
            yield name, np.asarray(value), self.bounds[enclosure][name]


def _beyond(value: Array, low: float, high: float) -> NDArray[np.bool_]:
    return np.asarray((value < low * (1 - 1e-9)) | (value > high * (1 + 1e-9)))


@lru_cache(maxsize=1)
def cell_atlas() -> CellAtlas:
    """The atlas that comes with the package, read once."""
    return atlas_of(parse_json(read_text(FILE, "the atlas of cells", Refusal), str(FILE), Refusal))


def atlas_of(plain: Mapping[str, Any]) -> CellAtlas:
    """The atlas that a table of plain values states."""

    def polynomial(stated: Mapping[str, Any]) -> ShapePolynomial:
        powers = np.array(stated["powers"], dtype=np.int64)
        return ShapePolynomial(powers, np.array(stated["real"]), np.array(stated["imag"]))

    def bounds(stated: Mapping[str, Sequence[float]]) -> dict[str, tuple[float, float]]:
        return {name: (low, high) for name, (low, high) in stated.items()}

    decisive = json.dumps([plain[name] for name in _DECISIVE], sort_keys=True)
    return CellAtlas(
        digest=hashlib.sha256(decisive.encode()).hexdigest()[:12],
        openings={enclosure: polynomial(stated) for enclosure, stated in plain["openings"].items()},
        storage=polynomial(plain["storage"]),
        passage=np.array(plain["passage"]),
        to_membrane=np.array(plain["to_membrane"]),
        bounds={enclosure: bounds(stated) for enclosure, stated in plain["bounds"].items()},
        errors=plain["errors"],
        provenance=plain["provenance"],
    )

"""Manufacturing scatter as data, and arrays drawn with it: every tube, cavity and membrane with its own deviation.

Sample k of a design depends on (seed, k) alone, so that any sample can be drawn again without the others. Responses
come from :mod:`acoustic_fem.batch.network` (lumped fidelity), thousands per second.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Literal, get_args

import numpy as np

from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.batch.topology import Topology
from acoustic_fem.membrane.design_discs import design_bulge_ratio, design_mounting_ratio, design_rubber
from acoustic_fem.membrane.disc import THICKNESS_BY_RADIUS, DiscOptions, DiscSolution, KnownDiscs, solve_disc
from acoustic_fem.quantities.units import metres, pascals
from acoustic_fem.scatter.mounted_membranes import MountedMembranes
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_choice, check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import read_toml
from geometry.ground.typed import Array

#: A deviation in mm, or of the nominal value.
DeviationKind = Literal["absolute", "relative"]

#: Quantities that scatter, and the part that each belongs to.
QUANTITIES = {
    "bore": "tube",
    "length": "tube",
    "cavity_diameter": "point",
    "cavity_height": "point",
    "membrane_thickness": "point",
    "modulus_of_part": "point",
    "modulus_of_batch": "array",
    "glue_overrun": "point",
    "chamber_height": "microphone",
    "microphone_gain": "microphone",
    "microphone_corner": "microphone",
    "ovality": "tube",
    "prestrain": "point",
    "glue_thickness": "point",
}
#: Draws are cut off here, in standard deviations: beyond, a part is thrown away.
CUT = 3.0
#: Parts are kept above this share of their nominal size, whatever is drawn.
LEAST = 0.2


class UnknownScatterError(Refusal):
    """Refusal of a design of which it is not known how it scatters."""


@dataclass(frozen=True)
class Tolerance:
    """Scatter of one quantity: normal, cut off at three standard deviations; of glue and of ovality the size only."""

    quantity: str
    """Name of the quantity, one of :data:`QUANTITIES`."""
    deviation: float
    """Standard deviation: mm where absolute, a fraction of the nominal value where relative; a strain of prestrain."""
    kind: DeviationKind
    """Kind of the deviation."""
    source: str
    """Source of the figure."""

    def __post_init__(self) -> None:
        check_choice("quantity", self.quantity, tuple(QUANTITIES))
        of_no_length = self.quantity.startswith(("modulus", "microphone", "ovality"))
        kinds = ("relative",) if of_no_length else get_args(DeviationKind)
        check_choice(f"{self.quantity}.kind", self.kind, ("absolute",) if self.quantity == "prestrain" else kinds)
        most, unit = (0.3, "") if self.kind == "relative" else (5.0, "mm")
        if self.quantity == "prestrain":
            most, unit = 0.01, ""
        check_range(f"{self.quantity}.deviation", self.deviation, 0, most, unit)


#: Tolerances of a careful workshop; figures without a measurement behind them say so.
TOLERANCES = (
    Tolerance("bore", 0.015, "absolute", "assumed: springs are wound to +-0.03 mm, two deviations"),
    Tolerance("length", 0.15, "absolute", "assumed: cut by hand along a ruler, and pushed onto the lip by hand"),
    Tolerance("cavity_diameter", 0.05, "absolute", "assumed: +-0.1 mm of desktop stereolithography, two deviations"),
    Tolerance("cavity_height", 0.05, "absolute", "assumed: two layers of 0.05 mm, two deviations"),
    Tolerance("membrane_thickness", 0.05, "absolute", "print_processes.CAST_THICKNESS: 0.1 mm, two deviations"),
    Tolerance("modulus_of_part", 0.03, "relative", "assumed: mixing and curing from disc to disc"),
    Tolerance("modulus_of_batch", 0.15, "relative", "geometry.schema.materials: Gent's formula, 30 %, two deviations"),
    Tolerance("glue_overrun", 0.05, "absolute", "assumed: glue creeps over the rim by a bead's foot, half-normal"),
)  # fmt: skip


_WIDE = "assumed: between a careful workshop and a first sensor of one's own"
#: Tolerances assumed of a sensor that nobody measured. The more is assumed, the less are neighbours in a long line
#: distinguished: of line-2 as designed it costs 0.3 % of the frames that 10 % for the batch would name.
UNCALIBRATED = (
    Tolerance("bore", 0.05, "relative", _WIDE),
    Tolerance("cavity_height", 0.05, "relative", _WIDE),
    Tolerance("modulus_of_part", 0.10, "relative", _WIDE),
    Tolerance("modulus_of_batch", 0.15, "relative", "geometry.schema.materials: Gent's formula, 30 %, two deviations"),
    Tolerance("length", 0.01, "relative", _WIDE),
    Tolerance("chamber_height", 0.10, "relative", _WIDE),
    Tolerance("microphone_gain", 0.05, "relative", "assumed: +-1 dB of MEMS microphones, two deviations"),
    Tolerance("microphone_corner", 0.10, "relative", _WIDE),
)


def tolerances_of(given: Sequence[Tolerance] | str | os.PathLike[str] | None) -> tuple[Tolerance, ...]:
    """Tolerances as a caller gives them: themselves, a TOML file of :func:`read_tolerances`, or None for assumed ones.

    Raises:
        Refusal: as :func:`read_tolerances`.
    """
    if given is None:
        return TOLERANCES
    return read_tolerances(Path(given)) if isinstance(given, str | os.PathLike) else tuple(given)


def read_tolerances(path: Path) -> tuple[Tolerance, ...]:
    """Tolerances of a file, with default ones for missing quantities.

    The file has a table per quantity: ``[bore]``, ``deviation = 0.02``, ``kind = "absolute"``, ``source = "..."``.
    Those of chambers, microphones and ovality, which scatter only where a file says so, need deviation and kind.

    Raises:
        Refusal: it cannot be read, or holds an unknown quantity or field, or a value out of range.
    """
    known = {tolerance.quantity: tolerance for tolerance in TOLERANCES}
    stated = read_toml(path, "a file of tolerances", Refusal)
    if not stated:  # a file that was cut short to nothing would be taken for the defaults
        problem = f"is empty; it must have a table of one of: {', '.join(QUANTITIES)}"
        raise Refusal(problem, kind=Kind.MISSING, file=path)
    for quantity, given in stated.items():
        if quantity not in QUANTITIES:
            raise Refusal(kind=Kind.UNKNOWN, file=path, field=quantity, allowed=QUANTITIES)
        if not isinstance(given, Mapping) or not set(given) <= {"deviation", "kind", "source"}:
            kind = Kind.UNKNOWN if isinstance(given, Mapping) else Kind.WRONG_TYPE
            raise Refusal("must hold deviation, kind and source only", kind=kind, file=path, field=quantity)
        if quantity not in known and not {"deviation", "kind"} <= set(given):
            problem = "must hold deviation and kind, because it has no default"
            raise Refusal(problem, kind=Kind.MISSING, file=path, field=quantity)
        deviation = given["deviation"] if "deviation" in given else known[quantity].deviation
        types = {"deviation": "a number", "kind": "a text", "source": "a text"}
        of_type = {"deviation": isinstance(deviation, (int, float)) and not isinstance(deviation, bool)}
        for name in given:
            if not of_type.get(name, isinstance(given[name], str)):
                field = f"{quantity}.{name}"
                raise Refusal(kind=Kind.WRONG_TYPE, file=path, field=field, value=given[name], allowed=types[name])
        try:
            start = known.get(quantity) or Tolerance(quantity, 0.0, "relative", "")
            known[quantity] = replace(start, **{"source": "of the file", **given})
        except Refusal as error:
            raise Refusal.of(error, file=path) from None
    return tuple(known.values())


def unknown_scatter(design: ArrayDesign) -> UnknownScatterError | None:
    """Refusal of a design of which it is not known how it scatters; None if it is known."""
    if design.membrane.stretch != 1 and not design_rubber(design).elastic:
        return UnknownScatterError(
            f"must be 1 for manufacturing scatter, unless materials.{design.membrane.material}.loss_factor is 0: "
            "the scatter of a stretched membrane with loss is not computed",
            kind=Kind.NO_RESULT,
            field="membrane.stretch",
            value=design.membrane.stretch,
        )
    if design.resonator.shape != "cylinder":
        problem = "must be 'cylinder' for manufacturing scatter, which is computed with closed forms only"
        shape = design.resonator.shape
        return UnknownScatterError(problem, kind=Kind.NO_RESULT, field="resonator.shape", value=shape)
    return None


class ScatteredDesign:
    """Design whose parts scatter.

    Args:
        design: the nominal array; its membranes must not be pre-stretched with loss.
        tolerances: one per quantity; a quantity that is not among them does not scatter.
        known: membranes that need not be solved.

    Raises:
        Refusal: a quantity twice, or a membrane that the elastic solution does not take.
        UnknownScatterError: a cavity that is not a cylinder, or a pre-stretched membrane with loss.
    """

    def __init__(
        self, design: DesignLike, tolerances: Sequence[Tolerance] = TOLERANCES, known: KnownDiscs | None = None
    ) -> None:
        design = resolve_design(design)
        names = [tolerance.quantity for tolerance in tolerances]
        if len(set(names)) != len(names):
            twice = max(names, key=names.count)
            raise Refusal("is given twice", kind=Kind.CONFLICT, field=f"tolerances.{twice}")
        if (unknown := unknown_scatter(design)) is not None:
            raise unknown
        self.design = design
        self.tolerances = tuple(tolerances)
        shared = Topology.of(design)
        self.topology = shared.individual()
        self.nominal = ArrayParameters.from_design(design, known=known).individual(shared)
        self._columns = {
            "tube": self.nominal.tube_radius.shape[1],
            "point": self.nominal.cavity_radius.shape[1],
            "array": 1,
            "microphone": self.nominal.chamber_height.shape[1],
        }
        self._discs = [_Discs(design.of_kind(kind), self.tolerances, known) for kind in design.kinds]
        self._kinds = np.array(design.kind_of_point)
        self._mounted = [self._mounting(design.of_kind(kind)) for kind in design.kinds]

    def _mounting(self, alike: ArrayDesign) -> MountedMembranes:
        steps = {each.quantity: CUT * each.deviation * _unit(each, alike) for each in self.tolerances}
        return MountedMembranes(alike, steps.get("prestrain", 0.0), steps.get("glue_thickness", 0.0))

    def draws(self, first: int, count: int, seed: int) -> dict[str, Array]:
        """Deviations of samples ``first`` to ``first + count - 1``.

        Args:
            first: number of the first sample, from 0.
            count: how many.
            seed: of all samples.

        Returns:
            By quantity (count, n_part) float64, in standard deviations.
        """
        sizes = [self._columns[QUANTITIES[name]] for name in QUANTITIES]
        parts = np.split(_cut_normals(first, count, seed, sum(sizes)), np.cumsum(sizes)[:-1], axis=1)
        return dict(zip(QUANTITIES, parts, strict=True))

    def parameters(self, draws: Mapping[str, Array]) -> ArrayParameters:
        """Parameters of the arrays with these deviations.

        Args:
            draws: by quantity (count, n_part) float64, in standard deviations, of :meth:`draws` or mixed from several.
        """
        by_name = {tolerance.quantity: tolerance for tolerance in self.tolerances}

        def scattered(quantity: str, nominal: Array) -> Array:
            """In the unit of the nominal values: m, or 1 for ratios."""
            if quantity not in by_name:
                return nominal
            tolerance = by_name[quantity]
            step = nominal if tolerance.kind == "relative" else metres(1.0)
            return np.maximum(nominal + draws[quantity] * tolerance.deviation * step, LEAST * nominal)

        nominal = self.nominal
        diameter = scattered("cavity_diameter", 2 * nominal.cavity_radius)
        one = np.ones((1, 1))
        overrun = np.zeros((1, self._columns["point"]))
        if "glue_overrun" in by_name:
            tolerance = by_name["glue_overrun"]
            unit = 2 * nominal.cavity_radius if tolerance.kind == "relative" else metres(1.0)
            overrun = np.abs(draws["glue_overrun"]) * tolerance.deviation * unit
        opening = np.maximum(diameter / 2 - overrun, LEAST * nominal.cavity_radius)
        designed = np.array([disc.thickness for disc in self._discs])[self._kinds][None]
        thickness = scattered("membrane_thickness", designed)
        modulus = scattered("modulus_of_part", one) * scattered("modulus_of_batch", one) * self._stiffened(draws)
        compliance, share, frequency = self._membranes(opening, thickness, modulus)
        return replace(
            nominal,
            tube_radius=scattered("bore", 2 * nominal.tube_radius) / 2 * self._narrowed(draws),
            tube_length=scattered("length", nominal.tube_length),
            cavity_radius=diameter / 2,
            cavity_height=scattered("cavity_height", nominal.cavity_height),
            chamber_height=scattered("chamber_height", nominal.chamber_height),
            vent_admittance=scattered("microphone_corner", nominal.vent_admittance),
            membrane_compliance=compliance,
            membrane_fraction=share,
            membrane_frequency=frequency,
        )

    def _stiffened(self, draws: Mapping[str, Array]) -> Array | float:
        """Stiffness of membranes by strain and glue that are drawn, against the nominal ones, (count, n_point)."""
        own = [each for each in self.tolerances if each.quantity in ("prestrain", "glue_thickness")]
        if not own:
            return 1.0
        columns = []
        for point, kind in enumerate(self._kinds):
            alike = self.design.of_kind(self.design.kinds[kind])
            deviations: dict[str, Array | float] = {"prestrain": 0.0, "glue_thickness": 0.0}
            for each in own:
                drawn = draws[each.quantity]
                own_draw = drawn[:, min(point, drawn.shape[1] - 1)]
                deviations[each.quantity] = own_draw * each.deviation * _unit(each, alike)
            columns.append(self._mounted[kind].stiffness(**deviations))
        return np.stack(columns, axis=1)

    def _narrowed(self, draws: Mapping[str, Array]) -> Array | float:
        """Round bore that resists as an oval one of the same mean diameter, by that diameter, (count, n_tube).

        Half-axes a (1 + d) and a (1 - d), d the ovality: the elliptic pipe's resistance is 8 mu / (pi a^4) times
        (1 + d^2) / (1 - d^2)^3. Tubes flatten where they are bent; here their whole length does.
        """
        oval = [tolerance.deviation for tolerance in self.tolerances if tolerance.quantity == "ovality"]
        if not oval:
            return 1.0
        square = (draws["ovality"] * oval[0]) ** 2
        return ((1 - square) ** 3 / (1 + square)) ** 0.25

    def microphones(self, draws: Mapping[str, Array]) -> Array:
        """Gains of the microphones and admittances of their vents, each by the nominal one.

        Args:
            draws: (count, n) float64 each, as of :meth:`parameters`.

        Returns:
            (count, 2, n_microphone) float64, ratios.
        """
        by_name = {tolerance.quantity: tolerance.deviation for tolerance in self.tolerances}
        names = ("microphone_gain", "microphone_corner")
        each = [1 + by_name.get(name, 0.0) * np.asarray(draws[name]) for name in names]
        return np.maximum(np.stack(each, axis=1), LEAST)

    def _membranes(self, opening: Array, thickness: Array, modulus: Array) -> tuple[Array, ...]:
        """Compliance, shares and frequencies of the modes of every membrane, each by the discs of its kind."""
        given = np.broadcast_arrays(opening, thickness, modulus)
        of_kinds = [
            disc.at(*(values[:, self._kinds == kind] for values in given)) for kind, disc in enumerate(self._discs)
        ]
        # Back from kind after kind to the order of the points.
        order = np.argsort(np.argsort(self._kinds, kind="stable"), kind="stable")
        return tuple(np.concatenate(values, axis=1)[:, order] for values in zip(*of_kinds, strict=True))

    def sample(self, first: int, count: int, seed: int) -> ArrayParameters:
        """Parameters of samples ``first`` to ``first + count - 1``."""
        return self.parameters(self.draws(first, count, seed))


def _unit(tolerance: Tolerance, alike: ArrayDesign) -> float:
    """Unit of the deviation of a strain, a ratio, or of the thickness of glue, m."""
    if tolerance.quantity == "prestrain":
        return 1.0
    return metres(alike.membrane.glue_thickness) if tolerance.kind == "relative" else metres(1.0)


@lru_cache(maxsize=8)
def _cut_normals(first: int, count: int, seed: int, size: int) -> Array:
    """Standard normal deviations of samples, cut off, (count, size); kept, because designs of a sweep share them."""
    total = np.empty((count, size))
    for row in range(count):
        child = np.random.SeedSequence(seed, spawn_key=(first + row,))
        total[row] = np.random.default_rng(child).standard_normal(size)
    # beyond the cut a part is made again: the tail is folded back evenly
    beyond = np.abs(total) > CUT
    total[beyond] = np.sign(total[beyond]) * (np.abs(total[beyond]) - CUT)
    total.setflags(write=False)
    return total


class _Discs:
    """Compliance and modes of a design's membrane for other openings, thicknesses and moduli.

    The elastic solution at Chebyshev points of log(thickness / opening), rim and opening in their nominal ratio, is
    interpolated by polynomials; tests compare it with solutions of their own.
    """

    nodes = 6

    def __init__(self, design: ArrayDesign, tolerances: Sequence[Tolerance], known: KnownDiscs | None) -> None:
        material = design.material(design.membrane.material)
        self.opening = metres(design.resonator.cavity_diameter) / 2
        self.thickness, self._stretch = metres(design.membrane.thickness), design.membrane.stretch
        rim = 0.0 if design.membrane.mounting == "clamped" else metres(design.membrane.rim_width) / self.opening
        low, high = self._range(tolerances)
        place = np.cos(np.pi * (np.arange(self.nodes) + 0.5) / self.nodes)
        ratios = np.exp((np.log(low) + np.log(high)) / 2 + (np.log(high) - np.log(low)) / 2 * place)
        solutions: list[DiscSolution] = [
            solve_disc(
                self.opening, ratio * self.opening, pascals(material.youngs_modulus), material.poisson_ratio,
                rim * self.opening, material.density, DiscOptions(stretch=self._stretch), known,
            )
            for ratio in ratios
        ]  # fmt: skip
        share = np.array([disc.model.swept**2 / disc.model.eigenvalues for disc in solutions])
        total = share.sum(axis=1)
        volume = np.array([disc.opening**3 / disc.modulus for disc in solutions])
        frequency = np.array([np.sqrt(disc.model.eigenvalues * disc.modulus / disc.density) for disc in solutions])
        values = np.concatenate([np.log(total * volume)[:, None], share / total[:, None], np.log(frequency)], axis=1)
        self._span = low, high
        self._fit = np.polynomial.chebyshev.chebfit(place, values, self.nodes - 1)
        self._modes = share.shape[1]
        self._design, self._bulged = design, design.air.overpressure
        self._mounted = 1 / design_mounting_ratio(design)

    def _range(self, tolerances: Sequence[Tolerance]) -> tuple[float, float]:
        """Smallest and largest ratio of thickness and opening that may be drawn, as far as discs can be solved."""
        low_thickness = high_thickness = self.thickness
        low_opening = high_opening = self.opening
        for tolerance in tolerances:
            unit = metres(1.0)
            if tolerance.quantity == "membrane_thickness":
                step = CUT * tolerance.deviation * (self.thickness if tolerance.kind == "relative" else unit)
                low_thickness = max(low_thickness - step, LEAST * self.thickness)
                high_thickness += step
            elif tolerance.quantity == "cavity_diameter":
                step = CUT * tolerance.deviation * (self.opening if tolerance.kind == "relative" else unit / 2)
                low_opening, high_opening = low_opening - step, high_opening + step
            elif tolerance.quantity == "glue_overrun":
                low_opening -= CUT * tolerance.deviation * (2 * self.opening if tolerance.kind == "relative" else unit)
        low_opening = max(low_opening, LEAST * self.opening)
        low, high = 0.999 * low_thickness / high_opening, 1.001 * high_thickness / low_opening
        thinnest, thickest = (self._stretch**2 * limit for limit in THICKNESS_BY_RADIUS)
        return max(low, thinnest), min(high, thickest)

    def at(self, opening: Array, thickness: Array, modulus: Array) -> tuple[Array, Array, Array]:
        """Compliance, m^3/Pa, shares and frequencies, Hz, of the modes, for moduli in units of the nominal one."""
        ratio = np.clip(thickness / opening, *self._span)
        opening, ratio, modulus = np.broadcast_arrays(opening, ratio, modulus)
        low, high = self._span
        place = (2 * np.log(ratio) - np.log(low) - np.log(high)) / (np.log(high) - np.log(low))
        values = np.moveaxis(np.polynomial.chebyshev.chebval(place, self._fit), 0, -1)
        scale = opening / self.opening
        compliance = np.exp(values[..., 0]) * scale**3 / (modulus * self._mounted)
        share = np.clip(values[..., 1 : 1 + self._modes], 0, None)
        frequency = np.exp(values[..., 1 + self._modes :]) / (2 * math.pi * opening[..., None])
        if self._bulged:
            # The bulge by the thickness, on which the stiffening depends, goes with pressure / modulus / ratio^4.
            stiffness = modulus * (ratio / (self.thickness / self.opening)) ** 4
            softer = design_bulge_ratio(self._design, self._bulged, stiffness)
            compliance, modulus = compliance * softer, modulus / softer
        modulus = modulus * self._mounted
        return compliance, share / share.sum(axis=-1, keepdims=True), frequency * np.sqrt(modulus)[..., None]

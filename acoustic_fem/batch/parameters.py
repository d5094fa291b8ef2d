"""The numbers of a batch of designs: its wiring, and the numbers of its parts as arrays.

The wiring is common to the batch; the numbers have a leading axis over designs. Parts that are one field of
the design file (all tubes between points, say) share one column of numbers, so that work is done once per
column and a derivative is that of the field. :meth:`Topology.individual` gives every part a column of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, fields
from types import ModuleType
from typing import Any, TypeVar, cast

import numpy as np

from acoustic_fem.batch.numpy_or_torch import namespace
from acoustic_fem.batch.topology import Topology, tubes_in_use
from acoustic_fem.membrane.design_discs import design_disc, design_rubber, design_stiffening
from acoustic_fem.membrane.disc import DiscSolution, KnownDiscs
from acoustic_fem.membrane.rubber import Rubber
from acoustic_fem.network.microphone import circuit_elements as elements
from acoustic_fem.network.yielding import design_leak, floor_compliance, sheath_compliance, soft_rubber
from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.units import cubic_metres, metres
from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_given, mismatch, out_of_range, wrong_type
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import NumpyOrTorch


@dataclass(frozen=True, eq=False)
class ArrayParameters:
    """Numbers of a batch of arrays of one topology: NumPy arrays or torch tensors, float64, SI."""

    tube_radius: NumpyOrTorch
    """Radius of the smooth tube that a tube is worth, (n_design, n_tube_column) float64, m."""
    tube_length: NumpyOrTorch
    """Length of that smooth tube, (n_design, n_tube_column) float64, m."""
    cavity_radius: NumpyOrTorch
    """Radius of the cavity, (n_design, n_point_column) float64, m."""
    cavity_height: NumpyOrTorch
    """Height of the cavity, (n_design, n_point_column) float64, m."""
    port_height: NumpyOrTorch
    """Height of the axes of the tubes above the floor of the cavity, (n_design, n_point_column) float64, m; counts at
    fidelity ``atlas``."""
    membrane_compliance: NumpyOrTorch
    """Static volume compliance of the membrane at its stated modulus, (n_design, n_point_column) float64, m^3/Pa."""
    membrane_loss: NumpyOrTorch
    """Loss factor of the membrane, without that of its relaxations, (n_design, n_point_column) float64."""
    membrane_slope: NumpyOrTorch
    """Slope of its modulus over frequency by that which the loss factor asks for, (n_design, n_point_column) float64: 1
    for a spring-pot, 0 for a modulus that stays, which is not causal."""
    membrane_reference: NumpyOrTorch
    """Frequency of the modulus that the compliance and the modes belong to, (n_design, n_point_column) float64, Hz."""
    membrane_relaxation: NumpyOrTorch
    """Relaxing moduli by that one, ratios, (n_design, n_point_column, n_term) float64; n_term may be 0."""
    membrane_relaxation_time: NumpyOrTorch
    """Relaxation times, (n_design, n_point_column, n_term) float64, s."""
    membrane_fraction: NumpyOrTorch
    """Share of one of each mode in the static compliance, (n_design, n_point_column, n_mode) float64; sum 1."""
    membrane_frequency: NumpyOrTorch
    """Frequency of each mode in vacuo at that modulus, (n_design, n_point_column, n_mode) float64, ascending, Hz. Modes
    from a design end with two that correct the statics (:class:`acoustic_fem.membrane.DiscSolution`).
    """
    leak_conductance: NumpyOrTorch
    """Conductance of the leak of the cavity to the outside, 0 where it is tight, (n_design, n_point_column) float64,
    m^3/(Pa s)."""
    floor_compliance: NumpyOrTorch
    """Static volume compliance of the floor at its stated modulus, 0 where it is rigid, (n_design, n_point_column)
    float64, m^3/Pa."""
    floor_loss: NumpyOrTorch
    """Loss factor of the floor, without that of its relaxations, (n_design, n_point_column) float64."""
    floor_slope: NumpyOrTorch
    """Slope of its modulus as ``membrane_slope``, an exponent, (n_design, n_point_column) float64."""
    floor_reference: NumpyOrTorch
    """Frequency of its stated modulus, (n_design, n_point_column) float64, Hz."""
    floor_relaxation: NumpyOrTorch
    """Relaxing moduli by that one, ratios, (n_design, n_point_column, n_term) float64; n_term may be 0."""
    floor_relaxation_time: NumpyOrTorch
    """Relaxation times, (n_design, n_point_column, n_term) float64, s."""
    sheath_compliance: NumpyOrTorch
    """Change of the bore's section per pressure at the stated modulus of the sheath, 0 where it is rigid, (n_design,
    n_tube_column) float64, m^2/Pa."""
    sheath_loss: NumpyOrTorch
    """Loss factor of the sheath, without that of its relaxations, (n_design, n_tube_column) float64."""
    sheath_slope: NumpyOrTorch
    """Slope of its modulus as ``membrane_slope``, an exponent, (n_design, n_tube_column) float64."""
    sheath_reference: NumpyOrTorch
    """Frequency of its stated modulus, (n_design, n_tube_column) float64, Hz."""
    sheath_relaxation: NumpyOrTorch
    """Relaxing moduli by that one, ratios, (n_design, n_tube_column, n_term) float64; n_term may be 0."""
    sheath_relaxation_time: NumpyOrTorch
    """Relaxation times, (n_design, n_tube_column, n_term) float64, s."""
    chamber_radius: NumpyOrTorch
    """Radius of the microphone's chamber, (n_design, n_microphone_column) float64, m."""
    chamber_height: NumpyOrTorch
    """Height of the microphone's chamber, (n_design, n_microphone_column) float64, m."""
    hole_radius: NumpyOrTorch
    """Radius of the sound hole, (n_design, n_microphone_column) float64, m."""
    hole_length: NumpyOrTorch
    """Length of the sound hole, (n_design, n_microphone_column) float64, m."""
    diaphragm_compliance: NumpyOrTorch
    """Compliance of the diaphragm, (n_design, n_microphone_column) float64, m^3/Pa."""
    back_volume: NumpyOrTorch
    """Volume behind the diaphragm, (n_design, n_microphone_column) float64, m^3."""
    vent_admittance: NumpyOrTorch
    """Admittance 1/R of the vent, (n_design, n_microphone_column) float64, m^3/(Pa s)."""

    @classmethod
    def from_design(cls, design: ArrayDesign, air: AirLike = None, known: KnownDiscs | None = None) -> ArrayParameters:
        """The numbers of one design, n_design = 1, as NumPy arrays in the columns of :meth:`Topology.of`.

        Args:
            design: the array.
            air: air on which diaphragm, vent and leaks depend; by default that of the design.
            known: membranes that need not be solved.
        """
        return cls.from_designs([design], air, known)

    @classmethod
    def from_designs(
        cls, designs: Sequence[ArrayDesign], air: AirLike = None, known: KnownDiscs | None = None
    ) -> ArrayParameters:
        """The numbers of several designs of one topology.

        Args:
            designs: the arrays.
            air: air on which diaphragm, vent and leaks depend; by default that of each design.
            known: membranes that need not be solved.

        Raises:
            Refusal: no design, designs that are wired in different ways, a cavity that is not a cylinder, or a
                pre-stretched membrane with loss.
        """
        check_given("designs", designs, "a batch needs at least one")
        topology = Topology.of(designs[0])
        for number, design in enumerate(designs):
            if Topology.of(design) != topology:
                raise mismatch(
                    f"designs.{number + 1}", f"({design.name}) is not wired as the first one ({designs[0].name})"
                )
        common = _Common(air, known)
        rows = [_row(design, common) for design in designs]
        for rubber in _RUBBERS:
            terms = max(len(column) for row in rows for column in row[f"{rubber}_relaxation"])
            for row in rows:
                for name, nothing in ((f"{rubber}_relaxation", 0.0), (f"{rubber}_relaxation_time", 1.0)):
                    row[name] = [[*column, *[nothing] * (terms - len(column))] for column in row[name]]
        return cls(**{name: np.array([row[name] for row in rows], dtype=np.float64) for name in rows[0]})

    @property
    def design_count(self) -> int:
        """Number of designs, the longest leading axis; a field with one row is common to all."""
        return max(int(getattr(self, field.name).shape[0]) for field in fields(self))

    @property
    def namespace(self) -> ModuleType:
        """Library of the numbers: ``numpy`` or ``torch``."""
        return namespace(self.tube_radius)

    @property
    def needs_gradient(self) -> bool:
        """True if any of the numbers is a tensor with gradients."""
        return any(getattr(getattr(self, field.name), "requires_grad", False) for field in fields(self))

    def map(self, function: Callable[[NumpyOrTorch], NumpyOrTorch]) -> ArrayParameters:
        """The parameters with a function applied to every field."""
        return ArrayParameters(**{field.name: function(getattr(self, field.name)) for field in fields(self)})

    def tensors(self, requires_grad: bool = False) -> ArrayParameters:
        """The same numbers as torch tensors of their own, float64."""
        import torch

        return self.map(lambda values: torch.tensor(values, dtype=torch.float64, requires_grad=requires_grad))

    def individual(self, topology: Topology) -> ArrayParameters:
        """The same numbers with the columns repeated for every part, as :meth:`Topology.individual` has them."""
        part_columns: Mapping[str, list[int]] = {
            "tube": [column for line in topology.lines for column in line.tubes],
            "point": [column for line in topology.lines for column in line.points],
            "microphone": list(topology.microphones),
        }
        return ArrayParameters(
            **{field.name: getattr(self, field.name)[:, part_columns[PART[field.name]]] for field in fields(self)}
        )


_PART_OF_PREFIX = {
    **dict.fromkeys(("tube", "sheath"), "tube"),
    **dict.fromkeys(("cavity", "port", "membrane", "leak", "floor"), "point"),
}

#: Part that each parameter belongs to.
PART = {field.name: _PART_OF_PREFIX.get(field.name.split("_")[0], "microphone") for field in fields(ArrayParameters)}


_RUBBERS = ("membrane", "floor", "sheath")
#: The last axis of the fields that have three, and the fields that may be 0.
_THIRD_AXIS = {
    "membrane_fraction": ", n_mode",
    "membrane_frequency": ", n_mode",
    **{f"{rubber}_{name}": ", n_term" for rubber in _RUBBERS for name in ("relaxation", "relaxation_time")},
}
_MAY_VANISH = {
    *("membrane_fraction", "leak_conductance", "floor_compliance", "sheath_compliance"),
    *(f"{rubber}_{name}" for rubber in _RUBBERS for name in ("loss", "slope", "relaxation")),
}


@dataclass(frozen=True, eq=False)
class MediumParameters:
    """A gas for each design, as arrays or tensors; fields as :class:`acoustic_fem.quantities.Medium`."""

    density: NumpyOrTorch
    """Density, (n_design,) float64, kg/m^3."""
    viscosity: NumpyOrTorch
    """Dynamic viscosity, (n_design,) float64, Pa s."""
    conductivity: NumpyOrTorch
    """Thermal conductivity, (n_design,) float64, W/(m K)."""
    heat_capacity: NumpyOrTorch
    """Heat capacity at constant pressure, (n_design,) float64, J/(kg K)."""
    gamma: NumpyOrTorch
    """Ratio of heat capacities, of one, (n_design,) float64."""
    pressure: NumpyOrTorch
    """Static pressure, (n_design,) float64, Pa."""

    @classmethod
    def from_media(cls, media: Sequence[Medium]) -> MediumParameters:
        """The gases of one medium per design, as NumPy arrays."""
        return cls(**{f.name: np.array([getattr(medium, f.name) for medium in media]) for f in fields(Medium)})


_Rows = TypeVar("_Rows", bound=ArrayParameters | MediumParameters)


def joined_rows(parts: Sequence[_Rows], counts: Sequence[int]) -> _Rows:
    """Numbers of several batches in one, batch after batch, as NumPy arrays.

    Args:
        parts: the batches, with equal columns; one row stands for all designs of its batch.
        counts: number of designs of each batch.
    """
    rows = {}
    for name in vars(parts[0]):
        own = zip((getattr(part, name) for part in parts), counts, strict=True)
        rows[name] = np.concatenate([np.broadcast_to(values, (count, *values.shape[1:])) for values, count in own])
    return type(parts[0])(**rows)


def check_parameters(parameters: ArrayParameters, topology: Topology) -> None:
    """Refuse numbers whose shapes, kinds or ranges are not those that the topology asks for.

    Raises:
        Refusal: with the field, what it is and what it must be.
    """
    columns = {
        "tube": 1 + max(column for line in topology.lines for column in line.tubes),
        "point": 1 + max(column for line in topology.lines for column in line.points),
        "microphone": 1 + max(topology.microphones),
    }
    xp, count = parameters.namespace, parameters.design_count
    for field in fields(parameters):
        values = getattr(parameters, field.name)
        if namespace(values) is not xp:
            raise wrong_type(field.name, f"is a {type(values).__name__}; all fields must be arrays of {xp.__name__}")
        if values.dtype != xp.float64:
            raise Refusal(f"is {values.dtype}; it must be float64", kind=Kind.WRONG_TYPE, field=field.name)
        shape, needed = tuple(values.shape), columns[PART[field.name]]
        more = _THIRD_AXIS.get(field.name, "")
        if len(shape) != (3 if more else 2) or shape[0] not in (1, count) or shape[1] != needed:
            raise wrong_type(
                field.name, f"has shape {shape}; it must be ({count}, {needed}{more}) or (1, {needed}{more})"
            )
        may_vanish = field.name in _MAY_VANISH
        fits = xp.isfinite(values) & ((values >= 0) if may_vanish else (values > 0))
        if not bool(fits.all()):
            bound = "at least 0" if may_vanish else "above 0"
            raise out_of_range(field.name, float(values[~fits].flatten()[0]), f"finite and {bound}")
    for rubber in _RUBBERS:
        moduli, times = (f"{rubber}_{name}" for name in ("relaxation", "relaxation_time"))
        terms = [tuple(getattr(parameters, name).shape)[2] for name in (moduli, times)]
        if terms[0] != terms[1]:
            raise mismatch(moduli, f"has {terms[0]} terms and {times} {terms[1]}; both need the same")
    modes = tuple(parameters.membrane_fraction.shape)[2], tuple(parameters.membrane_frequency.shape)[2]
    if modes[0] != modes[1] or modes[0] == 0:
        problem = f"has {modes[0]} modes and membrane_frequency {modes[1]}; both need equally many modes, at least 1"
        raise mismatch("membrane_fraction", problem)


def check_medium(medium: MediumParameters, count: int, xp: ModuleType) -> int:
    """Number of designs of a gas for each, whose shapes and kinds are checked.

    Raises:
        Refusal: with the field, what it is and what it must be.
    """
    sizes = {tuple(getattr(medium, field.name).shape) for field in fields(medium)}
    rows = max(max(size, default=0) for size in sizes)
    for field in fields(medium):
        values = getattr(medium, field.name)
        if namespace(values) is not xp or values.dtype != xp.float64:
            raise wrong_type(f"air.{field.name}", f"must be a float64 array of {xp.__name__}, as the parameters are")
        if tuple(values.shape) not in ((1,), (rows,)) or (count > 1 and rows not in (1, count)):
            raise wrong_type(f"air.{field.name}", f"has shape {tuple(values.shape)}; it must be ({count},) or (1,)")
        if not bool((xp.isfinite(values) & (values > 0)).all()):
            raise Refusal("must be finite and above 0", kind=Kind.OUT_OF_RANGE, field=f"air.{field.name}")
    return max(rows, count)


class _Common:
    """Common parts of many designs, worked out once."""

    def __init__(self, air: AirLike, known: KnownDiscs | None) -> None:
        self._air, self._known = air, known
        self._found: dict[Hashable, Any] = {}

    def _once(self, key: Hashable, make: Callable[[], Any]) -> Any:
        if key not in self._found:
            self._found[key] = make()
        return self._found[key]

    def air(self, design: ArrayDesign) -> Medium:
        """The air that was given, or that of the design."""
        return cast(Medium, self._once(design.air, lambda: medium_of(self._air, design)))

    def microphone(self, design: ArrayDesign) -> tuple[float, float]:
        """Compliance of the diaphragm and admittance of the vent."""
        own, air = design.microphone, self.air(design)
        diaphragm, _, vent = self._once((own, air), lambda: elements(own, own.vent_corner, air))
        return diaphragm, vent

    def disc(self, design: ArrayDesign) -> DiscSolution:
        """The membrane of a design whose points are alike."""
        own = design.membrane, design.material(design.membrane.material)
        key = design.resonator.cavity_diameter, *own, design_stiffening(design)
        return cast(DiscSolution, self._once(key, lambda: design_disc(design, known=self._known)))


def fits_batch(design: ArrayDesign) -> bool:
    """True if a batch can hold the design: its cavities are cylinders, and no membrane with loss is pre-stretched."""
    return all(_outside(design.of_kind(kind)) is None for kind in design.kinds)


def _outside(design: ArrayDesign) -> Refusal | None:
    """The refusal of a design, all points of which are alike, that a batch cannot hold."""
    if design.membrane.stretch != 1 and not design_rubber(design).elastic:
        return Refusal(
            f"must be 1 in a batch: the tension has no loss, so the modes do not share that of "
            f"{design.membrane.material!r}",
            kind=Kind.OUT_OF_RANGE,
            field="membrane.stretch",
            value=design.membrane.stretch,
            remedy="solve() accepts it",
        )
    if design.resonator.shape != "cylinder":
        return Refusal(
            kind=Kind.OUT_OF_RANGE,
            field="resonator.shape",
            value=design.resonator.shape,
            allowed="'cylinder' in a batch, which has closed forms only",
            remedy="solve() accepts it at every fidelity",
        )
    return None


def opening_sizes(design: ArrayDesign) -> dict[str, list[float]]:
    """Bores, cavities and chambers of a design by the names of :class:`ArrayParameters`, m, one value a column."""
    resonators = [design.of_kind(kind).resonator for kind in design.kinds]
    microphone = design.microphone
    return {
        "tube_radius": [metres(tube.acoustic_diameter) / 2 for tube in tubes_in_use(design).values()],
        "cavity_radius": [metres(resonator.cavity_diameter) / 2 for resonator in resonators],
        "cavity_height": [metres(resonator.cavity_height) for resonator in resonators],
        "port_height": [metres(resonator.port_axis_height) for resonator in resonators],
        "chamber_radius": [metres(microphone.chamber_diameter) / 2],
        "chamber_height": [metres(microphone.chamber_height)],
        "hole_radius": [metres(microphone.sound_hole_diameter) / 2],
    }


def _row(design: ArrayDesign, common: _Common) -> dict[str, list[Any]]:
    tubes = list(tubes_in_use(design).values())
    sheaths = [(sheath_compliance(design, tube), soft_rubber(design, tube.sheath_material)) for tube in tubes]
    points = [_point(design.of_kind(kind), common) for kind in design.kinds]
    microphone = design.microphone
    diaphragm, vent = common.microphone(design)
    return {
        **opening_sizes(design),
        "tube_length": [metres(tube.acoustic_length(design.printing.port_lip)) for tube in tubes],
        **_columns([{"sheath_compliance": compliance, **_law("sheath", rubber)} for compliance, rubber in sheaths]),
        **_columns(points),
        "hole_length": [metres(microphone.sound_hole_length)],
        "diaphragm_compliance": [diaphragm],
        "back_volume": [cubic_metres(microphone.back_volume)],
        "vent_admittance": [vent],
    }


def _point(design: ArrayDesign, common: _Common) -> dict[str, Any]:
    """The numbers of one column of points, all of which are alike."""
    problem = _outside(design)
    if problem is not None:
        raise problem
    air, disc, rubber = common.air(design), common.disc(design), design_rubber(design)
    leak, floor = design_leak(design, air), floor_compliance(design)
    floor_rubber = soft_rubber(design, design.resonator.floor_material)
    share = disc.model.swept**2 / disc.model.eigenvalues
    mode_frequency = np.sqrt(disc.model.eigenvalues * disc.modulus / disc.density) / (2 * np.pi * disc.opening)
    return {
        "membrane_compliance": float(share.sum()) * disc.opening**3 / disc.modulus,
        **_law("membrane", rubber),
        "membrane_fraction": share / share.sum(),
        "membrane_frequency": mode_frequency,
        "leak_conductance": leak,
        "floor_compliance": floor,
        **_law("floor", floor_rubber),
    }


def _law(prefix: str, rubber: Rubber) -> dict[str, Any]:
    """A rubber's law in the numbers of one column."""
    return {
        f"{prefix}_loss": rubber.loss_factor,
        f"{prefix}_slope": 1.0 if rubber.slope > 0 else 0.0,
        f"{prefix}_reference": rubber.reference,
        f"{prefix}_relaxation": list(rubber.strengths),
        f"{prefix}_relaxation_time": list(rubber.times),
    }


def _columns(rows: list[dict[str, Any]]) -> dict[str, list[Any]]:
    return {name: [row[name] for row in rows] for name in rows[0]}

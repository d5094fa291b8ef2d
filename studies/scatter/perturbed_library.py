"""Libraries of mis-made sensors: thousands of arrays drawn with manufacturing scatter in one Zarr store.

The store has the dimensions (design, point, microphone, frequency) and opens with ``xarray.open_zarr``. It is made
and read block by block: neither needs more memory than one block. A trainer takes it as the ``source`` of
:func:`localize.train`.
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from pydantic import BaseModel, ConfigDict, Field

from acoustic_fem.atlas.cell_table import cell_atlas
from acoustic_fem.atlas.fidelity_choice import QuickFidelity
from acoustic_fem.library.provenance import versions
from acoustic_fem.quantities.checks import frequency_grid
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter.as_built_sensors import AsBuiltSensors, as_built_fidelity
from acoustic_fem.scatter.tolerances import TOLERANCES, ScatteredDesign, Tolerance
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, read_stored_design, write_design
from geometry.ground.refusal import Refusal
from geometry.ground.whole_files import writing
from studies.output.checked_store import CheckedStore, add_checksums, create_checked, read_store
from studies.output.folders import check_folder
from studies.output.seals import SEALS, Seals, create_seals

#: Layout of the store, and the attribute that marks one; from 2 on there are checksums, from 3 on seals.
FORMAT = 3
MARK = "acoustic_fem_perturbed_library"
#: Sensors per block.
BLOCK = 64
MOST_SENSORS = 1_000_000
"""Sensors that a store holds at most."""
_DIMENSIONS = ("design", "point", "microphone", "frequency")
_PARTS = ("transfer_function_real", "transfer_function_imag")
#: Attributes that change no number.
_DESCRIBED = (
    "title",
    "fidelity",
    "atlas",
    "outside_atlas",
    "tolerances",
    "code_version",
    "created",
    "seed",
    "python",
    "libraries",
)


class _About(BaseModel):
    """Attributes of a store on which its numbers depend."""

    model_config = ConfigDict(strict=True)
    design: str
    microphones: Annotated[list[str], Field(min_length=1)]


def write_perturbed_library(
    path: str | os.PathLike[str],
    design: DesignLike,
    count: int,
    frequency: ArrayLike | str,
    *,
    tolerances: Sequence[Tolerance] = TOLERANCES,
    seed: int = 0,
    progress: Callable[[str, float], None] | None = None,
) -> PerturbedLibrary:
    """Store of the transfer functions of sensors that are drawn from a design.

    At fidelity ``atlas`` if that covers the design and all sensors about it, otherwise 3-D; the store says
    which and why. Sensor k depends on the design, the tolerances, (seed, k) and the frequencies alone. The store is
    built beside and renamed at the end: it is whole or not there.

    Args:
        path: of the new store, such as ``mis-made.zarr``.
        design: the nominal array.
        count: sensors, 1 to a million.
        frequency: (n_freq,), Hz, ascending.
        tolerances: what scatters.
        seed: of the draws.
        progress: called with what is being done and the fraction done.

    Raises:
        Refusal: a path that exists or cannot be written, a count or grid out of range, or a design that the
            batch does not take.
    """
    target = Path(path)
    if isinstance(count, bool) or not isinstance(count, int) or not 1 <= count <= MOST_SENSORS:
        raise Refusal(f"count = {count!r} must be a whole number from 1 to {MOST_SENSORS}")
    if target.exists():
        raise Refusal(f"{target}: exists; a library is never overwritten")
    check_folder(target)
    grid = frequency_grid(frequency)
    report = progress or (lambda message, fraction: None)
    report("membranes", 0.0)
    scattered = ScatteredDesign(design, tolerances)
    air = design_air(scattered.design)
    fidelity = as_built_fidelity(scattered, grid, air)
    sensors = AsBuiltSensors(scattered, grid, air, fidelity.name)
    target.parent.mkdir(parents=True, exist_ok=True)
    beside = target.with_name(f".{target.name}.{os.getpid()}.new")
    try:
        with writing(target):
            _new_store(beside, scattered, count, grid, seed, fidelity)
            stored, _ = _opened(beside)
            parts, seals = [stored.array(name, writing=True) for name in _PARTS], Seals(stored, _PARTS, writing=True)
            for first in range(0, count, BLOCK):
                report("sensors", first / count)
                size = min(BLOCK, count - first)
                h = sensors.transfer_functions(scattered.draws(first, size, seed))
                parts[0][first : first + size], parts[1][first : first + size] = h.real, h.imag
                seals.write(first // BLOCK, {_PARTS[0]: h.real, _PARTS[1]: h.imag})
            os.rename(beside, target)
    finally:
        shutil.rmtree(beside, ignore_errors=True)
    return PerturbedLibrary(target)


def _opened(path: Path) -> tuple[CheckedStore, _About]:
    """What a store says of itself."""
    return read_store(path, "a library of perturbed transfer functions", MARK, FORMAT, _About, _DESCRIBED, Refusal)


def _new_store(
    path: Path,
    scattered: ScatteredDesign,
    count: int,
    grid: NDArray[np.float64],
    seed: int,
    fidelity: QuickFidelity,
) -> None:
    """Make a store that says what is in it; its real and imaginary parts are still empty."""
    import zarr

    design, points = scattered.design, scattered.design.point_count
    group = zarr.open_group(path, mode="w", zarr_format=3)
    group.attrs.update(
        {
            MARK: FORMAT,
            "title": f"{design.name} with manufacturing scatter",
            "design": write_design(design.completed()),
            "fidelity": fidelity.name,
            **({"outside_atlas": fidelity.outside} if fidelity.outside else {"atlas": cell_atlas().digest}),
            "microphones": list(design.microphones),
            "tolerances": json.dumps([asdict(tolerance) for tolerance in scattered.tolerances]),
            **versions(seed, ("numpy", "scipy", "zarr")),
        }
    )
    _coordinate(group, "design", np.arange(count), "number of the sensor, from 0")
    _coordinate(group, "point", np.arange(1, points + 1), "sensing point, from 1")
    _coordinate(group, "frequency", grid, "frequency", units="Hz")
    shape = (count, points, len(design.microphones), len(grid))
    for name in _PARTS:
        create_checked(
            group, name, shape, "float64", (min(BLOCK, count), *shape[1:]), _DIMENSIONS,
            {"units": "Pa/Pa", "long_name": f"transfer function, {name.rsplit('_', 1)[1]}"},
        )  # fmt: skip
    create_seals(group, -(-count // BLOCK), _PARTS)
    add_checksums(path, (*_PARTS, SEALS))


class PerturbedLibrary:
    """Store of mis-made sensors, read a block at a time: a
    :class:`localize.signals.touch_generator.TransferFunctionSource`.

    Raises:
        Refusal: the path is no such store, was written by a later version, or is damaged; names the member.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = Path(path)
        self._stored, about = _opened(self.path)
        self.attributes = self._stored.attributes
        #: (n_freq,) float64, Hz.
        self.frequency: NDArray[np.float64] = np.asarray(self._stored.fixed("frequency", "f"), np.float64)
        self._parts: tuple[Any, Any] = (self._stored.array(_PARTS[0]), self._stored.array(_PARTS[1]))
        for name, array in zip(_PARTS, self._parts, strict=True):
            shape, wanted = tuple(array.shape), (len(about.microphones), len(self.frequency))
            if shape[2:] != wanted or shape != self._parts[0].shape or array.chunks[1:] != shape[1:]:
                raise Refusal(
                    f"{self.path}: {name} has shape {shape}; it must be (sensors, points, {wanted[0]}, {wanted[1]})"
                )
        self._block = int(self._parts[0].chunks[0])
        self._seals = Seals(self._stored, _PARTS)
        self._held: tuple[int, NDArray[np.complex128]] | None = None

    @property
    def design(self) -> ArrayDesign:
        """Nominal design."""
        return read_stored_design(str(self.attributes["design"]), f"{self.path}: design").completed()

    @property
    def microphones(self) -> tuple[str, ...]:
        """Names of the microphones."""
        return tuple(str(name) for name in self.attributes["microphones"])

    @property
    def sensor_count(self) -> int:
        """Number of sensors."""
        return int(self._parts[0].shape[0])

    def sensors(self, first: int, count: int) -> NDArray[np.complex128]:
        """Transfer functions of consecutive sensors; one block is held in memory.

        Args:
            first: number of the first sensor, from 0.
            count: how many.

        Returns:
            (count, n_point, n_microphone, n_freq) complex128, Pa/Pa.

        Raises:
            Refusal: sensors that the store does not hold, or a block that is damaged.
        """
        if not (first >= 0 and count >= 1 and first + count <= self.sensor_count):
            raise Refusal(
                f"{self.path}: sensors {first} to {first + count - 1} must be of 0 to {self.sensor_count - 1}"
            )
        pieces = []
        for block in range(first // self._block, (first + count - 1) // self._block + 1):
            start = block * self._block
            pieces.append(self._read(block)[max(first - start, 0) : first + count - start])
        return np.concatenate(pieces)

    def _read(self, block: int) -> NDArray[np.complex128]:
        if self._held is None or self._held[0] != block:
            self._held = block, self._part(0, block) + 1j * self._part(1, block)
        return self._held[1]

    def _part(self, part: int, block: int) -> NDArray[np.float64]:
        name, rows = _PARTS[part], slice(block * self._block, (block + 1) * self._block)
        if not self._stored.has_chunk(name, block, len(_DIMENSIONS)):
            raise Refusal(f"{self.path}: {name}: chunk {block} is missing")
        values = np.asarray(self._stored.part(self._parts[part], name, rows), np.float64)
        self._seals.check(block, {name: values})
        return values


def _coordinate(group: Any, name: str, values: NDArray[Any], long_name: str, **attributes: str) -> None:
    about = {"long_name": long_name, **attributes}
    create_checked(group, name, values.shape, str(values.dtype), values.shape, (name,), about)[:] = values

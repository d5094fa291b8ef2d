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
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.batch.parameters import design_air
from acoustic_fem.library.provenance import versions
from acoustic_fem.quantities.checks import frequency_grid
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import read_design, write_design
from geometry.refusal import Refusal
from studies.output.folders import check_folder
from studies.scatter.tolerances import TOLERANCES, ScatteredDesign, Tolerance

if TYPE_CHECKING:
    import zarr

#: Layout of the store, and the attribute that marks one.
FORMAT = 1
MARK = "acoustic_fem_perturbed_library"
#: Sensors per block.
BLOCK = 64
MOST_SENSORS = 1_000_000
"""Sensors that a store holds at most."""
_DIMENSIONS = ("design", "point", "microphone", "frequency")


def write_perturbed_library(
    path: str | os.PathLike[str],
    design: ArrayDesign,
    count: int,
    frequency: ArrayLike,
    *,
    tolerances: Sequence[Tolerance] = TOLERANCES,
    seed: int = 0,
    progress: Callable[[str, float], None] | None = None,
) -> PerturbedLibrary:
    """Store of the transfer functions of sensors that are drawn from a design (lumped fidelity).

    Sensor k depends on the design, the tolerances, (seed, k) and the frequencies alone. The store is built beside and
    renamed at the end: it is whole or not there.

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
            lumped batch does not take.
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
    scattered, air = ScatteredDesign(design, tolerances), design_air(design)
    target.parent.mkdir(parents=True, exist_ok=True)
    beside = target.with_name(f".{target.name}.{os.getpid()}.new")
    try:
        parts = _new_store(beside, scattered, count, grid, seed)
        for first in range(0, count, BLOCK):
            report("sensors", first / count)
            size = min(BLOCK, count - first)
            h = batch_transfer_function(scattered.sample(first, size, seed), scattered.topology, grid, air)
            parts[0][first : first + size], parts[1][first : first + size] = h.real, h.imag
        os.rename(beside, target)
    finally:
        shutil.rmtree(beside, ignore_errors=True)
    return PerturbedLibrary(target)


def _new_store(
    path: Path, scattered: ScatteredDesign, count: int, grid: NDArray[np.float64], seed: int
) -> tuple[zarr.Array, zarr.Array]:
    """A store that says what is in it; its real and imaginary parts are still empty."""
    import zarr

    design, points = scattered.design, scattered.design.point_count
    group = zarr.open_group(path, mode="w", zarr_format=3)
    group.attrs.update(
        {
            MARK: FORMAT,
            "title": f"{design.name} with manufacturing scatter",
            "design": write_design(design.completed()),
            "fidelity": "lumped",
            "microphones": list(design.microphones),
            "tolerances": json.dumps([asdict(tolerance) for tolerance in scattered.tolerances]),
            **versions(seed, ("numpy", "scipy", "zarr")),
        }
    )
    _coordinate(group, "design", np.arange(count), "number of the sensor, from 0")
    _coordinate(group, "point", np.arange(1, points + 1), "sensing point, from 1")
    _coordinate(group, "frequency", grid, "frequency", units="Hz")
    shape = (count, points, len(design.microphones), len(grid))
    real, imag = (
        group.create_array(
            f"transfer_function_{part}", shape=shape, dtype="float64", chunks=(min(BLOCK, count), *shape[1:]),
            dimension_names=_DIMENSIONS, attributes={"units": "Pa/Pa", "long_name": f"transfer function, {part}"},
        )
        for part in ("real", "imag")
    )  # fmt: skip
    return real, imag


class PerturbedLibrary:
    """Store of mis-made sensors, read a block at a time: a
    :class:`localize.signals.touch_generator.TransferFunctionSource`.

    Raises:
        Refusal: the path is no such store, or was written by a later version.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        import zarr

        self.path = Path(path)
        try:
            group: Any = zarr.open_group(self.path, mode="r", zarr_format=3)
            attributes: dict[str, Any] = dict(group.attrs)
        except (OSError, ValueError, KeyError) as error:
            raise Refusal(f"{self.path}: is not a library of perturbed transfer functions: {error}") from None
        if attributes.get(MARK) != FORMAT:
            raise Refusal(f"{self.path}: is not a library of perturbed transfer functions of format {FORMAT}")
        self.attributes = attributes
        #: (n_freq,) float64, Hz.
        self.frequency: NDArray[np.float64] = np.asarray(group["frequency"][:], np.float64)
        self._parts: tuple[Any, Any] = (group["transfer_function_real"], group["transfer_function_imag"])
        self._block = int(self._parts[0].chunks[0])
        self._held: tuple[int, NDArray[np.complex128]] | None = None

    @property
    def design(self) -> ArrayDesign:
        """Nominal design."""
        return read_design(str(self.attributes["design"]), f"{self.path}: design")

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
            Refusal: sensors that the store does not hold.
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
            rows = slice(block * self._block, (block + 1) * self._block)
            self._held = block, np.asarray(self._parts[0][rows]) + 1j * np.asarray(self._parts[1][rows])
        return self._held[1]


def _coordinate(group: Any, name: str, values: NDArray[Any], long_name: str, **attributes: str) -> None:
    array = group.create_array(
        name, shape=values.shape, dtype=str(values.dtype), chunks=values.shape, dimension_names=(name,),
        attributes={"long_name": long_name, **attributes},
    )  # fmt: skip
    array[:] = values

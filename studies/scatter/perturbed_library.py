"""Libraries of sensors with manufacturing scatter: thousands of arrays drawn from one design, in one Zarr store.

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

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.atlas.cell_table import cell_atlas
from acoustic_fem.atlas.fidelity_choice import QuickFidelity
from acoustic_fem.library.provenance import versions
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter.as_built_sensors import AsBuiltSensors, as_built_fidelity
from acoustic_fem.scatter.tolerances import TOLERANCES, ScatteredDesign, Tolerance
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, read_completed, write_design
from geometry.ground.argument_checks import check_range
from geometry.ground.file_checks import check_local, read_bytes
from geometry.ground.record import read_record, sha256, write_record
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.whole_files import writing
from studies.output.folders import check_folder
from studies.output.sole_writer import sole_writer_of_file
from studies.output.zarr_files import METADATA, Layout, Variable, ZarrFiles

#: Attribute of the Zarr store that marks it, and the layout of the store that it states.
MARK = "acoustic_fem_perturbed_library"
FORMAT = 4
#: Record beside the arrays: what is in the store, and the SHA-256 of each of its files.
_MANIFEST = "manifest"
_KIND = "perturbed library 4"
#: Sensors per block.
BLOCK = 64
MOST_SENSORS = 1_000_000
"""Sensors that a store holds at most."""
_PARTS = ("transfer_function_real", "transfer_function_imag")


def write_perturbed_library(
    path: str | os.PathLike[str],
    design: DesignLike,
    count: int,
    frequency: FrequencyLike,
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
        path: of the new store, such as ``as-built.zarr``.
        design: the nominal array.
        count: sensors, 1 to a million.
        frequency: (n_freq,), Hz, ascending.
        tolerances: what scatters.
        seed: seed of the random deviations.
        progress: function that is called with the name of the step and the fraction done.

    Raises:
        Refusal: a path that exists or cannot be written, a count or grid out of range, or a design that the
            batch does not take.
    """
    target = Path(path)
    check_range("count", count, 1, MOST_SENSORS, whole=True)
    if target.exists():
        raise Refusal("exists; a library is never overwritten", kind=Kind.EXISTS, file=target)
    check_folder(target)
    grid = frequency_grid(frequency)
    report = progress or (lambda message, fraction: None)
    report("membranes", 0.0)
    scattered = ScatteredDesign(design, tolerances)
    air = design_air(scattered.design)
    fidelity = as_built_fidelity(scattered, grid, air)
    sensors = AsBuiltSensors(scattered, grid, air, fidelity.name)
    target.parent.mkdir(parents=True, exist_ok=True)
    with sole_writer_of_file(target, Refusal):
        beside = target.with_name(f".{target.name}.new")
        shutil.rmtree(beside, ignore_errors=True)  # of a process that was killed
        try:
            with writing(target):
                layout = _layout(scattered, count, grid, seed, fidelity)
                files = ZarrFiles(beside, layout)
                for first in range(0, count, BLOCK):
                    report("sensors", first / count)
                    h = sensors.transfer_functions(scattered.draws(first, min(BLOCK, count - first), seed))
                    files.put(first, dict(zip(_PARTS, (h.real, h.imag), strict=True)))
                sums = json.dumps(files.sums)
                write_record(beside / _MANIFEST, _KIND, _MANIFEST, f"{sums}\n".encode() + layout.packed())
                os.rename(beside, target)
        finally:
            shutil.rmtree(beside, ignore_errors=True)
    return PerturbedLibrary(target)


def _layout(
    scattered: ScatteredDesign, count: int, grid: NDArray[np.float64], seed: int, fidelity: QuickFidelity
) -> Layout:
    """The store before any sensor is computed."""
    design, points = scattered.design, np.arange(1, scattered.design.point_count + 1)
    attributes = {
        MARK: FORMAT,
        "title": f"{design.name} with manufacturing scatter",
        "design": write_design(design.completed()),
        "fidelity": fidelity.name,
        **({"outside_atlas": fidelity.outside} if fidelity.outside else {"atlas": cell_atlas().digest}),
        "microphones": list(design.microphones),
        "tolerances": json.dumps([asdict(tolerance) for tolerance in scattered.tolerances]),
        **versions(seed, ("numpy", "scipy", "zarr")),
    }
    variables = {
        "design": Variable(("design",), {"long_name": "number of the sensor, from 0"}, np.arange(count)),
        "point": Variable(("point",), {"long_name": "sensing point, from 1"}, points),
        "frequency": Variable(("frequency",), {"long_name": "frequency", "units": "Hz"}, grid),
    }
    for name in _PARTS:
        about = {"units": "Pa/Pa", "long_name": f"transfer function, {name.rsplit('_', 1)[1]}"}
        shape = (count, len(points), len(design.microphones), len(grid))
        variables[name] = Variable(("design", "point", "microphone", "frequency"), about, shape=shape)
    return Layout(attributes, variables, BLOCK)


class PerturbedLibrary:
    """Store of sensors with manufacturing scatter, read a block at a time: a
    :class:`localize.signals.touch_generator.TransferFunctionSource`.

    Raises:
        Refusal: the path is not such a store, was written by another version, or is damaged; names the file.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        check_local(path)
        self.path = Path(path)
        if not (self.path / _MANIFEST).exists():
            raise Refusal(
                f"is not a library of perturbed transfer functions of this version: it has no {_MANIFEST}",
                kind=Kind.MISMATCH, file=self.path, remedy="write the library again",
            )  # fmt: skip
        sums, _, layout = read_record(self.path / _MANIFEST, _KIND, _MANIFEST, Refusal).partition(b"\n")
        self._sums: dict[str, str] = json.loads(sums)
        variables = Layout.unpacked(layout).variables
        #: What made the store.
        self.attributes = Layout.unpacked(layout).attributes
        #: Number of sensors.
        self.sensor_count = variables[_PARTS[0]].shape[0]
        #: (n_freq,) float64, Hz.
        self.frequency: NDArray[np.float64] = np.asarray(variables["frequency"].values, np.float64)
        self._held: tuple[int, NDArray[np.complex128]] | None = None

    @property
    def design(self) -> ArrayDesign:
        """Nominal design."""
        return read_completed(str(self.attributes["design"]), f"{self.path}: design").completed()

    @property
    def microphones(self) -> tuple[str, ...]:
        """Names of the microphones."""
        return tuple(self.attributes["microphones"])

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
                f"sensors {first} to {first + count - 1} must be of 0 to {self.sensor_count - 1}",
                kind=Kind.OUT_OF_RANGE,
                file=self.path,
            )
        pieces = []
        for block in range(first // BLOCK, (first + count - 1) // BLOCK + 1):
            start = block * BLOCK
            pieces.append(self._read(block)[max(first - start, 0) : first + count - start])
        return np.concatenate(pieces)

    def _read(self, block: int) -> NDArray[np.complex128]:
        if self._held is None or self._held[0] != block:
            real, imaginary = (self._part(name, block) for name in _PARTS)
            self._held = block, real + 1j * imaginary
        return self._held[1]

    def _part(self, name: str, block: int) -> NDArray[np.float64]:
        """Values of a block, whose files are those that were written."""
        import zarr

        for each in (f"{name}/{METADATA}", f"{name}/c/{block}/0/0/0"):
            if sha256(read_bytes(self.path / each, "a part of a library", Refusal)) != self._sums[each]:
                raise Refusal(
                    "is damaged: its SHA-256 differs from the recorded one",
                    kind=Kind.DAMAGED, file=self.path / each, remedy="write the library again",
                )  # fmt: skip
        array = zarr.open_array(self.path / name, mode="r", zarr_format=3)
        return np.asarray(array[block * BLOCK : (block + 1) * BLOCK], np.float64)

"""Libraries of as-built sensors: whole or not there, each sensor made again alone, read a block at a time."""

from __future__ import annotations

import json
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from damage import damaged

import acoustic_fem
import geometry
import localize
from acoustic_fem.atlas import cell_atlas
from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter.tolerances import ScatteredDesign
from geometry.ground.refusal import Kind, Refusal
from localize.signals.array_response import response_of
from localize.signals.touch_generator import TouchGenerator
from studies.scatter import perturbed_library
from studies.scatter.perturbed_library import PerturbedLibrary, write_perturbed_library

GRID = np.linspace(1.0, 100.0, 16)
DESIGN = geometry.prototype("array-2x6").with_values({"lines.0.points": 3})


@pytest.fixture(scope="module")
def store(tmp_path_factory: pytest.TempPathFactory) -> PerturbedLibrary:
    return write_perturbed_library(tmp_path_factory.mktemp("stores") / "made.zarr", DESIGN, 150, GRID, seed=5)


@pytest.fixture(scope="module")
def library() -> acoustic_fem.Library:
    return acoustic_fem.solve(DESIGN, GRID, "atlas")


class Recorded:
    """A source that notes what is read; every sensor is the same multiple of one response."""

    def __init__(self, h: np.ndarray, count: int) -> None:
        self.frequency, self.sensor_count, self.read = GRID, count, []
        self._h = h

    def sensors(self, first: int, count: int) -> np.ndarray:
        self.read.append((first, count))
        return np.repeat(self._h[None], count, 0) * (1 + np.arange(first, first + count))[:, None, None, None]


def test_it_opens_with_xarray_and_carries_what_made_it(store: PerturbedLibrary) -> None:
    dataset = xr.open_zarr(store.path)
    assert dataset["transfer_function_real"].dims == ("design", "point", "microphone", "frequency")
    assert dataset["transfer_function_real"].shape == (150, 3, 2, 16)
    assert dataset["transfer_function_imag"].attrs["units"] == "Pa/Pa"
    assert np.array_equal(dataset["frequency"], GRID)
    assert dataset.attrs["seed"] == 5
    assert (dataset.attrs["fidelity"], dataset.attrs["atlas"]) == ("atlas", cell_atlas().digest)
    assert store.design.point_count == 3


def test_it_can_be_written_as_netcdf(store: PerturbedLibrary, tmp_path: Path) -> None:
    dataset = xr.open_zarr(store.path)
    dataset.to_netcdf(tmp_path / "made.nc", engine="h5netcdf")
    again = xr.open_dataset(tmp_path / "made.nc", engine="h5netcdf")
    assert again.attrs == dataset.attrs
    assert json.loads(again.attrs["microphones"]) == list(store.microphones)
    assert store.microphones == ("A", "B")


def test_any_sensor_can_be_made_again_alone(store: PerturbedLibrary) -> None:
    scattered = ScatteredDesign(DESIGN)
    for k in (0, 63, 64, 149):
        sample, air = scattered.sample(k, 1, 5), design_air(DESIGN)
        alone = batch_transfer_function(sample, scattered.topology, GRID, air, "atlas")
        assert np.abs(store.sensors(k, 1) / alone - 1).max() < 1e-12
    across = store.sensors(60, 10)
    assert np.array_equal(across[4], store.sensors(64, 1)[0])
    dataset = xr.open_zarr(store.path)
    assert np.array_equal(across.imag, dataset["transfer_function_imag"].values[60:70])


def test_only_one_block_is_held(store: PerturbedLibrary, monkeypatch: pytest.MonkeyPatch) -> None:
    fresh, read = PerturbedLibrary(store.path), []
    own = PerturbedLibrary._part

    def noted(self: PerturbedLibrary, name: str, block: int) -> np.ndarray:
        read.append(block)
        return own(self, name, block)

    monkeypatch.setattr(PerturbedLibrary, "_part", noted)
    for first in range(0, 128, 4):
        fresh.sensors(first, 4)
    assert read == [0, 0, 1, 1]


def test_a_run_that_is_stopped_leaves_nothing(tmp_path: Path) -> None:
    def stop(message: str, fraction: float) -> None:
        if fraction > 0.3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_perturbed_library(tmp_path / "made.zarr", DESIGN, 150, GRID, progress=stop)
    assert list(tmp_path.iterdir()) == []


def test_bad_input_is_refused_by_name(store: PerturbedLibrary, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="exists; a library is never overwritten"):
        write_perturbed_library(store.path, DESIGN, 3, GRID)
    with pytest.raises(ValueError, match="count = 0 must be a whole number between 1 and 1000000"):
        write_perturbed_library(tmp_path / "none.zarr", DESIGN, 0, GRID)
    with pytest.raises(ValueError, match="is not a library of perturbed transfer functions"):
        PerturbedLibrary(tmp_path / "none.zarr")
    with pytest.raises(ValueError, match="sensors 149 to 150 must be of 0 to 149"):
        store.sensors(149, 2)


def test_a_store_of_another_version_is_refused_by_name(store: PerturbedLibrary, tmp_path: Path) -> None:
    path = Path(shutil.copytree(store.path, tmp_path / "made.zarr"))
    manifest = path / "manifest"
    manifest.write_bytes(manifest.read_bytes().replace(b"perturbed library 4\n", b"perturbed library 5\n"))
    with pytest.raises(Refusal, match="is of format 5; this version of the program reads format 4") as refused:
        PerturbedLibrary(path)
    manifest.unlink()  # as in older versions
    with pytest.raises(Refusal, match="is not a library of perturbed transfer functions of this version") as older:
        PerturbedLibrary(path)
    assert {refused.value.kind, older.value.kind} == {Kind.MISMATCH}


def check_damage(store: PerturbedLibrary, folder: Path, count: int, seed: int) -> None:
    path = Path(shutil.copytree(store.path, folder / "made.zarr"))
    expected = store.sensors(0, store.sensor_count)
    for member in ("transfer_function_imag/c/1/0/0/0", "transfer_function_real/zarr.json", "manifest"):
        lost = (path / member).rename(folder / "lost")
        with pytest.raises(Refusal) as refusal:
            PerturbedLibrary(path).sensors(0, 128)
        assert str(refusal.value).startswith(str(path))
        lost.rename(path / member)
    refused = 0
    for done in damaged(path, count, seed):
        said = ""
        try:
            found = PerturbedLibrary(path)
            assert np.array_equal(found.sensors(0, found.sensor_count), expected), done
            assert (found.microphones, found.design) == (store.microphones, store.design), done
            assert np.array_equal(found.frequency, store.frequency), done
        except Refusal as error:
            said = str(error)
        assert not said or said.startswith(f"{path}/"), (done, said)
        refused += bool(said)
    assert refused > count / 3


def test_a_damaged_store_is_refused_by_the_member_or_is_the_same(store: PerturbedLibrary, tmp_path: Path) -> None:
    check_damage(store, tmp_path, 15, 1)


@pytest.mark.slow
def test_a_much_damaged_store_is_refused_or_is_the_same(store: PerturbedLibrary, tmp_path: Path) -> None:
    check_damage(store, tmp_path, 300, 2)


def test_a_source_of_one_sensor_gives_the_touches_of_its_library(library: acoustic_fem.Library) -> None:
    # a source holds bare transfer functions, whose values between frequencies no closed form gives
    response = replace(response_of(library), closed_form=None)
    plain = TouchGenerator(response, 1, "training", 1e-3)
    sourced = TouchGenerator(response, 1, "training", 1e-3, Recorded(response.transfer_function, 1))
    first, second = (touches.samples(5, 9) for touches in (plain, sourced))
    np.testing.assert_allclose(
        second.signals.numpy(), first.signals.numpy(), rtol=0, atol=1e-6
    )  # products of one part and of many
    assert first.point.tolist() == second.point.tolist()


def test_each_sensor_in_turn_is_touched_at_all_points_and_only_it_is_read(library: acoustic_fem.Library) -> None:
    # a source holds bare transfer functions, whose values between frequencies no closed form gives
    response = replace(response_of(library), closed_form=None)
    source = Recorded(response.transfer_function, 10)
    touches = TouchGenerator(response, 1, "training", 0.0, source, range(2, 7))
    plain = TouchGenerator(response, 1, "training", 0.0)
    source.read.clear()
    found, once = touches.samples(3, 6).signals, plain.samples(3, 6).signals  # sensors 3 and 4
    assert source.read == [(3, 2)]
    gain = np.repeat([4.0, 5.0], 3)[:, None, None]
    assert np.allclose(found.numpy(), once.numpy() * gain, rtol=1e-5, atol=1e-6)
    source.read.clear()
    touches.samples(12, 6)  # the last of the five and the first again
    assert sorted(source.read) == [(2, 1), (6, 1)]
    assert np.array_equal(touches.samples(0, 30).signals[11:17], touches.samples(11, 6).signals)


def test_a_source_that_does_not_fit_is_refused(library: acoustic_fem.Library, store: PerturbedLibrary) -> None:
    response = response_of(library)
    with pytest.raises(ValueError, match="its sensors have 2 points and 2 microphones; the array has 3 and 2"):
        TouchGenerator(response, 0, "training", 0.0, Recorded(response.transfer_function[:2], 3))
    with pytest.raises(ValueError, match=r"sensors = range\(100, 200\) must be consecutive ones of the source's 150"):
        TouchGenerator(response, 0, "training", 0.0, store, range(100, 200))
    narrow = Recorded(response.transfer_function[..., :8], 3)
    narrow.frequency = GRID[:8]
    with pytest.raises(ValueError, match="it must cover 1 to 100 Hz"):
        TouchGenerator(response, 0, "training", 0.0, narrow)


def test_training_streams_and_holds_out_sensors_of_its_own(
    library: acoustic_fem.Library, store: PerturbedLibrary
) -> None:
    source = Recorded(response_of(library).transfer_function, 20)
    plan = localize.TrainingPlan(microphone_noise=1e-3, seconds_per_point=6, epochs=1, batch=12, held_out_fraction=1.0)
    localizer = localize.train(library, plan, source=source)
    assert localizer.training["sensors"] == 16
    read = {first + k for first, count in source.read for k in range(count)}
    assert read == set(range(20))
    assert localize.train(library, plan, source=store).training["sensors"] == 120
    assert perturbed_library.BLOCK == 64

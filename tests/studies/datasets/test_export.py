"""Data sets as files: read back by programs of others, resumed to the same bytes, described."""

from __future__ import annotations

import hashlib
import io
import json
import re
import tarfile
from pathlib import Path

import numpy as np
import pytest
import torch
import xarray as xr
from refusals import refused

import acoustic_fem
import localize
import studies
from geometry import Kind
from geometry.design.design_file import load_design
from localize.signals.array_response import ArrayResponse, response_of
from studies.datasets import export, shard_files


@pytest.fixture(scope="module")
def array() -> ArrayResponse:
    return response_of(acoustic_fem.solve("array-2x6", np.arange(1.0, 201.0), "lumped"))


@pytest.fixture(scope="module")
def sensors() -> studies.AsBuiltArrays:
    return studies.as_built("array-2x6", 12, 2, frequency=np.arange(1.0, 121.0), fidelity="lumped")


def bytes_of(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def expected(array, split, touches, **more):
    data = localize.TouchDataset(array, split=split, touches=touches, **more)
    return {(int(each["case"]), int(each["index"])): each for each in data}


def test_numpy_alone_reads_what_the_data_set_yields(array, tmp_path):
    made = studies.export_dataset(array, tmp_path / "touches", touches=100, samples_per_shard=30, seed=4)
    assert (made.samples, made.shards, made.continued) == ({"train": 80, "validation": 10, "test": 10}, 5, 0)
    wanted = expected(array, "train", 80, seed=4)
    rows = 0
    for number in range(3):
        with np.load(tmp_path / f"touches/train-{number:05d}.npz", allow_pickle=False) as shard:
            assert "parameters" not in shard.files  # a single library is not varied
            for row, (case, index) in enumerate(zip(shard["case"], shard["index"], strict=True)):
                sample = wanted.pop((int(case), int(index)))
                np.testing.assert_array_equal(shard["signals"][row], sample["signals"])
                assert shard["point"][row] == sample["point"]
                np.testing.assert_array_equal(shard["position"][row], sample["position"])
                rows += 1
    assert (rows, wanted) == (80, {})
    assert made.size == sum(map(len, bytes_of(tmp_path / "touches").values()))


def test_the_other_formats_hold_the_same_samples(sensors, tmp_path):
    for name in shard_files.FORMATS:
        studies.export_dataset(sensors, tmp_path / name, file_format=name, touches=20, samples_per_shard=64)
    with np.load(tmp_path / "npz/train-00000.npz") as shard:
        kept = dict(shard)
    count = len(kept["point"])
    store = xr.open_zarr(tmp_path / "zarr/train.zarr")
    assert store["signals"].dims == ("sample", "microphone", "time")
    assert store["signals"].attrs["units"] == "Pa"
    pyarrow = pytest.importorskip("pyarrow.parquet")
    table = pyarrow.read_table(tmp_path / "parquet/train-00000.parquet")
    flat = table["signals"].combine_chunks().flatten().to_numpy()
    np.testing.assert_array_equal(flat.reshape(kept["signals"].shape), kept["signals"])
    with tarfile.open(tmp_path / "webdataset/train-00000.tar") as shard:
        content = {entry.name: shard.extractfile(entry).read() for entry in shard.getmembers()}
    for row in range(0, count, 7):
        key = f"{kept['case'][row]:07d}-{kept['index'][row]:010d}"
        np.testing.assert_array_equal(np.load(io.BytesIO(content[f"{key}.signals.npy"])), kept["signals"][row])
        assert json.loads(content[f"{key}.json"])["point"] == kept["point"][row]
    for name, values in kept.items():
        np.testing.assert_array_equal(store[name][:count], values)
        if values.ndim == 1:
            np.testing.assert_array_equal(table[name].to_numpy(), values)


def test_hugging_face_and_webdataset_read_their_formats(sensors, tmp_path):
    datasets = pytest.importorskip("datasets")
    webdataset = pytest.importorskip("webdataset")
    for name in ("npz", "parquet", "webdataset"):
        studies.export_dataset(
            sensors,
            tmp_path / name,
            file_format=name,
            touches=20,
            samples_per_shard=64,
            shares={"train": 0.5, "test": 0.5},
        )
    with np.load(tmp_path / "npz/train-00000.npz") as shard:
        signals, point = shard["signals"], shard["point"]
    files = {"train": str(tmp_path / "parquet/train-*.parquet"), "test": str(tmp_path / "parquet/test-*.parquet")}
    found = datasets.load_dataset("parquet", data_files=files, cache_dir=str(tmp_path / "cache")).with_format("torch")
    assert set(found["train"]["case"][:].tolist()).isdisjoint(found["test"]["case"][:].tolist())
    torch.testing.assert_close(found["train"][3]["signals"].reshape(2, 1000), torch.from_numpy(signals[3]))
    shards = webdataset.WebDataset(str(tmp_path / "webdataset/train-00000.tar"), shardshuffle=False).decode()
    for row, sample in zip(range(5), shards, strict=False):
        np.testing.assert_array_equal(sample["signals.npy"], signals[row])
        assert sample["json"]["point"] == point[row]


@pytest.mark.parametrize("name", shard_files.FORMATS)
def test_what_was_stopped_or_damaged_ends_in_the_same_bytes(name, sensors, tmp_path, monkeypatch):
    def write(folder):
        return studies.export_dataset(sensors, folder, file_format=name, touches=30, samples_per_shard=50)

    write(tmp_path / "whole")
    kept = export._Rows.__call__
    asked = []

    def stopped(rows, start, stop):
        asked.append(start)
        if len(asked) > 4:
            raise KeyboardInterrupt
        return kept(rows, start, stop)

    monkeypatch.setattr(export._Rows, "__call__", stopped)
    with pytest.raises(KeyboardInterrupt):
        write(tmp_path / "stopped")
    monkeypatch.setattr(export._Rows, "__call__", kept)
    assert not (tmp_path / "stopped" / "README.md").exists()
    shard = next(
        path
        for path in sorted((tmp_path / "stopped").glob("train*/**/*" if name == "zarr" else "train*"))
        if path.is_file() and path.stat().st_size > 5000
    )
    shard.write_bytes(shard.read_bytes()[:-7])  # and the last of what was there is damaged
    again = write(tmp_path / "stopped")
    assert 0 < again.continued < again.shards
    assert bytes_of(tmp_path / "stopped") == bytes_of(tmp_path / "whole")
    assert write(tmp_path / "whole").continued == again.shards


def test_checksums_are_those_of_sha256sum_and_cover_every_shard(sensors, tmp_path):
    for name in ("npz", "zarr"):
        studies.export_dataset(sensors, tmp_path / name, file_format=name, touches=20, samples_per_shard=64)
        lines = (tmp_path / name / "SHA256SUMS").read_text().splitlines()
        named = {line[66:] for line in lines}
        others = {"README.md", "dataset.json", "SHA256SUMS"}
        assert named == set(bytes_of(tmp_path / name)) - others
        for line in lines:
            assert hashlib.sha256((tmp_path / name / line[66:]).read_bytes()).hexdigest() == line[:64]


@pytest.mark.parametrize("name", shard_files.FORMATS)
def test_the_five_lines_of_the_card_run_as_printed(name, sensors, tmp_path, monkeypatch, capsys):
    folder = tmp_path / name
    studies.export_dataset(
        sensors, folder, file_format=name, touches=20, samples_per_shard=64, licence="CC-BY-4.0", ambient=(40.0, 60.0)
    )
    card = (folder / "README.md").read_text(encoding="utf-8")
    assert "CC-BY-4.0" in card
    assert re.search(r"\| bore \| 13 \| -?[\d.]+ \| [\d.]+ \| standard deviations \|", card)
    assert "40 to 60 dB SPL" in card
    assert "| fidelity of the transfer functions | lumped |" in card
    assert "| their frequencies | 120 values from 1 to 120 Hz |" in card
    assert "pressure 1.0132e+05 Pa" in card
    for each in sensors.tolerances:
        assert re.search(rf"\| {each.quantity} \| \w+ \| {100 * each.deviation:g} % |\| {each.quantity} \| \w+ \| "
                         rf"{each.deviation:g} mm ", card)  # fmt: skip
    assert load_design(folder / "design.toml") == sensors.design.completed()
    assert (
        json.loads((folder / "dataset.json").read_text(encoding="utf-8"))["origin"]["tolerances"][0]["quantity"]
        == "bore"
    )
    (code,) = re.findall(r"```python\n(.*?)```", card, re.DOTALL)
    assert len([line for line in code.splitlines() if line]) <= 6
    monkeypatch.chdir(folder)
    exec(compile(code, "README.md", "exec"), {})
    assert "2, 1000" in capsys.readouterr().out


def test_the_card_of_a_sweep_says_which_text_each_number_stands_for(tmp_path):
    study = studies.Study(
        base="array-2x6", vary={"microphone_tube.bore": ["smooth", "coil"], "tube.inner_diameter": [0.4, 0.5]},
        fidelity="lumped", frequency="1:120:120", metrics=["volume"], keep="libraries",
    )  # fmt: skip
    sweep = studies.run_sweep(study, tmp_path / "r.zarr", workers=1)
    studies.export_dataset(sweep, tmp_path / "touches", touches=10, shares={"train": 1.0})
    card = (tmp_path / "touches" / "README.md").read_text(encoding="utf-8")
    assert "| microphone_tube.bore | 0: coil, 1: smooth |" in card
    assert "| fidelity of the transfer functions | lumped |" in card
    place = sweep.parameter_names.index("microphone_tube.bore")
    with np.load(tmp_path / "touches" / "train-00000.npz") as shard:
        for case, values in zip(shard["case"], shard["parameters"], strict=True):
            assert sweep.texts("microphone_tube.bore")[int(values[place])] == sweep.case(case)["microphone_tube.bore"]
    assert sweep.texts("tube.inner_diameter") == ()


def test_another_data_set_or_folder_of_others_is_not_written_over(array, tmp_path):
    studies.export_dataset(array, tmp_path / "a", touches=10)
    with refused(Kind.EXISTS, "out", file="a"):
        studies.export_dataset(array, tmp_path / "a", touches=10, seed=1)
    with refused(Kind.EXISTS, "out", file="a"):
        studies.export_dataset(replace_name(array), tmp_path / "a", touches=10)
    (tmp_path / "b").mkdir()
    (tmp_path / "b" / "thesis.txt").write_text("mine")
    with refused(Kind.EXISTS, "out", file="b"):
        studies.export_dataset(array, tmp_path / "b", touches=10)
    (tmp_path / "a" / "dataset.json").write_text("[]")
    with refused(Kind.DAMAGED, file="dataset.json"):
        studies.export_dataset(array, tmp_path / "a", touches=10)


def replace_name(array: ArrayResponse) -> ArrayResponse:
    from dataclasses import replace

    return replace(array, transfer_function=1.001 * array.transfer_function)


@pytest.mark.parametrize(
    ("arguments", "field"),
    [
        ({"file_format": "hdf5"}, "file_format"),
        ({"samples_per_shard": 0}, "samples_per_shard"),
        ({"touches": 0}, "touches"),
        ({"mix": {"stabs": 1.0}}, "mix"),
        ({"shares": {"train": 2.0}}, "shares"),
    ],
)
def test_a_bad_argument_is_refused_before_a_folder_is_made(array, tmp_path, arguments, field):
    with refused(Kind.OUT_OF_RANGE, field):
        studies.export_dataset(array, tmp_path / "new", **arguments)
    assert not (tmp_path / "new").exists()


def test_a_folder_of_other_designs_is_not_finished(tmp_path):
    grid = np.arange(1.0, 121.0)
    first, second = (studies.as_built("array-2x6", count, 2, frequency=grid, fidelity="lumped") for count in (12, 14))
    studies.export_dataset(first, tmp_path / "a", touches=10)
    (tmp_path / "a" / "train-00000.npz").unlink()
    with refused(Kind.EXISTS, "out", file="a"):
        studies.export_dataset(second, tmp_path / "a", touches=10)

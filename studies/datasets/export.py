"""Data sets as files for programs of others: shards in a common format, checksums, and a data card."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, cast

import numpy as np
import torch
from torch import Tensor

import acoustic_fem
import localize
from acoustic_fem import Library
from acoustic_fem.library.provenance import versions
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, prototype_names
from geometry.ground.argument_checks import check_choice, check_range
from geometry.ground.extras import check_extras
from geometry.ground.file_checks import read_bytes
from geometry.ground.record import sha256
from geometry.ground.refusal import Field, Kind, Refusal, counted
from geometry.ground.text_files import parse_json, read_text
from geometry.ground.typed import PathLike
from geometry.ground.whole_files import leftovers, write_text
from localize.datasets.array_source import ArraySource, source_of
from localize.datasets.splits import DEFAULT_SHARES, SPLITS, Split, check_shares, split_of
from localize.datasets.touch_dataset import DEFAULT_MIX, TouchBatch
from localize.learned.features import FeatureChoice
from localize.signals.array_response import ArrayResponse
from localize.signals.noise_model import NoiseChoice
from studies.datasets.as_built_arrays import as_built
from studies.datasets.columns import FileFormat, columns_of
from studies.datasets.data_card import data_card
from studies.datasets.origin import origin_of
from studies.datasets.shard_files import FORMATS, ZarrShards, writer_of
from studies.output.call_defaults import DATASET_FORMAT, SAMPLES_PER_SHARD, SEED, TOUCHES
from studies.output.display import Display
from studies.output.folders import check_folder, claimed_folder, write_json
from studies.output.frequencies import LIBRARY_FREQUENCIES
from studies.sweep.results import open_sweep

#: Files of a data set beside its shards.
DESCRIPTION, SUMS, CARD, DESIGN = "dataset.json", "SHA256SUMS", "README.md", "design.toml"


@dataclass(frozen=True)
class ExportedDataset:
    """Data set that was written."""

    folder: Path
    """Folder of all files."""
    samples: Mapping[Split, int]
    """Number of samples of each split."""
    shards: int
    """Number of shards."""
    continued: int
    """Number of them that an earlier run had written."""
    size: int
    """Bytes of all files."""


def export_dataset(
    source: ArraySource | Library | ArrayResponse | DesignLike,
    out: PathLike,
    *,
    as_built_sensors: int | None = None,
    file_format: FileFormat = DATASET_FORMAT,
    touches: int = TOUCHES,
    mix: Mapping[str, float] | None = None,
    shares: Mapping[Split, float] | None = None,
    seed: int = SEED,
    samples_per_shard: int = SAMPLES_PER_SHARD,
    features: FeatureChoice | None = None,
    microphone_noise: NoiseChoice = "design",
    ambient: tuple[float, float] | None = None,
    licence: str = "",
    display: Display | None = None,
) -> ExportedDataset:
    """Write a data set of touches as files that other programs read without this package.

    The folder then holds the shards of each split, README.md (the data card), dataset.json (the same facts for
    programs), design.toml (the nominal design) and SHA256SUMS. No design is in two splits; with a single array the
    splits have different touches. If writing is stopped, the same call continues after the last complete shard and
    ends with the same bytes.

    Args:
        source: as of :class:`localize.TouchDataset`; or the path of a library or of the results of a sweep; or, with
            ``as_built_sensors``, a design, the path of its file or the name of a prototype.
        as_built_sensors: number of as-built sensors to generate from a design, with the tolerances of a careful
            workshop and frequencies of 1 to 500 Hz.
        out: new folder, or the folder of this data set if writing it was stopped.
        file_format: "npz", "parquet", "webdataset" (tar files) or "zarr".
        touches: number of samples for each design; with a single array, number for all splits together.
        mix: fraction of each kind of touch; by default mostly finger touches.
        shares: fraction of the designs, or of the touches on a single array, in each split; by default 0.8, 0.1, 0.1.
        seed: seed of as-built sensors, touches and their order.
        samples_per_shard: number of samples in a shard, 1 to 65,536; the last shard of a split may have fewer.
        features: feature maps to write in place of signals, see :class:`localize.TouchDataset`.
        microphone_noise: see :class:`localize.TouchDataset`.
        ambient: see :class:`localize.TouchDataset`.
        licence: licence of the data, in words for the data card.
        display: shows progress.

    Raises:
        Refusal: an argument out of range; a folder that holds another data set or other files; a format whose packages
            are not installed; as :class:`localize.TouchDataset`.
    """
    check_choice("file_format", file_format, FORMATS)
    check_range("samples_per_shard", samples_per_shard, 1, 65_536, whole=True)
    check_range("touches", touches, 1, 2**31, whole=True)
    mix = DEFAULT_MIX if mix is None else mix
    shares = DEFAULT_SHARES if shares is None else shares
    check_shares(shares)
    if file_format == "parquet":
        check_extras("what writes Parquet", "parquet")
    folder = Path(out)
    check_folder(folder, "dataset", DESCRIPTION)
    arrays = _arrays(source, as_built_sensors, seed)
    parts = _parts(
        arrays, touches, shares, mix=mix, seed=seed, features=features, microphone_noise=microphone_noise,
        ambient=ambient,
    )  # fmt: skip
    request = _request(parts, file_format, samples_per_shard, shares, licence)
    with claimed_folder(folder, "dataset", DESCRIPTION), (display or Display()).stage("dataset") as report:
        _claim(folder, request)
        for left in leftovers(folder / SUMS):  # of a writer that was killed
            left.unlink()
        sums = _written(folder)
        total = sum(math.ceil(len(data) / samples_per_shard) for data in parts.values())
        done = continued = 0
        for split, data in parts.items():
            rows = _Rows(data)
            first = columns_of(rows(0, 1))
            writer = writer_of(file_format, folder, split, samples_per_shard, len(data), first)
            for number, start in enumerate(range(0, len(data), samples_per_shard)):
                report(f"{done} of {counted(total, 'shard')}", done / total)
                if _is_whole(folder, writer.files(number), sums):
                    continued += 1
                else:
                    stop = min(start + samples_per_shard, len(data))
                    sums |= writer.write(number, columns_of(rows(start, stop)))
                    write_text(folder / SUMS, _lines(sums))
                done += 1
            if isinstance(writer, ZarrShards):
                sums |= writer.described
        if "design" in request["origin"]:
            write_text(folder / DESIGN, request["origin"]["design"])
            sums[DESIGN] = sha256(request["origin"]["design"])
        write_text(folder / SUMS, _lines(sums))
        samples = {split: len(data) for split, data in parts.items()}
        write_json(folder / DESCRIPTION, {**request, "samples": samples, "complete": True})
        write_text(folder / CARD, data_card(arrays, parts, request, DESIGN))
    size = sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())
    return ExportedDataset(folder, samples, total, continued, size)


def _arrays(
    source: ArraySource | Library | ArrayResponse | DesignLike, as_built_count: int | None, seed: int
) -> ArraySource:
    """Arrays of what a caller gives."""
    if as_built_count is not None:
        check_range("as_built_sensors", as_built_count, 1, 1_000_000, whole=True)
        if not isinstance(source, ArrayDesign | str | os.PathLike):
            raise Refusal(
                "needs a design as its source", kind=Kind.CONFLICT, field="as_built_sensors", value=as_built_count
            )
        return as_built(source, as_built_count, seed, frequency=LIBRARY_FREQUENCIES)
    if isinstance(source, ArrayDesign) or (isinstance(source, str) and source in prototype_names()):
        raise _needs_library(source if isinstance(source, str) else source.name)
    if isinstance(source, str | os.PathLike):
        path = Path(source)
        if path.suffix == ".toml":
            raise _needs_library(str(path))
        return source_of(open_sweep(path) if path.is_dir() else acoustic_fem.load(path))
    return source_of(source)


def _needs_library(source: str) -> Refusal:
    return Refusal(
        f"{source} is a design, which has no transfer functions yet",
        kind=Kind.UNSUITABLE, field="source",
        remedy=("draw sensors about it with ", Field("as_built_sensors"), ", or solve it and give its library"),
    )  # fmt: skip


def _parts(
    arrays: ArraySource, touches: int, shares: Mapping[Split, float], **more: Any
) -> dict[Split, localize.TouchDataset]:
    """Data set of each split that has a case; with few designs a split may be empty."""
    single = len(arrays.case_numbers) == 1
    of_case = split_of(arrays.case_keys, 0, shares)
    parts = {}
    for split in SPLITS:
        count = round(touches * shares.get(split, 0.0)) if single else touches * int((of_case == split).any())
        if count:
            parts[split] = localize.TouchDataset(arrays, touches=count, split=split, shares=shares, **more)
    return parts


def _request(
    parts: Mapping[Split, localize.TouchDataset],
    file_format: FileFormat,
    samples_per_shard: int,
    shares: Mapping[Split, float],
    licence: str,
) -> dict[str, Any]:
    """Request that the bytes of a data set depend on, as JSON holds it."""
    data = next(iter(parts.values()))
    arrays, made = data.source, versions(data.seed, ("numpy", "scipy", "torch"))
    values = [arrays.parameter_values(int(case)).tobytes() for case in arrays.case_numbers]
    first = arrays.arrays([int(arrays.case_numbers[0])])[0]
    return {
        "format": file_format,
        "samples_per_shard": samples_per_shard,
        "touches": {split: each.touches for split, each in parts.items()},
        "mix": dict(zip(data.kinds, data.mix_shares, strict=True)),
        "shares": {split: shares.get(split, 0.0) for split in SPLITS},
        "cases": {split: each.cases.tolist() for split, each in parts.items()},
        "seed": data.seed,
        "features": data.features,
        "microphone_noise": data.microphone_noise,
        "ambient": None if data.ambient is None else list(data.ambient),
        "parameters": dict(zip(data.parameter_names, arrays.parameter_units, strict=True)),
        "kinds": list(data.kinds),
        "microphones": list(first.microphones),
        "design": first.name,
        "origin": origin_of(arrays),
        "first_array_sha256": sha256(first.transfer_function.tobytes(), first.frequency.tobytes()),
        "designs_sha256": sha256(*arrays.case_keys, *values),
        "licence": licence,
        "versions": {"acoustic-fem": made["code_version"], "python": made["python"], **made["libraries"]},
    }


def _claim(folder: Path, request: Mapping[str, Any]) -> None:
    """Take a folder for a data set, or that of the same one.

    Raises:
        Refusal: it holds another data set; names the first difference.
    """
    described = folder / DESCRIPTION
    if described.exists():
        found = parse_json(read_text(described, "a description of a data set", Refusal), str(described), Refusal)
        if not isinstance(found, dict):
            raise Refusal("is not the description of a data set", kind=Kind.DAMAGED, file=described)
        for name, value in json.loads(json.dumps(request)).items():
            if found.get(name) != value:
                raise Refusal(
                    f"holds another data set: its {name.replace('_', ' ')} differs",
                    kind=Kind.EXISTS, file=folder, field=Field("out"), remedy="name another folder",
                )  # fmt: skip
    write_json(described, {**request, "complete": False})


def _written(folder: Path) -> dict[str, str]:
    """SHA-256 of the files that an earlier run has finished, by name."""
    path = folder / SUMS
    if not path.exists():
        return {}
    lines = (line.split("  ", 1) for line in read_text(path, "checksums", Refusal).splitlines())
    return {name: digest for digest, name in lines}


def _is_whole(folder: Path, names: list[str], sums: Mapping[str, str]) -> bool:
    """True if all files of a shard are there as they were written."""
    return all(
        name in sums
        and (folder / name).is_file()
        and sha256(read_bytes(folder / name, "a shard", Refusal)) == sums[name]
        for name in names
    )


def _lines(sums: Mapping[str, str]) -> str:
    return "".join(f"{sums[name]}  {name}\n" for name in sorted(sums))


class _Rows:
    """Consecutive samples of a split, cut from its groups."""

    def __init__(self, data: localize.TouchDataset) -> None:
        self._ends = np.cumsum(data.group_sizes())
        self._group = lru_cache(maxsize=1)(data.group)

    def __call__(self, start: int, stop: int) -> TouchBatch:
        parts = list(self._parts(start, stop))
        return cast("TouchBatch", {name: torch.cat([part[name] for part in parts]) for name in parts[0]})

    def _parts(self, start: int, stop: int) -> Iterator[dict[str, Tensor]]:
        place = int(np.searchsorted(self._ends, start, "right"))
        while start < stop:
            begin = int(self._ends[place - 1]) if place else 0
            end = min(stop, int(self._ends[place]))
            group = cast("dict[str, Tensor]", self._group(place))
            yield {name: values[start - begin : end - begin] for name, values in group.items()}
            start, place = end, place + 1

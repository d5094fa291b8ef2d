"""Data card of a data set: what was drawn, from what, how to read it without this package."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import NDArray

import localize
from geometry.ground.refusal import counted
from localize.datasets.array_source import ArraySource
from localize.datasets.splits import SPLITS, Split
from studies.datasets.columns import COLUMNS, columns_of
from studies.datasets.origin import origin_lines
from studies.datasets.shard_files import ONE_FILE

if TYPE_CHECKING:
    from torch import Tensor

    from localize.datasets.touch_dataset import TouchBatch

#: Cases whose parameters are looked at for their ranges: reading thousands would take longer than it tells.
_LOOKED_AT = 256

_READ = {
    "npz": """import numpy as np

shard = np.load("{first}")
signals, point = shard["signals"], shard["point"]  # (n, microphone, time) in Pa, and 1, 2, ...
print(signals.shape, point[:5])
""",
    "parquet": """import numpy as np, pyarrow.parquet as pq

shard = pq.read_table("{first}")
shape = (len(shard), *{shape})
signals = shard["signals"].combine_chunks().flatten().to_numpy().reshape(shape)  # Pa
print(signals.shape, shard["point"][:5])
""",
    "webdataset": """import io, json, tarfile, numpy as np

with tarfile.open("{first}") as shard:
    signals, about = (shard.extractfile(each).read() for each in shard.getmembers()[:2])
signals, about = np.load(io.BytesIO(signals)), json.loads(about)  # Pa, and point, case, ...
print(signals.shape, about["point"])
""",
    "zarr": """import xarray as xr

data = xr.open_zarr("{first}")
signals, point = data["signals"], data["point"]  # (sample, microphone, time) in Pa, and 1, 2, ...
print(signals.shape, point[:5].values)
""",
}


def data_card(
    arrays: ArraySource, parts: Mapping[Split, localize.TouchDataset], request: Mapping[str, Any], design_file: str
) -> str:
    """Markdown of a data set, for people.

    Args:
        arrays: source of its arrays.
        parts: data set of each split.
        request: what was asked for, of :data:`studies.datasets.export.DESCRIPTION`.
        design_file: name of the file with the nominal design.
    """
    split, data = next(iter(parts.items()))
    first = f"{split}.zarr" if request["format"] == "zarr" else f"{split}-00000{ONE_FILE[request['format']][0]}"
    single = cast("dict[str, Tensor]", data.sample(int(data.cases[0]), 0))
    sample = columns_of(cast("TouchBatch", {name: values[None] for name, values in single.items()}))
    mapped = request["features"] is not None
    noise = request["microphone_noise"]
    lines = [
        f"# Touches on {request['design']}: {sum(map(len, parts.values())):,} simulated samples",
        "",
        f"Pressure signals at {counted(len(request['microphones']), 'microphone')} "
        f"({', '.join(request['microphones'])}) of passive acoustic-waveguide tactile sensors, one second at 1 kHz "
        "each, with the touched point. All signals are simulated; nothing here was recorded.",
        "",
        "| split | designs | samples |",
        "|---|---|---|",
        *(f"| {name} | {len(each.cases):,} | {len(each):,} |" for name, each in parts.items()),
        "",
        "No design is in two splits."
        + "".join(f" No design is in {name}." for name in SPLITS if name not in parts and request["shares"].get(name))
        if len(arrays.case_numbers) > 1
        else "There is one design, so all splits have the same array; no touch is in two of them.",
        "",
        "## How the touches were generated",
        "",
        "| kind of touch | fraction |",
        "|---|---|",
        *(f"| {name} | {share / sum(request['mix'].values()):.3g} |" for name, share in request["mix"].items()),
        "",
        "Noise of the microphones: "
        + ("that of each design's microphone." if noise == "design" else f"white, {noise:g} Pa rms over 0 to 500 Hz."),
        "Room sound: "
        + (
            "none."
            if request["ambient"] is None
            else "pink, {:g} to {:g} dB SPL, drawn for each sample.".format(*request["ambient"])
        ),
        f"Seed: {request['seed']}. A sample depends only on the seed, its split, `case` and `index`.",
        "",
        *_parameters(arrays),
        *origin_lines(request["origin"], design_file),
        "## Columns",
        "",
        "| column | shape | type | unit | meaning |",
        "|---|---|---|---|---|",
        *(_column(name, sample[name][0], mapped) for name in sample),
        "",
        f"Kinds, in the order of `kind`: {', '.join(request['kinds'])}, from 0. If an array has fewer points "
        "or microphones than the largest, its samples are filled up with zeros. `points` and `microphones` say "
        "which exist.",
        "",
        "## How to read it",
        "",
        "```python",
        _READ[request["format"]].format(first=first, shape=sample["signals"].shape[1:]).rstrip(),
        "```",
        "",
        "`sha256sum -c SHA256SUMS` checks every shard.",
        "",
        "## Origin and licence",
        "",
        f"Licence of these data: {request['licence'] or 'none was stated; ask who gave them to you'}.",
        "",
        "| program | version |",
        "|---|---|",
        *(f"| {name} | {value} |" for name, value in request["versions"].items()),
        "",
    ]
    return "\n".join(lines)


def _parameters(arrays: ArraySource) -> list[str]:
    if not arrays.parameter_names:
        return []
    cases = arrays.case_numbers
    looked_at = cases[np.unique(np.linspace(0, len(cases) - 1, _LOOKED_AT).round().astype(int))]
    values = np.array([arrays.parameter_values(int(case)) for case in looked_at])
    # Those of like parts stand in one row: bore 1, bore 2, ...
    rows: dict[tuple[str, str], list[int]] = {}
    for column, (name, unit) in enumerate(zip(arrays.parameter_names, arrays.parameter_units, strict=True)):
        stem, _, number = name.rpartition(" ")
        rows.setdefault((stem if number.isdecimal() else name, unit), []).append(column)
    return [
        f"Parameters of {counted(len(cases), 'design')}, in the order of `parameters`, with the range among "
        f"{len(looked_at)} of them:",
        "",
        "| parameters | how many | least | most | unit |",
        "|---|---|---|---|---|",
        *(
            f"| {name} | {len(columns)} | {values[:, columns].min():.4g} | {values[:, columns].max():.4g} | {unit} |"
            for (name, unit), columns in rows.items()
        ),
        "",
    ]


def _column(name: str, values: NDArray[Any], mapped: bool) -> str:
    column = COLUMNS[name]
    axes, unit, text = column.axes, column.unit, column.text
    if name == "signals" and mapped:
        axes, unit, text = ("map", "frequency", "time"), "1", "maps of level, phase and power"
    sizes = " x ".join(f"{axis} {size}" for axis, size in zip(axes, values.shape, strict=True)) or "one number"
    return f"| `{name}` | {sizes} | {values.dtype} | {unit} | {text} |"

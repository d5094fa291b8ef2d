"""Touches on disk, for other programs and other trainers: a folder of safetensors files and one description.

Training here makes its touches on the fly, which is faster than it can learn from them; nothing needs these files.
A shard holds consecutive samples and depends on nothing but the description and its number: one that is missing is made
again alone, the same. Each is written beside and renamed, so that a process that is killed leaves whole shards only.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

from geometry.files.writing import whole_file, write_text
from geometry.refusal import Refusal
from localize.signals.noise import NoiseSpectrum
from localize.signals.stimulus import SAMPLE_RATE
from localize.signals.touch_generator import TouchGenerator, TouchSignals

FORMAT = "acoustic-fem touches 1"
DESCRIPTION_FILE = "touches.json"


class ShardError(Refusal):
    """Refusal of a folder of shards that cannot be used: one line that names the file and the reason."""


def write_shards(
    folder: str | os.PathLike[str],
    touches: TouchGenerator,
    count: int,
    shard: int = 1000,
    progress: Callable[[int, int], None] | None = None,
) -> None:
    """Write the first samples of a generator; shards that are there are left alone.

    Args:
        folder: is made; may hold shards of the same touches.
        touches: what makes them.
        count: samples in all.
        shard: samples per file, of 8 kB each with two microphones.
        progress: called with the shards that are done and their number.

    Raises:
        Refusal: a count that is not positive.
        ShardError: the folder holds other touches.
    """
    from safetensors.torch import save

    for name, value in (("count", count), ("shard", shard)):
        if value < 1:
            raise Refusal(f"{name} = {value} must be at least 1")
    folder = Path(folder)
    description = {**_description(touches), "count": count, "shard": shard}
    if (folder / DESCRIPTION_FILE).exists():
        found = _read_description(folder)
        for name in description.keys() - {"provenance"}:
            if found.get(name) != description[name]:
                raise ShardError(f"{folder / DESCRIPTION_FILE}: holds other touches: their {name} differs")
    folder.mkdir(parents=True, exist_ok=True)
    write_text(folder / DESCRIPTION_FILE, json.dumps(description, indent=1))
    for stale in folder.glob(".shard-*"):
        stale.unlink()
    numbers = range(-(-count // shard))
    for number in numbers:
        path = _path(folder, number)
        if not path.exists():
            made = touches.samples(number * shard, min(shard, count - number * shard))
            content = save({name: value.cpu().contiguous() for name, value in vars(made).items()})
            with whole_file(path) as beside:
                beside.write_bytes(content)
        if progress:
            progress(number + 1, len(numbers))


def read_shards(folder: str | os.PathLike[str]) -> Iterator[TouchSignals]:
    """Touches of the shards of a folder, in the order of the shards.

    Raises:
        ShardError: the folder holds none, or one of them is missing or damaged.
    """
    from safetensors import SafetensorError
    from safetensors.torch import load_file

    folder = Path(folder)
    description = _read_description(folder)
    for number in range(-(-description["count"] // description["shard"])):
        path = _path(folder, number)
        try:
            yield TouchSignals(**load_file(path))
        except (OSError, SafetensorError) as error:
            raise ShardError(f"{path}: missing or damaged ({error}); write the shards again") from None


def _path(folder: Path, number: int) -> Path:
    return folder / f"shard-{number:06d}.safetensors"


def _description(touches: TouchGenerator) -> dict[str, Any]:
    response, noise = touches.response, touches.microphone_noise
    return {
        "format": FORMAT,
        "design": response.name,
        "microphones": list(response.microphones),
        "line": response.line.tolist(),
        "place": response.place.tolist(),
        "sample_rate": SAMPLE_RATE,
        "seed": touches.seed,
        "purpose": touches.purpose,
        "stimuli": getattr(touches.stimuli, "__name__", repr(touches.stimuli)),
        "microphone_noise": noise.power.tolist() if isinstance(noise, NoiseSpectrum) else noise,
        "ambient": None if touches.ambient is None else list(touches.ambient),
        "mismatch": None if touches.mismatch is None else asdict(touches.mismatch),
        "method": touches.method,
        "transfer_functions": touches.transfer_function_sha256(),
        "provenance": dict(response.provenance),
    }


def _read_description(folder: Path) -> dict[str, Any]:
    path = folder / DESCRIPTION_FILE
    try:
        description = json.loads(path.read_bytes())
    except OSError as error:
        raise ShardError(f"{path}: cannot be read: {error.strerror or error}") from None
    except ValueError:
        raise ShardError(f"{path}: cut short or not JSON") from None
    if not isinstance(description, dict) or description.get("format") != FORMAT:
        raise ShardError(f"{path}: does not describe touches of the format {FORMAT!r}")
    return description

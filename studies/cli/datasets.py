"""Verb that writes data sets for training: dataset."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, cast

import typer

import studies
from geometry.ground.refusal import Kind, Refusal, counted
from studies.cli.options import Noise, display_on_stderr, noise_choice
from studies.cli.terminal_tables import say, tell
from studies.output.call_defaults import DATASET_FORMAT, SAMPLES_PER_SHARD, SEED, TOUCHES

if TYPE_CHECKING:
    from localize.datasets.splits import Split
    from localize.learned.features import FeatureChoice
    from studies.datasets.columns import FileFormat


def dataset(
    source: Annotated[
        str,
        typer.Argument(
            metavar="SOURCE",
            help="A library, or the results of a sweep that keeps libraries. With --as-built, a design file or "
            "prototype.",
        ),
    ],
    out: Annotated[
        Path,
        typer.Option(help="New folder, or the folder of this data set if writing it was stopped."),
    ],
    file_format: Annotated[
        str, typer.Option("--format", help="Format of the shards: npz, parquet, webdataset or zarr.")
    ] = DATASET_FORMAT,
    as_built_sensors: Annotated[
        int | None,
        typer.Option(
            "--as-built",
            help="Number of as-built sensors to generate from a design.",
        ),
    ] = None,
    touches: Annotated[int, typer.Option(help="Number of samples for each design.")] = TOUCHES,
    mix: Annotated[
        str | None,
        typer.Option(
            metavar="KIND=FRACTION,...",
            help="Kinds of touches and their fractions: taps, presses, slides, multi-sines, friction, pulse-wave. "
            "Default: mostly those of fingers.",
        ),
    ] = None,
    shares: Annotated[
        str | None,
        typer.Option(
            "--split",
            metavar="NAME=FRACTION,...",
            help="Fraction of the designs in train, validation and test. Default: train=0.8,validation=0.1,test=0.1.",
        ),
    ] = None,
    samples_per_shard: Annotated[int, typer.Option(help="Number of samples in a shard.")] = SAMPLES_PER_SHARD,
    features: Annotated[
        str | None,
        typer.Option(
            help="Feature maps to write in place of signals: phasors, paper or rooms. Default: signals.",
        ),
    ] = None,
    noise: Noise = None,
    ambient: Annotated[
        str | None,
        typer.Option(
            "--sound",
            metavar="LOW:HIGH",
            help="Lowest and highest level of the room sound, dB SPL. Default: no sound.",
        ),
    ] = None,
    licence: Annotated[str | None, typer.Option(help="Licence of the data, for the data card.")] = None,
    seed: Annotated[int, typer.Option(help="Seed of as-built sensors, touches and order.")] = SEED,
) -> None:
    """Write a data set of touches to train networks of your own, readable without this program.

    Writes shards of training, validation and test samples, README.md (how the data was generated and how to read it)
    and SHA256SUMS. No design is in two splits. If writing is stopped, start the command again. It continues after the
    last complete shard and ends with the same bytes.

    Example: [bold]acoustic-fem dataset array-2x6 --as-built 500 --touches 1000 --format parquet --out touches[/bold]
    """
    with display_on_stderr() as display:
        made = studies.export_dataset(
            source,
            out,
            as_built_sensors=as_built_sensors,
            file_format=cast("FileFormat", file_format),
            touches=touches,
            mix=None if mix is None else _shares("mix", mix),
            shares=None if shares is None else cast("dict[Split, float]", _shares("shares", shares)),
            samples_per_shard=samples_per_shard,
            features=cast("FeatureChoice | None", features),
            microphone_noise=noise_choice(noise),
            ambient=None if ambient is None else _levels(ambient),
            licence=licence or "",
            seed=seed,
            display=display,
        )
    samples = ", ".join(f"{count:,} {split}" for split, count in made.samples.items())
    kept = f", {made.continued} of them from before" if made.continued else ""
    tell(f"{samples} samples in {counted(made.shards, 'shard')}{kept}; {made.size / 1e6:,.0f} MB")
    say(made.folder / "README.md")


def _shares(field: str, text: str) -> dict[str, float]:
    """Shares by name, from ``NAME=SHARE,...``."""
    try:
        pairs = [each.split("=") for each in text.split(",")]
        found = {name.strip(): float(share) for name, share in pairs}
    except ValueError:
        found = {}
    if not found or len(found) < len(text.split(",")):
        raise Refusal(
            kind=Kind.WRONG_TYPE, field=field, value=text, allowed="NAME=FRACTION,NAME=FRACTION,..., each name once"
        )
    return found


def _levels(text: str) -> tuple[float, float]:
    """Lowest and highest level, from ``LOW:HIGH``."""
    try:
        low, high = map(float, text.split(":"))
    except ValueError:
        raise Refusal(kind=Kind.WRONG_TYPE, field="ambient", value=text, allowed="LOW:HIGH, dB SPL") from None
    return low, high

"""The paper's table as a study: top-1 accuracy by number of microphones, points, noise and decoder.

``python benchmarks/paper_table.py --out DIR`` takes about ten minutes of one core. Every row is stored when it is done.
If you stop the command and run it again, it continues where it was. ``--full`` trains with
:meth:`localize.TrainingPlan.paper`, 14,000 touches of every point over 30 epochs, which takes hours for 12 points and
days for all. ``--seconds`` cuts each training short.
"""

from __future__ import annotations

import json
import warnings
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import typer

from studies.output.folders import check_folder, write_json

if TYPE_CHECKING:
    from localize import ArrayResponse, BayesDecoder, Localizer, TrainingPlan

#: Prototypes of two, three and four fully connected microphones.
DESIGNS = ("line-2", "line-3", "line-4")
POINTS_PER_LINE = (12, 24, 36)
#: Steps of 0.25 Hz where the responses of taps bend; up to 500 Hz, for the noise of the stimuli is white.
FREQUENCY = np.concatenate([np.arange(0.25, 5.0, 0.25), np.arange(5.0, 500.5, 1.0)])
#: Pa rms of white noise: none, and 60 dB below 94 dB SPL.
NOISES = (0.0, 1e-3)
#: What a decoder is told where there is none, Pa rms.
LEAST_NOISE = 1e-6
#: Touches judged in each cell of the table, about; at least ten of every point.
JUDGED = 4000
BEGIN, END = "<!-- table: made by benchmarks/paper_table.py -->", "<!-- end -->"
FULL_BEGIN, FULL_END = (
    "<!-- paper's plan: made by benchmarks/paper_table.py --full -->",
    "<!-- end of the paper's plan -->",
)


@dataclass(frozen=True)
class Row:
    """Row of the table: one array in one noise."""

    design: str
    """Name of the prototype."""
    points_per_line: int
    """Number of points of each line."""
    noise: float
    """Noise of every microphone, in training and in judging, Pa rms."""

    @property
    def name(self) -> str:
        """Name of the row's files."""
        return f"{self.design}-{self.points_per_line}-noise-{self.noise:g}"


def plan_of(full: bool, row: Row, seconds: float | None = None) -> TrainingPlan:
    """Plan for the network of a row, which is trained with the noise in which it is evaluated."""
    from localize import TrainingPlan

    if full:
        return replace(TrainingPlan.paper(), microphone_noise=row.noise, bfloat16=True, time_limit=seconds)
    return TrainingPlan(microphone_noise=row.noise, time_limit=seconds)


def solved(row: Row) -> ArrayResponse:
    """Transfer functions of a row's array, lumped."""
    import acoustic_fem
    import geometry
    from localize.signals.array_response import response_of

    design = geometry.prototype(row.design)
    lines = {f"lines.{k}.points": row.points_per_line for k in range(len(design.lines))}
    with warnings.catch_warnings():
        # Above 100 Hz the entrance losses of a tube leave their range; only the stimuli's noise lies there.
        warnings.filterwarnings("ignore", "entrance loss of a tube", UserWarning)
        return response_of(acoustic_fem.solve(design.with_values(lines), FREQUENCY, "lumped"))


def measure(row: Row, full: bool, folder: Path, seconds: float | None = None) -> dict[str, Any]:
    """Figures of one row: its array trained on, evaluated and timed."""
    from frame_time import frame_time

    from localize import BayesDecoder, evaluate, export_onnx, train
    from localize.graphs import OnnxLocalizer
    from localize.signals.stimulus_kinds import STIMULI

    response = solved(row)
    touches = max(10, JUDGED // response.point_count)
    plan = plan_of(full, row, seconds)
    checkpoint = folder / f"{row.name}{'-full' * full}.safetensors"
    network = train(response, plan, checkpoint=checkpoint)
    decoder = BayesDecoder(response, max(row.noise, LEAST_NOISE))
    found: dict[str, Any] = {"network": {"training": dict(network.training)}, "model-based": {}}
    locators: dict[str, Localizer | BayesDecoder] = {"network": network, "model-based": decoder}
    for name, locator in locators.items():
        for stimuli in ("multi-sines", "taps"):
            judged = evaluate(locator, response, touches, row.noise, stimuli=STIMULI[stimuli])
            found[name][stimuli] = [judged.top1, judged.top2, judged.within_one]
        graph = folder / f"{row.name}-{name}.onnx"
        export_onnx(locator, graph)
        found[name]["frame_time"] = asdict(frame_time(OnnxLocalizer(graph), response))
        graph.unlink()
    checkpoint.unlink()
    return {**asdict(row), "full": full, "microphones": len(response.microphones), "points": response.point_count,
            "touches": touches * response.point_count, "plan": asdict(plan), **found}  # fmt: skip


def table(rows: list[dict[str, Any]]) -> str:
    """Table of the rows as Markdown."""
    lines = [
        "| microphones | points | noise (mPa) | network: top-1 / top-2 (%) | network: training touches per point "
        "| network: taps, top-1 (%) | Bayes decoder: top-1 / top-2 (%) | Bayes decoder: taps, top-1 (%) "
        "| time per frame, network / Bayes decoder (ms) |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for row in sorted(rows, key=lambda row: (row["microphones"], row["points"], row["noise"])):
        network, decoder = row["network"], row["model-based"]
        shares = [[f"{100 * share:.1f}" for share in each["multi-sines"][:2]] for each in (network, decoder)]
        taps = [f"{100 * each['taps'][0]:.1f}" for each in (network, decoder)]
        times = " / ".join(f"{each['frame_time']['processor_median']:.2f}" for each in (network, decoder))
        trained = network["training"]["touches"] // row["points"]
        lines.append(
            f"| {row['microphones']} | {row['points']} | {1e3 * row['noise']:g} | {' / '.join(shares[0])} | {trained} "
            f"| {taps[0]} | {' / '.join(shares[1])} | {taps[1]} | {times} |"
        )
    return "\n".join(lines)


def full_table(rows: list[dict[str, Any]]) -> str:
    """Table of the rows that were trained by the paper's plan, as Markdown."""
    lines = [
        "| microphones | points | epochs of 30 | training touches | held-out touches with short windows: top-1 (%) "
        "| exact touches: top-1 / top-2 (%) | taps: top-1 (%) | Bayes decoder, exact touches: top-1 (%) |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for row in sorted(rows, key=lambda row: (row["microphones"], row["points"], row["noise"])):
        network, training = row["network"], row["network"]["training"]
        epochs = training["touches"] / (row["plan"]["seconds_per_point"] * row["points"])
        own = with_interval(training["held_out_accuracy"][-1], training["held_out_touches"])
        exact = with_interval(network["multi-sines"][0], row["touches"])
        lines.append(
            f"| {row['microphones']} | {row['points']} | {epochs:.1f} | {training['touches']:,} | {own} "
            f"| {exact} / {100 * network['multi-sines'][1]:.1f} | {100 * network['taps'][0]:.1f} "
            f"| {with_interval(row['model-based']['multi-sines'][0], row['touches'])} |"
        )
    return "\n".join(lines)


def with_interval(share: float, touches: int) -> str:
    """Percentage with its 95 % interval over so many touches."""
    from localize.evaluation.accuracy import wilson_interval

    low, high = wilson_interval(share, touches)
    return f"{100 * share:.1f} ({100 * low:.1f} to {100 * high:.1f})"


def write_table(folder: Path, rows: list[dict[str, Any]], full: bool) -> None:
    """Write the table into the folder's README.md where that has a place for it, else into table.md."""
    from geometry.ground.whole_files import replace_section, write_text

    page = folder / "README.md"
    begin, end = (FULL_BEGIN, FULL_END) if full else (BEGIN, END)
    text = full_table(rows) if full else table(rows)
    if page.exists() and begin in page.read_text(encoding="utf-8"):
        replace_section(page, begin, end, text.splitlines())
    else:
        write_text(folder / "table.md", text + "\n")


def main(
    out: Annotated[Path, typer.Option(help="The folder for rows and table.", show_default=False)],
    full: Annotated[bool, typer.Option("--full", help="Train by the paper's plan: hours a row, days in all.")] = False,
    design: Annotated[list[str] | None, typer.Option(help="Only this prototype; may be repeated.")] = None,
    points: Annotated[list[int] | None, typer.Option(help="Only so many points per line; may be repeated.")] = None,
    seconds: Annotated[float | None, typer.Option(help="Cut each training short after so many seconds.")] = None,
) -> None:
    """Measure the rows that the folder does not hold yet, then write the table of all that it holds."""
    for name in design or ():
        if name not in DESIGNS:
            raise typer.BadParameter(f"--design {name} must be one of: {', '.join(DESIGNS)}")
    for count in points or ():
        if not 2 <= count <= 64:
            raise typer.BadParameter(f"--points {count} must be between 2 and 64")
    check_folder(out)
    out.mkdir(parents=True, exist_ok=True)
    for name in design or DESIGNS:
        for count in points or POINTS_PER_LINE:
            for noise in NOISES[:1] if full else NOISES:
                row = Row(name, count, noise)
                file = out / f"{row.name}{'-full' * full}.json"
                if not file.exists():
                    write_json(file, measure(row, full, out, seconds))
                print(f"{file}: done", flush=True)
    files = sorted(out.glob("line-*.json"))
    rows = [json.loads(file.read_text(encoding="utf-8")) for file in files]
    write_table(out, [row for row in rows if row["full"] == full], full)


if __name__ == "__main__":
    typer.run(main)

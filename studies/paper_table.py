"""The paper's table as a study: which share of touches is named right, by microphones, points, noise and decoder.

``python -m studies.paper_table --out DIR`` takes half an hour of one core; every row is stored when it is
done, a training that is stopped goes on where it was, and running the command again takes up the rest. ``--full``
trains as long as the paper says, 14,000 touches of every point over 30 epochs, which takes days.
"""

from __future__ import annotations

import json
import re
import warnings
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import typer

from studies.folders import check_folder, write_json

if TYPE_CHECKING:
    from localize import ArrayResponse, TrainingPlan
    from localize.evaluation import Locator

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
BEGIN, END = "<!-- table: made by python -m studies.paper_table -->", "<!-- end -->"


@dataclass(frozen=True)
class Row:
    """One array."""

    design: str
    points_per_line: int

    @property
    def name(self) -> str:
        """Of its files."""
        return f"{self.design}-{self.points_per_line}"


def plan_of(full: bool, microphones: int) -> TrainingPlan:
    """How networks of the table are trained: with the higher noise, which costs those without hardly anything."""
    from localize import TrainingPlan

    if full:
        return replace(TrainingPlan.paper(), seconds_per_point=14_000)
    # More microphones tell more, and have more points.
    return TrainingPlan(seconds_per_point=400 // microphones, epochs=20, microphone_noise=NOISES[-1])


def solved(row: Row) -> ArrayResponse:
    """The array's transfer functions, lumped."""
    import acoustic_fem
    import geometry
    from localize.dataset import response_of

    design = geometry.prototype(row.design)
    lines = {f"lines.{k}.points": row.points_per_line for k in range(len(design.lines))}
    with warnings.catch_warnings():
        # Above 100 Hz the entrance losses of a tube leave their range; only the stimuli's noise lies there.
        warnings.filterwarnings("ignore", "entrance loss of a tube", UserWarning)
        return response_of(acoustic_fem.solve(design.with_values(lines), FREQUENCY, "lumped"))


def measure(row: Row, full: bool, folder: Path) -> dict[str, Any]:
    """Train, evaluate and time one array."""
    from localize import BayesDecoder, evaluate, export_onnx, train
    from localize.finger_stimuli import STIMULI
    from localize.onnx import OnnxLocalizer
    from studies.frame_time import frame_time

    response = solved(row)
    touches = max(10, JUDGED // response.point_count)
    plan = plan_of(full, len(response.microphones))
    checkpoint = folder / f"{row.name}{'-full' * full}.safetensors"
    network = train(response, plan, checkpoint=checkpoint)
    found: dict[str, Any] = {"network": {"training": dict(network.training)}, "model-based": {}}
    for noise in NOISES:
        decoder = BayesDecoder(response, max(noise, LEAST_NOISE))
        locators: dict[str, Locator] = {"network": network, "model-based": decoder}
        for name, locator in locators.items():
            for stimuli in ("multi-sines", "taps"):
                judged = evaluate(locator, response, touches, noise, stimuli=STIMULI[stimuli])
                found[name][f"{stimuli} {noise:g}"] = [judged.top1, judged.top2, judged.within_one]
    for name, each in (("network", network), ("model-based", decoder)):
        graph = folder / f"{row.name}-{name}.onnx"
        export_onnx(each, graph)
        found[name]["frame_time"] = asdict(frame_time(OnnxLocalizer(graph), response))
        graph.unlink()
    checkpoint.unlink()
    return {**asdict(row), "full": full, "microphones": len(response.microphones), "points": response.point_count,
            "touches": touches * response.point_count, "plan": asdict(plan), **found}  # fmt: skip


def table(rows: list[dict[str, Any]]) -> str:
    """The rows as Markdown."""
    lines = [
        "| microphones | points | decoder | no noise: top-1 / top-2 (%) | noise 1 mPa: top-1 / top-2 (%) "
        "| taps, no noise / 1 mPa: top-1 (%) | one frame, p50 / p99 (ms) | processor time, p50 (ms) |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for row in sorted(rows, key=lambda row: (row["microphones"], row["points"])):
        for name in ("network", "model-based"):
            found, time = row[name], row[name]["frame_time"]
            sines = (" / ".join(f"{100 * v:.1f}" for v in found[f"multi-sines {noise:g}"][:2]) for noise in NOISES)
            taps = " / ".join(f"{100 * found[f'taps {noise:g}'][0]:.1f}" for noise in NOISES)
            lines.append(
                f"| {row['microphones']} | {row['points']} | {name} | {' | '.join(sines)} | {taps} "
                f"| {time['median']:.2f} / {time['worst']:.2f} | {time['processor_median']:.2f} |"
            )
    return "\n".join(lines)


def write_table(folder: Path, rows: list[dict[str, Any]]) -> None:
    """Into the folder's README.md where that has a place for it, else into table.md."""
    from geometry.whole_file import write_text

    page = folder / "README.md"
    text = page.read_text(encoding="utf-8") if page.exists() else ""
    if BEGIN in text:
        pattern = re.compile(re.escape(BEGIN) + ".*?" + re.escape(END), re.DOTALL)
        write_text(page, pattern.sub(lambda _: f"{BEGIN}\n{table(rows)}\n{END}", text))
    else:
        write_text(folder / "table.md", table(rows) + "\n")


def main(
    out: Annotated[Path, typer.Option(help="The folder for rows and table.", show_default=False)],
    full: Annotated[bool, typer.Option("--full", help="Train as long as the paper: days.")] = False,
    design: Annotated[list[str] | None, typer.Option(help="Only this prototype; may be repeated.")] = None,
    points: Annotated[list[int] | None, typer.Option(help="Only so many points per line; may be repeated.")] = None,
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
            row = Row(name, count)
            file = out / f"{row.name}{'-full' * full}.json"
            if not file.exists():
                write_json(file, measure(row, full, out))
            print(f"{file}: done", flush=True)
    files = sorted(out.glob("line-*.json"))
    rows = [json.loads(file.read_text(encoding="utf-8")) for file in files]
    write_table(out, [row for row in rows if row["full"] == full])


if __name__ == "__main__":
    typer.run(main)

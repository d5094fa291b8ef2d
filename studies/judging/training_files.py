"""What a training leaves beside the localizer: its curves and its confusions, as tables and pictures."""

from __future__ import annotations

import csv
import io
from pathlib import Path
from typing import TYPE_CHECKING

from geometry.files.writing import write_text

if TYPE_CHECKING:
    from localize import Evaluation, Localizer

CURVES, CONFUSION = "training", "confusion"
#: Touches of every point from which the confusions are counted.
TOUCHES = 50


def write_training_files(folder: Path, localizer: Localizer, judged: Evaluation) -> None:
    """Write ``training.csv`` and ``.png`` (loss and accuracy by epoch) and ``confusion.csv`` and ``.png``.

    Where there were recordings, the curves have a column for each part of those that were held out.

    Args:
        folder: must exist; files of these names are replaced.
        localizer: just trained.
        judged: of the localizer, on touches that it has not seen.
    """
    from studies.output.figures import draw_confusion, draw_training

    loss, accuracy = localizer.training["loss"], localizer.training["held_out_accuracy"]
    by_epoch = localizer.training.get("recorded_accuracy") or [{} for _ in loss]
    recorded = {part: [entry[part] for entry in by_epoch] for part in by_epoch[0]}
    rows = [["epoch", "loss", "held_out_accuracy", *(f"recorded {part}" for part in recorded)]]
    rows += [
        [str(k), *map(repr, values)] for k, values in enumerate(zip(loss, accuracy, *recorded.values(), strict=True), 1)
    ]
    write_text(folder / f"{CURVES}.csv", _table(rows))
    draw_training(loss, {"simulated": accuracy, **recorded}, folder / f"{CURVES}.png")
    points = tuple(range(1, localizer.point_count + 1))
    rows = [["touched", *(str(point) for point in points)]]
    rows += [[str(k), *(str(n) for n in named)] for k, named in enumerate(judged.confusion.tolist(), 1)]
    write_text(folder / f"{CONFUSION}.csv", _table(rows))
    draw_confusion(judged.confusion, points, folder / f"{CONFUSION}.png")


def _table(rows: list[list[str]]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()

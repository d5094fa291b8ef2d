"""Files of a training beside the localizer: its curves and its confusions, as tables and pictures."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from geometry.ground.whole_files import write_text
from studies.output.response_figures import draw_confusion, draw_training

if TYPE_CHECKING:
    from localize import Evaluation, Localizer, Recognizer

CURVES, CONFUSION = "training", "confusion"
#: Touches of every point from which the confusions are counted.
TOUCHES = 50


def write_training_files(folder: Path, localizer: Localizer, evaluation: Evaluation) -> None:
    """Write ``training.csv`` and ``.png`` (loss and accuracy by epoch) and ``confusion.csv`` and ``.png``.

    If there were recordings, the curves have a column for each part of those that were held out.

    Args:
        folder: must exist; files of these names are replaced.
        localizer: just trained.
        evaluation: evaluation of the localizer on touches that it has not seen.
    """
    points = tuple(range(1, localizer.point_count + 1))
    _write(folder, localizer.training, points, evaluation.confusion, "point")


def write_recognizer_files(folder: Path, recognizer: Recognizer) -> None:
    """Write the files of :func:`write_training_files` for a recognizer, confusions being those of held-out takes.

    Args:
        folder: must exist; files of these names are replaced.
        recognizer: just trained.
    """
    confusion = np.array(recognizer.training["confusion"], np.int64)
    _write(folder, recognizer.training, recognizer.labels, confusion, "kind")


def _write(
    folder: Path, training: Mapping[str, Any], names: Sequence[int | str], confusion: NDArray[np.int64], what: str
) -> None:
    loss, accuracy = training["loss"], training["held_out_accuracy"]
    by_epoch = training.get("recorded_accuracy") or [{} for _ in loss]
    recorded = {part: [entry[part] for entry in by_epoch] for part in by_epoch[0]}
    rows = [["epoch", "loss", "held_out_accuracy", *(f"recorded {part}" for part in recorded)]]
    rows += [
        [str(k), *map(repr, values)] for k, values in enumerate(zip(loss, accuracy, *recorded.values(), strict=True), 1)
    ]
    write_text(folder / f"{CURVES}.csv", _table(rows))
    draw_training(loss, {"held out" if what == "kind" else "simulated": accuracy, **recorded}, folder / f"{CURVES}.png")
    rows = [["touched", *(str(name) for name in names)]]
    rows += [[str(name), *map(str, named)] for name, named in zip(names, confusion.tolist(), strict=True)]
    write_text(folder / f"{CONFUSION}.csv", _table(rows))
    draw_confusion(confusion, names, folder / f"{CONFUSION}.png", what)


def _table(rows: list[list[str]]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()

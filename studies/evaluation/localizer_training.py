"""A localizer trained on a library, with its files."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import localize
from acoustic_fem.library.transfer_functions import Library
from geometry.ground.refusal import Kind, Refusal
from localize.learned.training_plan import TrainingPlan
from localize.model.opening import ModelSource, files_of, open_library
from localize.signals.array_response import response_of
from studies.evaluation.training_files import TOUCHES, write_recognizer_files, write_training_files
from studies.output.display import Display
from studies.output.folders import check_folder, claimed_folder

#: Where the state of a training is kept until it is done.
_CHECKPOINT = "checkpoint.safetensors"


@dataclass(frozen=True, eq=False)
class TrainedLocalizer:
    """Trained localizer, and how it did."""

    folder: Path
    """Folder of the localizer, its curves and its confusions."""
    localizer: localize.Localizer
    """Localizer as :func:`localize.load_localizer` reads it from there."""
    evaluation: localize.Evaluation
    """Evaluation on touches that it has not seen."""


def train_localizer(
    library: ModelSource,
    out: str | os.PathLike[str],
    *,
    plan: TrainingPlan | None = None,
    recordings: str | os.PathLike[str] | None = None,
    display: Display | None = None,
) -> TrainedLocalizer:
    """Localizer trained on touches that are simulated with a library, and on recorded touches if you give any.

    If training is killed, call it again: it continues where it stopped and ends with the same weights.

    Args:
        library: its path, or a library or an open model in memory.
        out: the folder for the localizer, ``training.csv`` and ``confusion.csv``, and a picture of each.
        plan: plan of the training; by default that of :class:`localize.TrainingPlan`.
        recordings: a manifest of recorded touches, which become half of the training data.
        display: shows progress.

    Raises:
        Refusal: a folder that cannot be written or holds a finished localizer or another training, or a file that
            cannot be read; or another training is writing to the folder.
    """
    folder, plan = Path(out), plan or TrainingPlan()
    with _training(library, folder, "Localizer", recordings, display) as (loaded, report):
        response = response_of(loaded)
        report("training", 0.0)
        localizer = localize.train(
            loaded,
            plan,
            lambda p: report(f"epoch {p.epoch} of {p.epochs}: {p.accuracy:.1%}", p.epoch / p.epochs),
            checkpoint=folder / _CHECKPOINT,
            recordings=recordings,
        )
        localizer.save(folder)
        evaluation = localize.evaluate(localizer, response, TOUCHES, plan.microphone_noise, seed=plan.seed)
        write_training_files(folder, localizer, evaluation)
    return TrainedLocalizer(folder, localizer, evaluation)


def train_kinds(
    library: ModelSource,
    out: str | os.PathLike[str],
    kind: str,
    *,
    plan: localize.RecognitionPlan | None = None,
    recordings: str | os.PathLike[str] | None = None,
    display: Display | None = None,
) -> localize.Recognizer:
    """Trained recognizer of kinds of touch; :func:`localize.load_recognizer` reads it from its folder again.

    If training is killed, call it again: it continues where it stopped and ends with the same weights.

    Args:
        library: its path, or a library or an open model in memory.
        out: the folder for the recognizer, ``training.csv`` and ``confusion.csv``, and a picture of each.
        kind: what to recognize, the ``subject`` of :func:`localize.train_recognizer`.
        plan: how to train.
        recordings: a manifest of recorded touches with labels, if ``kind`` is "labels".
        display: shows progress.

    Raises:
        Refusal: as :func:`train_localizer` and :func:`localize.train_recognizer`.
    """
    folder = Path(out)
    with _training(library, folder, "Recognizer", recordings, display) as (loaded, report):
        report("takes", 0.0)
        recognizer = localize.train_recognizer(
            loaded,
            kind,
            plan,
            lambda p: report(f"epoch {p.epoch} of {p.epochs}: {p.accuracy:.1%}", 0.5 + 0.5 * p.epoch / p.epochs),
            folder / _CHECKPOINT,
            recordings,
            lambda share: report("takes", 0.5 * share),
        )
        recognizer.save(folder)
        write_recognizer_files(folder, recognizer)
    return recognizer


@contextmanager
def _training(
    library: ModelSource,
    folder: Path,
    title: str,
    recordings: str | os.PathLike[str] | None,
    display: Display | None,
) -> Iterator[tuple[Library, Callable[[str, float], None]]]:
    """Library of a training that alone writes to its folder, and its progress; its checkpoint goes at the end."""
    _check_unfinished(folder)
    check_folder(folder, "train", _CHECKPOINT, reads=(*files_of(library), recordings))
    loaded = open_library(library)
    response_of(loaded)  # refuses what cannot be trained on, before there is a folder
    with (
        claimed_folder(folder, "train", _CHECKPOINT, reads=(*files_of(library), recordings)),
        (display or Display()).stage(title) as report,
    ):
        _check_unfinished(folder)  # another process may have finished it in the meantime
        yield loaded, report
        (folder / _CHECKPOINT).unlink()


def _check_unfinished(folder: Path) -> None:
    for name, what in (("localizer.json", "localizer"), ("recognizer.json", "recognizer")):
        if (folder / name).exists() and not (folder / _CHECKPOINT).exists():
            raise Refusal(
                f"holds a finished {what}", kind=Kind.EXISTS, file=folder, remedy="remove it, or choose another folder"
            )

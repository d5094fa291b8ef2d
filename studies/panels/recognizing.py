"""Letters and kinds on the page: a letter written on a design, and the kinds that a recognizer assigns to touches."""

from __future__ import annotations

import base64
import binascii
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import localize
from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_choice
from geometry.ground.refusal import Kind, Refusal
from localize import recognition
from localize.model.opening import open_library
from studies.panels.touching import decode, decoder_of, without_folder

#: Files of a recognizer's folder.
_FILES = re.compile(r"recognizer\.json|weights-[0-9a-f]{12}\.safetensors")


def store_recognizer(content: bytes, folder: str) -> dict[str, Any]:
    """Write a recognizer that somebody handed in into a folder, and read it.

    Args:
        content: a table of JSON: each file of its folder, by its name, in base64.
        folder: exists and is empty.

    Returns:
        ``folder``; ``subject``, ``labels`` and ``design`` of the recognizer.

    Raises:
        Refusal: other files than those that ``train`` writes, or no recognizer.
    """
    try:
        files = json.loads(content)
        written = {str(name): base64.b64decode(text, validate=True) for name, text in files.items()}
    except (ValueError, TypeError, AttributeError, RecursionError, binascii.Error):
        raise Refusal("a recognizer is uploaded as a table of its files", kind=Kind.UNREADABLE) from None
    for name, data in written.items():
        if not _FILES.fullmatch(name):
            raise Refusal(
                "is not a file of a recognizer",
                kind=Kind.UNREADABLE,
                file=name[:60],
                remedy="choose recognizer.json and the weights beside it",
            )
        (Path(folder) / name).write_bytes(data)
    try:
        found = localize.load_recognizer(folder)
    except Refusal as error:
        raise without_folder(error, folder) from None
    return {"folder": folder, "subject": found.subject, "labels": list(found.labels), "design": found.design}


def write_letter(design: ArrayDesign, letter: str, sample: int) -> dict[str, Any]:
    """A letter that a finger writes on a design, and where the array hears the line.

    It is written as by :func:`localize.recognition.written`, and recorded as the takes of the studio are.

    Args:
        design: the array.
        letter: one of :data:`localize.recognition.LETTERS`.
        sample: number of the letter: each has draws of its own.

    Returns:
        As :func:`studies.panels.simulate_touch`, with ``line``: time (s), x and y (mm), and the probability that the
        line was there then.

    Raises:
        Refusal: no such letter, or a design without places, or one that cannot be decoded.
    """
    check_choice("letter", letter, recognition.LETTERS)
    decoder = decoder_of(design)
    response = decoder.recorder.response
    take = decoder.recorder.take(recognition.written(letter, response, recognition.Hand(), sample=sample), sample)
    line = localize.recognition.LineReader(response, "design").line(take.signals)
    line[:, 0] *= take.signals.shape[1] / 1000
    return {**decode(decoder, take.signals), "line": line.round(4).tolist()}


def with_kinds(
    work: Callable[..., dict[str, Any]],
    design: ArrayDesign,
    options: tuple[Any, ...],
    model: str | None,
    report: Callable[[str], None] | None = None,
) -> dict[str, Any]:
    """A decoded touch or recording of a design, with the kinds that a recognizer assigns.

    Args:
        work: :func:`write_letter` or, of :mod:`studies.panels.touching`, ``simulate_touch``, ``simulate_slide`` or
            ``replay_recording``.
        design: the array.
        options: of it, behind the design.
        model: the folder of a recognizer; None for none.
        report: called with how far it is, by a ``work`` that takes a function for it; None for the others.

    Returns:
        As ``work``; with a recognizer, ``kinds``: start and end (s), point, kind and its probability of each touch.

    Raises:
        Refusal: that of ``work``, or a recognizer of another array.
    """
    found = work(design, *options) if report is None else work(design, *options, report)
    if model is None:
        return found
    from localize.recognition.filter_bank import FilterBank

    found_model, recognizer = decoder_of(design).model, localize.load_recognizer(model)
    array = found_model.locator.array
    if (recognizer.design, recognizer.microphones) != (design.name, array.microphones):
        raise Refusal(
            kind=Kind.MISMATCH,
            problem=f"the recognizer is of {recognizer.design} with {', '.join(recognizer.microphones)}, not of "
            f"{design.name} with {', '.join(array.microphones)}",
        )
    signals = np.frombuffer(found["signals"], "<f4").reshape(len(found["microphones"]), -1).astype(np.float64)
    kinds = [
        [
            each.start,
            each.end,
            each.point,
            recognizer.labels[int(each.probability.argmax())],
            each.probability.max(),
        ]
        for each in FilterBank(open_library(found_model), recognizer).touches(signals, None, None, found_model.locator)
    ]
    return {**found, "kinds": kinds}

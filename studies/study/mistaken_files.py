"""Designs that are given in place of study files, and the study that would sweep them."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from geometry.design.design_file import prototype_names
from geometry.ground.refusal import Kind
from geometry.ground.text_files import read_text
from studies.study.parameter import StudyError

#: Tables by which the file of a design is recognised.
_OF_A_DESIGN = ("resonator", "membrane", "tube")


def study_text(path: str | os.PathLike[str]) -> str:
    """Text of a study file.

    Raises:
        StudyError: no such file, the name of a prototype, or no text in UTF-8.
    """
    if os.fspath(path) in prototype_names() and not os.path.exists(path):
        raise _is_design("is a prototype, which is a design", os.fspath(path))
    return read_text(Path(path), "a study file", StudyError)


def check_no_design(given: Mapping[str, Any], source: str) -> None:
    """Reject the content of a design file, which is recognised by its tables.

    Args:
        given: tables as TOML gives them.
        source: name of the file, for messages.

    Raises:
        StudyError: it is a design file; the message shows a study file that sweeps it.
    """
    if all(isinstance(given.get(section), Mapping) for section in _OF_A_DESIGN):
        raise _is_design("is a design file", source)


def _is_design(problem: str, source: str) -> StudyError:
    example = f'''base = "{source}" / metrics = ["predicted_top1"] / [vary] / "tube.length" = [10.0, 15.0]'''
    remedy = f"a study file names it and what varies, such as (a line for each part): {example}"
    return StudyError(problem, kind=Kind.WRONG_TYPE, file=source, remedy=remedy)

"""Letters on the pictures of plates: every copy of every part has that of the table, because ports cannot be told."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

import geometry
from geometry.assembly.model import array_model
from geometry.formats.part_files import tessellate_distinct
from geometry.printing.plates import export_plates
from geometry.schema.print_processes import process_of
from studies.kit import step_pictures


def test_each_copy_on_a_plate_has_the_letter_of_its_part(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    model = array_model(geometry.prototype("line-2").with_values({"lines.0.points": 2}))
    process, marks = process_of(model.design.printing), step_pictures.part_marks(model)
    shapes = tessellate_distinct(model.parts)
    plates = export_plates(model.parts, tmp_path, process, shapes).plates
    assert [plate.holds_molds for plate in plates] == [plate.path.stem.endswith("-molds") for plate in plates]
    written: list[str] = []

    def noted(plotter: Any, anchors: Any, words: Sequence[str], *others: Any) -> None:
        assert len(anchors) == len(words)
        written.extend(words)

    monkeypatch.setattr(step_pictures, "draw_labels", noted)
    for plate in plates:
        written.clear()
        step_pictures.plate_picture(plate, shapes, process, marks)
        expected = Counter({marks[name]: count for name, count in plate.copies.items() if name in marks})
        assert Counter(written) == expected
        assert bool(expected) != plate.holds_molds

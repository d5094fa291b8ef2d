"""Designs in place of studies, and studies in place of designs: one line says which it is and what to give."""

from __future__ import annotations

from pathlib import Path

import pytest
from refusals import check_messages, refused

import studies
from geometry import DesignError, Kind, load_design, prototype, save_design
from studies.study.parameter import StudyError


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with a design file and a study file."""
    save_design(prototype("array-2x6"), tmp_path / "design.toml")
    vary = {"tube.length": [10.0, 12.0]}
    studies.Study(base="array-2x6", vary=vary, metrics=["volume"]).save(tmp_path / "study.toml")
    return tmp_path


def test_a_design_is_no_study(folder: Path) -> None:
    for call in (studies.load_study, studies.load_optimization):
        for given in (folder / "design.toml", "array-2x6"):
            with refused(Kind.WRONG_TYPE, file=str(given), error=StudyError):
                call(given)


def test_a_study_is_no_design(folder: Path) -> None:
    for call in (load_design, studies.check_design):
        with refused(Kind.WRONG_TYPE, file="study.toml", error=DesignError) as found:
            call(folder / "study.toml")
        assert "array-2x6" in str(found.value.remedy)


def test_a_file_of_a_prototypes_name_is_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("glove").write_text('base = "array-2x6"\nmetrics = ["volume"]\n[vary]\n"tube.length" = [10, 12]\n')
    assert studies.load_study("glove").base == prototype("array-2x6")


def test_messages_of_mistaken_files(folder: Path) -> None:
    cases = {
        "design as study": lambda: studies.load_study(folder / "design.toml"),
        "prototype as study": lambda: studies.load_study("array-2x6"),
        "study as design": lambda: load_design(folder / "study.toml"),
    }
    check_messages(Path(__file__).with_name("messages_of_mistaken_files.txt"), cases, {str(folder): "FOLDER"})

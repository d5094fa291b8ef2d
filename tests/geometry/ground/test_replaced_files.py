"""Files of another kind are never written over, whoever writes."""

from pathlib import Path

import pytest
from refusals import refused

import geometry
from geometry import Kind, Refusal
from geometry.ground.whole_files import check_own_kind


@pytest.mark.parametrize("name", ["picture.png", "touches.wav", "design"])
def test_a_design_replaces_designs_only(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text("mine")
    design = geometry.prototype("line-2")
    with refused(Kind.EXISTS, file=tmp_path / name, error=geometry.DesignError):
        geometry.save_design(design, tmp_path / name)
    assert (tmp_path / name).read_text() == "mine"
    for _ in range(2):
        geometry.save_design(design, tmp_path / "design.TOML")


def test_what_is_not_there_may_have_any_name(tmp_path: Path) -> None:
    check_own_kind(tmp_path / "new", ".toml", Refusal)

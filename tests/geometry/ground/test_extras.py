"""The line to type where a package is missing names the extra that brings it, as the package's own file has them."""

from __future__ import annotations

import sys
import tomllib
from pathlib import Path

import pytest

from geometry.ground import extras
from geometry.ground.extras import EXTRAS, MissingExtra, check_extras, what_to_install

PROJECT = Path(__file__).parents[3] / "pyproject.toml"


@pytest.mark.parametrize("extra", EXTRAS)
def test_each_extra_brings_the_packages_by_which_it_is_known(extra: str) -> None:
    declared = tomllib.loads(PROJECT.read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    brought = {line.partition(">=")[0].replace("-", "").removeprefix("py") for line in declared[extra]}
    assert {each.removeprefix("py") for each in EXTRAS[extra]} <= brought


def test_the_core_brings_none_of_them() -> None:
    core = {
        line.partition(">=")[0]
        for line in tomllib.loads(PROJECT.read_text(encoding="utf-8"))["project"]["dependencies"]
    }
    assert core.isdisjoint({package for packages in EXTRAS.values() for package in packages})


def test_what_is_missing_is_refused_with_one_line_for_all(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(extras, "find_spec", lambda name: None if name in ("torch", "gmsh") else sys)
    check_extras("what draws", "plots")
    with pytest.raises(MissingExtra, match=r"^what runs is not installed: pip install 'acoustic-fem\[fem,train\]'$"):
        check_extras("what runs", "plots", "fem", "train")


def test_a_module_that_was_not_found_names_the_extra_of_its_package() -> None:
    assert what_to_install("matplotlib.collections") == (
        "matplotlib, which this needs, is not installed: pip install 'acoustic-fem[plots]'"
    )
    assert "acoustic-fem[cad]" in what_to_install("OCP.gp")
    assert what_to_install("numpy") == what_to_install(None) == ""

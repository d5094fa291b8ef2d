"""Bodies and fits of the page are those of the reader and of the command."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any
from zipfile import ZipFile

import numpy as np
import pytest
from refusals import refused

from geometry import Kind, Refusal, load_design, prototype
from geometry.body import read_body
from studies.panels.body_panel import body_shape, fit_to_body, write_fitted
from studies.panels.form import stated_values

ROBOT = Path(__file__).parents[3] / "docs" / "examples" / "robot"
BODY = ROBOT / "fingertip.step"
FITTED = load_design(ROBOT / "fingertip.toml")


def surface(**changes: Any) -> dict[str, Any]:
    """The table [surface] of the example, as the page sends it."""
    stated: dict[str, Any] = stated_values(FITTED)["surface"]
    return {name: value for name, value in {**stated, **changes}.items() if name != "body"}


def test_the_shape_of_a_body_is_that_of_the_reader() -> None:
    body, found = read_body(BODY), body_shape(str(BODY), "mm", None)
    assert (found["name"], found["faces"], found["sha256"]) == ("fingertip.step", 3, body.sha256)
    assert found["size"] == pytest.approx([18, 18, 27], abs=0.05)
    corners, facets = struct.unpack_from("<2I", found["shape"])
    places = np.frombuffer(found["shape"], "<f4", 3 * corners, 8).reshape(-1, 3)
    rest = np.frombuffer(found["shape"], "<u4", offset=8 + 12 * corners)
    np.testing.assert_allclose(places, body.vertices, atol=1e-5)
    np.testing.assert_array_equal(rest[: 3 * facets].reshape(-1, 3), body.triangles)
    np.testing.assert_array_equal(rest[3 * facets :], body.faces)


def test_a_body_that_cannot_be_read_is_refused_by_its_name(tmp_path: Path) -> None:
    (tmp_path / "a.step").write_text("no body", encoding="utf-8")
    with refused(Kind.UNREADABLE) as error:
        body_shape(str(tmp_path / "a.step"), "mm", None)
    assert str(error.value).startswith("a.step: ")


@pytest.mark.slow
def test_a_fit_gives_the_files_of_the_command(tmp_path: Path) -> None:
    lines: list[str] = []
    found = fit_to_body(FITTED, surface(), None, str(BODY), lines.append)
    assert found == FITTED
    assert any("dividing the body" in line for line in lines)
    write_fitted(found, str(BODY), str(tmp_path / "a.zip"))
    with ZipFile(tmp_path / "a.zip") as packed:
        packed.extractall(tmp_path)
    assert load_design(tmp_path / "robot-fingertip.toml") == FITTED
    assert (tmp_path / "robot-fingertip.places.json").read_bytes() == (ROBOT / "fingertip.places.json").read_bytes()
    assert (tmp_path / "fingertip.step").read_bytes() == BODY.read_bytes()


def test_what_cannot_be_fitted_is_refused_without_a_folder() -> None:
    for changes, points, field in (
        ({"pitch": 2.0}, None, "surface.pitch"),
        ({"pitch": "wide"}, None, "surface.pitch"),
        ({"shape": "round"}, None, "surface.shape"),
        ({}, [12], "lines.0.points"),
        ({"pitch": None}, [12, 3], "points"),
        ({"pitch": None}, [0], "lines.0.points"),
        ({"pitch": None}, None, "lines.0.points"),
    ):
        with pytest.raises(Refusal) as error:
            fit_to_body(FITTED, surface(**changes), points, str(BODY))
        assert error.value.field == field
        assert "/" not in str(error.value)
        assert "\n" not in str(error.value)


def test_a_design_without_places_has_no_files_of_a_fit(tmp_path: Path) -> None:
    with refused(Kind.UNSUITABLE, "layout.kind"):
        write_fitted(prototype("array-2x6"), None, str(tmp_path / "a.zip"))

"""Figures hold something, and numbers are written as people read them."""

from __future__ import annotations

import io

import numpy as np
import pytest
from PIL import Image

from studies.output.display import number
from studies.output.figure_style import crop_picture
from studies.output.response_figures import draw_confusion, draw_transfer_functions


def test_a_picture_is_cropped_to_its_content(tmp_path) -> None:
    picture = np.full((100, 200, 3), 255, np.uint8)
    picture[40:60, 70:170] = 10
    Image.fromarray(picture).save(tmp_path / "a.png")
    crop_picture(tmp_path / "a.png", margin=5)
    cropped = np.asarray(Image.open(tmp_path / "a.png").convert("RGB"))
    assert np.array_equal(cropped, picture[35:65, 65:175])
    Image.fromarray(np.full((50, 60, 3), 255, np.uint8)).save(tmp_path / "white.png")
    crop_picture(tmp_path / "white.png")
    assert Image.open(tmp_path / "white.png").size == (60, 50)


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (-0.01, 1, "0.0"),
        (-28.76, 1, "−28.8"),
        (5729.4, None, "5729"),
        (0.1181, None, "0.118"),
        (0.0, None, "0"),
        (12.0, None, "12"),
    ],
)
def test_numbers_are_written_as_people_read_them(value: float, digits: int | None, text: str) -> None:
    assert number(value, digits) == text


def test_many_points_get_a_colour_bar_and_no_numbers_in_cells(tmp_path) -> None:
    import xarray as xr

    grid = np.linspace(1, 100, 8)
    h = xr.DataArray(
        np.exp(-1j * np.outer(np.arange(1, 31), grid / 50))[:, None, :] * np.ones((1, 2, 1)),
        dims=("point", "microphone", "frequency"),
        coords={"point": np.arange(1, 31), "microphone": ["A", "B"], "frequency": grid},
    )
    for path in (
        draw_transfer_functions(h, tmp_path / "curves.png"),
        draw_confusion(np.eye(30, dtype=np.int64) * 5, tuple(range(1, 31)), tmp_path / "confusion.png"),
    ):
        with Image.open(io.BytesIO(path.read_bytes())) as picture:
            assert np.asarray(picture.convert("L"), float).std() > 10
    assert sorted(p.name for p in tmp_path.iterdir()) == ["confusion.png", "curves.png"]

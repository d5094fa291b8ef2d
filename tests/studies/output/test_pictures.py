"""Pictures: their suffix is checked before any work, and nothing around matplotlib changes how they look."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import matplotlib as mpl
import pytest
from refusals import refused
from small_run import small_run

import studies
from geometry import Kind
from studies.output.figure_style import figure_in_style, save_figure
from studies.output.folders import PICTURES, as_picture, check_drawing, new_picture
from studies.run.wiring import draw_wirings


def located(path: Path) -> object:
    return studies.locate_recording(small_run().folder / "library.nc", "none.wav", picture=path)


def tracked(path: Path) -> object:
    return studies.track_recording(small_run().folder / "library.nc", "none.wav", picture=path)


def pulse(path: Path) -> object:
    return studies.read_pulse(small_run().folder / "library.nc", "none.wav", picture=path)


def checked(path: Path) -> object:
    return studies.check_design("array-2x6", picture=path)


def wired(path: Path) -> object:
    return studies.wiring_table(2, 3, path)


Draw = Callable[[Path], object]


@pytest.mark.parametrize("name", ["p.csv", "p.txt", "p.nc", "take.wav", "p.2026", "p.png.zip"])
@pytest.mark.parametrize("draw", [located, tracked, pulse, checked, wired])
def test_another_suffix_is_refused_before_any_work(draw: Draw, name: str, tmp_path: Path) -> None:
    with refused(Kind.OUT_OF_RANGE, file=tmp_path / name) as found:
        draw(tmp_path / name)
    assert found.value.field == ("out" if draw is wired else "picture")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(("name", "written"), [("p", "p.png"), ("p.svg", "p.svg"), ("p.PDF", "p.PDF")])
def test_a_name_without_a_suffix_is_a_png(name: str, written: str, tmp_path: Path) -> None:
    studies.wiring_table(2, 3, tmp_path / name)
    assert [path.name for path in tmp_path.iterdir()] == [written]
    begin = {"p.png": b"\x89PNG", "p.svg": b"<?xml", "p.PDF": b"%PDF-"}[written]
    assert (tmp_path / written).read_bytes().startswith(begin)


@pytest.mark.parametrize("suffix", PICTURES)
def test_every_format_of_pictures_is_written_twice(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"p{suffix}"
    for _ in range(2):
        assert new_picture(path) == as_picture(path) == path
        with figure_in_style((1, 1)) as figure:
            save_figure(figure, path)
    assert path.stat().st_size > 50


def test_what_draws_itself_refuses_another_suffix(tmp_path: Path) -> None:
    with refused(Kind.OUT_OF_RANGE, "out", file=tmp_path / "p.csv"):
        draw_wirings(tmp_path / "p.csv", 2, 3)


SETTINGS = {
    "text.usetex": True,
    "savefig.dpi": 1000,
    "axes.facecolor": "black",
    "font.size": 40,
    "svg.fonttype": "none",
    "savefig.bbox": "tight",
}


@pytest.mark.parametrize("name", SETTINGS)
def test_a_matplotlibrc_changes_no_figure(name: str, tmp_path: Path) -> None:
    plain = draw_wirings(tmp_path / "plain.png", 3, 4).read_bytes()
    with mpl.rc_context({name: SETTINGS[name]}):
        assert draw_wirings(tmp_path / "set.png", 3, 4).read_bytes() == plain
        assert mpl.rcParams[name] == SETTINGS[name]  # the user's own figures stay as they were


TIMES = ["abc", "-1", "1.5", "9" * 5000, "253402300800", " 1", "1_0", "٣"]


@pytest.mark.parametrize("text", TIMES)
def test_a_build_time_that_is_none_is_refused_before_any_work(
    text: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", text)
    for call in (check_drawing, lambda: wired(tmp_path / "p.svg")):
        with refused(Kind.OUT_OF_RANGE, "SOURCE_DATE_EPOCH", text):
            call()
    assert not list(tmp_path.iterdir())


def text_of_no_script(path: Path) -> None:
    path.write_bytes(b"text.usetex: \xff\xfe")


CODE = """
from geometry import Refusal
from studies.output.folders import check_drawing
try:
    check_drawing()
except Refusal as error:
    print(error.kind.name, error.field, error.file)
"""


@pytest.mark.parametrize(
    ("make", "backend", "said"),
    [
        (None, "agg", ""),
        (None, "nonsense", "UNSUITABLE MPLBACKEND None"),
        (None, " ", "UNSUITABLE MPLBACKEND None"),
        (text_of_no_script, "agg", "UNSUITABLE matplotlibrc None"),
        (os.mkfifo, "agg", "UNREADABLE  matplotlibrc"),
        (lambda path: path.symlink_to("/dev/zero"), "agg", "UNREADABLE  matplotlibrc"),
    ],
)
def test_what_keeps_matplotlib_from_starting_is_refused(
    make: Callable[[Path], object] | None, backend: str, said: str, tmp_path: Path
) -> None:
    if make is not None:
        make(tmp_path / "matplotlibrc")
    words = [sys.executable, "-c", CODE]
    environment = {**os.environ, "MPLBACKEND": backend}
    ended = subprocess.run(
        words, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=100, check=True
    )
    assert ended.stdout.strip() == said

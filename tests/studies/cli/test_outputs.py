"""No verb writes over a file that it reads or that is somebody's, nor into a folder that it did not make."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from small_run import small_design
from typer.testing import CliRunner

import acoustic_fem
import geometry
from geometry import Kind
from studies.cli.app import app
from studies.cli.verbs import VERBS, option_names
from studies.output.folders import MARK
from studies.output.sole_writer import sole_writer_of, sole_writer_of_file
from studies.sweep.store import sole_writer

STUDY = """base = "array-2x6"
fidelity = "lumped"
stock = "off"
frequency = "1:100:12"
metrics = ["distance_smallest"]
[vary]
"tube.inner_diameter" = [0.3, 0.4]
"""
SEARCH = (
    STUDY.replace("[0.3, 0.4]", "{from = 0.3, to = 0.5}")
    + "[optimize]\nobjectives = [{metric = 'distance_smallest'}]\ntrials = 2\n"
)
#: Verb -> its words but for ``--out``, whose files are refused before they are read, and the suffix of its file.
FILES = {
    "prototypes": ("glove", ".toml"),
    "check": ("row.toml", ".json"),
    "new": ("mine", ".toml"),
    "compare": ("library.nc glove", ".json"),
    "stock": ("", ".json"),
    "wiring": ("2 3", ".png"),
    "solve": ("row.toml", ".nc"),
    "calibrate": ("touches.toml", ".nc"),
    "recalibrate": ("library.nc take.wav", ".nc"),
    "diagnose": ("library.nc take.wav", ".json"),
    "convert": ("library.nc", ".csv"),
    "onnx": ("library.nc", ".onnx"),
    "locate": ("library.nc take.wav", ".jsonl"),
    "recognize": ("localizer library.nc take.wav", ".jsonl"),
    "track": ("library.nc take.wav", ".csv"),
    "pulse": ("library.nc take.wav", ".csv"),
    "live": ("library.nc --replay take.wav", ".jsonl"),
    "record": ("--serial COM3", ".wav"),
    "report": ("results.zarr", ".html"),
    "best": ("results.zarr 0", ".toml"),
}
Refused = Callable[..., geometry.Refusal]
#: Seconds after which a command that does not end has failed.
PATIENCE = 300
FOLDERS = {
    "parts": "row.toml",
    "run": "row.toml",
    "rig": "row.toml",
    "train": "library.nc",
    "embed": "library.nc",
    "evaluate": "localizer library.nc",
    "bend": "",
    "sweep": "study.toml",
    "dataset": "library.nc --touches 12",
    "tolerance": "row.toml",
    "optimize": "search.toml",
}


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder in which somebody works: designs, a library, a recording, a localizer, notes."""
    monkeypatch.chdir(tmp_path)
    geometry.save_design(small_design(), "row.toml")
    for name, text in (("study.toml", STUDY), ("search.toml", SEARCH), ("notes.txt", "mine"), ("touches.toml", "")):
        Path(name).write_text(text, encoding="utf-8")
    for name in ("take.wav", "take.csv", "library.nc"):
        Path(name).write_bytes(b"what nobody can measure again")
    for name in ("localizer", "results.zarr"):
        Path(name).mkdir()
        Path(name, "localizer.json").write_text("{}", encoding="utf-8")
    return tmp_path


@pytest.fixture
def refusal(place: Path) -> Refused:
    """Runs a verb that must be refused in one line and leave everything as it is; the refusal."""

    def run(verb: str, *words: object) -> geometry.Refusal:
        before = content(place)
        result = CliRunner().invoke(app, [verb, *map(str, words)])
        assert isinstance(result.exception, geometry.Refusal), (verb, result.exception, result.output)
        assert content(place) == before
        assert "\n" not in str(result.exception)
        return result.exception

    return run


def content(folder: Path) -> dict[str, bytes | None]:
    """All that lies in a folder."""
    return {str(path): path.read_bytes() if path.is_file() else None for path in folder.rglob("*")}


def test_the_tables_name_every_verb_that_writes() -> None:
    assert {verb for verb in VERBS if "out" in option_names(verb)} == {*FILES, *FOLDERS}


@pytest.mark.parametrize("verb", FILES)
def test_a_file_of_another_kind_is_never_written_over(refusal: Refused, verb: str) -> None:
    words, _ = FILES[verb]
    for name in ("take.wav", "notes.txt", "library.nc", "take.csv", "row.toml"):
        found = refusal(verb, *words.split(), "--out", name)
        assert found.file == name
        assert found.kind in (Kind.EXISTS, Kind.CONFLICT, Kind.OUT_OF_RANGE), found


@pytest.mark.parametrize(
    ("verb", "read"),
    [(verb, word) for verb, (words, _) in FILES.items() for word in words.split() if "." in word and word[0] != "r"],
)
@pytest.mark.parametrize("link", [os.link, os.symlink, "other name"])
def test_a_file_that_is_read_is_not_written_under_any_name(
    refusal: Refused, place: Path, verb: str, read: str, link: Callable[[str, str], None] | str
) -> None:
    words, suffix = FILES[verb]
    out = f"other{suffix}"
    if callable(link):
        link(read, out)
    else:
        renamed = str(Path(read).with_suffix(suffix))
        if renamed != read:
            shutil.move(read, renamed)
        words, out = words.replace(read, renamed), f"./../{place.name}/{renamed}"
    # what is never overwritten needs not be known to be read
    assert refusal(verb, *words.split(), "--out", out).kind in (Kind.CONFLICT, Kind.EXISTS)


@pytest.mark.parametrize("address", ["s3://bucket/r", "gs://b/r", "FILE:///tmp/r", "https://host/r", "zip::s3://b/r"])
def test_an_address_is_no_place_to_write_to(refusal: Refused, address: str) -> None:
    for verb, (words, suffix) in FILES.items():
        found = refusal(verb, *words.split(), "--out", f"{address}{suffix}")
        assert (found.kind, found.field, found.file) == (Kind.OUT_OF_RANGE, "out", f"{address}{suffix}"), verb
    for verb, words in FOLDERS.items():
        found = refusal(verb, *words.split(), "--out", address)
        assert (found.kind, found.field, found.file) == (Kind.OUT_OF_RANGE, "out", address), verb


@pytest.mark.parametrize("verb", ["solve", *FOLDERS])
def test_a_command_is_refused_while_another_writes_to_the_same_place(refusal: Refused, place: Path, verb: str) -> None:
    acoustic_fem.save(acoustic_fem.solve(small_design(), np.arange(1.0, 501.0), fidelity="lumped"), "whole.nc")
    words = FOLDERS.get(verb, "row.toml --fidelity lumped").replace("localizer library.nc", "whole.nc whole.nc")
    words = words.replace("library.nc", "whole.nc")
    if verb == "bend":
        words = "--angles 0 --fidelity helmholtz --frequencies 50:50:1"
    out = Path("place.nc" if verb == "solve" else "place")
    writer = {
        "solve": lambda: sole_writer_of_file(out, geometry.Refusal),
        "sweep": lambda: sole_writer(out),
    }.get(verb, lambda: sole_writer_of(out, "command", geometry.Refusal))
    with writer():
        found = refusal(verb, *words.split(), "--out", out)
        assert (found.kind, found.file) == (Kind.EXISTS, str(out))
        assert "is writing to it" in str(found)
    assert not out.exists()


def test_a_library_replaces_a_computed_one_and_nothing_else(refusal: Refused, place: Path) -> None:
    library = acoustic_fem.solve(small_design(), [10.0, 20.0], fidelity="lumped")
    acoustic_fem.save(library, "good.nc")
    shutil.copy("good.nc", "earlier.nc")
    found = refusal("convert", "good.nc", "--out", "take.csv")
    assert (found.kind, found.file) == (Kind.EXISTS, "take.csv")
    solve = ["solve", "row.toml", "--fidelity", "lumped", "--frequencies", "1:3:2", "--out"]
    assert refusal(*solve, "library.nc").kind is Kind.EXISTS
    assert CliRunner().invoke(app, [*solve, "earlier.nc"]).exit_code == 0
    assert acoustic_fem.load("earlier.nc").frequency.tolist() == [1.0, 3.0]


@pytest.mark.parametrize("verb", FOLDERS)
def test_a_folder_with_files_of_others_is_left_alone(refusal: Refused, place: Path, verb: str) -> None:
    words = FOLDERS[verb].split()
    Path("work").mkdir()
    Path("work", "thesis.txt").write_text("all my work", encoding="utf-8")
    Path("link").symlink_to("work")
    Path("nothing").symlink_to("gone")
    for out in ("work", "link", ".", f"../{place.name}", "localizer"):
        found = refusal(verb, *words, "--out", out)
        assert (
            found.kind in (Kind.EXISTS, Kind.CONFLICT, Kind.MISMATCH, Kind.UNSUITABLE, Kind.UNREADABLE),
            found.file,
        ) == (True, str(Path(out)))
    for out in ("take.wav", "nothing"):
        found = refusal(verb, *words, "--out", out)
        assert (found.kind, found.file) == (Kind.EXISTS, out)


@pytest.mark.parametrize(("verb", "mark"), [("train", "checkpoint.safetensors"), ("evaluate", "evaluation.json")])
def test_a_folder_of_its_own_is_refused_while_it_holds_what_is_read(
    refusal: Refused, place: Path, verb: str, mark: str
) -> None:
    Path("own").mkdir()
    Path("own", mark).write_text("", encoding="utf-8")
    shutil.copy("library.nc", "own/library.nc")
    words = FOLDERS[verb].replace("library.nc", "own/library.nc").split()
    found = refusal(verb, *words, "--out", "./own")
    assert (found.kind, found.field, found.file) == (Kind.CONFLICT, "out", "own")


def test_a_verb_comes_back_to_its_own_folder_and_to_no_other(refusal: Refused, place: Path) -> None:
    bend = ["bend", "--angles", "0", "--fidelity", "helmholtz", "--frequencies", "50:50:1", "--out", "bent"]
    for _ in range(2):
        result = CliRunner().invoke(app, bend)
        assert result.exit_code == 0, result.output
    for verb, words in FOLDERS.items():
        if verb != "bend":
            assert refusal(verb, *words.split(), "--out", "bent").file == "bent"


@pytest.mark.slow
@pytest.mark.parametrize("end", [signal.SIGKILL, signal.SIGTERM])
def test_parts_that_were_killed_are_made_by_the_next_call(place: Path, end: signal.Signals) -> None:
    words = [sys.executable, "-m", "studies.cli", "parts", "row.toml", "--out", "made", "--format", "stl"]
    killed = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while not Path("made", ".files.new").is_dir():
        assert killed.poll() is None
        time.sleep(0.02)
    killed.send_signal(end)
    assert killed.wait(PATIENCE) != 0
    again = subprocess.run(words, check=False, capture_output=True, encoding="utf-8", timeout=PATIENCE)
    assert again.returncode == 0, again.stderr
    made = {path.relative_to("made").as_posix() for path in Path("made").rglob("*") if path.is_file()}
    assert made == set(Path("made", "files.txt").read_text(encoding="utf-8").split())


def test_a_run_keeps_a_design_that_was_changed_by_hand_and_a_measured_library(
    refusal: Refused, place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from dataclasses import replace

    from acoustic_fem.library.transfer_functions import MEASURED

    def stopped(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("studies.run.pipeline._make_parts", stopped)
    words = ["run", "row.toml", "--out", "demo"]
    for _ in range(2):
        assert CliRunner().invoke(app, words).exit_code == 130
    design = Path("demo/design.toml")
    text = design.read_text(encoding="utf-8")
    design.write_text("# mine\n" + text, encoding="utf-8")
    for source in ("row.toml", "demo/design.toml"):
        assert refusal("run", source, "--out", "demo").file == "demo/design.toml"
    design.write_text(text, encoding="utf-8")
    library = acoustic_fem.solve(small_design(), [10.0, 20.0], fidelity="lumped")
    acoustic_fem.save(replace(library, fidelity=MEASURED), "demo/library.nc")
    assert refusal(*words).file == "demo/library.nc"
    assert (Path("demo") / MARK).is_file()

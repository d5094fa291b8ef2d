"""Every wrong input ends in one line, every wrong command line with code 2."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest
import scipy.io.wavfile
from command import Command
from shared import solved
from small_run import small_design, small_run

import acoustic_fem
import geometry
from geometry.design.design_file import prototype_text


@pytest.fixture(scope="module")
def places(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Good and bad files by name; what is refused changes none of them."""
    result, tmp_path = small_run(), tmp_path_factory.mktemp("places")
    files = {name: tmp_path / name for name in ("text.nc", "short.nc", "bad.toml", "wide.toml", "full", "missing")}
    files |= {"out.nc": tmp_path / "out.nc", "none/out.nc": tmp_path / "none" / "out.nc", "folder": tmp_path}
    files["library.nc"] = result.folder / "library.nc"
    files["localizer"] = result.folder / "localizer"
    files["pipe"] = tmp_path / "pipe"
    for suffix in (".toml", ".wav"):
        os.mkfifo(tmp_path / f"pipe{suffix}")
    for name in ("text.nc", "text.wav", "text.onnx"):
        files[name] = tmp_path / name
        files[name].write_text("neither sound nor numbers")
    files["short.nc"].write_bytes(files["library.nc"].read_bytes()[:3000])
    files["bad.toml"].write_text("name = [unclosed")
    text = prototype_text("array-2x6").replace("cavity_diameter = 6.0", "cavity_diameter = 99.0")
    files["wide.toml"].write_text(text)
    files["one.toml"] = tmp_path / "one.toml"
    geometry.save_design(small_design().with_values({"lines.0.points": 1}), files["one.toml"])
    files["full"].mkdir()
    (files["full"] / "thesis.txt").write_text("all my work")
    acoustic_fem.save(solved("glove", np.arange(1.0, 101.0)), tmp_path / "glove.nc")
    files["glove.nc"] = tmp_path / "glove.nc"
    acoustic_fem.save(acoustic_fem.solve(small_design(), [1.0, 50.0, 60.0, 80.0], "lumped"), tmp_path / "narrow.nc")
    files["narrow.nc"] = tmp_path / "narrow.nc"
    return files


#: Words of a command -> what its one line names: an option, a field or a file.
REFUSED = [
    ("check array-2x7", "array-2x7"),
    ("check <missing>.toml", "<missing>.toml"),
    ("check <pipe>.toml", "<pipe>.toml"),
    ("solve <pipe>.toml --out <out.nc>", "<pipe>.toml"),
    ("parts array-2x6 --out <out.nc> --process <pipe>.toml", "<pipe>.toml"),
    ("locate <library.nc> <pipe>.wav", "<pipe>.wav"),
    ("live <library.nc> --replay <pipe>.wav", "<pipe>.wav"),
    ("sweep <pipe>.toml --out <out.nc>", "<pipe>.toml"),
    ("optimize <pipe>.toml --out <out.nc>", "<pipe>.toml"),
    ("calibrate <pipe>.toml --out <out.nc>", "<pipe>.toml"),
    ("check /dev/zero", "/dev/zero"),
    ("check " + 4000 * "x" + ".toml", "xxx"),
    ("check a\u202eb.toml", "a\\u202eb.toml"),
    ("check <bad.toml>", "<bad.toml>"),
    ("check <wide.toml>", "resonator.cavity_diameter = 99 mm"),
    ("check array-2x6 --out <none/out.nc>", "<none/out.nc>"),
    ("prototypes array", "'array'"),
    ("solve array-2x6 --out <folder> --fidelity lumped", "<folder>"),
    ("solve array-2x6 --out <text.wav>", "<text.wav>"),
    ("solve array-2x6 --out <none/out.nc>", "<none/out.nc>"),
    ("solve array-2x6 --out <out.nc> --frequencies 0:100:64", "--frequencies = 0 Hz"),
    ("solve array-2x6 --out <out.nc> --frequencies 1:3000:64", "--frequencies"),
    ("solve array-2x6 --out <out.nc> --frequencies 100:1:64", "--frequencies"),
    ("solve array-2x6 --out <out.nc> --frequencies 1-100", "--frequencies = '1-100'"),
    ("solve array-2x6 --out <out.nc> --frequencies 1:100:0", "--frequencies = '1:100:0'"),
    ("solve array-2x6 --out <out.nc> --pressure 1e4", "--pressure = 10000 Pa"),
    ("solve array-2x6 --out <out.nc> --pressure 9e4 --altitude 100", "--altitude"),
    ("tolerance array-2x6 --out <out.nc> --base -1", "--base = -1"),
    ("tolerance array-2x6 --out <out.nc> --library -1", "--library = -1"),
    ("tolerance array-2x6 --out <out.nc> --noise 0", "--noise = 0 Pa"),
    ("tolerance array-2x6 --out <out.nc> --seed -1", "--seed = -1"),
    ("parts array-2x6 --out <text.nc>", "<text.nc>"),
    ("train <missing> --out <out.nc>", "<missing>"),
    ("train <text.nc> --out <out.nc>", "<text.nc>"),
    ("train <short.nc> --out <out.nc>", "<short.nc>"),
    ("train <narrow.nc> --out <out.nc>", "frequency"),
    ("train <library.nc> --out <out.nc> --seconds -1", "--seconds = -1"),
    ("train <library.nc> --out <out.nc> --epochs 0", "--epochs = 0"),
    ("train <library.nc> --out <out.nc> --noise -1", "--noise = -1"),
    ("train <library.nc> --out <out.nc> --seed -1", "--seed = -1"),
    ("train <library.nc> --out <out.nc> --network big", "--network = 'big'"),
    ("evaluate <missing> <library.nc>", "<missing>"),
    ("evaluate <localizer> <glove.nc>", "microphones"),
    ("evaluate <localizer> <library.nc> --touches 0", "--touches = 0"),
    ("evaluate <localizer> <library.nc> --noise -1", "--noise = -1"),
    ("evaluate <localizer> <library.nc> --noise 11", "--noise = 11"),
    ("onnx <missing> --out <out.nc>", "<missing>"),
    ("onnx <localizer> --out <none/out.nc>", "<none/out.nc>"),
    ("onnx <localizer> --out <out.nc> --noise 1e-3", "--noise = 0.001"),
    ("onnx <library.nc> --out <out.nc> --noise 11", "--noise = 11"),
    ("locate <missing> <text.wav>", "<missing>"),
    ("locate <localizer> <text.wav>", "<text.wav>"),
    ("locate <localizer> <text.nc>", "<text.nc>"),
    ("locate <localizer> <text.wav> --full-scale 0", "--full-scale = 0"),
    ("locate <localizer> <text.wav> --noise 1e-3", "--noise = 0.001"),
    ("locate <localizer> <text.wav> --library <glove.nc>", "microphones"),
    ("locate <localizer> <text.wav> --ambient 60", "--ambient"),
    ("locate <library.nc> <text.wav> --reject 2", "--reject = 2"),
    ("onnx <localizer> --out <out.nc> --ambient 60", "--ambient = 60"),
    ("locate <text.onnx> <text.wav>", "<text.onnx>"),
    ("run <one.toml> --out <out.nc>", "<one.toml>: lines.0.points = 1"),
    ("run array-2x6 --out <full>", "<full>"),
    ("run array-2x6 --out <text.nc>", "<text.nc>"),
    # Files that are called as options are.
    *((f"locate <library.nc> {name}.wav", f"acoustic-fem: {name}.wav: ") for name in ("pressure", "refused", "speed")),
    *((f"locate {name}.csv <text.wav>", f"acoustic-fem: {name}.csv: ") for name in ("altitude", "ambient")),
    ("recognize <localizer> <library.nc> speed.wav", "acoustic-fem: speed.wav: "),
]


@pytest.mark.parametrize(("words", "named"), REFUSED)
def test_bad_input_ends_in_one_line(command: Command, places: dict[str, Path], words: str, named: str) -> None:
    for name, path in places.items():
        words, named = (text.replace(f"<{name}>", str(path)) for text in (words, named))
    told = command(*words.split())
    assert named in told.refusal()
    assert not [line for line in told.err.splitlines() if line.startswith(("Evaluation", "Localizer", "Parts"))]
    assert not places["out.nc"].exists()


@pytest.mark.parametrize(
    "words",
    [
        "solved array-2x6",
        "solve array-2x6",
        "solve array-2x6 --out x.nc --fidelity exact",
        "parts array-2x6 --out x --format obj",
        "train library.nc --out x --seconds soon",
        "check",
        "prototypes --out x.toml",
        "run --out x",
        "evaluate localizer",
    ],
)
def test_a_wrong_command_line_ends_with_code_2(
    command: Command, words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    command(*words.split()).refusal(code=2)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ("locate l.nc r.wav --ambient 500", "--ambient = 500 must be between 0 and 140"),
        ("locate l.nc r.wav --ambient x", "--ambient = 'x' must be a number between 0 and 140"),
        ("locate l.nc r.wav --noise x", "--noise = 'x' must be a number or design"),
        ("rig array-2x6 --out x --seed 1.5", "--seed = 1.5 must be a whole number at least 0"),
        ("rig array-2x6 --out x --seed -1", "--seed = -1 must be at least 0"),
        (
            "solve array-2x6 --out x.nc --fidelity exact",
            "--fidelity = 'exact' must be one of: lumped, atlas, helmholtz, navier-stokes",
        ),
    ],
)
def test_an_option_that_is_not_accepted_is_named_with_what_is(command: Command, words: str, sentence: str) -> None:
    assert command(*words.split()).refusal(code=2).startswith(f"acoustic-fem: {sentence}; try ")


def test_a_file_that_stands_where_the_result_would_go_names_the_option(
    command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "out").write_text("")
    (tmp_path / "mine.toml").write_text("")
    assert (
        command("new", "mine")
        .refusal()
        .startswith("acoustic-fem: mine.toml: exists, and a design is never overwritten; name another file with --out")
    )
    assert command("new", "other", "--out", "out").refusal().startswith("acoustic-fem: out: --out exists")


def test_names_that_break_or_turn_a_line_are_shown_escaped(command: Command, places: dict[str, Path]) -> None:
    folder = places["folder"] / "a\nb\u202ec\udcff"
    folder.mkdir(exist_ok=True)
    scipy.io.wavfile.write(folder / "r.wav", 1000, np.random.default_rng(0).uniform(-1, 1, (500, 2)).astype(np.float32))
    told = command("locate", places["library.nc"], folder / "r.wav")
    assert (told.code, "a\\nb\\u202ec\\udcff/r.wav: " in told.out) == (0, True), told
    assert "a\\nb\\u202ec\\udcff/none.wav: " in command("locate", places["library.nc"], folder / "none.wav").refusal()


def test_an_argument_longer_than_any_path_is_refused_in_one_line(command: Command) -> None:
    for words in (("check", "x" * 5000), ("solve", "array-2x6", "--fidelity", "x" * 5000)):
        assert "5000" in command(*words).refusal(code=2)


def test_out_and_record_of_live_are_two_files(command: Command, tmp_path: Path) -> None:
    folder, played = small_run().folder, tmp_path / "played.wav"
    scipy.io.wavfile.write(played, 1000, np.random.default_rng(0).standard_normal((2000, 2)).astype(np.float32))
    both = tmp_path / "both.wav"
    told = command("live", folder / "library.nc", "--replay", played, "--out", both, "--record", both)
    assert ("record" in told.refusal(), both.exists()) == (True, False)

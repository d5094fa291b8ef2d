"""The command line: every verb does its job, and every wrong input ends in one line."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.io.wavfile
import trimesh
from filelock import FileLock
from shared import shared_folder, solved
from small_run import small_design, small_run

import acoustic_fem
import geometry
import localize
from acoustic_fem.numerics.processors import cores
from geometry.design.design_file import prototype_text
from localize.signals.array_response import response_of
from localize.signals.finger_stimuli import STIMULI
from studies.cli import app

ROOT = Path(__file__).parents[3]
VERBS = ("prototypes", "check", "solve", "parts", "train", "evaluate", "onnx", "locate", "live", "run")


@dataclass(frozen=True)
class Outcome:
    """How a command ended."""

    code: int
    out: str
    err: str


Command = Callable[..., Outcome]


@pytest.fixture
def command(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Command:
    """Runs ``acoustic-fem`` with arguments, in this process."""

    def run(*arguments: object) -> Outcome:
        monkeypatch.setattr(sys, "argv", ["acoustic-fem", *map(str, arguments)])
        monkeypatch.setenv("COLUMNS", "200")  # what is told here, not how it is laid out
        capsys.readouterr()
        with pytest.raises(SystemExit) as ended:
            app.main()
        told = capsys.readouterr()
        return Outcome(int(ended.value.code or 0), told.out, told.err)

    return run


@pytest.fixture
def row(tmp_path: Path) -> Path:
    """A design file of three points in one row."""
    path = tmp_path / "row-3.toml"
    geometry.save_design(small_design(), path)
    return path


# -- help -------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("verb", VERBS)
def test_the_help_of_every_verb_has_an_example_and_out(command: Command, verb: str) -> None:
    told = command(verb, "--help")
    assert told.code == 0
    assert f"acoustic-fem {verb}" in told.out.partition("Example:")[2]
    assert "--out" in told.out


def test_the_help_lists_every_verb_in_the_order_of_work(command: Command) -> None:
    told = command("--help")
    assert [told.out.index(f"│ {verb} ") for verb in VERBS] == sorted(told.out.index(f"│ {verb} ") for verb in VERBS)
    assert command("--version").out.startswith("acoustic-fem")


def test_help_of_a_search_names_its_section(command: Command) -> None:
    assert "A study file with a section [optimize]." in command("optimize", "--help").out


def test_help_loads_nothing_heavy() -> None:
    code = (
        "import sys\n"
        "from studies.cli.app import app\n"
        "try:\n    app(['--help'])\nexcept SystemExit:\n    pass\n"
        "heavy = {'OCP', 'cadquery', 'gmsh', 'matplotlib', 'numpy', 'pyvista', 'scipy', 'skfem', 'torch', 'xarray'}\n"
        "print(sorted(heavy & set(sys.modules)), file=sys.stderr)"
    )
    told = subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=True, capture_output=True, encoding="utf-8")
    assert told.stderr.strip() == "[]"
    assert "Usage" in told.stdout


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is full")
def test_a_full_disk_is_told_in_one_line(command: Command, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def full(*_: object, **__: object) -> None:
        with open("/dev/full", "w") as file:
            file.write("x" * 10_000)

    monkeypatch.setattr("geometry.files.writing.os.replace", full)
    told = command("prototypes", "glove", "--out", tmp_path / "mine.toml")
    assert told.code == 1
    assert "No space left on device" in told.err.splitlines()[-1]
    assert "Traceback" not in told.err


def test_out_and_record_of_live_are_two_files(command: Command, tmp_path: Path) -> None:
    folder, played = small_run().folder, tmp_path / "played.wav"
    scipy.io.wavfile.write(played, 1000, np.random.default_rng(0).standard_normal((2000, 2)).astype(np.float32))
    both = tmp_path / "both.wav"
    told = command("live", folder / "library.nc", "--replay", played, "--out", both, "--record", both)
    assert (told.code, "out and record must be two files" in told.err, both.exists()) == (1, True, False)


def test_the_fidelities_of_the_command_are_those_of_the_library(command: Command, tmp_path: Path) -> None:
    told = command("solve", "array-2x6", "--out", str(tmp_path / "library.nc"), "--fidelity", "exact")
    assert told.code == 2
    offered = " ".join(told.err.replace("│", " ").split())
    assert ", ".join(map(repr, acoustic_fem.FIDELITIES)) in offered


# -- verbs ------------------------------------------------------------------------------------------------
def test_prototypes_are_listed_and_printed(command: Command, tmp_path: Path) -> None:
    told = command("prototypes")
    assert told.code == 0
    for name in geometry.prototype_names():
        design = geometry.prototype(name)
        line = next(line for line in told.out.splitlines() if line.split()[:1] == [name])
        assert line.split()[1:3] == [str(len(design.microphones)), str(design.point_count)]
    assert command("prototypes", "glove").out == prototype_text("glove")
    own = tmp_path / "mine.toml"
    assert command("prototypes", "glove", "--out", own).code == 0
    assert geometry.load_design(own) == geometry.prototype("glove")
    assert "exists" in command("prototypes", "glove", "--out", own).err


@pytest.mark.parametrize("name", geometry.prototype_names())
def test_a_prototype_passes_the_check(command: Command, name: str, tmp_path: Path) -> None:
    told = command("check", name, "--out", tmp_path / "check.json")
    assert told.code == 0, told.err
    design = geometry.prototype(name)
    found = json.loads((tmp_path / "check.json").read_text(encoding="utf-8"))
    assert found["wiring"]["points"] == design.point_count
    assert found["printing"]["verdict"] in ("ok", "warn")
    assert found["misfits"] == []  # no two placed parts are in each other's way, every tube fits its ports
    assert sum(cell["places"] for cell in found["cells"]) == design.point_count + len(design.microphones)
    levels = [entry["second_microphone_db"] for entry in found["attenuation"]]
    assert 0 > levels[0] > levels[1] > levels[2]
    for words in ("a valid design", "distinct cell", "estimated attenuation", "the models assume", "printing,"):
        assert words in told.out
    # What each fidelity costs, and how far off it is.
    assert "lumped: milliseconds; from navier-stokes, 1 to 100 Hz, it was at most 0.3 % and 0.2 degrees on" in told.out
    assert "1.1 % and 0.44 degrees on large-area-64" in told.out
    count = len(found["cells"])
    costs = f"about 13 s of one processor per distinct cell, here {count}: {13 * count} s; then from the cache"
    assert f"navier-stokes, the default: {costs}" in told.out


def test_the_check_of_a_design_that_cannot_be_printed_names_the_part(command: Command, tmp_path: Path) -> None:
    thin = small_design().with_values({"printing.port_lip": 0.15, "printing.process": "sla-resin"})
    geometry.save_design(thin, tmp_path / "thin.toml")
    told = command("check", tmp_path / "thin.toml")
    assert told.code == 1
    last = told.err.splitlines()[-1]
    assert last.startswith("acoustic-fem: row-3: cannot be printed: shell-straight: thinnest wall 0.15 mm must be at")


def test_the_fields_of_a_design_file_are_listed(command: Command) -> None:
    told = command("check", "--fields")
    assert told.code == 0
    for name in ("resonator.cavity_diameter", "lines.*.points", "air.humidity", "printing.process"):
        assert name in told.out


def test_parts_fill_a_folder_with_all_it_takes_to_make_the_array(command: Command, row: Path, tmp_path: Path) -> None:
    told = command("parts", row, "--out", tmp_path / "parts", "--format", "stl", "--process", "dlp-fine")
    assert told.code == 0, told.err
    written = {path.name: path for path in (tmp_path / "parts").iterdir()}
    made = ["shell-straight", "membrane", "mold-base", "mold-lid", "microphone-housing"]
    for name in made:
        assert trimesh.load_mesh(written[f"{name}.stl"]).is_volume
        assert f"{name}.stl" in told.out
        for doing in ("facets of", "files of", "print rules of"):
            assert f"Parts: {doing} {name}" in told.err
    assert not [name for name in written if name.startswith(".") or name == "membrane.step"]
    report = json.loads(written["print-report.json"].read_text(encoding="utf-8"))
    assert report["process"]["name"] == "dlp-fine"
    assert {file["name"] for file in report["files"]} == {name for name in written if name.endswith(".stl")}
    assert report["acoustic_effects"]
    plate = trimesh.load(written["plate-1.3mf"])
    assert "shell-straight" in plate.geometry
    assert written["assembly.step"].read_text().startswith("ISO-10303-21")
    assert json.loads(written["bill.json"].read_text(encoding="utf-8"))["items"]
    for name in ("array.glb", "array.html", "bill.csv", "bill.txt", "print-report.html", "top-view.png",
                 "exploded-view.png", "mold-section.png"):  # fmt: skip
        assert written[name].stat().st_size > 500
    assert "to microphones of line 1" in told.out
    assert "which tube between: assembly.txt" in told.out
    assert "point 3       shell-straight" in written["assembly.txt"].read_text(encoding="utf-8")
    assert set(written["files.txt"].read_text(encoding="utf-8").split()) == set(written)
    assert "resin" in told.out


def test_a_folder_of_parts_never_mixes_two_designs_and_keeps_what_others_put_there(
    command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from studies.output.folders import replaced_files

    folder = tmp_path / "parts"

    def make(*names: str) -> None:
        with replaced_files(folder) as fresh:
            for name in names:
                (fresh / name).write_text(f"{name} of {names}")

    def names() -> set[str]:
        return {path.name for path in folder.iterdir()}

    make("mold-lid.stl", "plate-1.3mf", "plate-2.3mf")
    (folder / "notes.md").write_text("mine")
    make("mold-scraper.stl", "plate-1.3mf")
    assert names() == {"mold-scraper.stl", "plate-1.3mf", "notes.md", "files.txt"}
    assert "scraper" in (folder / "plate-1.3mf").read_text()
    assert (folder / "notes.md").read_text() == "mine"

    # What fails changes nothing; what is stopped while files move leaves none that the next call would not remove.
    with pytest.raises(FileNotFoundError):
        make("mold-lid.stl", "no-such-folder/plate-1.3mf")
    assert names() == {"mold-scraper.stl", "plate-1.3mf", "notes.md", "files.txt"}
    moved = os.replace

    def stopped(source: Path, target: Path) -> None:
        if Path(target).name.startswith("plate"):
            raise KeyboardInterrupt
        moved(source, target)

    monkeypatch.setattr("studies.output.folders.os.replace", stopped)
    with pytest.raises(KeyboardInterrupt):
        make("mold-lid.stl", "plate-1.3mf", "plate-9.3mf")
    monkeypatch.undo()
    make("membrane.stl")
    assert names() == {"membrane.stl", "notes.md", "files.txt"}

    (folder / "files.txt").write_text("membrane.stl\n../precious\n")
    (tmp_path / "precious").write_text("mine")
    told = command("parts", "array-2x6", "--out", folder)
    assert (told.code, "'../precious' must be the name of a file in" in told.err) == (1, True)
    assert (tmp_path / "precious").read_text() == "mine"


def test_parts_for_an_unknown_process_are_refused(command: Command, row: Path, tmp_path: Path) -> None:
    told = command("parts", row, "--out", tmp_path / "parts", "--process", "sls")
    assert (told.code, not (tmp_path / "parts").exists()) == (1, True)
    assert "process = 'sls' must be one of: sla-resin, dlp-fine, fdm, mjf; or a .toml file" in told.err


def test_solve_train_and_evaluate_lead_from_a_design_to_a_judged_localizer(
    command: Command, row: Path, tmp_path: Path
) -> None:
    library, model, verdict = tmp_path / "library.nc", tmp_path / "localizer", tmp_path / "verdict"
    told = command("solve", row, "--out", library, "--fidelity", "lumped", "--frequencies", "1:100:100")
    assert (told.code, "3 points, 2 microphones, 100 frequencies" in told.out) == (0, True)
    loaded = acoustic_fem.load(library)
    assert np.array_equal(loaded.frequency, np.arange(1.0, 101.0))
    assert loaded.design == small_design()

    told = command("train", library, "--out", model, "--epochs", 3, "--seed", 5)
    assert told.code == 0, told.err
    assert json.loads((model / "localizer.json").read_text(encoding="utf-8"))["plan"]["seed"] == 5
    curves = (model / "training.csv").read_text(encoding="utf-8").splitlines()
    assert (curves[0], len(curves)) == ("epoch,loss,held_out_accuracy", 4)
    confusion = np.genfromtxt(model / "confusion.csv", delimiter=",", skip_header=1, dtype=int)
    assert confusion[:, 1:].sum(1).tolist() == [50, 50, 50]
    weights = next(model.glob("weights-*.safetensors")).name
    assert {path.name for path in model.iterdir()} == {
        "localizer.json", weights, "training.csv", "training.png", "confusion.csv", "confusion.png"
    }  # fmt: skip

    told = command("evaluate", model, library, "--touches", 50, "--out", verdict)
    assert told.code == 0, told.err
    found = json.loads((verdict / "evaluation.json").read_text(encoding="utf-8"))
    assert found["Bayes decoder"]["top1"] > 0.99
    assert found["network"]["top1"] > 0.5  # three short epochs; chance is 0.33
    assert np.sum(found["network"]["confusion"]) == 150
    assert f"{100 * found['network']['top1']:.1f}" in told.out
    assert told.out.endswith(f"{verdict / 'evaluation.html'}\n{verdict / 'evaluation.json'}\n")


@pytest.mark.slow
def test_a_network_is_trained_on_the_stimuli_that_are_named(command: Command, tmp_path: Path) -> None:
    library, model = small_run().folder / "library.nc", tmp_path / "localizer"
    words = ("--epochs", 2, "--stimuli", "taps", "--stimuli", "friction")
    told = command("train", library, "--out", model, *words)
    assert told.code == 0, told.err
    plan = json.loads((model / "localizer.json").read_text(encoding="utf-8"))["plan"]
    assert plan["stimuli"] == ["taps", "friction"]
    trained, array = localize.load_localizer(model), acoustic_fem.load(library)
    # Two short epochs; chance is 0.33.
    assert localize.evaluate(trained, array, 50, "design", stimuli=STIMULI["friction"]).top1 > 0.5
    told = command("train", library, "--out", tmp_path / "none", "--stimuli", "knocks")
    assert (told.code, "--stimuli" in told.err, (tmp_path / "none").exists()) == (1, True, False)


def test_train_goes_on_where_it_was_stopped(command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    library = small_run().folder / "library.nc"
    whole, stopped = tmp_path / "whole", tmp_path / "stopped"
    words = ("--epochs", 3, "--seed", 5)
    assert command("train", library, "--out", whole, *words).code == 0
    train = localize.train

    def interrupted(*arguments: Any, **named: Any) -> None:
        def at_the_second(progress: localize.TrainingProgress) -> None:
            if progress.epoch == 2:
                raise KeyboardInterrupt

        train(arguments[0], arguments[1], at_the_second, **named)

    with monkeypatch.context() as patch:
        patch.setattr(localize, "train", interrupted, raising=False)
        assert command("train", library, "--out", stopped, *words).code != 0
    assert [path.name for path in stopped.iterdir()] == ["checkpoint.safetensors"]
    told = command("train", library, "--out", stopped, "--epochs", 4, "--seed", 5)
    assert (told.code, "plan.epochs was 3, is 4; remove it to train anew" in told.err) == (1, True)
    assert command("train", library, "--out", stopped, *words).code == 0
    told = command("train", library, "--out", whole, *words)
    assert (told.code, "holds a finished localizer; remove it" in told.err) == (1, True)
    # The name of the weights is their checksum.
    assert [path.name for path in whole.glob("weights-*")] == [path.name for path in stopped.glob("weights-*")]


def assert_exported(told: Outcome) -> None:
    assert (told.code, "3 points, 2 microphones" in told.out) == (0, True), told.err
    assert [line for line in told.err.splitlines() if not line.startswith("note: entrance loss")] == []


def decoder_graph(command: Command) -> Path:
    """The decoder of the small run's library in a room with sound, made by the first who asks."""
    graph = shared_folder() / "row-3-decoder.onnx"
    with FileLock(graph.with_suffix(".lock")):
        if not graph.exists():
            words = ("--noise", 1e-3, "--ambient", 70)
            assert_exported(command("onnx", small_run().folder / "library.nc", "--out", graph, *words))
    return graph


def test_a_recording_is_located_by_the_network_an_onnx_file_and_the_library_alike(
    command: Command, tmp_path: Path
) -> None:
    folder = small_run().folder
    library = acoustic_fem.load(folder / "library.nc")
    touches = localize.TouchGenerator(response_of(library), 0, "evaluation").samples(0, 60)
    loud = [
        max((k for k in range(60) if touches.point[k] == point), key=lambda k: float(touches.signals[k].std()))
        for point in (2, 0)
    ]
    samples = 2e-4 * np.random.default_rng(0).standard_normal((2, 5000))
    for turn, sample in enumerate(loud):
        samples[:, 500 + 2000 * turn : 1500 + 2000 * turn] += touches.signals[sample].numpy()
    recording = tmp_path / "recording.wav"
    scipy.io.wavfile.write(recording, 1000, samples.T.astype(np.float32))

    network, decoder = tmp_path / "network.onnx", decoder_graph(command)
    assert_exported(command("onnx", folder / "localizer", "--out", network))
    for model in (folder / "localizer", folder / "library.nc", network, decoder):
        told = command("locate", model, recording)
        assert told.code == 0, told.err
        assert "2 touches in 5.0 s" in told.out
        rows = [line.split() for line in told.out.splitlines() if re.match(r" *\d", line)]
        assert [row[2] for row in rows] == ["3", "1"]

    lines = tmp_path / "touches.jsonl"
    words = ("--out", lines, "--waveform", "--library", folder / "library.nc")
    assert command("locate", decoder, recording, *words).code == 0
    events = [json.loads(line) for line in lines.read_text(encoding="utf-8").splitlines()]
    assert {event["state"] for event in events} == {"touch", "no touch"}
    assert {len(event["waveform"]) for event in events if event["state"] == "touch" and event["time"] > 0.3} == {16}


def test_sound_in_a_recording_and_what_no_point_explains_are_no_touches(command: Command, tmp_path: Path) -> None:
    folder = small_run().folder
    library = response_of(acoustic_fem.load(folder / "library.nc"))
    touches = localize.TouchGenerator(library, 0, "evaluation", 1e-3, ambient=(70.0, 70.0)).samples(0, 3)
    quiet = localize.TouchGenerator(library, 0, "evaluation", 0.0).samples(0, 3)
    sound = (touches.signals - quiet.signals).numpy()
    two = quiet.signals[0].numpy() + quiet.signals[2].numpy() + 1e-3 * np.random.default_rng(0).standard_normal((2, 1))
    for name, signals in (("sound", sound[0]), ("two", two)):
        scipy.io.wavfile.write(tmp_path / f"{name}.wav", 1000, signals.T.astype(np.float32))
    network, graph = folder / "localizer", decoder_graph(command)

    words = ("--library", folder / "library.nc", "--ambient", 80)
    for model in (folder / "library.nc", network, graph):
        assert " 0 touches" not in command("locate", model, tmp_path / "sound.wav").out
        told = command("locate", model, tmp_path / "sound.wav", *words)
        assert (told.code, "0 touches in 1.0 s, sound alone for 0.8 s" in told.out) == (0, True), told
    told = command("locate", folder / "library.nc", tmp_path / "two.wav", "--refuse", 1e-6)
    assert (told.code, "0 touches in 1.0 s, no single touch for 0.8 s" in told.out) == (0, True), told


def test_run_takes_a_design_and_a_folder_and_nothing_else(command: Command, tmp_path: Path) -> None:
    assert command("run", "array-2x6", "--out", tmp_path, "--fidelity", "lumped").code == 2
    told = command("run", "--help")
    options = [word for word in told.out.split() if word.startswith("--")]
    assert set(options) == {"--out", "--allow-overlaps", "--help"}


def test_one_point_is_enough_for_solve_and_parts(command: Command, tmp_path: Path) -> None:
    geometry.save_design(small_design().with_values({"lines.0.points": 1}), tmp_path / "one.toml")
    told = command("solve", tmp_path / "one.toml", "--out", tmp_path / "one.nc", "--fidelity", "lumped")
    assert (told.code, "1 point," in told.out) == (0, True)
    parts = geometry.build_parts(geometry.load_design(tmp_path / "one.toml"))
    assert parts.counts["shell-straight"] == parts.counts["membrane"] == 1


def test_train_has_the_defaults_of_the_plan_and_the_noise_of_the_design(
    command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plans, library = [], small_run().folder / "library.nc"

    def seen(
        library: object, plan: localize.TrainingPlan, progress: object, checkpoint: Path, recordings: Path | None
    ) -> None:
        assert recordings is None
        plans.append(plan)
        raise KeyboardInterrupt

    monkeypatch.setattr(localize, "train", seen, raising=False)
    command("train", library, "--out", tmp_path / "localizer")
    assert plans == [localize.TrainingPlan(microphone_noise="design")]


def test_evaluate_takes_the_noise_of_the_design_unless_told(
    command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("studies.judging.report.render", lambda found: "")  # the numbers are what matters here
    folder, verdict = small_run().folder, tmp_path / "verdict"
    used = []
    for words in ((), ("--noise", "1e-3"), ("--noise", "0")):
        told = command(
            "evaluate", folder / "localizer", folder / "library.nc", "--touches", 5, "--out", verdict, *words
        )
        assert told.code == 0, told.err
        found = json.loads((verdict / "evaluation.json").read_text(encoding="utf-8"))
        names = ("network", "Bayes decoder")
        used.append([(found[name]["microphone_noise"], found[name]["noise_source"]) for name in names])
    rms, source = small_run().network.microphone_noise, small_run().network.noise_source
    assert source.startswith("microphone SPH1878LR5H-C: ")
    assert used == [[(rms, source)] * 2, [(1e-3, "white")] * 2, [(0.0, "white")] * 2]


# -- bad input ----------------------------------------------------------------------------------------------
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


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        ("check array-2x7", "neither a design file nor a prototype; did you mean 'array-2x6'?"),
        ("check <missing>.toml", "no such file"),
        ("check <pipe>.toml", "pipe.toml: is a pipe, not a design file"),
        ("solve <pipe>.toml --out <out.nc>", "pipe.toml: is a pipe, not a design file"),
        ("parts array-2x6 --out <out.nc> --process <pipe>.toml", "pipe.toml: is a pipe, not a file of a process"),
        ("locate <library.nc> <pipe>.wav", "pipe.wav: is a pipe, not a"),
        ("live <library.nc> --replay <pipe>.wav", "pipe.wav: is a pipe, not a WAV file"),
        ("sweep <pipe>.toml --out <out.nc>", "pipe.toml: is a pipe, not a study file"),
        ("optimize <pipe>.toml --out <out.nc>", "pipe.toml: is a pipe, not a study file"),
        ("calibrate <pipe>.toml --out <out.nc>", "pipe.toml: is a pipe, not a manifest"),
        ("check /dev/zero", "/dev/zero: is a device, not a design file"),
        ("check " + 4000 * "x" + ".toml", "cannot be read: File name too long"),
        ("check a\u202eb.toml", "a\\u202eb.toml: no such file"),
        ("check <bad.toml>", "is not TOML"),
        ("check <wide.toml>", "resonator.cavity_diameter = 99 mm must be between 0.8 and 50 mm"),
        ("check array-2x6 --out <none/out.nc>", "must lie in a folder that exists"),
        ("prototypes array", "no prototype is named 'array'"),
        ("solve array-2x6 --out <folder> --fidelity lumped", "is a folder; --out must be a file"),
        ("solve array-2x6 --out <text.wav>", "text.wav: --out must be a library, .nc"),
        ("solve array-2x6 --out <none/out.nc>", "must lie in a folder that exists"),
        ("solve array-2x6 --out <out.nc> --frequencies 0:100:64", "--frequencies = 0 Hz must be between 0.001 and"),
        ("solve array-2x6 --out <out.nc> --frequencies 1:3000:64", "must be between 0.001 and 2000 Hz"),
        ("solve array-2x6 --out <out.nc> --frequencies 100:1:64", "--frequencies must ascend"),
        ("parts array-2x6 --out <text.nc>", "must be a folder"),
        ("train <missing> --out <out.nc>", "no such file"),
        ("train <text.nc> --out <out.nc>", "cut short, damaged or not a library in netCDF"),
        ("train <short.nc> --out <out.nc>", "cut short, damaged or not a library in netCDF"),
        ("train <narrow.nc> --out <out.nc>", "frequency runs from 1 to 80 Hz; it must cover 1 to 100 Hz"),
        ("train <library.nc> --out <out.nc> --seconds -1", "acoustic-fem: --seconds = -1.0 must be between"),
        ("train <library.nc> --out <out.nc> --epochs 0", "acoustic-fem: --epochs = 0 must be a whole number from 1"),
        ("train <library.nc> --out <out.nc> --noise -1", "acoustic-fem: --noise = -1.0 must be between"),
        ("train <library.nc> --out <out.nc> --seed -1", "acoustic-fem: --seed = -1 must be a whole number"),
        ("train <library.nc> --out <out.nc> --network big", "acoustic-fem: --network = 'big' must be one of: patches"),
        ("evaluate <missing> <library.nc>", "localizer.json: no such file"),
        ("evaluate <localizer> <glove.nc>", "the localizer is for 3 points and microphones A, B; the library has 15"),
        ("evaluate <localizer> <library.nc> --touches 0", "--touches = 0 must be between 1 and 1,000,000"),
        ("evaluate <localizer> <library.nc> --noise -1", "acoustic-fem: --noise = -1.0 must be"),
        ("evaluate <localizer> <library.nc> --noise 11", "acoustic-fem: --noise = 11.0 Pa must be between 1e-9 and 10"),
        ("onnx <missing> --out <out.nc>", "localizer.json: no such file"),
        ("onnx <localizer> --out <none/out.nc>", "must lie in a folder that exists"),
        ("onnx <localizer> --out <out.nc> --noise 1e-3", "--noise = 0.001 is for a library"),
        ("onnx <library.nc> --out <out.nc> --noise 11", "--noise = 11.0 Pa must be between 1e-9 and 10 Pa"),
        ("locate <missing> <text.wav>", "localizer.json: no such file"),
        ("locate <localizer> <text.wav>", "text.wav: cut short or not a WAV file"),
        ("locate <localizer> <text.nc>", "its name must end with .wav, .csv, .npz or .mat"),
        ("locate <localizer> <text.wav> --full-scale 0", "--full-scale = 0.0 Pa must be between 1e-12 and 1e+12"),
        ("locate <localizer> <text.wav> --noise 1e-3", "--noise = 0.001 is for a library"),
        ("locate <localizer> <text.wav> --library <library.nc>", "is for --waveform, --ambient and --refuse"),
        ("locate <localizer> <text.wav> --ambient 60", "--ambient needs the library of the array"),
        ("locate <library.nc> <text.wav> --refuse 2", "acoustic-fem: --refuse = 2.0 must be between 0 and 1"),
        (
            "locate <localizer> <text.wav> --library <glove.nc> --ambient 60",
            "its microphones are A, B, C, must be A, B",
        ),
        ("onnx <localizer> --out <out.nc> --ambient 60", "--ambient = 60 is for a library"),
        ("locate <text.onnx> <text.wav>", "text.onnx: cut short or not an ONNX file"),
        (
            "run <one.toml> --out <out.nc>",
            "one.toml: lines.0.points = 1 must be at least 2: run needs at least 2 points",
        ),
        ("run array-2x6 --out <full>", "holds files that no run of this program made"),
        ("run array-2x6 --out <text.nc>", "must be a folder"),
    ],
)
def test_bad_input_ends_in_one_line(command: Command, places: dict[str, Path], words: str, reason: str) -> None:
    for name, path in places.items():
        words = words.replace(f"<{name}>", str(path))
    told = command(*words.split())
    assert told.code == 1, told.err
    lines = [line for line in told.err.splitlines() if line.startswith("acoustic-fem: ")]
    assert len(lines) == 1
    assert told.err.splitlines()[-1] == lines[0]
    assert reason in lines[0]
    assert "Traceback" not in told.err
    assert len(lines[0]) < 2100
    assert not [line for line in told.err.splitlines() if line.startswith(("Evaluation:", "Localizer:", "Parts:"))]
    assert not places["out.nc"].exists()


@pytest.mark.parametrize(
    "words",
    [
        "solved array-2x6",
        "solve array-2x6",
        "solve array-2x6 --out x.nc --frequencies 1-100",
        "solve array-2x6 --out x.nc --frequencies 1:100",
        "solve array-2x6 --out x.nc --frequencies 1:100:0",
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
    told = command(*words.split())
    assert told.code == 2
    assert told.err
    assert "Traceback" not in told.err
    assert not list(tmp_path.iterdir())


def test_names_that_break_or_turn_a_line_are_shown_escaped(command: Command, places: dict[str, Path]) -> None:
    folder = places["folder"] / "a\nb\u202ec\udcff"
    folder.mkdir(exist_ok=True)
    scipy.io.wavfile.write(folder / "r.wav", 1000, np.random.default_rng(0).uniform(-1, 1, (500, 2)).astype(np.float32))
    told = command("locate", places["library.nc"], folder / "r.wav")
    assert (told.code, "a\\nb\\u202ec\\udcff/r.wav: " in told.out) == (0, True), told
    told = command("locate", places["library.nc"], folder / "none.wav")
    assert told.code == 1
    assert told.err.splitlines()[-1].endswith("a\\nb\\u202ec\\udcff/none.wav: no such file")


def test_an_argument_longer_than_any_path_is_refused_in_one_line(command: Command) -> None:
    for words in (("check", "x" * 5000), ("solve", "array-2x6", "--fidelity", "x" * 5000)):
        told = command(*words)
        assert (told.code, told.err.count("\n")) == (2, 1)
        assert "an argument of 5000 characters must have at most 4096" in told.err


def test_a_mistake_of_the_program_keeps_its_traceback(monkeypatch: pytest.MonkeyPatch) -> None:
    mistakes: list[Callable[[str], object]] = [
        lambda _: np.zeros(3) + np.zeros(4),
        lambda _: int("twelve"),
        lambda _: {}["name"],
        lambda _: np.linalg.inv(np.zeros((2, 3))),
    ]
    monkeypatch.setattr(sys, "argv", ["acoustic-fem", "check", "array-2x6"])
    for mistake in mistakes:
        monkeypatch.setattr(geometry, "resolve_design", mistake, raising=False)
        with pytest.raises((ValueError, KeyError)):
            app.main()


def test_a_file_that_fails_is_named(command: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(_: str) -> None:
        raise OSError(5, "Input/output error", "disk/mine.toml")

    monkeypatch.setattr(geometry, "resolve_design", broken, raising=False)
    told = command("check", "mine.toml")
    assert (told.code, told.err) == (1, "acoustic-fem: disk/mine.toml: Input/output error\n")


def test_a_process_of_its_own_ends_the_same_way(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "studies.cli", "solve", "array-2x6", "--out", str(tmp_path / "none" / "library.nc")],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("acoustic-fem: ")
    assert done.stderr.count("\n") == 1


def test_what_is_done_is_told_in_plain_lines_where_there_is_no_terminal(command: Command, tmp_path: Path) -> None:
    told = command("solve", "array-2x6", "--out", tmp_path / "library.nc", "--fidelity", "lumped")
    assert "\x1b" not in told.err + told.out
    assert "Cells: network" in told.err.splitlines()
    assert told.err.count("closed form") == 3


@pytest.mark.slow
@pytest.mark.skipif(cores() < 2, reason="cells are solved in child programs on several cores only")
def test_a_solve_that_is_told_to_stop_ends_its_child_programs_and_leaves_no_temporary_folder(tmp_path: Path) -> None:
    environment = {**os.environ, "ACOUSTIC_FEM_CACHE": str(tmp_path / "cache"), "TMPDIR": str(tmp_path)}
    program = subprocess.Popen(
        [sys.executable, "-m", "studies.cli", "solve", "array-2x6", "--out", str(tmp_path / "library.nc")],
        env=environment,
        stderr=subprocess.PIPE,
        text=True,
    )
    deadline = time.monotonic() + 600
    while not list(tmp_path.glob("acoustic-fem-cells-*/*.log")) and time.monotonic() < deadline:
        time.sleep(0.1)
    assert list(tmp_path.glob("acoustic-fem-cells-*/*.log"))
    program.terminate()
    _, said = program.communicate(timeout=600)
    assert program.returncode == 143
    assert "stopped" in said
    assert "Traceback" not in said
    assert not list(tmp_path.glob("acoustic-fem-cells-*"))
    assert not (tmp_path / "library.nc").exists()

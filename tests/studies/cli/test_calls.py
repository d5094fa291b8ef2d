"""A verb parses, calls and prints: what it does is one call in Python, with the same defaults and the same files."""

from __future__ import annotations

import inspect
import json
import re
import sys
from collections.abc import Callable
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.io.wavfile
from command import Command
from refusals import refused
from small_run import small_design, small_run

import acoustic_fem
import geometry
import localize
import studies
from acoustic_fem.quantities.local_air import LocalAir
from geometry import Kind
from geometry.ground.refusal import counted
from localize.signals.array_response import response_of
from studies.cli.verbs import VERBS, option_names

ROOT = Path(__file__).parents[3]
#: Verb -> what it calls, where it finds it.
CALLS = {
    "studio": "studies.serve_studio",
    "new": "studies.cli.new_designs.new_design",
    "check": "studies.check_design",
    "fit": "studies.fit_design",
    "compare": "studies.compare",
    "stock": "studies.list_stock",
    "wiring": "studies.wiring_table",
    "solve": "studies.solve_library",
    "parts": "studies.export_parts",
    "run": "studies.run_design",
    "verify": "studies.verify_run",
    "rig": "studies.record_rig",
    "calibrate": "studies.calibrate_sensor",
    "recalibrate": "studies.recalibrate",
    "diagnose": "studies.diagnose_recording",
    "convert": "studies.convert_library",
    "train": "studies.train_localizer",
    "evaluate": "studies.evaluate_localizer",
    "onnx": "studies.export_decoder",
    "embed": "studies.embed_decoder",
    "locate": "studies.locate_recording",
    "recognize": "studies.recognize_recording",
    "track": "studies.track_recording",
    "pulse": "studies.read_pulse",
    "live": "studies.inference.live.listen",
    "record": "studies.record_board",
    "bend": "studies.bending_study",
    "sweep": "studies.run_sweep",
    "dataset": "studies.export_dataset",
    "tolerance": "studies.tolerance_study",
    "optimize": "studies.optimize",
    "report": "studies.sweep_report",
    "best": "studies.best_designs",
    "prototypes": "studies.cli.new_designs.copy_prototype",
}
#: Verb -> what it calls with its options, where it shows something between the parts of its call.
CALLED = {"new": "studies.cli.new_designs.question"}
#: Verb -> the words that it needs.
WORDS = {
    "studio": "row.toml",
    "new": "mine --out x.toml",
    "check": "row.toml",
    "fit": "row.toml",
    "compare": "row.toml glove",
    "stock": "",
    "wiring": "2 3",
    "solve": "row.toml --out x.nc",
    "parts": "row.toml --out x",
    "run": "row.toml --out x",
    "verify": "x",
    "rig": "row.toml --out x",
    "calibrate": "folder --out x.nc",
    "recalibrate": "a.nc b.wav --out x.nc",
    "diagnose": "a.nc r.wav",
    "convert": "a.nc --out x.csv",
    "train": "a.nc --out x",
    "evaluate": "model a.nc",
    "onnx": "model --out x.onnx",
    "embed": "a.nc --out x",
    "locate": "model r.wav",
    "recognize": "model a.nc r.wav",
    "track": "a.nc r.wav --out x.csv",
    "pulse": "a.nc r.wav",
    "live": "model",
    "record": "--serial COM3 --out x.wav",
    "bend": "--out x",
    "sweep": "study.toml --out x.zarr",
    "dataset": "results.zarr --out x",
    "tolerance": "row.toml --out x",
    "optimize": "study.toml --out x",
    "report": "results.zarr --out x.html",
    "best": "results.zarr",
    "prototypes": "glove --out x.toml",
}
#: What a call takes where it is given None.
BY_DEFAULT = {
    "air": LocalAir(),  # which changes nothing
    "decoding": studies.Decoding(air=LocalAir()),
    "source": studies.LiveInput(),
    "rig": studies.BendingRig(),
    "scatter": studies.HiddenScatter(),
    "plan": localize.TrainingPlan(microphone_noise="design"),
}
STUDY = """
base = "array-2x6"
fidelity = "lumped"
stock = "off"
frequency = "1:100:12"
metrics = ["distance_smallest", "volume"]
[vary]
"tube.inner_diameter" = { from = 0.3, to = 0.5, count = 3 }
"""


@pytest.fixture(name="command")
def printed(command: Command) -> Callable[..., str]:
    """Runs ``acoustic-fem`` with arguments in this process; what it printed."""

    def run(*arguments: object, code: int = 0) -> str:
        told = command(*arguments)
        assert told.code == code, told.err
        return told.out

    return run


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder to work in, with a design and a study."""
    geometry.save_design(small_design(), tmp_path / "row.toml")
    (tmp_path / "study.toml").write_text(STUDY)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def text(*parts: str) -> str:
    """A file of the folder that is worked in."""
    return Path(*parts).read_text(encoding="utf-8")


def documented() -> dict[str, list[str]]:
    """The table of docs/python.md: verb -> its calls as written."""
    rows = re.findall(
        r"^\| `(\w+)` \| (.*?) \|", (ROOT / "docs" / "python.md").read_text(encoding="utf-8"), re.MULTILINE
    )
    return {verb: re.findall(r"(?:studies|geometry)\.\w+", calls) for verb, calls in rows}


# -- a verb holds no workflow ------------------------------------------------------------------------------
def test_every_verb_has_a_documented_call_that_can_be_imported() -> None:
    table = documented()
    assert table.keys() == VERBS.keys() == CALLS.keys()
    for verb, calls in table.items():
        assert calls, verb
        for call in calls:
            package, name = call.split(".")
            assert callable(getattr(sys.modules[package], name)), call
        module, _, own = CALLS[verb].rpartition(".")
        assert f"studies.{getattr(import_module(module), own).__name__}" in calls


@pytest.mark.parametrize("verb", CALLS)
def test_a_verb_without_options_has_the_defaults_of_its_call(
    command: Callable[..., str], place: Path, monkeypatch: pytest.MonkeyPatch, verb: str
) -> None:
    words, target = WORDS[verb], CALLED.get(verb, CALLS[verb])
    module, _, name = target.rpartition(".")
    call = getattr(import_module(module), name)
    given: list[inspect.BoundArguments] = []

    def seen(*arguments: Any, **named: Any) -> None:
        given.append(inspect.signature(call).bind(*arguments, **named))
        raise KeyboardInterrupt

    monkeypatch.setattr(target, seen)
    command(verb, *words.split(), code=130)
    (bound,) = given
    for name, parameter in inspect.signature(call).parameters.items():
        if name in bound.arguments and parameter.default is not parameter.empty and name not in ("display", "hear"):
            value = bound.arguments[name]
            value = tuple(value) if isinstance(value, list) else value
            # a verb may need a file that a call can do without
            assert value in (parameter.default, BY_DEFAULT.get(name, parameter.default)) or name in (
                "out",
                "library",
            ), name


def test_arguments_that_a_refusal_names_are_options_on_the_command_line(tmp_path: Path) -> None:
    model, recording = small_run().folder / "localizer", tmp_path / "r.wav"
    recording.touch()
    with pytest.raises(geometry.Refusal) as found:
        studies.locate_recording(model, recording, decoding=studies.Decoding(ambient=60.0))
    assert found.value.field == "ambient"
    assert found.value.sentence(option_names("locate")).startswith("--ambient")


@pytest.mark.parametrize(
    ("given", "option"), [({"volts": 9999.0}, "--converter-volts"), ({"bits": 77}, "--converter-bits")]
)
def test_a_converter_is_refused_by_the_options_of_embed(given: dict[str, Any], option: str) -> None:
    with pytest.raises(geometry.Refusal) as found:
        localize.embedded.Converter(**given)
    assert found.value.sentence(option_names("embed")).startswith(f"{option} = ")


# -- the same files ----------------------------------------------------------------------------------------
def test_designs_and_libraries_in_python_are_those_of_the_verbs(command: Callable[..., str], place: Path) -> None:
    command("prototypes", "glove", "--out", "verb.toml")
    studies.copy_prototype("glove", "call.toml")
    assert text("verb.toml") == text("call.toml")

    out = command("solve", "row.toml", "--out", "verb.nc", "--fidelity", "lumped")
    library = studies.solve_library(small_design(), "call.nc", fidelity="lumped")
    assert "verb.nc: 3 points, 2 microphones, 500 frequencies" in out
    for one in (library, acoustic_fem.load("call.nc")):
        assert one.transfer_function.identical(acoustic_fem.load("verb.nc").transfer_function)

    command("convert", "call.nc", "--out", "verb.csv")
    studies.convert_library("call.nc", "call.csv")
    assert text("verb.csv") == text("call.csv")

    command("wiring", 3, 36, "--out", "verb.png")
    counts = studies.wiring_table(3, 36, "call.png")
    assert [each.points for each in counts] == [72, 108]
    assert Path("verb.png").read_bytes() == Path("call.png").read_bytes()


def test_a_library_is_brought_to_the_air_of_the_place(command: Callable[..., str], place: Path) -> None:
    command("solve", "row.toml", "--out", "here.nc", "--fidelity", "lumped")
    command("solve", "row.toml", "--out", "there.nc", "--fidelity", "lumped", "--altitude", 2000, "--temperature", 10)
    here, there = acoustic_fem.load("here.nc"), acoustic_fem.load("there.nc")
    assert there.design.air.pressure == pytest.approx(79495, abs=1)
    assert np.allclose(here.in_air(altitude=2000, temperature_c=10).transfer_function, there.transfer_function)

    command("solve", "row.toml", "--out", "no.nc", "--pressure", 1e4, code=1)
    model = small_run().folder / "localizer"
    Path("row.wav").touch()
    with refused(Kind.CONFLICT, "pressure", 9e4):
        studies.locate_recording(model, "row.wav", decoding=studies.Decoding(air=LocalAir(pressure=9e4)))


@pytest.mark.slow
def test_a_check_in_python_writes_what_it_found(place: Path) -> None:
    found = studies.check_design(small_design(), "call.json")
    assert found.error is None
    assert json.loads(json.dumps(found.to_dict())) == json.loads(text("call.json"))


@pytest.mark.slow
def test_scatter_and_bending_in_python_are_those_of_the_verbs(command: Callable[..., str], place: Path) -> None:
    command("tolerance", "row.toml", "--out", "verb", "--samples", 4, "--base", 0, "--library", 2)
    study = studies.tolerance_study(small_design(), "call", samples=4, base_samples=0, library_size=2)
    assert [path.name for path in study.files] == ["tolerance.json", "tolerance.png", "library.zarr"]
    assert text("verb/tolerance.json") == text("call/tolerance.json")

    command("bend", "--out", "bent", "--angles", "0", "--frequencies", "1:100:3")
    bent = studies.bending_study("called", studies.BendingRig(angles=(0.0,)), frequency="1:100:3")
    assert [path.name for path in bent.files] == ["bending.png", "bending.csv", "bending.json"]
    assert text("bent/bending.csv") == text("called/bending.csv")


@pytest.mark.slow
def test_a_localizer_in_python_is_that_of_the_verbs(command: Callable[..., str], place: Path) -> None:
    library = small_run().folder / "library.nc"
    command("train", library, "--out", "verb", "--plan", "maps", "--epochs", 1)
    plan = replace(localize.TrainingPlan.on_maps(), epochs=1, microphone_noise="design")
    trained = studies.train_localizer(library, "call", plan=plan)
    assert trained.folder == Path("call")
    for name in ("training.csv", "confusion.csv"):
        assert text("verb", name) == text("call", name)
    assert {path.name for path in Path("verb").iterdir()} == {path.name for path in Path("call").iterdir()}

    out = command("evaluate", "verb", library, "--touches", 20)
    judged = studies.evaluate_localizer("call", library, touches=20)
    assert list(judged) == ["network", "Bayes decoder", "tolerance-aware decoder"]
    for title, each in judged.items():
        after = [line for line in out.partition(title)[2].splitlines() if line.strip()]
        assert "taps and presses on 20 as-built sensors" in after[0]
        assert f"{100 * each.top1:.1f}" in after[0]
        assert [name for name, _ in each.beside]
        for name, own in each.beside:
            line = next(line for line in after if line.strip().startswith(name))
            assert f"{100 * own.top1:.1f}" in line


@pytest.mark.slow
def test_touches_in_python_are_those_of_the_verbs(command: Callable[..., str], place: Path) -> None:
    library = small_run().folder / "library.nc"
    touches = localize.TouchGenerator(response_of(acoustic_fem.load(library)), 0, "evaluation", 1e-3).samples(0, 1)
    scipy.io.wavfile.write("r.wav", 1000, touches.signals[0].numpy().T.astype(np.float32))
    out = command("locate", library, "r.wav", "--out", "verb.jsonl", "--ambient", 60)
    found = studies.locate_recording(library, "r.wav", "call.jsonl", decoding=studies.Decoding(ambient=60.0))
    assert text("verb.jsonl") == text("call.jsonl")
    assert f"r.wav: {counted(len(found.touches), 'touch')} in 1.0 s" in out
    assert f"points are those of the design {found.design} in {library}" in out
    assert f"the decoder assumes {found.assumptions}" in out
    assert "within manufacturing tolerances" in found.assumptions

    heard: list[str] = []
    summary = studies.listen(
        library, studies.LiveInput(replay="r.wav"), "live.jsonl", record="again.wav",
        decoding=studies.Decoding(ambient=60.0), hear=lambda session, event, line: heard.append(line),
    )  # fmt: skip
    assert text("live.jsonl").splitlines() == heard
    told, located = (
        [{k: v for k, v in json.loads(line).items() if k != "latency"} for line in lines]
        for lines in (heard, text("call.jsonl").splitlines())
    )
    assert told == located
    assert sum(summary.states.values()) == sum("state" in line for line in told)
    assert summary.touches == sum(line.get("event") == "down" for line in told)
    assert summary.latencies.count >= len(heard) - 1  # the end of the filter may come when the file has ended
    assert summary.recordings == (Path("again.wav"),)
    first = studies.listen(library, studies.LiveInput(replay="r.wav"), hear=lambda *_: False)
    assert sum(first.states.values()) == 1


def test_a_sweep_in_python_is_that_of_the_verbs(command: Callable[..., str], place: Path) -> None:
    command("sweep", "study.toml", "--out", "verb.zarr", "--workers", 1)
    told: list[int] = []
    with studies.Display() as display:
        summary = studies.run_sweep(
            studies.load_study("study.toml"), "call.zarr", workers=1, display=display,
            progress=lambda now: told.append(now.done),
        ).summary  # fmt: skip
    assert (summary.cases, told[-1]) == (3, 3)
    assert "Sweep" in display.seconds
    one, other = (studies.open_sweep(name).to_xarray() for name in ("verb.zarr", "call.zarr"))
    assert one["distance_smallest"].identical(other["distance_smallest"])

    out = command("best", "verb.zarr", "--by", "volume", "--count", 2)
    best = studies.best_designs("call.zarr", "volume", 2)
    listed = [line.split()[0] for line in out.splitlines() if line.split()[:1] and line.split()[0].isdecimal()]
    assert [best.table.label(row) for row in best.rows] == listed
    command("best", "verb.zarr", listed[0], "--out", "verb.toml")
    studies.save_best_design("call.zarr", int(listed[0]), "call.toml")
    assert text("verb.toml") == text("call.toml")

    command("report", "verb.zarr", "--out", "verb.html")
    table = studies.sweep_report("call.zarr", "call.html")
    assert len(table.number) == 3
    own, called = (text(f"{name}.html").replace(f"{name}.zarr", "") for name in ("verb", "call"))
    assert own == called

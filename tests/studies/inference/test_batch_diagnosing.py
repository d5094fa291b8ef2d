"""Many sensors are diagnosed in one call: each is a row, passes or fails by the limits, and is diagnosed once."""

from __future__ import annotations

import csv
import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

import acoustic_fem
import geometry
import studies
from acoustic_fem.batch import ArrayParameters, Topology
from acoustic_fem.sound.sound_file import write_wav
from geometry import Kind, Refusal
from localize.diagnosis import Diagnoser, DiagnosisOptions, ProductionLimits, SensorFault, read_limits
from localize.diagnosis.production_limits import LimitsError
from studies.cli.app import app
from studies.inference import batch_diagnosing
from studies.test_rig.faulty_rig import FaultyRig, diagnosis_session

DESIGN = geometry.prototype("array-2x6").with_values({"lines.0.points": 4, "layout.columns": 2})
FAULTS = {"sound": None, "leaking": SensorFault("leak", (2,), 0.4)}


@cache
def library() -> acoustic_fem.Library:
    return acoustic_fem.solve(DESIGN, np.arange(1.0, 201.0), "lumped")


@cache
def signals(name: str) -> np.ndarray:
    rig = FaultyRig(DESIGN, 46920, FAULTS[name], fidelity="lumped")
    return diagnosis_session(rig, 3, count=8).signals


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a library, and a folder of three recordings of which one is broken."""
    monkeypatch.chdir(tmp_path)
    Path("recordings").mkdir()
    for name in FAULTS:
        write_wav(Path("recordings", f"{name}.wav"), signals(name) / 4.0, 1000, 24)
    Path("recordings", "broken.wav").write_bytes(b"RIFF")
    Path("recordings", "notes.md").write_text("not a recording")
    quick = DiagnosisOptions(candidates=2, moves=0, refinements=1, amounts=1)
    monkeypatch.setattr(batch_diagnosing, "Diagnoser", lambda library, noise: Diagnoser(library, noise, quick))
    return tmp_path


def rows(path: str) -> list[dict[str, str]]:
    with Path(path).open(newline="") as file:
        return list(csv.DictReader(file))


def test_a_batch_is_a_table_with_a_row_for_each_sensor(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    found = studies.diagnose_batch(library(), "recordings", "out", full_scale=4.0)
    assert [(each.sensor, each.result) for each in found.sensors] == [
        ("broken", "no diagnosis"), ("leaking", "fail"), ("sound", "pass")]  # fmt: skip
    assert found.counts == {"pass": 1, "fail": 1, "no diagnosis": 1}
    assert not found.passed
    leaking = found.sensors[1]
    assert leaking.faults[0].same_part(SensorFault("leak", (2,)))
    assert "a leak of" in leaking.objections[0]
    assert found.frequent_faults[0] == ("point 2 leaks", 1)
    table = rows("out/sensors.csv")
    assert [row["result"] for row in table] == ["no diagnosis", "fail", "pass"]
    assert "broken.wav" in table[0]["finding"]
    assert float(table[2]["modulus_low"]) < float(table[2]["modulus_of_batch"]) < float(table[2]["modulus_high"])
    parameters = rows("out/parameters.csv")
    assert {row["part"] for row in parameters if row["quantity"] == "cavity_height"} == {
        f"point {k}" for k in range(1, 5)
    }
    assert json.loads(Path("out/sensors.json").read_text(encoding="utf-8"))["sensors"][1]["reasons"] == list(
        leaking.objections
    )
    page = Path("out/report.html").read_text(encoding="utf-8")
    assert "1 of 3 pass" in page
    assert "point 2 leaks" in page

    # Other limits need no diagnosis again, and a changed recording needs one.
    def stopped(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(Diagnoser, "diagnose", stopped)
    again = studies.diagnose_batch(library(), "recordings", "out", limits=ProductionLimits(leak=1.0), full_scale=4.0)
    assert [each.result for each in again.sensors] == ["no diagnosis", "pass", "pass"]
    with pytest.raises(KeyboardInterrupt):
        studies.diagnose_batch(library(), "recordings", "out", full_scale=4.0, points={1.2: 3})


def test_a_stopped_batch_goes_on(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    diagnosed, done = Diagnoser.diagnose, []

    def counted(self: Diagnoser, *words: object) -> object:
        if len(done) == 1:
            done.append("stopped")
            raise KeyboardInterrupt
        done.append("diagnosed")
        return diagnosed(self, *words)  # type: ignore[arg-type]

    monkeypatch.setattr(Diagnoser, "diagnose", counted)
    with pytest.raises(KeyboardInterrupt):
        studies.diagnose_batch(library(), "recordings", "out", full_scale=4.0)
    assert not Path("out/report.html").exists()
    found = studies.diagnose_batch(library(), "recordings", "out", full_scale=4.0)
    assert done == ["diagnosed", "stopped", "diagnosed"]
    assert found.counts["pass"] == 1


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("points = [1, 2]", "states 2 points"),
        ('points = "all"', "must be a list of whole numbers"),
        ("[points]\nsoon = 3", "must be a list of whole numbers"),
        ("point = [1]", "must hold points and nothing else"),
    ],
)
def test_points_of_one_sensor_that_do_not_fit_are_its_problem(place: Path, text: str, words: str) -> None:
    for name in ("broken", "leaking"):
        Path("recordings", f"{name}.wav").unlink()
    Path("recordings/sound.toml").write_text(text)
    (sensor,) = studies.diagnose_batch(library(), "recordings", "out", full_scale=4.0).sensors
    assert sensor.result == "no diagnosis"
    assert words in sensor.problem


def test_bad_folders_are_refused(place: Path) -> None:
    for folder, words in (("nowhere", "must be a folder"), ("empty", "holds no recording")):
        Path("empty").mkdir(exist_ok=True)
        with pytest.raises(Refusal, match=words):
            studies.diagnose_batch(library(), folder, "out")
    Path("recordings/sound.csv").write_text("A,B\n")
    with pytest.raises(Refusal, match="two recordings of the sensor sound"):
        studies.diagnose_batch(library(), "recordings", "out")
    with pytest.raises(Refusal) as refused:
        studies.diagnose_batch(library(), "recordings", "recordings")
    assert refused.value.kind in (Kind.EXISTS, Kind.CONFLICT)


def test_limits_are_a_file(tmp_path: Path) -> None:
    path = tmp_path / "limits.toml"
    path.write_text("leak = 0.2\ntouches = 12\n[parameters.modulus_of_batch]\nlow = 0.8\nhigh = 1.2\n")
    limits = read_limits(path)
    assert limits == ProductionLimits(12, 0.2, parameters={"modulus_of_batch": (0.8, 1.2)})
    for text, words in (
        ("leaks = 1", "leaks"),
        ("leak = -1", "leak"),
        ("touches = 3", "touches"),
        ("[parameters.length]\nlow = 0.0\nhigh = 1.0", "parameters"),
        ("[parameters.bore]\nlow = 2.0\nhigh = 1.0", "parameters.bore.low"),
    ):
        path.write_text(text)
        with pytest.raises(LimitsError, match=words):
            read_limits(path)


def test_each_fault_has_its_limit() -> None:
    limits = ProductionLimits(leak=0.2, blocked_tube=0.6, quiet_microphone=3.0)
    within = (SensorFault("leak", (1,), 0.15), SensorFault("blocked tube", (1,), 0.7),
              SensorFault("quiet microphone", (1,), -2.0))  # fmt: skip
    beyond = (SensorFault("leak", (1,), 0.3), SensorFault("blocked tube", (1,), 0.4),
              SensorFault("quiet microphone", (1,), -12.0), SensorFault("reversed microphone", (1,)),
              SensorFault("exchanged microphones", (1, 2)))  # fmt: skip
    assert not limits.objections("one of several", within, (), 24)
    for fault in beyond:
        assert len(limits.objections("fault", [fault], (), 24)) == 1
        assert len(limits.objections("one of several", [within[0], fault], (), 24)) == 1
    assert len(limits.objections("unexplained", beyond[:1], (), 24)) == 1
    assert len(limits.objections("sound", (), (), 5)) == 1


@pytest.mark.slow
@pytest.mark.end_to_end
def test_a_lot_is_judged_and_its_bores_are_measured(tmp_path: Path) -> None:
    """As-built sensors of seeds on which nothing was chosen, touched at points that nobody states."""
    design = geometry.prototype("array-2x6")
    faults = (None, SensorFault("leak", (9,), 0.3), SensorFault("blocked tube", (6,), 0.35))
    (tmp_path / "lot").mkdir()
    truths = {}
    for number, fault in enumerate(faults):
        rig = FaultyRig(design, 46940 + number, fault, fidelity="lumped")
        touches = diagnosis_session(rig, number)
        write_wav(tmp_path / "lot" / f"s{number}.wav", touches.signals / 4.0, 1000, 24)
        sound = FaultyRig(design, 46940 + number, None, fidelity="lumped")
        nominal = ArrayParameters.from_design(design).individual(Topology.of(design)).tube_radius
        truths[f"s{number}"] = (np.asarray(sound.hidden.tube_radius) / np.asarray(nominal))[0]
    whole = acoustic_fem.solve(design, np.arange(1.0, 201.0), "lumped")
    found = studies.diagnose_batch(whole, tmp_path / "lot", tmp_path / "out", full_scale=4.0)
    assert [each.result for each in found.sensors] == ["pass", "fail", "fail"]
    inside = []
    for sensor, fault in zip(found.sensors, faults, strict=True):
        assert not fault or sensor.faults[0].same_part(fault)
        assert sensor.probability is not None
        assert sensor.probability > 0.9
        bores = [each for each in sensor.parameters if each.quantity == "bore"]
        inside += [
            each.low < truths[sensor.sensor][k] < each.high
            for k, each in enumerate(bores)
            if each.measured and not (fault and fault.kind == "blocked tube" and k == fault.part[0] - 1)
        ]
    assert len(inside) > 20
    assert np.mean(inside) > 0.85


def test_the_verb_shows_the_table_and_ends_by_the_result(place: Path) -> None:
    acoustic_fem.save(library(), "library.nc")
    words = ["diagnose", "library.nc", "--batch", "recordings", "--out", "out", "--full-scale", "4"]
    found = CliRunner().invoke(app, words)
    assert found.exit_code == 3, found.output
    assert "1 of 3 sensors pass" in " ".join(found.output.split())
    for name in ("broken", "leaking"):
        Path("recordings", f"{name}.wav").unlink()
    assert CliRunner().invoke(app, words).exit_code == 0
    stated = [*diagnosis_session(FaultyRig(DESIGN, 46920, None, fidelity="lumped"), 3, count=8).point.tolist(), 1]
    Path("recordings/sound.toml").write_text(f"points = {stated}")
    one_more = CliRunner().invoke(app, words)
    assert "touch 9 (point 1) was missed" in " ".join(one_more.output.split())
    assert "touch 9 (point 1) was missed" in Path("out/report.html").read_text()
    for wrong in (["diagnose", "library.nc"], ["diagnose", "library.nc", "take.wav", "--batch", "recordings"],
                  words[:4], ["diagnose", "library.nc", "take.wav", "--limits", "x.toml"]):  # fmt: skip
        assert CliRunner().invoke(app, wrong).exit_code == 2

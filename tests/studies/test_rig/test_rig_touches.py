"""Recorded touches of the virtual rig's sensor, from files to a localizer that knows the made sensor."""

import csv
import json
import sys
from dataclasses import replace

import numpy as np
import pytest
from refusals import refused
from small_run import small_design

import acoustic_fem
import geometry
import localize
from geometry import Kind
from localize.learned.recorded_frames import RecordedFrames
from localize.recordings.touch_manifest import PARTS
from localize.signals.array_response import response_of
from studies.cli import app
from studies.test_rig.rig_touches import TouchSession, record_touches
from studies.test_rig.virtual_rig import HiddenScatter, Recorder, Rig

NOISE = 1e-3
RECORDER = Recorder(hum=5e-4, drift=1e-3)
SESSION = TouchSession(takes=2, seconds=5.0)


@pytest.fixture(scope="module")
def rig():
    return Rig(small_design(), 4, HiddenScatter(batch=0.0, modulus=0.8), fidelity="lumped")


@pytest.fixture(scope="module")
def library(rig):
    return acoustic_fem.solve(rig.design, np.arange(1.0, 201.0), "lumped")


@pytest.fixture(scope="module")
def manifest(rig, tmp_path_factory):
    return record_touches(rig, tmp_path_factory.mktemp("touches"), (1, 2, 3), SESSION, RECORDER)


def test_every_part_of_every_point_is_recorded_twice_and_again_the_same(rig, manifest, tmp_path):
    files = sorted(manifest.parent.glob("*.wav"))
    assert [path.name for path in files] == [
        f"point-0{point}-{part}-{take}.wav" for point in (1, 2, 3) for part in sorted(PARTS) for take in (1, 2)
    ]
    again = record_touches(rig, tmp_path, (2,), TouchSession(2, 5.0, ("taps",)), RECORDER)
    for path in sorted(again.parent.glob("*.wav")):
        assert path.read_bytes() == (manifest.parent / path.name).read_bytes()
    with refused(Kind.OUT_OF_RANGE, "points", 4.0):
        record_touches(rig, tmp_path, (4,), SESSION)


def test_the_parts_lie_in_their_bands(rig, manifest):
    def shares(part):
        heard = localize.read_recording(manifest.parent / f"point-02-{part}-1.wav", rig.design.microphones, 2.0)
        power = np.abs(np.fft.rfft(heard.signals[0] - heard.signals[0].mean())) ** 2
        grid = np.fft.rfftfreq(heard.signals.shape[1], 1e-3)
        total = power[grid > 0.8].sum()
        return [power[(grid > low) & (grid <= high)].sum() / total for low, high in ((0.8, 11), (11, 101))]

    assert shares("random-1-10")[0] > 0.95
    assert shares("random-1-100")[1] > 0.5
    assert shares("friction")[1] > 0.5


def test_a_decoder_that_knows_the_made_sensor_names_its_touches(rig, library, manifest):
    nominal = response_of(library)
    frames = RecordedFrames(manifest, nominal, NOISE, 0)
    assert sum(entry["frames"] for entry in frames.to_dict()["training"]) > 500
    made = replace(nominal, transfer_function=rig.transfer_function(np.minimum(nominal.frequency, 160.0)))
    found = frames.judge(localize.BayesDecoder(made, NOISE))
    assert set(found) == set(PARTS)
    assert all(found[part].top1 > 0.93 for part in PARTS if part != "taps")
    # what is left of a tap once its beginning has passed out of the frame names wrong points
    assert 0.6 < found["taps"].top1 < 0.9


@pytest.mark.slow
def test_training_on_recordings_from_the_command_line(library, manifest, tmp_path, monkeypatch, capsys):
    acoustic_fem.save(library, tmp_path / "library.nc")
    arguments = ["train", "library.nc", "--out", "made", "--epochs", "2", "--noise", str(NOISE), "--seed", "7"]
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "argv", ["acoustic-fem", *arguments, "--recordings", str(manifest)])
    with pytest.raises(SystemExit) as ended:
        app.main()
    told = capsys.readouterr()
    assert ended.value.code == 0, told.err
    for part in PARTS:
        assert any(line.split()[:2] == [part, "3"] for line in told.out.splitlines()), part
    kept = localize.load_localizer("made").training
    assert len(kept["recordings"]["held_out"]) == len(kept["recordings"]["training"]) == 12
    assert kept["recordings"]["seed"] == 7
    rows = list(csv.DictReader((tmp_path / "made" / "training.csv").open()))
    assert list(rows[0]) == ["epoch", "loss", "held_out_accuracy", *(f"recorded {part}" for part in PARTS)]
    last = {part: float(rows[-1][f"recorded {part}"]) for part in PARTS}
    assert last == {part: found["top1"] for part, found in kept["held_out_recordings"].items()}
    assert json.loads((tmp_path / "made" / "localizer.json").read_text())["plan"]["recorded"] == 0.5
    elsewhere = ["elsewhere" if word == "made" else word for word in arguments]
    monkeypatch.setattr(sys, "argv", ["acoustic-fem", *elsewhere, "--recordings", "nowhere.toml"])
    with pytest.raises(SystemExit) as ended:
        app.main()
    assert ended.value.code == 1
    assert "nowhere.toml: no such file" in capsys.readouterr().err


@pytest.mark.slow
def test_recordings_of_a_as_built_sensor_add_what_its_design_does_not_tell(tmp_path):
    design = geometry.prototype("array-2x6")
    library = acoustic_fem.solve(design, np.arange(1.0, 201.0), "lumped")
    rig = Rig(design, 1, HiddenScatter(batch=0.0, modulus=0.85), fidelity="lumped")
    manifest = record_touches(rig, tmp_path, range(1, 13), TouchSession(), RECORDER)
    frames = RecordedFrames(manifest, response_of(library), NOISE, 0)
    # A convolutional network: the one of hypotheses learns from recordings only what holds for all points.
    usual = localize.TrainingPlan.on_maps()
    plan = replace(usual, microphone_noise=1e-3, epochs=5, stimuli=("multi-sines", "taps", "friction"))
    right = {}
    for name, recordings in (("simulated", None), ("mixed", manifest)):
        found = frames.judge(localize.train(library, plan, recordings=recordings))
        right[name] = np.mean([each.top1 for each in found.values()])
    assert right["mixed"] > right["simulated"] + 0.05
    assert right["mixed"] > 0.6  # fingers of a rig play, and are not flat

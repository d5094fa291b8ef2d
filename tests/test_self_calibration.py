"""A sensor calibrated by touches of which nobody knows the points, or refused, and then nothing changes."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import acoustic_fem
import geometry
import localize
from acoustic_fem.library import Library
from acoustic_fem.model_updating import UpdatedModel
from localize.array_response import response_of
from localize.bayes import NOISE_SHARE
from localize.calibration_search import value_and_slope
from localize.marginal_likelihood import MarginalLikelihood
from localize.self_calibration import SelfCalibration, self_calibrate
from studies.cli import main
from studies.rig import HiddenScatter, Rig

GRID = np.linspace(1.0, 100.0, 24)
DESIGN = geometry.prototype("array-2x6")
NOISE = 1e-3

Array = NDArray[np.float64]


@cache
def nominal() -> Library:
    return acoustic_fem.solve(DESIGN, GRID, "lumped")


@cache
def truth(seed: int = 6, modulus: float = 0.85) -> localize.ArrayResponse:
    """A made sensor, on which the nominal library names half of the touches right."""
    h = Rig(DESIGN, seed, HiddenScatter(modulus=modulus)).transfer_function(GRID)
    return replace(response_of(nominal()), transfer_function=h)


def touches(response: localize.ArrayResponse, count: int, seed: int = 1) -> tuple[Array, NDArray[np.int64]]:
    """Frames and the points nobody tells."""
    made = localize.TouchGenerator(response, seed, "training", NOISE).samples(0, count)
    return made.signals[:, :, :250].double().numpy(), made.point.numpy()


def top1(library: Library, response: localize.ArrayResponse) -> float:
    return localize.evaluate(localize.BayesDecoder(library, NOISE), response, 20, NOISE, seed=7).top1


@cache
def calibrated() -> SelfCalibration:
    return self_calibrate(nominal(), touches(truth(), 160)[0], NOISE)


def test_the_slope_is_that_of_finite_differences() -> None:
    model = UpdatedModel(nominal())
    likelihood = MarginalLikelihood(GRID, touches(truth(), 24)[0], 0.01)
    random = np.random.default_rng(3)
    u, direction = 0.5 * random.standard_normal((2, model.count))
    value, slope = value_and_slope(model, likelihood, u)
    step = 1e-4

    def at(parameters: Array) -> float:
        return float(likelihood.evidence(model.transfer_function(parameters[None])[0]).frames.sum())

    assert at(u) == pytest.approx(value, rel=1e-9)
    along = (at(u + step * direction) - at(u - step * direction)) / (2 * step)
    assert along == pytest.approx(float(slope @ direction), rel=1e-5)


def test_the_likelihood_ranks_points_as_the_decoder_does() -> None:
    frames, points = touches(truth(), 120)
    likelihood = MarginalLikelihood(GRID, frames, NOISE_SHARE * NOISE)
    share = likelihood.evidence(truth().transfer_function).share
    assert np.allclose(share.sum(1), 1)
    decoder = localize.BayesDecoder(truth(), NOISE)
    assert (share.argmax(1) == decoder.locate(frames).argmax(1)).mean() > 0.98
    assert (share.argmax(1) == points).mean() > 0.98


def test_information_is_symmetric_never_negative_and_grows_with_the_frames() -> None:
    model = UpdatedModel(nominal())
    h = nominal().transfer_function.values
    likelihood = MarginalLikelihood(GRID, touches(truth(), 24)[0], 0.01)
    information = likelihood.information(h, model.jacobian(np.zeros(model.count)))
    assert np.allclose(information, information.T)
    assert np.linalg.eigvalsh(information)[0] > -1e-4 * np.linalg.eigvalsh(information)[-1]
    twice = MarginalLikelihood(GRID, np.tile(touches(truth(), 24)[0], (2, 1, 1)), 0.01)
    assert np.allclose(twice.information(h, model.jacobian(np.zeros(model.count))), 2 * information, rtol=1e-6)


def test_unlabelled_touches_bring_the_library_to_the_made_sensor() -> None:
    found = calibrated()
    assert found.objection is None
    before, after, known = top1(nominal(), truth()), top1(found.library(), truth()), 1.0
    assert before < 0.7
    assert after > known - 0.01


def test_the_library_says_what_it_was_made_from(tmp_path: Path) -> None:
    library = calibrated().library()
    acoustic_fem.save(library, tmp_path / "now.nc")
    read = acoustic_fem.load(tmp_path / "now.nc")
    assert np.array_equal(read.transfer_function.values, library.transfer_function.values)
    made = read.provenance["self_calibration"]
    assert (made["frames"], made["seed"], made["objection"]) == (160, 0, None)
    assert set(made["parameters"]) == set(UpdatedModel(nominal()).names)
    assert read.provenance["present"]["fidelity"] == "lumped"
    assert read.transfer_function_deviation is not None
    error = np.abs(read.transfer_function.values - truth().transfer_function)
    assert np.median(error / read.transfer_function_deviation.values) < 3


def recording(path: Path, frames: Array) -> Path:
    """The frames one after the other, as a recording of 1 kHz."""
    np.savez(path, signals=np.concatenate(list(frames), axis=1))
    return path


def run(monkeypatch: pytest.MonkeyPatch, *arguments: object) -> int:
    monkeypatch.setattr("sys.argv", ["acoustic-fem", "recalibrate", *map(str, arguments), "--noise", "1e-3"])
    with pytest.raises(SystemExit) as ended:
        main()
    return int(str(ended.value.code))


def test_the_command_makes_the_same_library_from_recordings(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    acoustic_fem.save(nominal(), tmp_path / "last.nc")
    frames = touches(truth(), 160)[0]
    files = [recording(tmp_path / f"{k}.npz", part) for k, part in enumerate(np.split(frames, [70]))]
    assert run(monkeypatch, tmp_path / "last.nc", *files, "--out", tmp_path / "now.nc") == 0
    assert "from 160 frames with touches" in capsys.readouterr().out
    made = acoustic_fem.load(tmp_path / "now.nc")
    assert made.provenance["self_calibration"] == calibrated().summary()
    assert np.array_equal(made.transfer_function.values, calibrated().library().transfer_function.values)


def test_the_command_writes_nothing_when_it_refuses(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A library that is right already is kept, and so is one that the touches say too little of."""
    last, out = tmp_path / "last.nc", tmp_path / "now.nc"
    acoustic_fem.save(nominal(), last)
    before = last.read_bytes()
    own = touches(replace(truth(), transfer_function=nominal().transfer_function.values), 110)[0]
    for frames, reason in (
        (own, "which is as good"),
        (own[:30], "30 of 30 frames hold a touch"),
        (own[:, :1], "has 1 channels"),
    ):
        file = recording(tmp_path / "touches.npz", frames)
        assert run(monkeypatch, last, file, "--out", out) == 1
        assert reason in capsys.readouterr().err.splitlines()[-1]
        assert run(monkeypatch, last, tmp_path / "none.npz", "--out", out) == 1
    assert last.read_bytes() == before
    assert not out.exists()


def test_the_command_never_overwrites_a_library_its_own_least_of_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "last.nc").write_bytes(b"the last calibration")
    (tmp_path / "again.nc").symlink_to("last.nc")
    monkeypatch.chdir(tmp_path)
    for out in ("last.nc", "./last.nc", "again.nc"):
        assert run(monkeypatch, "last.nc", "touches.npz", "--out", out) == 1
        assert "exists, and a calibrated library is never overwritten" in capsys.readouterr().err
    assert (tmp_path / "last.nc").read_bytes() == b"the last calibration"


def test_touches_of_another_sensor_are_refused() -> None:
    other = DESIGN.with_values({"tube.inner_diameter": 0.6 * DESIGN.tube.inner_diameter})
    h = acoustic_fem.solve(other, GRID, "lumped").transfer_function.values
    found = self_calibrate(nominal(), touches(replace(truth(), transfer_function=h), 110)[0], NOISE)
    assert found.objection is not None
    assert found.library() is nominal()


@pytest.mark.slow
def test_noise_that_differs_between_microphones_is_refused() -> None:
    noise = 0.1 * np.random.default_rng(5).standard_normal((110, 2, 250))
    found = self_calibrate(nominal(), noise, NOISE)
    assert "held-out frames are touches of the sensor found" in str(found.objection)
    assert found.library() is nominal()


def test_frames_that_cannot_be_used_are_refused() -> None:
    frames = touches(truth(), 120)[0]
    with pytest.raises(ValueError, match="99 of 99 frames hold a touch; a calibration needs at least 100"):
        self_calibrate(nominal(), frames[:99], NOISE)
    quiet = frames.copy()
    quiet[30:] *= 1e-6
    with pytest.raises(ValueError, match="of 120 frames hold a touch"):
        self_calibrate(nominal(), quiet)
    with pytest.raises(ValueError, match="have 1 channels, must have 2"):
        self_calibrate(nominal(), frames[:, :1])
    with pytest.raises(ValueError, match=r"must be \(n, n_microphone, 250\)"):
        self_calibrate(nominal(), np.pad(frames, ((0, 0), (0, 0), (0, 50))))
    with pytest.raises(ValueError, match="channel B of signal 0 is silent"):
        self_calibrate(nominal(), frames * np.array([1.0, 0.0])[:, None])
    with pytest.raises(ValueError, match="microphone_noise = 0 Pa must be between"):
        self_calibrate(nominal(), frames, 0)

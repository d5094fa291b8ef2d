"""What a library opens: a decoder that its sensor asks for, which goes on without a microphone where it has three."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from shared import solved

import acoustic_fem
import localize
from acoustic_fem.library.transfer_functions import MEASURED, measured_library
from geometry.ground.refusal import Refusal
from localize.signals.array_response import response_of
from studies.listening.opening import Decoding, assumed_by, open_localizer, open_stream, open_trained
from studies.listening.recorded import locate_recording


@pytest.mark.parametrize(
    ("name", "state"), [pytest.param("glove", "no touch", marks=pytest.mark.slow), ("array-2x6", "unreadable")]
)
def test_a_library_of_three_microphones_goes_on_without_one_that_is_dead(tmp_path, name, state) -> None:
    path = tmp_path / "library.nc"
    acoustic_fem.save(solved(name, np.arange(1.0, 101.0)), path)
    localizer = open_localizer(path, Decoding())
    samples = 7e-4 * np.random.default_rng(0).standard_normal((len(localizer.microphones), 300))
    samples[0] = 0.0
    events = open_stream(path, localizer, Decoding()).push(samples)
    assert {event.state for event in events if isinstance(event, localize.Decision)} == {state}


def test_a_drift_is_followed_about_a_calibrated_library_alone(tmp_path) -> None:
    grid = np.arange(1.0, 101.0, 3.0)
    nominal = solved("array-2x6", grid)
    computed, calibrated = tmp_path / "computed.nc", tmp_path / "calibrated.nc"
    acoustic_fem.save(nominal, computed)
    h = nominal.transfer_function.values
    acoustic_fem.save(measured_library(nominal.design, nominal, h, 0.01 * np.abs(h), ("numpy",), {}), calibrated)
    follow = Decoding(noise=1e-3, follow_drift=True)
    decoder = open_localizer(calibrated, follow)
    assert isinstance(decoder, localize.DriftDecoder)
    samples = 7e-4 * np.random.default_rng(0).standard_normal((2, 300))
    assert open_stream(calibrated, decoder, follow).push(samples)
    with pytest.raises(Refusal, match=r"computed\.nc: must be calibrated to follow a drift, was computed"):
        open_localizer(computed, follow)
    with pytest.raises(Refusal, match="`follow_drift` needs a calibrated library as model: localizer is none"):
        open_localizer(Path("localizer"), follow)


@pytest.mark.slow
def test_a_drift_is_followed_on_where_a_microphone_dies(tmp_path) -> None:
    grid = np.arange(1.0, 101.0, 3.0)
    nominal, path = solved("glove", grid), tmp_path / "calibrated.nc"
    h = nominal.transfer_function.values
    acoustic_fem.save(measured_library(nominal.design, nominal, h, 0.01 * np.abs(h), ("numpy",), {}), path)
    follow = Decoding(noise=1e-3, follow_drift=True)
    decoder = open_localizer(path, follow)
    assert isinstance(decoder, localize.DriftDecoder)
    before = decoder.belief
    touch = localize.TouchGenerator(response_of(nominal), 1, "training", 1e-3).samples(3, 1).signals[0].double().numpy()
    touch[0] = 0.0
    events = open_stream(path, decoder, follow).push(touch)
    assert any(event.state == "touch" for event in events if isinstance(event, localize.Decision))
    assert not np.array_equal(decoder.belief, before)  # what the others heard moved what all believe


def test_a_library_is_decoded_with_the_tolerances_until_its_sensor_is_measured(tmp_path) -> None:
    library = solved("array-2x6", np.arange(1.0, 101.0))
    for one, kind in (
        (library, localize.TolerantDecoder),
        (replace(library, fidelity=MEASURED), localize.BayesDecoder),
    ):
        acoustic_fem.save(one, tmp_path / "library.nc")
        assert type(open_localizer(tmp_path / "library.nc", Decoding(noise=1e-3))) is kind


@pytest.mark.slow
def test_what_is_assumed_of_a_sensor_is_said_of_every_kind_of_model(tmp_path) -> None:
    library = solved("array-2x6", np.arange(1.0, 101.0))
    dome = library.design.with_values({"resonator.shape": "dome"})
    path, given = tmp_path / "library.nc", Decoding(noise=1e-3)

    def said(one: acoustic_fem.Library) -> str:
        acoustic_fem.save(one, path)
        found = assumed_by(path, open_localizer(path, given), given)
        path.unlink()  # a measured one is not overwritten
        return found

    assert said(replace(library, fidelity=MEASURED)) == "that the sensor is as its library has it, in air of 101.3 kPa"
    without = said(replace(library, design=dome))
    assert "tolerances of manufacturing are not reckoned with (resonator.shape = 'dome' must be" in without
    assert "within the tolerances" in said(library)
    # A graph is of the library as it is, and says so wherever it is read.
    acoustic_fem.save(library, path)
    decoder, graph = open_trained(path, 1e-3, None), tmp_path / "decoder.onnx"
    localize.export_onnx(decoder, graph)
    exactly = assumed_by(path, decoder, given)
    assert exactly.endswith("tolerances of manufacturing are not reckoned with")
    assert assumed_by(graph, localize.OnnxLocalizer(graph), Decoding()) == exactly


def test_a_recording_that_is_not_there_is_refused_before_anything_is_opened(tmp_path) -> None:
    with pytest.raises(Refusal, match=r"taps\.wav: no such file"):
        locate_recording(tmp_path / "library.nc", tmp_path / "taps.wav")
    with pytest.raises(Refusal, match=r"taps\.mp3: its name must end with \.wav, \.csv, \.npz or \.mat"):
        locate_recording(tmp_path / "library.nc", tmp_path / "taps.mp3")

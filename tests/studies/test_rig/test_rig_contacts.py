"""Contacts recorded with the virtual rig's sensor, and the example recordings that were made with it."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from small_run import small_design

import acoustic_fem
import localize
from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.network import output_response, response
from acoustic_fem.quantities.local_air import design_air
from localize.contacts import Contact, covered_force
from localize.signals.array_response import response_of
from studies.test_rig.rig_contacts import record_contact
from studies.test_rig.virtual_rig import Recorder, Rig

QUIET = Recorder(full_scale=50.0, hum=0.0, drift=0.0)
GRID = np.array([1.0, 10.0, 20.0, 40.0, 100.0])
EXAMPLES = Path(__file__).parents[3] / "docs" / "examples" / "recordings"


@pytest.fixture(scope="module")
def rig():
    return Rig(small_design(), 4, fidelity="lumped")


@pytest.fixture(scope="module")
def nominal(rig):
    return response_of(acoustic_fem.solve(rig.design, GRID, "lumped"))


def humming(place, force=1e-3):
    """A finger that presses inside one membrane with 20 Hz."""
    time = np.arange(4001) / 1e3
    return Contact(time, np.tile(place, (len(time), 1)), force * (1 + np.sin(2 * np.pi * 20 * time)), 0.5)


def high_pass(rig):
    return np.abs(output_response(rig.design.microphone, 20.0, design_air(rig.design)))


def at_20_hz(rig, path):
    heard = localize.read_recording(path, rig.design.microphones, QUIET.full_scale).signals[:, 1000:4000]
    return heard @ np.exp(-2j * np.pi * 20 * np.arange(3000) / 1e3) / 1500


def test_a_force_is_heard_through_the_cavity_as_designed_and_the_sensor_as_made(rig, nominal, tmp_path):
    record_contact(rig, humming(nominal.position[1]), tmp_path / "press.wav", QUIET)
    made = rig.transfer_function(np.array([20.0]))[1, :, 0]
    expected = np.abs(1e-3 * nominal.cavity_response[1, 2] * made) * high_pass(rig)
    assert np.allclose(np.abs(at_20_hz(rig, tmp_path / "press.wav")), expected, rtol=0.01)


def test_membranes_under_one_contact_are_heard_together(rig, nominal, tmp_path):
    middle = nominal.position[:2].mean(0)
    wide = replace(humming(middle), contact_radius_mm=float(np.ptp(nominal.position[:2], axis=0).max()))
    truth = record_contact(rig, wide, tmp_path / "both.wav", QUIET)
    share = covered_force(wide, nominal).max(0) / 2
    made = (rig.transfer_function(np.array([20.0]))[:, :, 0] * (share * nominal.cavity_response[:, 2])[:, None]).sum(0)
    assert (share > 0).sum() >= 2
    expected = np.abs(made) * high_pass(rig)
    assert np.allclose(np.abs(at_20_hz(rig, tmp_path / "both.wav")), expected, rtol=0.01)
    assert truth.read_text(encoding="utf-8").startswith("time_s,x_mm,y_mm,force_N,point\n0.000,")


def test_the_truth_says_which_point_is_pressed(rig, nominal, tmp_path):
    still = humming(nominal.position[2])
    lifted = replace(still, force=np.where(still.time < 2, still.force, 0.0))
    path = record_contact(rig, lifted, tmp_path / "press.wav", QUIET)
    truth = np.genfromtxt(path, delimiter=",", names=True)
    assert set(truth["point"][truth["time_s"] < 1.9]) <= {0, 3}
    assert set(truth["point"][truth["time_s"] > 2.0]) == {0}


def test_the_example_recordings_are_small_and_of_no_machine():
    files = [path for path in EXAMPLES.rglob("*") if path.is_file()]
    assert sum(path.stat().st_size for path in files) < 2_000_000
    held = acoustic_fem.load(EXAMPLES / "library.nc")
    assert held.fidelity == "measured"
    traces = (b"/tmp/", b"/home/", str(EXAMPLES.parents[2]).encode())
    assert not [path for path in files for trace in traces if trace in path.read_bytes()]


@pytest.mark.physics
@pytest.mark.parametrize("leak", [0.0, 0.05])
def test_a_press_is_held_as_the_network_of_the_made_sensor_holds_it_and_rings_nowhere(tmp_path, leak):
    rig = Rig(small_design().with_values({"resonator.leak_diameter": leak}), 4, fidelity="lumped")
    time, rate = np.arange(12001) / 1e3, 1000
    place = response_of(acoustic_fem.solve(rig.design, GRID, "lumped")).position[1]
    held = 1e-3 * np.sin(np.pi / 2 * np.clip((time - 1.0) / 0.1, 0.0, 1.0)) ** 2
    contact = Contact(time, np.tile(place, (len(time), 1)), held, 0.1)
    path = tmp_path / "held.wav"
    record_contact(rig, contact, path, replace(QUIET, output="pressure", full_scale=100.0, bits=24))
    heard = localize.read_recording(path, rig.design.microphones, 100.0).signals

    # inverse transform of the network from 1 mHz, over a period of 1000 s
    solved = np.concatenate([np.arange(1, 2000) * 1e-3, np.arange(2, 20, 0.01), np.arange(20, 160.01, 0.1)])
    touched = batch_transfer_function(rig.hidden, rig.topology, solved, rig.medium)[0][1]
    design, air = rig.design, design_air(rig.design)
    for k, (gain, corner) in enumerate(zip(rig.gain, rig.corner, strict=True)):
        own = design.microphone.model_copy(update={"vent_corner": design.microphone.vent_corner * corner})
        touched[k] *= gain * response(own, solved, rig.medium) / response(design.microphone, solved, air)
    touched *= acoustic_fem.solve(design, solved, "lumped").cavity_response.values[1]
    lines = np.fft.rfftfreq(1000 * rate, 1 / rate)
    inside = lines <= 160
    through = np.zeros((len(touched), len(lines)), complex)
    through[:, inside] = CubicSpline(solved, touched, axis=-1)(np.maximum(lines[inside], 1e-3))
    through[:, 0] = through[:, 0].real
    expected = np.fft.irfft(through * np.fft.rfft(held, 1000 * rate), 1000 * rate)[:, : len(time)]
    expected -= expected[:, :500].mean(axis=1, keepdims=True)  # the mean of a period is not known
    until = 11500  # the reference rings before its force ends at once
    assert np.abs(heard - expected)[:, :until].max() < 5e-3 * np.abs(expected).max()
    assert np.abs(heard[:, :950]).max() < 2e-3 * np.abs(expected).max()

"""Contacts recorded with the virtual rig's sensor, and the example recordings that were made with it."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from small_run import small_design

import acoustic_fem
import localize
from acoustic_fem.network import output_response
from acoustic_fem.quantities.local_air import design_air
from localize.contacts import Contact, covered_force
from localize.signals.array_response import response_of
from studies.test_rig.rig_contacts import record_contact
from studies.test_rig.virtual_rig import Recorder, Rig

QUIET = Recorder(full_scale=50.0, hum=0.0, drift=0.0)
EXAMPLES = Path(__file__).parents[3] / "docs" / "examples" / "recordings"


@pytest.fixture(scope="module")
def rig():
    return Rig(small_design(), 4, fidelity="lumped")


@pytest.fixture(scope="module")
def nominal(rig):
    return response_of(acoustic_fem.solve(rig.design, np.array([1.0, 10.0, 20.0, 40.0, 100.0]), "lumped"))


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

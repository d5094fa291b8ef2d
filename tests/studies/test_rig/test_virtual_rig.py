"""Properties of a virtual as-built sensor that no fit knows: its rubber, the air of its place, a finger's contact."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from refusals import refused
from small_run import small_design

from acoustic_fem import LocalAir
from acoustic_fem.batch.elements import membrane_modulus
from acoustic_fem.calibration.manifest import read_manifest
from acoustic_fem.enclosed import enclosed_air
from acoustic_fem.membrane import design_mounting_ratio
from acoustic_fem.network import output_response
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.sound import transfer_estimate
from geometry import Kind
from localize.recordings.touch_manifest import Part
from studies.test_rig.rig_touches import SLOW, TouchSession, _pressure, _with_play
from studies.test_rig.virtual_rig import HiddenScatter, Recorder, Rig

STILL = HiddenScatter(
    bore=0.0, volume=0.0, membrane=0.0, gain=0.0, corner=0.0, chamber=0.0, length=0.0, loss=0.0, temperature=0.0,
    pressure=0.0, slope=0.0,
)  # fmt: skip
FLAT = TouchSession(tilt=0.0, press=0.0, hysteresis=0.0)
RATE, COUNT = 1000, 20_000


def modulus(scatter: HiddenScatter, *frequency: float) -> np.ndarray:
    return membrane_modulus(Rig(small_design(), 1, scatter, fidelity="lumped").hidden, np.array(frequency))[0, 0]


def contact(session: TouchSession, part: Part = "random-1-100", seed: int = 2) -> np.ndarray:
    draws = [np.random.default_rng(seed + k) for k in (0, 1)]
    return _pressure(part, COUNT, session, RATE, *draws)


def test_without_scatter_it_is_the_design() -> None:
    rig, grid = Rig(small_design(), 1, STILL, fidelity="lumped"), np.array([1.0, 10.0, 100.0])
    assert rig.medium.pressure == pytest.approx(101325.0)
    assert np.allclose(modulus(STILL, *grid), modulus(HiddenScatter(), *grid), rtol=0.1)
    assert rig.hidden.membrane_relaxation.shape[2] == 0


def test_its_rubber_rises_more_steeply_and_stays_causal() -> None:
    grid = np.geomspace(2.5, 40.0, 21)
    before, after = (modulus(scatter, *grid) for scatter in (STILL, replace(STILL, slope=0.02)))
    rig = Rig(small_design(), 1, replace(STILL, slope=0.02), fidelity="lumped")
    ratio = (
        rig.hidden.membrane_compliance[0, 0]
        / Rig(small_design(), 1, STILL, fidelity="lumped").hidden.membrane_compliance[0, 0]
    )
    stiffness = after / ratio
    assert np.abs(stiffness[10]) == pytest.approx(np.abs(before[10]), rel=1e-9)
    further = np.polyfit(np.log(grid), np.log(np.abs(stiffness) / np.abs(before)), 1)[0]
    assert 0.002 < further < 0.06
    # Kramers and Kronig, locally: a slope of n asks for an angle of n pi / 2
    assert np.mean(np.angle(stiffness) - np.angle(before)) == pytest.approx(np.pi / 2 * further, rel=0.1)


def test_a_worn_sensor_is_bulged_by_its_enclosed_air_each_membrane_by_its_stiffness() -> None:
    still = replace(STILL, batch=0.0)
    rested, worn = (
        Rig(small_design(), 1, each, fidelity="lumped") for each in (still, replace(still, warming=12.0, hours=0.0))
    )
    expected = enclosed_air(small_design(), LocalAir(temperature_c=32.0))
    assert worn.overpressure == pytest.approx(expected.overpressure)
    assert worn.medium.pressure == pytest.approx(101325.0 + worn.overpressure)
    softer = worn.hidden.membrane_compliance / rested.hidden.membrane_compliance
    assert softer == pytest.approx(np.full(softer.shape, expected.compliance_ratio))
    scattered = replace(still, membrane=0.1)
    flat, bulged = (
        Rig(small_design(), 1, each, fidelity="lumped").hidden for each in (scattered, replace(scattered, warming=12.0))
    )
    own, softer = flat.membrane_compliance[0], (bulged.membrane_compliance / flat.membrane_compliance)[0]
    assert (np.diff(softer[np.argsort(own)]) < 0).all()
    assert rested.overpressure == 0
    with refused(Kind.CONFLICT, "air.overpressure"):
        Rig(small_design().with_values({"air.overpressure": 10.0}), 1, replace(still, climb=100.0), fidelity="lumped")
    with refused(Kind.OUT_OF_RANGE, "humidity"):
        HiddenScatter(humidity=1.5)


def test_its_membranes_are_mounted_with_strain_and_on_glue() -> None:
    plain, mounted = (
        Rig(small_design(), 1, each, fidelity="lumped").hidden
        for each in (STILL, replace(STILL, prestrain=0.002, glue=0.1))
    )
    design = small_design().with_values({"membrane.prestrain": 0.002, "membrane.glue_thickness": 0.1})
    softer = mounted.membrane_compliance / plain.membrane_compliance
    assert softer == pytest.approx(np.full(softer.shape, design_mounting_ratio(design)))


def test_the_air_is_that_of_its_place() -> None:
    low, high = (
        Rig(small_design(), 1, replace(STILL, altitude=each), fidelity="lumped").medium.pressure
        for each in (0.0, 2000.0)
    )
    assert low == pytest.approx(101325.0)
    assert high == pytest.approx(79495.0, abs=1.0)
    weather = [
        Rig(small_design(), seed, replace(STILL, pressure=1000.0), fidelity="lumped").medium.pressure
        for seed in range(40)
    ]
    assert np.std(weather) == pytest.approx(1000.0, rel=0.4)


def test_what_it_has_beside_leaves_its_parts_as_they_were() -> None:
    rigs = [
        Rig(small_design(), 1, scatter, fidelity="lumped")
        for scatter in (HiddenScatter(), HiddenScatter(pressure=0.0, slope=0.0))
    ]
    assert np.array_equal(rigs[0].hidden.tube_radius, rigs[1].hidden.tube_radius)
    assert np.array_equal(rigs[0].gain, rigs[1].gain)


def test_the_spectrum_of_a_contact_is_not_flat_and_differs_from_take_to_take() -> None:
    def tilt(session: TouchSession, seed: int) -> float:
        power = np.abs(np.fft.rfft(contact(session, seed=seed))) ** 2
        grid = np.fft.rfftfreq(COUNT, 1 / RATE)
        low, high = (10 * np.log10(power[(grid > a) & (grid < 2 * a)].mean()) for a in (5.0, 40.0))
        return float(high - low) / 3

    assert abs(tilt(FLAT, 2)) < 0.7
    assert np.std([tilt(replace(FLAT, tilt=3.0), seed) for seed in range(2, 22, 2)]) == pytest.approx(3.0, rel=0.5)


def test_a_finger_presses_slowly_while_it_rubs() -> None:
    pressed = contact(replace(FLAT, press=0.2)) - contact(FLAT)
    power, grid = np.abs(np.fft.rfft(pressed)) ** 2, np.fft.rfftfreq(COUNT, 1 / RATE)
    assert power[(grid > SLOW[0] - 0.5) & (grid < SLOW[1] + 0.5)].sum() > 0.97 * power.sum()
    assert 0.1 < pressed.std() < 0.2


def test_pressure_follows_the_movement_with_hysteresis() -> None:
    time = np.arange(COUNT) / RATE
    movement = np.sin(2 * np.pi * 2 * time)
    followed = _with_play(movement, replace(FLAT, hysteresis=0.2))
    spectra = [np.fft.rfft(each)[COUNT * 2 // RATE] for each in (movement, followed)]
    assert -20.0 < np.degrees(np.angle(spectra[1] / spectra[0])) < -5.0  # it lags
    one = slice(COUNT // 2, COUNT // 2 + RATE // 2)
    loop = abs(np.trapezoid(followed[one], movement[one]))
    reach = 0.2 * movement.std()
    assert loop == pytest.approx(4 * reach * (1 - reach), rel=0.02)  # of a parallelogram
    assert np.array_equal(_with_play(movement, FLAT), movement)


def test_recordings_are_outputs_of_the_microphones_and_clip_at_their_overload() -> None:
    rig = Rig(small_design(), 1, fidelity="lumped")
    quiet = Recorder(seconds=20.0, hum=0.0, drift=0.0, reference_corner=0.0)
    pressure, voltage = (rig.signals(2, replace(quiet, output=output)) for output in ("pressure", "voltage"))
    np.testing.assert_array_equal(pressure[0], voltage[0])
    frequency = np.array([5.0, 20.0, 50.0, 100.0])
    found = transfer_estimate(pressure[1], voltage[1:2], 1000.0, frequency).transfer_function[0]
    microphone = rig.design.microphone
    np.testing.assert_allclose(found, output_response(microphone, frequency, design_air(rig.design)), rtol=0.01)
    # 20 times as loud as usual: some peaks are above a low overload
    deaf = small_design().with_values({"microphone.overload": 2.0})
    loud = Rig(deaf, 1, fidelity="lumped").signals(2, replace(quiet, level=7.0))
    assert np.abs(loud[1:]).max(1) == pytest.approx([2.0, 2.0])
    assert np.abs(loud[0]).max() > 20.0
    assert (np.abs(loud[1:]) == 2.0).mean() > 0.05


def test_the_table_of_the_calibration_microphone_is_its_response(tmp_path: Path) -> None:
    rig, recorder = Rig(small_design(), 1, fidelity="lumped"), Recorder(seconds=4.0, reference_corner=2.0)
    manifest = read_manifest(rig.record(tmp_path, [1], recorder))
    frequency = np.geomspace(0.5, 200.0, 50)
    assert manifest.response is not None
    np.testing.assert_allclose(manifest.response.at(frequency), recorder.reference_response(frequency), rtol=2e-4)
    assert abs(recorder.reference_response(np.array([2.0]))[0]) == pytest.approx(np.sqrt(0.5))
    for field, value in (("output", "volts"), ("reference_corner", -1.0)):
        with refused(Kind.OUT_OF_RANGE, field, value):
            Recorder(**{field: value})

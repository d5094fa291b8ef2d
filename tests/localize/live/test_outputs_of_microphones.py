"""Outputs of microphones are located as the pressures that they come from, and an overload is reported."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from rc_line import rc_line
from refusals import refused
from small_run import small_design

import acoustic_fem
import geometry
import localize
from acoustic_fem.library.transfer_functions import Library
from acoustic_fem.network import output_response
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.sound import write_wav
from geometry import Kind
from geometry.ground.typed import Array
from localize.contacts import Contact, ContactRecorder
from localize.live import Decision, Fault
from localize.signals.array_response import response_of

OVERLOAD = 2.0
#: Of the recordings, Pa: above the overload, so that the recorder does not clip.
FULL_SCALE = 4.0


@pytest.fixture(scope="module")
def library() -> Library:
    design = small_design().with_values({"microphone.overload": OVERLOAD})
    return acoustic_fem.solve(design, np.arange(1.0, 501.0), "lumped")


@pytest.fixture(scope="module")
def pressures(library: Library) -> tuple[Array, list[int]]:
    """Three touches of a second each between silences, (n_microphone, n_sample) Pa, and their points."""
    made = localize.TouchGenerator(response_of(library), 0, "evaluation", 0.0).samples(0, 30)
    loud = [int(k) for k in np.argsort(-made.signals.std(-1).amax(1).numpy())[:3]]
    signals = 1e-4 * np.random.default_rng(0).standard_normal((2, 12_000))
    for turn, sample in enumerate(loud):
        signals[:, 2000 + 3500 * turn :][:, :1000] += made.signals[sample].numpy()
    return signals, [int(made.point[k]) for k in loud]


def outputs(pressures: Array, library: Library) -> Array:
    grid = np.fft.rfftfreq(2 * pressures.shape[1], 1e-3)
    known = output_response(library.design.microphone, np.maximum(grid, 1e-3), design_air(library.design))
    spectrum = np.fft.rfft(pressures, 2 * pressures.shape[1]) * known
    return np.asarray(np.fft.irfft(spectrum)[:, : pressures.shape[1]])


def decisions(events: object) -> list[Decision]:
    return [event for event in events if isinstance(event, Decision)]  # type: ignore[attr-defined]


@pytest.mark.slow
def test_a_stream_decides_on_outputs_as_on_the_pressures(library: Library, pressures: tuple[Array, list[int]]) -> None:
    signals, points = pressures
    assert np.abs(outputs(signals, library)).max() < OVERLOAD
    usual = localize.open_model(library, microphone_noise=1e-4)
    equalising = localize.open_model(library, microphone_noise=1e-4, microphone_output="voltage")
    expected = decisions(usual.stream().push(signals))
    whole = outputs(signals, library)
    stream = equalising.stream()
    found = decisions([event for part in np.split(whole, [10, 777, 5000], 1) for event in stream.push(part)])
    both = [(a, b) for a, b in zip(expected, found, strict=True) if "touch" in (a.state, b.state)]
    assert len(both) > 150
    assert np.mean([a.point == b.point for a, b in both]) > 0.97
    # The high-pass of 1 Hz changes the level of slow parts a little.
    assert np.median([b.level / a.level for a, b in both]) == pytest.approx(1.0, abs=0.05)
    quiet = decisions(usual.stream().push(whole))
    assert np.median([b.level / a.level for a, b in zip(expected, quiet, strict=True) if a.state == "touch"]) < 0.9
    assert points


@pytest.mark.slow
def test_an_overloaded_frame_is_reported_and_has_no_other_point(
    library: Library, pressures: tuple[Array, list[int]], tmp_path: Path
) -> None:
    signals, points = pressures
    loud = outputs(signals, library)
    loud[:, 2000:4000] *= 1.5 * OVERLOAD / np.abs(loud[:, 2000:4000]).max()  # the first touch alone
    path = tmp_path / "loud.wav"
    write_wav(path, np.clip(loud, -OVERLOAD, OVERLOAD) / FULL_SCALE, 1000, 24)
    model = localize.open_model(library, microphone_noise=1e-4, microphone_output="voltage")
    found = model.locate_file(path, FULL_SCALE)
    faults = [event for event in found.events if isinstance(event, Fault)]
    assert {fault.kind for fault in faults} == {"clipped"}
    over = np.abs(loud).max(0) >= OVERLOAD
    for event in decisions(found.events):
        frame = slice(round(event.time * 1000) - 250, round(event.time * 1000))
        if over[frame].any():
            assert (event.state, event.point) in (("unreadable", None), ("touch", points[0]))
        elif event.time > 4.0:
            assert event.state != "unreadable"
    assert found.touches[-1].point == points[-1]
    # As pressures nothing is known of an overload.
    unaware = localize.open_model(library, microphone_noise=1e-4).locate_file(path, FULL_SCALE)
    assert len([event for event in decisions(unaware.events) if event.state == "unreadable"]) <= len(
        [event for event in decisions(found.events) if event.state == "unreadable"]
    )


@pytest.mark.slow
def test_a_press_that_is_clipped_while_it_rises_is_located_by_the_other_samples() -> None:
    design = geometry.prototype("array-2x6")
    library = acoustic_fem.solve(design, np.arange(1.0, 501.0), "lumped")
    model = localize.open_model(library, tolerances=False, microphone_output="voltage")
    unaware = localize.open_model(library, tolerances=False)
    time = np.arange(3000) / 1000
    ramp = np.clip(np.minimum((time - 1) / 0.15, (1.9 - time) / 0.15), 0, 1)
    response, overload = response_of(library), design.microphone.overload
    assert response.position is not None
    recorder = ContactRecorder(response)
    wrong = 0
    for point in (2, 4, 9):
        place = np.tile(response.position[point - 1], (3000, 1))
        press = recorder.take(Contact(time, place, 0.5 * np.sin(np.pi / 2 * ramp) ** 2, 1.5)).signals
        clipped = np.clip(outputs(press, library), -overload, overload)[:, :1700]
        assert (np.abs(clipped) == overload).any(0).sum() > 90
        found = decisions(model.stream().push(clipped))
        assert {event.point for event in found if event.state == "touch"} == {point}
        assert found[-1].state in ("no touch", "unreadable")
        # What the equaliser makes of clipped samples names other points for a while.
        equaliser = model.decoding.equaliser(model.locator.array)
        assert equaliser is not None
        spread = decisions(unaware.stream().push(equaliser.begin(clipped)))
        wrong += sum(event.state == "touch" and event.point != point for event in spread if event.time > 1.4)
    assert wrong > 10


def test_an_array_without_a_design_cannot_be_equalised() -> None:
    decoder = localize.BayesDecoder(rc_line(3), 1e-3)
    model = localize.open_model(decoder, microphone_output="voltage")
    with refused(Kind.MISSING, "design"):
        model.stream()
    for field, value in (("lowest", 0.0), ("microphone_output", "volts")):
        with refused(Kind.OUT_OF_RANGE, field, value):
            replace(model.decoding, **{field: value})

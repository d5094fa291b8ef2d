"""One door to a model: what is opened, by its content and once, and what it takes in memory."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from refusals import refused
from shared import solved

import acoustic_fem
import geometry
import localize
import studies
from acoustic_fem import LocalAir
from acoustic_fem.library import exchange
from acoustic_fem.library.transfer_functions import MEASURED, Library, measured_library
from acoustic_fem.sound import write_wav
from geometry import Kind, Refusal
from localize.model.opening import opened_as_designed
from localize.signals.array_response import response_of

GRID = np.arange(1.0, 101.0, 3.0)
NOISE = 1e-3


def calibrated(name: str = "array-2x6") -> Library:
    nominal = solved(name, GRID)
    h = nominal.transfer_function.values
    return measured_library(nominal.design, nominal, h, 0.01 * np.abs(h), ("numpy",), {})


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Libraries and a graph with names that say nothing, and a recording of a touch."""
    made = tmp_path_factory.mktemp("models")
    library = calibrated()
    for suffix in ("nc", "sofa", "npz", "csv"):
        exchange.export(library, made / f"library.{suffix}")
    localize.export_onnx(localize.BayesDecoder(library, NOISE), made / "decoder.onnx")
    touch = localize.TouchGenerator(response_of(library), 1, "evaluation", NOISE).samples(3, 1).signals[0].numpy()
    write_wav(made / "touch.wav", touch.astype(np.float64) / 20, 1000)
    return made


@pytest.mark.parametrize("name", ["library.nc", "library.sofa", "library.npz", "library.csv", "decoder.onnx"])
@pytest.mark.parametrize("suffix", ["", ".onnx", ".dat"])
def test_a_file_is_known_by_its_content(folder: Path, tmp_path: Path, name: str, suffix: str) -> None:
    path = tmp_path / f"mylib{suffix}"
    shutil.copy(folder / name, path)
    model = localize.open_model(path)
    assert model.locator.kind == "model-based decoder"
    assert (model.library is None) == (name == "decoder.onnx")
    assert model.files == (path,)


def test_what_holds_no_model_is_refused(tmp_path: Path) -> None:
    with refused(Kind.UNREADABLE, file=tmp_path):
        localize.open_model(tmp_path)
    path = tmp_path / "model"
    for content in (b"", b"\0\1\2\3"):
        path.write_bytes(content)
        with refused(Kind.UNREADABLE, file=path, error=acoustic_fem.LibraryError):
            localize.open_model(path)
    for content, error in ((b"\x08\x0a\x12", localize.LocalizerError), (b"a,b\n1,2\n", acoustic_fem.LibraryError)):
        path.write_bytes(content)
        with pytest.raises(error):
            localize.open_model(path)


def test_a_library_is_read_once_by_every_verb(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    read: list[Path] = []
    load = acoustic_fem.load
    monkeypatch.setattr(acoustic_fem, "load", lambda path: (read.append(path), load(path))[1])
    library, touch = folder / "library.nc", folder / "touch.wav"
    decoding = studies.Decoding(air=LocalAir(altitude=1000.0), ambient=60.0)
    studies.locate_recording(library, touch, full_scale=20.0, decoding=decoding)
    studies.listen(library, studies.LiveInput(replay=touch, full_scale=20.0), decoding=decoding, contact_radius_mm=4.0)
    studies.track_recording(library, touch, full_scale=20.0)
    assert read == [library] * 3


def test_what_is_in_memory_answers_as_its_file_does(folder: Path) -> None:
    library, touch = folder / "library.nc", folder / "touch.wav"
    decoding = studies.Decoding(microphone_noise=NOISE)
    by_path = studies.locate_recording(library, touch, full_scale=20.0, decoding=decoding)
    assert by_path.touches
    loaded = acoustic_fem.load(library)
    for found in (
        studies.locate_recording(loaded, touch, full_scale=20.0, decoding=decoding),
        studies.locate_recording(localize.open_model(loaded, microphone_noise=NOISE), touch, full_scale=20.0),
        localize.open_model(library, microphone_noise=NOISE).locate_file(touch, 20.0),
    ):
        assert found.events == by_path.events
        assert found.touches == by_path.touches
        assert found.assumptions == by_path.assumptions
    assert by_path.options["stream"].follow is False
    assert by_path.options["decoder"] == localize.DecoderOptions()
    decoder = localize.BayesDecoder(loaded, NOISE)
    (one,) = studies.locate_recording(decoder, touch, full_scale=20.0).touches
    assert one.point == by_path.touches[0].point
    frame = localize.read_recording(touch, decoder.microphones, 20.0).signals[:, 250:500]
    assert np.array_equal(localize.open_model(decoder).locate(frame), decoder.locate(frame))


@pytest.mark.slow
def test_tracks_pulses_and_exports_take_what_is_in_memory(folder: Path, tmp_path: Path) -> None:
    library = acoustic_fem.load(folder / "library.nc")
    model, touch = localize.open_model(library), folder / "touch.wav"
    tracks = [studies.track_recording(each, touch, full_scale=20.0) for each in (folder / "library.nc", library, model)]
    assert len({len(each.tracks) for each in tracks}) == 1
    for number, each in enumerate((folder / "library.nc", library, model)):
        studies.export_decoder(each, tmp_path / f"{number}.onnx")
        studies.embed_decoder(each, tmp_path / f"{number}")
    texts = [(tmp_path / f"{number}" / "touch_tables.c").read_bytes() for number in range(3)]
    assert texts[0] == texts[1] == texts[2]
    assert localize.open_model(tmp_path / "2.onnx").locator.design == library.design.name
    judged = studies.evaluate_localizer(
        localize.BayesDecoder(library, NOISE), library, touches=5, microphone_noise=NOISE
    )
    assert judged["model-based decoder"].top1 == judged["Bayes decoder"].top1


@pytest.mark.slow
def test_a_model_that_holds_its_library_is_evaluated_with_it(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    read: list[object] = []
    load = acoustic_fem.load
    monkeypatch.setattr(acoustic_fem, "load", lambda path: read.append(path) or load(path))
    path = folder / "library.nc"
    alone = studies.evaluate_localizer(path, touches=5, microphone_noise=NOISE)
    beside = studies.evaluate_localizer(path, str(path), touches=5, microphone_noise=NOISE)
    assert len(read) == 2
    opened = studies.evaluate_localizer(
        localize.open_model(calibrated(), microphone_noise=NOISE), touches=5, microphone_noise=NOISE
    )
    assert len({each["Bayes decoder"].top1 for each in (alone, beside, opened)}) == 1
    with refused(Kind.MISSING, "library"):
        studies.evaluate_localizer(folder / "decoder.onnx", touches=5)
    with refused(Kind.WRONG_TYPE, "model", 3):
        studies.evaluate_localizer(3)
    with refused(Kind.OUT_OF_RANGE, "microphone_noise", -1):
        studies.evaluate_localizer(path, touches=5, microphone_noise=-1)


@pytest.mark.parametrize(
    ("name", "state"), [pytest.param("glove", "no touch", marks=pytest.mark.slow), ("array-2x6", "unreadable")]
)
def test_a_library_of_three_microphones_goes_on_without_one_that_is_dead(name: str, state: str) -> None:
    stream = localize.open_model(solved(name, np.arange(1.0, 101.0))).stream()
    samples = 7e-4 * np.random.default_rng(0).standard_normal((len(stream.locator.microphones), 300))
    samples[0] = 0.0
    assert {event.state for event in stream.push(samples) if isinstance(event, localize.Decision)} == {state}


def test_a_drift_is_followed_about_a_calibrated_library_alone(folder: Path, tmp_path: Path) -> None:
    model = localize.open_model(calibrated(), microphone_noise=NOISE, follow_drift=True)
    assert isinstance(model.locator, localize.DriftDecoder)
    assert model.stream().push(7e-4 * np.random.default_rng(0).standard_normal((2, 300)))
    acoustic_fem.save(solved("array-2x6", GRID), tmp_path / "computed.nc")
    with refused(Kind.UNSUITABLE, file=tmp_path / "computed.nc"):
        localize.open_model(tmp_path / "computed.nc", follow_drift=True)
    with refused(Kind.CONFLICT, "follow_drift"):
        localize.open_model(folder / "decoder.onnx", follow_drift=True)


@pytest.mark.slow
def test_a_drift_is_followed_on_where_a_microphone_dies_and_the_model_keeps_nothing() -> None:
    library = calibrated("glove")
    model = localize.open_model(library, microphone_noise=NOISE, follow_drift=True)
    touch = (
        localize.TouchGenerator(response_of(library), 1, "training", NOISE).samples(3, 1).signals[0].double().numpy()
    )
    touch[0] = 0.0
    stream = model.stream()
    assert any(event.state == "touch" for event in stream.push(touch) if isinstance(event, localize.Decision))
    assert not np.array_equal(stream.state, model.locator.start)  # what the others heard moved the belief
    assert np.array_equal(model.stream().state, model.locator.start)


@pytest.mark.slow
def test_a_library_is_decoded_with_the_tolerances_until_its_sensor_is_measured() -> None:
    library = solved("array-2x6", np.arange(1.0, 101.0))
    assert type(localize.open_model(library, microphone_noise=NOISE).locator) is localize.TolerantDecoder
    measured = replace(library, fidelity=MEASURED)
    for model in (
        localize.open_model(measured, microphone_noise=NOISE),
        localize.open_model(library, microphone_noise=NOISE, tolerances=False),
        opened_as_designed(localize.open_model(library, microphone_noise=NOISE)),
    ):
        assert type(model.locator) is localize.BayesDecoder
        assert model.locator.microphone_noise == NOISE


def test_assumptions_and_warnings_are_those_of_the_model(folder: Path) -> None:
    library = solved("array-2x6", np.arange(1.0, 101.0))
    model = localize.open_model(replace(library, fidelity=MEASURED))
    assert model.assumptions == "that the sensor is as its library describes it, in air of 101.3 kPa"
    assert model.warnings == ()
    dome = replace(library, design=library.design.with_values({"resonator.shape": "dome"}))
    model = localize.open_model(dome)
    assert "resonator.shape" in model.assumptions
    assert len(model.warnings) == 1
    assert "within manufacturing tolerances" in localize.open_model(library).assumptions
    exactly = localize.open_model(library, tolerances=False).assumptions
    assert exactly.endswith("without manufacturing tolerances")
    # A graph is of the library as it is, and says so wherever it is read.
    assert localize.open_model(folder / "decoder.onnx").assumptions.startswith(
        "that the sensor is as its library describes it"
    )


def test_what_is_for_a_library_alone_is_refused_of_others(folder: Path) -> None:
    graph = folder / "decoder.onnx"
    with refused(Kind.CONFLICT, "microphone_noise", NOISE):
        localize.open_model(graph, microphone_noise=NOISE)
    with refused(Kind.CONFLICT, "altitude", 500.0):
        localize.open_model(graph, air=LocalAir(altitude=500.0))
    for field, value in (("ambient", 60.0), ("waveform", True), ("rejected_fraction", 1e-3)):
        with refused(Kind.MISSING, field):
            localize.open_model(graph, **{field: value})
    beside = localize.open_model(graph, ambient=60.0, library=folder / "library.nc")
    assert beside.library is not None
    assert beside.files == (graph, folder / "library.nc")
    with refused(Kind.UNSUITABLE, "model"):
        localize.open_model(graph).tracker(4.0)
    with refused(Kind.CONFLICT, "ambient", 70.0):
        studies.locate_recording(beside, folder / "touch.wav", decoding=studies.Decoding(ambient=70.0))
    with refused(Kind.UNSUITABLE, "library"):
        studies.embed_decoder(localize.OnnxLocalizer(graph), folder / "c")


def test_a_recording_that_is_not_there_is_refused_before_anything_is_opened(tmp_path: Path) -> None:
    for name in ("taps.wav", "taps.mp3"):
        with pytest.raises(Refusal, match=name):
            studies.locate_recording(tmp_path / "library.nc", tmp_path / name)


def test_sound_and_noise_that_cannot_be_assumed_are_refused_by_the_name_of_their_argument() -> None:
    library: Any = solved("array-2x6", GRID)
    calls: tuple[Callable[[Any], object], ...] = (
        lambda given: localize.open_model(library, ambient=given),
        lambda given: studies.Decoding(ambient=given),
        lambda given: localize.BayesDecoder(library, NOISE, given),
        lambda given: localize.ResidualTest(library, NOISE, ambient=given),
        lambda given: localize.tracking.PathTracker(library, ambient=given),
        lambda given: localize.tracking.track(library, np.zeros((2, 1000)), ambient=given),
    )
    for call in calls:
        for level in (500, -1, "x"):
            with refused(Kind.WRONG_TYPE if level == "x" else Kind.OUT_OF_RANGE, "ambient", level):
                call(level)
        with refused(Kind.OUT_OF_RANGE, "ambient"):
            call(float("nan"))
    decoder = localize.BayesDecoder(library, NOISE)
    simulations: tuple[Callable[[], object], ...] = (
        lambda: localize.evaluate(decoder, library, 1, NOISE, ambient=500.0),
        lambda: localize.contacts.ContactRecorder(library, ambient=500.0),
    )
    for simulate in simulations:
        with refused(Kind.OUT_OF_RANGE, "ambient", 500.0):
            simulate()
    assert localize.open_model(library, microphone_noise=NOISE, ambient=140, tolerances=False).decoding.ambient == 140
    for noise in (-1, "x", None):
        kind = Kind.OUT_OF_RANGE if noise == -1 else Kind.WRONG_TYPE
        with refused(kind, "microphone_noise", noise):
            localize.open_model(library, microphone_noise=noise)
        with refused(kind, "microphone_noise", noise):
            response_of(library).noise(noise)
    with refused(Kind.OUT_OF_RANGE, "microphone_noise", 0):
        localize.open_model(library, microphone_noise=0)
    with refused(Kind.WRONG_TYPE, "microphone_noise"):
        localize.open_model(library, microphone_noise=np.ones(3))
    with refused(Kind.OUT_OF_RANGE, "microphone_noise"):
        localize.open_model(library, microphone_noise=float("nan"))


@pytest.mark.parametrize("given", [None, 3, geometry.prototype("line-2")])
def test_what_is_no_model_no_library_and_no_design_is_refused(given: Any) -> None:
    library = solved("array-2x6", GRID)
    with refused(Kind.WRONG_TYPE, "source", given):
        localize.open_model(given)
    with refused(Kind.WRONG_TYPE, "path", given):
        acoustic_fem.load(given)
    if given is not None:
        with refused(Kind.WRONG_TYPE, "library", given):
            localize.open_model(library, library=given)
    if not isinstance(given, geometry.ArrayDesign):
        for call in (lambda: acoustic_fem.solve(given, GRID), lambda: studies.check_design(given)):
            with refused(Kind.WRONG_TYPE, "design", given):
                call()


@pytest.mark.parametrize("signals", ["x", None, {"A": 1}, [[1.0, 2.0], [1.0]], np.ones((2, 250), complex)])
def test_signals_that_are_no_numbers_are_refused(signals: Any) -> None:
    with refused(Kind.WRONG_TYPE, "signals"):
        localize.open_model(calibrated(), microphone_noise=NOISE).locate(signals)


@pytest.mark.parametrize("radius", [float("nan"), 0.0, "x"])
def test_a_radius_that_no_contact_has_is_refused(radius: Any) -> None:
    library = solved("array-2x6", GRID)
    kind = Kind.WRONG_TYPE if radius == "x" else Kind.OUT_OF_RANGE
    with refused(kind, "contact_radius_mm"):
        localize.tracking.PathTracker(library, radius)
    with refused(kind, "contact_radius_mm"):
        localize.open_model(library, tolerances=False).tracker(radius)


def test_an_open_model_names_the_argument_that_comes_too_late() -> None:
    library = calibrated()
    model = localize.open_model(library, microphone_noise=NOISE)
    assert localize.open_model(model, microphone_noise=NOISE) is model
    for name, value in (("microphone_noise", 2e-3), ("ambient", 60.0), ("waveform", True), ("tolerances", False)):
        given: dict[str, Any] = {name: value}
        with refused(Kind.CONFLICT, name, value):
            localize.open_model(model, **given)
    with refused(Kind.CONFLICT, "air"):
        localize.open_model(model, air=LocalAir(altitude=1000.0))

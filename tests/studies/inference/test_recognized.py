"""Settings of the place, noise and air, reach the recognizer of kinds."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from refusals import refused
from shared import solved

import acoustic_fem
import studies
from acoustic_fem.quantities.local_air import LocalAir
from acoustic_fem.sound import write_wav
from geometry import Kind


@pytest.mark.parametrize(
    ("options", "field", "value"),
    [
        ({"point": 3}, "point", 3),
        ({"decoding": studies.Decoding(ambient=60.0)}, "ambient", 60.0),
        ({"speed": 12.0}, "speed", 12.0),
    ],
)
@pytest.mark.slow
def test_what_says_nothing_of_letters_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, options: dict, field: str, value: float
) -> None:
    library = solved("array-2x6", np.arange(1.0, 101.0, 3.0))
    acoustic_fem.save(library, tmp_path / "library.nc")
    write_wav(tmp_path / "take.wav", 1e-3 * np.random.default_rng(0).standard_normal((2, 400)), 1000)
    own = SimpleNamespace(
        microphones=("A", "B"), design=library.design.name, at_usual_speed=False, labels=(), subject="letters"
    )
    monkeypatch.setattr("localize.load_recognizer", lambda _: own)
    with refused(Kind.CONFLICT, field, value):
        studies.recognize_recording("model", tmp_path / "library.nc", tmp_path / "take.wav", **options)


@pytest.mark.slow
def test_kinds_are_told_in_the_noise_and_air_of_the_place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    library = solved("array-2x6", np.arange(1.0, 101.0, 3.0))
    acoustic_fem.save(library, tmp_path / "library.nc")
    write_wav(tmp_path / "take.wav", 1e-3 * np.random.default_rng(0).standard_normal((2, 400)), 1000)
    own = SimpleNamespace(
        microphones=("A", "B"), design=library.design.name, at_usual_speed=False, labels=(), subject="events"
    )
    ears = []

    class FakeFilters:
        def __init__(self, *given: object) -> None:
            ears.append(given)

        def touches(self, *_: object) -> tuple[()]:
            return ()

    monkeypatch.setattr("localize.load_recognizer", lambda _: own)
    monkeypatch.setattr("localize.recognition.filter_bank.FilterBank", FakeFilters)
    there = studies.Decoding(microphone_noise=2e-3, ambient=60.0, air=LocalAir(pressure=8e4))
    for decoding in (there, None):
        studies.recognize_recording("model", tmp_path / "library.nc", tmp_path / "take.wav", decoding=decoding)
    assert [noise for _, _, noise in ears] == [2e-3, None]
    assert [array.medium.pressure for array, _, _ in ears] == [8e4, library.medium.pressure]

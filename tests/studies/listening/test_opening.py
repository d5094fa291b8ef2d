"""What a library opens goes on without a microphone, where it has three."""

from __future__ import annotations

import numpy as np
import pytest
from shared import solved

import acoustic_fem
import localize
from studies.listening.opening import Decoding, open_localizer, open_stream


@pytest.mark.parametrize(("name", "state"), [("glove", "no touch"), ("array-2x6", "unreadable")])
def test_a_library_of_three_microphones_goes_on_without_one_that_is_dead(tmp_path, name, state) -> None:
    path = tmp_path / "library.nc"
    acoustic_fem.save(solved(name, np.arange(1.0, 101.0)), path)
    localizer = open_localizer(path, None, None)
    samples = 7e-4 * np.random.default_rng(0).standard_normal((len(localizer.microphones), 300))
    samples[0] = 0.0
    events = open_stream(path, localizer, Decoding()).push(samples)
    assert {event.state for event in events if isinstance(event, localize.Decision)} == {state}

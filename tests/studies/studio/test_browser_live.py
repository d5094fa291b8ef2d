"""Live listening in the browser: what a sound card hears is decoded, drawn and played with while it comes."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from browser import PAINTED, ROOT, Studio, give, lit, opened, panel, shown, studio, until, until_lit
from scipy.io import wavfile

from acoustic_fem.sound.sound_file import write_wav
from geometry import prototype
from studies.panels.touching import simulate_touch

pytestmark = [pytest.mark.slow, pytest.mark.end_to_end]
FULL_SCALE = 500.0
#: Points that a finger taps, one after the other.
TAPPED = (5, 2, 9)


@pytest.fixture(scope="module")
def taps(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recording of taps, some seconds long."""
    path = tmp_path_factory.mktemp("taps") / "taps.wav"
    takes = [simulate_touch(prototype("array-2x6"), point, "tap", sample) for sample, point in enumerate(TAPPED * 4, 1)]
    signals = [np.frombuffer(each["signals"], "<f4").reshape(len(each["microphones"]), -1) for each in takes]
    write_wav(path, np.concatenate(signals, axis=1) / FULL_SCALE, 1000, bits=32)
    return path


@pytest.fixture(scope="module")
def with_card(taps: Path) -> Iterator[Studio]:
    """A studio on a machine whose sound card hears the taps again and again, each time that somebody listens."""
    with studio(module="sound_card", STUDIO_TAPS=str(taps)) as found:
        yield found


@pytest.fixture
def listening(browser: Any, with_card: Studio) -> Iterator[Any]:
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    page = opened(context, with_card)
    panel(page, "touch")
    until(page, f"{ROOT}.shown_surface === '0'")
    page.fill("#full-scale", f"{FULL_SCALE:g}")
    yield page
    assert page.problems == []
    context.close()


def test_a_tap_that_a_sound_card_hears_lights_its_membrane_under_all_waveforms(listening: Any) -> None:
    assert not lit(listening.locator("#plan").screenshot()).any()
    listening.click("#live")
    for point in TAPPED[:2]:
        until(listening, f"document.getElementById('answer').textContent.startsWith('point {point} ')")
    picture = lit(listening.locator("#waves").screenshot())
    for waveform in np.split(picture[: len(picture) // 2 * 2], 2):  # neither of them a flat line
        assert np.count_nonzero(waveform.any(axis=1)) > 5
    give(listening, "tube.length", "13")
    until(listening, "document.querySelector(`[data-problem='live']`).textContent.includes('the design was changed')")
    assert listening.locator("#live").get_attribute("aria-pressed") == "false"
    shown(listening, "surface")
    until(listening, PAINTED)
    listening.click("#live")  # the sound card was given back
    until(listening, "document.getElementById('answer').textContent.startsWith('point ')")
    listening.click("#live")
    until(listening, "document.getElementById('live').getAttribute('aria-pressed') === 'false'")


def test_the_game_is_played_with_what_a_sound_card_hears_and_with_a_recording(listening: Any, taps: Path) -> None:
    listening.click("#game")
    assert listening.locator("#score").inner_text().endswith("still to come: 10.")
    listening.set_input_files("#replay", taps)
    over = "document.getElementById('score').textContent.match(/^Over: [0-9]+ of 10 moles hit/)"
    until(listening, over)
    listening.click("#game")
    listening.click("#live")
    until(listening, "document.getElementById('score').textContent.endsWith('still to come: 7.')")
    listening.click("#live")


def test_a_touch_is_heard_at_once_though_a_recording_is_played(listening: Any, taps: Path, tmp_path: Path) -> None:
    rate, samples = wavfile.read(taps)
    wavfile.write(tmp_path / "long.wav", rate, np.tile(samples, (5, 1)))
    listening.evaluate("""() => {
      window.said = [];
      const answer = document.getElementById("answer");
      new MutationObserver(() => window.said.push(answer.textContent)).observe(answer, { childList: true });
    }""")
    listening.set_input_files("#replay", tmp_path / "long.wav")
    until_lit(listening.locator("#plan"), 50, 600)
    listening.locator("#touch-points button").nth(6).click()
    until(listening, "window.said.some((each) => each.startsWith('A tap on point 7'))")
    assert not listening.evaluate("window.said.some((each) => each.startsWith('long.wav'))")

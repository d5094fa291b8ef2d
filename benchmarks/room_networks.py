"""Networks in the sound of rooms: trained in silence and in rooms, judged over levels of sound and of touches.

``python benchmarks/room_networks.py`` writes the tables of docs/localizer.md, in about ten minutes of one core. Touches
are the library's own sums of sines, and the same on sensors drawn with the workshop's tolerances (benchmarks/rooms.py).
No constant was chosen on these seeds.
"""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
from rooms import made_sensors

import acoustic_fem
import geometry
import localize
from geometry.files.writing import replace_section
from localize.decoders import ROOM
from localize.evaluation.accuracy import wilson_interval
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.finger_stimuli import Louder
from localize.signals.stimulus import multi_sines
from localize.signals.touch_generator import TouchGenerator

PAGE = Path(__file__).parents[1] / "docs" / "localizer.md"
BEGIN, END = "<!-- rooms: made by benchmarks/room_networks.py -->", "<!-- end rooms -->"
SCALE_BEGIN, SCALE_END = "<!-- louder: made by benchmarks/room_networks.py -->", "<!-- end louder -->"
FREQUENCY = np.concatenate([np.arange(0.25, 20.0, 0.25), np.arange(20.0, 501.0)])
DESIGNS, NOISE, TRAINED, JUDGED, TOUCHES = ("array-2x6", "glove"), 1e-3, 7, 8100, 1200
LEVELS = (None, 50.0, 60.0, 70.0, 80.0, 90.0)
#: dB above the paper's numbers read as Pa; 12 to 22 is what its signal-to-noise ratio suggests.
LOUDER, LOUD = (0.0, 6.0, 12.0, 17.0, 22.0), 90.0


def share(locator: localize.BayesDecoder, arrays: list[ArrayResponse], sound: float | None, louder: float = 0.0) -> str:
    """Touches named right, %, with the half width of the interval over touches."""
    touches = max(1, TOUCHES // (len(arrays) * arrays[0].point_count))
    source = Louder(multi_sines, louder)
    found = [
        localize.evaluate(locator, each, touches, NOISE, seed=JUDGED + k, stimuli=source, ambient=sound)
        for k, each in enumerate(arrays)
    ]
    top1 = float(np.mean([each.top1 for each in found]))
    low, high = wilson_interval(top1, touches * len(arrays) * arrays[0].point_count)
    return f"{100 * top1:.1f} ± {50 * (high - low):.1f}"


def ratio(response: ArrayResponse, louder: float) -> str:
    """Level of touches over that of the sound of :data:`LOUD` dB at the microphones, dB: median of touches."""

    def power(stimuli: object, sound: float | None) -> np.ndarray:
        levels = None if sound is None else (sound, sound)
        made = TouchGenerator(response, JUDGED, "evaluation", stimuli=stimuli, ambient=levels).samples(0, 600)
        return made.signals[..., -250:].square().mean((-2, -1)).numpy()

    touch = power(Louder(multi_sines, louder), None)
    sound = power(Louder(multi_sines, -60.0), LOUD)
    return f"{10 * np.log10(np.median(touch / sound)):.0f}"


def main() -> None:
    warnings.filterwarnings("ignore", "entrance loss", UserWarning)
    titles = ["none" if level is None else f"{level:g}" for level in LEVELS]
    lines = [f"| sound (dB SPL) | {' | '.join(titles)} |", "|---" * (len(LEVELS) + 1) + "|"]
    scaled = [f"| touches louder by (dB) | {' | '.join(f'{level:g}' for level in LOUDER)} |", "|---" * 6 + "|"]
    for name in DESIGNS:
        design = geometry.prototype(name)
        response = response_of(acoustic_fem.solve(design, FREQUENCY, "lumped"))
        made = made_sensors(response, design)
        deaf, heard = (
            localize.train(response, localize.TrainingPlan(seed=TRAINED, microphone_noise=NOISE, ambient=ambient))
            for ambient in (None, "rooms")
        )
        decoder = localize.BayesDecoder(response, NOISE, ambient=ROOM)
        rows = {
            "network trained in silence": (deaf, [response]),
            "network trained in rooms": (heard, [response]),
            "decoder told of rooms": (decoder, [response]),
            "mis-made sensors: network trained in silence": (deaf, made),
            "mis-made sensors: network trained in rooms": (heard, made),
        }
        for title, (locator, arrays) in rows.items():
            lines.append(f"| {name}: {title} | {' | '.join(share(locator, arrays, level) for level in LEVELS)} |")
            print(lines[-1], flush=True)
        at_ninety = [ratio(response, level) for level in LOUDER]
        scaled.append(f"| {name}: touches over sound of 90 dB SPL at the microphones (dB) | {' | '.join(at_ninety)} |")
        for title in ("network trained in silence", "network trained in rooms", "decoder told of rooms"):
            locator, arrays = rows[title]
            cells = " | ".join(share(locator, arrays, LOUD, level) for level in LOUDER)
            scaled.append(f"| {name}: {title} | {cells} |")
        print("\n".join(scaled), flush=True)
    replace_section(PAGE, BEGIN, END, lines)
    replace_section(PAGE, SCALE_BEGIN, SCALE_END, scaled)


if __name__ == "__main__":
    main()

"""Touches in room sound: how often they are taken for sound, and how often they are located correctly.

``python benchmarks/rooms.py`` writes the table of docs/evidence/decoder.md, in some minutes of one core.

Frames have 250 ms, with pink sound of 20 to 500 Hz and 1 mPa of microphone noise, at lumped fidelity. As-built sensors
have the workshop's tolerances, and the gains of their microphones deviate by 5 %. No constant was chosen on the seed.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

import acoustic_fem
import geometry
import localize
from acoustic_fem.batch.network import batch_response
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter.tolerances import ScatteredDesign
from geometry.ground.whole_files import replace_section
from localize.decoders.surroundings import ROOM
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.stimulus import Stimuli, multi_sines
from localize.signals.touch_generator import TouchGenerator

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "decoder.md"
BEGIN, END = "<!-- rooms: made by benchmarks/rooms.py -->", "<!-- end rooms -->"
FREQUENCY = np.concatenate([np.arange(0.25, 20.0, 0.25), np.arange(20.0, 501.0)])
DESIGNS, NOISE, SEED, FRAMES = ("array-2x6", "line-2"), 1e-3, 11, 1000
LEVELS = (None, 50.0, 70.0, 80.0, 90.0)
SENSORS, GAIN = 12, 0.05


def nothing(
    seed: int, purpose: str, start: int, count: int, band: tuple[float, float], device: str | torch.device
) -> Stimuli:
    """No touch."""
    made = multi_sines(seed, "evaluation", start, count, band, device)
    return replace(made, spectrum=torch.zeros_like(made.spectrum))


def made_sensors(response: ArrayResponse, design: geometry.ArrayDesign) -> list[ArrayResponse]:
    """The array as it may come out, sound included."""
    scattered, air = ScatteredDesign(design), design_air(design)
    draws = scattered.draws(0, SENSORS, SEED)
    nominal, made = (
        batch_response(
            scattered.parameters({name: share * values for name, values in draws.items()}),
            scattered.topology, FREQUENCY, air,
        )
        for share in (0.0, 1.0)
    )  # fmt: skip
    assert response.ambient_response is not None
    # Sound pushes each membrane by its own compliance.
    push = made.source_response * scattered.parameters(draws).membrane_compliance[:, :, None, None]
    still = nominal.source_response * scattered.nominal.membrane_compliance[:, :, None, None]
    gain = 1 + GAIN * np.random.default_rng(SEED).standard_normal((SENSORS, len(response.microphones), 1))
    ambient = gain * response.ambient_response * (push.sum(1) / still.sum(1))
    return [
        replace(response, transfer_function=gain[k] * made.transfer_function[k], ambient_response=ambient[k])
        for k in range(SENSORS)
    ]


def frames(response: ArrayResponse, level: float | None, touched: bool, count: int) -> tuple[Tensor, NDArray[np.int64]]:
    sound = None if level is None else (level, level)
    stimuli = multi_sines if touched else nothing
    made = TouchGenerator(response, SEED, "evaluation", NOISE, ambient=sound, stimuli=stimuli).samples(0, count)
    return made.signals[..., -250:], made.point.numpy() - 1


def rows(name: str) -> list[str]:
    design = geometry.prototype(name)
    response = response_of(acoustic_fem.solve(design, FREQUENCY, "lumped"))
    deaf, in_room = localize.BayesDecoder(response, NOISE), localize.BayesDecoder(response, NOISE, ambient=ROOM)
    test = localize.SoundTest(response, NOISE)
    sensors = made_sensors(response, design)
    cells: dict[str, list[str]] = {}

    def add(title: str, share: float) -> None:
        cells.setdefault(title, []).append(f"{100 * share:.1f}")

    for level in LEVELS:
        alone = [test.is_sound(frames(each, level, False, FRAMES // SENSORS)[0]).mean() for each in sensors]
        print(
            f"{name}: sound alone called sound, worst made sensor, {level} dB SPL: {100 * min(alone):.1f} %", flush=True
        )
        signals, point = frames(response, level, True, FRAMES)
        heard = ~test.is_sound(signals)
        add("touches not classified as sound", heard.mean())
        add("top-1, no sound configured", (deaf.locate(signals).argmax(1) == point).mean())
        add("top-1, `ambient=ROOM`", (in_room.locate(signals).argmax(1) == point).mean())
    return [f"| {name}: {title} | {' | '.join(shares)} |" for title, shares in cells.items()]


def main() -> None:
    titles = ["none" if level is None else f"{level:g}" for level in LEVELS]
    lines = [f"| sound (dB SPL) | {' | '.join(titles)} |", "|---" * (len(LEVELS) + 1) + "|"]
    for name in DESIGNS:
        lines += rows(name)
    print("\n".join(lines))
    replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()

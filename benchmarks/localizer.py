"""Speed of the localizer: signals, features, training, one frame. ``python benchmarks/localizer.py [DESIGN]``.

Everything runs on one thread. Rates are per second of processor time, so that a busy machine changes them little; only
single frames are timed by the clock. About five minutes for ``line-2``.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable
from dataclasses import replace
from time import perf_counter, process_time

import numpy as np
import torch
from rich.console import Console
from rich.table import Table
from torch import nn

import acoustic_fem
import geometry
import localize
from localize.learned.classifier import NetworkShape, TouchClassifier
from localize.learned.features import PairFeatures, map_count
from localize.learned.network_sizes import NETWORKS
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.disturbances import MicrophoneMismatch
from localize.signals.frames import FRAME
from localize.signals.stimulus_kinds import STIMULI
from localize.signals.touch_generator import SHARD

FREQUENCY = np.arange(1.0, 501.0)
LATENCY_FRAMES = 300
QUIET = replace(localize.TrainingPlan.on_maps(), microphone_noise=1e-3, ambient=None, batch=128)
"""Plan in silence, in large steps: what networks cost without what rooms add."""


ENOUGH = 0.94
"""Share of held-out touches named right at which the time is taken."""


def rate(job: Callable[[], int], seconds: float = 3.0) -> float:
    """Units per second of processor time of a job that returns how many it did; the first call is not counted."""
    job()
    done, start = 0, process_time()
    while process_time() - start < seconds:
        done += job()
    return done / (process_time() - start)


def latency(locate: Callable[[np.ndarray], np.ndarray], frames: np.ndarray) -> tuple[float, float]:
    """Median and 99th percentile of single frames, ms."""
    locate(frames[0])
    times = []
    for frame in frames:
        start = perf_counter()
        locate(frame)
        times.append(1e3 * (perf_counter() - start))
    return float(np.median(times)), float(np.percentile(times, 99))


def signal_rates(response: ArrayResponse) -> dict[str, float]:
    """One-second touches per second, by what is in them."""
    kinds: dict[str, dict[str, object]] = {name: {"stimuli": source} for name, source in STIMULI.items()}
    kinds["multi-sines, short-window route of the paper"] = {"method": "stft"}
    kinds["multi-sines, noise, sound of 30 to 90 dB, unlike microphones"] = {
        "microphone_noise": "design",
        "ambient": (30.0, 90.0),
        "mismatch": MicrophoneMismatch(gain=0.5, vent=0.1),
    }
    rates = {}
    for name, choice in kinds.items():
        touches = localize.TouchGenerator(response, 0, "evaluation", 0.0, **choice)
        rates[name] = rate(lambda touches=touches: len(touches.samples(0, SHARD).point))
    return rates


def step_rate(response: ArrayResponse, plan: localize.TrainingPlan) -> float:
    """Training touches per second by a plan: signals, features, network and optimizer."""
    channels, choice = len(response.microphones), plan.maps(response)
    shape = NetworkShape(map_count(channels, choice), response.point_count, features=choice, **NETWORKS[plan.network])
    classifier = TouchClassifier(channels, shape).train()
    optimizer = torch.optim.AdamW(classifier.parameters(), lr=1e-3, fused=True)
    noise, sound = plan.microphone_noise, plan.sound(response)
    touches = localize.TouchGenerator(response, 0, "training", noise, stimuli=plan.source, ambient=sound)

    def steps() -> int:
        part = touches.samples(0, SHARD)
        for frames, point in zip(*(each.split(plan.batch) for each in (part.signals, part.point - 1)), strict=True):
            maps = classifier.maps(frames[..., -FRAME:])
            with torch.autocast("cpu", torch.bfloat16, enabled=plan.bfloat16):
                logits = classifier.network(maps)
            optimizer.zero_grad()
            nn.functional.cross_entropy(logits.float(), point).backward()
            optimizer.step()
        return SHARD

    return rate(steps)


def main(name: str) -> None:
    torch.set_num_threads(1)
    # The closed forms warn of frequencies at which only the stimulus noise is left.
    with warnings.catch_warnings(record=True):
        library = acoustic_fem.solve(geometry.prototype(name), FREQUENCY, fidelity="lumped")
    response = response_of(library)
    frames = localize.TouchGenerator(response, 0, "evaluation", 1e-3).samples(0, LATENCY_FRAMES).signals[..., :FRAME]
    title = f"{name}: {response.point_count} points, {len(response.microphones)} microphones, one thread"
    table = Table("what", "value", "unit", title=title)
    table.columns[1].justify = "right"

    for kind, speed in signal_rates(response).items():
        table.add_row(f"signals of one second: {kind}", f"{speed:,.0f}", "samples/s")
    for choice in ("phasors", "paper"):
        maps = PairFeatures(len(response.microphones), choice)
        speed = rate(lambda maps=maps: len(maps(frames[:SHARD])))
        table.add_row(f"features in batches: {choice}", f"{speed:,.0f}", "frames/s")
    for network in NETWORKS:
        plans = (replace(QUIET, network=network, bfloat16=bfloat16) for bfloat16 in (False, True))
        speeds = " / ".join(f"{step_rate(response, plan):,.0f}" for plan in plans)
        table.add_row(f"training {network}, signals and features included, float32 / bfloat16", speeds, "samples/s")

    plan, reached = replace(localize.TrainingPlan.on_maps(), microphone_noise=0.0), []
    started = process_time()

    def note(progress: localize.TrainingProgress) -> None:
        if progress.accuracy >= ENOUGH and not reached:
            reached.append(process_time() - started)

    quiet = localize.train(library, plan, note)
    table.add_row(f"{100 * ENOUGH:g} % of held-out touches right, no noise", f"{reached[0]:.0f}", "s")
    table.add_row("training, default plan, no noise", f"{process_time() - started:.0f}", "s")
    noisy = localize.train(library, replace(plan, microphone_noise=1e-3))
    start = perf_counter()
    decoder = localize.BayesDecoder(library)
    table.add_row("tables of the Bayes decoder", f"{perf_counter() - start:.2f}", "s")

    for title, locators in (("network", (quiet, noisy)), ("Bayes decoder", (decoder, decoder))):
        middle, worst = latency(locators[0].locate, frames.numpy())
        table.add_row(f"{title}: one frame, median / 99 %", f"{middle:.2f} / {worst:.2f}", "ms")
        for locator, noise in zip(locators, (0.0, 1e-3), strict=True):
            result = localize.evaluate(locator, library, microphone_noise=noise)
            shares = " / ".join(f"{100 * share:.2f}" for share in (result.top1, result.top2, result.within_one))
            table.add_row(f"{title}: top-1 / top-2 / within one, noise {noise:g} Pa", shares, "%")
    Console(width=130).print(table)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "line-2")

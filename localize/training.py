"""Training of the network on touches made from a library."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import asdict, dataclass
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn

from acoustic_fem.provenance import versions
from localize.dataset import ArrayResponse, TouchGenerator, TouchSignals, TransferFunctionSource, response_of
from localize.features import map_count
from localize.frames import FRAME
from localize.localizer import Localizer
from localize.model import NetworkShape, TouchClassifier
from localize.noise import NoiseChoice, NoiseSpectrum
from localize.threads import one_thread

if TYPE_CHECKING:
    from acoustic_fem import Library

WARM_UP = 20
"""Steps over which the learning rate rises: a fresh batch normalisation does not bear the full one."""
SETTLING = 0.25
"""Share of a time limit after which the speed of training is judged."""
NORMALISATION_TOUCHES = 20
"""Touches per point from which the normalisation of the maps is taken."""


@dataclass(frozen=True)
class TrainingPlan:
    """How to train. The same plan on the same library and machine gives the same localizer.

    Raises:
        ValueError: a field outside its range, with field, value and range.
    """

    seconds_per_point: int = 200
    """One-second touches of every point in an epoch; each epoch draws new ones and each touch gives one frame."""
    epochs: int = 20
    held_out_fraction: float = 0.25
    """Held-out touches, drawn once from seeds of their own, as a fraction of an epoch's."""
    batch: int = 128
    learning_rate: float = 3e-3
    """The highest; a cosine takes it to zero."""
    weight_decay: float = 0.01
    label_sigma: float = 0.35
    """Places along a line over which labels are smoothed; 0 for hard labels. Lines never mix. The paper's 1 made half
    a percent more errors on array-2x6 with microphone noise, and its probabilities say too little of the point."""
    microphone_noise: NoiseChoice = 1e-3
    """Added to the training signals; held-out ones have the same. Pa rms over 0 to 500 Hz, white; or "design" for the
    noise of the microphone of the library's design, see :mod:`localize.noise`."""
    seed: int = 0
    time_limit: float | None = None
    """Seconds; None trains as planned, with the same result on a busy machine. Where the plan would take longer,
    training is cut short, the cosine still ending at zero: the result then depends on the speed of the machine, and
    ``training["cut_short"]`` of the localizer says so."""
    width: int = 32
    """Channels of the network's embedding."""
    depths: tuple[int, ...] = (1, 2, 2)
    """Blocks per stage of the network."""

    def __post_init__(self) -> None:
        for name, least, most in (
            ("seconds_per_point", 1, 1_000_000),
            ("epochs", 1, 10_000),
            ("batch", 2, 65_536),
            ("seed", 0, 2**63 - 1),
        ):
            value = getattr(self, name)
            if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
                raise ValueError(f"{name} = {value!r} must be a whole number from {least} to {most}")
        for name, low, high in (
            ("held_out_fraction", 1e-6, 10.0),
            ("learning_rate", 1e-8, 1.0),
            ("weight_decay", 0.0, 1.0),
            ("label_sigma", 0.0, 100.0),
            ("microphone_noise", 0.0, 100.0),
            ("time_limit", 1e-3, 1e9),
        ):
            value = getattr(self, name)
            if (name, value) in (("time_limit", None), ("microphone_noise", "design")):
                continue
            if isinstance(value, str) or not low <= value <= high:
                raise ValueError(f"{name} = {value!r} must be between {low:g} and {high:g}")


@dataclass(frozen=True)
class TrainingProgress:
    """One finished epoch; where time runs out, the last one is a part of one."""

    epoch: int
    """From 1."""
    epochs: int
    """How many there will be."""
    loss: float
    """Mean soft-target cross-entropy over the epoch."""
    accuracy: float
    """Share of held-out touches whose most probable point is the right one."""
    seconds: float
    """Since training began."""


def train(
    library: Library | ArrayResponse,
    plan: TrainingPlan | None = None,
    progress: Callable[[TrainingProgress], None] | None = None,
    source: TransferFunctionSource | None = None,
) -> Localizer:
    """Train a localizer for the array of a library.

    Where the plan has a time limit and it is reached, training is cut short and the result depends on the machine's
    load; without one it does not.

    Args:
        library: transfer functions that cover 1 to 100 Hz, of at least two points and two microphones.
        plan: by default one that takes about 25 s for 12 points on one core.
        progress: called after every epoch.
        source: transfer functions of many sensors of this design, to train on in place of the library's own; read as
            they are needed. The last fifth of the sensors is held out (of a single one, its stimuli only).

    Raises:
        ValueError: the library or the source does not cover 1 to 100 Hz, they hold different points or microphones,
            or the plan's network does not fit the maps.
    """
    plan = plan or TrainingPlan()
    response = response_of(library)
    shape = NetworkShape(
        maps=map_count(len(response.microphones)), points=response.point_count, width=plan.width, depths=plan.depths
    )
    started = perf_counter()
    seen, unseen = _split(source)
    touches = TouchGenerator(response, plan.seed, "training", plan.microphone_noise, source, seen)
    noise = touches.microphone_noise
    # The global state of torch's generator is left as it was found.
    with torch.random.fork_rng(devices=[]), one_thread():
        torch.manual_seed(plan.seed)
        held_out = _held_out(response, plan, source, unseen)
        classifier = TouchClassifier(len(response.microphones), shape)
        classifier.fit_normalisation(_frames(touches.samples(0, NORMALISATION_TOUCHES * response.point_count)))
        curve, touch_count = _run_epochs(classifier, touches, held_out, plan, started, progress)
    classifier.eval()
    return Localizer(
        classifier=classifier,
        shape=shape,
        design=response.name,
        microphones=response.microphones,
        line=response.line,
        place=response.place,
        plan=asdict(plan),
        training={
            "loss": [entry.loss for entry in curve],
            "held_out_accuracy": [entry.accuracy for entry in curve],
            "epochs": len(curve),
            "touches": touch_count,
            "held_out_touches": len(held_out.point),
            "seconds": curve[-1].seconds,
            "cut_short": touch_count < plan.epochs * _steps_per_epoch(plan, response) * plan.batch,
            "microphone_noise": noise.rms if isinstance(noise, NoiseSpectrum) else noise,
            "sensors": 1 if seen is None else len(seen),
        },
        provenance={
            **response.provenance,
            "localizer": versions(plan.seed, ("numpy", "safetensors", "scipy", "torch")),
        },
    )


def soft_labels(line: NDArray[np.int64], place: NDArray[np.int64], sigma: float) -> NDArray[np.float64]:
    """Target probabilities of each point: a Gaussian over places of its own line, zero on the others.

    Args:
        line: (n_point,).
        place: (n_point,) along the line.
        sigma: in places; 0 gives the identity.

    Returns:
        (n_point, n_point) float64, rows sum to 1.
    """
    distance = place[:, None] - place[None, :]
    same_line = line[:, None] == line[None, :]
    weight = np.exp(-0.5 * (distance / sigma) ** 2) if sigma > 0 else (distance == 0).astype(np.float64)
    weight = np.where(same_line, weight, 0.0)
    return np.asarray(weight / weight.sum(1, keepdims=True))


def _run_epochs(
    classifier: TouchClassifier,
    touches: TouchGenerator,
    held_out: TouchSignals,
    plan: TrainingPlan,
    started: float,
    progress: Callable[[TrainingProgress], None] | None,
) -> tuple[list[TrainingProgress], int]:
    """Train in place; one entry per epoch, and the number of touches used."""
    response = touches.response
    target = torch.from_numpy(soft_labels(response.line, response.place, plan.label_sigma)).float()
    optimizer = torch.optim.AdamW(classifier.parameters(), lr=plan.learning_rate, weight_decay=plan.weight_decay)
    steps_per_epoch = _steps_per_epoch(plan, response)
    planned, step, turned = plan.epochs * steps_per_epoch, 0, 0.0
    steps = planned
    losses: list[float] = []
    curve: list[TrainingProgress] = []
    while step < steps:
        classifier.train()
        rate = plan.learning_rate * min(1.0, (step + 1) / WARM_UP) * 0.5 * (1 + math.cos(math.pi * turned))
        for group in optimizer.param_groups:
            group["lr"] = rate
        part = touches.samples(step * plan.batch, plan.batch)
        loss = nn.functional.cross_entropy(classifier(_frames(part)), target[part.point])
        optimizer.zero_grad()
        loss.backward()
        optimizer.step()
        losses.append(loss.item())
        step += 1
        if plan.time_limit is not None:
            steps = _affordable(step, perf_counter() - started, plan.time_limit, planned)
        # What is left of the cosine is spread evenly over the steps that are left.
        turned += (1 - turned) / (max(steps - step, 0) + 1)
        if step % steps_per_epoch == 0 or step >= steps:
            epoch, epochs = (math.ceil(k / steps_per_epoch) for k in (step, max(step, steps)))
            accuracy = _accuracy(classifier, held_out)
            curve.append(TrainingProgress(epoch, epochs, float(np.mean(losses)), accuracy, perf_counter() - started))
            losses = []
            if progress:
                progress(curve[-1])
    return curve, step * plan.batch


def _steps_per_epoch(plan: TrainingPlan, response: ArrayResponse) -> int:
    return math.ceil(plan.seconds_per_point * response.point_count / plan.batch)


def _affordable(step: int, seconds: float, limit: float, planned: int) -> int:
    """How many of the planned steps there may be in all, judged by those done so far."""
    # The first ones are slow and say little; a plan that fits easily is then never touched, and repeats exactly.
    if seconds < SETTLING * limit:
        return planned
    return min(planned, step + max(0, math.floor((limit - seconds) * step / seconds)))


def _frames(touches: TouchSignals) -> Tensor:
    """The last frame of each touch."""
    return touches.signals[..., -FRAME:]


def _split(source: TransferFunctionSource | None) -> tuple[range | None, range | None]:
    """Sensors to train on, and those held out."""
    if source is None:
        return None, None
    count = source.sensor_count
    seen = max(1, count - max(1, round(count / 5)))
    return range(seen), range(min(seen, count - 1), count)


def _held_out(
    response: ArrayResponse, plan: TrainingPlan, source: TransferFunctionSource | None, sensors: range | None
) -> TouchSignals:
    """Held-out touches, cut to their last frame at once to keep them small."""
    count = max(1, round(plan.held_out_fraction * plan.seconds_per_point)) * response.point_count
    touches = TouchGenerator(response, plan.seed, "held-out", plan.microphone_noise, source, sensors)
    parts = list(touches.stream(0, count))
    return TouchSignals(
        signals=torch.cat([_frames(part).clone() for part in parts]),
        point=torch.cat([part.point for part in parts]),
        interval=torch.cat([part.interval for part in parts]),
    )


def _accuracy(classifier: TouchClassifier, touches: TouchSignals) -> float:
    classifier.eval()
    with torch.inference_mode():
        named = torch.cat([classifier(part).argmax(1) for part in touches.signals.split(512)])
    return float((named == touches.point).double().mean())

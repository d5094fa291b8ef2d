"""The loop that trains a network, whatever it names: epochs, learning rate, checkpoints, a limit of time."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import astuple, dataclass, field
from time import perf_counter
from typing import Protocol

import numpy as np
import torch
from torch import Tensor, nn

from localize.learned.checkpoint import Checkpoint, Progress
from localize.learned.classifier import Classifier


@dataclass(frozen=True)
class TrainingProgress:
    """Figures of one finished epoch; where time runs out, the last one is a part of one."""

    epoch: int
    """Number of the epoch, from 1."""
    epochs: int
    """Number of epochs that there will be."""
    loss: float
    """Mean soft-target cross-entropy over the epoch, nats."""
    accuracy: float
    """Top-1 accuracy on held-out touches, from 0 to 1."""
    seconds: float
    """Time since training began, s."""
    recorded: Mapping[str, float] = field(default_factory=dict)
    """Top-1 accuracy on held-out recordings, from 0 to 1, by part; empty without recordings."""


class Schedule(Protocol):
    """Length and speed of a training: the fields of a plan that the loop reads."""

    @property
    def epochs(self) -> int:
        """Number of epochs."""

    @property
    def batch(self) -> int:
        """Number of samples of a step."""

    @property
    def learning_rate(self) -> float:
        """Highest learning rate; a cosine takes it to zero."""

    @property
    def weight_decay(self) -> float:
        """Weight decay of AdamW."""

    @property
    def time_limit(self) -> float | None:
        """Time limit, s, or None."""

    @property
    def warm_up_steps(self) -> int:
        """Number of steps over which the learning rate rises."""

    @property
    def settling_fraction(self) -> float:
        """Fraction of a time limit after which the speed of training is estimated."""

    @property
    def checkpoint_interval(self) -> float:
        """Time between checkpoints within an epoch, s."""

    @property
    def bfloat16(self) -> bool:
        """True if the network computes in bfloat16 while it is trained."""


@dataclass(frozen=True, eq=False)
class TrainingTask:
    """Samples that a classifier is trained on, and those that it is evaluated on after every epoch."""

    batch: Callable[[int, int], tuple[Tensor, Tensor]]
    """Inputs and classes, from 0, of step k of steps of so many samples; the same whatever was asked for before."""
    steps_per_epoch: int
    """Number of steps of an epoch."""
    target: Tensor
    """Probabilities to aim at for each class; (n_class, n_class) float32."""
    held_out: Tensor
    """Inputs that are judged and never trained on; (n, ...) float32."""
    held_out_class: Tensor
    """Their classes, from 0; (n,) int64."""
    are_maps: bool = False
    """True if all these inputs are maps already: the learned part alone looks at them."""
    judge: Callable[[], Mapping[str, float]] = dict
    """Shares of what else is judged after an epoch, by name."""


def run_epochs(
    classifier: Classifier,
    lesson: TrainingTask,
    plan: Schedule,
    checkpoint: Checkpoint | None,
    report: Callable[[TrainingProgress], None] | None,
) -> tuple[list[TrainingProgress], int]:
    """Train in place.

    Args:
        classifier: normalised already.
        lesson: what it is taught.
        plan: how long and how fast.
        checkpoint: where the state is kept, and gone on from.
        report: called after every epoch, those that are gone on from included.

    Returns:
        One entry per epoch, and the number of samples used.

    Raises:
        CheckpointError: as :meth:`localize.learned.checkpoint.Checkpoint.load`.
    """
    # fused: a quarter of the time of a loop over small tensors
    optimizer = torch.optim.AdamW(
        classifier.parameters(), lr=plan.learning_rate, weight_decay=plan.weight_decay, fused=True
    )
    at = (checkpoint.load(classifier, optimizer) if checkpoint else None) or Progress()
    curve = [TrainingProgress(int(entry[0]), int(entry[1]), *entry[2:]) for entry in at.curve]
    if report:
        for entry in curve:
            report(entry)
    saved = perf_counter()
    started = saved - at.seconds
    planned = steps = plan.epochs * lesson.steps_per_epoch
    if at.turned == 1.0:  # it had ended, by its limit of time perhaps
        steps = at.step
    while at.step < steps:
        classifier.train()
        rate = (
            plan.learning_rate
            * min(1.0, (at.step + 1) / plan.warm_up_steps)
            * 0.5
            * (1 + math.cos(math.pi * at.turned))
        )
        for group in optimizer.param_groups:
            group["lr"] = rate
        at.losses.append(_step(classifier, optimizer, lesson, plan, at.step))
        at.step += 1
        if plan.time_limit is not None:
            steps = _affordable(at.step, perf_counter() - started, plan.time_limit, planned, plan.settling_fraction)
        # What is left of the cosine is spread evenly over the steps that are left.
        at.turned += (1 - at.turned) / (max(steps - at.step, 0) + 1)
        ended = at.step % lesson.steps_per_epoch == 0 or at.step >= steps
        if ended:
            epoch, epochs = (math.ceil(k / lesson.steps_per_epoch) for k in (at.step, max(at.step, steps)))
            told = most_probable_classes(classifier.network if lesson.are_maps else classifier, lesson.held_out)
            right = told == lesson.held_out_class
            judged = lesson.judge()
            seconds = perf_counter() - started
            accuracy = float(right.double().mean())
            curve.append(TrainingProgress(epoch, epochs, float(np.mean(at.losses)), accuracy, seconds, judged))
            at.curve.append(list(astuple(curve[-1])))
            at.losses = []
        if checkpoint and (ended or perf_counter() - saved > plan.checkpoint_interval):
            at.seconds = perf_counter() - started
            checkpoint.save(classifier, optimizer, at)
            saved = perf_counter()
        if ended and report:
            report(curve[-1])
    return curve, at.step * plan.batch


def most_probable_classes(classifier: nn.Module, inputs: Tensor) -> Tensor:
    """Most probable class of each input of a classifier, or of its learned part, from 0; (n,) int64."""
    classifier.eval()
    with torch.inference_mode():
        return torch.cat([classifier(part).argmax(1) for part in inputs.split(512)])


def _step(
    classifier: Classifier, optimizer: torch.optim.Optimizer, lesson: TrainingTask, plan: Schedule, number: int
) -> float:
    """Loss of a step that is done."""
    inputs, label = lesson.batch(number, plan.batch)
    maps = inputs.float() if lesson.are_maps else classifier.maps(inputs)
    with torch.autocast(maps.device.type, torch.bfloat16, enabled=plan.bfloat16):
        logits = classifier.network(maps)
    loss = nn.functional.cross_entropy(logits.float(), lesson.target[label])
    optimizer.zero_grad()
    loss.backward()
    optimizer.step()
    return float(loss.item())


def _affordable(step: int, seconds: float, limit: float, planned: int, settling: float) -> int:
    """How many of the planned steps there may be in all, judged by those done so far."""
    # The first ones are slow and say little; a plan that fits easily is then never touched, and repeats exactly.
    if seconds < settling * limit:
        return planned
    return min(planned, step + max(0, math.floor((limit - seconds) * step / seconds)))

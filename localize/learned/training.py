"""Training of the network on touches made from a library, and on recorded ones beside them."""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from dataclasses import asdict, replace
from functools import lru_cache
from typing import Any

import numpy as np
import scipy.signal
import torch
from numpy.typing import NDArray
from torch import Tensor

from acoustic_fem import Library
from acoustic_fem.library.provenance import versions
from acoustic_fem.library.transfer_functions import MEASURED
from acoustic_fem.scatter.tolerances import unknown_scatter
from geometry.ground.stated_times import stated_seconds
from localize.decoders.bayes import BayesDecoder
from localize.decoders.frame_covariance import LEAST_NOISE, whole_frame_covariance
from localize.decoders.tolerant import decoder_of
from localize.learned.checkpoint import Checkpoint, training_identity
from localize.learned.classifier import Classifier, NetworkShape, TouchClassifier
from localize.learned.epochs import TrainingProgress, TrainingTask, most_probable_classes, run_epochs
from localize.learned.features import map_count
from localize.learned.hypothesis_network import HypothesisClassifier, HypothesisShape
from localize.learned.localizer import Localizer
from localize.learned.network_sizes import NETWORKS
from localize.learned.recorded_frames import RecordedFrames
from localize.learned.training_plan import HYPOTHESES, TrainingPlan, identity_of
from localize.live.front_end import high_pass_sections
from localize.live.stream_options import HIGH_PASS
from localize.signals.array_response import ArrayResponse, TransferFunctionSource, response_of, warn_of_uncovered
from localize.signals.as_built_draws import AsBuiltDraws
from localize.signals.frames import FRAME
from localize.signals.noise_model import NoiseSpectrum
from localize.signals.random_streams import Purpose, random_words, uniform
from localize.signals.stimulus import Device
from localize.signals.threads import one_thread
from localize.signals.touch_generator import SHARD, TouchGenerator, TouchSignals

__all__ = ["TrainingPlan", "soft_labels", "train"]

KEPT_BYTES = 2**30
"""Largest size of the frames or maps that are kept in memory from one epoch to the next, bytes."""


def train(
    library: Library | ArrayResponse,
    plan: TrainingPlan | None = None,
    progress: Callable[[TrainingProgress], None] | None = None,
    source: TransferFunctionSource | None = None,
    checkpoint: str | os.PathLike[str] | None = None,
    recordings: str | os.PathLike[str] | None = None,
) -> Localizer:
    """Train a localizer for the array of a library, on the graphics processor where torch finds one.

    If the plan has a time limit and it is reached, training stops early and the result depends on the load of the
    machine; without a time limit it does not.

    Args:
        library: transfer functions that cover 1 to 100 Hz, of at least two points and two microphones; frequencies up
            to 500 Hz that they do not cover are left out of the touches, with a warning.
        plan: by default one that takes some two minutes for 12 points on one core.
        progress: called after every epoch, those of a resumed training included.
        source: transfer functions of many sensors of this design, to train on in place of the library's own; read as
            they are needed. The last fifth of the sensors is held out (with a single sensor, only its stimuli are).
        checkpoint: a file that keeps the state of the training, after every epoch and every minute. If it is there,
            training goes on from it, and the weights become those that it would have led to, bit for bit. It stays
            when training is done; remove it once the localizer is saved.
        recordings: a manifest of touches of the as-built sensor (:mod:`localize.recordings.touch_manifest`), which
            supply the plan's fraction of the touches. A fifth of the recordings is held out for the evaluation.

    Raises:
        Refusal: the library or the source does not cover 1 to 100 Hz, they hold different points or microphones,
            the plan's network does not fit the maps, or it asks for sound without a design.
        TouchManifestError, RecordingError: recordings that cannot be used.
        CheckpointError: the checkpoint is damaged, or that of another plan, library, set of recordings or version of
            torch.
    """
    plan = plan or TrainingPlan()
    response = response_of(library)
    if plan.network != HYPOTHESES:  # its decoder warns
        warn_of_uncovered(response)
    if source is None:
        source = _as_built(library, response, plan)
    seen, unseen = _split(source)
    device = "cuda" if torch.cuda.is_available() else "cpu"
    touches = _touches(response, plan, "training", source, seen, device)
    noise = touches.microphone_noise
    noise_rms = noise.rms if isinstance(noise, NoiseSpectrum) else noise
    recorded = (
        None
        if recordings is None
        else RecordedFrames(recordings, response, noise_rms, plan.seed, device, plan.judged_frames)
    )
    # The global state of torch's generator is left as it was found.
    with torch.random.fork_rng(devices=[]), one_thread():
        torch.manual_seed(plan.seed)
        held_out = _held_out(plan, _touches(response, plan, "held-out", source, unseen, device))
        classifier, shape = _classifier(library, response, plan, noise)
        classifier = classifier.to(device)
        batches = _Batches(touches, recorded, plan, _steps_per_epoch(plan, response))
        classifier.fit_normalisation(batches.first(plan.normalisation_touches * response.point_count))
        identity = {**training_identity(identity_of(plan), touches), **(recorded.identity() if recorded else {})}
        kept = None if checkpoint is None else Checkpoint(checkpoint, identity)
        target = torch.from_numpy(labels_of(response, plan)).float().to(device)
        are_maps = isinstance(classifier, HypothesisClassifier) and batches.prepare(classifier)
        curve, touch_count = run_epochs(
            classifier,
            TrainingTask(
                batches.frames,
                _steps_per_epoch(plan, response),
                target,
                classifier.maps(held_out[0]) if are_maps else held_out[0],
                held_out[1],
                are_maps,
                lambda: _by_part(classifier, recorded),
            ),
            plan,
            kept,
            progress,
        )
        if isinstance(classifier, HypothesisClassifier):
            classifier.calibrate(*held_out)
        of_recordings = _of_recordings(recorded, classifier, curve)
    classifier.cpu().eval()
    return Localizer(
        classifier=classifier,
        shape=shape,
        array=replace(
            response.array,
            noise_rms=float(noise_rms),
            provenance={
                **response.provenance,
                "localizer": versions(plan.seed, ("numpy", "safetensors", "scipy", "torch")),
            },
        ),
        plan=asdict(plan),
        training={
            "loss": [entry.loss for entry in curve],
            "held_out_accuracy": [entry.accuracy for entry in curve],
            "epochs": len(curve),
            "touches": touch_count,
            "held_out_touches": len(held_out[1]),
            "seconds": stated_seconds(curve[-1].seconds),
            "cut_short": touch_count < plan.epochs * _steps_per_epoch(plan, response) * plan.batch,
            "microphone_noise": noise_rms,
            "ambient": plan.sound(response),
            "sensors": 1 if seen is None else len(seen),
            "device": device,
            **of_recordings,
        },
    )


def _as_built(library: Library | ArrayResponse, response: ArrayResponse, plan: TrainingPlan) -> AsBuiltDraws | None:
    """As-built sensors that a plan asks for, of a library that can have them."""
    if not plan.as_built or isinstance(library, ArrayResponse) or library.fidelity == MEASURED:
        return None
    if unknown_scatter(library.design) is not None:
        return None
    # Others than those that any decoder or evaluation of the same seed draws.
    seed = int(np.random.SeedSequence(plan.seed, spawn_key=(1,)).generate_state(1, np.uint64)[0] >> 1)
    return AsBuiltDraws(library, response, plan.as_built, seed, plan.designed_share)


def _classifier(
    library: Library | ArrayResponse, response: ArrayResponse, plan: TrainingPlan, noise: float | NoiseSpectrum
) -> tuple[TouchClassifier | HypothesisClassifier, NetworkShape | HypothesisShape]:
    """Network of a plan, not yet trained, and its sizes."""
    if plan.network == HYPOTHESES:
        # Nothing can be divided by no noise.
        assumed = LEAST_NOISE if plan.microphone_noise == 0.0 else plan.microphone_noise
        decoder = BayesDecoder(library, assumed) if isinstance(library, ArrayResponse) else decoder_of(library, assumed)
        of_hypotheses = HypothesisShape.of(decoder, plan.shapes)
        classifier = HypothesisClassifier(of_hypotheses)
        classifier.take(decoder)
        return classifier, of_hypotheses
    microphones, sound, features = len(response.microphones), plan.sound(response), plan.maps(response)
    shape = NetworkShape(
        maps=map_count(microphones, features),
        points=response.point_count,
        features=features,
        **NETWORKS[plan.network],
    )
    convolutional = TouchClassifier(microphones, shape)
    if features == "rooms" and sound is not None:
        convolutional.features.take_out(whole_frame_covariance(response, noise, sound[1]))
    return convolutional, shape


def soft_labels(line: NDArray[np.int64], place: NDArray[np.int64], sigma: float) -> NDArray[np.float64]:
    """Target probabilities of each point: a Gaussian over places of its own line, zero on the others.

    Args:
        line: (n_point,) int64, line of each point.
        place: (n_point,) int64, place of each point along its line.
        sigma: standard deviation, in places; 0 gives the identity.

    Returns:
        (n_point, n_point) float64, rows sum to 1.
    """
    distance = place[:, None] - place[None, :]
    same_line = line[:, None] == line[None, :]
    weight = np.exp(-0.5 * (distance / sigma) ** 2) if sigma > 0 else (distance == 0).astype(np.float64)
    weight = np.where(same_line, weight, 0.0)
    return np.asarray(weight / weight.sum(1, keepdims=True))


def labels_of(response: ArrayResponse, plan: TrainingPlan) -> NDArray[np.float64]:
    """(n_point, n_point) targets of a plan, see :func:`soft_labels`."""
    if plan.label_neighbours == "line":
        return soft_labels(response.line, response.place, plan.label_sigma)
    number = np.arange(response.point_count)
    return soft_labels(np.zeros_like(number), number, plan.label_sigma)


class _Batches:
    """Touches of each step: simulated ones, and recorded ones where there are recordings.

    Touch i of a generator is of the points in turn. A step of consecutive ones would hold one part of
    a large array, and batch normalisation would learn which. Steps are therefore dealt from blocks that hold all points
    and are shuffled. A block is the same whatever was made before, so that a training goes on after a stop.
    """

    def __init__(
        self, touches: TouchGenerator, recordings: RecordedFrames | None, plan: TrainingPlan, steps_per_epoch: int
    ) -> None:
        self.touches, self.recordings, self.plan = touches, recordings, plan
        self._fraction = 0.0 if recordings is None else plan.recorded
        self._steps = steps_per_epoch
        self._block = lru_cache(maxsize=1)(self._shuffled)
        self._kept: dict[int, tuple[Tensor, Tensor]] = {}
        self._prepare: Callable[[Tensor], Tensor] | None = None
        self._keeps = self._has_room(len(touches.response.microphones) * FRAME * torch.float32.itemsize)

    def _has_room(self, size: int) -> bool:
        """True if inputs of so many bytes each are kept from one epoch to the next."""
        return not self.plan.new_touches and self._steps * self.plan.batch * size <= KEPT_BYTES

    def prepare(self, classifier: HypothesisClassifier) -> bool:
        """From now on give maps of a normalised classifier in place of frames, if there is room for all of them.

        Returns:
            True if it does.
        """
        size = classifier.features.prior.numel() * classifier.features.count * torch.float16.itemsize
        if self.recordings is None and self._has_room(size):
            self._prepare = lambda frames: classifier.maps(frames).half()
        return self._prepare is not None

    def first(self, count: int) -> Tensor:
        """(count, n_microphone, 250): frames from which the maps are normalised."""
        simulated = count - round(self._fraction * count)
        parts = [_frames(self.touches.samples(0, simulated), self.plan, 0)] if simulated else []
        if self.recordings is not None and simulated < count:
            parts.append(self.recordings.samples(0, count - simulated)[0])
        return torch.cat(parts)

    def frames(self, step: int, size: int) -> tuple[Tensor, Tensor]:
        """(size, n_microphone, 250) and (size,) points, from 0: batch ``step`` of batches of this size."""
        recorded = round(self._fraction * size)
        parts = [self._simulated(step, size - recorded)] if recorded < size else []
        if self.recordings is not None and recorded:
            parts.append(self.recordings.samples(step * recorded, recorded))
        frames, point = zip(*parts, strict=True)
        return torch.cat(frames), torch.cat(point)

    def _simulated(self, step: int, size: int) -> tuple[Tensor, Tensor]:
        epoch, within = divmod(step, self._steps)
        blocks = max(1, self._steps * size // (max(SHARD, self.touches.response.point_count) + size))
        bounds = self._steps * np.arange(blocks + 1) // blocks  # of nearly one length: a short one has few points
        block = int(np.searchsorted(bounds, within, "right")) - 1
        first, end = int(bounds[block]), int(bounds[block + 1])
        frames, point = self._block(epoch, first, end - first, size)
        own = slice((within - first) * size, (within - first + 1) * size)
        return frames[own], point[own]

    def _shuffled(self, epoch: int, first: int, steps: int, size: int) -> tuple[Tensor, Tensor]:
        """Frames and points of a block: those of so many steps of an epoch, from its step ``first`` on."""
        begin, count = first * size, steps * size
        runs = [(epoch * self._steps * size + begin, count)]
        if not self.plan.new_touches:
            run = math.gcd(size, self.plan.run_length)
            order = _order(self.plan.seed, epoch, self._steps * size // run)
            runs = [(int(k) * run, run) for k in order[begin // run : (begin + count) // run]]
        made = [self._made(*run) for run in runs]
        random = np.random.default_rng(np.random.SeedSequence(self.plan.seed, spawn_key=(0, epoch, first)))
        shuffled = torch.from_numpy(random.permutation(count)).to(self.touches.device)
        frames, point = zip(*made, strict=True)
        return torch.cat(frames)[shuffled], torch.cat(point)[shuffled]

    def _made(self, start: int, count: int) -> tuple[Tensor, Tensor]:
        """Frames and points of consecutive touches."""
        if start in self._kept:
            return self._kept[start]
        touches = self.touches.samples(start, count)
        frames = _frames(touches, self.plan, start)
        made = frames if self._prepare is None else self._prepare(frames), touches.point - 1
        if self._keeps:
            self._kept[start] = made
        return made


@lru_cache(maxsize=1)
def _order(seed: int, epoch: int, runs: int) -> NDArray[np.int64]:
    """Order of the runs of touches in an epoch, (runs,) int64."""
    return np.random.default_rng((seed, epoch)).permutation(runs)


def _touches(
    response: ArrayResponse,
    plan: TrainingPlan,
    purpose: Purpose,
    source: TransferFunctionSource | None,
    sensors: range | None,
    device: Device,
) -> TouchGenerator:
    return TouchGenerator(
        response,
        plan.seed,
        purpose,
        plan.microphone_noise,
        source,
        sensors,
        stimuli=plan.source,
        ambient=plan.sound(response),
        mismatch=plan.mismatch,
        method=plan.method,
        device=device,
    )


def _steps_per_epoch(plan: TrainingPlan, response: ArrayResponse) -> int:
    return math.ceil(plan.touches_per_point(response.point_count) * response.point_count / plan.batch)


def _frames(touches: TouchSignals, plan: TrainingPlan, start: int) -> Tensor:
    """The last frame of each touch, of some behind the high-pass of a stream, from touch number ``start`` on."""
    signals = touches.signals
    if plan.high_passed:
        drawn = uniform(random_words(plan.seed, "training", "high-pass", start, len(signals), 1))[:, 0, 0]
        behind = (drawn < plan.high_passed).to(signals.device)
        sections = high_pass_sections(HIGH_PASS)
        passed = scipy.signal.sosfilt(sections, signals[behind].cpu().numpy(), axis=-1).astype(np.float32)
        signals[behind] = torch.from_numpy(passed).to(signals.device)
    return signals[..., -FRAME:].clone()


def _split(source: TransferFunctionSource | None) -> tuple[range | None, range | None]:
    """Sensors to train on, and those held out."""
    if source is None:
        return None, None
    count = source.sensor_count
    seen = max(1, count - max(1, round(count / 5)))
    return range(seen), range(min(seen, count - 1), count)


def _held_out(plan: TrainingPlan, touches: TouchGenerator) -> tuple[Tensor, Tensor]:
    """Frames of held-out touches, and their points, from 0."""
    points = touches.response.point_count
    count = max(1, round(plan.held_out_fraction * plan.touches_per_point(points))) * points
    starts = range(0, count, SHARD)
    parts = [touches.samples(start, min(SHARD, count - start)) for start in starts]
    frames = [_frames(part, plan, start) for part, start in zip(parts, starts, strict=True)]
    return torch.cat(frames), torch.cat([part.point - 1 for part in parts])


def _by_part(classifier: Classifier, recordings: RecordedFrames | None) -> dict[str, float]:
    if recordings is None:
        return {}
    judged = recordings.judged(most_probable_classes(classifier, recordings.judged_frames))
    return {part: found.top1 for part, found in judged.items()}


def _of_recordings(
    recordings: RecordedFrames | None, classifier: Classifier, curve: list[TrainingProgress]
) -> dict[str, Any]:
    """Record of the recordings in a localizer: the split, the curves, and the accuracy on the held-out ones."""
    if recordings is None:
        return {}
    judged = recordings.judged(most_probable_classes(classifier, recordings.judged_frames))
    return {
        "recordings": recordings.to_dict(),
        "held_out_recordings": {part: asdict(found) for part, found in judged.items()},
        "recorded_accuracy": [dict(entry.recorded) for entry in curve],
    }

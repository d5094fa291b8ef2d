"""Training of a recognizer, on simulated takes or on recorded ones."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from acoustic_fem import Library
from acoustic_fem.library.provenance import versions
from geometry.ground.argument_checks import check_choice
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.stated_times import stated_seconds
from localize.decoders.reconstruct import Reconstructor
from localize.learned.checkpoint import Checkpoint
from localize.learned.classifier import MapClassifier, NetworkShape
from localize.learned.epochs import TrainingProgress, TrainingTask, most_probable_classes, run_epochs
from localize.learned.network_sizes import NETWORKS
from localize.learned.training_plan import identity_of
from localize.recognition.handwriting import WRITTEN, LetterMaker, LineReader
from localize.recognition.letter_classifier import Hand, training_hands
from localize.recognition.letter_shapes import LETTERS
from localize.recognition.power_maps import MAPS
from localize.recognition.recognition_plan import RecognitionPlan
from localize.recognition.recognizer import Recognizer
from localize.recognition.recorded_takes import recorded_takes
from localize.recognition.takes import SUBJECTS, TakeMaker
from localize.signals.array_response import ArrayResponse, response_of, warn_of_uncovered
from localize.signals.noise_model import NoiseSpectrum
from localize.signals.threads import one_thread

RECORDED = "labels"
"""Subject of a recognizer that was trained on recordings, whose labels are the user's."""


@dataclass(frozen=True, eq=False)
class Takes:
    """Data of a training: maps and their kinds, to train on and held out."""

    labels: tuple[str, ...]
    """Kinds."""
    maps: Tensor
    """Maps to train on; (n, n_map, 64, 32) float32."""
    kind: Tensor
    """Their kinds, from 0; (n,) int64."""
    held_out_maps: Tensor
    """Maps that are held out; (m, n_map, 64, 32) float32."""
    held_out_kind: Tensor
    """Their kinds, from 0; (m,) int64."""
    identity: dict[str, str]
    """Facts that must agree for a training to go on."""


def train_recognizer(
    library: Library | ArrayResponse,
    subject: str,
    plan: RecognitionPlan | None = None,
    progress: Callable[[TrainingProgress], None] | None = None,
    checkpoint: str | os.PathLike[str] | None = None,
    recordings: str | os.PathLike[str] | None = None,
    making: Callable[[float], None] | None = None,
) -> Recognizer:
    """Train a recognizer of kinds of touch for the array of a library.

    Args:
        library: transfer functions that cover 1 to 100 Hz.
        subject: what to recognize: one of :data:`localize.recognition.takes.SUBJECTS`, "letters", or "labels" for those
            of a manifest.
        plan: by default one that takes about a minute for twelve kinds on one core.
        progress: called after every epoch.
        checkpoint: a file that keeps the state of the training, as of :func:`localize.train`.
        recordings: a manifest with labels (:mod:`localize.recordings.touch_manifest`), for "labels" and "letters".
        making: function that is called with the fraction of the simulated signals that are made.

    Raises:
        Refusal: an unknown subject, or one that does not go with recordings; a library that does not cover 1 to 100 Hz;
            an unknown font of letters.
        MissingExtra: simulated letters of fonts, and the extra "fonts" is not installed.
        TouchManifestError, RecordingError: recordings that cannot be used.
        CheckpointError: the checkpoint is damaged, or that of another training.
    """
    plan = plan or RecognitionPlan.of(subject)
    known = (*SUBJECTS, WRITTEN, RECORDED)
    check_choice("subject", subject, known)
    if subject != WRITTEN and (subject == RECORDED) != (recordings is not None):
        raise Refusal(
            f"a manifest of recordings goes with {RECORDED!r} or {WRITTEN!r}, and {RECORDED!r} needs one",
            kind=Kind.CONFLICT,
            field="subject",
            value=subject,
        )
    response = response_of(library)
    warn_of_uncovered(response)
    takes, slides = _takes(response, subject, plan, recordings, making)
    shape = NetworkShape(maps=MAPS, points=len(takes.labels), **NETWORKS[plan.network])
    classifier, record = learn(takes, shape, plan, response, checkpoint, progress)
    return Recognizer(
        classifier=classifier,
        shape=shape,
        subject=subject,
        labels=takes.labels,
        design=response.name,
        microphones=response.microphones,
        at_usual_speed=slides,
        plan=asdict(plan),
        training=record,
        provenance={
            **response.provenance,
            "recognizer": versions(plan.seed, ("numpy", "safetensors", "scipy", "torch")),
        },
    )


def _takes(
    response: ArrayResponse,
    subject: str,
    plan: RecognitionPlan,
    recordings: str | os.PathLike[str] | None,
    making: Callable[[float], None] | None,
) -> tuple[Takes, bool]:
    """Data of a training, and True if they are of sliding at a known speed."""
    hands: tuple[Hand, ...] = ()
    if subject == WRITTEN and recordings is None:
        hands = training_hands(plan.letter_speeds, plan.letter_fonts)
    reconstructor = reconstructor_of(response, plan)
    reader = LineReader(response, plan.microphone_noise) if subject == WRITTEN else None
    if recordings is not None:
        noise = response.noise(plan.microphone_noise)
        rms = noise.rms if isinstance(noise, NoiseSpectrum) else noise
        found = recorded_takes(recordings, response, reader or reconstructor, rms, plan)
        identity = {f"recording {name}": said for name, said in found.files.items()}
        own = (found.maps, found.kind, found.held_out_maps, found.held_out_kind)
        return Takes(found.labels, *own, identity), found.at_usual_speed
    kinds = LETTERS if reader else SUBJECTS[subject].labels
    held = max(1, round(plan.held_out_fraction * plan.takes)) * len(kinds)
    if reader:
        written = LetterMaker((reader,), (response,), plan.seed, plan.microphone_noise, hands)
        seen = written.maps("training", plan.takes * len(kinds), making, plan.letter_variants)
        return Takes(kinds, *seen, *written.maps("held-out", held), {}), False
    slides = SUBJECTS[subject].speeds is not None
    # Bare transfer functions have no surface to slide over, so no speed is given.
    passing = plan.passing if slides and response.membrane_radius is not None else 0.0
    maker = TakeMaker(subject, reconstructor, (response,), plan.seed, plan.microphone_noise, passing=passing)
    seen = maker.maps("training", plan.takes * len(kinds), making)
    return Takes(kinds, *seen, *maker.maps("held-out", held), {}), slides


def reconstructor_of(response: ArrayResponse, plan: RecognitionPlan) -> Reconstructor:
    """Filters that waveforms are made by, for the noise of a plan."""
    noise = plan.microphone_noise
    return Reconstructor(response, noise if isinstance(noise, str) else max(noise, plan.least_noise))


def learn(
    takes: Takes,
    shape: NetworkShape,
    plan: RecognitionPlan,
    response: ArrayResponse,
    checkpoint: str | os.PathLike[str] | None,
    progress: Callable[[TrainingProgress], None] | None,
) -> tuple[MapClassifier, dict[str, Any]]:
    """Network that has learnt to name takes, and the record of its training, as JSON can hold it.

    Args:
        takes: to train on, and held out.
        shape: of the network.
        plan: how.
        response: of the array.
        checkpoint: a file that keeps the state of the training.
        progress: called after every epoch.

    Raises:
        CheckpointError: the checkpoint is damaged, or that of another training.
    """
    kinds = len(takes.labels)
    steps = -(-len(takes.kind) // plan.batch)
    with torch.random.fork_rng(devices=[]), one_thread():
        torch.manual_seed(plan.seed)
        classifier = MapClassifier(shape)
        classifier.fit_normalisation(takes.maps)
        target = (1 - plan.smoothing) * torch.eye(kinds) + plan.smoothing / kinds
        lesson = TrainingTask(
            lambda step, size: _batch(takes, plan, step, size), steps, target, takes.held_out_maps, takes.held_out_kind
        )
        kept = None if checkpoint is None else Checkpoint(checkpoint, _identity(takes, plan, response))
        curve, count = run_epochs(classifier, lesson, plan, kept, progress)
        named = most_probable_classes(classifier, takes.held_out_maps)
    confusion = np.zeros((kinds, kinds), np.int64)
    np.add.at(confusion, (takes.held_out_kind.numpy(), named.numpy()), 1)
    return classifier.eval(), {
        "loss": [entry.loss for entry in curve],
        "held_out_accuracy": [entry.accuracy for entry in curve],
        "epochs": len(curve),
        "takes": len(takes.kind),
        "held_out_takes": len(takes.held_out_kind),
        "seconds": stated_seconds(curve[-1].seconds),
        "cut_short": count < plan.epochs * steps * plan.batch,
        "confusion": confusion.tolist(),
        "recordings": {name.removeprefix("recording "): said for name, said in takes.identity.items()},
    }


def _batch(takes: Takes, plan: RecognitionPlan, step: int, size: int) -> tuple[Tensor, Tensor]:
    """Takes of one step: every epoch has all of them, in an order of its own."""
    count = len(takes.kind)
    epoch, place = divmod(step, -(-count // size))
    order = np.random.default_rng(np.random.SeedSequence(plan.seed, spawn_key=(1, epoch))).permutation(count)
    index = torch.from_numpy(order[np.arange(place * size, (place + 1) * size) % count])
    maps = takes.maps[index]
    if plan.salt_and_pepper:
        noise = np.random.default_rng(np.random.SeedSequence(plan.seed, spawn_key=(2, step)))
        drawn = torch.from_numpy(noise.random(maps.shape, np.float32))
        low, high = maps.amin((2, 3), keepdim=True), maps.amax((2, 3), keepdim=True)
        maps = torch.where(drawn < plan.salt_and_pepper / 2, low, maps)
        maps = torch.where(drawn > 1 - plan.salt_and_pepper / 2, high, maps)
    return maps, takes.kind[index]


def _identity(takes: Takes, plan: RecognitionPlan, response: ArrayResponse) -> dict[str, str]:
    digest = hashlib.sha256(response.transfer_function.tobytes() + response.frequency.tobytes())
    own = hashlib.sha256(_numbers(takes.maps).tobytes() + _numbers(takes.kind).tobytes())
    return {
        **{f"plan.{name}": json.dumps(value) for name, value in identity_of(plan).items()},
        **takes.identity,
        "labels": ", ".join(takes.labels),
        "takes": own.hexdigest()[:16],
        "transfer_function": digest.hexdigest(),
        "torch": torch.__version__,
    }


def _numbers(tensor: Tensor) -> NDArray[Any]:
    return np.ascontiguousarray(tensor.numpy())

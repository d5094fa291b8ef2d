"""The trained localizer: signals in, probability per point out; saved as safetensors and JSON."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import torch

from geometry.ground.shown import Shown
from geometry.ground.typed import Array
from localize.graphs.description import LocalizerError, naming
from localize.learned.classifier import NetworkShape, TouchClassifier
from localize.learned.hypothesis_network import HypothesisClassifier, HypothesisShape
from localize.learned.localizer_description import (
    LocalizerDescription,
    classifier_of,
    read_model,
    save_model,
    with_weights,
)
from localize.signals.array_facts import ArrayFacts
from localize.signals.frames import combined_probability, cut_frames
from localize.signals.locator import Locator

FORMAT = "acoustic-fem localizer"
VERSION = 2
DESCRIPTION_FILE = "localizer.json"


@dataclass(frozen=True, eq=False, repr=False)
class Localizer(Shown, Locator):
    """Network trained on the transfer functions of one array, made by :func:`localize.train`."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        return f"Localizer of {self.design}", {
            "points": self.point_count,
            "microphones": ", ".join(self.microphones),
            "network": self.shape,
            "trained for": f"{self.plan.get('epochs')} epochs, seed {self.plan.get('seed')}",
        }

    classifier: TouchClassifier | HypothesisClassifier = field(repr=False)
    """Network with its features and normalisation."""
    shape: NetworkShape | HypothesisShape
    """Sizes of the network."""
    array: ArrayFacts
    """Array that it was trained for, and the noise of its training."""
    plan: Mapping[str, Any] = field(repr=False)
    """Fields of the training plan, seed included."""
    training: Mapping[str, Any] = field(repr=False)
    """Record of the training: loss and accuracy per epoch, seconds, touches."""

    @property
    def no_graph(self) -> str:
        """Empty: an ONNX graph can hold this localizer."""
        return ""

    def _probability(self, batch: Array) -> Array:
        frames = cut_frames(batch)
        flat = torch.from_numpy(frames.reshape(-1, *frames.shape[2:]).astype(np.float32))
        self.classifier.eval()
        with torch.inference_mode():
            logits = torch.cat([self.classifier(part) for part in flat.split(512)])
        per_frame = logits.double().log_softmax(-1).unflatten(0, frames.shape[:2])
        return combined_probability(per_frame.numpy())

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write ``localizer.json`` and the weights it names, as safetensors, into a folder.

        The description is renamed into place last: a run that is killed leaves the localizer that was there before.
        """
        description = {
            "format": FORMAT,
            "version": VERSION,
            "design": self.design,
            "microphones": list(self.microphones),
            "line": self.line.tolist(),
            "place": self.place.tolist(),
            "network": asdict(self.shape),
            "plan": dict(self.plan),
            "training": dict(self.training),
            "provenance": dict(self.provenance),
        }
        save_model(Path(folder) / DESCRIPTION_FILE, description, self.classifier)


def load_localizer(folder: str | os.PathLike[str]) -> Localizer:
    """Localizer that :meth:`Localizer.save` wrote, read back; it gives the same probabilities, bit for bit.

    Raises:
        LocalizerError: a file is missing, cut short, changed, too large or not of a localizer, or a value in it is not
            allowed.
    """
    path = Path(folder) / DESCRIPTION_FILE
    values, stated, weights = read_model(path, LocalizerDescription, (FORMAT, VERSION, "a localizer"), LocalizerError)
    with naming(path, LocalizerError):
        shape = stated.network.shape()
        classifier = with_weights(lambda: classifier_of(shape, len(stated.microphones)), weights)
    return Localizer(
        classifier=classifier,
        shape=shape,
        array=ArrayFacts(
            stated.design,
            tuple(stated.microphones),
            np.asarray(stated.line, np.int64),
            np.asarray(stated.place, np.int64),
            stated.provenance,
            float(values["training"]["microphone_noise"]),
        ),
        plan=values["plan"],
        training=values["training"],
    )

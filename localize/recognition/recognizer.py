"""The trained recognizer: the waveform of a touch in, probability per kind out; saved as safetensors and JSON."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import torch
from numpy.typing import ArrayLike, NDArray
from pydantic import Field
from torch import Tensor

from geometry.ground.refusal import Kind, Refusal
from localize.graphs.description import Digest, Strict, naming
from localize.learned.classifier import MapClassifier, NetworkShape
from localize.learned.localizer_description import Network, read_model, save_model, with_weights
from localize.recognition.power_maps import MAPS, WINDOW, maps_of
from localize.signals.threads import one_thread

FORMAT = "acoustic-fem recognizer"
VERSION = 2
DESCRIPTION_FILE = "recognizer.json"

_Name = Annotated[str, Field(min_length=1, max_length=200)]


class RecognizerError(Refusal):
    """Refusal of a recognizer that cannot be read: one line that names the file and the reason."""


class _Description(Strict):
    """Schema of ``recognizer.json``."""

    format: str
    version: int
    subject: _Name
    labels: Annotated[list[_Name], Field(min_length=2, max_length=1000)]
    design: _Name
    microphones: Annotated[list[_Name], Field(min_length=2, max_length=16)]
    at_usual_speed: bool
    network: Network
    plan: dict[str, Any]
    training: dict[str, Any]
    provenance: dict[str, Any]
    weights: Annotated[str, Field(pattern=r"^weights-[0-9a-f]{12}\.safetensors$")]
    weights_sha256: Digest
    sha256: Digest


@dataclass(frozen=True, eq=False)
class Recognizer:
    """Network that recognizes kinds of touch, made by :func:`localize.train_recognizer`."""

    classifier: MapClassifier = field(repr=False)
    """Network with its normalisation."""
    shape: NetworkShape
    """Sizes of the network."""
    subject: str
    """Sort of what it tells: events, textures, or the labels of recordings."""
    labels: tuple[str, ...]
    """Kinds that it tells."""
    design: str
    """Name of the design."""
    microphones: tuple[str, ...]
    """Names of the microphones of the array."""
    at_usual_speed: bool
    """True if it expects waveforms of sliding as they are at 12 mm/s."""
    plan: Mapping[str, Any] = field(repr=False)
    """Fields of the plan, seed included."""
    training: Mapping[str, Any] = field(repr=False)
    """Record of the training: loss and accuracy per epoch, confusions, seconds."""
    provenance: Mapping[str, Any] = field(repr=False)
    """Design, fidelity, air, frequencies and versions."""

    def recognize(self, waveforms: ArrayLike) -> NDArray[np.float64]:
        """Probability of each kind of touch for a waveform.

        Args:
            waveforms: (n, 1024) float64 or (1024,), Pa or any other unit, at 1 kHz; of sliding, at 12 mm/s.

        Returns:
            (n, n_label) or (n_label,) float64: probability per kind.

        Raises:
            Refusal: another number of samples, or a value that is not finite.
        """
        given = np.asarray(waveforms, np.float64)
        batch = np.atleast_2d(given)
        if batch.ndim != 2 or batch.shape[1] != WINDOW:
            raise Refusal(f"has shape {given.shape}, must be (n, {WINDOW})", kind=Kind.WRONG_TYPE, field="waveforms")
        if not np.isfinite(batch).all():
            raise Refusal("must be finite", kind=Kind.UNSUITABLE, field="waveforms")
        probability = self.of_maps(maps_of(batch))
        return probability if given.ndim == 2 else probability[0]

    @one_thread()
    def of_maps(self, maps: Tensor) -> NDArray[np.float64]:
        """Probability per kind.

        Args:
            maps: (n, n_map, 64, 32) float32, as it was trained on.

        Returns:
            (n, n_label) float64.
        """
        self.classifier.eval()
        with torch.inference_mode():
            logits = torch.cat([self.classifier(part) for part in maps.split(512)])
        return np.asarray(logits.double().softmax(-1).numpy())

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write ``recognizer.json`` and the weights it names into a folder; a run that is killed leaves what was
        there before.
        """
        description = {
            "format": FORMAT,
            "version": VERSION,
            "subject": self.subject,
            "labels": list(self.labels),
            "design": self.design,
            "microphones": list(self.microphones),
            "at_usual_speed": self.at_usual_speed,
            "network": asdict(self.shape),
            "plan": dict(self.plan),
            "training": dict(self.training),
            "provenance": dict(self.provenance),
        }
        save_model(Path(folder) / DESCRIPTION_FILE, description, self.classifier)


def load_recognizer(folder: str | os.PathLike[str]) -> Recognizer:
    """Recognizer that :meth:`Recognizer.save` wrote, read back; it gives the same probabilities, bit for bit.

    Raises:
        RecognizerError: a file is missing, cut short, changed, too large or not of a recognizer, or a value in it is
            not allowed.
    """
    path = Path(folder) / DESCRIPTION_FILE
    values, said, weights = read_model(path, _Description, (FORMAT, VERSION, "a recognizer"), RecognizerError)
    with naming(path, RecognizerError):
        shape = said.network.shape()
        if (shape.points, shape.maps) != (len(said.labels), MAPS):
            raise Refusal(
                f"network.points = {shape.points} and network.maps = {shape.maps} must be {len(said.labels)}, the "
                f"number of labels, and {MAPS}",
                kind=Kind.MISMATCH,
            )
        classifier = with_weights(lambda: MapClassifier(shape), weights)
    return Recognizer(
        classifier=classifier,
        shape=shape,
        subject=said.subject,
        labels=tuple(said.labels),
        design=said.design,
        microphones=tuple(said.microphones),
        at_usual_speed=said.at_usual_speed,
        plan=values["plan"],
        training=values["training"],
        provenance=said.provenance,
    )

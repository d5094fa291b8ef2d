"""The trained localizer: signals in, probability per point out; saved as safetensors and JSON."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import torch
from numpy.typing import ArrayLike, NDArray
from torch import Tensor

from localize.graphs.description import LocalizerError, naming
from localize.learned.classifier import NetworkShape, TouchClassifier
from localize.learned.localizer_description import LocalizerDescription, read_model, save_model, with_weights
from localize.signals.frames import checked_signals, combined_probability, cut_frames
from localize.signals.threads import one_thread

FORMAT = "acoustic-fem localizer"
VERSION = 1
DESCRIPTION_FILE = "localizer.json"


@dataclass(frozen=True, eq=False)
class Localizer:
    """Network trained on the transfer functions of one array, made by :func:`localize.train`."""

    classifier: TouchClassifier = field(repr=False)
    """Network with its features and normalisation."""
    shape: NetworkShape
    """Sizes of the network."""
    design: str
    """Name of the design."""
    microphones: tuple[str, ...]
    """Names of the microphones, in the order of the signals."""
    line: NDArray[np.int64]
    """Line of each point, as the library numbers it; (n_point,) int64."""
    place: NDArray[np.int64]
    """Place of each point along its line, as the library numbers it; (n_point,) int64."""
    plan: Mapping[str, Any] = field(repr=False)
    """Fields of the training plan, seed included."""
    training: Mapping[str, Any] = field(repr=False)
    """Record of the training: loss and accuracy per epoch, seconds, touches."""
    provenance: Mapping[str, Any] = field(repr=False)
    """Design, fidelity, air, frequencies and versions."""

    @property
    def kind(self) -> str:
        """Kind of localizer, as graphs state theirs."""
        return "network"

    @property
    def point_count(self) -> int:
        """Number of sensing points."""
        return self.shape.points

    @property
    def noise_rms(self) -> float:
        """Noise of every microphone in training, Pa rms."""
        return float(self.training["microphone_noise"])

    @one_thread()
    def locate(self, signals: ArrayLike | Tensor) -> NDArray[np.float64]:
        """Where the array was touched.

        A recording longer than 250 samples is cut into frames, the last one ending with it, which are taken as
        independent observations of one touch.

        Args:
            signals: (n_microphone, n_sample) or (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples.

        Returns:
            (n_point,) or (n, n_point) float64: probability per point.

        Raises:
            Refusal: wrong number of channels, too few samples, a value that is not finite, a silent channel.
        """
        batch, batched = checked_signals(signals, self.microphones)
        frames = cut_frames(batch)
        flat = torch.from_numpy(frames.reshape(-1, *frames.shape[2:]).astype(np.float32))
        self.classifier.eval()
        with torch.inference_mode():
            logits = torch.cat([self.classifier(part) for part in flat.split(512)])
        per_frame = logits.double().log_softmax(-1).unflatten(0, frames.shape[:2])
        probability = combined_probability(per_frame.numpy())
        return probability if batched else probability[0]

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
    values, said, weights = read_model(path, LocalizerDescription, (FORMAT, VERSION, "a localizer"), LocalizerError)
    with naming(path, LocalizerError):
        shape = said.network.shape()
        classifier = with_weights(lambda: TouchClassifier(len(said.microphones), shape), weights)
    return Localizer(
        classifier=classifier,
        shape=shape,
        design=said.design,
        microphones=tuple(said.microphones),
        line=np.asarray(said.line, np.int64),
        place=np.asarray(said.place, np.int64),
        plan=values["plan"],
        training=values["training"],
        provenance=said.provenance,
    )

"""The trained localizer: signals in, probability per point out; saved as safetensors and JSON."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import torch
from numpy.typing import ArrayLike, NDArray
from torch import Tensor

from geometry.files.writing import whole_file, write_text
from geometry.refusal import Refusal
from localize.learned.classifier import NetworkShape, TouchClassifier
from localize.signals.frames import checked_signals, combined_probability, cut_frames
from localize.signals.threads import one_thread

FORMAT = "acoustic-fem localizer"
VERSION = 1
DESCRIPTION_FILE = "localizer.json"


class LocalizerError(Refusal):
    """Refusal of a localizer that cannot be read: one line that names the file and the reason."""


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
        frames = cut_frames(batch.to(torch.float32))
        self.classifier.eval()
        with torch.inference_mode():
            logits = torch.cat([self.classifier(part) for part in frames.flatten(0, 1).split(512)])
        per_frame = logits.double().log_softmax(-1).unflatten(0, frames.shape[:2])
        probability = combined_probability(per_frame).numpy()
        return probability if batched else probability[0]

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write ``localizer.json`` and the weights it names, as safetensors, into a folder.

        The description is renamed into place last: a run that is killed leaves the localizer that was there before.
        """
        from safetensors.torch import save

        folder = Path(folder)
        folder.mkdir(parents=True, exist_ok=True)
        weights = save({name: value.contiguous() for name, value in self.classifier.state_dict().items()})
        digest = hashlib.sha256(weights).hexdigest()
        description = {
            "format": FORMAT,
            "version": VERSION,
            "weights": f"weights-{digest[:12]}.safetensors",
            "weights_sha256": digest,
            "design": self.design,
            "microphones": list(self.microphones),
            "line": self.line.tolist(),
            "place": self.place.tolist(),
            "network": asdict(self.shape),
            "plan": dict(self.plan),
            "training": dict(self.training),
            "provenance": dict(self.provenance),
        }
        with whole_file(folder / description["weights"]) as beside:
            beside.write_bytes(weights)
        write_text(folder / DESCRIPTION_FILE, json.dumps(description, indent=1))
        for old in folder.glob("weights-*.safetensors"):
            if old.name != description["weights"]:
                old.unlink()


def load_localizer(folder: str | os.PathLike[str]) -> Localizer:
    """Localizer that :meth:`Localizer.save` wrote, read back; it gives the same probabilities, bit for bit.

    Raises:
        LocalizerError: a file is missing, cut short, or not of a localizer.
    """
    from safetensors import SafetensorError
    from safetensors.torch import load

    path = Path(folder) / DESCRIPTION_FILE
    try:
        text = path.read_bytes()
    except OSError as error:
        raise LocalizerError(f"{path}: cannot be read: {error.strerror or error}") from None
    try:
        description = json.loads(text)
    except ValueError:
        raise LocalizerError(f"{path}: cut short or not JSON") from None
    if not isinstance(description, dict) or description.get("format") != FORMAT:
        raise LocalizerError(f"{path}: not a localizer: its format is not {FORMAT!r}")
    if description.get("version") != VERSION:
        raise LocalizerError(f"{path}: version = {description.get('version')} must be {VERSION}")
    try:
        weights_path = path.parent / Path(description["weights"]).name
        digest = description["weights_sha256"]
        network = description["network"]
        shape = NetworkShape(**{**network, "depths": tuple(network["depths"]), "patch": tuple(network["patch"])})
        microphones = tuple(str(name) for name in description["microphones"])
        classifier = TouchClassifier(len(microphones), shape)
        line, place = (np.asarray(description[name], np.int64) for name in ("line", "place"))
        if line.shape != (shape.points,) or place.shape != (shape.points,):
            raise Refusal(f"line and place must hold {shape.points} values")
        rest = {name: description[name] for name in ("design", "plan", "training", "provenance")}
    except (KeyError, TypeError, ValueError) as error:
        reason = f"{error} is missing" if isinstance(error, KeyError) else str(error)
        raise LocalizerError(f"{path}: {reason}") from None
    try:
        weights = weights_path.read_bytes()
    except OSError as error:
        raise LocalizerError(f"{weights_path}: cannot be read: {error.strerror or error}") from None
    if hashlib.sha256(weights).hexdigest() != digest:
        raise LocalizerError(f"{weights_path}: cut short or changed: its checksum is not the one in {path.name}")
    try:
        classifier.load_state_dict(load(weights))
    except (SafetensorError, RuntimeError) as error:
        raise LocalizerError(f"{weights_path}: does not fit the network of {path.name}: {error}") from None
    classifier.eval()
    return Localizer(classifier=classifier, shape=shape, microphones=microphones, line=line, place=place, **rest)

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

from geometry.files.ordinary import library_reads, read_bytes
from geometry.files.reading import parse_json
from geometry.files.writing import whole_file, write_text
from geometry.refusal import Refusal
from localize.learned.classifier import NetworkShape, TouchClassifier
from localize.learned.description import (
    LARGEST_DESCRIPTION,
    LARGEST_MODEL,
    LocalizerDescription,
    check_format,
    described,
    is_sealed,
    sealed,
)
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
        write_text(folder / DESCRIPTION_FILE, json.dumps(sealed(description), indent=1))
        for old in folder.glob("weights-*.safetensors"):
            if old.name != description["weights"]:
                old.unlink()


def load_localizer(folder: str | os.PathLike[str]) -> Localizer:
    """Localizer that :meth:`Localizer.save` wrote, read back; it gives the same probabilities, bit for bit.

    Raises:
        LocalizerError: a file is missing, cut short, changed, too large or not of a localizer, or a value in it is not
            allowed.
    """
    from safetensors.torch import load

    path = Path(folder) / DESCRIPTION_FILE
    text = read_bytes(path, "a localizer's description", LocalizerError, LARGEST_DESCRIPTION)
    values = parse_json(text, str(path), LocalizerError)
    check_format(values, FORMAT, VERSION, path, LocalizerError)
    said = described(LocalizerDescription, text, path, LocalizerError)
    if not is_sealed(values):
        raise LocalizerError(f"{path}: changed or damaged: its checksum is not that of what it says")
    weights_path = path.parent / said.weights
    weights = read_bytes(weights_path, "the weights of a localizer", LocalizerError, LARGEST_MODEL)
    if hashlib.sha256(weights).hexdigest() != said.weights_sha256:
        raise LocalizerError(f"{weights_path}: cut short or changed: its checksum is not the one in {path.name}")
    with library_reads(weights_path, "the weights of a localizer", LocalizerError):
        tensors = load(weights)
    network = said.network
    try:
        shape = NetworkShape(
            **{**network.model_dump(), "depths": tuple(network.depths), "patch": (network.patch[0], network.patch[1])}
        )
        classifier = _classifier(len(said.microphones), shape, tensors)
    except Refusal as error:
        raise LocalizerError(f"{path}: {error}") from None
    classifier.eval()
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


def _classifier(microphones: int, shape: NetworkShape, weights: Mapping[str, Tensor]) -> TouchClassifier:
    """Network with weights that fit it; it is laid out without memory first, so that it never takes more than they do.

    Raises:
        Refusal: other weights than the network has, or some that are not finite.
    """
    with torch.device("meta"):
        wanted = TouchClassifier(microphones, shape).state_dict()
    for name in sorted({*wanted, *weights}):
        if name not in wanted or name not in weights:
            raise Refusal(
                f"the weights do not fit the network: {name} is {'none of it' if name in weights else 'missing'}"
            )
        mine, other = ((tuple(each[name].shape), each[name].dtype) for each in (wanted, weights))
        if mine != other:
            raise Refusal(f"the weights do not fit the network: {name} is {other}, must be {mine}")
        if not torch.isfinite(weights[name]).all():
            raise Refusal(f"the weights hold a value of {name} that is not finite")
    classifier = TouchClassifier(microphones, shape)
    classifier.load_state_dict(dict(weights))
    return classifier

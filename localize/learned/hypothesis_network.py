"""The network of hypotheses: likelihoods of a frame under each hypothesis, weighed by a small network.

Each hypothesis of each point gives some features, :mod:`localize.learned.hypothesis_features`. One network, the same
for all of them, makes a score of each, and those of a point are summed as probabilities. It begins as a plain sum of
the logarithms, which names most touches already; training finds what to believe when.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import torch
from torch import Tensor, nn

from geometry.ground.refusal import Kind, Refusal
from localize.decoders.library_decoder import LibraryDecoder
from localize.decoders.tolerant import TolerantDecoder
from localize.learned.classifier import Classifier
from localize.learned.hypothesis_features import SHARES, HypothesisFeatures, feature_count
from localize.signals.frames import FRAME

WIDTH = 48
"""Width of the network's layers: 64 does not do better."""
FIRST_WEIGHT = (4.0, 4.0, 4.0, 2.0, 1.0, 1.0, 1.0)
"""Weights of the residuals of each share before training: about half the number of directions that a touch leaves."""
TEMPERATURES = (0.25, 4.0, 65)
"""Lowest and highest temperature that probabilities are calibrated with, and how many are tried."""


@dataclass(frozen=True)
class HypothesisShape:
    """Sizes of a network of hypotheses."""

    points: int
    """Number of points."""
    hypotheses: int
    """Number of hypotheses of each point."""
    microphones: int
    """Number of microphones."""
    size: int
    """Size of a frame where noise is white."""
    rank: int
    """Number of directions in which a touch moves a frame."""
    shapes: int
    """Number of shapes in which these deviate, or 0."""
    width: int = WIDTH
    """Width of the network's layers."""

    def __post_init__(self) -> None:
        for name, value, least in (
            ("points", self.points, 2),
            ("hypotheses", self.hypotheses, 1),
            ("microphones", self.microphones, 2),
            ("rank", self.rank, 1),
            ("size", self.size, self.rank + 1),
            ("shapes", self.shapes, 0),
            ("width", self.width, 1),
        ):
            if value < least:
                raise Refusal(kind=Kind.OUT_OF_RANGE, field=f"network.{name}", value=value, allowed=f"at least {least}")

    @classmethod
    def of(cls, decoder: LibraryDecoder, most_shapes: int) -> Self:
        """Sizes of a decoder's tables.

        Args:
            decoder: of the array.
            most_shapes: shapes at most.
        """
        tables, size, rank = decoder.tables[0].vectors.shape
        shapes = min(most_shapes, decoder.shapes) if isinstance(decoder, TolerantDecoder) else 0
        return cls(decoder.point_count, tables // decoder.point_count, len(decoder.microphones), size, rank, shapes)


class HypothesisHead(nn.Module):
    """Scores of hypotheses from their features, (n, n_point, n_hypothesis, n_feature), to one logit per point."""

    def __init__(self, features: int, width: int) -> None:
        super().__init__()
        self.straight = nn.Linear(features, 1, bias=False)
        self.layers = nn.Sequential(
            nn.Linear(features, width), nn.GELU(), nn.Linear(width, width), nn.GELU(), nn.Linear(width, 1)
        )

    def begin(self, scale: Tensor) -> None:
        """Begin as the sum of the logarithms, for features that are divided by a scale, (n_feature,)."""
        weight = torch.zeros_like(scale)
        weight[: len(SHARES)] = -torch.tensor(FIRST_WEIGHT, device=scale.device)
        weight[-1] = 1.0
        with torch.no_grad():
            self.straight.weight.copy_(weight * scale)
            last = self.layers[-1]
            assert isinstance(last, nn.Linear)
            last.weight.zero_()
            last.bias.zero_()

    def forward(self, features: Tensor) -> Tensor:
        """Logits of a batch of normalised features; (n, n_point) float32."""
        return torch.logsumexp((self.straight(features) + self.layers(features))[..., 0], 2)


class HypothesisClassifier(Classifier):
    """Classifier of frames (n, n_microphone, 250), one logit per point: features, normalisation, network."""

    mean: Tensor
    """Mean of each feature; (n_feature,) float32."""
    scale: Tensor
    """Standard deviation of each feature, at least 1e-3; (n_feature,) float32."""
    temperature: Tensor
    """Divisor of the logits, which calibrates probabilities; () float32."""

    def __init__(self, shape: HypothesisShape) -> None:
        super().__init__()
        self.features = HypothesisFeatures(
            shape.points, shape.hypotheses, shape.microphones * FRAME, shape.size, shape.rank, shape.shapes
        )
        count = feature_count(shape.shapes)
        self.register_buffer("mean", torch.zeros(count))
        self.register_buffer("scale", torch.ones(count))
        self.register_buffer("temperature", torch.ones(()))
        self.network: HypothesisHead = HypothesisHead(count, shape.width)

    def take(self, decoder: LibraryDecoder) -> None:
        """Take the hypotheses of a decoder of the shape that it was made for."""
        if isinstance(decoder, TolerantDecoder):
            self.features.take(decoder.tables[0], decoder.deviating[0], decoder.log_prior)
        else:
            self.features.take(decoder.tables[0], None, self.features.prior.numpy())

    def fit_normalisation(self, inputs: Tensor) -> None:
        """Take mean and standard deviation of the features over frames, (n, n_microphone, 250) float32, Pa."""
        features = self.features(inputs)
        self.mean.copy_(features.mean((0, 1, 2)))
        self.scale.copy_(features.std((0, 1, 2)).clamp_min(1e-3))
        self.network.begin(self.scale)

    def maps(self, inputs: Tensor) -> Tensor:
        """Normalised features of a batch of frames; nothing is differentiated through them.

        Args:
            inputs: (n, n_microphone, 250) float32, Pa, at 1 kHz.

        Returns:
            (n, n_point, n_hypothesis, n_feature) float32.
        """
        with torch.no_grad():
            return (self.features(inputs) - self.mean) / self.scale

    def forward(self, inputs: Tensor) -> Tensor:
        """Logits of a batch of frames.

        Args:
            inputs: (n, n_microphone, 250) float32, Pa, at 1 kHz.

        Returns:
            (n, n_point) float32.
        """
        return self.network(self.maps(inputs)) / self.temperature

    def calibrate(self, inputs: Tensor, label: Tensor) -> None:
        """Find the temperature with which probabilities of touches that were held out are most likely.

        Args:
            inputs: (n, n_microphone, 250) float32, Pa.
            label: their points, from 0; (n,) int64.
        """
        self.eval()
        with torch.inference_mode():
            logits = torch.cat([self.network(self.maps(part)) for part in inputs.split(512)])
            low, high, count = TEMPERATURES
            tried = torch.logspace(math.log10(low), math.log10(high), count, device=logits.device)
            loss = torch.stack([nn.functional.cross_entropy(logits / each, label) for each in tried])
        self.temperature.fill_(float(tried[loss.argmin()]))

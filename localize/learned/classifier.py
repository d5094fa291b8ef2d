"""A small convolutional classifier in the manner of FasterNet (Chen et al. 2023, "Run, Don't Walk").

An embedding cuts the maps into patches; stages of partial-convolution blocks follow, with a merging layer between them
that halves both sides and doubles the channels; the mean over what is left feeds a linear layer. Partial convolution
means that the 3 x 3 filter sees a quarter of the channels, the 1 x 1 filters all of them.

:data:`localize.learned.network_sizes.NETWORKS` names the shapes that are offered. The network of the paper merges after
the last stage as well. Five mergings leave 2 x 1 of 64 x 32, so that its embedding must not cut the maps into patches.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial

import torch
from torch import Tensor, nn

from geometry.ground.refusal import Kind, Refusal, counted
from localize.layers.gradients import Layer, Stages, block, merging, normalisation, patches_of_maps
from localize.layers.partial_block import PARTIAL, PartialBlock, PatchConvolution
from localize.learned.features import COLUMNS, FeatureChoice, PairFeatures
from localize.learned.wavelets import FREQUENCIES


@dataclass(frozen=True)
class NetworkShape:
    """Sizes of the network; checked against the maps when it is made."""

    maps: int
    """Number of maps at its input."""
    points: int
    """Number of logits at its output, one per point."""
    width: int = 32
    """Number of channels of the embedding; each merging doubles them."""
    depths: tuple[int, ...] = (1, 2, 2)
    """Number of blocks of each stage."""
    patch: tuple[int, int] = (4, 8)
    """Rows (frequency) and columns (time) of the embedding's patches."""
    merge_last: bool = False
    """True if a merging layer follows the last stage too."""
    features: FeatureChoice = "phasors"
    """Choice of the maps, see :mod:`localize.learned.features`."""

    def __post_init__(self) -> None:
        if not self.depths or min(self.depths) < 1:
            raise Refusal(
                kind=Kind.OUT_OF_RANGE,
                field="network.depths",
                value=self.depths,
                allowed="at least one stage, of at least one block each",
            )
        for name, value, least in (("maps", self.maps, 1), ("points", self.points, 2), ("width", self.width, PARTIAL)):
            if value < least:
                raise Refusal(kind=Kind.OUT_OF_RANGE, field=f"network.{name}", value=value, allowed=f"at least {least}")
        if self.width % PARTIAL:
            raise Refusal(
                kind=Kind.OUT_OF_RANGE, field="network.width", value=self.width, allowed=f"a multiple of {PARTIAL}"
            )
        merged = self.mergings
        for name, size, patch in (("rows", FREQUENCIES, self.patch[0]), ("columns", COLUMNS, self.patch[1])):
            if patch < 1 or size % (patch * 2**merged):
                raise Refusal(
                    f"cannot cut {size} {name} of a map into patches of {patch} and halve them {merged} times; "
                    f"patch x {2**merged} must divide {size}",
                    kind=Kind.OUT_OF_RANGE,
                    field="network.patch",
                    value=self.patch,
                )

    @property
    def mergings(self) -> int:
        """Number of mergings, each of which halves both sides of the maps, behind the embedding."""
        return len(self.depths) - (0 if self.merge_last else 1)


class TouchNetwork(nn.Module):
    """Network from maps (n, maps, 64, 32) to one logit per point, (n, points)."""

    def __init__(self, shape: NetworkShape) -> None:
        super().__init__()
        width = shape.width
        layers: list[nn.Module] = [
            PatchConvolution(shape.maps, width, shape.patch),
            nn.BatchNorm2d(width),
        ]
        for stage, depth in enumerate(shape.depths):
            layers += [PartialBlock(width) for _ in range(depth)]
            if stage < shape.mergings:
                layers += [PatchConvolution(width, 2 * width, 2), nn.BatchNorm2d(2 * width)]
                width *= 2
        self.stages = nn.Sequential(*layers)
        self.head = nn.Linear(width, shape.points)

    def forward(self, maps: Tensor) -> Tensor:
        """Logits of a batch of normalised maps.

        Args:
            maps: (n, n_map, 64, 32) float32.

        Returns:
            (n, points) float32.
        """
        by_hand = self.training and maps.device.type == "cpu" and not torch.is_autocast_enabled("cpu")
        left = Stages.apply(maps, self._layers(), *self.stages.parameters()) if by_hand else self.stages(maps)
        return self.head(left.mean((-2, -1)))

    def _layers(self) -> Iterator[Layer]:
        """The stages, each with its gradients."""
        for number, layer in enumerate(self.stages):
            if isinstance(layer, PatchConvolution):
                yield partial(merging if number else patches_of_maps, layer)
            elif isinstance(layer, PartialBlock):
                yield partial(block, layer)
            elif isinstance(layer, nn.BatchNorm2d):
                yield partial(normalisation, layer)


class Classifier(nn.Module, ABC):
    """Module that makes one logit per class of a batch of inputs, in two parts: what is learned, and what is not."""

    network: nn.Module
    """Learned part: from what :meth:`maps` gives to logits, (n, n_class) float32."""

    @abstractmethod
    def maps(self, inputs: Tensor) -> Tensor:
        """Inputs of the learned part, (n, ...) float32; nothing is differentiated through them.

        Args:
            inputs: a batch.
        """

    @abstractmethod
    def fit_normalisation(self, inputs: Tensor) -> None:
        """Take mean and standard deviation of the maps over inputs."""


class MapClassifier(Classifier):
    """Classifier of maps (n, maps, 64, 32), one logit per class: normalisation and network."""

    mean: Tensor
    """Mean of each map and row over what :meth:`fit_normalisation` was given; (1, maps, 64, 1) float32."""
    scale: Tensor
    """Standard deviation of each map and row over these inputs, at least 1e-3; (1, maps, 64, 1) float32."""

    def __init__(self, shape: NetworkShape) -> None:
        super().__init__()
        # One mean and one scale per map and row, found from the training signals.
        self.register_buffer("mean", torch.zeros(1, shape.maps, FREQUENCIES, 1))
        self.register_buffer("scale", torch.ones(1, shape.maps, FREQUENCIES, 1))
        self.network = TouchNetwork(shape)
        for parameter in self.network.parameters():
            if parameter.ndim == 4:  # the faster layout for small convolutions on a processor
                parameter.data = parameter.data.contiguous(memory_format=torch.channels_last)

    def raw_maps(self, inputs: Tensor) -> Tensor:
        """Maps of a batch of inputs before they are normalised: here the inputs are the maps.

        Args:
            inputs: (n, n_map, 64, 32) float32.

        Returns:
            (n, n_map, 64, 32) float32.
        """
        return inputs

    def fit_normalisation(self, inputs: Tensor) -> None:
        """Take mean and standard deviation of the maps over inputs.

        Args:
            inputs: as of :meth:`raw_maps`.
        """
        maps = self.raw_maps(inputs)
        self.mean.copy_(maps.mean((0, 3), keepdim=True))
        self.scale.copy_(maps.std((0, 3), keepdim=True).clamp_min(1e-3))

    def maps(self, inputs: Tensor) -> Tensor:
        """Normalised maps of a batch of inputs; nothing is differentiated through them.

        Args:
            inputs: as of :meth:`raw_maps`.

        Returns:
            (n, n_map, 64, 32) float32.
        """
        with torch.no_grad():
            return (self.raw_maps(inputs) - self.mean).div_(self.scale)

    def forward(self, inputs: Tensor) -> Tensor:
        """Logits of a batch of inputs.

        Args:
            inputs: as of :meth:`raw_maps`.

        Returns:
            (n, n_class) float32.
        """
        return self.network(self.maps(inputs))


class TouchClassifier(MapClassifier):
    """Classifier of frames (n, n_microphone, 250), one logit per point: features, normalisation, network."""

    def __init__(self, microphones: int, shape: NetworkShape) -> None:
        super().__init__(shape)
        self.features = PairFeatures(microphones, shape.features)
        if shape.maps != self.features.map_count:
            raise Refusal(
                kind=Kind.MISMATCH,
                field="network.maps",
                value=shape.maps,
                allowed=f"{self.features.map_count} for {counted(microphones, 'microphone')}",
            )

    def raw_maps(self, inputs: Tensor) -> Tensor:
        """Level and phase differences of a batch of frames.

        Args:
            inputs: (n, n_microphone, 250) float32, Pa, at 1 kHz.

        Returns:
            (n, n_map, 64, 32) float32.
        """
        return self.features(inputs)

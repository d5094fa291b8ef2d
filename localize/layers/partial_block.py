"""Blocks of partial convolutions, and convolutions of patches, as FasterNet has them (Chen et al. 2023)."""

from __future__ import annotations

from typing import cast

import torch
from torch import Tensor, nn

EXPANSION = 2
"""Number of channels inside a block, in multiples of its width."""
PARTIAL = 4
"""Ratio of a block's channels to those that are filtered in space."""


class PatchConvolution(nn.Conv2d):
    """Convolution whose stride is the size of its kernel, without bias; in training it is one matrix product, which
    takes two thirds of the time of a convolution and its gradients on a processor.
    """

    def __init__(self, inputs: int, outputs: int, size: int | tuple[int, int]) -> None:
        super().__init__(inputs, outputs, size, stride=size, bias=False)

    def forward(self, x: Tensor) -> Tensor:
        """Channels of each patch.

        Args:
            x: (n, n_input, m, k) float32.

        Returns:
            (n, n_output, m, k) float32, m rows and k columns of patches.
        """
        if not self.training:
            return super().forward(x)
        (high, wide), (_, _, rows, columns) = self.kernel_size, x.shape
        parts = x.unflatten(3, (columns // wide, wide)).unflatten(2, (rows // high, high))
        if x.is_contiguous():
            patches, weight = parts.permute(0, 2, 4, 1, 3, 5), self.weight
        else:  # channels last, the layout of what comes out of any layer here
            patches, weight = parts.permute(0, 2, 4, 3, 5, 1), self.weight.permute(0, 2, 3, 1)
        return nn.functional.linear(patches.flatten(3), weight.flatten(1)).permute(0, 3, 1, 2)


class PartialBlock(nn.Module):
    """Block of a 3 x 3 filter on the first quarter of the channels, then 1 x 1 up and down, added to its input."""

    def __init__(self, width: int) -> None:
        super().__init__()
        self.part = width // PARTIAL
        self.spatial = nn.Conv2d(self.part, self.part, 3, padding=1, bias=False)
        self.mix = nn.Sequential(
            PatchConvolution(width, EXPANSION * width, 1),
            nn.BatchNorm2d(EXPANSION * width),
            nn.ReLU(inplace=True),
            PatchConvolution(EXPANSION * width, width, 1),
        )

    @property
    def parts(self) -> tuple[nn.Conv2d, nn.BatchNorm2d, nn.Conv2d]:
        """The way up, its normalisation, and the way down."""
        up, norm, _, down = self.mix.children()
        return cast(nn.Conv2d, up), cast(nn.BatchNorm2d, norm), cast(nn.Conv2d, down)

    def forward(self, x: Tensor) -> Tensor:
        """Channels behind the block.

        Args:
            x: (n, n_channel, m, k).

        Returns:
            Same shape as ``x``.
        """
        filtered = torch.cat([self.spatial(x[:, : self.part]), x[:, self.part :]], 1)
        return x + self.mix(filtered)

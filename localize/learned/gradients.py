"""Layers of the network with their gradients, written out for training on a processor.

What the layers compute stays the same. Written out, every matrix lies in memory with the channels of a place side by
side, whatever layer its gradient comes from, and a filter of few columns is one matrix product: together they take two
thirds of the time that automatic differentiation takes.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
import torch
from torch import Tensor

FEW = 4
"""Most columns of maps on which the 3 x 3 filter is a matrix over all columns: on more, most of it would be zeros."""


class PatchProduct(torch.autograd.Function):
    """Convolution whose stride is the size of its kernel, without bias."""

    @staticmethod
    def forward(ctx: Any, x: Tensor, weight: Tensor) -> Tensor:
        """Channels of each patch; (n, n_input, rows, columns) and (n_output, n_input, high, wide) to (n, n_output, rows
        / high, columns / wide).
        """
        patches, last = _patches(x, weight.shape[2:])
        flat = _flat(weight, last)
        ctx.save_for_backward(patches, weight)
        ctx.last, ctx.shape = last, x.shape
        return (patches @ flat.T).unflatten(0, _places(x, weight)).permute(0, 3, 1, 2)

    @staticmethod
    def backward(ctx: Any, *gradients: Tensor) -> tuple[Tensor | None, Tensor]:
        """Gradients of the maps and of the weights."""
        patches, weight = ctx.saved_tensors
        output = _in_rows(gradients[0])
        of_weight = (output.T @ patches).view(_flat_shape(weight, ctx.last))
        if ctx.last:
            of_weight = of_weight.permute(0, 3, 1, 2)
        if not ctx.needs_input_grad[0]:
            return None, of_weight
        of_patches = output @ _flat(weight, ctx.last)
        (n, channels, rows, columns), (high, wide) = ctx.shape, weight.shape[2:]
        if ctx.last:
            parts = of_patches.view(n, rows // high, columns // wide, high, wide, channels)
            return parts.transpose(2, 3).reshape(n, rows, columns, channels).permute(0, 3, 1, 2), of_weight
        parts = of_patches.view(n, rows // high, columns // wide, channels, high, wide)
        return parts.permute(0, 3, 1, 4, 2, 5).reshape(ctx.shape), of_weight


class BlockPass(torch.autograd.Function):
    """A whole :class:`localize.learned.classifier.PartialBlock`."""

    @staticmethod
    def forward(
        ctx: Any,
        x: Tensor,
        spatial: Tensor,
        up: Tensor,
        gain: Tensor,
        shift: Tensor,
        down: Tensor,
        running: tuple[Tensor, Tensor, float, float],
    ) -> Tensor:
        """Channels behind the block.

        Args:
            ctx: of autograd.
            x: (n, width, rows, columns), channels last in memory.
            spatial: (part, part, 3, 3), the filter of the first channels.
            up: (n_inside, width, 1, 1).
            gain: (n_inside,), weight of the batch normalisation.
            shift: (n_inside,), its bias.
            down: (width, n_inside, 1, 1).
            running: mean and variance of the batch normalisation, which are moved, its momentum and its epsilon.

        Returns:
            Same shape as ``x``.
        """
        rows = _in_rows(x)
        part = len(spatial)
        filtered = rows.clone()
        places = filtered.view(len(x), *x.shape[2:], -1)
        first = places[..., :part]
        seen, kernel = _seen(first), _kernel(spatial, x.shape[3])
        first.copy_((seen @ kernel).view(first.shape))
        inside = filtered @ up.flatten(1).T
        mean, variance, momentum, epsilon = running
        active, centre, scale = torch.native_batch_norm(
            _as_maps(inside, x), gain, shift, mean, variance, True, momentum, epsilon
        )
        active = _in_rows(active).relu_()
        ctx.save_for_backward(seen, kernel, filtered, inside, active, centre, scale, up, gain, down)
        ctx.running = running
        return _as_maps(torch.addmm(rows, active, down.flatten(1).T), x)

    @staticmethod
    def backward(ctx: Any, *gradients: Tensor) -> tuple[Tensor | None, ...]:
        """Gradients of what :meth:`forward` takes, its filters and normalisation included."""
        seen, kernel, filtered, inside, active, centre, scale, up, gain, down = ctx.saved_tensors
        mean, variance, _, epsilon = ctx.running
        maps = gradients[0]
        part = kernel.shape[1] // maps.shape[3]
        output = _in_rows(maps)
        of_down = (output.T @ active).view(down.shape)
        of_active = output @ down.flatten(1)
        torch.ops.aten.threshold_backward.grad_input(of_active, active, 0, grad_input=of_active)
        of_inside, of_gain, of_shift = torch.ops.aten.native_batch_norm_backward(
            _as_maps(of_active, maps), _as_maps(inside, maps), gain, mean, variance, centre, scale, True, epsilon,
            [True, True, True],
        )  # fmt: skip
        of_inside = _in_rows(of_inside)
        of_up = (of_inside.T @ filtered).view(up.shape)
        of_x = of_inside @ up.flatten(1)
        first = of_x.view(len(maps), *maps.shape[2:], -1)[..., :part]
        of_filtered = first.clone(memory_format=torch.contiguous_format).view(len(seen), -1)
        of_x += output
        of_spatial = _of_kernel(seen.T @ of_filtered, part, maps.shape[3])
        above, here, below = (of_filtered @ kernel.T).view(len(maps), maps.shape[2], 3, -1).unbind(2)
        here[:, :-1] += above[:, 1:]
        here[:, 1:] += below[:, :-1]
        torch.add(output.view(*first.shape[:-1], -1)[..., :part], here.view(first.shape), out=first)
        return _as_maps(of_x, maps), of_spatial, of_up, of_gain, of_shift, of_down, None


def _in_rows(maps: Tensor) -> Tensor:
    """(n, channels, rows, columns) as (n rows columns, channels), copied where channels are not last in memory."""
    return maps.permute(0, 2, 3, 1).reshape(-1, maps.shape[1])


def _as_maps(rows: Tensor, like: Tensor) -> Tensor:
    """The inverse of :func:`_in_rows`, of maps with so many rows and columns."""
    return rows.view(len(like), *like.shape[2:], -1).permute(0, 3, 1, 2)


def _patches(x: Tensor, size: torch.Size) -> tuple[Tensor, bool]:
    """Values of patches, one row each, and whether channels are last among them, as they are in memory."""
    (high, wide), (_, _, rows, columns) = size, x.shape
    parts = x.unflatten(3, (columns // wide, wide)).unflatten(2, (rows // high, high))
    last = not x.is_contiguous()
    order = (0, 2, 4, 3, 5, 1) if last else (0, 2, 4, 1, 3, 5)
    if wide > 1 and not last and x.device.type == "cpu":
        strips = x.view(-1, wide).numpy()
        return torch.from_numpy(strips.take(_strips(x.shape, size), 0)).view(len(x) * (rows // high) * (columns // wide), -1), last
    return parts.permute(order).reshape(len(x) * (rows // high) * (columns // wide), -1), last


@lru_cache(maxsize=4)
def _strips(shape, size):
    """Order in which the rows of patches, of maps of a shape, lie in them."""
    (high, wide), (n, channels, rows, columns) = size, shape
    places = np.arange(n * channels * rows * columns // wide)
    return places.reshape(n, channels, rows // high, high, columns // wide).transpose(0, 2, 4, 1, 3).ravel()


def _places(x: Tensor, weight: Tensor) -> tuple[int, int, int]:
    return len(x), x.shape[2] // weight.shape[2], x.shape[3] // weight.shape[3]


def _flat(weight: Tensor, last: bool) -> Tensor:
    """Weights in the order of :func:`_patches`, (n_output, n_input high wide)."""
    return (weight.permute(0, 2, 3, 1) if last else weight).flatten(1)


def _flat_shape(weight: Tensor, last: bool) -> tuple[int, ...]:
    outputs, inputs, high, wide = weight.shape
    return (outputs, high, wide, inputs) if last else (outputs, inputs, high, wide)


def _seen(first: Tensor) -> Tensor:
    """What the filter sees of maps (n, rows, columns, part) in three rows, (n rows, 3 columns part)."""
    n, rows, columns, part = first.shape
    size = columns * part
    padded = first.new_zeros(n, rows + 2, size)
    padded[:, 1:-1] = first.flatten(2)
    return padded.as_strided((n, rows, 3 * size), ((rows + 2) * size, size, 1)).reshape(n * rows, -1)


def _kernel(spatial: Tensor, columns: int) -> Tensor:
    """The filter as a matrix from three rows to one, (3 columns part, columns part)."""
    size = 3 * len(spatial) * columns
    values = torch.cat([spatial.permute(0, 2, 3, 1).flatten(), spatial.new_zeros(1)])
    return values.index_select(0, _index(len(spatial), columns)).view(size, -1)


def _of_kernel(gradient: Tensor, part: int, columns: int) -> Tensor:
    """Gradient of the filter from that of its matrix."""
    found = gradient.new_zeros(9 * part**2 + 1)
    found.index_add_(0, _index(part, columns), gradient.flatten())
    return found[:-1].view(part, 3, 3, part).permute(0, 3, 1, 2)


@lru_cache(maxsize=16)
def _index(part: int, columns: int) -> Tensor:
    """Where in the filter, channels last, each element of its matrix lies; one beyond its end for a zero."""
    inputs, row, column = torch.arange(part), torch.arange(3), torch.arange(columns)
    across = column[:, None] - column + 1  # (columns from, columns to)
    place = (torch.arange(part) * 3 + row[:, None, None, None, None]) * 3 + across[:, None, :, None]
    place = place * part + inputs[:, None, None]
    inside = ((across >= 0) & (across < 3))[:, None, :, None]
    return torch.where(inside, place, part * part * 9).flatten()

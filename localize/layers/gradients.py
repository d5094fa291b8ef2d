"""The network's stages with their gradients, written out for training on a processor.

The results are those of the layers in :mod:`localize.layers.partial_block`. Written out, channels lie side by side in
memory wherever a gradient comes from, a 3 x 3 filter of few columns is one matrix product, and nothing is recorded
between layers: that takes three quarters of the time of automatic differentiation.

Each layer gives its output and a function from the gradient of that to those of its input and of its parameters, in
the order in which the layer has them. Maps are (n, n_channel, rows, columns), channels last in memory, and rows of a
matrix their places.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import lru_cache
from typing import Any, TypeAlias, cast

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn

from localize.layers.partial_block import PartialBlock

FEW = 4
"""Most columns of maps on which a 3 x 3 filter is a matrix over all columns: on more, most of it would be zeros."""

#: Gradient of an output to that of the input and to those of the parameters.
Back: TypeAlias = Callable[[Tensor], tuple[Tensor, list[Tensor]]]
Layer: TypeAlias = Callable[[Tensor], tuple[Tensor, Back]]


class Stages(torch.autograd.Function):
    """Layers one after the other as one step of automatic differentiation, which ends at the maps they begin with."""

    @staticmethod
    def forward(ctx: Any, maps: Tensor, layers: Iterable[Layer], *_: Tensor) -> Tensor:
        """Output of the last layer.

        Args:
            ctx: of autograd.
            maps: (n, n_map, m, k), nothing of which is differentiated.
            layers: the first of them :func:`patches_of_maps`.
            _: their parameters, in their order, so that autograd asks for their gradients.

        Returns:
            (n, n_channel, m, k).
        """
        ctx.backs = []
        for layer in layers:
            maps, back = layer(maps)
            ctx.backs.append(back)
        return maps

    @staticmethod
    def backward(ctx: Any, *gradients: Tensor) -> tuple[Tensor | None, ...]:
        """Gradients of the parameters, each of the same shape as its parameter; none of the maps."""
        gradient, found = gradients[0], list[Tensor]()
        for back in reversed(ctx.backs):
            gradient, own = back(gradient)
            found = own + found
        return None, None, *found


def patches_of_maps(layer: nn.Conv2d, maps: Tensor) -> tuple[Tensor, Back]:
    """Convolution of the maps whose stride is the size of its kernel, without bias.

    Args:
        layer: the convolution.
        maps: (n, n_map, m, k), columns last in memory; no gradient of theirs is given.

    Returns:
        (n, n_output, i, j), i rows and j columns of patches, and the way back.
    """
    weight, (high, wide) = layer.weight, layer.kernel_size
    # By NumPy, which copies strips of eight values in a fifth of the time of torch.
    strips = maps.contiguous().view(-1, wide).numpy().take(_order(tuple(maps.shape), high, wide), 0)
    patches = torch.from_numpy(strips).view(-1, maps.shape[1] * high * wide)

    def back(gradient: Tensor) -> tuple[Tensor, list[Tensor]]:
        return gradient[:0], [(_in_rows(gradient).T @ patches).view_as(weight)]

    made = patches @ weight.flatten(1).T
    return made.view(len(maps), maps.shape[2] // high, maps.shape[3] // wide, -1).permute(0, 3, 1, 2), back


def merging(layer: nn.Conv2d, x: Tensor) -> tuple[Tensor, Back]:
    """The same between stages.

    Args:
        layer: the convolution.
        x: (n, n_input, m, k).

    Returns:
        (n, n_output, i, j), and the way back.
    """
    weight, (high, wide) = layer.weight.permute(0, 2, 3, 1), layer.kernel_size
    places = len(x), x.shape[2] // high, x.shape[3] // wide
    parts = _in_rows(x).view(*places[:2], high, places[2], -1)
    patches, flat = parts.transpose(2, 3).reshape(-1, high * wide * x.shape[1]), weight.flatten(1)

    def back(gradient: Tensor) -> tuple[Tensor, list[Tensor]]:
        output = _in_rows(gradient)
        of_x = (output @ flat).view(*places, high, -1).transpose(2, 3).reshape(-1, x.shape[1])
        return _as_maps(of_x, x), [(output.T @ patches).view_as(weight).permute(0, 3, 1, 2)]

    return (patches @ flat.T).view(*places, -1).permute(0, 3, 1, 2), back


def normalisation(layer: nn.BatchNorm2d, x: Tensor) -> tuple[Tensor, Back]:
    """Batch normalisation by what is at hand, which moves its running mean and variance.

    Args:
        layer: the normalisation.
        x: (n, n_channel, m, k).

    Returns:
        Same shape as ``x``, and the way back.
    """
    gain, running = layer.weight, (layer.running_mean, layer.running_var)
    cast(Tensor, layer.num_batches_tracked).add_(1)
    momentum = cast(float, layer.momentum)
    y, centre, scale = torch.native_batch_norm(x, gain, layer.bias, *running, True, momentum, layer.eps)

    def back(gradient: Tensor) -> tuple[Tensor, list[Tensor]]:
        found = torch.ops.aten.native_batch_norm_backward(
            gradient, x, gain, *running, centre, scale, True, layer.eps, [True, True, True]
        )
        return found[0], [found[1], found[2]]

    return y, back


def block(layer: PartialBlock, x: Tensor) -> tuple[Tensor, Back]:
    """A block of a filter in space, and up and down again, added to its input.

    Args:
        layer: the block.
        x: (n, n_channel, m, k).

    Returns:
        Same shape as ``x``, and the way back.
    """
    up, norm, down = layer.parts
    rise, fall = up.weight.flatten(1), down.weight.flatten(1)
    rows = _in_rows(x)
    filtered = rows.clone()
    first = _as_maps(filtered, x)[:, : layer.part]
    filtering = filter_of_few if x.shape[3] <= FEW else filter_of_many
    through, of_filter = filtering(layer.spatial.weight, first)
    first.copy_(through)
    inside, of_norm = normalisation(norm, _as_maps(filtered @ rise.T, x))
    active = _in_rows(inside).relu_()

    def back(gradient: Tensor) -> tuple[Tensor, list[Tensor]]:
        output = _in_rows(gradient)
        of_active = output @ fall
        torch.ops.aten.threshold_backward.grad_input(of_active, active, 0, grad_input=of_active)
        of_inside, of_affine = of_norm(_as_maps(of_active, x))
        of_raised = _in_rows(of_inside)
        of_x = of_raised @ rise
        first = _as_maps(of_x, x)[:, : layer.part]
        of_first, of_spatial = of_filter(first)
        of_x += output
        torch.add(_as_maps(output, x)[:, : layer.part], of_first, out=first)
        of_up, of_down = (of_raised.T @ filtered).view_as(up.weight), (output.T @ active).view_as(down.weight)
        return _as_maps(of_x, x), [*of_spatial, of_up, *of_affine, of_down]

    return _as_maps(torch.addmm(rows, active, fall.T), x), back


def filter_of_few(weight: Tensor, x: Tensor) -> tuple[Tensor, Back]:
    """3 x 3 filter of maps that have few columns: one matrix from what lies in three rows to one row.

    Args:
        weight: (n_channel, n_channel, 3, 3).
        x: (n, n_channel, m, k).

    Returns:
        Same shape as ``x``, and the way back.
    """
    (n, part, rows, columns), index = x.shape, _index(x.shape[1], x.shape[3])
    size = columns * part
    values = torch.cat([weight.permute(0, 2, 3, 1).flatten(), weight.new_zeros(1)])
    kernel = values.index_select(0, index).view(3 * size, size)
    padded = x.new_zeros(n, rows + 2, size)
    padded[:, 1:-1] = x.permute(0, 2, 3, 1).flatten(2)
    seen = padded.as_strided((n, rows, 3 * size), ((rows + 2) * size, size, 1)).reshape(n * rows, -1)

    def as_maps(flat: Tensor) -> Tensor:
        return flat.unflatten(-1, (columns, part)).view(n, rows, columns, part).permute(0, 3, 1, 2)

    def back(gradient: Tensor) -> tuple[Tensor, list[Tensor]]:
        output = gradient.permute(0, 2, 3, 1).clone(memory_format=torch.contiguous_format).view(n * rows, size)
        of_values = torch.zeros_like(values).index_add_(0, index, (seen.T @ output).flatten())
        above, here, below = (output @ kernel.T).view(n, rows, 3, size).unbind(2)
        here[:, :-1] += above[:, 1:]
        here[:, 1:] += below[:, :-1]
        of_weight = of_values[:-1].view(part, 3, 3, part)
        return as_maps(here), [of_weight.permute(0, 3, 1, 2)]

    return as_maps(seen @ kernel), back


def filter_of_many(weight: Tensor, x: Tensor) -> tuple[Tensor, Back]:
    """3 x 3 filter of maps that have many columns.

    Args:
        weight: (n_channel, n_channel, 3, 3).
        x: (n, n_channel, m, k).

    Returns:
        Same shape as ``x``, and the way back.
    """
    x = x.clone(memory_format=torch.channels_last)
    how = [1, 1], [1, 1], [1, 1], False, [0, 0], 1

    def back(gradient: Tensor) -> tuple[Tensor, list[Tensor]]:
        gradient = gradient.clone(memory_format=torch.channels_last)
        found = torch.ops.aten.convolution_backward(gradient, x, weight, None, *how, [True, True, False])
        return found[0], [found[1]]

    return nn.functional.conv2d(x, weight, padding=1), back


def _in_rows(maps: Tensor) -> Tensor:
    """(n, channels, rows, columns) as (n rows columns, channels), copied where channels are not last in memory."""
    return maps.permute(0, 2, 3, 1).reshape(-1, maps.shape[1])


def _as_maps(rows: Tensor, like: Tensor) -> Tensor:
    """The inverse of :func:`_in_rows`, of maps with so many rows and columns."""
    return rows.view(len(like), *like.shape[2:], -1).permute(0, 3, 1, 2)


@lru_cache(maxsize=4)
def _order(shape: tuple[int, int, int, int], high: int, wide: int) -> NDArray[np.int64]:
    """Strips of maps of that shape that lie in their patches one after the other."""
    n, channels, rows, columns = shape
    strip = np.arange(n * channels * rows * columns // wide)
    return strip.reshape(n, channels, rows // high, high, columns // wide).transpose(0, 2, 4, 1, 3).ravel()


@lru_cache(maxsize=16)
def _index(part: int, columns: int) -> Tensor:
    """Place of each element of its matrix in a filter, channels last; one beyond its end for a zero."""
    row, column = torch.arange(3), torch.arange(columns)
    across = (column[:, None] - column + 1)[:, None, :, None]  # of the column that is seen and the one that sees
    place = (torch.arange(part) * 3 + row[:, None, None, None, None]) * 3 + across
    place = place * part + torch.arange(part)[:, None, None]
    return torch.where((across >= 0) & (across < 3), place, 9 * part**2).flatten()

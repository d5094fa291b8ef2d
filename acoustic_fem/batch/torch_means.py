"""Derivatives in torch of the means of :mod:`acoustic_fem.batch.means`, by closed formulas.

Real arguments, complex results: the gradient of a real loss L is Re(conj(slope) dL/dPsi) in torch's convention.
"""

from __future__ import annotations

from typing import Any

import torch
from torch import Tensor
from torch.autograd import Function
from torch.autograd.function import once_differentiable

from acoustic_fem.batch.series import ball_mean_slope, ball_mean_values, cylinder_mean_values


class BallMean(Function):
    """I_{order+2}(x) / I_{order}(x), x^2 = j t, of real t; as often differentiable as asked for."""

    @staticmethod
    def forward(ctx: Any, order: float, t: Tensor) -> Tensor:
        """Values of the mean, shape of t, complex128."""
        mean: Tensor = ball_mean_values(order, t)
        ctx.order = order
        ctx.save_for_backward(t, mean)
        return mean

    @staticmethod
    def backward(ctx: Any, gradient: Tensor) -> tuple[None, Tensor]:
        """Gradient by t, shape of t, float64: by the Riccati equation."""
        t, mean = ctx.saved_tensors
        return None, _real_product(ball_mean_slope(ctx.order, t, mean), gradient)


class CylinderMean(Function):
    """Mean thermal field of a closed cylinder of real t and H/(2R); differentiable once."""

    @staticmethod
    def forward(ctx: Any, t: Tensor, aspect: Tensor) -> Tensor:
        """Values of the mean, of the broadcast shape, complex128; derivatives are summed on the way where needed."""
        wanted = any(ctx.needs_input_grad)
        mean, *slopes = cylinder_mean_values(t, aspect, slopes=wanted)
        if wanted:
            ctx.save_for_backward(*slopes)
            ctx.shapes = t.shape, aspect.shape
        return mean

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, gradient: Tensor) -> tuple[Tensor, Tensor]:
        """Gradients by t and by the aspect ratio, from the sums kept: each the shape of what it is by, float64."""
        slopes = zip(ctx.saved_tensors, ctx.shapes, strict=True)
        by_t, by_aspect = (_real_product(slope, gradient).sum_to_size(shape) for slope, shape in slopes)
        return by_t, by_aspect


def _real_product(slope: Tensor, gradient: Tensor) -> Tensor:
    """Re(conj(slope) gradient)."""
    return torch.addcmul(slope.real * gradient.real, slope.imag, gradient.imag)

"""The training pass that is written out does what automatic differentiation of the same layers does."""

from copy import deepcopy

import pytest
import torch
from torch.nn.functional import cross_entropy

from localize.learned.classifier import NetworkShape, TouchNetwork
from localize.learned.network_sizes import NETWORKS


@pytest.mark.parametrize("name", NETWORKS)
def test_outputs_gradients_and_running_statistics_are_those_of_automatic_differentiation(name):
    torch.manual_seed(0)
    written = TouchNetwork(NetworkShape(maps=5, points=7, **NETWORKS[name])).double().train()
    differentiated = deepcopy(written)
    maps, point = torch.randn(3, 5, 64, 32, dtype=torch.float64), torch.tensor([0, 4, 6])

    logits = written(maps)
    cross_entropy(logits, point).backward()
    expected = differentiated.head(differentiated.stages(maps).mean((-2, -1)))
    cross_entropy(expected, point).backward()

    assert torch.allclose(logits, expected, atol=1e-10)
    for one, other in zip(written.parameters(), differentiated.parameters(), strict=True):
        assert torch.allclose(one.grad, other.grad, rtol=1e-8, atol=1e-10 * float(other.grad.abs().max()))
        assert one.grad.stride() == one.stride()
    for one, other in zip(written.buffers(), differentiated.buffers(), strict=True):
        assert torch.allclose(one, other, rtol=1e-12)


def test_a_network_in_training_may_be_asked_without_gradients():
    network = TouchNetwork(NetworkShape(maps=4, points=3, **NETWORKS["patches"])).train()
    maps = torch.randn(2, 4, 64, 32)
    with torch.no_grad():
        assert torch.allclose(network(maps), network.head(network.stages(maps).mean((-2, -1))), atol=1e-5)

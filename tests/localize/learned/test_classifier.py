"""The networks that are offered by name are what they are called after, and learn."""

from dataclasses import replace

import pytest
import torch
from rc_line import rc_line
from refusals import refused
from torch import nn

import localize
from geometry import Kind
from localize.learned.classifier import NetworkShape, PatchConvolution, TouchClassifier, TouchNetwork
from localize.learned.features import map_count
from localize.learned.network_sizes import NETWORKS


def shape(name: str, microphones: int = 2, points: int = 36, features="phasors") -> NetworkShape:
    return NetworkShape(maps=map_count(microphones, features), points=points, features=features, **NETWORKS[name])


def multiply_adds(network: nn.Module, maps: int) -> int:
    """Of convolutions and linear layers, for one frame."""
    counted = []

    def count(layer, inputs, output):
        per_output = layer.weight[0].numel()
        counted.append(per_output * output[0].numel())

    for layer in network.modules():
        if isinstance(layer, nn.Conv2d | nn.Linear):
            layer.register_forward_hook(count)
    network(torch.zeros(1, maps, 64, 32))
    return sum(counted)


@pytest.mark.parametrize(
    ("name", "parameters", "work"), [("paper", 856e3, 14.2e6), ("stride-2", 553e3, 3.3e6), ("patches", 243e3, 2.0e6)]
)
def test_networks_have_the_size_that_the_documentation_says(name, parameters, work):
    network = TouchNetwork(shape(name)).eval()
    assert sum(p.numel() for p in network.parameters()) == pytest.approx(parameters, rel=0.01)
    assert multiply_adds(network, 4) == pytest.approx(work, rel=0.08)


def test_the_papers_network_is_five_stages_of_which_each_is_followed_by_a_merging():
    network = TouchNetwork(shape("paper", features="paper")).eval()
    widths = [layer.out_channels for layer in network.stages if isinstance(layer, nn.Conv2d)]
    assert widths == [12, 24, 48, 96, 192, 384]
    sides = []
    for layer in network.stages:
        layer.register_forward_hook(lambda layer, inputs, output: sides.append(tuple(output.shape[2:])))
    network(torch.zeros(2, 2, 64, 32))
    assert (sides[0], sides[-1]) == ((64, 32), (2, 1))


@pytest.mark.parametrize("microphones", [2, 3, 4])
@pytest.mark.parametrize("features", ["phasors", "paper"])
def test_the_papers_network_takes_the_maps_of_any_array(microphones, features):
    classifier = TouchClassifier(microphones, shape("paper", microphones, 7, features)).eval()
    assert classifier(torch.randn(2, microphones, 250)).shape == (2, 7)


def test_a_stride_of_2_does_not_survive_the_papers_mergings():
    with refused(Kind.OUT_OF_RANGE, "network.patch", (2, 2)):
        replace(shape("paper"), patch=(2, 2))


@pytest.mark.slow
@pytest.mark.parametrize("change", [{"network": "stride-2"}, {"bfloat16": True}, {"features": "paper"}])
def test_other_networks_maps_and_precisions_learn_and_are_saved(change, tmp_path):
    usual = localize.TrainingPlan.on_maps()
    plan = replace(usual, microphone_noise=1e-3, seconds_per_point=60, epochs=4, seed=1, **change)
    array = rc_line(4, spread=3.0)
    localizer = localize.train(array, plan)
    assert localizer.training["held_out_accuracy"][-1] > 0.6
    assert localizer.training["loss"][-1] < localizer.training["loss"][0]
    localizer.save(tmp_path)
    signals = localize.TouchGenerator(array, 0, "evaluation", 0.0).samples(0, 8).signals
    assert (localize.load_localizer(tmp_path).locate(signals) == localizer.locate(signals)).all()


@pytest.mark.parametrize("features", ["phasors", "paper", "rooms"])
def test_maps_network_and_gradients_follow_the_device(features):
    # The device without data refuses tensors of any other: no accelerator is needed to see that all of them move.
    classifier = TouchClassifier(3, shape("patches", 3, 4, features)).to("meta").train()
    optimizer = torch.optim.AdamW(classifier.parameters())
    logits = classifier(torch.randn(8, 3, 250, device="meta"))
    logits.sum().backward()
    optimizer.step()
    assert logits.device.type == "meta"
    assert logits.shape == (8, 4)


@pytest.mark.skipif(not torch.cuda.is_available(), reason="no graphics processor: what is trained there is not tested")
@pytest.mark.parametrize("bfloat16", [False, True])
def test_a_graphics_processor_trains_and_goes_on(bfloat16, tmp_path):
    plan = localize.TrainingPlan(microphone_noise=1e-3, seconds_per_point=60, epochs=4, seed=1, bfloat16=bfloat16)
    kept = tmp_path / "checkpoint.safetensors"
    localizer = localize.train(rc_line(4, spread=3.0), plan, checkpoint=kept)
    assert localizer.training["device"] == "cuda"
    assert localizer.training["held_out_accuracy"][-1] > 0.6
    again = localize.train(rc_line(4, spread=3.0), plan, checkpoint=kept)
    signals = localize.TouchGenerator(rc_line(4, spread=3.0), 0, "evaluation", 0.0).samples(0, 8).signals
    assert (again.locate(signals) == localizer.locate(signals)).all()


def test_in_training_patches_are_cut_as_by_the_convolution():
    for size, layout in ((1, torch.channels_last), (2, torch.channels_last), ((4, 8), torch.contiguous_format)):
        layer = PatchConvolution(6, 10, size).double()
        inputs = torch.randn(3, 6, 16, 8).double().contiguous(memory_format=layout)
        assert torch.allclose(layer.train()(inputs), layer.eval()(inputs), atol=1e-12)


def test_training_takes_gains_and_finger_stimuli():
    plan = localize.TrainingPlan(
        microphone_noise=1e-3, seconds_per_point=16, epochs=1, microphone_gain=0.5, stimuli=("multi-sines", "taps")
    )
    localizer = localize.train(rc_line(4), plan)
    assert localizer.plan["stimuli"] == ("multi-sines", "taps")


def test_sound_from_outside_needs_an_array_that_has_an_outside():
    with refused(Kind.MISMATCH, "ambient"):
        localize.train(
            rc_line(4),
            localize.TrainingPlan(microphone_noise=1e-3, seconds_per_point=4, epochs=1, ambient=(30.0, 90.0)),
        )

"""The network learns an easy array within seconds, repeats itself, survives its file and refuses bad input."""

import copy
import importlib.metadata
import json
import os
from dataclasses import replace

import numpy as np
import pytest
import torch
from clocks import ticking
from rc_line import rc_line
from refusals import refused
from safetensors.torch import save_file

import localize
from geometry import Kind
from geometry.ground.record import sealed
from localize.learned import epochs
from localize.learned.classifier import NetworkShape, TouchClassifier
from localize.learned.features import map_count
from localize.learned.training import soft_labels
from localize.signals import stimulus

POINTS = 4
PLAN = localize.TrainingPlan(seconds_per_point=200, epochs=5, seed=1, microphone_noise=1e-3)
TINY = localize.TrainingPlan(seconds_per_point=4, epochs=1, batch=8, microphone_noise=1e-3)


@pytest.fixture(scope="module")
def array():
    return rc_line(POINTS, spread=3.0)


@pytest.fixture(scope="module")
def trained(array):
    reports = []
    return localize.train(array, PLAN, reports.append), reports


@pytest.fixture(scope="module")
def tiny(array):
    return localize.train(array, TINY)


@pytest.fixture(scope="module")
def touches(array):
    return localize.TouchGenerator(array, 9, "evaluation", 0.0).samples(0, 8)


def test_four_points_are_learnt_in_seconds(trained, array):
    localizer, _ = trained
    result = localize.evaluate(localizer, array, touches_per_point=100, microphone_noise=0.0)
    assert result.top1 > 0.93
    assert result.top2 > 0.98
    assert result.within_one > 0.98


def test_progress_reports_every_epoch_with_falling_loss_and_held_out_accuracy(trained):
    localizer, reports = trained
    assert [r.epoch for r in reports] == [1, 2, 3, 4, 5]
    assert reports[-1].loss < reports[0].loss
    assert reports[-1].accuracy > max(0.9, reports[0].accuracy - 0.02)
    assert [r.accuracy for r in reports] == localizer.training["held_out_accuracy"]
    assert localizer.training["held_out_touches"] == 50 * POINTS


def test_the_same_plan_gives_the_same_weights_and_another_seed_others(tiny, array):
    again = localize.train(array, TINY).classifier.state_dict()
    other = localize.train(array, replace(TINY, seed=2)).classifier.state_dict()
    mine = tiny.classifier.state_dict()
    assert all(torch.equal(mine[name], again[name]) for name in mine)
    assert not torch.equal(mine["network.layers.0.weight"], other["network.layers.0.weight"])


def test_training_leaves_the_global_random_state_alone(array):
    before = torch.get_rng_state()
    localize.train(array, TINY)
    assert torch.equal(before, torch.get_rng_state())


@pytest.mark.slow
def test_a_time_limit_shortens_training_and_still_ends_it_well(array, monkeypatch):
    monkeypatch.setattr(epochs, "perf_counter", ticking(0.03))
    reports = []
    plan = replace(PLAN, seconds_per_point=50, epochs=5000, time_limit=2.5)
    localizer = localize.train(array, plan, reports.append)
    assert reports[-1].epoch == reports[-1].epochs < 1000
    assert localizer.training["cut_short"]
    assert localizer.training["epochs"] == len(reports)
    assert localizer.training["touches"] < 1000 * 50 * POINTS
    # A run cut off at a high learning rate would be far worse than chance of two neighbours.
    assert reports[-1].accuracy > 0.7


def test_a_time_limit_that_is_ample_changes_nothing(tiny, array):
    ample = localize.train(array, replace(TINY, time_limit=600.0))
    assert not ample.training["cut_short"]
    weights = ample.classifier.state_dict()
    assert all(torch.equal(value, weights[name]) for name, value in tiny.classifier.state_dict().items())


def test_probabilities_of_a_batch_are_those_of_its_signals_and_sum_to_one(trained, touches):
    localizer, _ = trained
    batch = localizer.locate(touches.signals)
    assert batch.shape == (8, POINTS)
    assert batch.sum(1) == pytest.approx(np.ones(8))
    single = localizer.locate(touches.signals[3].numpy())
    assert single.shape == (POINTS,)
    assert single == pytest.approx(batch[3], abs=1e-5)


def test_a_longer_recording_is_the_product_of_its_frames(trained, touches):
    localizer, _ = trained
    signal = touches.signals[0, :, :500].numpy()
    parts = localizer.locate(signal[:, :250]) * localizer.locate(signal[:, 250:])
    assert localizer.locate(signal) == pytest.approx(parts / parts.sum(), abs=1e-5)


def test_a_gain_common_to_all_microphones_changes_nothing(trained, touches):
    localizer, _ = trained
    assert localizer.locate(1e-3 * touches.signals) == pytest.approx(localizer.locate(touches.signals), abs=1e-3)


def test_locate_refuses_signals_it_cannot_read(tiny):
    with refused(Kind.UNSUITABLE, "signals"):
        tiny.locate(np.stack([np.sin(np.arange(300)), np.zeros(300)]))
    with refused(Kind.MISMATCH, "signals"):
        tiny.locate(np.ones((3, 300)))


# -- labels, plan, network ----------------------------------------------------------------------------------------


def test_soft_labels_are_gaussian_along_a_line_and_never_cross_to_another():
    line, place = np.array([0, 0, 0, 1, 1]), np.array([0, 1, 2, 0, 1])
    labels = soft_labels(line, place, 1.0)
    assert labels.sum(1) == pytest.approx(np.ones(5))
    assert (labels[:3, 3:] == 0).all()
    assert (labels[3:, :3] == 0).all()
    assert labels[0, 1] / labels[0, 0] == pytest.approx(np.exp(-0.5))
    assert labels[0, 2] / labels[0, 0] == pytest.approx(np.exp(-2))
    assert np.array_equal(soft_labels(line, place, 0.0), np.eye(5))


@pytest.mark.parametrize(
    ("change", "field", "value"),
    [
        ({"depths": (1, 1, 1, 1, 1)}, "network.patch", (4, 8)),
        ({"patch": (5, 8)}, "network.patch", (5, 8)),
        ({"width": 30}, "network.width", 30),
        ({"depths": ()}, "network.depths", ()),
        ({"points": 1}, "network.points", 1),
    ],
)
def test_a_network_that_does_not_fit_the_maps_is_refused_when_it_is_made(change, field, value):
    with refused(Kind.OUT_OF_RANGE, field, value):
        NetworkShape(**{"maps": 4, "points": 12, **change})


@pytest.mark.parametrize("microphones", [2, 3, 4])
def test_the_default_network_takes_the_maps_of_any_array(microphones):
    classifier = TouchClassifier(microphones, NetworkShape(maps=map_count(microphones), points=7))
    logits = classifier(torch.randn(2, microphones, 250))
    assert logits.shape == (2, 7)
    with refused(Kind.MISMATCH, "network.maps", 5):
        TouchClassifier(microphones, NetworkShape(maps=5, points=7))


# -- evaluation -----------------------------------------------------------------------------------------------------


class Scripted:
    """Knows the order of the touches and always names the next point, the right one second."""

    microphones = ("left", "right")
    point_count = POINTS

    def __init__(self) -> None:
        self.next = 0

    def locate(self, signals):
        point = np.arange(self.next, self.next + len(signals)) % POINTS
        self.next += len(signals)
        eye = np.eye(POINTS)
        return 0.4 * eye[point] + 0.6 * eye[(point + 1) % POINTS]


def test_evaluation_counts_what_was_named(array):
    result = localize.evaluate(Scripted(), array, touches_per_point=70, microphone_noise=0.0, seed=4)
    assert (result.top1, result.top2, result.within_one) == (0.0, 1.0, 0.75)
    assert np.array_equal(result.confusion, 70 * np.roll(np.eye(POINTS, dtype=int), 1, axis=1))
    assert result.hardest_pair[2] == 0.5
    assert result.touches == 70 * POINTS
    assert sum(n for _, n in result.by_components.values()) == result.touches
    assert set(result.by_components) <= {f"{low} to {high - 1}" for low, high in stimulus.COMPONENT_INTERVALS}
    assert json.loads(json.dumps(result.to_dict()))["confusion"] == result.confusion.tolist()


def test_evaluation_is_the_same_again(tiny, array):
    one, two = (localize.evaluate(tiny, array, touches_per_point=10, microphone_noise=1e-2) for _ in range(2))
    assert np.array_equal(one.confusion, two.confusion)


@pytest.mark.parametrize(
    ("arguments", "kind", "field"),
    [
        ({"library": rc_line(5)}, Kind.MISMATCH, ""),
        ({"library": replace(rc_line(4), microphones=("a", "b"))}, Kind.MISMATCH, ""),
        ({"touches_per_point": 0}, Kind.OUT_OF_RANGE, "touches_per_point"),
        ({"samples": 200}, Kind.OUT_OF_RANGE, "samples"),
        ({"microphone_noise": float("inf")}, Kind.OUT_OF_RANGE, "microphone_noise"),
    ],
)
def test_an_evaluation_that_makes_no_sense_is_refused(tiny, array, arguments, kind, field):
    with refused(kind, field, *() if field == "" else arguments.values()):
        localize.evaluate(tiny, **{"library": array, "microphone_noise": 0.0, **arguments})


# -- files ----------------------------------------------------------------------------------------------------------


def test_a_saved_localizer_gives_the_same_probabilities_and_knows_its_origin(trained, touches, tmp_path):
    localizer, _ = trained
    localizer.save(tmp_path / "localizer")
    loaded = localize.load_localizer(tmp_path / "localizer")
    assert np.array_equal(loaded.locate(touches.signals), localizer.locate(touches.signals))
    assert loaded.design == "rc-line-4"
    assert loaded.plan["seed"] == 1
    assert loaded.provenance["made by"] == "tests/support/rc_line.py"
    assert loaded.provenance["localizer"]["libraries"]["torch"] == importlib.metadata.version("torch")
    assert np.array_equal(loaded.place, localizer.place)


def test_saving_again_replaces_the_old_weights(tiny, trained, touches, tmp_path):
    tiny.save(tmp_path)
    trained[0].save(tmp_path)
    assert len(list(tmp_path.iterdir())) == 2
    loaded = localize.load_localizer(tmp_path)
    assert np.array_equal(loaded.locate(touches.signals), trained[0].locate(touches.signals))


def test_a_save_that_is_interrupted_leaves_the_former_localizer(tiny, trained, touches, tmp_path, monkeypatch):
    tiny.save(tmp_path)
    real = os.replace

    def interrupted(source, target):
        if str(target).endswith(".json"):
            raise KeyboardInterrupt
        real(source, target)

    monkeypatch.setattr(os, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        trained[0].save(tmp_path)
    loaded = localize.load_localizer(tmp_path)
    assert np.array_equal(loaded.locate(touches.signals), tiny.locate(touches.signals))


def cut(path, share=0.6):
    path.write_bytes(path.read_bytes()[: int(share * path.stat().st_size)])


def described(folder, **change):
    path = folder / "localizer.json"
    path.write_text(json.dumps({**json.loads(path.read_text()), **change}))


def without(folder, key):
    path = folder / "localizer.json"
    description = json.loads(path.read_text())
    del description[key]
    path.write_text(json.dumps(description))


def foreign_weights(folder):
    import hashlib

    path = next(folder.glob("*.safetensors"))
    save_file({"other": torch.zeros(3)}, path)
    path = folder / "localizer.json"
    description = json.loads(path.read_text())
    description["weights_sha256"] = hashlib.sha256((folder / description["weights"]).read_bytes()).hexdigest()
    del description["sha256"]
    path.write_text(json.dumps(sealed(description)))


@pytest.mark.parametrize(
    ("damage", "kind", "field"),
    [
        (lambda f: (f / "localizer.json").unlink(), Kind.MISSING, ""),
        (lambda f: cut(f / "localizer.json"), Kind.UNREADABLE, ""),
        (lambda f: (f / "localizer.json").write_text("[1]"), Kind.UNREADABLE, ""),
        (lambda f: described(f, format="something else"), Kind.UNREADABLE, ""),
        (lambda f: described(f, version=99), Kind.MISMATCH, "version"),
        (lambda f: without(f, "network"), Kind.MISSING, "network"),
        (lambda f: described(f, place=[0, 1]), Kind.MISMATCH, ""),
        (lambda f: described(f, microphones=["a", "b", "c"]), Kind.MISMATCH, "network.microphones"),
        (lambda f: described(f, version=1), Kind.MISMATCH, "version"),
        (lambda f: next(f.glob("*.safetensors")).unlink(), Kind.MISSING, ""),
        (lambda f: cut(next(f.glob("*.safetensors"))), Kind.DAMAGED, ""),
        (foreign_weights, Kind.MISMATCH, ""),
    ],
)
def test_a_damaged_or_foreign_folder_is_refused_by_file_and_reason(tiny, tmp_path, damage, kind, field):
    tiny.save(tmp_path)
    damage(tmp_path)
    with refused(kind, field, error=localize.LocalizerError) as found:
        localize.load_localizer(tmp_path)
    assert found.value.file is not None


@pytest.mark.parametrize(
    ("field", "value", "kind"),
    [
        ("plan", None, Kind.WRONG_TYPE),
        ("plan", "deep", Kind.WRONG_TYPE),
        ("plan.epochs", "3", Kind.WRONG_TYPE),
        ("plan.seconds_per_point", -3, Kind.OUT_OF_RANGE),
        ("plan.microphone_noise", None, Kind.WRONG_TYPE),
        ("training", None, Kind.WRONG_TYPE),
        ("training.microphone_noise", -1.0, Kind.OUT_OF_RANGE),
        ("training.microphone_noise", "loud", Kind.WRONG_TYPE),
        ("training.held_out_accuracy", [1.5], Kind.OUT_OF_RANGE),
        ("design", 5, Kind.WRONG_TYPE),
        ("design", "", Kind.OUT_OF_RANGE),
        ("provenance", [], Kind.WRONG_TYPE),
        ("provenance.design", 5, Kind.WRONG_TYPE),
        ("microphones", ["left"] * 1_000_000, Kind.OUT_OF_RANGE),
        ("microphones", ["left", "left"], Kind.CONFLICT),
        ("line", [0, 0, None, 1], Kind.WRONG_TYPE),
        ("line", [-1, 0, 1, 1], Kind.OUT_OF_RANGE),
        ("network.width", 1 << 40, Kind.OUT_OF_RANGE),
        ("network.points", 3, Kind.MISMATCH),
        ("network.hypotheses", 0, Kind.OUT_OF_RANGE),
        ("network.rank", 1_000_000, Kind.OUT_OF_RANGE),
        ("network.depths", [1], Kind.UNKNOWN),
        ("weights", "../../other.safetensors", Kind.OUT_OF_RANGE),
        ("surprise", 1, Kind.UNKNOWN),
        ("design", "another", Kind.DAMAGED),
    ],
)
def test_a_value_that_is_no_such_thing_is_refused_by_its_field(tiny, tmp_path, field, value, kind):
    tiny.save(tmp_path)
    path = tmp_path / "localizer.json"
    description = table = json.loads(path.read_text())
    *tables, name = field.split(".")
    for each in tables:
        table = table[each]
    table[name] = value
    path.write_text(json.dumps(description))
    with refused(kind, file=path, error=localize.LocalizerError) as found:
        localize.load_localizer(tmp_path)
    assert kind in (Kind.DAMAGED, Kind.MISMATCH) or found.value.field.startswith(field)
    assert len(str(found.value)) < 500


def test_a_network_larger_than_its_weights_takes_no_memory(tiny, tmp_path, monkeypatch):
    tiny.save(tmp_path)
    path = tmp_path / "localizer.json"
    description = json.loads(path.read_text())
    description["network"] |= {"width": 1024, "hypotheses": 1000, "size": 10_000}
    del description["sha256"]
    path.write_text(json.dumps(sealed(description)))
    with refused(Kind.MISMATCH, file=path, error=localize.LocalizerError):
        localize.load_localizer(tmp_path)


def test_weights_that_are_not_finite_are_refused(tiny, tmp_path):
    with torch.no_grad():
        broken = copy.deepcopy(tiny)
        broken.classifier.network.layers[0].bias[0] = float("nan")
    broken.save(tmp_path)
    with refused(Kind.UNSUITABLE, file="localizer.json", error=localize.LocalizerError):
        localize.load_localizer(tmp_path)

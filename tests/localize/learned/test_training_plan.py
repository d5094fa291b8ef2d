"""What a plan asks for is what the network is trained on: touches, labels, sound."""

from dataclasses import replace
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from rc_line import rc_line
from refusals import check_messages, refused

import localize
from geometry import Kind
from localize.learned import training
from localize.learned.epochs import run_epochs
from localize.learned.training import labels_of
from localize.learned.training_plan import PLANS, TrainingPlan
from localize.signals.disturbances import ROOM_LEVELS
from localize.signals.stimulus import multi_sines
from localize.signals.stimulus_kinds import Louder
from localize.signals.touch_generator import TouchSignals

SHORT = TrainingPlan(
    seconds_per_point=16,
    epochs=2,
    batch=32,
    microphone_noise=1e-3,
    stimuli=("multi-sines",),
    high_passed=0.0,
    network="patches",
)


def frames_of(plan, monkeypatch):
    """Frames that are trained on, (n, n_microphone, 250), by epoch; those of as many of the first touches."""
    lessons = []

    def told(classifier, lesson, *others):
        lessons.append(lesson)
        return run_epochs(classifier, lesson, *others)

    monkeypatch.setattr(training, "run_epochs", told)
    assert localize.train(rc_line(4), plan).training["epochs"] == plan.epochs
    (lesson,) = lessons
    of_epoch = [range(k * lesson.steps_per_epoch, (k + 1) * lesson.steps_per_epoch) for k in range(plan.epochs)]
    frames = [torch.cat([lesson.batch(step, plan.batch)[0] for step in steps]) for steps in of_epoch]
    touches = localize.TouchGenerator(rc_line(4), plan.seed, "training", plan.microphone_noise, method=plan.method)
    return frames, touches.samples(0, sum(map(len, frames))).signals[..., -250:]


def orders_of(frames, touches):
    """Numbers of the touches that the frames of each epoch are of."""
    orders = [[int((touches - frame).abs().sum((1, 2)).argmin()) for frame in epoch] for epoch in frames]
    for epoch, order in zip(frames, orders, strict=True):
        assert torch.allclose(epoch, touches[order], atol=1e-6)
    return orders


def test_every_epoch_draws_new_touches_unless_the_plan_says_that_they_stay(monkeypatch):
    first, second = orders_of(*frames_of(replace(SHORT, new_touches=True), monkeypatch))
    assert sorted(first) == list(range(64))
    assert sorted(second) == list(range(64, 128))
    assert first != sorted(first)


def test_touches_that_stay_come_in_another_order_in_every_epoch(monkeypatch):
    first, second = orders_of(*frames_of(replace(SHORT, method="stft"), monkeypatch))
    assert sorted(first) == sorted(second) == list(range(64))
    assert first != second


class PointsOnly:
    """Touches whose frames hold nothing but their number."""

    device = "cpu"

    def __init__(self, points):
        self.response = SimpleNamespace(point_count=points, microphones=("a", "b"))

    def samples(self, start, count):
        number = torch.arange(start, start + count)
        return TouchSignals(number[:, None, None].expand(-1, 2, 250), number % self.response.point_count + 1, number)


@pytest.mark.parametrize("new_touches", [True, False])
@pytest.mark.parametrize("points", [48, 300])  # fewer and more than are made at once
def test_a_step_has_points_from_all_over_a_large_array_whatever_was_asked_for_before(new_touches, points):
    plan = TrainingPlan(seconds_per_point=4, epochs=2, batch=32, new_touches=new_touches, high_passed=0.0)
    touches = PointsOnly(points)
    steps = range(2 * (4 * points // 32))

    def batches():
        return training._Batches(touches, None, plan, len(steps) // 2)

    straight = batches()
    made = [straight.frames(step, 32) for step in steps]
    assert all(int(point.max() - point.min()) > 0.6 * points for _, point in made)
    assert torch.equal(batches().frames(steps[-1], 32)[0], made[-1][0])
    number = torch.cat([frames[:, 0, 0] for frames, _ in made])
    assert len(number.unique()) == len(number) // (1 if new_touches else 2)


def test_an_array_of_more_points_than_a_step_has_touches_is_learnt():
    # 3 % where the touches of a step came in the order of the points, 25 % where they are shuffled; one in 48 by chance
    plan = TrainingPlan(seconds_per_point=14, epochs=1, batch=16, seed=1, held_out_fraction=0.7, microphone_noise=0.0)
    assert localize.train(rc_line(48, spread=0.3), plan).training["held_out_accuracy"][-1] > 0.15


def test_labels_are_shared_along_a_line_or_by_number():
    array = replace(rc_line(4), line=np.array([0, 0, 1, 1]), place=np.array([0, 1, 0, 1]))
    by_line, by_number = (
        labels_of(array, TrainingPlan(label_sigma=1.0, label_neighbours=name)) for name in ("line", "number")
    )
    assert by_line[1, 2] == 0
    assert by_number[1, 2] / by_number[1, 1] == pytest.approx(np.exp(-0.5))
    assert by_number[1, 2] == by_number[1, 0]


def test_a_network_is_trained_in_the_sound_of_rooms_where_the_library_knows_it():
    array = rc_line(4)
    heard = replace(array, ambient_response=np.ones_like(array.transfer_function[0]))
    assert TrainingPlan().sound(heard) is None
    assert TrainingPlan(ambient="rooms").sound(array) is None
    assert TrainingPlan(ambient="rooms").sound(heard) == ROOM_LEVELS
    assert TrainingPlan(ambient=(40.0, 50.0)).sound(heard) == (40.0, 50.0)
    trained = localize.train(heard, replace(SHORT, epochs=1, ambient="rooms"))
    assert trained.training["ambient"] == ROOM_LEVELS
    assert trained.shape.features == "rooms"
    deaf = localize.train(array, replace(SHORT, epochs=1, ambient="rooms"))
    assert (deaf.training["ambient"], deaf.shape.features) == (None, "phasors")


def test_a_network_of_rooms_is_saved_with_what_it_takes_out(tmp_path):
    array = rc_line(4)
    heard = replace(array, ambient_response=np.ones_like(array.transfer_function[0]))
    trained = localize.train(heard, replace(SHORT, epochs=1, ambient="rooms"))
    trained.save(tmp_path)
    read = localize.load_localizer(tmp_path)
    assert torch.equal(read.classifier.features.of_white, trained.classifier.features.of_white)
    signals = localize.TouchGenerator(heard, 0, "evaluation", 0.0, ambient=(80.0, 80.0)).samples(0, 8).signals
    assert (read.locate(signals) == trained.locate(signals)).all()


def test_touches_are_as_loud_as_the_plan_says():
    plain, louder = (replace(SHORT, touch_level=level).source for level in (0.0, 20.0))
    assert plain is multi_sines
    spectra = [source(0, "training", 0, 4, (1.0, 500.0), "cpu").spectrum for source in (plain, louder)]
    assert np.allclose(spectra[1], 10 * spectra[0])
    with refused(Kind.OUT_OF_RANGE, "level", 61):
        Louder(multi_sines, 61)


def test_the_papers_plan_is_the_papers():
    plan = TrainingPlan.of("paper")
    assert plan == TrainingPlan.paper()
    assert (plan.learning_rate, plan.epochs, plan.label_sigma, plan.label_neighbours) == (1e-3, 30, 1.0, "number")
    assert (plan.network, plan.features, plan.microphone_noise, plan.ambient) == ("paper", "paper", 0.0, None)
    held_out = round(plan.held_out_fraction * plan.seconds_per_point)
    assert (plan.seconds_per_point + held_out, plan.seconds_per_point / held_out) == (14_000, 4)
    assert (plan.new_touches, plan.method) == (False, "stft")


def test_plans_have_names():
    assert TrainingPlan.of("usual") == TrainingPlan()
    assert PLANS == ("usual", "maps", "paper")
    with refused(Kind.OUT_OF_RANGE, "plan", "best"):
        TrainingPlan.of("best")


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("seconds_per_point", 0),
        ("epochs", 0),
        ("epochs", 2.5),
        ("batch", 1),
        ("learning_rate", 0.0),
        ("learning_rate", float("nan")),
        ("weight_decay", -1.0),
        ("held_out_fraction", 0.0),
        ("label_sigma", -0.1),
        ("microphone_noise", -1e-3),
        ("microphone_noise", "own"),
        ("microphone_gain", 21.0),
        ("seed", -1),
        ("time_limit", 0.0),
        ("network", "big"),
        ("features", "raw"),
        ("stimuli", ()),
        ("stimuli", ("taps", "drums")),
        ("ambient", (90.0, 30.0)),
        ("ambient", "loud"),
        ("method", "fft"),
        ("label_neighbours", "all"),
        ("touch_level", 61.0),
    ],
)
def test_a_plan_outside_its_ranges_is_refused_by_field_and_value(field, value):
    with refused(Kind.OUT_OF_RANGE, field) as found:
        TrainingPlan(**{field: value})
    assert str(found.value.value) == str(value)


def test_the_wording_of_plans_out_of_range():
    changes = {"epochs": 2.5, "batch": 1, "learning_rate": 0.0, "microphone_noise": -1e-3, "network": "big",
               "features": "raw", "stimuli": ("taps", "drums"), "ambient": "loud", "method": "fft"}  # fmt: skip
    cases = {field: partial(TrainingPlan, **{field: value}) for field, value in changes.items()}
    check_messages(Path(__file__).parent / "messages.txt", {**cases, "plan": lambda: TrainingPlan.of("best")})

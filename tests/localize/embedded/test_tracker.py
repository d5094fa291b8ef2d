"""The exported tracker, with all sanitizers on, reports from any decisions what the tracker in Python reports."""

import subprocess
from pathlib import Path

import numpy as np
import pytest
from embedded_bench import COMPILER, SANITIZED, STRICT, needs_compiler
from rc_line import rc_line

from benchmarks.embedded_touches import STATES
from localize.embedded import embed
from localize.embedded.tracker_tables import point_steps, stream_delay, tracker_options
from localize.live.events import HOP, Decision
from localize.live.serial_frames import KINDS
from localize.live.touch_filter import TouchFilter
from localize.live.touches import TouchTracker

BENCH = Path(__file__).parents[2] / "support" / "tracker_bench.c"
POINTS = 6
RECORD = np.dtype(
    [("sample", "<u4"), ("state", "<i4"), ("level", "<f4"), ("mean", "<f4"), ("point", "<i4"),
     ("posterior", "<f4", POINTS)]
)  # fmt: skip


@pytest.fixture(scope="module")
def array():
    return rc_line(POINTS)


@pytest.fixture(scope="module")
def bench(array, tmp_path_factory):
    folder = tmp_path_factory.mktemp("tracker")
    for name, text in embed(array, microphone_noise=1e-2).files.items():
        (folder / name).write_text(text, encoding="utf-8")
    command = [str(COMPILER), *STRICT, *SANITIZED, "-I.", str(BENCH), "touch_tracker.c", "-lm", "-o", "bench"]
    made = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr
    return folder / "bench"


def decisions(seed, count):
    """Decisions about a finger that taps, presses, slides, trembles and beats, some of them wrong or unreadable."""
    random = np.random.default_rng(seed)
    hops = np.arange(count)
    pressure, rough, here = 0.02 * random.standard_normal(count), np.zeros(count), np.zeros(count, int)
    at = 5
    while at < count:
        kind, point = random.choice(["tap", "press", "beats", "beats", "slide"]), random.integers(POINTS)
        rise, hold, fall = (
            random.integers(1, 9),
            0 if kind != "press" else random.integers(3, 60),
            random.integers(1, 9),
        )
        height, times = random.uniform(0.5, 5), random.integers(2, 6) if kind == "beats" else 1
        if kind == "beats":
            rise, fall = random.integers(4, 9), random.integers(8, 18)
        length = int(rise + hold + fall + (random.integers(0, 20) if kind == "beats" else 0))
        for turn in range(times):
            since = hops - at - turn * length
            pressed = np.clip(np.minimum(since / rise, (rise + hold + fall - since) / fall), 0, 1)
            pressure += height * random.uniform(0.7, 1.3) * np.sin(np.pi / 2 * pressed) ** 2
        here[at:] = point
        if kind == "slide":
            length += int(random.integers(20, 60))
            rough[at : at + length] = height
            here[at + length // 2 :] = (point + 1) % POINTS
        at += times * length + int(random.integers(2, 60))
    rest = np.zeros(count)
    for k in range(1, count):
        rest[k] = 0.8 * rest[k - 1] + 0.2 * pressure[k]
    made = np.zeros(count, RECORD)
    made["sample"] = 250 + HOP * hops + 1000 * np.cumsum(random.random(count) < 0.003)
    made["level"] = (np.abs(pressure - rest) + rough) * random.uniform(0.8, 1.2, count)
    made["mean"] = pressure
    wrong = random.random(count)
    made["state"] = np.where(made["level"] > 0.1, 3, np.where(wrong < 0.1, 1, 0))
    made["state"][wrong > 0.99] = random.choice([1, 2, 4], int((wrong > 0.99).sum()))
    logit = random.uniform(0.3, 3) * random.standard_normal((count, POINTS))
    logit[hops, np.where(random.random(count) < 0.1, random.integers(POINTS, size=count), here)] += (
        6 * random.random() + 2
    )
    made["posterior"] = np.exp(logit) / np.exp(logit).sum(1, keepdims=True)
    made["point"] = np.where(made["state"] == 3, made["posterior"].argmax(1) + 1, 0)
    return made


def told_in_python(array, made):
    tracker = TouchTracker(array, stream_delay())
    told = []
    for each in made:
        is_touch, state = each["state"] == 3, STATES[each["state"]]
        decision = Decision(
            each["sample"] / 1000, state, float(each["level"]), int(each["point"]) if is_touch else None,
            distribution=each["posterior"].astype(float) if is_touch else None,
            mean_pressure=None if state == "unreadable" else float(each["mean"]),
        )  # fmt: skip
        told += tracker.take(decision)
    return told


@needs_compiler
@pytest.mark.parametrize(
    "seeds", [range(10), pytest.param(range(10, 150), marks=pytest.mark.slow)], ids=["few", "many"]
)
def test_events_of_any_decisions_are_those_of_python(bench, array, seeds):
    kinds = dict.fromkeys(KINDS.values(), 0)
    for seed in seeds:
        made = decisions(seed, 600)
        done = subprocess.run([bench], input=made.tobytes(), capture_output=True, check=False)
        assert done.returncode == 0, done.stderr.decode()
        found = [line.split() for line in done.stdout.decode().splitlines()]
        expected = told_in_python(array, made)
        assert [(KINDS[int(row[1])], int(row[0]), int(row[2]), int(row[3])) for row in found] == [
            (each.kind, round(1000 * each.time), each.touch, each.point) for each in expected
        ]
        numbers = np.array([[float(value) for value in row[4:]] for row in found])
        same = np.array([[each.probability, each.level, each.latency] for each in expected])
        np.testing.assert_allclose(numbers, same, rtol=1e-5, atol=2e-5)
        for each in expected:
            kinds[each.kind] += 1
    assert all(count >= 3 for count in kinds.values()), kinds


def test_steps_from_point_to_point_are_those_of_the_filter_in_python(array):
    from localize.embedded.decoder_tables import embedded_tables

    tables = embedded_tables(array, microphone_noise=1e-2)
    neighbours, staying, going_on = point_steps(tables)
    made = np.diag(staying) + tracker_options()["JUMP"] / POINTS
    for point, row in enumerate(neighbours):
        made[row[row >= 0], point] += going_on[row[row >= 0]]
    np.testing.assert_allclose(made, TouchFilter(array.line, array.place, 0.97, 1e-3).transition, atol=1e-12)

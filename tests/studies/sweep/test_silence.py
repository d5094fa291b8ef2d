"""Workers and schedulers that count as silent: those without a message, but never by a process that was itself away."""

from __future__ import annotations

from typing import Any

import pytest

from studies.sweep import cluster
from studies.sweep.cluster import PATIENCE, SCHEDULER_SILENCE, SILENCE, Cluster, WorkersLost


class Clock:
    now = 0.0

    def __call__(self) -> float:
        return self.now


class Loop:
    def add_callback(self, *_: Any) -> None:
        """Nothing runs beside the test."""


class Client:
    status, loop = "running", Loop()


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    found = Clock()
    monkeypatch.setattr(cluster, "monotonic", found)
    return found


def manned(clock: Clock) -> Cluster:
    """A cluster with one worker that was heard of just now."""
    found = Cluster(Client(), "scheduler")
    told(found, clock, 1.0)
    found._look()
    (worker,) = found._crew.values()
    worker.same = True
    return found


def told(team: Cluster, clock: Clock, last_seen: float) -> None:
    """The scheduler says when it last heard of the worker."""
    team._news = clock.now, {"tcp://worker": {"nthreads": 1, "last_seen": last_seen, "status": "running"}}


def watched(team: Cluster, clock: Clock, seconds: float, answers: bool) -> None:
    """Look every second, with or without a scheduler that answers; its worker is never heard again."""
    for _ in range(int(seconds)):
        clock.now += 1.0
        if answers:
            told(team, clock, 1.0)
        team._look()


def test_a_process_that_was_stopped_blames_nobody(clock: Clock) -> None:
    team = manned(clock)
    clock.now += 10 * SILENCE
    team._look()
    assert team._free() is not None
    watched(team, clock, SILENCE / 2, answers=True)
    assert team._free() is not None


def test_a_worker_that_is_not_heard_gets_nothing_and_without_any_the_run_ends(clock: Clock) -> None:
    team = manned(clock)
    watched(team, clock, SILENCE + 1, answers=True)
    assert team._free() is None
    with pytest.raises(WorkersLost, match="there have been no workers for 60 s"):
        watched(team, clock, PATIENCE + 1, answers=True)


def test_a_scheduler_that_does_not_answer_ends_the_run(clock: Clock) -> None:
    team = manned(clock)
    with pytest.raises(WorkersLost, match="scheduler has not answered for 60 s"):
        watched(team, clock, SCHEDULER_SILENCE + 1, answers=False)

"""Work in a process beside: what it returns and refuses arrives, and its crash is one line."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Iterator

import pytest

from geometry import Refusal
from studies.studio.workshop import Stopped, Workshop

pytestmark = pytest.mark.slow


def double(value: int, tell: Callable[[str], None]) -> tuple[int, int]:
    tell(f"doubling {value}")
    return 2 * value, os.getpid()


def refuse(value: int) -> None:
    raise Refusal(f"value = {value} must be small")


def stumble() -> None:
    raise KeyError("a mistake")


def full() -> None:
    raise OSError(28, "No space left on device", "parts.zip")


def crash() -> None:
    os.abort()


def go_on(tell: Callable[[str], None]) -> None:
    for _ in range(1000):
        tell("still here")
        time.sleep(0.01)


@pytest.fixture(scope="module")
def workshop() -> Iterator[Workshop]:
    found = Workshop()
    yield found
    found.close()


def test_answers_refusals_mistakes_and_a_full_disk_arrive(workshop: Workshop) -> None:
    told: list[str] = []
    (value, process) = workshop.run(double, (21,), told.append)
    assert (value, told) == (42, ["doubling 21"])
    assert process != os.getpid()
    with pytest.raises(Refusal, match=r"^value = 3 must be small$"):
        workshop.run(refuse, (3,))
    with pytest.raises(RuntimeError, match=r"KeyError: 'a mistake'"):
        workshop.run(stumble, ())
    with pytest.raises(Refusal, match=r"^parts\.zip: No space left on device$"):
        workshop.run(full, ())
    assert workshop.run(double, (1,), told.append)[1] == process


def test_a_crash_is_one_line_and_the_next_task_is_done(workshop: Workshop) -> None:
    with pytest.raises(Refusal, match="the CAD process ended without an answer; it is started again"):
        workshop.run(crash, ())
    assert workshop.run(double, (4,), lambda line: None)[0] == 8


def test_a_process_that_was_ended_for_good_is_not_started_again() -> None:
    ended = Workshop()
    ended.end()
    with pytest.raises(Stopped):
        ended.start()
    with pytest.raises(Stopped):
        ended.run(double, (4,), lambda line: None)


def test_what_nobody_waits_for_is_stopped(workshop: Workshop) -> None:
    heard = threading.Event()
    task = object()
    stopper = threading.Thread(target=lambda: (heard.wait(20), workshop.stop(task)))
    stopper.start()
    with pytest.raises(Stopped):
        workshop.run(go_on, (), lambda line: heard.set(), task)
    stopper.join()
    assert workshop.run(double, (4,), lambda line: None)[0] == 8


def test_tasks_that_are_stopped_while_they_wait_are_not_begun(workshop: Workshop) -> None:
    tasks = [object(), object()]
    for task in tasks:
        workshop.stop(task)
    told: list[str] = []
    for task in tasks:
        with pytest.raises(Stopped):
            workshop.run(double, (4,), told.append, task)
    assert told == []
    assert workshop.run(double, (4,), told.append, object())[0] == 8

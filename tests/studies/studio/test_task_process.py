"""Tasks in a process of their own: their results and refusals arrive, a crash is one line, and they can be stopped."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Iterator

import pytest

from geometry import Kind, Refusal
from geometry.ground.process_messages import Stopped
from studies.studio.task_process import TaskProcess

pytestmark = pytest.mark.slow


def double(value: int, tell: Callable[[str], None]) -> tuple[int, int]:
    tell(f"doubling {value}")
    return 2 * value, os.getpid()


def refuse(value: int) -> None:
    raise Refusal(kind=Kind.OUT_OF_RANGE, field="value", value=value, allowed="small")


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
def tasks_apart() -> Iterator[TaskProcess]:
    found = TaskProcess()
    yield found
    found.close()


def test_answers_refusals_mistakes_and_a_full_disk_arrive(tasks_apart: TaskProcess) -> None:
    told: list[str] = []
    (value, process) = tasks_apart.run(double, (21,), told.append)
    assert (value, told) == (42, ["doubling 21"])
    assert process != os.getpid()
    with pytest.raises(Refusal) as refused:
        tasks_apart.run(refuse, (3,))
    assert (refused.value.field, refused.value.value) == ("value", 3)
    with pytest.raises(KeyError, match="a mistake"):
        tasks_apart.run(stumble, ())
    with pytest.raises(OSError, match="No space left on device") as no_space:
        tasks_apart.run(full, ())
    assert no_space.value.filename == "parts.zip"
    assert tasks_apart.run(double, (1,), told.append)[1] == process


def test_a_crash_is_one_line_and_the_next_task_is_done(tasks_apart: TaskProcess) -> None:
    with pytest.raises(Refusal) as ended:
        tasks_apart.run(crash, ())
    assert ended.value.kind is Kind.STOPPED
    assert tasks_apart.run(double, (4,), lambda line: None)[0] == 8


def test_a_process_that_was_ended_for_good_is_not_started_again() -> None:
    ended = TaskProcess()
    ended.end()
    with pytest.raises(Stopped):
        ended.start()
    with pytest.raises(Stopped):
        ended.run(double, (4,), lambda line: None)


def test_what_nobody_waits_for_is_stopped(tasks_apart: TaskProcess) -> None:
    heard = threading.Event()
    task = object()
    stopper = threading.Thread(target=lambda: (heard.wait(20), tasks_apart.stop(task)))
    stopper.start()
    with pytest.raises(Stopped):
        tasks_apart.run(go_on, (), lambda line: heard.set(), task)
    stopper.join()
    assert tasks_apart.run(double, (4,), lambda line: None)[0] == 8


def test_tasks_that_are_stopped_while_they_wait_are_not_begun(tasks_apart: TaskProcess) -> None:
    tasks = [object(), object()]
    for task in tasks:
        tasks_apart.stop(task)
    told: list[str] = []
    for task in tasks:
        with pytest.raises(Stopped):
            tasks_apart.run(double, (4,), told.append, task)
    assert told == []
    assert tasks_apart.run(double, (4,), told.append, object())[0] == 8

"""A process that works for this one: what it returns and raises arrives, and every other end of it is one error."""

from __future__ import annotations

import gc
import multiprocessing
import os
import queue
import signal
import subprocess
import sys
import textwrap
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from geometry.ground.child import Child, Message
from geometry.ground.process_messages import ChildError, Limits, Stopped
from geometry.ground.refusal import Kind, Refusal

ROOT = Path(__file__).parents[3]


class Odd(Exception):
    """An error that cannot be sent."""

    def __init__(self, one: object, other: object) -> None:
        super().__init__(one)


def doubled(value: int, report: Callable[[object], None]) -> tuple[int, int]:
    report(f"doubling {value}")
    print("libraries print what they like")
    return 2 * value, os.getpid()


def process() -> int:
    return os.getpid()


def refuse(value: int) -> None:
    raise Refusal(field="value", value=value, allowed="small", kind=Kind.OUT_OF_RANGE)


def stumble() -> None:
    raise KeyError("a mistake")


def puzzle() -> None:
    raise Odd(lambda: None, 2)


def leave(status: int) -> None:
    os._exit(status)


def take(count: int) -> int:
    return len(bytearray(count))


def sleep(marker: str, seconds: float = 600) -> None:
    Path(marker).touch()
    try:
        time.sleep(seconds)
    finally:
        Path(f"{marker}-cleaned").touch()


def wait_for_ever(report: Callable[[object], None]) -> None:
    while True:
        report("still here")
        time.sleep(0.01)


def opened(place: str) -> Path:
    return Path(place)


def name_of(place: Path, end: str) -> str:
    return place.name + end


def raw() -> bytes:
    return b"\0raw"


@pytest.fixture
def child() -> Iterator[Child]:
    with Child("the helper") as found:
        yield found


def until(condition: Callable[[], object], seconds: float = 60) -> None:
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "waited too long"
        time.sleep(0.02)


def is_gone(process: int) -> bool:
    """True if a process has ended, and nobody has to wait for it."""
    return not Path(f"/proc/{process}").exists()


def test_results_refusals_mistakes_and_what_is_report_arrive_from_one_process(child: Child) -> None:
    reported: list[object] = []
    value, number = child.call(doubled, 21, report=reported.append)  # type: ignore[misc]
    assert (value, reported) == (42, ["doubling 21"])
    assert number != os.getpid()
    with pytest.raises(Refusal) as refused:
        child.call(refuse, 3)
    assert (refused.value.kind, refused.value.field, refused.value.value) == (Kind.OUT_OF_RANGE, "value", 3)
    with pytest.raises(KeyError, match="a mistake") as mistake:
        child.call(stumble)
    assert "in stumble" in str(mistake.value.__cause__)
    with pytest.raises(RuntimeError, match="Odd"):
        child.call(puzzle)
    assert child.call(raw) == b"\0raw"
    assert child.call(process) == number


def test_an_end_without_a_result_is_one_error_and_leaves_no_zombie(child: Child) -> None:
    number = child.call(process)
    with pytest.raises(ChildError) as ended:
        child.call(leave, 7)
    assert (ended.value.kind, ended.value.status) == (Kind.STOPPED, 7)
    assert not child.is_alive
    assert is_gone(number)
    with pytest.raises(ChildError):
        child.call(process)


def test_a_process_that_was_killed_while_it_rested_is_the_same_error(child: Child) -> None:
    os.kill(child.call(process), signal.SIGKILL)
    with pytest.raises(ChildError) as ended:
        child.call(process)
    assert ended.value.status == -signal.SIGKILL


def test_work_that_takes_too_long_ends_its_process(child: Child, tmp_path: Path) -> None:
    with pytest.raises(ChildError) as ended:
        child.call(sleep, str(tmp_path / "began"), seconds=1)
    assert ended.value.status is None
    assert not child.is_alive


def test_a_process_takes_no_more_memory_than_it_may() -> None:
    with Child("the helper", limits=Limits(memory=100_000_000)) as child:
        assert child.call(take, 50_000_000) == 50_000_000
        with pytest.raises(MemoryError):
            child.call(take, 200_000_000)


def test_whoever_stops_waiting_ends_the_process(child: Child) -> None:
    def interrupted(_: object) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        child.call(wait_for_ever, report=interrupted)
    assert not child.is_alive


def test_a_call_that_is_stopped_ends_alone(child: Child) -> None:
    number, reported = child.call(process), threading.Event()
    stopper = threading.Thread(target=lambda: (reported.wait(60), child.stop()))
    stopper.start()
    with pytest.raises(Stopped):
        child.call(wait_for_ever, report=lambda _: reported.set())
    stopper.join()
    assert child.call(process) == number


def test_an_interrupt_of_the_terminal_does_not_reach_it(child: Child) -> None:
    number = child.call(process)
    os.kill(number, signal.SIGINT)
    assert child.call(process) == number


def test_a_process_that_is_asked_to_end_cleans_up_what_it_works_at(child: Child, tmp_path: Path) -> None:
    inbox: queue.SimpleQueue[Message] = queue.SimpleQueue()
    child.begin(inbox, sleep, str(tmp_path / "work"))
    until((tmp_path / "work").exists)
    child.end()
    assert (tmp_path / "work-cleaned").exists()
    with pytest.raises(ChildError):
        inbox.get(timeout=10).value()


def test_an_object_made_at_the_start_stays_in_the_process() -> None:
    from functools import partial

    with Child("the helper", start=partial(opened, "/folder/file")) as child:
        assert child.call(name_of, ".txt") == "file.txt"


def test_what_is_not_trusted_sends_bytes_or_nothing() -> None:
    with Child("the helper", trusted=False, quiet=True) as child:
        assert child.call(raw) == b"\0raw"
        with pytest.raises(ChildError):
            child.call(process)


def test_a_process_ends_with_the_object_that_stands_for_it() -> None:
    child = Child("the helper")
    number = child.call(process)
    del child
    gc.collect()
    until(lambda: is_gone(number))


PROGRAM = """
import os, sys, time
from test_child import Child, process, sleep
if __name__ != "__main__":
    raise SystemExit("the main program was imported again")
child = Child("the helper")
print(child.call(process), flush=True)
if sys.argv[1] == "fork":
    if not os.fork():
        try:
            child.call(process)
        except Exception as error:
            print(type(error).__name__, flush=True)
        sys.exit()
    os.wait()
    print(child.call(process), flush=True)
elif sys.argv[1] == "work":
    child.call(sleep, sys.argv[2])
else:
    time.sleep(600)
"""


def start(tmp_path: Path, *arguments: str) -> subprocess.Popen[str]:
    (tmp_path / "program.py").write_text(textwrap.dedent(PROGRAM))
    paths = os.pathsep.join([str(Path(__file__).parent), str(ROOT)])
    return subprocess.Popen(
        [sys.executable, str(tmp_path / "program.py"), *arguments],
        stdout=subprocess.PIPE, text=True, env={**os.environ, "PYTHONPATH": paths},
    )  # fmt: skip


@pytest.mark.parametrize("does", ["rest", "work"])
def test_a_process_ends_with_its_parent_however_that_ends_and_cleans_up(does: str, tmp_path: Path) -> None:
    program = start(tmp_path, does, str(tmp_path / "work"))
    assert program.stdout is not None
    number = int(program.stdout.readline())
    if does == "work":
        until((tmp_path / "work").exists)
    program.kill()
    program.wait()
    program.stdout.close()
    until(lambda: is_gone(number))
    assert (tmp_path / "work-cleaned").exists() == (does == "work")


def test_a_copy_of_the_parent_leaves_its_process_alone(tmp_path: Path) -> None:
    lines = start(tmp_path, "fork").communicate()[0].split()
    assert lines == [lines[0], "ChildError", lines[0]]


def in_daemon(answers: multiprocessing.Queue[int]) -> None:
    with Child("the helper") as child:
        answers.put(child.call(process))


def test_a_process_that_may_have_no_children_by_multiprocessing_has_one() -> None:
    """As the workers of a dask nanny are: a pool of loky or of the standard library is refused there."""
    context = multiprocessing.get_context("spawn")
    answers: multiprocessing.Queue[int] = context.Queue()
    daemon = context.Process(target=in_daemon, args=(answers,), daemon=True)
    daemon.start()
    assert answers.get(timeout=60) != daemon.pid
    daemon.join()

"""Work in a copy of this process: what it returns and raises comes back; a crash or Ctrl-C ends the copy alone."""

import contextlib
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from geometry.ground.child import Child
from geometry.ground.forked import in_a_copy
from geometry.ground.process_messages import ChildError, Limits
from geometry.ground.refusal import Kind, Refusal


def test_what_the_work_returns_comes_back_from_another_process():
    process, answer = in_a_copy(lambda: (os.getpid(), "done"), "work")
    assert answer == "done"
    assert process != os.getpid()


def test_what_the_work_raises_is_raised_here():
    def fail():
        raise Refusal(field="solid", kind=Kind.UNSUITABLE)

    with pytest.raises(Refusal) as refused:
        in_a_copy(fail, "work")
    assert (refused.value.field, refused.value.kind) == ("solid", Kind.UNSUITABLE)


def test_an_error_that_cannot_be_sent_is_no_refusal():
    def fail():
        raise ValueError(lambda: None)

    with pytest.raises(RuntimeError, match="lambda"):
        in_a_copy(fail, "work")


def test_a_crash_of_the_work_is_an_error_and_leaves_no_zombie(tmp_path):
    def crash():
        (tmp_path / str(os.getpid())).touch()
        os.kill(os.getpid(), signal.SIGKILL)

    with pytest.raises(ChildError) as ended:
        in_a_copy(crash, "work")
    assert ended.value.status == -signal.SIGKILL
    ((process,),) = [[each.name for each in tmp_path.iterdir()]]
    with pytest.raises(ProcessLookupError):
        os.kill(int(process), 0)


def test_work_takes_no_more_processor_time_than_it_may():
    def for_ever():
        while True:
            pass

    with pytest.raises(ChildError) as ended:
        in_a_copy(for_ever, "work", Limits(processor_seconds=1))
    assert ended.value.status == -signal.SIGXCPU


def test_whoever_stops_waiting_ends_the_work(tmp_path):
    started = tmp_path / "started"

    def for_ever():
        started.write_text(str(os.getpid()), encoding="ascii")
        signal.pause()

    def interrupted():
        if started.exists() and started.read_text(encoding="ascii"):
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        in_a_copy(for_ever, "work", beat=interrupted)
    with pytest.raises(ProcessLookupError):
        os.kill(int(started.read_text(encoding="ascii")), 0)


def test_work_that_waits_for_threads_of_this_process_is_given_up():
    with pytest.raises(ChildError) as stuck:
        in_a_copy(signal.pause, "work", asleep=0.3)
    assert stuck.value.status is None


def test_a_copy_leaves_the_children_of_this_process_alone():
    with Child("the helper") as child:
        number = child.call(os.getpid)
        assert in_a_copy(lambda: child.is_alive, "work") is False
        assert child.call(os.getpid) == number


@pytest.mark.skipif(not hasattr(os, "fork"), reason="copies are made by fork")
def test_a_copy_ends_with_a_parent_that_is_killed(tmp_path):
    number = tmp_path / "copy"
    code = (
        "import os, time, pathlib\n"
        "from geometry.ground.forked import in_a_copy\n"
        "def work():\n"
        f"    pathlib.Path({str(number)!r}).write_text(str(os.getpid()))\n"
        "    os.kill(os.getppid(), 9)\n"
        "    return bytes(10_000_000)  # more than a pipe holds\n"
        "in_a_copy(work, 'work')\n"
    )
    subprocess.run([sys.executable, "-c", code], check=False, timeout=60)
    copy = int(number.read_text())
    deadline = time.monotonic() + 30
    while is_running(copy) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert not is_running(copy)


def is_running(process):
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    with contextlib.suppress(ChildProcessError):
        os.waitpid(process, os.WNOHANG)
    try:
        state = Path(f"/proc/{process}/stat").read_text(encoding="ascii").rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"

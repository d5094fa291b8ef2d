"""A process beside this one that calls functions for it, and one error if it ends without a result.

It is a fresh interpreter, which never imports the program that started it. It ends with this process, is not
interrupted by Ctrl-C, because this process decides, and leaves no zombie. A copy of this process (``os.fork``) leaves
it alone. Work whose input cannot be sent goes into a copy of this process: :mod:`geometry.ground.forked`.
"""

from __future__ import annotations

import contextlib
import math
import os
import pickle  # noqa: TID251  between two processes of one program, never into a file
import queue
import signal
import subprocess
import sys
import threading
import time
import weakref
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple, NoReturn, Self, TypeVar

from geometry.ground.process_messages import (
    BEAT,
    BYTES,
    ENDED,
    PATIENCE,
    REPORT,
    STOPPED,
    ChildError,
    Limits,
    Stopped,
    StopWork,
    packed,
    read_message,
    unpacked,
    write_message,
)
from geometry.ground.refusal import Kind

Result = TypeVar("Result")

#: Kinds of messages to a child.
_SETUP, _CALL, _STOP = b"u", b"c", b"h"


class Message(NamedTuple):
    """Message of a child to whoever handed it a call."""

    child: Child
    """The sender."""
    kind: bytes
    """Kind of the message."""
    content: bytes
    """Its content, as bytes."""

    @property
    def is_report(self) -> bool:
        """True if the work goes on: the message is something that it reports on its way."""
        return self.kind == REPORT

    def value(self) -> Any:
        """The value that the work reports or returns.

        Raises:
            Exception: the error that the work raised, with its traceback as the cause.
            Stopped: the work was stopped.
            ChildError: the process ended without a result.
        """
        if self.kind == STOPPED:
            raise Stopped(f"{self.child.name} was stopped", kind=Kind.STOPPED)
        if self.kind == ENDED or not (self.child.trusted or self.kind == BYTES):
            raise ChildError.ended(self.child.name, self.child.kill())
        return unpacked(self.kind, self.content)


class Child:
    """A process that works off one call after the other, until it is ended or this object is gone.

    Args:
        name: what it is to a user, such as "the CAD process".
        limits: limits of the process.
        start: called in the process before the first call, such as for imports; an object that it returns stays in the
            process and is the first argument of every call.
        environment: variables beside, or in place of, those of this process.
        niceness: how far it stands back behind other processes.
        quiet: what it writes to standard error is thrown away.
        trusted: False: nothing that it sends is unpickled, so functions must return bytes.
    """

    def __init__(
        self,
        name: str,
        *,
        limits: Limits | None = None,
        start: Callable[[], Any] | None = None,
        environment: Mapping[str, str] | None = None,
        niceness: int = 0,
        quiet: bool = False,
        trusted: bool = True,
    ) -> None:
        self.name, self.trusted = name, trusted
        self._calls, self._has_ended = 0, False
        self._inbox: queue.SimpleQueue[Message] = queue.SimpleQueue()
        self._lock = threading.Lock()
        paths = os.pathsep.join(path or os.curdir for path in sys.path)
        self._process = subprocess.Popen(
            [sys.executable, "-P", "-c", f"from {__name__} import serve; serve()"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL if quiet else None,
            bufsize=0,
            env={**os.environ, **(environment or {}), "PYTHONPATH": paths},
        )
        weakref.finalize(self, _finish, self._process, os.getpid())
        _children.add(self)
        threading.Thread(target=_listen, args=(self._process, weakref.ref(self)), daemon=True).start()
        self._send(_SETUP, pickle.dumps((limits or Limits(), start, niceness)))

    @property
    def is_alive(self) -> bool:
        """True if the process runs."""
        return self._process.poll() is None

    @property
    def number(self) -> int:
        """Number of the process in the system."""
        return self._process.pid

    @property
    def is_stopped(self) -> bool:
        """True if a signal has stopped the process, which goes on when it is continued."""
        if not hasattr(os, "waitid"):  # Windows stops no process
            return False
        how = os.WSTOPPED | os.WNOHANG | os.WNOWAIT
        with contextlib.suppress(ChildProcessError):  # it has ended
            return os.waitid(os.P_PID, self._process.pid, how) is not None
        return False

    def begin(
        self, inbox: queue.SimpleQueue[Message], function: Callable[..., Any], *arguments: Any, reports: bool = False
    ) -> None:
        """Hand the process a call, without waiting for it.

        Args:
            inbox: where its messages go; several children may share it.
            function: a function of a module.
            arguments: its arguments.
            reports: it takes a further argument, a function that sends a value as a message.
        """
        content = pickle.dumps((function, arguments, reports))
        with self._lock:
            self._calls += 1
            self._inbox = inbox
            if self._has_ended:
                inbox.put(Message(self, ENDED, b""))
            else:
                self._send(_CALL, content)

    def call(
        self,
        function: Callable[..., Result],
        *arguments: Any,
        report: Callable[[Any], None] | None = None,
        beat: Callable[[], None] = lambda: None,
        seconds: float = math.inf,
    ) -> Result:
        """The result of a function that is called in the process, which is ended if this wait is interrupted.

        Args:
            function: a function of a module; with ``report`` it takes a further argument, to send values to that.
            arguments: its arguments.
            report: called here with what the function reports.
            beat: called here again and again while the function works.
            seconds: time that it may take, s; for the first call the start of the process included.

        Raises:
            Exception: what the function raised.
            Stopped: :meth:`stop` was called.
            ChildError: the process ended without a result, or took too long.
        """
        inbox: queue.SimpleQueue[Message] = queue.SimpleQueue()
        self.begin(inbox, function, *arguments, reports=report is not None)
        waited = 0.0
        try:
            while True:
                beat()
                try:
                    message = inbox.get(timeout=BEAT)
                except queue.Empty:
                    waited += BEAT  # counted, not timed: both processes may be stopped for hours and go on
                    if waited > seconds:
                        raise ChildError(f"{self.name} took more than {seconds:g} s", kind=Kind.STOPPED) from None
                    continue
                if not message.is_report:
                    break
                if report is not None:
                    report(message.value())
        except BaseException:
            self.kill()
            raise
        return message.value()

    def stop(self) -> None:
        """Stop the call that is being worked at: it raises :class:`Stopped` when it next reports something."""
        with self._lock:
            self._send(_STOP, self._calls.to_bytes(8, "little"))

    def end(self, patience: float = PATIENCE) -> None:
        """End the process: what it works at is cleaned up first, if that takes no more than ``patience`` seconds."""
        self._process.terminate()
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(patience)
        self.kill()

    def kill(self) -> int:
        """End the process at once; its exit status."""
        self._process.kill()
        with self._lock:  # whoever is sending it something stops now
            return _finish(self._process)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.kill()

    def _send(self, kind: bytes, content: bytes) -> None:
        # A process that has ended does not read it; the end of its own output says so.
        with contextlib.suppress(OSError, ValueError):
            write_message(_pipe(self._process.stdin).fileno(), kind, content)

    def _leave_to_parent(self) -> None:
        """Forget the process: this one is a copy of the process that started it."""
        for pipe in (self._process.stdin, self._process.stdout):
            _pipe(pipe).close()  # held open here too, it would keep the child from noticing the end of its parent
        self._process.returncode, self._has_ended, self._lock = 0, True, threading.Lock()


def _pipe(pipe: Any) -> Any:
    assert pipe is not None
    return pipe


def _finish(process: subprocess.Popen[bytes], owner: int | None = None) -> int:
    """End a process, if this one is its parent; its exit status."""
    if owner not in (None, os.getpid()):
        return 0
    process.kill()
    status = process.wait()
    _pipe(process.stdin).close()
    return status


def _listen(process: subprocess.Popen[bytes], owner: weakref.ref[Child]) -> None:
    """Pass on the messages of a child, until it ends."""
    with _pipe(process.stdout) as output, contextlib.suppress(EOFError, OSError):
        while True:
            kind, content = read_message(output.fileno())
            if (child := owner()) is not None:
                child._inbox.put(Message(child, kind, content))
            del child
    process.wait()
    if (child := owner()) is not None:
        with child._lock:
            child._has_ended = True
            child._inbox.put(Message(child, ENDED, b""))


_children: weakref.WeakSet[Child] = weakref.WeakSet()


def _leave_children() -> None:
    for child in list(_children):
        child._leave_to_parent()
    _children.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_leave_children)


# -- in the child -----------------------------------------------------------------------------------
def serve() -> None:
    """Work for the process that started this one, until it wants no more or is gone."""
    inward, outward = _channel()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent decides
    signal.signal(signal.SIGTERM, _exit)
    calls: queue.SimpleQueue[bytes | None] = queue.SimpleQueue()
    stopped: set[int] = set()
    threading.Thread(target=_follow, args=(inward, calls, stopped), daemon=True).start()
    if (setup := calls.get()) is None:
        return
    limits, start, niceness = pickle.loads(setup)
    if niceness and hasattr(os, "nice"):  # Windows has none
        os.nice(niceness)
    limits.apply()
    resident = None if start is None else start()
    first = () if resident is None else (resident,)
    number = 0

    def report(value: object) -> None:
        if number in stopped:
            raise StopWork
        write_message(outward, REPORT, pickle.dumps(value))

    def answer(call: bytes) -> object:
        function, arguments, reports = pickle.loads(call)
        return function(*first, *arguments, report) if reports else function(*first, *arguments)

    while (call := calls.get()) is not None:
        number += 1
        try:
            write_message(outward, *packed(lambda call=call: answer(call)))  # type: ignore[misc]
        except OSError:  # the parent is gone
            break
    signal.signal(signal.SIGTERM, signal.SIG_IGN)


def _channel() -> tuple[int, int]:
    """The pipes from and to the parent, taken from standard input and output, so that nobody else uses them."""
    pipes = [os.dup(0), os.dup(1)]
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.close(nothing)
    with contextlib.suppress(OSError):  # there may be no standard error
        os.dup2(2, 1)
    inward, outward = pipes

    def close() -> None:
        while pipes:  # held open in a copy, they would keep the parent from noticing the end of this process
            os.close(pipes.pop())

    if hasattr(os, "register_at_fork"):
        os.register_at_fork(after_in_child=close)
    return inward, outward


def _follow(inward: int, calls: queue.SimpleQueue[bytes | None], stopped: set[int]) -> None:
    """Take what the parent sends; end when it is gone."""
    with contextlib.suppress(EOFError, OSError):
        while True:
            kind, content = read_message(inward)
            if kind == _STOP:
                stopped.add(int.from_bytes(content, "little"))
            else:
                calls.put(content)
    calls.put(None)
    if hasattr(signal, "pthread_kill"):
        signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGTERM)  # what it works at is cleaned up
    time.sleep(PATIENCE)
    os._exit(1)


def _exit(number: int, frame: object) -> NoReturn:
    """End as a program does that has come to its end: what it began is cleaned up."""
    raise SystemExit(0)

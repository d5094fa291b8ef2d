"""Work in one process beside the server: a CAD kernel is no thread, and what crashes there takes no design with it."""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import signal
import threading
from collections import deque
from collections.abc import Callable, Sequence
from multiprocessing.connection import Connection
from typing import Any

from geometry.ground.refusal import Refusal

#: Seconds that a process gets to end when it is told to.
_PATIENCE = 2.0
#: Stopped tasks that are remembered: one may still wait for its turn.
_REMEMBERED = 64
#: By how much a process that works aside is nicer than the server.
_ASIDE = 10


class Stopped(Refusal):
    """Work that nobody waits for any more."""


class _Stop(BaseException):
    """In the process: whoever asked has said that the work is not wanted any more."""


class Workshop:
    """A process that works off one task after the other, and is started again when it ends.

    Args:
        warm_up: called in the process when it is started, such as for imports.
        name: of it, for messages.
        aside: the process has what processor time others leave: who drags a slider does not wait for it.
    """

    def __init__(
        self, warm_up: Callable[[], None] | None = None, name: str = "the CAD process", aside: bool = True
    ) -> None:
        self._warm_up, self._name, self._aside = warm_up, name, aside
        self._turn = threading.Lock()  # one task at a time
        self._sending = threading.Lock()  # one message at a time
        self._change = threading.Lock()  # of what follows
        self._process: multiprocessing.process.BaseProcess | None = None
        self._connection: Connection | None = None
        self._is_over = False
        self._busy: object = None
        self._number = 0  # of the task: a stop that comes late is not meant for the next one
        self._stopped: deque[object] = deque(maxlen=_REMEMBERED)

    def start(self) -> None:
        """Start the process, where it does not run.

        Raises:
            Stopped: there is none any more.
        """
        with self._change:
            if self._is_over:
                raise Stopped("the studio ends")
            if self._process is not None and self._process.is_alive():
                return
            context = multiprocessing.get_context("spawn")
            self._connection, theirs = context.Pipe()
            self._process = context.Process(target=_work, args=(theirs, self._warm_up, self._aside), name=self._name)
            self._process.start()
            theirs.close()

    def run(
        self,
        work: Callable[..., Any],
        arguments: Sequence[Any],
        tell: Callable[[str], None] | None = None,
        task: object = None,
    ) -> Any:
        """What a function returns, called in the process; waits for its turn.

        Args:
            work: a function of a module, by name; with ``tell`` it takes a further argument ``tell``.
            arguments: of it.
            tell: called with each line that the function tells.
            task: by which :meth:`stop` knows it.

        Raises:
            Refusal: that of the function, or the process ended without an answer.
            Stopped: it was stopped.
        """
        with self._turn:
            with self._change:
                self._busy, self._number = task, self._number + 1
            try:
                if self._is_stopped(task):
                    raise Stopped("stopped")
                self.start()
                return self._answer(work, arguments, tell, task)
            except Stopped:
                raise
            except (EOFError, OSError, RuntimeError) as error:
                if self._is_stopped(task):  # whatever broke, it was told to end
                    self.close()
                    raise Stopped("stopped") from None
                if isinstance(error, RuntimeError):
                    raise
                self.close()  # what is left of it: it may still count as alive
                raise Refusal(
                    f"{self._name} ended without an answer; it is started again, the design is kept"
                ) from None
            finally:
                with self._change:
                    self._busy = None

    def _is_stopped(self, task: object) -> bool:
        return task is not None and any(each is task for each in [*self._stopped])

    def _answer(
        self, work: Callable[..., Any], arguments: Sequence[Any], tell: Callable[[str], None] | None, task: object
    ) -> Any:
        connection = self._connection
        assert connection is not None
        with self._sending:
            connection.send((self._number, work, tuple(arguments), tell is not None))
        if self._is_stopped(task):  # whoever stopped it meanwhile could not say so
            with self._sending:
                connection.send((self._number, "stop"))
        while True:
            kind, value = connection.recv()
            if kind == "told" and tell is not None:
                tell(value)
            elif kind == "done":
                return value
            elif kind == "refused":
                raise Refusal(value)
            elif kind == "stopped":
                raise Stopped("stopped")
            elif kind == "failed":
                raise RuntimeError(value)  # a mistake of ours, with its traceback

    def stop(self, task: object, at_once: bool = False) -> None:
        """Say that a task is not wanted any more: it ends when it next tells something, or at once with its process."""
        with self._change:
            self._stopped.append(task)
            if self._busy is task and self._connection is not None:
                if self._sending.acquire(blocking=False):  # else the task itself is being sent
                    with contextlib.suppress(OSError):
                        self._connection.send((self._number, "stop"))
                    self._sending.release()
                if at_once and self._process is not None:
                    self._process.terminate()  # it may have processes and folders of its own to clear away
                    killed = threading.Timer(_PATIENCE, self._process.kill)
                    killed.daemon = True
                    killed.start()

    def end(self) -> None:
        """End the process for good: who was about to start it does not."""
        with self._change:
            self._is_over = True
        self.close()

    def close(self) -> None:
        """End the process."""
        with self._change:
            if self._process is None:
                return
            self._process.terminate()
            self._process.join(_PATIENCE)
            if self._process.is_alive():
                self._process.kill()
                self._process.join()
            if self._connection is not None:
                self._connection.close()
            self._process = self._connection = None


def _end(number: int, frame: object) -> None:
    """End as a program does that has come to its end: what it began is cleared away."""
    raise SystemExit(0)


def _work(connection: Connection, warm_up: Callable[[], None] | None, aside: bool) -> None:
    """Work off tasks until whoever gives them is gone."""
    import traceback

    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the server decides
    signal.signal(signal.SIGTERM, _end)
    if aside and hasattr(os, "nice"):  # Windows has none
        os.nice(_ASIDE)
    if warm_up is not None:
        warm_up()

    def tell(line: str) -> None:
        while connection.poll():
            if connection.recv() == (number, "stop"):
                raise _Stop
        connection.send(("told", line))

    while True:
        try:
            number, *task = connection.recv()
        except (EOFError, OSError):
            return
        if task == ["stop"]:  # came when all was done
            continue
        work, arguments, tells = task
        try:
            answer = ("done", work(*arguments, tell) if tells else work(*arguments))
        except Refusal as error:
            answer = ("refused", str(error))
        except _Stop:
            answer = ("stopped", None)
        except OSError as error:
            answer = ("refused", f"{error.filename or 'a file'}: {error.strerror or error}")
        except Exception:
            answer = ("failed", traceback.format_exc())
        try:
            connection.send(answer)
        except OSError:
            return

"""A process that works off tasks for the server: a CAD kernel cannot run in a thread, and its crash costs no design."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Sequence
from typing import Any

from geometry.ground.child import Child
from geometry.ground.process_messages import ChildError, Stopped
from geometry.ground.refusal import Kind, Refusal

#: Number of stopped tasks that are remembered: one may still wait for its turn.
_REMEMBERED = 64
#: Niceness of a process in the background.
_BACKGROUND = 10


class TaskProcess:
    """A process that works off one task after the other, and is started again if it has ended.

    Args:
        start: called in the process when it is started, such as for imports.
        name: what it is to a user.
        in_background: the process takes only the processor time that others leave, so that no slider waits for it.
    """

    def __init__(
        self, start: Callable[[], None] | None = None, name: str = "the CAD process", in_background: bool = True
    ) -> None:
        self._start, self._name, self._niceness = start, name, _BACKGROUND if in_background else 0
        self._turn = threading.Lock()  # one task at a time
        self._change = threading.Lock()  # of what follows
        self._child: Child | None = None
        self._is_over = False
        self._busy: object = None
        self._stopped: deque[object] = deque(maxlen=_REMEMBERED)

    def start(self) -> None:
        """Start the process, if it does not run.

        Raises:
            Stopped: it was ended for good.
        """
        with self._change:
            self._running()

    def _running(self) -> Child:
        if self._is_over:
            raise Stopped("the studio ends", kind=Kind.STOPPED)
        if self._child is None or not self._child.is_alive:
            self._child = Child(self._name, start=self._start, niceness=self._niceness)
        return self._child

    def run(
        self,
        work: Callable[..., Any],
        arguments: Sequence[Any],
        report: Callable[[str], None] | None = None,
        task: object = None,
    ) -> Any:
        """Return value of a function called in the process; waits for its turn.

        Args:
            work: a function of a module; with ``report`` it takes a further argument ``report``.
            arguments: its arguments.
            report: called with each line that the function reports.
            task: by which :meth:`stop` knows it.

        Raises:
            Exception: what the function raised.
            Refusal: the process ended without a result.
            Stopped: the task was stopped.
        """

        def stop() -> None:
            if self._is_stopped(task):
                child.stop()

        with self._turn:
            with self._change:
                if self._is_stopped(task):
                    raise Stopped("stopped", kind=Kind.STOPPED)
                child, self._busy = self._running(), task
            try:
                return child.call(work, *arguments, report=report, beat=stop)
            except Exception as error:
                if self._is_stopped(task):  # whatever broke, it was asked to end
                    raise Stopped("stopped", kind=Kind.STOPPED) from None
                if not isinstance(error, ChildError):
                    raise
                problem = f"{self._name} ended without a result; it is started again, and the design is kept"
                raise Refusal(problem, kind=Kind.STOPPED) from None
            finally:
                with self._change:
                    self._busy = None

    def _is_stopped(self, task: object) -> bool:
        return task is not None and any(each is task for each in [*self._stopped])

    def stop(self, task: object, at_once: bool = False) -> None:
        """Post that nobody waits for a task: it ends when it next reports something, or at once with its process."""
        with self._change:
            self._stopped.append(task)
            if at_once and self._busy is task and self._child is not None:
                # It may have processes and folders of its own to clean up.
                threading.Thread(target=self._child.end, daemon=True).start()

    def end(self) -> None:
        """End the process for good: it cannot be started again."""
        self._is_over = True
        self.close()

    def close(self) -> None:
        """End the process."""
        with self._change:
            child, self._child = self._child, None
        if child is not None:
            child.end()

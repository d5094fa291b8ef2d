"""One thread for the small matrices of this package.

At these sizes a second thread gains at most a fifth. On a busy machine threads that wait for each other cost five
times the whole, and results would depend on the number of cores.
"""

from __future__ import annotations

import functools
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager

import numpy.linalg  # noqa: F401  loaded, so that the controller below finds its library
import scipy.linalg  # noqa: F401  the same
from threadpoolctl import LibController, ThreadpoolController


class _Setting:
    """Numbers of threads as they were before the first of those who want one thread, which the last one restores."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._inside = 0
        self._libraries: list[tuple[LibController, int]] = []
        self._torch: int | None = None

    def enter(self) -> None:
        torch = sys.modules.get("torch")  # which takes seconds to load, and need not be installed
        with self._lock:
            if not self._inside:
                self._libraries = [(each, each.num_threads) for each in _libraries()]
                for library, _ in self._libraries:
                    library.set_num_threads(1)
            if torch is not None and self._torch is None:
                self._torch = torch.get_num_threads()
                torch.set_num_threads(1)
            self._inside += 1

    def leave(self) -> None:
        with self._lock:
            self._inside -= 1
            if self._inside:
                return
            for library, count in self._libraries:
                library.set_num_threads(count)
            if self._torch is not None:
                sys.modules["torch"].set_num_threads(self._torch)
                self._torch = None


_SETTING = _Setting()


@contextmanager
def one_thread() -> Iterator[None]:
    """Torch and the linear algebra of NumPy and SciPy on one thread, afterwards on as many as before.

    The setting holds for the process, as long as any of its threads is in here. It costs some microseconds, so that
    single frames bear it too.
    """
    _SETTING.enter()
    try:
        yield
    finally:
        _SETTING.leave()


@functools.cache
def _libraries() -> tuple[LibController, ...]:
    # Looking for the libraries of a process takes milliseconds: it is done once.
    return tuple(each for each in ThreadpoolController().lib_controllers if each.user_api == "blas")

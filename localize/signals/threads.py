"""One thread for the small matrices of this package.

At these sizes a second thread gains at most a fifth. On a busy machine threads that wait for each other cost five
times the whole, and results would depend on the number of cores.
"""

from __future__ import annotations

import functools
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import numpy.linalg  # noqa: F401  loaded, so that the controller below finds its library
import scipy.linalg  # noqa: F401  the same
from threadpoolctl import LibController, ThreadpoolController


@contextmanager
def one_thread() -> Iterator[None]:
    """Torch and the linear algebra of NumPy and SciPy on one thread, afterwards on as many as before.

    The setting holds for the process. It costs some microseconds, so that single frames bear it too.
    """
    torch = sys.modules.get("torch")  # which takes seconds to load, and need not be installed
    before = None if torch is None else torch.get_num_threads()
    libraries = [(each, each.num_threads) for each in _libraries()]
    if torch is not None:
        torch.set_num_threads(1)
    for library, _ in libraries:
        library.set_num_threads(1)
    try:
        yield
    finally:
        for library, count in libraries:
            library.set_num_threads(count)
        if torch is not None:
            torch.set_num_threads(before)


@functools.cache
def _libraries() -> tuple[LibController, ...]:
    # Looking for the libraries of a process takes milliseconds: it is done once.
    return tuple(each for each in ThreadpoolController().lib_controllers if each.user_api == "blas")

"""Another user of the machine: what a function finds that runs with that user's rights."""

from __future__ import annotations

import json
import os
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import pytest

#: Number of a user that no machine has.
USER = 54_321


@contextmanager
def other_user(function: Callable[..., Any], *arguments: Any) -> Iterator[Any]:
    """What a function returns in a process of another user, as JSON carries it; the process rests until the end.

    Skips the test where no process may change its user. The process is a copy of this one, because another user may
    not be able to read the interpreter. So the function must import nothing.
    """
    if not hasattr(os, "geteuid") or os.geteuid() != 0:
        pytest.skip("only root can run a process of another user")
    found, told = os.pipe()
    process = os.fork()
    if process == 0:
        try:
            os.close(found)
            os.setgroups([])
            os.setgid(USER)
            os.setuid(USER)
            try:
                answer = [True, function(*arguments)]
            except Exception as error:
                answer = [False, repr(error)]
            os.write(told, json.dumps(answer).encode())
            os.close(told)
            signal.pause()
        finally:
            os._exit(1)
    os.close(told)
    try:
        with open(found, encoding="utf-8") as lines:
            text = lines.read()
        assert text, "the process of another user ended"
        done, value = json.loads(text)
        assert done, value
        yield value
    finally:
        os.kill(process, signal.SIGKILL)
        os.waitpid(process, 0)

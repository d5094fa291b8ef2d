"""One thread of linear algebra, also where threads of the program enter and leave at different times."""

from __future__ import annotations

from localize.signals import threads
from localize.signals.threads import one_thread


def counts() -> list[int]:
    return [library.num_threads for library in threads._libraries()]


def test_the_last_who_leaves_restores_the_setting() -> None:
    before = counts()
    for library in threads._libraries():
        library.set_num_threads(2)
    try:
        first, second = one_thread(), one_thread()
        first.__enter__()
        second.__enter__()
        first.__exit__(None, None, None)
        assert set(counts()) == {1}
        second.__exit__(None, None, None)
        assert set(counts()) == {2}
    finally:
        for library, count in zip(threads._libraries(), before, strict=True):
            library.set_num_threads(count)

"""One search of designs at a time, which a page can stop."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest
from refusals import refused

from geometry import Kind, prototype
from geometry.ground.process_messages import Stopped
from studies.studio.job_search import JobSearch
from studies.studio.messages import MessageError

ARRAY = prototype("array-2x6")


class Searching:
    """A workplace whose search ends when the test sets its result."""

    def __init__(self) -> None:
        self.found: asyncio.Future[dict[str, Any]] = asyncio.get_running_loop().create_future()
        self.asked: list[tuple[str, Mapping[str, Any]]] = []

    async def job_words(self) -> dict[str, Any]:
        return {"printer": "resin"}

    async def proposals(
        self, name: str, asked: Mapping[str, Any], notify: Callable[[str], None], task: object
    ) -> dict[str, Any]:
        self.asked.append((name, asked))
        notify("figures of 12 designs, 50%")
        return await self.found

    def stop_apart(self, name: str, task: object) -> None:
        assert name == "proposals"
        self.found.set_exception(Stopped("stopped", kind=Kind.STOPPED))


def played(play: Callable[[JobSearch, Searching, list[Any]], Any]) -> list[Any]:
    """Messages to the page while something is played."""
    sent: list[Any] = []

    async def post(message: dict[str, Any] | bytes) -> None:
        sent.append(message)

    async def run() -> None:
        place = Searching()
        await play(JobSearch(place, post), place, sent)  # type: ignore[arg-type]

    with ThreadPoolExecutor(1) as thread:  # a browser of other tests may have left its loop in this one
        thread.submit(asyncio.run, run()).result()
    return sent


async def settle() -> None:
    for _ in range(10):
        await asyncio.sleep(0)


def test_a_page_gets_the_words_the_progress_and_the_proposals_of_its_search() -> None:
    async def play(search: JobSearch, place: Searching, sent: list[Any]) -> None:
        await search.words(ARRAY, 3)
        search.search(ARRAY, 3, {"name": "mine", "asked": {"points": "16"}})
        await settle()
        place.found.set_result({"question": "16 points", "problem": "", "designs": []})
        await settle()
        assert place.asked == [("mine", {"points": "16"})]

    words, *lines, last = played(play)
    assert words == {"type": "job", "printer": "resin"}
    assert [each["line"] for each in lines] == ["begins", "figures of 12 designs, 50%"]
    assert {each["revision"] for each in lines} == {3}
    assert last == {"type": "proposals", "question": "16 points", "problem": "", "designs": []}


def test_a_second_search_is_refused_until_the_first_is_stopped() -> None:
    async def play(search: JobSearch, place: Searching, sent: list[Any]) -> None:
        search.stop()  # none runs: nothing happens
        search.search(ARRAY, 0, {"name": "mine", "asked": {}})
        await settle()
        with refused(Kind.CONFLICT):
            search.search(ARRAY, 0, {"name": "mine", "asked": {}})
        search.stop()
        await settle()
        place.found = asyncio.get_running_loop().create_future()
        search.search(ARRAY, 1, {"name": "mine", "asked": {}})
        await settle()
        search.stop()
        await settle()
        assert len(place.asked) == 2

    sent = played(play)
    assert [(each["revision"], each["message"]) for each in sent if each["type"] == "failed"] == [
        (0, "stopped"),
        (1, "stopped"),
    ]


@pytest.mark.parametrize("message", [{}, {"name": "mine"}, {"name": 3, "asked": {}}, {"name": "mine", "asked": []}])
def test_a_message_that_is_no_search_is_refused(message: dict[str, Any]) -> None:
    async def play(search: JobSearch, place: Searching, sent: list[Any]) -> None:
        with pytest.raises(MessageError):
            search.search(ARRAY, 0, message)
        assert place.asked == []

    assert played(play) == []

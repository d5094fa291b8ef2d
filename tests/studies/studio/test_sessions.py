"""Every page has a design of its own on the server, and finds it again."""

from __future__ import annotations

import asyncio
import json
import struct
import threading
from collections.abc import Callable, Coroutine, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from geometry import Kind, Refusal, prototype
from geometry.ground.process_messages import Stopped
from geometry.stock import catalogue
from studies.panels.curves import curves_of, quick_library
from studies.panels.verdict_panel import verdict_figures
from studies.studio.exports import MOST_FILES
from studies.studio.session import Session
from studies.studio.sessions import MOST_SESSIONS, Sessions
from studies.studio.stage import Job, Stage
from studies.studio.workplace import Workplace

ARRAY = prototype("array-2x6")


def ended(play: Coroutine[Any, Any, Any]) -> Any:
    """What a coroutine gives; in a thread, because a browser of other tests may have left its loop in this one."""
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(asyncio.run, play).result()


class Page:
    """Messages that a page would get."""

    def __init__(self) -> None:
        self.texts: list[dict[str, Any]] = []
        self.curves: list[bytes] = []

    async def send(self, message: str | bytes) -> None:
        if isinstance(message, bytes):
            self.curves.append(message)
        else:
            self.texts.append(json.loads(message))

    async def until(self, kind: str) -> dict[str, Any]:
        for _ in range(24000):
            found = [each for each in self.texts if each["type"] == kind]
            if found:
                return found[-1]
            await asyncio.sleep(0.005)
        pytest.fail(f"no {kind}")

    async def until_curves(self, revision: int) -> dict[str, Any]:
        for _ in range(24000):
            for message in reversed(self.curves):
                header, values = unpacked(message)
                if header["revision"] == revision:
                    return {**header, "values": values}
            await asyncio.sleep(0.005)
        pytest.fail(f"no curves of {revision}")


def unpacked(message: bytes) -> tuple[dict[str, Any], Any]:
    (length,) = struct.unpack("<I", message[:4])
    return json.loads(message[4 : 4 + length]), np.frombuffer(message[4 + length :], "<f4")


@pytest.fixture(scope="module")
def workplace() -> Any:
    place = Workplace()
    yield place
    place.close()


def test_a_change_is_told_with_what_changed_alone_and_its_curves_follow(workplace: Workplace) -> None:
    async def play() -> None:
        page, session = Page(), Session(ARRAY, workplace)
        await session.join(page.send)
        first = await page.until("design")
        assert first["stated"]["tube"]["length"] == 12.5
        page.texts.clear()
        await session.take({"do": "set", "name": "tube.length", "value": 14.0})
        told = await page.until("design")
        assert told["values"] == {"tube.length": 14.0}
        assert (told["revision"], told["undo"], told["redo"], told["unsaved"]) == (1, True, False, True)
        curves = await page.until_curves(1)
        library, _ = quick_library(ARRAY.with_values({"tube.length": 14.0}))
        expected = curves_of(library.transfer_function, "level")
        np.testing.assert_array_equal(curves["values"], expected.values.astype("<f4").ravel())
        assert (curves["points"], curves["heard_by"], curves["unit"]) == ([*range(1, 13)], ["A", "B"], "dB")
        assert curves["validity"].startswith("quick, \N{PLUS-MINUS SIGN}")
        assert len(page.curves[-1]) < 20_000

    ended(play())


def test_a_drag_is_one_step_and_counts_from_its_beginning(workplace: Workplace) -> None:
    async def play() -> None:
        page, session = Page(), Session(ARRAY, workplace)
        await session.join(page.send)
        drag = {"do": "drag", "part": "point 6", "at": [92.5, 0, 3], "gesture": "a"}
        for way, length in ((2.5, 13.0), (10.0, 14.5), (5.0, 13.5)):
            page.texts.clear()
            await session.take({**drag, "by": [way, 0.0, 0.0]})
            assert session.state.design.tube.length == length
            moved = next(each for each in page.texts if each["type"] == "moved")
            assert (moved["words"], moved["refused"]) == (f"tube.length = {length:g} mm", "")
            assert moved["revision"] == session.state.revision
            assert (await page.until("design"))["values"] == {"tube.length": length}
        await session.take({"do": "undo"})
        assert session.state.design == ARRAY
        assert not session.state.can_undo

        page.texts.clear()
        await session.take({**drag, "by": [-500.0, 0.0, 0.0], "gesture": "b"})
        moved = next(each for each in page.texts if each["type"] == "moved")
        assert "the two walls" in moved["refused"]
        assert session.state.design.tube.length == 4.01

        await session.take({**drag, "part": "point 1", "by": [-5.0, 0.0, 0.0], "gesture": "c"})
        moved = [each for each in page.texts if each["type"] == "moved"][-1]
        before = moved["points"][6][0] - moved["shift"][0]
        assert moved["shift"][0] < 0
        assert before + moved["shift"][0] == pytest.approx(5 * 10.01, abs=1e-3)  # point 7 holds still

    ended(play())


def test_a_size_that_is_typed_is_taken_or_refused_with_the_nearest_one(workplace: Workplace) -> None:
    async def play() -> None:
        page, session = Page(), Session(ARRAY, workplace)
        await session.join(page.send)
        await session.take({"do": "resize", "size": "x", "value": 150.0})
        assert session.state.design.tube.length == 19.04
        await session.take({"do": "resize", "size": "x", "value": 20.0})
        told = await page.until("refused-size")
        assert (told["size"], round(told["nearest"], 2)) == ("x", 74.85)
        await session.take({"do": "resize", "size": "x", "value": "wide"})
        assert (await page.until("refused-size"))["message"] == "x = 'wide' must be a length in mm"
        assert session.state.design.tube.length == 19.04

    ended(play())


def test_a_bought_size_brings_the_parts_that_go_with_it(workplace: Workplace) -> None:
    async def play() -> None:
        page, session = Page(), Session(ARRAY, workplace)
        await session.join(page.send)
        sizes = (await page.until("design"))["sizes"]
        assert sizes["tube.inner_diameter"] == list(catalogue().sizes("tube.inner_diameter"))
        assert "tube.length" not in sizes
        page.texts.clear()
        await session.take({"do": "set", "name": "tube.inner_diameter", "value": 0.57, "bought": True})
        told = await page.until("design")
        assert told["values"]["tube.inner_diameter"] == 0.56
        assert {"tube.wire_diameter", "tube.outer_diameter"} <= set(told["values"])
        assert told["sizes"]["tube.outer_diameter"] != sizes["tube.outer_diameter"]
        assert catalogue().fit(session.state.design).bought
        await session.take({"do": "set", "name": "tube.inner_diameter", "value": 0.57})
        assert session.state.design.tube.inner_diameter == 0.57
        page.texts.clear()
        await session.take({"do": "set", "name": "tube.length", "value": 14.0, "bought": True})
        assert (await page.until("refused"))["name"] == "tube.length"

    ended(play())


def test_a_remedy_of_the_verdict_bar_is_one_step_and_a_bad_one_changes_nothing(workplace: Workplace) -> None:
    async def talk() -> None:
        page, session = Page(), Session(ARRAY, workplace)
        await session.join(page.send)
        changes = {"membrane.thickness": 1.0, "resonator.cavity_height": 3.0}
        await session.take({"do": "remedy", "values": changes})
        assert session.state.design == ARRAY.with_values(changes)
        await session.take({"do": "remedy", "values": {"tube.length": -1.0}})
        assert "tube.length" in (await page.until("refused-design"))["message"]
        assert session.state.design == ARRAY.with_values(changes)
        with pytest.raises(Refusal) as error:
            await session.take({"do": "remedy", "values": [1]})
        assert (error.value.kind, error.value.field) == (Kind.WRONG_TYPE, "values")
        await session.take({"do": "undo"})
        assert session.state.design == ARRAY

    ended(talk())


@pytest.mark.slow
def test_the_verdict_bar_gets_reasons_with_the_changes_that_help() -> None:
    found = verdict_figures(ARRAY.with_values({"target.size": (100.0, 30.0)}))
    assert found["outcome"] == "does not work"
    assert [row[0] for row in found["rows"]] == ["as-built accuracy of taps", "smallest tap", "size", "cost"]
    remedies = [each["remedy"] for each in found["reasons"] if each["remedy"]]
    assert remedies
    for remedy in remedies:
        assert remedy["line"].startswith(remedy["words"])
        ARRAY.with_values(json.loads(json.dumps(remedy["changes"])))


def test_what_follows_the_tube_is_told_too_until_it_is_stated(workplace: Workplace) -> None:
    values = {name: value for name, value in ARRAY.model_dump().items() if name != "microphone_tube"}

    async def play() -> None:
        page, session = Page(), Session(type(ARRAY)(**values), workplace)
        await session.join(page.send)
        page.texts.clear()
        await session.take({"do": "set", "name": "tube.length", "value": 14.0})
        assert (await page.until("design"))["values"] == {"tube.length": 14.0, "microphone_tube.length": 14.0}
        page.texts.clear()
        await session.take({"do": "set", "name": "microphone_tube.length", "value": 9.0})
        assert (await page.until("design"))["stated"]["microphone_tube"]["length"] == 9.0

    ended(play())


def test_two_pages_have_two_designs_and_each_finds_its_own_again(workplace: Workplace) -> None:
    async def play() -> None:
        sessions, pages = Sessions(ARRAY, workplace), [Page(), Page()]
        one, new = sessions.enter(None)
        other, _ = sessions.enter("a name that nobody has")
        assert new
        for session, page, length in ((one, pages[0], 13.0), (other, pages[1], 14.0)):
            await session.join(page.send)
            await session.take({"do": "set", "name": "tube.length", "value": length})
        assert (one.state.design.tube.length, other.state.design.tube.length) == (13.0, 14.0)
        one.leave(pages[0].send)
        assert sessions.enter(one.id) == (one, False)
        doubled, new = sessions.enter(other.id)  # another tab with the same memory
        assert new
        assert doubled is not other
        assert doubled.state.design == other.state.design

    ended(play())


def test_the_number_of_sessions_is_bounded_and_open_ones_stay(workplace: Workplace) -> None:
    async def play() -> None:
        sessions, page = Sessions(ARRAY, workplace), Page()
        first, _ = sessions.enter(None)
        await first.join(page.send)
        for _ in range(MOST_SESSIONS + 5):
            sessions.enter(None)
        assert len(sessions) == MOST_SESSIONS
        assert sessions.find(first.id) is first

    ended(play())


def test_while_a_job_runs_of_those_asked_for_the_last_alone_is_done() -> None:
    done: list[int] = []
    superseded: list[int] = []

    async def play() -> None:
        gate = asyncio.Event()

        async def do(job: Job) -> None:
            await gate.wait()
            done.append(job.revision)

        stage = Stage(do, lambda job: superseded.append(job.revision))
        for revision in range(5):
            stage.ask(Job("curves", revision, ARRAY))
            await asyncio.sleep(0)
        gate.set()
        for _ in range(5):
            await asyncio.sleep(0)

    ended(play())
    assert done == [0, 4]
    assert superseded == [0, 0, 0, 0]


def test_a_job_that_fails_takes_none_of_those_that_wait_with_it() -> None:
    done: list[int] = []

    async def play() -> None:
        gate = asyncio.Event()

        async def do(job: Job) -> None:
            await gate.wait()
            if job.revision == 0:
                raise RuntimeError("a mistake")
            done.append(job.revision)

        stage = Stage(do)
        for revision in range(2):
            stage.ask(Job("curves", revision, ARRAY))
            await asyncio.sleep(0)
        gate.set()
        for _ in range(5):
            await asyncio.sleep(0)

    ended(play())
    assert done == [1]


class Busy:
    """A process that works on one file until it is let go."""

    def __init__(self) -> None:
        self.begun, self.go_on = threading.Event(), threading.Event()
        self.done: list[str] = []

    def run(self, work: Any, arguments: Any, notify: Any = None, task: Any = None) -> str:
        self.begun.set()
        assert self.go_on.wait(60)
        self.done.append(arguments[1])
        return str(Path(arguments[2]) / arguments[1])

    def stop(self, task: object, at_once: bool = False) -> None:
        raise AssertionError("the file of another page is stopped")


@pytest.fixture
def busy(workplace: Workplace, monkeypatch: pytest.MonkeyPatch) -> Iterator[Busy]:
    found = Busy()

    @contextmanager
    def process(name: str, title: str) -> Iterator[Any]:
        workplace._processes[name] = found  # type: ignore[assignment]
        yield found
        del workplace._processes[name]

    monkeypatch.setattr(workplace, "_process", process)
    yield found
    found.go_on.set()


def test_a_file_that_waits_for_that_of_another_page_is_stopped_alone(workplace: Workplace, busy: Busy) -> None:
    async def play() -> None:
        pages = [Page(), Page()]
        sessions = [Session(ARRAY, workplace) for _ in pages]
        for page, session in zip(pages, sessions, strict=True):
            await session.join(page.send)
        await sessions[0].take({"do": "export", "name": "report.html"})
        await asyncio.to_thread(busy.begun.wait, 60)
        await sessions[1].take({"do": "export", "name": "parts.zip"})
        while not any("waiting" in each.get("line", "") for each in pages[1].texts):
            await asyncio.sleep(0.005)
        await sessions[1].take({"do": "stop", "stage": "export"})
        assert (await pages[1].until("failed"))["message"] == "stopped"
        busy.go_on.set()
        assert (await pages[0].until("file"))["name"] == "array-2x6-report.html"

    ended(play())
    assert busy.done == ["report.html"]


def test_a_design_is_saved_while_another_file_is_made(workplace: Workplace, busy: Busy) -> None:
    async def play() -> None:
        page, session = Page(), Session(ARRAY, workplace)
        await session.join(page.send)
        await session.take({"do": "set", "name": "tube.length", "value": 14.0})
        await session.take({"do": "export", "name": "report.html"})
        await asyncio.to_thread(busy.begun.wait, 60)
        await session.take({"do": "export", "name": "design.toml"})
        assert (await page.until("file"))["name"] == "array-2x6.toml"
        assert not session.state.unsaved
        page.texts.clear()
        session.leave(page.send)  # the link is cut while the report is made
        busy.go_on.set()
        while not busy.done or session.exports.task is None or not session.exports.task.done():
            await asyncio.sleep(0.005)
        assert page.texts == []
        await session.join(page.send)
        assert (await page.until("file"))["name"] == "array-2x6-report.html"

    ended(play())


@pytest.mark.slow
def test_the_page_that_compares_needs_a_pinned_design(workplace: Workplace) -> None:
    async def play() -> str:
        page, session = Page(), Session(ARRAY, workplace)
        await session.join(page.send)
        await session.take({"do": "export", "name": "comparison.html"})
        assert (await page.until("refused-export"))["message"] == "pin a design first"
        await session.take({"do": "pin", "on": True})
        await session.take({"do": "set", "name": "tube.length", "value": 14.0})
        await session.take({"do": "export", "name": "comparison.html"})
        while session.exports.task is None or not session.exports.task.done():
            await asyncio.sleep(0.05)
        assert (await page.until("file"))["name"] == "array-2x6-comparison.html"
        ((path, _),) = session.exports.files.values()
        return path.read_text(encoding="utf-8")

    assert "Comparison of array-2x6-pinned, array-2x6-now" in ended(play())


def test_a_sound_card_is_given_back_before_another_is_taken(
    workplace: Workplace, monkeypatch: pytest.MonkeyPatch
) -> None:
    taken: list[str] = []

    async def live(job: Job, notify: Callable[[str], None]) -> dict[str, Any]:
        taken.append(f"take {job.options[0]}")
        while job not in stopped:
            await asyncio.sleep(0.005)
        await asyncio.sleep(0.02)  # a process takes its time to end
        taken.append(f"give {job.options[0]}")
        raise Stopped("stopped", kind=Kind.OUT_OF_RANGE)

    stopped: list[object] = []
    monkeypatch.setattr(workplace, "live", live)
    monkeypatch.setattr(workplace, "stop_apart", lambda name, task: stopped.append(task))

    async def play() -> None:
        page, session = Page(), Session(ARRAY, workplace)
        await session.join(page.send)
        for device in (1, 2):
            await session.take({"do": "listen", "device": device, "full_scale": 20})
            while f"take {device}" not in taken:
                await asyncio.sleep(0.005)
        assert taken == ["take 1", "give 1", "take 2"]
        assert not [each for each in page.texts if each["type"] == "failed"]
        await session.take({"do": "set", "name": "tube.length", "value": 14.0})
        assert "the design was changed" in (await page.until("failed"))["message"]
        while "give 2" not in taken:
            await asyncio.sleep(0.005)

    ended(play())


def test_a_page_that_comes_back_is_told_the_pinned_design_and_its_figures_again(workplace: Workplace) -> None:
    async def play() -> None:
        page, session = Page(), Session(ARRAY, workplace)
        await session.join(page.send)
        await session.take({"do": "pin", "on": True})
        kept = (await page.until("pinned"))["stated"]
        await session.take({"do": "set", "name": "tube.length", "value": 14.0})
        session.leave(page.send)
        for new, held in ((False, session), (True, Session(ARRAY, workplace))):
            page.texts.clear()
            page.curves.clear()
            await held.join(page.send)
            if new:  # of a studio that was started again
                await held.take({"do": "pin", "values": kept})
            while not any(each.get("stage") == "pinned_points" for each in page.texts):
                await asyncio.sleep(0.005)
            assert held.pinned == ARRAY
            if not new:  # figures of the current design are asked for as well
                await held.take({"do": "want", "stages": ["points"], "quantity": "level"})
                while not any(each["type"] == "compared" for each in page.texts):
                    await asyncio.sleep(0.005)
                rows = next(each for each in page.texts if each["type"] == "compared")["rows"]
                longer = {row["name"]: row for row in rows}["length"]
                assert longer["here"] > longer["there"]
                assert longer["better"] == "worse"
            while "pinned" not in [unpacked(each)[0]["stage"] for each in page.curves]:
                await asyncio.sleep(0.005)
        await held.take({"do": "pin", "values": {"name": 3}})
        assert (await page.until("refused-design"))["message"].startswith("the pinned design that the page kept: ")
        assert held.pinned == ARRAY

    ended(play())


def test_a_session_that_is_given_up_leaves_no_files(workplace: Workplace) -> None:
    async def play() -> None:
        sessions, page = Sessions(ARRAY, workplace), Page()
        first, _ = sessions.enter(None)
        longest, _ = sessions.enter(None)
        await first.join(page.send)
        await first.take({"do": "export", "name": "design.toml"})
        await page.until("file")
        ((path, _),) = first.exports.files.values()
        longest.leave(page.send)
        first.leave(page.send)
        while len(sessions) < MOST_SESSIONS:
            sessions.enter(None)
        sessions.enter(None)
        assert sessions.find(longest.id) is None  # left before the other one
        assert sessions.find(first.id) is first
        assert path.exists()
        sessions.enter(None)
        assert sessions.find(first.id) is None
        assert not path.exists()

    ended(play())


def test_what_a_sound_card_hears_is_told_until_it_is_stopped(
    workplace: Workplace, monkeypatch: pytest.MonkeyPatch
) -> None:
    stopped: list[str] = []

    async def live(job: Job, notify: Callable[[str], None]) -> dict[str, Any]:
        assert job.options == (2, 20.0)
        notify(json.dumps({"time": 0.25, "state": "touch", "point": 3, "samples": [[0.1], [0.2]]}))
        while not stopped:
            await asyncio.sleep(0.005)
        raise Stopped("stopped", kind=Kind.OUT_OF_RANGE)

    monkeypatch.setattr(workplace, "live", live)
    monkeypatch.setattr(workplace, "stop_apart", lambda name, task: stopped.append(name))

    async def play() -> None:
        page, session = Page(), Session(ARRAY, workplace)
        await session.join(page.send)
        await session.take({"do": "listen", "device": 2, "full_scale": 20})
        assert (await page.until("heard"))["event"]["point"] == 3
        await session.take({"do": "stop", "stage": "live"})
        assert (await page.until("failed"))["message"] == "stopped"

    ended(play())
    assert stopped == ["live"]


def test_a_cad_process_that_crashes_and_a_full_disk_are_told_and_the_design_is_kept(
    workplace: Workplace, monkeypatch: pytest.MonkeyPatch
) -> None:
    def crash(*arguments: Any, **options: Any) -> None:
        raise Refusal("the CAD process ended without a result", kind=Kind.STOPPED)

    async def full(*arguments: Any) -> None:
        raise OSError(28, "No space left on device", "parts.zip")

    monkeypatch.setattr(workplace.cad, "run", crash)
    monkeypatch.setattr(workplace, "export", full)

    async def play() -> None:
        page, session = Page(), Session(ARRAY, workplace)
        await session.join(page.send)
        await session.take({"do": "set", "name": "tube.length", "value": 14.0})
        await session.take({"do": "want", "quantity": "level", "stages": ["model"]})
        told = await page.until("failed")
        assert (told["stage"], told["message"]) == ("model", "the CAD process ended without a result")
        page.texts.clear()
        await session.take({"do": "export", "name": "parts.zip", "fidelity": "lumped"})
        told = await page.until("failed")
        assert told["message"] == "parts.zip: No space left on device; the design is kept"
        assert session.state.design.tube.length == 14.0

    ended(play())


def test_the_last_files_that_were_handed_out_can_be_fetched_and_older_ones_are_removed(workplace: Workplace) -> None:
    async def play() -> list[bool]:
        page, session = Page(), Session(ARRAY, workplace)
        await session.join(page.send)
        paths = []
        for _ in range(MOST_FILES + 2):
            page.texts.clear()
            await session.take({"do": "export", "name": "design.toml"})
            told = await page.until("file")
            paths.append(session.exports.files[told["file"].rsplit("/", 1)[1]][0])
        return [path.exists() for path in paths]

    assert ended(play()) == [False] * 2 + [True] * MOST_FILES


def test_a_page_whose_link_was_cut_unnoticed_takes_up_its_session_again(workplace: Workplace) -> None:
    async def play() -> None:
        sessions, page = Sessions(ARRAY, workplace), Page()
        first, _ = sessions.enter(None, "one page")
        await first.join(page.send)
        assert sessions.enter(first.id, "one page") == (first, False)
        assert sessions.enter(first.id, "another page")[0] is not first

    ended(play())

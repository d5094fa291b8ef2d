"""One fit at a time, which a page can stop, and which takes no design that was changed meanwhile."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, cast

import pytest
from refusals import refused

from geometry import ArrayDesign, Kind, load_design, prototype
from geometry.ground.process_messages import Stopped
from studies.studio.body_store import MOST_BODIES, BodyStore
from studies.studio.fit_job import FitJob
from studies.studio.messages import MessageError

ROBOT = Path(__file__).parents[3] / "docs" / "examples" / "robot"
ARRAY, FITTED = prototype("array-2x6"), load_design(ROBOT / "fingertip.toml")
BODY = Path("body.step")


class Fitting:
    """A workplace whose fit ends when the test sets its result."""

    def __init__(self, folder: Path) -> None:
        self.bodies = BodyStore(folder)
        self.found: asyncio.Future[ArrayDesign] = asyncio.get_running_loop().create_future()
        self.asked: list[Any] = []

    async def body(self, path: Path, unit: str, skin: int | None) -> dict[str, Any]:
        return {"name": path.name, "file": f"/bodies/{unit}{skin}", "shape": b"facets"}

    async def fit(self, design: ArrayDesign, asked: Any, notify: Callable[[str], None], task: object) -> ArrayDesign:
        self.asked.append(asked)
        notify("dividing the body")
        return await self.found

    def stop_apart(self, name: str, task: object) -> None:
        assert name == "fit"
        self.found.set_exception(Stopped("stopped", kind=Kind.STOPPED))


def played(folder: Path, play: Callable[[FitJob, Fitting], Any], fresh: bool = True) -> tuple[list[Any], list[Any]]:
    """Messages to the page while something is played, and the designs that are put in place."""
    sent: list[Any] = []
    taken: list[Any] = []

    async def post(message: dict[str, Any] | bytes) -> None:
        sent.append(message)

    async def take(design: ArrayDesign, revision: int) -> bool:
        taken.append((design, revision))
        return fresh

    async def run() -> None:
        place = Fitting(folder)
        await play(FitJob(cast(Any, place), post, take), place)

    with ThreadPoolExecutor(1) as thread:  # a browser of other tests may have left its loop in this one
        thread.submit(asyncio.run, run()).result()
    return sent, taken


async def settle() -> None:
    for _ in range(10):
        await asyncio.sleep(0)


def test_a_fit_says_how_far_it_is_and_its_array_is_put_in_place(tmp_path: Path) -> None:
    async def play(job: FitJob, place: Fitting) -> None:
        job.take_body(BODY)
        job.fit(ARRAY, 3, {"surface": {"pitch": 6.0}, "points": None})
        await settle()
        await job.post_again()
        place.found.set_result(FITTED)
        await settle()
        await job.post_again()  # nothing runs any more
        assert place.asked == [({"pitch": 6.0}, None, BODY)]

    sent, taken = played(tmp_path, play)
    assert [each["line"] for each in sent if each["type"] == "progress"] == ["begins", "dividing the body", "goes on"]
    assert sent[-1] == {"type": "fitted", "revision": 3}
    assert taken == [(FITTED, 3)]


def test_a_design_that_was_changed_meanwhile_is_kept(tmp_path: Path) -> None:
    async def play(job: FitJob, place: Fitting) -> None:
        job.take_body(BODY)
        job.fit(ARRAY, 3, {"surface": {}, "points": [12]})
        await settle()
        place.found.set_result(FITTED)
        await settle()

    sent, _ = played(tmp_path, play, fresh=False)
    assert sent[-1]["type"] == "failed"
    assert sent[-1]["message"].startswith("The design was changed while it was fitted")


def test_a_second_fit_is_refused_until_the_first_is_stopped(tmp_path: Path) -> None:
    async def play(job: FitJob, place: Fitting) -> None:
        job.stop()  # none runs: nothing happens
        with refused(Kind.MISSING):
            job.fit(ARRAY, 0, {"surface": {}})
        job.take_body(BODY)
        job.fit(ARRAY, 0, {"surface": {}})
        await settle()
        with refused(Kind.CONFLICT):
            job.fit(ARRAY, 0, {"surface": {}})
        job.stop()
        await settle()

    sent, taken = played(tmp_path, play)
    assert sent[-1] == {"type": "failed", "stage": "fit", "revision": 0, "message": "stopped"}
    assert taken == []


@pytest.mark.parametrize(
    "message", [{}, {"surface": []}, {"surface": {}, "points": 3}, {"surface": {}, "points": [1.5]}]
)
def test_a_message_that_is_no_fit_is_refused(tmp_path: Path, message: dict[str, Any]) -> None:
    async def play(job: FitJob, place: Fitting) -> None:
        job.take_body(BODY)
        with pytest.raises(MessageError):
            job.fit(ARRAY, 0, message)
        assert place.asked == []

    assert played(tmp_path, play) == ([], [])


def test_a_page_sees_the_body_that_was_handed_in_else_that_of_its_design(tmp_path: Path) -> None:
    async def play(job: FitJob, place: Fitting) -> None:
        await job.show(ARRAY, 0, {"unit": "mm"})
        await job.show(FITTED, 0, {"unit": "mm"})
        job.take_body(BODY)
        await job.show(FITTED, 0, {"unit": "inch", "skin": 2})
        await settle()
        for wrong in ({}, {"unit": "yard"}, {"unit": "mm", "skin": 0}, {"unit": "mm", "skin": "first"}):
            with pytest.raises(MessageError):
                await job.show(FITTED, 0, wrong)

    sent = [each for each in played(tmp_path, play)[0] if each["type"] == "body"]
    assert [(each["name"], each["file"]) for each in sent] == [
        ("", None),
        ("fingertip.step", None),
        ("body.step", "/bodies/inch2"),
    ]
    assert "shape" not in sent[-1]


# -- files of bodies -----------------------------------------------------------------------------------
def test_a_body_that_is_handed_in_is_found_by_its_content(tmp_path: Path) -> None:
    store = BodyStore(tmp_path)
    assert store.of(FITTED) is None
    path = store.keep((ROBOT / "fingertip.step").read_bytes(), "my finger.step")
    assert path.name == "my_finger.step"
    assert store.of(FITTED) == path
    assert store.of(ARRAY) is None
    for number in range(MOST_BODIES):
        store.keep(bytes([number]), "a.stl")
    assert store.of(FITTED) is None
    assert not path.exists()


@pytest.mark.parametrize("name", ["../../a.step", "..\\a.step", "/a.step", ".a.step", "a.step"])
def test_the_name_of_a_body_leads_nowhere_else(tmp_path: Path, name: str) -> None:
    path = BodyStore(tmp_path).keep(b"x", name)
    assert path.name == "a.step"
    assert path.parent.parent == tmp_path


def test_a_page_sees_no_file_outside_the_folder_of_the_design(tmp_path: Path) -> None:
    (tmp_path / "own").mkdir()
    above = FITTED.with_values({"surface.body": "../fingertip.step", "layout.frozen.inputs": ""})
    for named, design, is_seen in (
        ("sub/a.step", ARRAY, True),
        ("../a.step", ARRAY, False),
        ("/a.step", ARRAY, False),
        ("../fingertip.step", above, True),
    ):
        asked = FITTED.with_values({"surface.body": named, "layout.frozen.inputs": ""})
        assert (BodyStore(tmp_path / "kept", tmp_path / "own", design).of(asked) is not None) == is_seen

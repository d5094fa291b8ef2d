"""A studio in a process of its own, spoken with over real HTTP and websockets: who is refused, and what breaks."""

from __future__ import annotations

import http.client
import json
import os
import re
import resource
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from browser import Studio, studio
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import ClientConnection, connect

from studies.studio.guard import SECRET_HEADER
from studies.studio.page_words import MOST_UPLOAD
from studies.studio.server import MOST_MESSAGE

pytestmark = [pytest.mark.slow, pytest.mark.end_to_end]


@pytest.fixture(scope="module")
def running() -> Iterator[Studio]:
    with studio() as found:
        yield found


def asked(running: Studio, method: str, path: str, body: Any = None, **headers: str) -> tuple[int, str, str]:
    """Status, text and cookie of an answer; a body of chunks is sent without its length."""
    own = {"Host": f"127.0.0.1:{running.port}", **headers}
    link = http.client.HTTPConnection("127.0.0.1", running.port, timeout=240)
    link.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
    for name, value in own.items():
        link.putheader(name, value)
    if body is not None:
        link.putheader("Transfer-Encoding", "chunked")
    link.endheaders(body, encode_chunked=True)
    answer = link.getresponse()
    found = answer.status, answer.read().decode(), answer.headers.get("set-cookie", "").split(";")[0]
    link.close()
    return found


def keys(running: Studio) -> dict[str, str]:
    """Headers of a page of a browser that has used a code."""
    status, text, cookie = asked(running, "GET", "/?" + running.take_address().partition("?")[2])
    assert status == 200
    (secret,) = re.findall('<meta name="secret" content="([^"]*)">', text)
    return {"Cookie": cookie, SECRET_HEADER: secret}


@contextmanager
def joined(running: Studio) -> Iterator[tuple[ClientConnection, dict[str, Any]]]:
    """A page's link, and the design that it was told."""
    here = f"http://127.0.0.1:{running.port}"
    own = keys(running)
    with connect(f"ws://{here[7:]}/session", origin=here, additional_headers=own, max_size=None) as link:
        tell(link, do="hello", session=None, values=None, secret=own[SECRET_HEADER])
        yield link, until(link, lambda told: told["type"] == "design")


def tell(link: ClientConnection, **message: Any) -> None:
    link.send(json.dumps(message))


def until(link: ClientConnection, is_it: Callable[[dict[str, Any]], bool], seconds: float = 240.0) -> dict[str, Any]:
    """The next text message that is the one."""
    while True:
        message = link.recv(timeout=seconds)
        if isinstance(message, str) and is_it(told := json.loads(message)):
            return dict(told)


ROUTES = [
    *[("GET", path) for path in ("/", "/studio.js", "/studio.css", "/models/0.glb", "/files/a/b")],
    *[("GET", "/bodies/0"), ("POST", "/bodies"), ("HEAD", "/studio.css"), ("POST", "/designs")],
    *[("POST", "/recordings"), ("POST", "/recognizers")],
]


@pytest.mark.parametrize(("method", "path"), ROUTES)
@pytest.mark.parametrize("wrong", ["no cookie", "cookie", "host", "origin"])
def test_no_address_answers_a_stranger(running: Studio, method: str, path: str, wrong: str) -> None:
    here = f"http://127.0.0.1:{running.port}"
    own = keys(running)
    headers = {
        "no cookie": {"Origin": here, SECRET_HEADER: own[SECRET_HEADER]},
        "cookie": {"Origin": here, **own, "Cookie": f"{own['Cookie'].split('=')[0]}=guess"},
        "host": {"Origin": here, **own, "Host": f"evil.example:{running.port}"},
        "origin": {**own, "Origin": "http://evil.example"},
    }[wrong]
    status, text, given = asked(running, method, path, **headers)
    assert (status, given) == (403, "")
    assert len(text.splitlines()) == (0 if method == "HEAD" else 1)


@pytest.mark.parametrize("wrong", ["no cookie", "cookie", "host", "origin", "no origin"])
def test_no_websocket_is_opened_to_a_stranger(running: Studio, wrong: str) -> None:
    here, key = f"http://127.0.0.1:{running.port}", keys(running)["Cookie"]
    headers = {"Cookie": {"no cookie": "", "cookie": f"{key.split('=')[0]}=guess"}.get(wrong, key)}
    origin: Any = {"origin": "http://evil.example", "no origin": None}.get(wrong, here)
    host = "evil.example" if wrong == "host" else "127.0.0.1"
    with (
        pytest.raises(InvalidStatus) as refused,
        connect(
            f"ws://{host}:{running.port}/session", origin=origin, additional_headers=headers,
            sock=None if wrong != "host" else own_socket(running.port),
        ),
    ):  # fmt: skip
        pass
    assert refused.value.response.status_code == 403


def own_socket(port: int) -> Any:
    """A socket to this machine, whatever the name that the address has."""
    import socket

    return socket.create_connection(("127.0.0.1", port))


def test_too_long_a_message_ends_its_link_alone(running: Studio) -> None:
    with joined(running) as (link, design), joined(running) as (other, _):
        link.send(json.dumps({"do": "set", "name": "description", "value": "x" * MOST_MESSAGE}))
        with pytest.raises(ConnectionClosed) as closed:
            until(link, lambda told: False)
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 1009
        tell(other, do="set", name="tube.length", value=14)
        assert until(other, lambda told: told["type"] == "design")["values"] == {"tube.length": 14.0}
        assert design["stated"]["tube"]["length"] == 12.5


def test_an_upload_without_an_end_is_refused_once_it_is_too_long(running: Studio) -> None:
    here, chunk = f"http://127.0.0.1:{running.port}", b"x" * 16384
    chunks = (chunk for _ in range(MOST_UPLOAD // len(chunk) + 2))  # chunked: no length is told before
    status, text, _ = asked(running, "POST", "/designs", chunks, Origin=here, **keys(running))
    assert (status, json.loads(text)["message"]) == (413, "the file must be at most 256 kB")


def wav(data: bytes, size: int | None = None, channels: int = 2, kind: int = 3, bits: int = 32) -> bytes:
    """A recording of 1000 samples a second, which may say that it is longer than it is."""
    width = channels * bits // 8
    numbers = [(16, 4), (kind, 2), (channels, 2), (1000, 4), (1000 * width, 4), (width, 2), (bits, 2)]
    head = b"WAVEfmt " + b"".join(value.to_bytes(length, "little") for value, length in numbers)
    size = len(data) if size is None else size
    return b"RIFF" + (size + 36 & 0xFFFFFFFF).to_bytes(4, "little") + head + b"data" + size.to_bytes(4, "little") + data


RECORDINGS = {
    "empty": b"",
    "RIFF alone": b"RIFF",
    "text": b"no recording at all" * 10,
    "no data": wav(b""),
    "a few samples": wav(b"\0" * 64),
    "half a sample": wav(b"\0" * 8001),
    "shorter than it says": wav(b"\0" * 8000, size=0xFFFFFFF0),
    "no numbers": wav(b"\0\0\xc0\x7f" * 4000),
    "5000 channels": wav(b"\0" * 20000, channels=5000),
    "no channels": wav(b"\0" * 8000, channels=0),
    "an unknown coding": wav(b"\0" * 8000, kind=999),
    "7 bits": wav(b"\0" * 8000, bits=7),
}


@pytest.mark.parametrize("content", RECORDINGS.values(), ids=RECORDINGS)
def test_a_malformed_recording_is_refused_in_one_line(running: Studio, content: bytes) -> None:
    here = f"http://127.0.0.1:{running.port}"
    with joined(running) as (_, design):
        path = f"/recordings?session={design['session']}&name=a.wav&full_scale=1"
        status, text, _ = asked(running, "POST", path, iter([content]), Origin=here, **keys(running))
    assert status == 400, text[:200]
    assert "\n" not in json.loads(text)["message"]


def test_a_full_disk_is_told_and_the_design_is_saved_once_there_is_room(running: Studio) -> None:
    with joined(running) as (link, _):
        tell(link, do="set", name="tube.length", value=15)
        until(link, lambda told: told["type"] == "design")
        before = resource.prlimit(running.process.pid, resource.RLIMIT_FSIZE)
        resource.prlimit(running.process.pid, resource.RLIMIT_FSIZE, (100, before[1]))  # no file gets longer
        try:
            for name in ("design.toml", "library.nc"):
                tell(link, do="export", name=name, fidelity="lumped")
                told = until(link, lambda told: told["type"] in ("failed", "file"))
                assert told["type"] == "failed", name
                assert "File too large" in told["message"]
                assert "\n" not in told["message"]
        finally:
            resource.prlimit(running.process.pid, resource.RLIMIT_FSIZE, before)
        tell(link, do="export", name="design.toml", fidelity="lumped")
        address = until(link, lambda told: told["type"] == "file")["file"]
        status, text, _ = asked(running, "GET", address, **keys(running))
        assert status == 200
        assert "length = 15" in text


def test_a_studio_that_is_told_to_end_leaves_nothing_behind(tmp_path: Path) -> None:
    with studio(TMPDIR=str(tmp_path)) as found:
        assert any(each.name.startswith("acoustic-fem-studio-") for each in tmp_path.iterdir())
        found.process.terminate()
        found.process.wait(60)
    assert [each.name for each in tmp_path.iterdir() if each.name.startswith("acoustic-fem-studio-")] == []


def children(process: int) -> list[int]:
    """The processes that work for a studio."""
    found = [
        int(each) for path in Path(f"/proc/{process}/task").glob("*/children") for each in path.read_text().split()
    ]
    return [each for each in found if b"geometry.ground.child" in Path(f"/proc/{each}/cmdline").read_bytes()]


def test_a_cad_process_that_is_killed_is_told_and_started_again(running: Studio) -> None:
    with joined(running) as (link, _):
        tell(link, do="set", name="tube.length", value=16)
        tell(link, do="want", quantity="level", stages=["model"])
        until(link, lambda told: told.get("stage") == "model")
        for child in children(running.process.pid):
            os.kill(child, signal.SIGKILL)
        told = until(link, lambda told: told["type"] == "failed" and told["stage"] == "model")
        assert told["message"].endswith("ended without a result; it is started again, and the design is kept")
        tell(link, do="set", name="tube.length", value=17)
        found = until(link, lambda told: told["type"] == "figures" and told["stage"] == "model")
        status, _, _ = asked(running, "HEAD", found["found"]["file"], **keys(running))
        assert status == 200

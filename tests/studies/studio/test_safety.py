"""Nobody speaks with the studio but its own page: over HTTP and over the websocket."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack
from typing import Any

import pytest
from starlette.testclient import TestClient
from starlette.websockets import WebSocketDisconnect

from geometry import prototype
from studies.studio import server, session
from studies.studio.guard import SECRET_HEADER, Guard
from studies.studio.messages import written
from studies.studio.page_words import MOST_UPLOAD
from studies.studio.server import MOST_BODY, MOST_RECOGNIZER, MOST_RECORDING, studio_app
from studies.studio.stage import MISTAKE
from studies.studio.workplace import Workplace

ORIGIN = "http://127.0.0.1:8765"
TEXT = '<script>alert("x")</script><img src=x onerror=alert(1)>'


class Here:
    """A workshop without a process of its own."""

    def run(
        self,
        work: Callable[..., Any],
        arguments: Sequence[Any],
        tell: Callable[[str], None] | None = None,
        task: object = None,
    ) -> Any:
        return work(*arguments, tell) if tell is not None else work(*arguments)

    def stop(self, task: object) -> None: ...

    def end(self) -> None: ...


@pytest.fixture(scope="module")
def workplace() -> Iterator[Workplace]:
    place = Workplace()
    setattr(place, "workshop", Here())  # noqa: B010 - its face is that of a workshop
    yield place
    place.close()


@pytest.fixture(scope="module")
def guard() -> Guard:
    return Guard("127.0.0.1", 8765)


@pytest.fixture
def stranger(guard: Guard, workplace: Workplace) -> TestClient:
    """A client that knows no key."""
    return TestClient(studio_app(prototype("array-2x6"), guard, workplace), base_url=ORIGIN)


@pytest.fixture
def page(stranger: TestClient, guard: Guard) -> TestClient:
    """A client that opened the address with the code, and keeps its secret."""
    answer = stranger.get("/", params={"code": guard.code})
    assert answer.status_code == 200
    stranger.headers[SECRET_HEADER] = secret_in(answer.text)
    return stranger


def secret_in(text: str) -> str:
    """The secret that comes with the page."""
    (found,) = re.findall('<meta name="secret" content="([^"]*)">', text)
    return str(found)


def refused(client: TestClient, **headers: str) -> bool:
    """True if a websocket is refused before it is opened."""
    try:
        with client.websocket_connect("ws://127.0.0.1:8765/session", headers=headers):
            return False
    except WebSocketDisconnect as closed:
        return closed.code == 1008


def hello(page: TestClient, socket: Any, **more: Any) -> dict[str, Any]:
    """The design that a page is told when it begins."""
    secret = page.headers[SECRET_HEADER]
    socket.send_text(json.dumps({"do": "hello", "session": None, "values": None, "secret": secret, **more}))
    while True:
        told = next_text(socket)
        if told["type"] in ("design", "refused-design"):
            return told


def next_text(socket: Any) -> dict[str, Any]:
    while True:
        message = socket.receive()
        if message.get("text") is not None:
            found: dict[str, Any] = json.loads(message["text"])
            return found


# -- keys, names and origins ---------------------------------------------------------------------------
def test_the_code_gives_a_cookie_that_scripts_and_other_sites_do_not_get(stranger: TestClient, guard: Guard) -> None:
    code = guard.code
    answer = stranger.get("/", params={"code": code})
    cookie, secret = answer.headers["set-cookie"], secret_in(answer.text)
    assert cookie.startswith("acoustic-fem-studio-8765=")
    assert cookie.endswith("; Path=/; HttpOnly; SameSite=Strict")
    assert code not in cookie
    assert secret not in cookie
    assert code not in answer.text
    again = stranger.get("/")
    assert again.status_code == 200
    assert "set-cookie" not in again.headers
    assert secret not in again.text


def test_a_code_works_once_and_another_one_is_announced(workplace: Workplace) -> None:
    renewed: list[str] = []
    guard = Guard("127.0.0.1", 8765, lambda: renewed.append(guard.code))
    app = studio_app(prototype("array-2x6"), guard, workplace)
    first = guard.code
    browsers = [TestClient(app, base_url=ORIGIN) for _ in range(3)]
    assert [each.get("/", params={"code": first}).status_code for each in browsers] == [200, 403, 403]
    assert renewed == [guard.code] != [first]
    assert browsers[1].get("/", params={"code": guard.code}).status_code == 200
    assert [each.get("/").status_code for each in browsers] == [200, 200, 403]


@pytest.mark.parametrize("path", ["/", "/studio.js", "/studio.css", "/models/0.glb", "/files/a/b"])
@pytest.mark.parametrize("query", ["", "?code=", "?code=wrong", "?code=%F0%9F"])
def test_without_the_code_or_the_cookie_there_is_nothing(stranger: TestClient, path: str, query: str) -> None:
    answer = stranger.get(path + query)
    assert answer.status_code == 403
    assert "set-cookie" not in answer.headers
    assert "holds the key" in answer.text


def test_the_code_opens_the_page_alone(stranger: TestClient, guard: Guard) -> None:
    asked = {"params": {"code": guard.code}, "headers": {"origin": ORIGIN}}
    assert stranger.get("/studio.js", params={"code": guard.code}).status_code == 403
    assert stranger.post("/designs", **asked).status_code == 403
    assert stranger.head("/", params={"code": guard.code}).status_code == 403
    assert stranger.get("/", params={"code": guard.code}).status_code == 200


@pytest.mark.parametrize("secret", [None, "", "guess", "another browser's"])
def test_a_cookie_without_its_secret_gets_nothing_but_the_files_of_the_page(
    page: TestClient, guard: Guard, secret: str | None
) -> None:
    """All programs at 127.0.0.1 get the cookies of a browser, whatever their ports."""
    del page.headers[SECRET_HEADER]
    if secret == "another browser's":
        key = dict(page.cookies)
        secret = secret_in(page.get("/", params={"code": guard.code}).text)
        page.cookies.clear()
        page.cookies.update(key)
    headers = {"origin": ORIGIN} | ({} if secret is None else {SECRET_HEADER: secret})
    assert page.get("/", headers=headers).status_code == 200
    assert "secret" not in page.get("/", headers=headers).text
    assert page.get("/models/0.glb", headers=headers).status_code == 403
    for path in ("/designs", "/recordings", "/recognizers"):
        assert page.post(path, headers=headers).status_code == 403
    for first in ({"do": "hello", "session": None, "secret": secret}, {"do": "ping"}, [], "no table"):
        with page.websocket_connect("ws://127.0.0.1:8765/session", headers=headers) as socket:
            socket.send_text(json.dumps(first))
            assert socket.receive() == {
                "type": "websocket.close", "code": 1008, "reason": "the first message must hold the secret of the page",
            }  # fmt: skip


def test_a_websocket_over_which_no_secret_comes_is_closed(page: TestClient, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(server, "PROOF_WITHIN", 0.2)
    with page.websocket_connect("ws://127.0.0.1:8765/session", headers={"origin": ORIGIN}) as socket:
        assert socket.receive()["code"] == 1008


def test_of_websockets_over_which_no_secret_comes_the_oldest_make_room(
    page: TestClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(server, "PROOF_WITHIN", 600.0)
    monkeypatch.setattr(server, "MOST_UNPROVEN", 3)
    with page, ExitStack() as stack:
        silent = [
            stack.enter_context(page.websocket_connect("ws://127.0.0.1:8765/session", headers={"origin": ORIGIN}))
            for _ in range(4)
        ]
        assert silent[0].receive()["code"] == 1008
        assert hello(page, silent[3])["type"] == "design"


@pytest.mark.parametrize("host", ["evil.example", "127.0.0.1", "127.0.0.1:80", "evil.example:8765", ""])
def test_another_host_is_refused_with_the_cookie_too(page: TestClient, host: str) -> None:
    assert page.get("/", headers={"host": host}).status_code == 403
    assert refused(page, host=host, origin=ORIGIN)


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "https://127.0.0.1:8765", "http://127.0.0.1:8766"])
def test_another_origin_is_refused_with_the_cookie_too(page: TestClient, origin: str) -> None:
    assert page.get("/", headers={"origin": origin}).status_code == 403
    assert page.post("/designs", content=b"", headers={"origin": origin}).status_code == 403
    assert refused(page, host="127.0.0.1:8765", origin=origin)


def test_what_changes_something_needs_an_origin(page: TestClient) -> None:
    assert page.post("/designs", content=b"").status_code == 403
    assert refused(page, host="127.0.0.1:8765")


def test_a_websocket_without_the_cookie_is_refused(stranger: TestClient, page: TestClient) -> None:
    assert not refused(page, host="127.0.0.1:8765", origin=ORIGIN)
    page.cookies.clear()
    assert refused(stranger, host="127.0.0.1:8765", origin=ORIGIN)
    assert refused(stranger, host="127.0.0.1:8765", origin=ORIGIN, cookie="acoustic-fem-studio-8765=guess")


@pytest.mark.parametrize("other", ['settings={"dark": true}', "a[b]=1", "x", "words=b c d", "\xe9=1"])
def test_cookies_that_other_programs_set_are_passed_over(page: TestClient, other: str) -> None:
    """All programs at 127.0.0.1 share their cookies, whatever their ports."""
    own = "; ".join(f"{name}={value}" for name, value in page.cookies.items())
    page.cookies.clear()
    assert page.get("/", headers={b"cookie": f"{other}; {own}".encode("latin-1")}).status_code == 200


def test_the_usual_port_of_browsers_stands_in_no_address(workplace: Workplace) -> None:
    guard = Guard("127.0.0.1", 80)
    client = TestClient(studio_app(prototype("array-2x6"), guard, workplace), base_url="http://127.0.0.1")
    assert client.get("/", params={"code": guard.code}).status_code == 200
    assert client.get("/", headers={"host": "evil.example"}).status_code == 403


def test_every_answer_forbids_scripts_and_frames_of_others(page: TestClient) -> None:
    for answer in (page.get("/"), page.get("/nowhere"), page.get("/", headers={"host": "evil.example"})):
        policy = answer.headers["content-security-policy"]
        assert "default-src 'none'; script-src 'self'; style-src 'self'" in policy
        assert "unsafe" not in policy
        assert "frame-ancestors 'none'" in policy
        assert answer.headers["cache-control"] == "no-store"
        assert answer.headers["referrer-policy"] == "no-referrer"
        assert answer.headers["x-content-type-options"] == "nosniff"


def test_the_page_has_no_script_of_its_own_and_asks_nobody_else(page: TestClient) -> None:
    text = page.get("/").text
    assert "<script src=" in text
    assert "<script>" not in text
    assert "style=" not in text
    assert "://" not in text


# -- what is handed in ---------------------------------------------------------------------------------
def post(page: TestClient, content: bytes) -> Any:
    return page.post("/designs", params={"name": "mine.toml"}, content=content, headers={"origin": ORIGIN})


@pytest.mark.parametrize(
    ("content", "status", "message"),
    [
        (b"x" * (MOST_UPLOAD + 1), 413, "the file must be at most 256 kB"),
        (b"\xff\xfe", 400, "mine.toml: is not a text in UTF-8"),
        (b"name = [", 400, "mine.toml: "),
        (b"name = 'a'", 400, "mine.toml: "),
        (b"a = " + b"[" * 5000, 400, "mine.toml: "),
        (b"", 400, "mine.toml: "),
    ],
)
def test_a_file_that_is_no_design_is_refused_in_one_line(
    page: TestClient, content: bytes, status: int, message: str
) -> None:
    answer = post(page, content)
    assert answer.status_code == status
    assert answer.json()["message"].startswith(message)
    assert "\n" not in answer.json()["message"]


@pytest.mark.parametrize(
    ("session", "full_scale", "size", "status", "message"),
    [
        ("nobody's", "1", 10, 404, "there is no such session"),
        ("own", "1", MOST_RECORDING + 1, 413, "the recording must be at most 32 MB"),
        ("own", "much", 10, 400, "full_scale = 'much' must be a number of pascals"),
    ],
)
def test_a_recording_that_is_none_is_refused_in_one_line(
    page: TestClient, session: str, full_scale: str, size: int, status: int, message: str
) -> None:
    with page.websocket_connect("ws://127.0.0.1:8765/session", headers={"origin": ORIGIN}) as socket:
        own = hello(page, socket)["session"]
        asked = {"session": own if session == "own" else session, "full_scale": full_scale, "name": "a.wav"}
        answer = page.post("/recordings", params=asked, content=b"x" * size, headers={"origin": ORIGIN})
    assert (answer.status_code, answer.json()["message"]) == (status, message)


@pytest.mark.parametrize(
    ("session", "content", "status", "message"),
    [
        ("nobody's", b"{}", 404, "there is no such session"),
        ("own", b"x" * (MOST_RECOGNIZER + 1), 413, "the recognizer must be at most 16 MB"),
        ("own", b"[" * 5000, 400, "a recognizer is uploaded as a table of its files"),
        ("own", b'{"recognizer.json": "?"}', 400, "a recognizer is uploaded as a table of its files"),
        ("own", b'{"../a.json": ""}', 400, "../a.json: is not a file of a recognizer"),
        ("own", b'{"recognizer.json": ""}', 400, "recognizer.json: "),
    ],
)
def test_a_recognizer_that_is_none_is_refused_in_one_line(
    page: TestClient, session: str, content: bytes, status: int, message: str
) -> None:
    with page.websocket_connect("ws://127.0.0.1:8765/session", headers={"origin": ORIGIN}) as socket:
        own = hello(page, socket)["session"]
        asked = {"session": own if session == "own" else session}
        answer = page.post("/recognizers", params=asked, content=content, headers={"origin": ORIGIN})
    assert answer.status_code == status
    assert answer.json()["message"].startswith(message)
    assert "\n" not in answer.json()["message"]


@pytest.mark.parametrize(
    ("session", "size", "status", "message"),
    [
        ("nobody's", 10, 404, "there is no such session"),
        ("own", MOST_BODY + 1, 413, "the body must be at most 64 MB"),
    ],
)
def test_a_body_that_is_none_is_refused_in_one_line(
    page: TestClient, session: str, size: int, status: int, message: str
) -> None:
    with page.websocket_connect("ws://127.0.0.1:8765/session", headers={"origin": ORIGIN}) as socket:
        own = hello(page, socket)["session"]
        asked = {"session": own if session == "own" else session, "name": "a.step"}
        answer = page.post("/bodies", params=asked, content=b"x" * size, headers={"origin": ORIGIN})
    assert (answer.status_code, answer.json()["message"]) == (status, message)


def test_places_beside_a_design_must_be_two_texts(page: TestClient) -> None:
    for content in (b"{}", b"[1", b'["a"]', b"3"):
        asked = {"name": "a.toml", "places": "a.places.json"}
        answer = page.post("/designs", params=asked, content=content, headers={"origin": ORIGIN})
        assert (answer.status_code, answer.json()["message"]) == (400, "must be a list of two texts")


@pytest.mark.parametrize(
    "text",
    [
        "[]",
        "no json",
        "{}",
        '{"do": 1}',
        '{"do": "shout"}',
        "[" * 100_000,
        '{"do": "set"}',
        '{"do": "want"}',
        '{"do": "touch", "kind": "tap", "point": "1"}',
        '{"do": "touch", "kind": "slide", "start": [0, 0], "end": [0, NaN]}',
        '{"do": "touch", "kind": "slide", "start": [0], "end": [0, 1]}',
        f'{{"do": "touch", "kind": "slide", "start": [0, 0], "end": [0, {10**400}]}}',
        f'{{"do": "set", "name": "tube.length", "value": {10**400}}}',
        f'{{"do": "listen", "device": null, "full_scale": {10**400}}}',
        f'{{"do": "listen", "device": {10**30}, "full_scale": 1}}',
        f'{{"do": "study", "ranges": {{"tube.length": [1, {10**400}]}}, "metrics": ["volume"], "designs": 4}}',
        '{"do": "set", "name": "tube.length", "value": NaN}',
        '{"do": "set", "name": "tube.length", "value": -Infinity}',
        '{"do": "set", "name": "description", "value": "\\ud800"}',
        '{"do": "restore", "source": "x", "values": ' + '{"a":' * 5000 + "1" + "}" * 5000 + "}",
        '{"do": "listen", "device": "/dev/dsp", "full_scale": 1}',
        '{"do": "listen", "device": 0, "full_scale": "loud"}',
        '{"do": "want", "quantity": "level", "stages": [{}]}',
        '{"do": "want", "quantity": ["level"], "stages": []}',
    ],
)
def test_a_message_that_is_none_is_refused_and_the_page_goes_on(page: TestClient, text: str) -> None:
    with page.websocket_connect("ws://127.0.0.1:8765/session", headers={"origin": ORIGIN}) as socket:
        hello(page, socket)
        socket.send_text(text)
        while (told := next_text(socket))["type"] != "error":
            pass
        assert len(told["message"]) < 300
        socket.send_text('{"do": "ping"}')
        while next_text(socket)["type"] != "pong":
            pass


def test_a_mistake_of_ours_ends_no_link(page: TestClient, monkeypatch: pytest.MonkeyPatch) -> None:
    async def stumble(*arguments: Any) -> None:
        raise KeyError("a mistake")

    monkeypatch.setitem(session._ACTIONS, "toml", stumble)
    with page.websocket_connect("ws://127.0.0.1:8765/session", headers={"origin": ORIGIN}) as socket:
        hello(page, socket)
        socket.send_text('{"do": "toml"}')
        while (told := next_text(socket))["type"] != "error":
            pass
        assert told["message"] == MISTAKE
        socket.send_text('{"do": "ping"}')
        while next_text(socket)["type"] != "pong":
            pass


@pytest.mark.parametrize(
    ("error", "status", "message"),
    [
        (OSError(28, "No space left on device"), 507, "could not be kept: No space left on device; the design is kept"),
        (RuntimeError("a mistake"), 500, MISTAKE),
    ],
)
def test_why_nothing_was_taken_is_told(
    page: TestClient, workplace: Workplace, monkeypatch: pytest.MonkeyPatch, error: Exception, status: int, message: str
) -> None:
    async def fail(*arguments: Any) -> None:
        raise error

    monkeypatch.setattr(workplace, "upload", fail)
    answer = post(page, b"name = 'a'")
    assert answer.status_code == status
    assert answer.json()["message"].endswith(message)


def test_what_is_no_number_is_told_as_null() -> None:
    found = json.loads(written({"figures": {"a": float("nan"), "b": 1.5}, "list": [float("inf"), (2, "NaN")]}))
    assert found == {"figures": {"a": None, "b": 1.5}, "list": [None, [2, "NaN"]]}


def test_what_a_page_kept_is_a_design_or_is_refused(page: TestClient) -> None:
    with page.websocket_connect("ws://127.0.0.1:8765/session", headers={"origin": ORIGIN}) as socket:
        told = hello(page, socket, values={"name": TEXT})
        assert told["type"] == "refused-design"
        assert told["message"].startswith("the design that the page kept: name = ")
        assert next_text(socket)["design_name"] == "array-2x6"


def test_script_in_any_text_of_a_design_is_refused_or_told_as_it_is(page: TestClient) -> None:
    """The page sets texts as text, which a test in a browser sees; here nothing is lost or changed on the way."""
    with page.websocket_connect("ws://127.0.0.1:8765/session", headers={"origin": ORIGIN}) as socket:
        form = hello(page, socket)["form"]
        texts = [entry["name"] for entry in form if entry["kind"] == "text"]
        assert {"name", "description", "microphone.model", "microphone.source", "membrane.material"} <= {*texts}
        for name in texts:
            socket.send_text(json.dumps({"do": "set", "name": name, "value": TEXT}))
            while (told := next_text(socket))["type"] not in ("design", "refused"):
                pass
            if told["type"] == "design":
                assert told["values"] == {name: TEXT}
            else:
                assert told["name"] == name
                assert TEXT[:20] in told["message"]


@pytest.mark.parametrize(
    ("asked", "message"),
    [
        ({}, "ranges must be a table of lists of numbers or texts"),
        ({"ranges": {"tube.length": [None]}}, "ranges must be a table"),
        ({"ranges": {}, "metrics": "volume"}, "metrics must be a list of names"),
        ({"ranges": {}, "metrics": ["volume"], "designs": True}, "designs must be a whole number"),
        (
            {"ranges": {}, "metrics": ["volume"], "designs": 10**9},
            "designs = 1000000000 must be a whole number between",
        ),
        ({"ranges": {TEXT: [1, 2]}, "metrics": ["volume"], "designs": 4, "fidelity": "lumped"}, "the study: "),
        ({"ranges": {"tube.length": [9, 10]}, "metrics": ["volume"], "designs": 4, "fidelity": TEXT}, "the study: "),
    ],
)
@pytest.mark.parametrize("run", [True, False])
def test_a_study_that_is_none_is_refused_in_one_line(
    page: TestClient, asked: dict[str, Any], message: str, run: bool
) -> None:
    with page.websocket_connect("ws://127.0.0.1:8765/session", headers={"origin": ORIGIN}) as socket:
        hello(page, socket)
        socket.send_text(json.dumps({"do": "study", "run": run, **asked}))
        while (told := next_text(socket))["type"] != "failed":
            pass
        assert told["message"].startswith(message)
        assert "\n" not in told["message"]
        socket.send_text(json.dumps({"do": "load", "number": 3}))
        while (told := next_text(socket))["type"] != "refused-design":
            pass
        assert told["message"].startswith("design = 3 ")

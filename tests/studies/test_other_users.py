"""Other users of the machine get nothing from a sweep, a search or a studio, and a blocked studio recovers."""

from __future__ import annotations

import os
import re
import resource
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import psutil
import pytest
from browser import Studio, studio
from other_user import other_user
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from studies.studio.guard import SECRET_HEADER

pytestmark = [pytest.mark.slow, pytest.mark.end_to_end]
STUDY = """
base = "array-2x6"
fidelity = "lumped"
frequency = "1:100:32"
metrics = ["distance_smallest", "predicted_top1_white_noise"]
[vary]
"tube.length" = {from = 9.0, to = 30.0}
"""
SWEEP = 'sampling = "sobol"\ncases = 100000\n' + STUDY
SEARCH = STUDY + '[optimize]\ntrials = 100000\nbatch = 64\nobjectives = [{metric = "distance_smallest"}]\n'
ROOT = Path(__file__).parents[2]
FILES = 256
CONNECTIONS = 280


def until(condition: Callable[[], Any], seconds: float = 120.0) -> Any:
    """The value of a condition once it holds."""
    end = time.monotonic() + seconds
    while not (found := condition()):
        assert time.monotonic() < end, "waited too long"
        time.sleep(0.05)
    return found


# -- sweeps and searches -------------------------------------------------------------------------------
@contextmanager
def running(*words: str) -> Iterator[psutil.Process]:
    """A command of two workers that both compute."""
    line = [sys.executable, "-m", "studies.cli", *words, "--workers", "2"]
    with subprocess.Popen(
        line, env={**os.environ, "PYTHONPATH": str(ROOT)}, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    ) as command:
        try:
            process = psutil.Process(command.pid)
            until(lambda: command.poll() is not None or len(busy(process)) == 2)
            assert command.poll() is None, "it ended"
            yield process
        finally:
            command.kill()


def busy(process: psutil.Process) -> list[psutil.Process]:
    """Workers that have computed for a while."""
    return [each for each in process.children(recursive=True) if each.cpu_times().user > 1]


def ways_in(process: psutil.Process) -> list[Any]:
    """Sockets of a process and of its children to which somebody else could connect."""
    everyone = [process, *process.children(recursive=True)]
    sockets = [each for one in everyone for each in one.net_connections(kind="all")]
    return [each.laddr for each in sockets if each.status == psutil.CONN_LISTEN or each.type == socket.SOCK_DGRAM] + [
        each.laddr for each in sockets if each.family == socket.AF_UNIX and each.laddr
    ]


def seen(processes: list[int]) -> list[str]:
    """As another user: files of processes that can be opened, of those through which one takes them over."""
    found = []
    for process in processes:
        for name in ("mem", "environ", "fd/0", "fd/1"):
            try:
                os.close(os.open(f"/proc/{process}/{name}", os.O_RDWR if name != "environ" else os.O_RDONLY))
            except OSError:
                continue
            found.append(f"{process}/{name}")
    return found


@pytest.mark.parametrize(("verb", "text"), [("sweep", SWEEP), ("optimize", SEARCH)])
def test_a_sweep_or_a_search_has_no_way_in(tmp_path: Path, verb: str, text: str) -> None:
    (tmp_path / "study.toml").write_text(text)
    out = tmp_path / ("out.zarr" if verb == "sweep" else "out")
    with running(verb, str(tmp_path / "study.toml"), "--out", str(out)) as process:
        assert ways_in(process) == []
        everyone = [each.pid for each in (process, *process.children(recursive=True))]
        with other_user(seen, everyone) as found:
            assert found == []


# -- the studio ----------------------------------------------------------------------------------------
@pytest.fixture(scope="module")
def visited() -> Iterator[Studio]:
    with studio() as found:
        yield found


def answer(port: int, request: str) -> str:
    """What the studio sends, until it closes the connection."""
    with socket.create_connection(("127.0.0.1", port), 30) as link:
        link.settimeout(30)
        found = b""
        try:
            link.sendall(request.encode())
            while part := link.recv(65536):
                found += part
        except ConnectionError:
            pass
    return found.decode("utf-8", "replace")


def request(port: int, path: str, *headers: str, method: str = "GET") -> str:
    """A request whose connection is closed after its answer."""
    lines = [f"{method} {path} HTTP/1.1", f"Host: 127.0.0.1:{port}", *headers, "Connection: close", "", ""]
    return "\r\n".join(lines)


def opened(running: Studio) -> tuple[str, str, str]:
    """Code, cookie and secret of a browser that has used the address."""
    address = running.take_address()
    text = answer(running.port, request(running.port, "/?" + address.partition("/?")[2]))
    assert text.startswith("HTTP/1.1 200")
    (cookie,) = re.findall(r"set-cookie: ([^;]*);", text)
    (secret,) = re.findall('<meta name="secret" content="([^"]*)">', text)
    return address.partition("code=")[2], cookie, secret


def test_another_user_gets_nothing_with_whatever_key(visited: Studio) -> None:
    port = visited.port
    code, cookie, secret = opened(visited)
    unused = visited.take_address().partition("code=")[2]
    asked = [
        request(port, "/"),
        request(port, f"/?code={code}"),
        request(port, f"/?code={unused}"),
        request(port, "/", f"Cookie: {cookie}"),
        request(port, "/models/0.glb", f"Cookie: {cookie}", f"{SECRET_HEADER}: {secret}"),
    ]
    with other_user(lambda: [answer(port, each) for each in asked]) as answers:
        for text in answers:  # a connection that is closed before all was sent brings no answer
            assert text == "" or text.startswith("HTTP/1.1 403")
            assert "studio.js" not in text
    assert answer(port, request(port, f"/?code={unused}")).startswith("HTTP/1.1 200"), "another user used the code"


def test_who_has_seen_the_code_and_stolen_the_cookie_gets_the_files_of_the_page_alone(visited: Studio) -> None:
    """With the rights of the owner, as a program at another port of this machine has them."""
    port = visited.port
    code, cookie, secret = opened(visited)
    _, _, other_secret = opened(visited)
    origin = f"http://127.0.0.1:{port}"
    assert answer(port, request(port, f"/?code={code}")).startswith("HTTP/1.1 403")
    assert secret not in answer(port, request(port, f"/?code={code}", f"Cookie: {cookie}"))
    for stolen in ("", f"{SECRET_HEADER}: {other_secret}"):
        headers = [f"Cookie: {cookie}", f"Origin: {origin}", *([stolen] if stolen else [])]
        assert answer(port, request(port, "/models/0.glb", *headers)).startswith("HTTP/1.1 403")
        assert answer(port, request(port, "/designs", *headers, method="POST")).startswith("HTTP/1.1 403")
    with connect(f"ws://127.0.0.1:{port}/session", origin=origin, additional_headers={"Cookie": cookie}) as link:  # type: ignore[arg-type]
        link.send(f'{{"do": "hello", "session": null, "secret": "{other_secret}"}}')
        with pytest.raises(ConnectionClosed) as closed:
            link.recv(timeout=30)
    assert closed.value.rcvd is not None
    assert closed.value.rcvd.code == 1008


BROWSER = """#!/bin/sh
touch "{folder}/started"
while [ ! -e "{folder}/end" ]; do sleep 0.1; done
"""


def lines_of_processes() -> list[str]:
    """As another user: command lines of all processes, as ``ps`` shows them."""
    found = []
    for name in os.listdir("/proc"):
        try:
            with open(f"/proc/{name}/cmdline", encoding="utf-8", errors="replace") as file:
                found.append(file.read().replace("\0", " "))
        except OSError:
            continue
    return found


def test_command_lines_show_nothing_that_still_works(tmp_path: Path) -> None:
    program = tmp_path / "browser"
    program.write_text(BROWSER.format(folder=tmp_path))
    program.chmod(0o755)
    with studio(browser=True, BROWSER=f"{program} %s &") as found:
        until((tmp_path / "started").exists)
        with other_user(lines_of_processes) as lines:
            codes = {code for line in lines for code in re.findall(rf":{found.port}/\?code=([\w-]+)", line)}
        assert codes == {found.first.partition("code=")[2].strip()}
        path = f"/?code={codes.pop()}"
        with other_user(answer, found.port, request(found.port, path)) as text:
            assert text == "" or text.startswith("HTTP/1.1 403")
        assert answer(found.port, request(found.port, path)).startswith("HTTP/1.1 200")
        assert answer(found.port, request(found.port, path)).startswith("HTTP/1.1 403")
        (tmp_path / "end").touch()


UNFINISHED = {
    "silent": b"",
    "part of a line": b"GET / HT",
    "without an end": b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n",
    "an upload of a stranger": b"POST /designs HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 99\r\n\r\n",
}


def open_many(port: int, begin: str) -> int:
    """Connections with the beginning of a request, which stay open; their number."""
    kept = []
    for _ in range(CONNECTIONS):
        link = socket.socket()
        link.setblocking(False)
        link.connect_ex(("127.0.0.1", port))
        kept.append(link)
    time.sleep(1)
    for link in kept:
        try:
            link.send(begin.encode())
        except OSError:
            continue
    KEPT.append(kept)
    return len(kept)


KEPT: list[list[socket.socket]] = []


@pytest.fixture
def small() -> Iterator[Studio]:
    """A studio that may open few files."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (max(soft, 2 * CONNECTIONS), hard))
    with ExitStack() as stack:
        found = stack.enter_context(studio())
        resource.prlimit(found.process.pid, resource.RLIMIT_NOFILE, (FILES, FILES))
        yield found
        for links in KEPT:
            for link in links:
                link.close()
        KEPT.clear()


@pytest.mark.parametrize("user", ["own", "other"])
def test_a_studio_that_many_unfinished_requests_block_answers_within_seconds(small: Studio, user: str) -> None:
    address = small.take_address()
    path = "/?" + address.partition("/?")[2]
    for begin in UNFINISHED.values():
        with ExitStack() as stack:
            if user == "other":
                assert stack.enter_context(other_user(open_many, small.port, begin.decode())) == CONNECTIONS
            else:
                assert open_many(small.port, begin.decode()) == CONNECTIONS
            start = time.monotonic()
            text = answer(small.port, request(small.port, path))
            assert text.startswith("HTTP/1.1 200"), text[:100]
            assert time.monotonic() - start < 20
            path = "/?" + small.take_address().partition("/?")[2]


def dripped(port: int, text: str) -> None:
    """Send a text byte by byte.

    Raises:
        ConnectionError: the other end has closed the connection.
    """
    with socket.create_connection(("127.0.0.1", port), 30) as link:
        for byte in text:
            link.sendall(byte.encode())
            time.sleep(0.2)


def test_a_head_that_comes_byte_by_byte_is_cut_off(visited: Studio) -> None:
    start = time.monotonic()
    with pytest.raises(ConnectionError):
        dripped(visited.port, "GET / HTTP/1.1\r\nX: " + "x" * 100)
    assert 4 < time.monotonic() - start < 20

"""A studio in a process of its own, and a real Chromium that looks at it."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import pytest

TOKEN = "theStudiosOwnTestToken"
#: A renderer in software, which a machine without a graphics card has too.
ARGUMENTS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]


@dataclass
class Studio:
    """A running studio."""

    process: subprocess.Popen[str]
    port: int

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.port}/?token={TOKEN}"

    def kill(self) -> None:
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()


@contextmanager
def studio(design: str = "array-2x6", port: int = 0) -> Iterator[Studio]:
    """A studio of a design, ended at the end."""
    line = [
        *(sys.executable, "-c", "from studies.cli.app import main; main()", "studio", design),
        *("--port", str(port), "--no-browser", "--token", TOKEN),
    ]
    process = subprocess.Popen(line, stdout=subprocess.PIPE, text=True, env={**os.environ, "PYTHONUNBUFFERED": "1"})
    try:
        assert process.stdout is not None
        first = process.stdout.readline()
        yield Studio(process, int(first.split(":")[-1].split("/")[0]))
    finally:
        process.terminate()
        try:
            process.wait(20)
        except subprocess.TimeoutExpired:
            process.kill()
        process.stdout.close()


@contextmanager
def chromium() -> Iterator[Any]:
    """The Chromium of the system; the test is skipped where there is none."""
    program = shutil.which("chromium") or shutil.which("chromium-browser")
    if program is None:
        pytest.skip("there is no chromium; Debian: apt install chromium")
    api = pytest.importorskip("playwright.sync_api")
    with api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=ARGUMENTS)
        yield browser
        browser.close()


def until(page: Any, condition: str, seconds: float = 120.0) -> Any:
    """What an expression of the page's gives, once it is neither null nor false.

    Asked again and again: the page's policy forbids what Playwright waits with.
    """
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = page.evaluate(condition)
        if found:
            return found
        time.sleep(0.05)
    said = page.evaluate("document.querySelector('main').innerText")
    pytest.fail(f"{condition}: not within {seconds:g} s; the page says: {said[:500]}")

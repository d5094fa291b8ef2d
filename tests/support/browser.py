"""A studio in a process of its own, and a real Chromium that looks at it."""

from __future__ import annotations

import io
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

#: A renderer in software for three dimensions, and pages put together by the processor, as without a graphics card.
ARGUMENTS = [
    *("--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"),
    *("--ignore-gpu-blocklist", "--disable-gpu-compositing"),
]


ROOT = "document.documentElement.dataset"
PAINTED = f"{ROOT}.painted === {ROOT}.revision"


@dataclass
class Studio:
    """A running studio."""

    process: subprocess.Popen[str]
    first: str
    """The first line that it printed."""
    taken: bool = False

    @property
    def port(self) -> int:
        return int(self.first.split(":")[-1].split("/")[0])

    def take_address(self) -> str:
        """An address with a code that nobody has used; whoever takes one uses it, so that the next one is printed."""
        assert self.process.stdout is not None
        line = self.process.stdout.readline() if self.taken else self.first
        while "?code=" not in line:
            assert line, "the studio has ended"
            line = self.process.stdout.readline()
        self.taken = True
        return line.split(": ")[-1].strip()

    def kill(self) -> None:
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()


@contextmanager
def studio(
    design: str = "array-2x6",
    port: int = 0,
    module: str = "studies.cli.app",
    browser: bool = False,
    **environment: str,
) -> Iterator[Studio]:
    """A studio of a design, ended at the end; ``module`` has the command line's ``main``."""
    program = f"import sys; sys.path.append({str(Path(__file__).parent)!r}); from {module} import main; main()"
    line = [
        *(sys.executable, "-c", program, "studio", design),
        *("--port", str(port), "--browser" if browser else "--no-browser"),
    ]
    environment = {**os.environ, "PYTHONUNBUFFERED": "1", **environment}
    process = subprocess.Popen(line, stdout=subprocess.PIPE, text=True, env=environment)
    try:
        assert process.stdout is not None
        yield Studio(process, process.stdout.readline())
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


def opened(context: Any, running: Studio) -> Any:
    """A page of the studio that has painted its first curves, at an address that nobody has used."""
    return opened_at(context, running.take_address())


def opened_at(context: Any, address: str) -> Any:
    """A page of a studio that has painted its first curves; ``problems``: errors and requests to elsewhere.

    Args:
        context: of Playwright's synchronous API.
        address: what the studio printed, with its code.
    """
    found = context.new_page()
    found.problems = []
    found.on("pageerror", lambda error: found.problems.append(str(error)))
    found.on("console", lambda told: found.problems.append(told.text) if "Content Security" in told.text else None)
    here = (address.partition("?")[0], "data:", "blob:")
    found.on("request", lambda asked: None if asked.url.startswith(here) else found.problems.append(asked.url))
    found.goto(address)
    until(found, f"document.documentElement.dataset.painted !== undefined && {PAINTED}")
    return found


def panel(page: Any, name: str) -> None:
    """Open a panel, such as "touch"."""
    if page.get_attribute(f"#tab-{name}", "aria-selected") != "true":  # a click would take the keyboard away
        page.click(f"#tab-{name}")


#: The panel in which a stage is in sight; the others are beside every panel.
PANELS = {"as_built": "sound", "check": "make", "surface": "touch"}


def shown(page: Any, *stages: str, seconds: float = 240.0) -> None:
    """Open the panels of stages one after the other, and wait until each shows the design at hand."""
    for stage in stages:
        if stage in PANELS:
            panel(page, PANELS[stage])
        until(page, f"{ROOT}.shown_{stage} === {ROOT}.revision", seconds)


#: Points at places of the picture until the page names a part.
_SEARCH = """(name) => {
  const sheet = document.querySelector("#space canvas"), frame = sheet.getBoundingClientRect();
  for (let down = 0.05; down < 0.95; down += 0.02) {
    for (let across = 0.02; across < 0.98; across += 0.01) {
      const [clientX, clientY] = [frame.left + across * frame.width, frame.top + down * frame.height];
      sheet.dispatchEvent(new PointerEvent("pointermove", { clientX, clientY }));
      if (document.getElementById("pointed-part").textContent.startsWith(`\u00b7 ${name}:`)) return [clientX, clientY];
    }
  }
  return null;
}"""


def place_of(page: Any, part: str, seconds: float = 120.0) -> tuple[float, float]:
    """Place of the pointer at which the page names a part of the array that can be dragged.

    Asked until two answers agree: panels that fill move the picture, on a busy host seconds after the model is there.
    """
    end, before = time.monotonic() + seconds, None
    while time.monotonic() < end:
        place = page.evaluate(_SEARCH, part)
        if place is not None and place == before:
            return place[0], place[1]
        before = place
        time.sleep(0.2)
    pytest.fail(f"{part} is not found at one place within {seconds:g} s; the last was {before}")


def figure_of(text: str) -> tuple[float, str]:
    """Value and unit of a figure as the page writes it, forces in N; a figure without a unit has an empty one."""
    number, _, unit = text.replace("\N{MINUS SIGN}", "-").partition(" ")
    prefix = {"\N{MICRO SIGN}N": 1e-6, "nN": 1e-9}.get(unit)
    return (float(number), unit) if prefix is None else (float(number) * prefix, "N")


def field(page: Any, name: str) -> Any:
    """The control of a field of the design, in sight."""
    panel(page, "design")
    page.evaluate(f"document.querySelector(`[data-name='{name}']`).closest('details').open = true")
    return page.locator(f"[data-name='{name}'] .value")


def give(page: Any, name: str, value: str) -> None:
    """Type a value into the control of a field."""
    field(page, name).fill(value)
    field(page, name).press("Enter")


def downloaded(page: Any, act: Callable[[], None], folder: Path, seconds: float = 120.0) -> Path:
    """The file that the page hands out when something is done."""
    with page.expect_download(timeout=1000 * seconds) as download:
        act()
    path = folder / str(download.value.suggested_filename)
    download.value.save_as(path)
    return path


def lit(picture: bytes) -> Any:
    """Which pixels of a picture have the colour that lights a part: strongly red, little blue; (height, width) bool."""
    pixels = np.asarray(Image.open(io.BytesIO(picture)).convert("RGB"), int)
    return (pixels[..., 0] > 180) & (pixels[..., 2] < 90)


def until_lit(place: Any, pixels: float, seconds: float = 120.0) -> None:
    """Wait until more than so many pixels of a place are lit."""
    end = time.monotonic() + seconds
    while (found := int(lit(place.screenshot()).sum())) <= pixels:
        if time.monotonic() > end:
            pytest.fail(f"{found} pixels are lit, not more than {pixels:g}, after {seconds:g} s")

"""The studio in a real Chromium: how long a change takes to be painted, how much is sent, what the server keeps.

    python benchmarks/studio.py [DESIGN ...] [--changes N]

For each design (by default array-2x6 and line-2) a studio is started in a process of its own. ``first curves`` and
``first 3-D`` run from when the page is asked for; ``slider`` from an input event of the slider of ``tube.length`` to
the frame in which the curves of that change are painted, and ``change of colour`` from the choice of another figure to
the frame behind that in which its membranes have their colours. ``confusion`` and ``new 3-D`` run from a change of the
length to when its figures and its model are shown, all panels in sight; ``pictures`` are those drawn a second while six
simulated taps are replayed from a WAV file, and ``tap to picture`` runs from where a tap begins in it to when a picture
with a membrane lit has been shown. ``bytes`` is what the server sends for one change of the slider with the curves
alone in sight. Memory is that of the server's process, after a tenth of the changes and after all. Needs the extras
``studio`` and ``dev`` and the system's Chromium. Figures are of the machine at hand: close other programs.
"""

from __future__ import annotations

import argparse
import asyncio
import gzip
import json
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import IO, Any

import numpy as np

FULL_SCALE = 500.0  # Pa, of the taps that are replayed
#: Three dimensions by a renderer in software, pages put together by the processor: a machine without a graphics card.
ARGUMENTS = [
    *("--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"),
    *("--ignore-gpu-blocklist", "--disable-gpu-compositing"),
]
DRAG = """async (count) => {
  const root = document.documentElement, slider = document.querySelector("[data-name='tube.length'] .slider");
  const times = [];
  for (let k = 0; k < count; k++) {
    const before = Number(root.dataset.painted), begin = performance.now();
    slider.value = String(300 + (k * 37) % 400);
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    while (Number(root.dataset.painted) <= before && performance.now() - begin < 5000)
      await new Promise((next) => requestAnimationFrame(next));
    times.push(performance.now() - begin);
    await new Promise((next) => setTimeout(next, 30));
  }
  return times;
}"""


RECOLOUR = """async (count) => {
  const root = document.documentElement, choice = document.getElementById("colour-by"), times = [];
  const figures = [...choice.options].map((each) => each.value).filter((each) => each !== "as_built");
  for (let k = 0; k < count; k++) {
    const shown = () => Number(root.dataset.coloured) + Number(root.dataset.drawn);
    const before = shown(), begin = performance.now();
    choice.value = figures[(k + 1) % figures.length];
    choice.dispatchEvent(new Event("change", { bubbles: true }));
    while (shown() <= before && performance.now() - begin < 5000)
      await new Promise((next) => requestAnimationFrame(next));
    await new Promise((next) => requestAnimationFrame(next));
    times.push(performance.now() - begin);
    await new Promise((next) => setTimeout(next, 400));
  }
  return times;
}"""
SET = """(place) => {
  const slider = document.querySelector("[data-name='tube.length'] .slider");
  slider.value = String(place);
  slider.dispatchEvent(new Event("input", { bubbles: true }));
  slider.dispatchEvent(new Event("change", { bubbles: true }));
}"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("designs", nargs="*", default=["array-2x6", "line-2"])
    parser.add_argument("--changes", type=int, default=200, help="of the slider; memory over ten times as many")
    options = parser.parse_args()
    static = Path(__file__).parents[1] / "studies" / "studio" / "static"
    size = sum(len(gzip.compress(path.read_bytes())) for path in static.iterdir())
    print(f"load at the start {os.getloadavg()[0]:.1f}, {os.cpu_count()} cores")
    print(f"page: {size / 1000:.0f} kB gzip (at most 350)")
    for design in options.designs:
        measure(design, options.changes)


def measure(design: str, changes: int) -> None:
    line = [sys.executable, "-c", "from studies.cli.app import main; main()", "studio", design]
    line += ["--port", "0", "--no-browser"]
    with subprocess.Popen(line, stdout=subprocess.PIPE, text=True) as server:
        try:
            assert server.stdout is not None
            address = next_address(server.stdout)
            time.sleep(10)  # the processes have started
            in_browser(design, address, changes)
            early, late = asyncio.run(memory(next_address(server.stdout), server.pid, 10 * changes))
            print(f"  memory of the server: {early:.0f} MB after {changes} changes, {late:.0f} MB after {10 * changes}")
        finally:
            server.terminate()


def next_address(lines: IO[str]) -> str:
    """The next address that a studio prints; each works once."""
    return next(line.split(": ")[-1].strip() for line in lines if "?code=" in line)


def in_browser(design: str, address: str, changes: int) -> None:
    """Measured figures of the studio."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=ARGUMENTS)
        page = browser.new_page(viewport={"width": 1440, "height": 900})
        received: list[int] = []
        page.on("websocket", lambda socket: socket.on("framereceived", lambda frame: received.append(len(frame))))
        begin = time.perf_counter()
        page.goto(address)
        print(f"\n{design}, load {os.getloadavg()[0]:.1f}")
        print(f"  first curves {wait(page, 'painted') - begin:.2f} s (at most 1)")
        print(f"  first 3-D {wait(page, 'shown_model') - begin:.2f} s (at most 15)")
        wait(page, "shown_points")
        recoloured = np.percentile(page.evaluate(RECOLOUR, 50), [50, 95])
        print("  change of colour in 3-D, ms: p50 {:.0f}, p95 {:.0f} (at most 50)".format(*recoloured))
        again(page, design)
        page.set_viewport_size({"width": 1440, "height": 420})  # the curves alone are in sight
        page.wait_for_timeout(1500)
        page.evaluate(DRAG, 20)
        received.clear()
        times = np.array(page.evaluate(DRAG, changes))
        p50, p95 = np.percentile(times, [50, 95])
        print(f"  slider to painted curves, ms: p50 {p50:.0f}, p95 {p95:.0f} (at most 100), most {times.max():.0f}")
        print(f"  bytes a change: {sum(received) / changes / 1000:.1f} kB (at most 20)")
        browser.close()


def again(page: Any, design: str, changes: int = 3) -> None:
    """Figures and models of changed designs, the worst of some, and the pictures of taps."""
    worst = dict.fromkeys(("points", "model"), 0.0)
    page.set_viewport_size({"width": 1440, "height": 1500})  # curves, array and points are in sight
    for change in range(changes):
        before = page.evaluate("document.documentElement.dataset.revision")
        begin = time.perf_counter()
        page.evaluate(SET, (540, 460, 530)[change % 3])  # the way of the slider begins anew around each value
        while page.evaluate("document.documentElement.dataset.revision") == before:
            time.sleep(0.01)
        for stage in worst:  # the first is there long before the second
            while page.evaluate(
                f"document.documentElement.dataset.shown_{stage} !== document.documentElement.dataset.revision"
            ):
                time.sleep(0.01)
            worst[stage] = max(worst[stage], time.perf_counter() - begin)
    print(f"  confusion {worst['points']:.2f} s (at most 0.5), new 3-D {worst['model']:.2f} s (at most 3)")
    page.set_viewport_size({"width": 1440, "height": 900})
    page.click("#tab-touch")
    while page.locator("#touch-points button").count() == 0:
        time.sleep(0.05)
    with TemporaryDirectory() as folder:
        path = Path(folder) / "taps.wav"
        begins = write_taps(design, path)
        page.fill("#full-scale", f"{FULL_SCALE:g}")
        for _ in range(2):  # the first one imports the decoder
            page.evaluate("delete document.getElementById('answer').dataset.pictures")
            page.set_input_files("#replay", path)
            while (pictures := page.locator("#answer").get_attribute("data-pictures")) is None:
                if said := page.locator("[data-problem='touch']").inner_text():
                    raise SystemExit(said)
                time.sleep(0.05)
    lit = np.array([float(each) for each in str(page.locator("#answer").get_attribute("data-lit")).split(",")])
    after = [1000 * float(lit[lit > begin][0] - begin) for begin in begins if np.any(lit > begin)]
    told = f"ms: p50 {np.median(after):.0f}, most {max(after):.0f} (at most 100), {len(after)} of {len(begins)} lit"
    print(f"  pictures a second: {pictures} (at least 30); tap to picture, {told}")


def write_taps(design: str, path: Path, count: int = 7) -> list[float]:
    """Taps one after the other, written for :data:`FULL_SCALE`; when they begin, without the first, s."""
    from acoustic_fem.sound.sound_file import write_wav
    from geometry import prototype
    from localize.contacts.contact_shapes import QUIET
    from studies.panels.touching import simulate_touch

    array = prototype(design)
    takes = [simulate_touch(array, 1 + 2 * sample % array.point_count, "tap", sample) for sample in range(1, count + 1)]
    signals = [np.frombuffer(each["signals"], "<f4").reshape(len(each["microphones"]), -1) for each in takes]
    write_wav(path, np.concatenate(signals, axis=1) / FULL_SCALE, 1000, bits=32)
    begins = np.cumsum([each.shape[1] for each in signals[:-1]]) / 1000 + QUIET[0]
    return [float(begin) for begin in begins]


def wait(page: Any, name: str) -> float:
    while page.evaluate(f"document.documentElement.dataset.{name} === undefined"):
        time.sleep(0.01)
    return time.perf_counter()


async def memory(address: str, process: int, changes: int) -> tuple[float, float]:
    """Resident memory of the server in MB after a tenth of the changes and after all, each awaited until its curves."""
    import urllib.request

    from websockets.asyncio.client import connect

    here = address.partition("/?")[0]
    with urllib.request.urlopen(address) as answer:
        cookie = answer.headers["set-cookie"].split(";")[0]
        (secret,) = re.findall('<meta name="secret" content="([^"]*)">', answer.read().decode())
    early = 0.0
    async with connect(
        f"ws{here.removeprefix('http')}/session", origin=here, additional_headers={"Cookie": cookie}, max_size=None
    ) as socket:
        await socket.send(json.dumps({"do": "hello", "session": None, "values": None, "secret": secret}))
        for change in range(changes):
            value = 10 + (change % 997) * 0.01
            await socket.send(json.dumps({"do": "set", "name": "tube.length", "value": value, "gesture": "drag"}))
            while revision(await socket.recv()) != change + 1:  # of changes that come at once the last has curves
                pass
            if change == changes // 10:
                early = resident(process)
    return early, resident(process)


def revision(message: str | bytes) -> int | None:
    """Number of the change that some curves show; None of all other messages."""
    if isinstance(message, str):
        return None
    found: int = json.loads(message[4 : 4 + int.from_bytes(message[:4], "little")])["revision"]
    return found


def resident(process: int) -> float:
    pages = int(Path(f"/proc/{process}/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


if __name__ == "__main__":
    main()

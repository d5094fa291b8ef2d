"""Pictures of the studio: the README's moving one, in which a membrane is dragged, and the one of its guide.

``python docs/moving_picture.py`` opens the studio in Chromium, drags a membrane so that all tubes get longer, and
writes docs/images/studio-moving.webp and studio.png from what the page paints.
"""

from __future__ import annotations

import io
import sys
from pathlib import Path
from typing import Any

from PIL import Image

sys.path.append(str(Path(__file__).parents[1] / "tests" / "support"))
from browser import PAINTED, chromium, give, opened, place_of, shown, studio, until

IMAGES = Path(__file__).parent / "images"
OUT, STILL = IMAGES / "studio-moving.webp", IMAGES / "studio.png"
DESIGN, FIELD, MEMBRANE = "array-2x6", "tube.length", "membrane 6"
SIZE = {"width": 1200, "height": 880}
#: Places of the pointer on the way of the membrane, pixels; there and back again.
WAY = [0, 8, 16, 24, 32, 40, 48, 56, 64, 72]
STILL_SIZE = {"width": 1440, "height": 900}
#: Duration of a frame, and of the first and the last one, ms.
FRAME, REST = 140, 1200
#: Largest file, bytes.
LARGEST = 1_500_000


def frames(page: Any) -> list[Image.Image]:
    """Pictures of the page while a membrane is dragged, one for each place of the pointer."""
    shown(page, "model", "verdict", seconds=300)
    page.click("#pin")
    x, y = place_of(page, MEMBRANE)
    page.mouse.move(x, y)
    page.mouse.down()
    found = []
    for across in WAY:
        page.mouse.move(x + across, y)
        page.wait_for_timeout(300)
        until(page, PAINTED)
        found.append(picture(page))
    page.mouse.up()
    shown(page, "model", "verdict", seconds=300)
    page.wait_for_timeout(300)
    found.append(picture(page))
    return found


def picture(page: Any) -> Image.Image:
    """What the page shows."""
    return Image.open(io.BytesIO(page.screenshot())).convert("RGB")


def still(page: Any) -> list[Image.Image]:
    """The picture of the guide: point 3 lit in the exploded array, curves of shorter tubes dashed."""
    give(page, FIELD, "9")
    until(page, PAINTED)
    page.click("#pin")
    give(page, FIELD, "14")
    until(page, PAINTED)
    page.evaluate("document.getElementById('exploded').value = 45")
    page.evaluate("document.getElementById('exploded').dispatchEvent(new Event('input'))")
    page.check("#dimensions")
    page.select_option("#point", "3")
    shown(page, "model", "points", "verdict", seconds=300)
    page.evaluate("document.querySelector('.side-panel').scrollTop = 0")
    page.wait_for_timeout(1000)
    return [picture(page)]


def main() -> None:
    """Write both pictures, and end with an error if the page had one or the file is too large."""
    problems: list[str] = []
    taken = []
    with studio(DESIGN) as running, chromium() as browser:
        for size, look in ((STILL_SIZE, still), (SIZE, frames)):
            context = browser.new_context(viewport=size, reduced_motion="reduce")
            page = opened(context, running)
            taken.append(look(page))
            problems += page.problems
            context.close()
    (guide,), seen = taken
    if problems:
        sys.exit(f"the page has problems: {problems}")
    guide.save(STILL, optimize=True)
    film = seen + seen[-2:0:-1]
    times = [FRAME] * len(film)
    times[0] = times[len(seen) - 1] = REST
    film[0].save(OUT, save_all=True, append_images=film[1:], duration=times, loop=0, quality=70, method=6)
    size = OUT.stat().st_size
    print(f"{OUT.name}: {len(film)} frames, {size} bytes")
    if size > LARGEST:
        sys.exit(f"{OUT.name} has {size} bytes, allowed {LARGEST}")


if __name__ == "__main__":
    main()

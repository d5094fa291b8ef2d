"""The README's moving picture: a tube is made longer in the studio, and every curve follows.

``python docs/moving_picture.py`` opens the studio in Chromium, moves one field step by step, and writes
docs/images/studio-moving.webp from what the page paints.
"""

from __future__ import annotations

import io
import sys
from pathlib import Path
from typing import Any

from PIL import Image

sys.path.append(str(Path(__file__).parents[1] / "tests" / "support"))
from browser import PAINTED, ROOT, chromium, give, opened, studio, until

OUT = Path(__file__).parent / "images" / "studio-moving.webp"
DESIGN, FIELD = "array-2x6", "tube.length"
SIZE = {"width": 1200, "height": 880}
#: mm; there and back again.
LENGTHS = [12.5, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22]
#: True once the verdict is that of the design shown.
SETTLED = f"{ROOT}.shown_verdict === {ROOT}.revision"
#: Duration of a frame, and of the first and the longest tube, ms.
FRAME, REST = 140, 1200
#: Largest file, bytes.
LARGEST = 1_500_000


def frames(page: Any) -> list[Image.Image]:
    """Pictures of the page, one for each length."""
    page.click("#pin")
    field = page.locator(f"[data-name='{FIELD}']")
    field.scroll_into_view_if_needed()
    found = []
    for number, length in enumerate(LENGTHS):
        if number:
            give(page, FIELD, f"{length:g}")
            until(page, f"Number({ROOT}.revision) >= {number} && {PAINTED}")
            until(page, f"{ROOT}.shown_model === {ROOT}.revision", 300)
        else:
            until(page, f"{ROOT}.shown_model === {ROOT}.revision", 300)
        if number in (0, len(LENGTHS) - 1):
            until(page, SETTLED, 300)
        page.wait_for_timeout(300)
        found.append(Image.open(io.BytesIO(page.screenshot())).convert("RGB"))
    return found


def main() -> None:
    """Write the picture, and end with an error if the page had one or the file is too large."""
    with studio(DESIGN) as running, chromium() as browser:
        context = browser.new_context(viewport=SIZE, reduced_motion="reduce")
        page = opened(context, running)
        seen = frames(page)
        problems = page.problems
        context.close()
    if problems:
        sys.exit(f"the page has problems: {problems}")
    shown = seen + seen[-2:0:-1]
    times = [FRAME] * len(shown)
    times[0] = times[len(seen) - 1] = REST
    shown[0].save(OUT, save_all=True, append_images=shown[1:], duration=times, loop=0, quality=70, method=6)
    size = OUT.stat().st_size
    print(f"{OUT.name}: {len(shown)} frames, {size} bytes")
    if size > LARGEST:
        sys.exit(f"{OUT.name} has {size} bytes, allowed {LARGEST}")


if __name__ == "__main__":
    main()

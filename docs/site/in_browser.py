"""The built site in the Chromium of the system: no page is wider than its window, and axe-core finds nothing serious.

``python docs/site/in_browser.py docs/build/html`` looks at one page of each kind, wide in light and narrow in dark
colours. Without Chromium it says so and ends with exit code 0. No host is asked for anything: axe-core comes with the
package axe-playwright-python.
"""

from __future__ import annotations

import shutil
import sys
from collections.abc import Iterator
from importlib.resources import files
from pathlib import Path
from typing import Any

#: One page of each kind.
PAGES = (
    "index", "install", "gallery", "theory", "tutorial", "notebooks/first_steps", "verification", "design-file",
    "reference/made/verbs", "search",
)  # fmt: skip
#: Width of the window, px, and colours.
WINDOWS = ((1440, "light"), (1024, "light"), (390, "dark"))
#: Of axe-core's grades.
SERIOUS = ("serious", "critical")
_WIDER = "document.documentElement.scrollWidth - document.documentElement.clientWidth"


def faults_of(page: Any, address: str) -> Iterator[str]:
    """What is wrong with a page: one line each.

    Args:
        page: of Playwright's synchronous API.
        address: what it opens.
    """
    page.goto(address)
    if (wider := page.evaluate(_WIDER)) > 0:
        yield f"{wider} px wider than its window"
    # The package's own reader takes the encoding of the locale, which a library may have set to ASCII by then.
    page.evaluate(files("axe_playwright_python").joinpath("axe.min.js").read_text("utf-8"))
    for found in page.evaluate("axe.run()")["violations"]:
        if found["impact"] in SERIOUS:
            yield f"{found['id']} ({found['impact']}): {', '.join(str(node['target'][0]) for node in found['nodes'])}"


def main(folder: Path, pages: tuple[str, ...] = PAGES) -> int:
    """Exit code: 1 with a line for each fault."""
    program = shutil.which("chromium") or shutil.which("chromium-browser")
    if program is None:
        print("The site was not looked at in a browser: there is no chromium (Debian: apt install chromium)")
        return 0
    from playwright.sync_api import sync_playwright

    faults = []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        for width, colours in WINDOWS:
            context = browser.new_context(viewport={"width": width, "height": 900}, color_scheme=colours)
            page = context.new_page()
            for name in pages:
                address = (folder / f"{name}.html").resolve().as_uri()
                faults += [f"{name}, {width} px, {colours}: {fault}" for fault in faults_of(page, address)]
            context.close()
        browser.close()
    for line in faults:
        print(line, file=sys.stderr)
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))

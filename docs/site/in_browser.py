"""The built site in the Chromium of the system: no page is too wide, axe-core is content, and the search finds.

``python docs/site/in_browser.py docs/build/html`` looks at one page of each kind, wide in light and narrow in dark
colours: no page may be wider than its window. The search must find all of :data:`search_words.WORDS` and of
:data:`queries.QUERIES`.
Without Chromium it says so and ends with exit code 0. No host is asked for anything: axe-core comes with the package
axe-playwright-python.
"""

from __future__ import annotations

import shutil
import sys
from collections.abc import Iterable, Iterator, Mapping
from importlib.resources import files
from pathlib import Path
from typing import Any
from urllib.parse import quote

from queries import QUERIES
from search_words import WORDS

#: One page of each kind.
PAGES = (
    "index", "install", "gallery", "applications/gripper-pad", "applications/first-day", "theory", "tutorial",
    "notebooks/first_steps", "verification", "design-file", "studio",
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


def first_found(page: Any, search: str, query: str) -> str:
    """Name of the page that the site's search lists first; empty where it finds none.

    Args:
        page: of Playwright's synchronous API.
        search: address of the page of the search.
        query: words to look for.
    """
    page.goto(f"{search}?q={quote(query)}")
    page.wait_for_function("document.querySelector('.search-summary')?.textContent.trim()", timeout=60_000)
    found = page.evaluate("document.querySelector('ul.search li a')?.getAttribute('href') ?? ''")
    return str(found).partition("#")[0].partition("?")[0].removesuffix(".html")


def sought() -> dict[str, tuple[str, ...]]:
    """All that the search must find, by the page that must come first."""
    return {page: (*WORDS.get(page, ()), *QUERIES.get(page, ())) for page in {**WORDS, **QUERIES}}


def main(folder: Path, pages: tuple[str, ...] = PAGES, words: Mapping[str, Iterable[str]] | None = None) -> int:
    """Exit code: 1 with a line for each fault."""
    program = shutil.which("chromium") or shutil.which("chromium-browser")
    if program is None:
        print("The site was not looked at in a browser: there is no chromium (Debian: apt install chromium)")
        return 0
    from playwright.sync_api import sync_playwright

    faults, asked = [], sought() if words is None else words
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        for width, colours in WINDOWS:
            context = browser.new_context(viewport={"width": width, "height": 900}, color_scheme=colours)
            page = context.new_page()
            for name in pages:
                address = (folder / f"{name}.html").resolve().as_uri()
                faults += [f"{name}, {width} px, {colours}: {fault}" for fault in faults_of(page, address)]
            context.close()
        page = browser.new_page()
        search = (folder / "search.html").resolve().as_uri()
        for wanted, query in ((name, query) for name, queries in asked.items() for query in queries):
            if (found := first_found(page, search, query)) != wanted:
                faults.append(f"search for {query!r}: finds {found or 'nothing'} first, must find {wanted}")
        browser.close()
    for line in faults:
        print(line, file=sys.stderr)
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))

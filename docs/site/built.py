"""What the built site must be: it asks no other host for anything, and its search finds what people look for."""

from __future__ import annotations

import json
import re
import sys
from html.parser import HTMLParser
from pathlib import Path

#: Words that must be found, one of each kind of page.
SOUGHT = ("port_admittance", "mold", "calibrate", "altitude")
#: Attributes that a browser loads by itself.
LOADED = {("script", "src"), ("img", "src"), ("link", "href"), ("iframe", "src"), ("source", "src"), ("use", "href")}
OUTSIDE = re.compile(r"^(?:https?:)?//")
IN_STYLE = re.compile(r"url\(\s*[\"']?((?:https?:)?//[^)\"']+)|@import\s+[\"']((?:https?:)?//[^\"']+)")


class Loads(HTMLParser):
    """Addresses that a page loads when it is opened."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Collect what a tag loads; a link that is followed by hand is none."""
        values = dict(attrs)
        if tag == "link" and values.get("rel") in ("search", "index", "next", "prev", "canonical"):
            return
        self.found += [str(value) for name, value in attrs if (tag, name) in LOADED and value]


def outside_requests(folder: Path) -> list[str]:
    """File and address of everything that the pages and styles of a folder would ask of another host."""
    found = []
    for page in sorted(folder.rglob("*.html")):
        loads = Loads()
        text = page.read_text(encoding="utf-8")
        loads.feed(text)
        found += [f"{page.name}: {address}" for address in loads.found if OUTSIDE.match(address)]
    for style in sorted(folder.rglob("*.css")):
        found += [f"{style.name}: {hit[0] or hit[1]}" for hit in IN_STYLE.findall(style.read_text(encoding="utf-8"))]
    return found


def not_found(folder: Path) -> list[str]:
    """Words that people look for and the search does not know."""
    text = (folder / "searchindex.js").read_text(encoding="utf-8")
    index = json.loads(text.removeprefix("Search.setIndex(").rstrip().removesuffix(")"))
    terms = {*index["terms"], *index["titleterms"]}
    names = {entry[4] for entries in index["objects"].values() for entry in entries}
    known = terms | names
    # the index holds stems: "calibr" is found by "calibrate"
    return [word for word in SOUGHT if not any(len(term) > 3 and word.startswith(term) for term in known)]


def main(folder: Path) -> int:
    """Exit code: 1 with a line for each fault."""
    faults = [f"asks another host: {line}" for line in outside_requests(folder)]
    faults += [f"the search does not find {word}" for word in not_found(folder)]
    for line in faults:
        print(line, file=sys.stderr)
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))

"""What the built site must be: it asks no other host for anything, its search finds what people look for, and its
signatures are as the source has them.
"""

from __future__ import annotations

import json
import re
import sys
from html.parser import HTMLParser
from pathlib import Path

from sphinx.search.en import SearchEnglish

#: Words that must be found, one of each kind of page.
SOUGHT = ("port_admittance", "mold", "calibrate", "altitude")
#: Attributes that a browser loads by itself.
LOADED = {("script", "src"), ("img", "src"), ("link", "href"), ("iframe", "src"), ("source", "src"), ("use", "href")}
OUTSIDE = re.compile(r"^(?:https?:)?//")
#: pydantic's marks of a field, NumPy's types as evaluated, an object's address.
MACHINERY = re.compile(r"Annotated|FieldInfo|PydanticGeneral|\b(?:Le|Ge|Lt|Gt|MinLen|MaxLen)\(|numpy\.dtype| at 0x")
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
    """Words that people look for and the search does not know: neither their stem nor an entry of that name."""
    text = (folder / "searchindex.js").read_text(encoding="utf-8")
    index = json.loads(text.removeprefix("Search.setIndex(").rstrip().removesuffix(")"))
    names = {entry[4] for entries in index["objects"].values() for entry in entries}
    known = names | {*index["terms"], *index["titleterms"]}
    stem = SearchEnglish({}).stem  # what the page of the search does with a word that is typed
    return [word for word in SOUGHT if word not in names and stem(word) not in known]


class Signatures(HTMLParser):
    """The words of a page's signatures, where each begins and what it says."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[str] = []
        self._inside = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Begin one."""
        if tag == "dt" and "sig" in (dict(attrs).get("class") or "").split():
            self._inside = True
            self.found.append("")

    def handle_endtag(self, tag: str) -> None:
        """End one."""
        self._inside = self._inside and tag != "dt"

    def handle_data(self, data: str) -> None:
        """Words of it."""
        if self._inside:
            self.found[-1] += data


def machinery(folder: Path) -> list[str]:
    """File and signature of every entry that shows what a library made of the source instead of the source."""
    found = []
    for page in sorted(folder.rglob("*.html")):
        signatures = Signatures()
        signatures.feed(page.read_text(encoding="utf-8"))
        for words in signatures.found:
            if MACHINERY.search(words):
                found.append(f"{page.name}: {' '.join(words.split())[:80]}")
    return found


def main(folder: Path) -> int:
    """Exit code: 1 with a line for each fault."""
    faults = [f"asks another host: {line}" for line in outside_requests(folder)]
    faults += [f"the search does not find {word}" for word in not_found(folder)]
    faults += [f"not as a person would write it: {line}" for line in machinery(folder)]
    for line in faults:
        print(line, file=sys.stderr)
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))

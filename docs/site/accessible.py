"""What Sphinx and its theme leave to readers of screens and keyboards, put right in the pages as they are written.

Sections of the navigation open and close: that of the page is open, elsewhere the first. Blocks of code and tables can
be reached and scrolled by the keyboard, arguments of a long signature are no list of definitions without terms, the two
asides have names.
"""

from __future__ import annotations

import re
from functools import partial
from pathlib import Path

from sphinx.application import Sphinx

_ARGUMENTS = re.compile(r"<dl>\n((?:<dd>.*</dd>\n)+)</dl>")
_SECTION = re.compile(
    r'<p class="caption" role="heading">(.*?)</p>\n(.*?\n</ul>)(?=\n*(?:<p class="caption"|</div>))', re.DOTALL
)
#: The section that is open on a page in none of them.
_FIRST = ">Start<"
_CHANGES = (
    (re.compile(r"<pre(?! tabindex)"), '<pre tabindex="0"'),
    (re.compile(r'<table class="docutils'), '<table tabindex="0" class="docutils'),
    (re.compile(r'<aside class="sidebar-drawer">'), '<aside class="sidebar-drawer" aria-label="All pages">'),
    (re.compile(r'<aside class="toc-drawer'), '<aside aria-label="On this page" class="toc-drawer'),
)


def accessible(text: str) -> str:
    """A page's HTML put right; one that was put right before stays as it is."""
    for pattern, instead in _CHANGES:
        text = pattern.sub(instead, text)
    here = "current-page" if "current-page" in text else _FIRST
    text = _SECTION.sub(partial(_closable, here=here), text)
    return _ARGUMENTS.sub(_blocks, text)


def _blocks(found: re.Match[str]) -> str:
    items = found[1].replace("<dd>", '<span class="argument">').replace("</dd>", "</span>")
    return f'<span class="arguments">\n{items}</span>'


def _closable(found: re.Match[str], here: str) -> str:
    """A section of the navigation, open where it has the words ``here``."""
    is_open = " open" if here in found[0] else ""
    return f'<details{is_open}><summary class="caption">{found[1]}</summary>\n{found[2]}</details>'


def setup(app: Sphinx) -> dict[str, bool]:
    """Go over the pages when all are written."""
    app.connect("build-finished", _finished)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _finished(app: Sphinx, error: Exception | None) -> None:
    if error is None and app.builder.format == "html":
        for page in Path(app.outdir).rglob("*.html"):
            text = page.read_text(encoding="utf-8")
            if (better := accessible(text)) != text:
                page.write_text(better, encoding="utf-8")

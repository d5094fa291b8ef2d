"""Styles and scripts of the pages of HTML; they are built from studies/studio/page."""

from __future__ import annotations

from functools import cache
from importlib import resources

import geometry


@cache
def page_parts(name: str = "page") -> tuple[str, str]:
    """Style sheet and script of a kind of page, to be written into it.

    The script of reports folds tables on narrow screens, opens all sections for a printer and draws figures that a page
    has as data; without it a page shows everything all the same.

    Args:
        name: of both files: ``page`` for reports, ``array-page`` for the page of an array.
    """
    folder = resources.files(geometry) / "templates"
    style, script = ((folder / f"{name}.{suffix}").read_text(encoding="utf-8") for suffix in ("css", "js"))
    return style, script.replace("</script", "<\\/script")

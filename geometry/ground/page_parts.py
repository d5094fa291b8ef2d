"""Style and script that all pages of HTML share; they are built from studies/studio/page."""

from __future__ import annotations

from functools import lru_cache
from importlib import resources

import geometry


@lru_cache(maxsize=1)
def page_parts() -> tuple[str, str]:
    """Style sheet and script of every report, to be written into its page.

    The script folds tables on narrow screens, opens all sections for a printer and draws figures that a page has as
    data; without it a page shows everything all the same.
    """
    folder = resources.files(geometry) / "templates"
    style, script = ((folder / name).read_text(encoding="utf-8") for name in ("page.css", "page.js"))
    return style, script.replace("</script", "<\\/script")

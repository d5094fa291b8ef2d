"""The page that shows a design without a studio: the studio's own page, with all that it was sent, in one file."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Callable
from dataclasses import replace
from html import escape
from importlib import resources
from pathlib import Path
from typing import Any

import studies.studio as here
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import write_design
from geometry.ground.extras import installed_version
from geometry.ground.refusal import Refusal
from geometry.ground.stated_times import stated_time
from studies.panels.curves import CURVES
from studies.panels.form import sizes_sold
from studies.panels.form_hints import fields_without_effect, values_in_use
from studies.studio.messages import packed, written
from studies.studio.page_words import SHARED, form_words, page_words
from studies.studio.stage import Job
from studies.studio.workplace import Workplace

#: Panels of the page in the order in which they are computed, each with what it is for people.
_STAGES = {
    "points": "figures of the points",
    "as_built": "as-built sensors",
    "verdict": "verdict",
    "model": "array in 3-D",
    "check": "print findings",
}
#: What a page without a studio may load: nothing but what it holds itself.
_POLICY = (
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:; "
    "connect-src data: blob:"
)


async def shared_page(workplace: Workplace, job: Job, notify: Callable[[str], None]) -> Path:
    """Page of a design as one file that any browser opens without a network; nothing can be changed in it.

    Args:
        workplace: where the panels are computed, unless it has them already.
        job: its design is shown.
        notify: called with what is computed.

    Returns:
        Path of the page, which the caller removes.

    Raises:
        Refusal: the design cannot be solved. A single panel that cannot be computed says why on the page.
    """
    notify("curves")
    curves = {}
    messages = [{"type": "words", **page_words(), "new": False}, _design_message(job.design)]
    for name in CURVES:
        drawn, known = await workplace.curves(job.design, name)
        message = packed(replace(job, stage="curves", revision=0), drawn, known.words)
        curves[name] = b64encode(message).decode("ascii")
    messages.append({"type": "validity", "reason": known.reason, "solves": False})
    for stage, words in _STAGES.items():
        notify(words)
        messages.append(await _panel(workplace, replace(job, stage=stage, revision=0), notify))
    about = {"made": stated_time().strftime("%Y-%m-%d"), "version": installed_version("acoustic-fem")}
    held = {"about": about, "toml": write_design(job.design), "messages": messages, "curves": curves}
    return await workplace.written(SHARED, page_of(job.design.name, held))


def page_of(name: str, held: dict[str, Any]) -> str:
    """The studio's page with its style, its script and what it shows, in one file.

    Args:
        name: of the design, the title of the page.
        held: ``about``, ``toml``, ``messages`` and ``curves``, as the page's script reads them.
    """
    text, style, script = (
        (resources.files(here) / "static" / file).read_text(encoding="utf-8")
        for file in ("index.html", "studio.css", "studio.js")
    )
    # Nothing in them ends an element too early; JSON and JavaScript read the escaped signs as the plain ones.
    data = written(held).replace("<", "\\u003c")
    charset = '<meta charset="utf-8">'
    script = script.replace("</script", "<\\/script")
    for old, new in (
        ('<html lang="en">', '<html lang="en" data-shared>'),
        (charset, f'{charset}\n<meta http-equiv="Content-Security-Policy" content="{_POLICY}">'),
        ("<title>acoustic-fem studio</title>", f"<title>{escape(name)}</title>"),
        ('<link rel="stylesheet" href="/studio.css">', f"<style>{style}</style>"),
        ('<script src="/studio.js" defer></script>\n', ""),
        ("</body>", f'<script type="application/json" id="shared">{data}</script>\n<script>{script}</script>\n</body>'),
    ):
        if text.count(old) != 1:
            raise RuntimeError(f"the page of the studio has {old!r} {text.count(old)} times")
        text = text.replace(old, new)
    return text


def _design_message(design: ArrayDesign) -> dict[str, Any]:
    hints = {"without_effect": fields_without_effect(design), "in_use": values_in_use(design)}
    state = {"session": None, "revision": 0, "undo": False, "redo": False, "unsaved": False}
    return {"type": "design", **state, **form_words(design), "hints": hints, "sizes": sizes_sold(design)}


async def _panel(workplace: Workplace, job: Job, notify: Callable[[str], None]) -> dict[str, Any]:
    """Message with a panel's figures, or with the reason why there are none."""
    try:
        found = await workplace.result(job, notify)
    except Refusal as error:
        return {"type": "failed", "stage": job.stage, "revision": 0, "message": str(error)}
    shown = {name: value for name, value in found.items() if name != "glb"}
    if job.stage == "model":
        shown["file"] = f"data:model/gltf-binary;base64,{b64encode(found['glb']).decode('ascii')}"
    return {"type": "figures", "stage": job.stage, "revision": 0, "found": shown}

"""Texts that every report shares: its page, percentages, and the rows of a table of provenance."""

from __future__ import annotations

import base64
import io
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from geometry.ground.page_parts import page_parts
from geometry.ground.refusal import counted
from studies.output.display import number

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def rendered_page(template: str, **values: Any) -> str:
    """Page of HTML from a template of the package, in the style of all reports.

    Args:
        template: name of the template, which can use the filters ``number`` and ``counted``.
        values: values by the names that the template uses; each of these needs one.
    """
    import jinja2

    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("studies"),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters |= {"number": number, "counted": counted}
    style, script = page_parts()
    page = environment.get_template(template).render(style=style, **values)
    before, _, after = page.rpartition("</body>")
    return f"{before}<script>{script}</script>\n</body>{after}"


def inlined_picture(path: Path) -> str:
    """Address that holds a PNG picture itself, for an image of a page."""
    return "data:image/png;base64," + base64.b64encode(path.read_bytes()).decode("ascii")


def inlined_drawing(figure: Figure) -> str:
    """Figure as an SVG element for a page, with the page's own colours of text and grid in each of its schemes."""
    import matplotlib as mpl

    out = io.StringIO()
    with mpl.rc_context({"svg.fonttype": "none", "svg.hashsalt": "acoustic-fem", "font.family": "sans-serif"}):
        figure.savefig(out, format="svg", transparent=True, metadata={"Date": None, "Creator": None})
    text = out.getvalue()
    for colour, own in (("#000000", "currentColor"), ("#dddddd", "var(--grid)"), ("black", "currentColor")):
        text = text.replace(f": {colour}", f": {own}")
    return re.sub(r"(?s)<metadata>.*?</metadata>", "", text[text.index("<svg") :])


def percent(fraction: float) -> str:
    """Percentage with one decimal; only a fraction of exactly 1 is shown as 100 %."""
    return "100 %" if fraction == 1 else f"{100 * min(fraction, 0.9995):.1f} %"


def with_worst(accuracy: float, worst: float | None) -> str:
    """Percentage of an accuracy and, if it is a mean over several sensors, that of the worst one."""
    return percent(accuracy) + ("" if worst is None else f" (worst {percent(worst)})")


def record_rows(name: str, value: object) -> Iterator[tuple[str, str]]:
    """Rows of a nested record, each a dotted name with its value."""
    if isinstance(value, Mapping):
        for key, part in value.items():
            yield from record_rows(f"{name}.{key}", part)
    elif isinstance(value, (list, tuple)):
        yield name, ", ".join(map(str, value))
    else:
        yield name, "" if value is None else str(value)

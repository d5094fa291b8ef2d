"""Objects that show themselves: a title and a few facts, as text in a session and as a table in a notebook."""

from __future__ import annotations

import html
from collections.abc import Mapping

#: Most lines of a text, its title included, and most characters of a line and of a fact.
MOST_LINES, LONGEST_LINE, _LONGEST = 12, 100, 90


class Shown:
    """Base of objects that show themselves. A data class that has it is declared with ``repr=False``."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title, and facts by name, of which the first eleven are shown."""
        raise NotImplementedError

    def __repr__(self) -> str:
        title, facts = self.shown()
        lines = (f"  {_short(f'{name}: {value}', LONGEST_LINE - 2)}" for name, value in _listed(facts))
        return "\n".join([_short(title), *lines])

    def __str__(self) -> str:
        return repr(self)

    def _repr_html_(self) -> str:
        """The same as a table, for notebooks."""
        title, facts = self.shown()
        rows = "".join(
            f"<tr><th style='text-align:left'>{html.escape(name)}</th>"
            f"<td style='text-align:left'>{html.escape(value)}</td></tr>"
            for name, value in _listed(facts)
        )
        return f"<div><b>{html.escape(_short(title))}</b><table>{rows}</table></div>"


def _listed(facts: Mapping[str, object]) -> list[tuple[str, str]]:
    """Facts as texts of one line, those that are empty left out."""
    texts = [(name, _short(str(value))) for name, value in facts.items() if value not in (None, "", ())]
    return texts[: MOST_LINES - 1]


def _short(text: str, longest: int = _LONGEST) -> str:
    text = " ".join(text.split())
    return text if len(text) <= longest else f"{text[: longest - 3]}..."

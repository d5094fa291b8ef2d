"""The sessions of a studio: each page has its own, and finds it again after its link was cut."""

from __future__ import annotations

from typing import Any

from geometry.design.array_design import ArrayDesign
from studies.studio.session import Session
from studies.studio.workplace import Workplace

#: Sessions that are kept; beyond, the one left longest ago goes first.
MOST_SESSIONS = 32


class Sessions:
    """All sessions by their secret names.

    Args:
        design: that a new session begins with.
        workplace: where they have their jobs done.
    """

    def __init__(self, design: ArrayDesign, workplace: Workplace) -> None:
        self._design, self._workplace = design, workplace
        self._known: dict[str, Session] = {}

    def __len__(self) -> int:
        return len(self._known)

    def find(self, name: Any) -> Session | None:
        """The session of a name; None where there is none."""
        return self._known.get(name) if isinstance(name, str) else None

    def enter(self, name: Any, page: Any = None) -> tuple[Session, bool]:
        """The session of a page, and whether it is a new one.

        Args:
            name: that the page knows from before. A page that was doubled gets a session of its own, as the name is
                in use.
            page: name that the page gave itself when it was opened: one whose link is cut takes up its session again
                even where nobody here has noticed yet.
        """
        found = self.find(name)
        if found is not None and (not found.is_open or (isinstance(page, str) and page == found.page)):
            found.page = page
            return found, False
        session = Session(self._design if found is None else found.state.design, self._workplace)
        session.page = page
        self._known[session.id] = session
        for old in sorted((each for each in self._known.values() if not each.is_open), key=lambda each: each.left):
            if len(self._known) > MOST_SESSIONS and old is not session:
                self._known.pop(old.id).end()
        return session, True

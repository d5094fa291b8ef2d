"""Drags of parts in the picture of an array, and sizes that are typed on its dimension lines."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from geometry.design.array_design import ArrayDesign
from geometry.design.field_values import declared_at
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from geometry.layout.arrangement import place_housings
from studies.panels.designing import DesignState, Dragged
from studies.panels.dragged_places import parts_in_space
from studies.panels.dragging import dragged, resized, size_of
from studies.studio.messages import MessageError, is_number, numbers_of, text_of
from studies.studio.stage import Post

#: Fields named beside a drag; a row of places has two for each point.
_MOST_NAMED = 2


class Drags:
    """Drags of one session: every message of a drag counts from the design at its beginning.

    Args:
        state: design that is changed.
        post: sends a message to the page.
    """

    def __init__(self, state: DesignState, post: Post) -> None:
        self._state, self._post = state, post
        self._gesture = ""
        self._start = self._last = state.design

    async def drag(self, message: Mapping[str, Any]) -> None:
        """Move a part; the page is sent where all parts then are, and why they are not where it asked for.

        Raises:
            MessageError: it is not a message of a page of ours.
        """
        part, gesture = text_of(message, "part"), text_of(message, "gesture")
        by, at = (np.array(numbers_of(message, key, 3)) for key in ("by", "at"))
        if gesture != self._gesture or self._state.design is not self._last:
            self._gesture, self._start = gesture, self._state.design
        try:
            found = dragged(self._start, part, by, at, message.get("row") is True)
        except MessageError:
            raise
        except Refusal as error:
            found = Dragged(self._start, refused=str(error))
        self._state.replace(found.design, gesture)
        self._last = self._state.design
        shift = _shift(self._start, found)
        about = {"gesture": gesture, "revision": self._state.revision, "shift": shift.tolist()}
        said = {"words": words_of(found), "refused": found.refused}
        await self._post({"type": "moved", **about, **said, **parts_in_space(found.design, shift)})

    async def resize(self, message: Mapping[str, Any]) -> bool:
        """Change a size; True if it was changed. The page is sent why a size is not allowed, and the nearest one.

        Raises:
            MessageError: it is not a message of a page of ours.
        """
        size, value = text_of(message, "size"), message.get("value")
        nearest = None
        try:
            if not is_number(value):
                raise Refusal(kind=Kind.WRONG_TYPE, field=size, value=value, allowed="a length in mm")
            found = resized(self._state.design, size, float(value))
            if not found.refused:
                self._state.replace(found.design)
                return True
            refused, nearest = found.refused, size_of(found.design, size)
        except MessageError:
            raise
        except Refusal as error:
            refused = str(error)
        await self._post({"type": "refused-size", "size": size, "message": refused, "nearest": nearest})
        return False


def _shift(start: ArrayDesign, found: Dragged) -> Array:
    """Way by which the picture is moved so that the point that holds still does, (3,) float64, mm."""
    if found.anchor is None:
        return np.zeros(3)
    before, after = (place_housings(each) for each in (start, found.design))
    places = [np.array(each.frame(each.points[found.anchor]).origin) for each in (before, after)]
    return np.asarray(places[0] - places[1])


def words_of(found: Dragged) -> str:
    """Fields that follow a drag, with their values and units."""
    named = []
    for name, value in [*found.values.items()][:_MOST_NAMED]:
        unit = declared_at(name).unit
        named.append(f"{name} = {value}" if isinstance(value, str) else f"{name} = {value:g} {unit}".rstrip())
    return ", ".join(named)

"""A design while it is changed: undo and redo, what is not saved, and refusals with the value that would fix them."""

from __future__ import annotations

import hashlib
import math
from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from geometry.design.array_design import ArrayDesign, validated
from geometry.design.design_file import value_of
from geometry.ground.refusal import Refusal
from geometry.schema.declared_fields import field_named

#: Steps that can be taken back.
MOST_STEPS = 500
#: Halvings of the way from the value that is to the one that was refused.
_HALVINGS = 40
#: Significant digits of a value that is offered.
_DIGITS = 4


@dataclass(frozen=True)
class Refused:
    """Refusal of a changed value."""

    name: str
    """Dotted name of the field that was changed."""
    message: str
    """Line that names field, value and the allowed range."""
    allowed: str
    """Range of the field alone in words, with the unit; empty where anything of its kind goes."""
    mend: float | int | None
    """Value nearest to the refused one, in its unit, with which the design is valid; None where none is known."""


@dataclass(frozen=True)
class Dragged:
    """Design after a part of it was dragged."""

    design: ArrayDesign
    """Valid design nearest to what was asked for."""
    values: Mapping[str, Any] = field(default_factory=dict)
    """Fields that were changed, by dotted name."""
    refused: str = ""
    """Reason why it is not exactly what was asked for; empty where it is."""
    anchor: int | None = None
    """Index of the point that stays in place; None where the layout's own places say it."""


class DesignState:
    """State of a design that is being changed.

    Args:
        design: to begin with; it counts as saved.
    """

    def __init__(self, design: ArrayDesign) -> None:
        self.design = design
        #: Number of the design: another one after each change.
        self.revision = 0
        self._saved = design
        self._undo: deque[ArrayDesign] = deque(maxlen=MOST_STEPS)
        self._redo: list[ArrayDesign] = []
        self._gesture: object = None

    @property
    def unsaved(self) -> bool:
        """True if the design differs from the one that was opened or saved last."""
        return self.design is not self._saved and self.design != self._saved

    @property
    def can_undo(self) -> bool:
        """True if there is a step to take back."""
        return bool(self._undo)

    @property
    def can_redo(self) -> bool:
        """True if there is a step to take again."""
        return bool(self._redo)

    def set_values(self, values: Mapping[str, Any], gesture: object = None) -> None:
        """Change fields by dotted name; all changes of one gesture are one step.

        Args:
            values: as :meth:`geometry.ArrayDesign.with_values` takes them.
            gesture: of a slider that is being dragged; None is a step of its own.

        Raises:
            DesignError: no such field, or the changed design is not valid; nothing is changed then.
        """
        self.replace(self.design.with_values(values), gesture)

    def replace(self, design: ArrayDesign, gesture: object = None) -> None:
        """Put a design in place, as a step that can be taken back where it is another one."""
        if design == self.design and design.followers == self.design.followers:
            return
        if gesture is None or gesture != self._gesture:
            self._undo.append(self.design)
        self._gesture = gesture
        self._redo.clear()
        self._become(design)

    def open(self, design: ArrayDesign, saved: bool = True) -> None:
        """Put a design from a file in place; it counts as saved unless ``saved`` is false."""
        self.replace(design)
        if saved:
            self._saved = design

    def undo(self) -> None:
        """Take one step back, if there is one."""
        if self._undo:
            self._redo.append(self.design)
            self._become(self._undo.pop())
        self._gesture = None

    def redo(self) -> None:
        """Take one step again, if there is one."""
        if self._redo:
            self._undo.append(self.design)
            self._become(self._redo.pop())
        self._gesture = None

    def mark_saved(self) -> None:
        """Post that the design is in a file now."""
        self._saved = self.design

    def restore(self, values: Mapping[str, Any], source: str) -> None:
        """Take up the design that a page kept, in place of the one of the beginning.

        Args:
            values: of :func:`studies.panels.stated_values`.
            source: where they come from, for messages.

        Raises:
            DesignError: they are not a valid design.
        """
        self.open(validated(values, source), saved=False)

    def _become(self, design: ArrayDesign) -> None:
        self.design = design
        self.revision += 1


def refusal_of(design: ArrayDesign, name: str, value: Any, error: Refusal) -> Refused:
    """The message at a field whose value is not allowed.

    Args:
        design: the valid design, as it still is.
        name: dotted name of the field that was to be changed.
        value: the value that was refused.
        error: the refusal.
    """
    declared = field_named(ArrayDesign, name)
    allowed = declared.allowed if declared is not None else ""
    return Refused(name, str(error), allowed, nearest_valid(design, name, value))


def nearest_valid(design: ArrayDesign, name: str, refused: Any) -> float | int | None:
    """The valid value nearest to a refused one, on the way to it from the value that the design has.

    Args:
        design: the valid design.
        name: dotted name of the field.
        refused: value that is not valid.

    Returns:
        None where no other value than the design's own is known to be valid.
    """
    try:
        now = value_of(design, name)
    except Refusal:
        return None
    if not _is_number(now) or not _is_number(refused):
        return None
    whole = isinstance(now, int)
    declared = field_named(ArrayDesign, name)
    if declared is not None:  # the end of the field's own range
        end = min(max(refused, declared.range[0]), declared.range[1])
        if end != refused and _is_valid(design, name, int(end) if whole else end):
            return int(end) if whole else end
    good, bad = float(now), float(refused)
    for _ in range(_HALVINGS):
        middle = (good + bad) / 2
        if whole:
            middle = math.trunc(middle) if bad > good else math.ceil(middle)
        if middle in (good, bad) or abs(bad - good) < 10.0 ** (1 - _DIGITS) * abs(bad):
            break
        good, bad = (middle, bad) if _is_valid(design, name, int(middle) if whole else middle) else (good, middle)
    found = int(good) if whole else _towards(good, bad > good)
    return None if found == now or not _is_valid(design, name, found) else found


def _towards(value: float, downwards: bool) -> float:
    """A value with few digits, rounded to the side that is allowed."""
    if value == 0:
        return value
    step = 10.0 ** (math.floor(math.log10(abs(value))) - _DIGITS + 2)
    steps = math.floor(value / step + 1e-9) if downwards else math.ceil(value / step - 1e-9)
    return float(f"{steps * step:.12g}")


def _is_valid(design: ArrayDesign, name: str, value: float) -> bool:
    try:
        design.with_values({name: value})
    except Refusal:
        return False
    return True


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def design_key(design: ArrayDesign) -> str:
    """A text that two designs share where everything that they state is the same."""
    return hashlib.sha256(design.model_dump_json().encode()).hexdigest()

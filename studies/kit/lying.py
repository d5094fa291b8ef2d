"""Words that say how a printed part lies on its plate, for people without a CAD program."""

from __future__ import annotations

from collections.abc import Mapping

from geometry.assembly.part_list import PartKind
from geometry.printing.pose import Pose

#: Sides that look up if a part lies as drawn, and those that look up if it lies upside down.
_SIDES: Mapping[PartKind, tuple[str, str]] = {
    "shell": ("open cavity up", "open cavity down"),
    "carrier": ("open cavities up", "open cavities down"),
    "housing": ("seat of the board up", "seat of the board down"),
    "base": ("seats up", "seats down"),
    "mold-base": ("cavities up", "cavities down"),
    "mold-lid": ("face that lies on the lands down", "face that lies on the lands up"),
    "mold-shim": ("either face up", "either face up"),
    "mold-scraper": ("edge down", "edge up"),
    "mold-plugs": ("plugs up", "plugs down"),
}


def lying_words(kind: PartKind, pose: Pose) -> str:
    """How a part lies on its plate."""
    turned = f", turned by {pose.turn:g} degrees" if pose.turn else ""
    return _SIDES[kind][pose.upside_down] + turned

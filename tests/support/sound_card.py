"""A studio on a machine with a sound card that hears a recording: for tests of what a page shows of it."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

from studies.panels.live_panel import listen_live


def cards() -> list[dict[str, Any]]:
    """The one sound card."""
    return [{"number": 0, "name": "a recording", "channels": 2, "default": True}]


def hear(design: Any, device: int | None, full_scale: float, replay: None, tell: Callable[[str], None]) -> Any:
    """What the card hears, in real time."""
    return listen_live(design, None, full_scale, os.environ["STUDIO_TAPS"], tell)


def main() -> None:
    """The command line, with the card."""
    from studies.cli.app import main as command_line
    from studies.studio import workplace

    workplace.listen_live, workplace.sound_cards = hear, cards
    command_line()

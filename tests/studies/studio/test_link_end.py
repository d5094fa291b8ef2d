"""A link that closed while something was sent ends, because reading it again would hold up the studio."""

from __future__ import annotations

import asyncio
from types import SimpleNamespace
from typing import Any

import pytest
from starlette.websockets import WebSocketState

from studies.studio.server import _hold


class ClosedWhileSent:
    """A websocket whose first message comes, and which is closed by then."""

    headers: Any = None
    application_state = WebSocketState.CONNECTED
    reads = 0

    async def accept(self) -> None:
        """Take the link."""

    async def receive_text(self) -> str:
        """The first message; afterwards what Starlette raises of a link that it has closed itself."""
        self.reads += 1
        if self.reads == 1:
            return '{"do": "ping"}'
        if self.reads > 3:
            pytest.fail("read again and again")
        self.application_state = WebSocketState.DISCONNECTED
        raise RuntimeError("WebSocket is not connected")

    async def send_text(self, text: str) -> None:
        """Nothing."""


def test_a_link_that_closed_while_something_was_sent_is_read_no_more() -> None:
    link, guard = ClosedWhileSent(), SimpleNamespace(is_page=lambda headers, secret: True)
    asyncio.run(_hold(link, SimpleNamespace(), guard, []))  # type: ignore[arg-type]
    assert link.reads == 2

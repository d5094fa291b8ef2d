"""Connections to the studio: those that bring no request are few and short, and other users of the machine get none."""

from __future__ import annotations

import asyncio
import os
import socket
import struct
from contextlib import suppress
from pathlib import Path
from typing import Any

from uvicorn.protocols.http.h11_impl import H11Protocol

#: Seconds within which the head of a request must be complete, from when it may begin.
HEAD_WITHIN = 5.0
#: Connections that may wait for a request; beyond, the one that has waited longest is closed.
MOST_WAITING = 48
#: Tables of the connections of this machine (Linux), by the family of their addresses.
_TABLES = {socket.AF_INET: Path("/proc/net/tcp"), socket.AF_INET6: Path("/proc/net/tcp6")}


def bounded_protocol() -> type[H11Protocol]:
    """A class of connections for one server, which share the bound on those that wait for a request."""
    waiting: dict[BoundedProtocol, asyncio.TimerHandle] = {}

    class Bounded(BoundedProtocol):
        _waiting = waiting

    return Bounded


class BoundedProtocol(H11Protocol):
    """Connection that is closed if no request comes, or not all of its head, or if it comes from another user."""

    _waiting: dict[BoundedProtocol, asyncio.TimerHandle]

    def connection_made(self, transport: Any) -> None:
        """Take a connection, and close the one that has waited longest where too many wait."""
        super().connection_made(transport)
        if not is_own_user(transport):
            text = "this studio belongs to another user of the machine\n"
            head = "HTTP/1.1 403 Forbidden\r\nContent-Type: text/plain\r\nConnection: close\r\n"
            transport.write(f"{head}Content-Length: {len(text)}\r\n\r\n{text}".encode())
            transport.close()
            return
        self._wait()
        if len(self._waiting) > MOST_WAITING:
            next(iter(self._waiting))._give_up()

    def connection_lost(self, exc: Exception | None) -> None:
        """Wait no more."""
        self._wait_no_more()
        super().connection_lost(exc)

    def handle_events(self) -> None:
        """Wait no more once a request is there: what it takes is up to whoever answers it."""
        super().handle_events()
        if self.cycle is not None and not self.cycle.response_complete:
            self._wait_no_more()

    def handle_websocket_upgrade(self, event: Any) -> None:
        """Hand the connection on."""
        self._wait_no_more()
        super().handle_websocket_upgrade(event)

    def on_response_complete(self) -> None:
        """Wait for the next request. Bytes that come one by one do not prolong that."""
        super().on_response_complete()
        if not self.transport.is_closing() and (self.cycle is None or self.cycle.response_complete):
            self._wait()

    def _wait(self) -> None:
        self._wait_no_more()
        self._waiting[self] = self.loop.call_later(HEAD_WITHIN, self._give_up)

    def _wait_no_more(self) -> None:
        timer = self._waiting.pop(self, None)
        if timer is not None:
            timer.cancel()

    def _give_up(self) -> None:
        self._wait_no_more()
        self.transport.abort()


def is_own_user(transport: Any) -> bool:
    """True unless a connection is known to come from another user of this machine, other than its administrator."""
    peer, own = transport.get_extra_info("peername"), transport.get_extra_info("sockname")
    user = None if not peer or not own else user_of(peer[:2], own[:2])
    allowed = {0, os.getuid(), int(os.environ.get("SUDO_UID", "0"))} if hasattr(os, "getuid") else set()
    return user is None or user in allowed


def user_of(client: tuple[str, int], server: tuple[str, int]) -> int | None:
    """User of the program at one end of a connection within this machine; None if the system does not say.

    Args:
        client: address and port of that end.
        server: address and port of the other end.
    """
    family = socket.AF_INET6 if ":" in client[0] else socket.AF_INET
    ends = [_written(family, *client), _written(family, *server)]
    with suppress(OSError), _TABLES[family].open(encoding="ascii") as table:
        for line in table:
            fields = line.split()
            if fields[1:3] == ends and fields[9] != "0":  # 0: no program holds it any more, and the user is unknown
                return int(fields[7])
    return None


def _written(family: socket.AddressFamily, address: str, port: int) -> str:
    """An address and a port as the tables of Linux have them: words in the order of the processor's bytes."""
    packed = socket.inet_pton(family, address.partition("%")[0])
    words = struct.unpack(f"={len(packed) // 4}I", packed)
    return "".join(f"{word:08X}" for word in words) + f":{port:04X}"

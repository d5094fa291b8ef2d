"""A serial port without a board: a pseudo-terminal, at whose other end a thread writes what a board would."""

from __future__ import annotations

import contextlib
import os
import threading
import time
import tty
from collections.abc import Iterable
from pathlib import Path
from typing import Self


class PseudoPort:
    """A port at a path, which is there from the beginning to the end of the context.

    Args:
        path: of the port.
        parts: bytes that are written one after the other; the first one again until somebody reads.
        pace: s between them.
    """

    def __init__(self, path: Path, parts: Iterable[bytes] = (), pace: float = 0.0) -> None:
        self.path, self._parts, self._pace = path, parts, pace
        self._stop = threading.Event()

    def __enter__(self) -> Self:
        self._board, self._host = os.openpty()
        tty.setraw(self._host)
        self.path.symlink_to(os.ttyname(self._host))
        self._thread = threading.Thread(target=self._write, daemon=True)
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.unplug()

    def unplug(self) -> None:
        """Take the board away."""
        self._stop.set()
        if self.path.is_symlink():
            self.path.unlink()
            self._thread.join()
            os.close(self._board)
            os.close(self._host)

    def opened(self) -> None:
        """Wait until somebody has opened the port, and has thrown away what came before."""
        os.set_blocking(self._board, False)
        with contextlib.suppress(BlockingIOError):
            while True:  # fill the line: it empties when the port is opened
                os.write(self._board, bytes(1024))
        while not self._stop.is_set():
            try:
                os.write(self._board, b"\0")
                return
            except BlockingIOError:
                time.sleep(0.002)

    def _write(self) -> None:
        self.opened()
        time.sleep(0.2)  # the line empties as its settings change, and once more at the end of opening
        for part in self._parts:
            while part and not self._stop.is_set():
                try:
                    part = part[os.write(self._board, part) :]
                except BlockingIOError:
                    time.sleep(0.001)
                except OSError:  # nobody is at the other end
                    return
            if self._stop.is_set():
                return
            time.sleep(self._pace)

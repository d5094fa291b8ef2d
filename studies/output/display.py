"""Display for the user: numbers, and while something runs a bar on a terminal, short lines elsewhere."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import perf_counter
from types import TracebackType
from typing import Self, TextIO

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

from geometry.ground.refusal import in_one_line

#: Called with what is being done and the fraction of the stage that is done, 0 to 1.
Report = Callable[[str, float], None]


def number(value: float, digits: int | None = None) -> str:
    """Text of a number as people read it: with a minus sign, no negative zero, and no exponent where it can be avoided.

    Args:
        value: the number, in any unit.
        digits: decimals; without them three significant digits.
    """
    if digits is None:
        text = f"{value:.0f}" if 1000 <= abs(value) < 1e6 else f"{value:.3g}"
    else:
        text = f"{value:.{digits}f}"
    if float(text) == 0:
        text = text.lstrip("-")
    return text.replace("-", "\N{MINUS SIGN}") if text.startswith("-") else text


def duration(seconds: float) -> str:
    """A time in seconds as people say it."""
    if seconds < 100:
        return f"{number(seconds)} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"


class Display:
    """Display of the stages of a job, one after the other.

    Args:
        stream: where to write; None writes nothing.
    """

    def __init__(self, stream: TextIO | None = None) -> None:
        self._stream = stream
        self._bars: Progress | None = None
        #: Seconds of each finished stage.
        self.seconds: dict[str, float] = {}

    def __enter__(self) -> Self:
        if self.terminal:
            self._bars = Progress(
                TextColumn("{task.description:<20}"),
                BarColumn(bar_width=24),
                TimeElapsedColumn(),
                TextColumn("{task.fields[message]}"),
                console=Console(file=self._stream),
            )
            self._bars.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bars is not None:
            self._bars.stop()
            self._bars = None

    @property
    def terminal(self) -> bool:
        """True if progress bars are drawn. Otherwise every message is printed as a line."""
        return self._stream is not None and self._stream.isatty()

    def note(self, text: str) -> None:
        """Print a line that is not overwritten by progress bars."""
        text = in_one_line(text)
        if self._bars is not None:
            self._bars.console.print(text, markup=False, highlight=False)
        elif self._stream is not None:
            print(text, file=self._stream, flush=True)

    @contextmanager
    def stage(self, name: str, of: int = 1) -> Iterator[Report]:
        """Show one stage of a job. Yields a function that you call with its progress.

        Args:
            name: name of the stage.
            of: number of stages of the job. If there are several, each shows its number.
        """
        started = perf_counter()
        title = f"{name} ({len(self.seconds) + 1} of {of})" if of > 1 else name
        with self._shown(title) as report:
            yield report
        self.seconds[name] = perf_counter() - started
        if self._bars is None:
            self.note(f"{title}: {self.seconds[name]:.1f} s")

    @contextmanager
    def _shown(self, name: str) -> Iterator[Report]:
        if self._bars is not None:
            bars = self._bars
            task = bars.add_task(name, total=1.0, message="")
            yield lambda message, fraction: bars.update(task, completed=fraction, message=in_one_line(message))
            bars.update(task, completed=1.0, message="")
            bars.stop_task(task)
            return
        told = {"", "done"}

        def report(message: str, fraction: float) -> None:
            # What goes on side by side reports by turns: every line is told once.
            if message not in told:
                self.note(f"{name}: {message}")
            told.add(message)

        yield report

"""Terminal display of live input: the array, its signals, the latency, faults."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from rich.console import Console, ConsoleOptions, RenderResult
from rich.live import Live
from rich.text import Text

from localize.live.events import Decision, Fault, SeveralTouches, TouchEvent, TrackedGesture, TrackedPlace
from localize.live.listener import Heard, Latencies, Notice
from localize.signals.array_facts import ArrayFacts
from studies.output.display import number

FRAMES = 12
"""Pictures a second."""
LIKELY = 0.1
"""Points that are as probable as this are marked beside the most probable one."""
LINES = 4
"""Number of lines about what went wrong."""
_UNICODE = ("○", "◍", "●", "─", "▁▂▃▄▅▆▇█")
_ASCII = ("o", "x", "#", "-", "_.-~=+*#")


def sparkline(values: NDArray[np.float64], width: int, marks: str = _UNICODE[4]) -> tuple[str, float]:
    """A signal as a row of marks, from minus to plus its peak, and the peak.

    Args:
        values: (n,), n at least 1; each mark shows the value of its part that is farthest from zero.
        width: at most so many marks.
        marks: from the lowest to the highest.
    """
    parts = np.array_split(values, min(width, len(values)))
    shown = np.array([part[np.abs(part).argmax()] for part in parts])
    peak = float(np.abs(shown).max())
    level = np.rint((shown / (peak or 1.0) + 1) / 2 * (len(marks) - 1)).astype(int)
    return "".join(marks[k] for k in level), peak


class LivePicture:
    """The picture, made anew whenever it is drawn; whoever listens only tells what it hears.

    Args:
        source: name of what is listened to.
        array: points' lines and places.
        microphones: names.
        recent: gives (n_microphone, n) Pa, the newest samples.
        latencies: of the decisions so far.
        waveform: whether decisions carry the pressure in the cavity.
    """

    def __init__(
        self,
        source: str,
        array: ArrayFacts,
        recent: Callable[[], NDArray[np.float64]],
        latencies: Latencies,
        waveform: bool = False,
    ) -> None:
        self._source, self._microphones = source, array.microphones
        self._recent, self._latencies = recent, latencies
        self._lines = [
            own[np.argsort(array.place[own], kind="stable")]
            for own in (np.flatnonzero(array.line == line) for line in np.unique(array.line))
        ]
        self._last: Heard | None = None
        self._place: TrackedPlace | None = None
        self._gesture: TrackedGesture | None = None
        self._several: SeveralTouches | None = None
        self._wrong: deque[str] = deque(maxlen=LINES)
        self._faults: Counter[str] = Counter()
        self._waveform: deque[float] | None = deque(maxlen=500) if waveform else None

    def hear(self, heard: Heard) -> None:
        """Take an event."""
        event = heard.event
        if isinstance(event, Fault):
            self._faults[event.kind] += 1
            samples = "" if event.samples is None else f": {event.samples}"
            channel = "" if event.channel is None else f", microphone {event.channel}"
            self._wrong.append(f"{event.time:9.2f} s  {event.kind}{samples}{channel}")
        elif isinstance(event, Notice):
            self._wrong.append(f"{event.time:9.2f} s  {event.kind}: {event.text}")
        elif isinstance(event, TrackedPlace):
            self._place = event
        elif isinstance(event, TrackedGesture):
            self._gesture = event
        elif isinstance(event, SeveralTouches):
            self._several = event
        elif not isinstance(event, TouchEvent):
            self._last = heard
            if self._waveform is not None:
                self._waveform.extend(event.waveform or ())

    def live(self, console: Console) -> Live:
        """Draws itself until it is left."""
        return Live(get_renderable=lambda: self, console=console, refresh_per_second=FRAMES)

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        """The picture as rich draws it."""
        utf = options.encoding.lower().startswith("utf")
        glyphs = _UNICODE if utf else _ASCII
        yield Text(self._source, style="bold")
        yield from self._array(glyphs, options.max_width)
        yield self._state()
        width = max(8, options.max_width - 24)
        if self._waveform:
            marks, peak = sparkline(np.array(self._waveform), width, glyphs[4])
            yield Text(f"cavity  {marks} {number(peak)} Pa", no_wrap=True)
        else:
            for name, values in zip(self._microphones, self._recent(), strict=True):
                marks, peak = sparkline(values - values.mean(), width, glyphs[4])
                yield Text(f"{name[:7]:<7} {marks} {number(peak)} Pa", no_wrap=True)
        if self._several is not None:
            points = ", ".join("unknown" if each.point is None else str(each.point) for each in self._several.touches)
            yield Text(f"touches at once, at {self._several.time:.2f} s: points {points}")
        p50, p99 = (1e3 * self._latencies.percentile(share) for share in (50, 99))
        faults = ", ".join(f"{kind} {count}" for kind, count in self._faults.items()) or "none"
        yield Text(f"latency p50 {p50:.1f} ms, p99 {p99:.1f} ms   faults: {faults}")
        for line in tuple(self._wrong):
            yield Text(line, style="yellow")

    def _array(self, glyphs: tuple[str, ...], width: int) -> list[Text]:
        point, distribution = None, None
        if self._last is not None:
            point = getattr(self._last.event, "point", None)
            distribution = getattr(self._last.event, "distribution", None)
        rows = []
        for line, own in enumerate(self._lines, 1):
            row = Text(f"{f'line {line}':<8}", no_wrap=True)
            joint = glyphs[3] if 8 + 2 * len(own) <= width else ""
            for place, index in enumerate(own):
                row.append(joint if place else "", style="dim")
                if point == index + 1:
                    row.append(glyphs[2], style="bold green")
                elif point is not None and distribution is not None and distribution[index] >= LIKELY:
                    row.append(glyphs[1], style="yellow")
                else:
                    row.append(glyphs[0], style="dim")
            rows.append(row)
        return rows

    def _state(self) -> Text:
        event = None if self._last is None else self._last.event
        if not isinstance(event, Decision):
            return Text("nothing detected yet")
        named = "" if event.point is None else f"  point {event.point}"
        sure = "" if event.probability is None else f", {100 * event.probability:.0f} %"
        place = ""
        if self._place is not None and event.state == "touch":
            x, y = self._place.place
            place = f"   at {x:.0f}, {y:.0f} ± {self._place.deviation:.0f} mm"
        elif self._gesture is not None:
            place = f"   last: {self._gesture.kind} {self._gesture.direction}".rstrip()
        level = f"   level {number(event.level)} Pa"
        return Text(f"{event.time:9.2f} s  {event.state}{named}{sure}{level}{place}", no_wrap=True)

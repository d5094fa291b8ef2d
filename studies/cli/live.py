"""The verb live."""

from __future__ import annotations

import gc
import os
import sys
from collections import Counter
from collections.abc import Callable
from contextlib import ExitStack, closing
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Annotated

import typer

from geometry.refusal import Refusal
from studies.cli.listening import Extras, open_localizer, open_stream
from studies.cli.locating import ArrayLibrary, DecoderAmbient, DecoderNoise, RefusedShare
from studies.cli.options import named
from studies.cli.tables import show, table_of

if TYPE_CHECKING:
    from localize import BayesDecoder, Localizer, OnnxLocalizer
    from localize.live.listener import Heard, LiveListener
    from localize.live.sources import Source
    from localize.live.stream import StreamLocator


def _list_devices(wanted: bool) -> None:
    if not wanted:
        return
    from localize.live.sound_device import input_devices

    table = table_of("device", "name", "audio system", "channels", "rate (Hz)", "", numbers=(0, 3, 4))
    for each in input_devices():
        default = "default" if each.default else ""
        table.add_row(str(each.number), each.name, each.host, str(each.channels), f"{each.rate:g}", default)
    show(table)
    raise typer.Exit


def live(
    model: Annotated[
        Path,
        typer.Argument(
            metavar="MODEL",
            help="A trained localizer (a folder), an .onnx file, or a library for the model-based decoder.",
            show_default=False,
        ),
    ],
    device: Annotated[
        str | None,
        typer.Option(help="The sound card: its number, or a part of its name.", show_default="that of the system"),
    ] = None,
    list_devices: Annotated[
        bool, typer.Option("--list-devices", callback=_list_devices, is_eager=True, help="List sound cards and stop.")
    ] = False,
    channels: Annotated[
        str | None,
        typer.Option(
            metavar="A=1,B=2",
            help="Which channel, from 1, is which microphone.",
            show_default="the first ones, in the order of the design",
        ),
    ] = None,
    full_scale: Annotated[float, typer.Option(help="Pa: the pressure at full scale of the sound card or file.")] = 1.0,
    replay: Annotated[
        Path | None,
        typer.Option(metavar="FILE.wav", help="Play this in real time instead of listening.", show_default=False),
    ] = None,
    record: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE.wav",
            help="Record what comes in, at the rate at which it does, to a new file; readable even if the program is "
            "killed.",
            show_default=False,
        ),
    ] = None,
    out: Annotated[
        Path | None, typer.Option(help="Write a line of JSON for every frame here, 16 ms apart.", show_default=False)
    ] = None,
    noise: DecoderNoise = None,
    library: ArrayLibrary = None,
    waveform: Annotated[
        bool, typer.Option("--waveform", help="Reconstruct the pressure in the touched cavity.")
    ] = False,
    ambient: DecoderAmbient = None,
    refuse: RefusedShare = None,
) -> None:
    r"""Name touches while they happen: listen to the microphones on a sound card, or play a recording in real time.

    A terminal shows the array; where the output is none, it is a line of JSON for every frame. A sound card that is
    unplugged is waited for. Ctrl-C ends with a summary. Sound cards need: pip install 'acoustic-fem\[live]'.

    Example: [bold]acoustic-fem live library.nc --device USB --record touches.wav --out touches.jsonl[/bold]
    """
    from studies.output.folders import check_new_file

    check_new_file(out)
    if device is not None and replay is not None:
        raise typer.BadParameter("--device must not be given beside --replay")
    if record is not None and replay is not None and record.exists() and record.samefile(replay):
        raise Refusal(f"--record {record} is the file that --replay plays")
    check_new_file(record, kept="a recording", option="--record")
    from localize.live.listener import LiveListener
    from localize.live.recorder import LiveRecorder
    from localize.recordings.recording import check_full_scale

    with named(full_scale="--full-scale"):
        check_full_scale(full_scale)
    chosen = None if channels is None else _channel_map(channels)
    locator = open_localizer(model, noise, ambient)
    source = _source(locator, replay, device, full_scale, chosen)
    stream = open_stream(model, locator, library, Extras(waveform, ambient, refuse), source.limit)
    recorder = None
    if record is not None:
        recorder = LiveRecorder(record, source.rate, len(locator.microphones), full_scale)
    listener = LiveListener(source, stream, recorder)
    summary = _Summary()
    # Looking through all that was imported for what can be freed takes longer than a frame.
    gc.collect()
    gc.freeze()
    try:
        with ExitStack() as stack:
            hear = _outputs(stack, out, listener, locator, summary, waveform)
            for heard in stack.enter_context(closing(listener.listen())):
                hear(heard)
    except KeyboardInterrupt:
        pass
    except BrokenPipeError:
        # Whoever read the lines has gone; Python would fail once more when it flushes them at the end.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    for line in summary.lines():
        print(line, file=sys.stderr)
    for path in [] if recorder is None else recorder.paths:
        print(path, file=sys.stderr)


class _Summary:
    """Counts of all that was heard."""

    def __init__(self) -> None:
        from localize.live.listener import Latencies

        self.latencies = Latencies()
        self._states: Counter[str] = Counter()
        self._faults: Counter[str] = Counter()
        self._lost = 0
        self._began = perf_counter()

    def count(self, heard: Heard) -> None:
        """Take an event that has been put out."""
        from localize.live.listener import Notice
        from localize.live.stream import Decision, Fault

        event = heard.event
        if isinstance(event, Decision):
            self._states[event.state] += 1
        elif isinstance(event, Fault):
            self._faults[event.kind] += 1
            self._lost += (event.samples or 0) if event.kind == "samples lost" else 0
        elif isinstance(event, Notice):
            self._faults[event.kind] += 1

    def lines(self) -> list[str]:
        """For the user."""
        states = ", ".join(f"{count} {state}" for state, count in self._states.items()) or "none"
        faults = ", ".join(f"{count} {kind}" for kind, count in self._faults.items()) or "none"
        lost = f" ({self._lost} samples)" if self._lost else ""
        p50, p99 = (1e3 * self.latencies.percentile(share) for share in (50, 99))
        return [
            f"listened for {perf_counter() - self._began:.1f} s; decisions: {states}",
            f"faults: {faults}{lost}",
            f"latency: p50 {p50:.1f} ms, p99 {p99:.1f} ms, at most {1e3 * self.latencies.largest:.1f} ms",
        ]


def _outputs(
    stack: ExitStack,
    out: Path | None,
    listener: LiveListener,
    locator: Localizer | BayesDecoder | OnnxLocalizer,
    summary: _Summary,
    waveform: bool,
) -> Callable[[Heard], None]:
    """What is done with every event."""
    from rich.console import Console

    from studies.cli.live_display import LivePicture

    console = Console()
    # Lines are written as they come, and stand in the file whenever the program ends.
    files = [] if out is None else [stack.enter_context(out.open("w", encoding="utf-8", newline="\n", buffering=1))]
    picture = None
    if console.is_terminal:
        picture = LivePicture(
            listener.source.name,
            locator,
            locator.microphones,
            lambda: listener.recent,
            summary.latencies,
            waveform,
        )
        stack.enter_context(picture.live(console))

    def hear(heard: Heard) -> None:
        available = heard.available
        line = heard.json_line(None if available is None else perf_counter() - available)
        for file in files:
            file.write(line + "\n")
        if picture is None:
            print(line, flush=True)
        else:
            picture.hear(heard)
        if available is not None:
            summary.latencies.add(perf_counter() - available)
        summary.count(heard)

    return hear


def _source(
    locator: StreamLocator,
    replay: Path | None,
    device: str | None,
    full_scale: float,
    channels: dict[str, int] | None,
) -> Source:
    from localize.live.sound_device import DeviceSource
    from localize.live.sources import ReplaySource

    with named(channels="--channels", device="--device"):
        if replay is not None:
            return ReplaySource(replay, locator.microphones, full_scale, channels)
        wanted = int(device) if device is not None and device.isdecimal() else device
        return DeviceSource(locator.microphones, wanted, full_scale, channels)


def _channel_map(text: str) -> dict[str, int]:
    """``A=1,B=2`` as microphone -> channel."""
    pairs = [part.partition("=") for part in text.split(",")]
    for name, equals, value in pairs:
        if not (name.strip() and equals and value.strip().isdecimal()):
            raise typer.BadParameter(f"--channels {text} must be like A=1,B=2: microphone and channel from 1")
    return {name.strip(): int(value) for name, _, value in pairs}

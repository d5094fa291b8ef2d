"""Files of the electronics of a kit: the board of the microphones to order, the wiring sheet, the expected levels."""

from __future__ import annotations

import csv
import io
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from geometry.assembly.model import ArrayModel
from geometry.boards import closest, shown_board, write_board
from geometry.ground.whole_files import made_folder, write_text
from geometry.stock import Logger
from studies.kit.jobs import BUILD, BUY
from studies.kit.logger_levels import (
    FIRM_TAP,
    FIRST_TOUCH,
    ExpectedLevels,
    LongestTouch,
    expected_levels,
    gentle_touches,
    two_digits,
)
from studies.kit.microphone_wiring import (
    Wire,
    Wiring,
    head_clashes,
    reference_wire,
    size_with_boards,
    wires_csv,
    wiring_of,
)
from studies.kit.recording_setup import logger_needs

#: Folder of the files of the board.
BOARD_FOLDER = "electronics"
#: Width of the lines of the wiring sheet.
_WIDTH = 110


@dataclass(frozen=True)
class Electronics:
    """Electronics of an array."""

    wiring: Wiring
    """Pins, board and signals."""
    levels: ExpectedLevels
    """Levels at the data loggers."""
    wires: tuple[Wire, ...]
    """Wires to the most suitable logger; the calibration microphone is the last."""
    gentle: tuple[LongestTouch, ...]
    """Largest forces of touches of some lengths that are not clipped at the most suitable logger."""
    clashes: tuple[str, ...]
    """Microphones the head of whose board may touch other parts."""
    size: tuple[float, float, float] | None
    """Length, width and height of the array with the heads of its boards, mm; None if the solids do not show them."""

    @property
    def logger(self) -> Logger | None:
        """Most suitable data logger; None for digital microphones, or if none has enough inputs."""
        return self.levels.loggers[0].logger if self.levels.loggers else None

    @property
    def logger_needs(self) -> str:
        """Properties that every data logger must have; empty for digital microphones."""
        return logger_needs(self.levels, self.wires[-1].channel - 1)

    @property
    def first_touch(self) -> LongestTouch:
        """Largest touch of the first recording."""
        return next(touch for touch in self.gentle if touch.seconds == FIRST_TOUCH)

    @property
    def notes(self) -> tuple[str, ...]:
        """Sentences that a maker must know before ordering the board."""
        notes = self.wiring.notes
        if self.size is not None:
            size = " x ".join(f"{side:.1f}" for side in self.size)
            notes += (
                f"With the heads of its boards, as pictures show it, the array is {size} mm large. "
                "Other sizes leave these heads out.",
            )
        if not self.clashes:
            return notes
        touch = (
            f"The head of the board may touch other parts ({'; '.join(self.clashes)}). Compare it with "
            f"{BUILD}/array.html, and order it as a flexible board if it does."
        )
        return (*notes, touch)


def electronics_of(model: ArrayModel) -> Electronics:
    """Electronics of an array: wiring, board and levels."""
    wiring, levels = wiring_of(model.design), expected_levels(model.design)
    logger = levels.loggers[0].logger if levels.loggers else None
    clashes = () if wiring.board is None else head_clashes(model, wiring.board)
    wires = (*wiring.wires(model.design, logger), reference_wire(model.design, logger))
    shown = shown_board(model.design)
    size = None if shown is None else size_with_boards(model, shown)
    return Electronics(wiring, levels, wires, gentle_touches(model.design, levels), clashes, size)


def recorded_options(electronics: Electronics) -> str:
    """Options by which commands read recordings of the most suitable logger."""
    loggers = electronics.levels.loggers
    scale = f"--full-scale {loggers[0].full_scale:.4g} " if loggers else ""
    return f"{scale}--microphone-output voltage"


def write_electronics(electronics: Electronics, folder: Path) -> None:
    """Write the board, the wiring sheet and the levels into the folder of a kit.

    Args:
        electronics: of :func:`electronics_of`.
        folder: of the kit.
    """
    board = electronics.wiring.board
    if board is not None:
        place = made_folder(folder / BUY / BOARD_FOLDER)
        write_board(board, place)
        write_text(place / "order-board.txt", _folded(_order_lines(electronics)))
    build = made_folder(folder / BUILD)
    write_text(build / "wiring.csv", wires_csv(electronics.wires))
    write_text(build / "wiring.txt", _folded(_wiring_lines(electronics)))
    write_text(build / "levels.csv", _levels_csv(electronics.levels))


def _order_lines(electronics: Electronics) -> Iterator[str]:
    """Lines on the board for whoever orders it."""
    board = electronics.wiring.board
    assert board is not None
    yield f"Board of microphone {board.microphone}, {board.title}"
    yield ""
    yield "Upload microphone-board-gerber.zip to a board maker; gerber holds the same layers as single files."
    yield "Open microphone-board.kicad_pcb in KiCad 7 or later to change it. microphone-board.svg shows it."
    yield ""
    yield from electronics.notes
    yield ""
    yield "Pins of the microphone: " + ", ".join(f"{k} {net}" for k, net in enumerate(board.pins, start=1)) + "."
    yield "Pins of the connector J1: " + ", ".join(f"{k} {net}" for k, net in enumerate(board.wires, start=1)) + "."
    yield "Capacitor C1: 100 nF, size 0402, between VDD and GND."
    yield f"Source: {board.source}."
    yield ""
    yield "Smallest sizes of the board, and what makers of cheap boards need (assumed):"
    for spacing in closest(board):
        yield f"  {spacing.rule:8} {spacing.value:.3f} mm, needed {spacing.allowed:g} mm ({spacing.where})"


def _wiring_lines(electronics: Electronics) -> Iterator[str]:
    """Lines of the wiring sheet."""
    wiring, levels = electronics.wiring, electronics.levels
    needs = electronics.logger_needs
    yield f"Wiring of the microphones {wiring.model}"
    yield ""
    if wiring.board is None:
        yield f"No board is drawn: {wiring.missing}."
    else:
        yield f"The board of {BUY}/{BOARD_FOLDER} has the connector J1. Its pins are counted from 1, the square pad."
    if wiring.pins:
        yield "Pins of the microphone: " + ", ".join(f"{k} {net}" for k, net in enumerate(wiring.pins, start=1)) + "."
    yield f"Source: {wiring.source}."
    yield ""
    yield f"{'microphone':11} {'channel':8} {'pin':4} {'signal':7} {'colour':8} goes to"
    for wire in electronics.wires:
        pin, colour = wire.pin or "-", wire.colour
        yield f"{wire.microphone:11} {wire.channel:<8} {pin:<4} {wire.signal:7} {colour:8} {wire.goes_to}"
    yield ""
    if not levels.loggers:
        yield "No data logger of the catalogue has an input for each microphone, so no levels at a logger are listed."
    for each in levels.loggers:
        volts = "" if each.volts is None else f"{each.volts:.3g} V = "
        noises = f"microphone {1e3 * each.microphone_noise:.2g} mPa and logger {1e3 * each.logger_noise:.2g} mPa"
        yield (
            f"{each.name}: largest sample {volts}{each.full_scale:.3g} Pa, one step {1e3 * each.step:.2g} mPa. Noise "
            f"of {noises}, together {each.noise_steps:.3g} steps (rms)."
        )
        yield from each.problems
    if needs:
        yield ""
        yield needs
    yield ""
    yield from levels.verdict
    yield ""
    yield "Largest touches that are not clipped, on the loudest point:"
    for touch in electronics.gentle:
        yield f"  {touch.seconds:.2g} s  {touch.force:.2g} N, the weight of {two_digits(touch.grams)} g"


def _levels_csv(levels: ExpectedLevels) -> str:
    """Levels of all points as CSV: one line per point and logger, with a header."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    forces = (f"{levels.force:g} N", f"{FIRM_TAP:g} N")
    taps = [f"{name} {column}" for name in forces for column in ("(Pa)", "(mV)", "(dBFS)", "clipped")]
    table.writerow(
        ["point", "microphone", "logger", *taps, "headroom to overload (dB)", "largest tap (N)", "noise (steps)"]
    )
    for each in levels.loggers:
        for point in levels.points:
            row: list[object] = [point.point, point.microphone, each.name]
            for pressure in (point.touch, point.firm):
                kept = levels.recorded(pressure, each)
                peak = levels.volts_of(pressure, each)
                volts = "" if peak is None else f"{1e3 * peak:.4g}"
                clipped = "yes" if levels.is_clipped(pressure, each) else "no"
                row += [f"{pressure:.4g}", volts, f"{each.decibels(kept):.1f}", clipped]
            headroom = each.decibels(levels.overload) - each.decibels(point.touch)
            largest = levels.largest_tap(point, each)
            table.writerow([*row, f"{headroom:.1f}", f"{largest:.2g}", f"{each.noise_steps:.3g}"])
    return text.getvalue()


def _folded(lines: Iterator[str]) -> str:
    """Lines as a text; sentences that are too long are folded, lines of tables stay."""
    folded: list[str] = []
    for line in lines:
        folded += textwrap.wrap(line, _WIDTH) if ". " in line or len(line) > _WIDTH else [line]
    return "\n".join(folded) + "\n"

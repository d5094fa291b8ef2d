"""Wiring of the microphones: pins, connector of the board, colours of the wires, and terminals of the data logger."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from acoustic_fem.calibration.manifest import REFERENCE
from geometry.assembly.model import ArrayModel
from geometry.boards import IN_CHAMBER, BoardPlan, board_or_reason, shown_board
from geometry.design.array_design import ArrayDesign
from geometry.layout.size import array_box
from geometry.stock import SIGNALS, Logger, StockMicrophone, catalogue

#: Frequency below which the capacitor of an input may take 3 dB, Hz: a tenth of the slowest touches.
_COUPLING_CORNER = 0.3
#: Capacitors that shops sell, uF.
_CAPACITORS = (1.0, 2.2, 4.7, 10.0, 22.0, 47.0, 100.0, 220.0)
#: Height of the connector and the capacitor above the board, mm; assumed.
_ABOVE_HEAD = 1.0
#: Colour and way of each signal but the output of an analog microphone.
_COLOURS = {
    "VDD": "red", "GND": "black", "OUT": "white", "CLOCK": "blue", "DATA": "green", "SELECT": "yellow",
    "SCK": "blue", "WS": "white", "SD": "green", "LR": "yellow",
}  # fmt: skip
_WAYS = {
    "VDD": "supply that the data sheet states; two AA cells in series give 3 V",
    "GND": "ground of supply and recorder; the metal of the package is ground too",
    "CLOCK": "clock of the controller, common to all microphones",
    "DATA": "data input; two microphones share one line",
    "SELECT": "GND for the first microphone of a pair, VDD for the second",
    "SCK": "bit clock of the controller, common to all microphones",
    "WS": "word clock, common to all microphones",
    "SD": "data input; two microphones share one line",
    "LR": "GND for the first microphone of a pair, VDD for the second",
}


@dataclass(frozen=True)
class Wire:
    """One wire from the board of a microphone."""

    microphone: str
    """Name of the microphone."""
    channel: int
    """Channel of the recording, from 1."""
    pin: int | None
    """Pin of the connector of the board, from 1; None for the calibration microphone, which has no board."""
    signal: str
    """Signal."""
    colour: str
    """Colour of the wire."""
    goes_to: str
    """Terminal at the other end."""


@dataclass(frozen=True)
class Wiring:
    """Wiring of the microphones as far as the design and the catalogue state it."""

    model: str
    """Part number."""
    output: str
    """Output; empty if the catalogue lacks the part."""
    port: str
    """Side of the sound hole; empty if the catalogue lacks the part."""
    pins: tuple[str, ...]
    """Signal of each pin of the microphone, pin 1 first; empty if no source states them."""
    source: str
    """Source of the pins, or of the figures of the microphone."""
    board: BoardPlan | None
    """Board; None if none is drawn."""
    missing: str
    """Reason why no board is drawn; empty if one is."""
    notes: tuple[str, ...]
    """Sentences on the board that a maker must know before ordering it."""

    def wires(self, design: ArrayDesign, logger: Logger | None) -> tuple[Wire, ...]:
        """All wires of an array to a logger; ``logger`` is None for digital microphones."""
        return tuple(self._wires(design, logger))

    def _wires(self, design: ArrayDesign, logger: Logger | None) -> Iterator[Wire]:
        signals = SIGNALS[self.output or "analog"] if self.board is None else self.board.wires
        for number, name in enumerate(design.microphones):
            for pin, signal in enumerate(signals, start=1):
                way = _way_out(logger, number) if signal == "OUT" else _WAYS[signal]
                if signal in ("SELECT", "LR"):
                    way = ("GND", "VDD")[number % 2]
                elif signal in ("DATA", "SD"):
                    way = f"data input {number // 2 + 1} of the controller"
                elif signal == "GND" and logger is not None:
                    way = f"minus of the cells, and {_terminal(logger, 1, number)}"
                elif signal == "VDD" and logger is not None:
                    way = "plus of the cells, 3 V"
                yield Wire(name, number + 1, pin, signal, _COLOURS[signal], way)


def reference_wire(design: ArrayDesign, logger: Logger | None) -> Wire:
    """Wire of the calibration microphone, which has the channel after those of the array.

    Args:
        design: the array.
        logger: its data logger; None for digital microphones.
    """
    number = len(design.microphones)
    if logger is not None and number < logger.channels:
        way = f"{_terminal(logger, 0, number)}, the output of its amplifier; only to calibrate"
    else:
        way = "a recorder of its own, only to calibrate; state started_late in calibration.toml"
    return Wire(REFERENCE, number + 1, None, "OUT", "as its maker says", way)


def wiring_of(design: ArrayDesign) -> Wiring:
    """Wiring of the microphones of a design."""
    model = design.microphone.model
    part = catalogue().microphone(model)
    board, missing = board_or_reason(design)
    if not isinstance(part, StockMicrophone):
        return Wiring(model, "", "", (), design.microphone.source, board, missing, ())
    source = part.pins_source or part.source
    notes = () if board is None else tuple(_notes(design, board))
    return Wiring(part.part_number, part.output, part.port, part.pins, source, board, missing, notes)


def head_clashes(model: ArrayModel, board: BoardPlan) -> tuple[str, ...]:
    """Microphones the head of whose board may touch another part, each with the names of these parts.

    Parts are compared by the boxes around them, so a part that is near but does not touch may be named too.
    """
    (left, low), (right, high) = board.head
    bottom = model.design.microphone.chamber_height
    head = np.array([[left, low, bottom], [right, high, bottom + board.thickness + _ABOVE_HEAD]])
    boxes = {}
    for name, shape in model.shapes.items():
        box = shape.BoundingBox()
        sides = ((box.xmin, box.xmax), (box.ymin, box.ymax), (box.zmin, box.zmax))
        boxes[name] = np.array([[x, y, z, 1.0] for x in sides[0] for y in sides[1] for z in sides[2]])
    found = []
    for housing in (part for part in model.placed if part.kind == "housing"):
        inwards, near = np.linalg.inv(housing.matrix), dict[str, None]()
        for part in model.placed:
            if part.group == housing.group:
                continue
            corners = (boxes[part.part] @ part.matrix.T @ inwards.T)[:, :3]
            if (corners.min(axis=0) < head[1]).all() and (corners.max(axis=0) > head[0]).all():
                near[part.group] = None
        if near:
            found.append(f"{housing.group}: {', '.join(near)}")
    return tuple(found)


def size_with_boards(model: ArrayModel, board: BoardPlan) -> tuple[float, float, float]:
    """Length, width and height of an array with the heads of its boards, mm."""
    low, high = array_box(model.design, model.layout)
    corners = np.array([(x, y, z, 1.0) for x, y in board.outline for z in (0.0, board.thickness)])
    for part in model.placed:
        if part.kind == "board":
            places = (corners @ part.matrix.T)[:, :3]
            low, high = np.minimum(low, places.min(axis=0)), np.maximum(high, places.max(axis=0))
    length, width, height = (high - low).tolist()
    return length, width, height


def coupling_capacitor(logger: Logger) -> float:
    """Capacitor between microphone and input of a logger, uF, the next that shops sell.

    Its corner with the resistance of the input, 1 / (2 pi R C), is at most a tenth of the slowest touches.
    """
    needed = 1e6 / (2 * math.pi * _COUPLING_CORNER * logger.input_resistance)
    return next((each for each in _CAPACITORS if each >= needed), _CAPACITORS[-1])


def wires_csv(wires: tuple[Wire, ...]) -> str:
    """Wires as CSV: one line per wire, with a header."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["microphone", "channel", "pin of the board", "signal", "colour", "goes to"])
    for wire in wires:
        table.writerow([wire.microphone, wire.channel, wire.pin or "", wire.signal, wire.colour, wire.goes_to])
    return text.getvalue()


def _way_out(logger: Logger | None, number: int) -> str:
    if logger is None:
        return "input of the recorder, through a capacitor of 10 uF"
    resistor = ""
    if logger.coupling == "DC":
        resistor = f", with {logger.input_resistance / 1e3:g} kOhm from the terminal to ground"
    return f"{_terminal(logger, 0, number)}, through {coupling_capacitor(logger):g} uF{resistor}"


def _terminal(logger: Logger, which: int, number: int) -> str:
    return logger.terminals[which].format(n=number + logger.first_terminal)


def _notes(design: ArrayDesign, board: BoardPlan) -> Iterator[str]:
    microphone, (length, width) = design.microphone, board.size
    housing = microphone.board_size[0] / 2 + microphone.board_gap + microphone.wall_thickness
    yield (
        f"Order it with two layers, {board.thickness:g} mm thick, {length:.1f} x {width:.1f} mm, with gold on the pads "
        "(ENIG). If the maker has no such thickness, order the next one and set microphone.sound_hole_length to it."
    )
    if "assumed" in board.source:
        yield (
            "The source of its pads or pins is assumed. Compare them with the data sheet of the microphone before you "
            "order, because no other check can find a wrong pin."
        )
    yield f"The head of the board ends {-board.head[0][0] - housing:.1f} mm outside the housing."
    if shown_board(design) is None:
        yield (
            "On a body the board cannot lie flat. Order it as a flexible board with a stiffener below the seat, of the "
            "same thickness together, and bend the neck outwards in the slot. The solids show only the seat."
        )
    yield (
        "File the two inner corners at the neck square, because a milling cutter leaves them round. The board must lie "
        "flat in its seat."
    )
    x, inside = board.sound_hole.centre[0], board.in_chamber
    if x > 0.05:
        yield (
            f"The sound hole lies {x:.2f} mm beside the axis of the chamber, away from the slot, because that of "
            f"the package is not in its middle. Its edge stays {inside:.2f} mm from the wall of the chamber, so keep "
            "glue off the inner edge of the seat. The simulation has the hole in the middle."
        )
    if inside < IN_CHAMBER - 0.05:
        longer = microphone.board_size[0] + 2 * (IN_CHAMBER - inside)
        yield (
            f"Glue needs {IN_CHAMBER:g} mm there. With microphone.board_length = {longer:.2f} the hole lies far enough "
            "within."
        )
    if board.pin_mark is None:
        yield "The board has no room for a mark of pin 1. Compare the package with the drawing before you solder it."
    else:
        yield "A white dot on the board, beside the package, marks pin 1 of the microphone."

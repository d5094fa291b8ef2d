"""Costs of a decoder on a microcontroller: flash, memory, stack and instructions, and whether that is within a budget.

Tables and variables are counted. Code, stack and instructions are those of gcc 12.2 with newlib at -O2 for a
Cortex-M4F, counted on an emulated board while no point is given up early: no decision takes more, whatever the signal
is. Tests hold all of it against what the compiler makes for three cores, and what they execute.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from geometry.ground.refusal import Kind, Refusal
from localize.decoders.frame_covariance import SAMPLES
from localize.embedded.decoder_tables import EmbeddedTables
from localize.embedded.reflections import BLOCK
from localize.embedded.source import POWER_COUNT, named_points, table_bytes
from localize.live.events import HOP
from localize.signals.frames import FRAME

CODE = {"float32": 7650, "int16": 8100}
"""Code and constants of the decoder and of what it takes from newlib, of up to four microphones, bytes."""
MARGIN = 1.03
"""By what counts of instructions are stated higher: cores and arrays differ."""
#: TOUCH_HOPS of touch_decoder.h.
HOPS = -(-FRAME // HOP)
_STATED = re.compile(r"\s*(flash|ram|stack|instructions)\s*=\s*(\d+(?:\.\d+)?)\s*([kM]?)\s*")


class LargeDecoderWarning(UserWarning):
    """Warning of a decoder that needs more flash than the linker file of its board states."""


@dataclass(frozen=True)
class Cost:
    """Costs of a decoder."""

    flash: int
    """Tables, code and constants, bytes."""
    ram: int
    """Variables of the decoder, bytes."""
    stack: int
    """Most that its calls take of the stack, bytes."""
    instructions: int
    """Most that a decision takes, every 16 ms."""
    first: int
    """Most that the first decision takes beyond that, after the start or a gap."""


@dataclass(frozen=True)
class Budget:
    """Resources that a microcontroller has left for the decoder; None where a resource does not matter."""

    flash: int | None = None
    """Bytes."""
    ram: int | None = None
    """Bytes."""
    stack: int | None = None
    """Bytes."""
    instructions: int | None = None
    """Instructions for a decision, every 16 ms."""

    @classmethod
    def stated(cls, text: str) -> Budget:
        """Budget from words such as ``flash=512k,ram=16k,instructions=2.5M``.

        k and M are 1024 and 1024^2 bytes, as data sheets have them, or thousands and millions of instructions.

        Raises:
            Refusal: other words, a figure that is given twice, or 0.
        """
        found: dict[str, int] = {}
        for part in text.split(","):
            match = _STATED.fullmatch(part)
            if match is None or match[1] in found or not float(match[2]):
                raise Refusal(
                    f"holds {part!r}; each part must be flash, ram, stack or instructions, once, with a number above 0",
                    kind=Kind.OUT_OF_RANGE,
                    field="budget",
                    value=text,
                    remedy="write it as flash=512k,ram=16k,instructions=2.5M",
                )
            thousand = 1000 if match[1] == "instructions" else 1024
            found[match[1]] = int(float(match[2]) * thousand ** {"": 0, "k": 1, "M": 2}[match[3]])
        return cls(**found)

    def check(self, cost: Cost, what: str) -> None:
        """Refuse a decoder that takes more.

        Args:
            cost: of the decoder.
            what: the decoder in words.

        Raises:
            Refusal: names each figure that is over, and by what.
        """
        over = []
        for name in ("flash", "ram", "stack", "instructions"):
            needed, left = getattr(cost, name), getattr(self, name)
            if left is not None and needed > left:
                over.append(f"{name} {needed} of {left}{'' if name == 'instructions' else ' bytes'}")
        if over:
            raise Refusal(f"is exceeded by {what}: {', '.join(over)}", kind=Kind.UNSUITABLE, field="budget")


def in_units(name: str, value: int) -> str:
    """A figure of :class:`Cost` in words: bytes in KiB, instructions in thousands or millions."""
    if name != "instructions":
        return f"{value / 1024:.4g} KiB"
    return f"{value / 1e6:.4g} M" if value >= 1e6 else f"{value / 1e3:.4g} k"


def cost_of(tables: EmbeddedTables) -> Cost:
    """Cost of the decoder that has some tables."""
    microphones = len(tables.microphones)
    return Cost(
        flash=table_bytes(tables) + CODE[tables.precision],
        ram=_memory(tables),
        stack=256 + 64 * microphones + 4 * tables.rank + (64 if tables.precision == "int16" else 0),
        instructions=int(MARGIN * _instructions(tables)),
        first=36_500 * microphones,
    )


def _memory(tables: EmbeddedTables) -> int:
    """Size of touch_decoder, field by field; bytes."""
    microphones = len(tables.microphones)
    decision = 4 * (6 + named_points(tables) + tables.point_count)
    single = 4 * 14
    # whole, tail, state, frame, coming, decimated.
    of_each = 4 * microphones * (2 * 2 * HOPS + 2 + FRAME + HOP + SAMPLES)
    return decision + single + of_each + 2 * 4 * tables.size


def _instructions(tables: EmbeddedTables) -> int:
    """Most instructions of a decision.

    Each point costs its reflections, four by four over the rest of the frame, and the scores of all powers. The frame
    itself costs the directions beside sound, and the transform from samples to the white frame.
    """
    blocks, microphones = tables.size // BLOCK, len(tables.microphones)
    fours = blocks * (blocks + 1) // 2
    turns = 120 * fours + 204 * blocks if tables.precision == "int16" else 86 * fours + 70 * blocks
    scores = (2 * 35 + 8 * 28) * POWER_COUNT // 32 * tables.rank // 2
    beside = 0 if tables.beside is None else len(tables.beside)
    frame = beside * (4.8 * microphones * SAMPLES + 8 * microphones**2) + 19_000 * microphones
    return int(tables.point_count * (turns + scores + 1500) + frame)

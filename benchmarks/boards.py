"""The decoder as C on emulated boards: compiled with arm-none-eabi-gcc, run by qemu-system-arm, instructions counted.

Under ``-icount shift=0`` every instruction takes a nanosecond of the board's time. So the clock of the board counts
instructions to within a tick, however busy the host is. The count does not include waits for flash, and divisions take
more than one cycle on silicon.
"""

from __future__ import annotations

import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

SOURCES = Path(__file__).parent / "board"
COMPILER, EMULATOR = "arm-none-eabi-gcc", "qemu-system-arm"
#: What makes the decoder as the README of an export says.
FLAGS = ("-std=c99", "-O2", "-ffp-contract=fast")


@dataclass(frozen=True)
class Board:
    """A board that the emulator knows."""

    processor: str
    """Name of its core."""
    flags: tuple[str, ...]
    """What the compiler must know of the core."""
    tick: float
    """Length of a tick of its clock, ns: as many instructions."""
    code_at: int = 0x00000000
    """Address of its code."""
    data_at: int = 0x20000000
    """Address of its memory."""
    float_abi: str = "hard"
    """``soft`` for a core without a floating-point unit."""
    flash: str = "4M"
    """Size of its flash, as linkers write it."""
    ram: str = "2M"
    """Size of its memory."""


BOARDS = {
    "mps2-an386": Board("Cortex-M4F", ("-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16"), 40),
    "mps2-an500": Board("Cortex-M7", ("-mcpu=cortex-m7", "-mfpu=fpv5-sp-d16"), 40),
    "mps2-an505": Board("Cortex-M33", ("-mcpu=cortex-m33", "-mfpu=fpv5-sp-d16"), 50, 0x10000000, 0x38000000),
}
#: Board whose core has no floating-point unit. Its Cortex-M0 has all the instructions of a Cortex-M0+.
WITHOUT_FPU = "microbit"
SMALL = Board("Cortex-M0+", ("-mcpu=cortex-m0plus",), 62.5, float_abi="soft", flash="256K", ram="16K")


@dataclass(frozen=True, eq=False)
class OnBoard:
    """Results of the decoder on a board, decision by decision."""

    sample: NDArray[np.int64]
    """Samples up to the end of the frame."""
    state: NDArray[np.int64]
    """State as the header numbers them."""
    level: NDArray[np.float64]
    """Of the loudest microphone, Pa rms."""
    point: NDArray[np.int64]
    """Point from 1, 0 where none is touched."""
    instructions: NDArray[np.int64]
    """Instructions since the decision before."""
    stack: NDArray[np.int64]
    """Bytes of the stack that the calls took."""
    posterior: NDArray[np.float64]
    """Probabilities, (n, n_point); NaN where no point is touched."""


def missing_tools() -> str | None:
    """The first of the tools that is not installed; None where all are."""
    return next((name for name in (COMPILER, EMULATOR) if shutil.which(name) is None), None)


def linked_bytes(folder: Path, name: str) -> int:
    """Bytes of flash that a firmware grows by: an exported decoder, its tables, and what it needs of the C library."""
    board, objects = BOARDS[name], []
    for source in ("touch_decoder", "touch_tables"):
        objects.append(str(folder / f"{source}.o"))
        _compile(board, ["-c", str(folder / f"{source}.c"), "-o", objects[-1]])
    linked = str(folder / "linked.elf")
    kept = ["-nostartfiles", "-Wl,-e,touch_push", "-Wl,-u,touch_init", "-Wl,--gc-sections", "--specs=nosys.specs"]
    _compile(board, [*objects, *kept, "-lm", "-o", linked])
    told = subprocess.run(["arm-none-eabi-size", linked], check=True, capture_output=True, text=True)
    code, data, *_ = told.stdout.splitlines()[1].split()
    return int(code) + int(data)


def run_on_board(
    folder: Path, samples: NDArray[np.float32], name: str = "mps2-an386", limit: float = 0.0, everything: bool = False
) -> OnBoard:
    """Decisions of an exported decoder on a board.

    Args:
        folder: of an export; the built program is written there too.
        samples: (n_sample, n_microphone), Pa.
        name: of the board.
        limit: pressure from which a sample counts as clipped, Pa; 0 if none does.
        everything: True to score every point fully, so that each frame takes the longest possible time.
    """
    board = BOARDS[name]
    linked = folder / f"{name}.elf"
    start = _compile(board, ["-print-file-name=rdimon-crt0.o"]).strip()
    given = [f"-DLIMIT={limit!r}f", *(["-DTOUCH_ALL=1"] if everything else [])]
    # The linker's script goes through the preprocessor, which knows the addresses.
    script = folder / f"{name}.ld"
    text = (SOURCES / "board.ld").read_text(encoding="utf-8")
    script.write_text(text.replace("CODE_AT", hex(board.code_at)).replace("DATA_AT", hex(board.data_at)))
    sources = [SOURCES / "startup.c", SOURCES / "board.c", folder / "touch_decoder.c", folder / "touch_tables.c"]
    libraries = ["-nostartfiles", start, "--specs=rdimon.specs", "-lc", "-lrdimon", "-lm"]
    _compile(
        board,
        [*given, f"-I{folder}", *map(str, sources), "-T", str(script), *libraries, "-o", str(linked)],
    )
    np.ascontiguousarray(samples, np.float32).tofile(folder / "samples.f32")
    command = [EMULATOR, "-M", name, "-nographic", "-monitor", "none", "-serial", "none", "-icount", "shift=0"]
    command += ["-semihosting-config", "enable=on,target=native", "-kernel", str(linked)]
    told = subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True, timeout=300)
    rows = [line.split() for line in told.stdout.splitlines()]
    points = max((len(row) - 6 for row in rows), default=0)
    posterior = np.full((len(rows), points), np.nan)
    for row, fields in enumerate(rows):
        posterior[row, : len(fields) - 6] = [float(field) for field in fields[6:]]
    sample, state, level, point, ticks, stack = np.array([[float(field) for field in row[:6]] for row in rows]).T
    whole = [each.astype(np.int64) for each in (sample, state, point, ticks * board.tick, stack)]
    return OnBoard(*whole[:2], level, *whole[2:], posterior)


def _compile(board: Board, arguments: list[str]) -> str:
    command = [COMPILER, *board.flags, "-mthumb", "-mfloat-abi=hard", *FLAGS, *arguments]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout

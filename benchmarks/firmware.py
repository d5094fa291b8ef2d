"""The firmware on an emulated Cortex-M4, in raw and in event mode.

``python -m benchmarks.firmware`` plays five recordings of each array to the board and prints two tables, as
docs/embed.md has them: flash, RAM, stack and instructions; and how its events compare with those of Python.
``--seconds N`` takes shorter recordings.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from benchmarks.boards import BOARDS, COMPILER, EMULATOR, FLAGS, SMALL, SOURCES, WITHOUT_FPU
from benchmarks.embedded_touches import array_of
from benchmarks.firmware_touches import SECONDS, decimated, events_in_python, of_converter, recordings
from localize.embedded import embed
from localize.embedded.decoder_tables import Precision
from localize.live.events import TouchEvent
from localize.live.serial_frames import FrameReader, SampleFrame, StatusFrame, TouchFrame

BOARD = "mps2-an386"
PARTS = ("firmware", "ring", "decimator", "serial", "board_mps2")
#: What event mode needs beside these.
MORE = ("decoder", "tables", "tracker")
FULL_SCALE = float(np.float32(28.3))
"""Pressure of the largest sample, Pa: the overload of the microphone of the prototypes."""
NEAREST = 188
"""Smallest stack that can be measured, bytes. The counting itself uses the bytes that lie nearer to the main loop."""
ARRAYS = ("array-2x6", "glove")
EMULATED = {BOARD: BOARDS[BOARD], WITHOUT_FPU: SMALL}
SEED = 45

Mode = Literal["raw", "events"]


def linked_firmware(
    folder: Path, prefix: str = "touch", mode: Mode = "raw", counted: bool = False, name: str = BOARD
) -> Path:
    """Program of an exported project, built as its README says; with counts of instructions and stack, if asked for.

    For :data:`WITHOUT_FPU`, its linker file has the sizes of that board, and its frames go to a file of the host.
    """
    board = EMULATED[name]
    command = [COMPILER, *board.flags, "-mthumb", f"-mfloat-abi={board.float_abi}", *FLAGS]
    command += ["-Wall", "-Wextra", "-Werror"]
    parts = PARTS + (MORE if mode == "events" else ())
    sources = [f"{prefix}_{part}.c" for part in parts]
    script = (folder / f"{prefix}_board_mps2.ld").read_text(encoding="utf-8")
    (folder / f"{name}.ld").write_text(script.replace("= 4M", f"= {board.flash}").replace("= 2M", f"= {board.ram}"))
    linker = ["-nostartfiles", "-Wl,--gc-sections", "-T", f"{name}.ld", "-o", f"{mode}.elf", "-lm"]
    if name == WITHOUT_FPU:
        sources += [str(SOURCES / "line.c"), "-DWORDS=700"]  # there is no more room behind the variables
        linker += ["-Wl,--wrap=touch_hal_send"]
    if counted:
        sources.append(str(SOURCES / "count.c"))
        linker.append("-Wl,--wrap=touch_hal_wait")
    chosen = [f"-D{prefix.upper()}_EVENT_MODE={int(mode == 'events')}"]
    command += ["-ffunction-sections", "-fdata-sections", *chosen, *sources, *linker]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    return folder / f"{mode}.elf"


def firmware_bytes(program: Path) -> tuple[int, int]:
    """Flash and RAM of a program, bytes, without its stack."""
    told = subprocess.run(["arm-none-eabi-size", program], check=True, capture_output=True, text=True)
    code, data, zeros, *_ = (int(each) for each in told.stdout.splitlines()[1].split()[:3])
    return code + data, data + zeros


def started(
    program: Path, samples: NDArray[np.int16], line: str, *more: str, name: str = BOARD
) -> subprocess.Popen[bytes]:
    """The emulated board with (n, n_microphone) samples at 16 kHz, and its UART at a line of the emulator."""
    np.ascontiguousarray(samples, "<i2").tofile(program.parent / "samples.i16")
    command = [EMULATOR, "-M", name, "-nographic", "-monitor", "none", "-serial", line, *more]
    command += ["-semihosting-config", "enable=on,target=native", "-kernel", str(program)]
    return subprocess.Popen(command, cwd=program.parent)


@dataclass(frozen=True, eq=False)
class OnBoard:
    """Output of the whole firmware on the emulated board."""

    touches: list[TouchFrame]
    """Events, in event mode."""
    samples: list[SampleFrame]
    """Samples, in raw mode."""
    states: list[StatusFrame]
    """States of the board."""
    lost: int
    """Frames that were lost or damaged on its line."""
    instructions: int
    """Instructions of the main loop for all samples, without those of ``touch_hal_wait``."""
    longest: int
    """Instructions of the longest pass of that loop, which takes 4 ms of samples."""
    stack: int
    """Most bytes of the stack."""


def run_firmware(folder: Path, samples: NDArray[np.int16], mode: Mode, name: str = BOARD) -> OnBoard:
    """All that an exported project sends of (n, n_microphone) samples at 16 kHz, and what it takes."""
    program, tick = linked_firmware(folder, mode=mode, counted=True, name=name), EMULATED[name].tick
    (folder / "line.bin").unlink(missing_ok=True)
    line = "none" if name == WITHOUT_FPU else "file:line.bin"
    board = started(program, samples, line, "-icount", "shift=0", name=name)
    if board.wait(600) != 0:
        raise RuntimeError(f"the emulated board ended with {board.returncode}")
    reader = FrameReader()
    frames = reader.push((folder / "line.bin").read_bytes())
    ticks, longest, stack = (int(each) for each in np.fromfile(folder / "counts.u32", "<u4"))
    return OnBoard(
        [each for each in frames if isinstance(each, TouchFrame)],
        [each for each in frames if isinstance(each, SampleFrame)],
        [each for each in frames if isinstance(each, StatusFrame)],
        reader.counts.lost + reader.counts.damaged,
        round(ticks * tick),
        round(longest * tick),
        stack,
    )


def write_project(folder: Path, name: str, precision: Precision = "float32") -> None:
    """The project of an as-built sensor of a prototype, calibrated without error."""
    for file, text in embed(array_of(name, True), precision).files.items():
        (folder / file).write_text(text, encoding="utf-8")


def differing(found: list[TouchFrame], expected: list[TouchEvent]) -> int:
    """Number of events that are not in both: of the same kind, touch and point, at times at most a hop apart."""
    same = sum(
        (a.kind, a.touch, a.point) == (b.kind, b.touch, b.point) and abs(a.sample - 1000 * b.time) < 16.5
        for a, b in zip(found, expected, strict=False)
    )
    return max(len(found), len(expected)) - same


def rows_without_fpu(seconds: int) -> list[str]:
    """Table of the firmware of ``array-2x6`` with tables in int16 on a core without a floating-point unit."""
    response = array_of("array-2x6", True)
    played = of_converter(recordings(response, SEED, FULL_SCALE, seconds)["taps"], FULL_SCALE)
    rows = ["| mode | flash (bytes) | RAM (bytes) | stack (bytes) | instructions a second | longest pass |"]
    rows.append("|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        write_project(folder, "array-2x6", "int16")
        for mode in ("raw", "events"):
            flash, ram = firmware_bytes(linked_firmware(folder, mode=mode, name=WITHOUT_FPU))
            run = run_firmware(folder, played, mode, WITHOUT_FPU)
            each_second = run.instructions / seconds
            rows.append(f"| {mode} | {flash} | {ram} | {run.stack} | {each_second:.3g} | {run.longest:.3g} |")
    return rows


def main(arguments: list[str] | None = None) -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0] if __doc__ else None)
    parser.add_argument("--seconds", type=int, default=SECONDS, help="length of each recording, s")
    parser.add_argument("--without-fpu", action="store_true", help="the table of a Cortex-M0+ alone")
    given = parser.parse_args(arguments)
    seconds = given.seconds
    if given.without_fpu:
        print("\n".join(rows_without_fpu(seconds)))
        return
    costs = ["| array | mode | flash (bytes) | RAM (bytes) | stack (bytes) | instructions a second | longest pass |"]
    events = ["| array | recording | events | not equal to those of Python |"]
    costs.append("|---|---|---|---|---|---|---|")
    events.append("|---|---|---|---|")
    for name in ARRAYS:
        response = array_of(name, True)
        played = {
            key: of_converter(each, FULL_SCALE) for key, each in recordings(response, SEED, FULL_SCALE, seconds).items()
        }
        with tempfile.TemporaryDirectory() as place:
            folder = Path(place)
            write_project(folder, name)
            for mode in ("raw", "events"):
                flash, ram = firmware_bytes(linked_firmware(folder, mode=mode))
                runs = {key: run_firmware(folder, each, mode) for key, each in played.items()}
                each_second = max(run.instructions for run in runs.values()) / seconds
                longest, stack = max(run.longest for run in runs.values()), max(run.stack for run in runs.values())
                used = f"{'at most ' if stack <= NEAREST else ''}{stack}"
                costs.append(f"| {name} | {mode} | {flash} | {ram} | {used} | {each_second:.3g} | {longest:.3g} |")
                if mode == "events":
                    for key, run in runs.items():
                        expected = events_in_python(response, decimated(played[key], FULL_SCALE), FULL_SCALE).events
                        events.append(f"| {name} | {key} | {len(expected)} | {differing(run.touches, expected)} |")
    print("\n".join([*costs, "", *events]))


if __name__ == "__main__":
    sys.exit(main())

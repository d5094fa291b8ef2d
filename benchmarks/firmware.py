"""The firmware in raw mode on an emulated Cortex-M4.

``python -m benchmarks.firmware`` prints its flash, its RAM and its instructions, as docs/embed.md has them.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from benchmarks.boards import BOARDS, COMPILER, EMULATOR, FLAGS
from benchmarks.embedded_touches import array_of
from localize.embedded import embed

BOARD = "mps2-an386"
PARTS = ("firmware", "ring", "decimator", "serial", "board_mps2")


def linked_firmware(folder: Path, prefix: str = "touch") -> Path:
    """Program of an exported project, built as its README says."""
    command = [COMPILER, *BOARDS[BOARD].flags, "-mthumb", "-mfloat-abi=hard", *FLAGS, "-Wall", "-Wextra", "-Werror"]
    sources = [f"{prefix}_{part}.c" for part in PARTS]
    linker = ["-nostartfiles", "-Wl,--gc-sections", "-T", f"{prefix}_board_mps2.ld", "-o", "firmware.elf"]
    command += ["-ffunction-sections", "-fdata-sections", *sources, *linker]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    return folder / "firmware.elf"


def firmware_bytes(program: Path) -> tuple[int, int]:
    """Flash and RAM of a program, bytes, without its stack."""
    told = subprocess.run(["arm-none-eabi-size", program], check=True, capture_output=True, text=True)
    code, data, zeros, *_ = (int(each) for each in told.stdout.splitlines()[1].split()[:3])
    return code + data, data + zeros


def started(program: Path, samples: NDArray[np.int16], line: str, *more: str) -> subprocess.Popen[bytes]:
    """The emulated board with (n, n_microphone) samples at 16 kHz, and its UART at a line of the emulator."""
    np.ascontiguousarray(samples, "<i2").tofile(program.parent / "samples.i16")
    command = [EMULATOR, "-M", BOARD, "-nographic", "-monitor", "none", "-serial", line, *more]
    command += ["-semihosting-config", "enable=on,target=native", "-kernel", str(program)]
    return subprocess.Popen(command, cwd=program.parent)


def main() -> None:
    """Print the table."""
    print("| array | flash (bytes) | RAM (bytes) |\n|---|---|---|")
    for name in ("array-2x6", "glove"):
        with tempfile.TemporaryDirectory() as folder:
            for file, text in embed(array_of(name, False)).files.items():
                Path(folder, file).write_text(text, encoding="utf-8")
            flash, ram = firmware_bytes(linked_firmware(Path(folder)))
        print(f"| {name} | {flash} | {ram} |")


if __name__ == "__main__":
    sys.exit(main())

"""Boards that an export has sources for: what each adds to the folder, and how it is built."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

#: Names of the boards.
BoardName = Literal["cortex-m", "zephyr", "arduino"]


@dataclass(frozen=True)
class Board:
    """Sources of a board, and the section of the README about them."""

    title: str
    """Name in words."""
    sources: tuple[str, ...]
    """Names of the files that it adds to those of every board."""
    building: str
    """How the firmware is built, in Markdown."""
    scaling: str
    """How the pressure of the largest sample is changed, in Markdown."""
    faster: str
    """How the line gets the speed ``{faster}``, in Markdown, as the beginning of a sentence."""
    most_microphones: int | None = None
    """Largest number of microphones that its source reads; None for any."""
    digital: bool = False
    """True if its source reads PDM microphones, whose samples have 16 bits and no voltage."""
    flash: int | None = None
    """Flash in its linker file, bytes; None where the board's tools choose it."""
    has_bench: bool = True
    """True if the test bench for the host may lie in the folder; if not, the board's tools would compile it too."""


_CORTEX_M = """`touch_board_mps2.c` shows the five functions, with a start-up and the linker file `touch_board_mps2.ld`,
for a Cortex-M4 that emulators know. For a chip of your own, keep the start-up, enter the sizes of its memories in the
linker file, and replace what reads samples and writes bytes. No silicon was tried.

The emulator reads the microphones from the file `samples.i16` in its folder: 16-bit integers at 16 kHz, interleaved.
From a recording `take.wav` at 16 kHz with a channel for each microphone, in the order of the design, make it with
`sox take.wav -t s16 samples.i16`, or in Python from signals as fractions of full scale with
`(32767 * signals.T).astype("<i2").tofile("samples.i16")`.

```sh
arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -std=c99 -O2 -ffp-contract=fast \\
    -ffunction-sections -fdata-sections -Wl,--gc-sections -DTOUCH_EVENT_MODE=1 \\
    touch_firmware.c touch_ring.c touch_decimator.c touch_serial.c touch_board_mps2.c \\
    touch_decoder.c touch_tables.c touch_tracker.c \\
    -nostartfiles -T touch_board_mps2.ld -lm -o firmware.elf
qemu-system-arm -M mps2-an386 -nographic -monitor none -serial tcp:127.0.0.1:5555,server=on,wait=on \\
    -semihosting-config enable=on,target=native -kernel firmware.elf     # reads samples.i16
```

The emulator waits for a reader: `acoustic-fem live library.nc --serial socket://127.0.0.1:5555`.
"""
_ZEPHYR = """`touch_board_zephyr.c` has the five functions for Zephyr, with PDM microphones on its DMIC driver. The
device tree of your board must have a DMIC with the label `dmic_dev`, and choose a UART as `zephyr,console`. Choose the
mode in `CMakeLists.txt`. No silicon was tried; the tests compile and run the file with stubs in place of Zephyr.

```sh
west build -b BOARD .
west flash
```
"""
_ARDUINO = """`touch_board_arduino.cpp` has the five functions for Arduino boards with the library PDM, which reads at
most two microphones. Call the folder `touch_arduino` and open it in the Arduino IDE. Choose the mode in
`touch_firmware.h`. The buffer of `Serial` must hold a whole frame, up to 100 bytes in raw mode with two microphones;
otherwise the frames are counted as unsent. No silicon was tried; the tests compile and run the file with stubs in place
of Arduino. The test bench for the host comes with the other boards.
"""
_OTHER_MICROPHONES = """For PDM microphones with a sensitivity of S dBFS at 94 dB SPL, the pressure of the largest
sample is 1.41 * 10^(-S / 20) Pa, because a sine of 94 dB SPL has a peak of 1.41 Pa.
Export again with `--board {board} --full-scale` and this number, or {by_hand}."""

BOARDS: dict[BoardName, Board] = {
    "cortex-m": Board(
        "a Cortex-M without an operating system",
        ("touch_board_mps2.c", "touch_board_mps2.ld"),
        _CORTEX_M,
        "For another converter, export again with `--converter-volts`, `--full-scale` or `--converter-bits`, or\n"
        "compile with `-DTOUCH_FULL_SCALE=...f`.",
        "Compile with `-DTOUCH_BAUD={faster}`, or set the speed of your board",
        flash=2**22,
    ),
    "zephyr": Board(
        "Zephyr",
        ("touch_board_zephyr.c", "CMakeLists.txt", "prj.conf"),
        _ZEPHYR,
        _OTHER_MICROPHONES.format(
            board="zephyr", by_hand="add `TOUCH_FULL_SCALE=...f` to\n`target_compile_definitions` in `CMakeLists.txt`"
        ),
        "Set `current-speed = <{faster}>` of the UART in the device tree of your board",
        digital=True,
    ),
    "arduino": Board(
        "Arduino",
        ("touch_board_arduino.cpp", "touch_arduino.ino"),
        _ARDUINO,
        _OTHER_MICROPHONES.format(board="arduino", by_hand="change `TOUCH_FULL_SCALE` in\n`touch_tables.h`"),
        "Change `TOUCH_BAUD` in `touch_board_arduino.cpp`",
        most_microphones=2,
        digital=True,
        has_bench=False,
    ),
}
"""Boards by name."""

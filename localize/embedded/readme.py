"""The README of an exported decoder: what it costs, how it is built and called, how microphones are wired to it."""

from __future__ import annotations

from localize.embedded.boards import Board
from localize.embedded.budget import Cost, in_units
from localize.embedded.converter import SampleScale
from localize.embedded.decoder_tables import EmbeddedTables
from localize.embedded.source import named_points, table_bytes
from localize.live.events import HOP
from localize.live.stream_options import BAUD
from localize.signals.stimulus import SAMPLE_RATE

#: Usual speeds of a line above that of the boards, bit/s.
_SPEEDS = (230_400, 460_800, 921_600)
#: Bytes of a frame of samples beside the samples: TOUCH_SERIAL_HEADER and TOUCH_SERIAL_RAW before them, the CRC behind.
_FRAME = 12 + 16 + 2
_TEXT = """# The decoder of {name} as C

This code locates touches on an array of {points} points. Every 16 ms it decides from the last 250 ms of the signals of
{count} microphones ({microphones}), with tables in {precision}. `acoustic-fem embed` wrote it. The decoder is
described in docs/embed.md and docs/decoder.md of that program. The code is portable C99. It uses no heap and no
recursion, its tables are constant, and it needs no library except `math.h`.

It assumes **that the sensor is as its library describes it**. So use a library that was calibrated on the sensor, not
the one that was computed from its design. The microphones are assumed to have a noise of {noise:.3g} Pa rms over 0 to
500 Hz.{sound}

| resource | at most | used for |
|---|---|---|
| flash | {flash} ({flash_bytes} bytes) | tables ({tables_share:.0f} %), code and the parts of newlib that it needs |
| RAM | {ram} ({ram_bytes} bytes) | `touch_decoder`; newlib needs 1.1 kB more for `errno`, newlib-nano 0.1 kB |
| stack | {stack_bytes} bytes | the deepest call of `touch_push` |
| instructions | {instructions} | one decision, whatever the signal; {per_second} in a second |
| | {first} more | the first decision after the start or after a gap |

Code, stack and instructions hold for gcc 12.2 with `-O2 -ffp-contract=fast`, for a Cortex-M4F. Instructions are
not cycles: a division takes about 14 cycles, and flash that is slower than the core adds wait states. Most decisions
need a third of these instructions or less, because points that cannot win are dropped early.

## Build and call

Compile `touch_decoder.c` and `touch_tables.c` with your firmware, on a core with a floating-point unit:

```sh
arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -std=c99 -O2 -ffp-contract=fast \\
    -c touch_decoder.c touch_tables.c
```

```c
#include "touch_decoder.h"

static touch_decoder decoder;             /* {ram_bytes} bytes: static, not on the stack */

static const float limit_pa = TOUCH_OVERLOAD; /* pressure from which your samples are clipped, Pa; 0 for none */

touch_init(&decoder, limit_pa);
for (;;) {{
    size_t taken = 0, count = fill(samples);   /* float, Pa, interleaved: {order}; 1 kHz each */
    while (taken < count) {{
        taken += touch_push(&decoder, samples + taken * TOUCH_MICROPHONES, count - taken);
        if (decoder.is_new && decoder.decision.state == TOUCH_TOUCHED)
            act_on(decoder.decision.point, decoder.decision.probability);
    }}
}}
```

Chunks may have any length, because a decision depends only on the samples. `decoder.decision` holds the state (no
touch, fading, sound alone, touched, unreadable), the level of the loudest microphone in Pa rms, the {top} most
probable points, numbered from 1, and the probability of every point. If samples are lost, push a NaN for each, or one
NaN if you do not know how many were lost. No frame spans them, and decisions are unreadable until a whole frame of
good samples has arrived.

## Serial line

`touch_serial.c` writes frames for a UART or a USB serial port: samples, touches and the state of the board, each with a
counter and a CRC-16. Besides its header it needs only `touch_compiler.h`. The table of bytes is in docs/serial.md of
the program:

```c
#include "touch_serial.h"

static touch_serial line;                  /* all zero */
static uint8_t frame[TOUCH_SERIAL_LARGEST];
static const uint16_t rate_hz = 1000;
static const float limit_pa = TOUCH_OVERLOAD; /* pressure from which your samples are clipped, Pa; 0 for none */

/* TOUCH_HOP samples of each microphone in Pa, interleaved; first is the number of the first one since the start */
send(frame, touch_serial_samples(&line, frame, first, rate_hz, TOUCH_MICROPHONES, TOUCH_HOP, samples, limit_pa));
```

## The whole firmware

`touch_firmware.c` sends samples, for a computer that locates touches, or with `TOUCH_EVENT_MODE` 1 the touches that
`touch_tracker.c` finds: down, moved, beat and up. Write the five functions of `touch_hal.h` for your board. The
low-pass from 16 kHz to 1 kHz is flat within 0.01 dB up to 300 Hz and attenuates by 70 dB from 612 Hz on.

{building}
On the computer, `acoustic-fem live library.nc --serial PORT` shows touches in both modes, and `acoustic-fem record`
records samples. Raw mode sends {raw_rate} bits/s with start and stop bits. {speed}

The largest sample, {largest}, is {full_scale:.4g} Pa, so a step is {step:.3g} Pa. This is
{scale_source}.

{scaling}
Samples count as clipped from {limit:.4g} Pa on.

{bench}## Microphones

The array transmits 1 to 100 Hz, so use microphones whose response is known from a few hertz up. Do not change them
after the calibration. All must be sampled at the same instants. The firmware takes 16-bit samples at 16 kHz and
decimates them itself. If you call the decoder without the firmware, give it samples at 1000 Hz:

- **Two PDM microphones** share one clock and one data line. SELECT is low at one and high at the other, so each
  transmits at its own clock edge. Four microphones need two lines on the same clock. Clock them at 1.024 MHz. Let the
  chip's filter (DFSDM or MDF on STM32, PDM on nRF) decimate to 16 kHz. Then decimate by 16, with a low-pass of 400 Hz,
  to 1 kHz.
- **Two I2S microphones** share one bus, left and right by their SELECT pin. If you have more, run the buses as slaves
  of one clock (SAI blocks in synchronous mode) or use TDM. Their lowest rate is about 8 kHz, so decimate in the same
  manner.
- **Analogue microphones** need one converter with simultaneous or scanned channels at 8 kHz or more, behind an RC
  filter of a few kHz. A scan that lasts less than 20 us is as good as simultaneous sampling.
- The order of the channels is that of the design: {order}.

Fill a buffer by DMA, one half at a time. 16 samples of each microphone are {buffer} bytes, and a decision then has
16 ms. At F MHz and one instruction per cycle it takes at most {instructions_millions:.2f} / F seconds.
"""
_BENCH = """## On the host

The test bench reads 32-bit floats and writes a line for every decision. A line holds the number of samples so far, the
state (0 to 4, in the order of `touch_state`), the level, the point and the probabilities.

```sh
cc -std=c99 -O2 touch_bench.c touch_decoder.c touch_tables.c -lm -o touch_bench
./touch_bench 16 10 < samples.f32    # 16 samples at a time; the input clips at 10 Pa
```

In Python, `signals.T.astype("<f4").tofile("samples.f32")` writes (microphone, sample) in Pa at 1 kHz.

"""
_SOUND = " Room sound of up to 80 dB SPL, which acts on all points equally, is detected and not reported as a touch."


def readme(tables: EmbeddedTables, cost: Cost, scale: SampleScale, board: Board) -> str:
    """Text of the README of a decoder and its firmware."""
    count = len(tables.microphones)
    return _TEXT.format(
        name=tables.name,
        points=tables.point_count,
        count=count,
        microphones=", ".join(tables.microphones),
        order=", ".join(tables.microphones),
        precision=tables.precision,
        noise=tables.noise_rms,
        sound="" if tables.beside is None else _SOUND,
        flash=in_units("flash", cost.flash),
        flash_bytes=cost.flash,
        tables_share=100 * table_bytes(tables) / cost.flash,
        ram=in_units("ram", cost.ram),
        ram_bytes=cost.ram,
        stack_bytes=cost.stack,
        instructions=in_units("instructions", cost.instructions),
        instructions_millions=cost.instructions / 1e6,
        per_second=in_units("instructions", int(cost.instructions * 62.5)),
        first=in_units("instructions", cost.first),
        top=named_points(tables),
        buffer=4 * HOP * count,
        building=board.building,
        bench=_BENCH if board.has_bench else "",
        largest=scale.largest,
        full_scale=scale.full_scale,
        step=scale.pascals_per_step,
        scale_source=scale.source,
        scaling=board.scaling,
        limit=min(scale.full_scale, scale.overload),
        raw_rate=raw_rate(count),
        speed=_speed(count, board),
    )


def raw_rate(microphones: int) -> int:
    """Bits a second that raw mode takes on a UART with one start and one stop bit, for a number of microphones."""
    frame = _FRAME + 2 * microphones * HOP
    return int(10 * frame * SAMPLE_RATE / HOP)


def _speed(microphones: int, board: Board) -> str:
    """Words about the speed of the line; those for a faster one depend on where the board's tools take it from."""
    needed = raw_rate(microphones)
    if needed <= BAUD:
        return f"The line runs at {BAUD}."
    faster = next(each for each in _SPEEDS if each >= needed)
    return (
        f"At {BAUD} bits/s a UART is too slow. {board.faster.format(faster=faster)}, and give `--baud {faster}` to "
        "both commands. A USB serial port needs neither."
    )

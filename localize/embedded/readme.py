"""The README of an exported decoder: what it costs, how it is built and called, how microphones are wired to it."""

from __future__ import annotations

from localize.embedded.budget import Cost, in_units
from localize.embedded.decoder_tables import EmbeddedTables
from localize.embedded.source import named_points, table_bytes
from localize.live.events import HOP

_TEXT = """# The decoder of {name} as C

Gives the touched point of an array of {points} points from its {count} microphones ({microphones}), every 16 ms
from the last 250 ms, in {precision}. Made by `acoustic-fem embed`; what the decoder is: docs/embed.md and
docs/decoder.md there.
Portable C99: no heap, no recursion, constant tables, nothing but `math.h`.

It assumes **that the sensor is as its library has it**: use a library that was calibrated on the sensor, not the one
computed from its design. It was made for microphones whose noise is {noise:.3g} Pa rms over 0 to 500 Hz.{sound}

| | most | of what |
|---|---|---|
| flash | {flash} ({flash_bytes} bytes) | tables {tables_share:.0f} %, the rest code with what it takes of newlib |
| RAM | {ram} ({ram_bytes} bytes) | `touch_decoder`; newlib keeps 1.1 kB of its own for `errno`, newlib-nano 0.1 kB |
| stack | {stack_bytes} bytes | the deepest call of `touch_push` |
| instructions | {instructions} | a decision, whatever the signal; {per_second} in a second |
| | {first} more | the first decision after the start or a gap |

Code, stack and instructions are those of gcc 12.2, `-O2 -ffp-contract=fast`, for a Cortex-M4F. They are instructions,
not cycles: a division takes some 14 of those, and flash that is slower than the core adds waits. Most decisions take a
third or less, for points that cannot win are given up early.

## Build and call

Compile `touch_decoder.c` and `touch_tables.c` with your firmware, on a core with a floating-point unit:

```sh
arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -std=c99 -O2 -ffp-contract=fast \\
    -c touch_decoder.c touch_tables.c
```

```c
#include "touch_decoder.h"

static touch_decoder decoder;             /* {ram_bytes} bytes: static, not on the stack */

touch_init(&decoder, 10.0f);              /* Pa, from which on a microphone clips; 0 if it never does */
for (;;) {{
    size_t taken = 0, count = fill(samples);   /* float, Pa, interleaved: {order}; 1000 a second of each */
    while (taken < count) {{
        taken += touch_push(&decoder, samples + taken * TOUCH_MICROPHONES, count - taken);
        if (decoder.is_new && decoder.decision.state == TOUCH_TOUCHED)
            act_on(decoder.decision.point, decoder.decision.probability);
    }}
}}
```

Chunks may have any length; a decision depends on the samples alone. `decoder.decision` holds the state (no touch,
fading, sound alone, touched, unreadable), the level of the loudest microphone in Pa rms, the {top} most probable
points, numbered from 1, and the probability of every point. If samples are
lost, push as many NaN as were lost, at least one: no frame spans them, and decisions are unreadable until a whole
frame has come again.

## On the host

A test bench that reads 32-bit floats and writes a line for every decision: samples so far, state (0 to 4, in the order
of `touch_state`), level, point, probabilities.

```sh
cc -std=c99 -O2 touch_bench.c touch_decoder.c touch_tables.c -lm -o touch_bench
./touch_bench 16 10 < samples.f32    # 16 samples at a time, clipped from 10 Pa on
```

In Python, `signals.T.astype("<f4").tofile("samples.f32")` writes (microphone, sample) in Pa at 1 kHz.

## Microphones

The array hears 1 to 100 Hz: take microphones whose response is known from a few hertz up, and keep them as the
calibration had them. All must be sampled at the same instants, at 1000 Hz:

- **Two PDM microphones** share one clock and one data line: SELECT is low at one and high at the other, and each
  speaks at an edge of its own. Four take two lines on the same clock. Clock them at 1.024 MHz and let the chip's filter
  (DFSDM or MDF on STM32, PDM on nRF) decimate to 16 kHz; then once more by 16, through a low-pass of 400 Hz, to 1 kHz.
- **I2S microphones** come two on one bus, left and right by their SELECT pin; of more, run the buses as slaves of one
  clock (SAI blocks in synchronous mode) or take TDM. They give no less than some 8 kHz: decimate the same way.
- **Analogue microphones**: one converter with simultaneous or scanned channels at 8 kHz or more, behind an RC of a few
  kHz; a scan that lasts under 20 us is as good as simultaneous.
- Samples to pascals: p = 1.41 s 10^(-S / 20), for s relative to full scale and S the sensitivity in dBFS at 94 dB SPL
  (1 Pa rms), such as -26, of data sheets whose full scale is that of a sine. The sensitivity must be the same
  as in the calibration, and so must the gains of the microphones against each other.
- Order: {order}, as they stand in the design.

Fill a buffer by DMA, half of it at a time: 16 samples of each microphone are {buffer} bytes, and a decision then has
16 ms. At F MHz and an instruction a cycle it takes at most {instructions_millions:.2f} / F seconds.
"""
_SOUND = (
    " The sound of a room up to 80 dB SPL, which presses on all points alike, is recognised, not reported as a touch."
)


def readme(tables: EmbeddedTables, cost: Cost) -> str:
    """Text of the README of a decoder."""
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
    )

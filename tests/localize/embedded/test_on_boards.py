"""The exported C on emulated boards: the decisions of Python, no more stack, flash and instructions than are told."""

import subprocess
from pathlib import Path

import numpy as np
import pytest
from embedded_bench import LARGEST, assert_agree

from benchmarks.boards import BOARDS, linked_bytes, missing_tools, run_on_board
from benchmarks.embedded_touches import LIMIT, STATES, Decided, array_of, decided_of
from localize.embedded import EmbeddedDecoder, embed

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(missing_tools() is not None, reason=f"{missing_tools()} is not installed"),
]


def exported(name: str, is_calibrated: bool, precision: str, folder: Path) -> EmbeddedDecoder:
    decoder = embed(array_of(name, is_calibrated), precision)
    for file, text in decoder.files.items():
        (folder / file).write_text(text, encoding="utf-8")
    return decoder


@pytest.mark.parametrize(
    ("board", "name", "precision", "most"),
    [
        ("mps2-an386", "array-2x6", "float32", 0.6e6),
        ("mps2-an500", "array-2x6", "float32", 0.6e6),
        ("mps2-an505", "array-2x6", "float32", 0.6e6),
        ("mps2-an386", "array-2x6", "int16", 0.8e6),
        ("mps2-an386", "line-2", "float32", 2.5e6),
        ("mps2-an386", "line-2", "int16", 2.5e6),
    ],
)
def test_a_board_decides_as_python_within_what_is_told(
    tmp_path: Path, board: str, name: str, precision: str, most: float
) -> None:
    samples, expected = decided_of(name, True, 12)
    assert len(expected.state) > 1400
    cost = exported(name, True, precision, tmp_path).cost
    found = run_on_board(tmp_path, samples.T, board, LIMIT)
    state = tuple(STATES[number] for number in found.state)
    decided = Decided(found.sample, state, found.level, found.point, found.posterior)
    assert_agree(decided, expected, samples, *LARGEST[name][precision])
    heard = found.state != STATES.index("unreadable")
    begins = np.diff(heard, prepend=False)  # the first decisions after gaps, and those that follow clipped ones
    assert found.instructions[heard & ~begins].max() < most
    assert found.instructions.max() <= cost.instructions + cost.first
    assert found.stack.max() <= cost.stack


@pytest.mark.parametrize("board", BOARDS)
@pytest.mark.parametrize("precision", ["float32", "int16"])
def test_the_cost_that_is_told_is_that_of_the_compiled_code(tmp_path: Path, board: str, precision: str) -> None:
    """With nothing given up early every decision takes what is told, and little less."""
    samples, _ = decided_of("array-2x6", True, 12)
    cost = exported("array-2x6", True, precision, tmp_path).cost
    # The second sum of sines that is as loud as it comes.
    begin = int(np.flatnonzero(np.isnan(samples[0]))[8]) + 1 + 300  # behind the quiet that follows a gap
    found = run_on_board(tmp_path, samples.T[begin : begin + 600], board, everything=True)
    assert (found.state == STATES.index("touch")).all()
    longest = found.instructions[1:].max()
    assert 0.94 * cost.instructions <= longest <= cost.instructions
    assert 0.5 * cost.first <= found.instructions[0] - longest <= cost.first
    assert 0.85 * cost.stack <= found.stack.max() <= cost.stack
    assert 0.99 * cost.flash <= linked_bytes(tmp_path, board) <= cost.flash


def test_the_decoder_needs_no_heap(tmp_path: Path) -> None:
    exported("array-2x6", False, "int16", tmp_path)
    linked_bytes(tmp_path, "mps2-an386")
    told = subprocess.run(
        ["arm-none-eabi-nm", "-u", "touch_decoder.o"], cwd=tmp_path, check=True, capture_output=True, text=True
    ).stdout.split()
    asked = {name for name in told if name != "U" and not name.startswith("touch_")}
    assert asked <= {
        "expf",
        "fmaxf",
        "fminf",
        "sqrtf",
        "frexpf",
        "ldexpf",
        "memcpy",
        "memmove",
        "memset",
        "__aeabi_l2f",
    }

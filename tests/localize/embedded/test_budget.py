"""What a decoder costs is counted as the compiler counts it; what is over a budget is refused with the number."""

import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from embedded_bench import COMPILER, needs_compiler
from refusals import refused

from geometry import Kind
from localize import ArrayResponse
from localize.embedded import Budget, Converter, Cost, LargeDecoderWarning, embed, in_units
from localize.embedded.boards import BOARDS, BoardName
from localize.embedded.readme import raw_rate

COST = Cost(flash=340_892, ram=4_100, stack=704, instructions=641_292, first=66_000)


def small(microphones: int, points: int) -> ArrayResponse:
    """An array of no design, whose points differ."""
    frequency = np.linspace(1.0, 100.0, 12)
    delay = np.random.default_rng(2).uniform(1e-3, 2e-2, (points, microphones, 1))
    names = tuple("ABCDE"[:microphones])
    gain = 0.3 * np.exp(-2j * np.pi * frequency * delay)
    return ArrayResponse(gain, frequency, np.zeros(points, int), np.arange(points), names, name="of delays */ #")


def test_a_budget_is_read_from_words() -> None:
    assert Budget.stated("flash=512k,ram=16k,instructions=2.5M") == Budget(512 * 1024, 16 * 1024, None, 2_500_000)
    assert Budget.stated("stack = 800") == Budget(stack=800)
    assert Budget.stated("flash=1M,instructions=900k") == Budget(flash=1024**2, instructions=900_000)


@pytest.mark.parametrize(
    "text", ["", "flash", "flash=", "flash=1g", "rom=3k", "ram=0", "ram=1k,ram=2k", "ram=-1k", "ram=1k,"]
)
def test_other_words_are_refused(text: str) -> None:
    with refused(Kind.OUT_OF_RANGE, "budget", text):
        Budget.stated(text)


def test_what_is_over_is_refused_with_all_its_numbers() -> None:
    with refused(Kind.UNSUITABLE, "budget") as found:
        Budget.stated("flash=256k,ram=4k,stack=704,instructions=0.64M").check(COST, "array-2x6 in float32")
    numbers = ("flash 340892 of 262144", "ram 4100 of 4096", "instructions 641292 of 640000")
    assert all(each in str(found.value) for each in numbers)
    assert "stack" not in str(found.value)
    Budget.stated("flash=333k,ram=4.1k,stack=704,instructions=0.65M").check(COST, "array-2x6 in float32")
    with refused(Kind.UNSUITABLE, "budget"):
        embed(small(2, 2), microphone_noise=1e-3, budget=Budget(flash=10_000))


def test_figures_are_told_in_units_of_data_sheets() -> None:
    assert in_units("flash", 524_288) == "512 KiB"
    assert in_units("instructions", 2_500_000) == "2.5 M"


@needs_compiler
@pytest.mark.parametrize(("microphones", "precision"), [(2, "float32"), (3, "int16"), (4, "float32")])
def test_memory_and_tables_are_what_the_compiler_makes_of_them(
    tmp_path: Path, microphones: int, precision: str
) -> None:
    decoder = embed(small(microphones, 3), precision, 1e-3)
    for name, text in decoder.files.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    names = [line.split()[3].split("[")[0].rstrip(";") for line in decoder.files["touch_tables.h"].splitlines()
             if line.startswith("extern")]  # fmt: skip
    program = "".join(f" + sizeof {name}" for name in names)
    (tmp_path / "size.c").write_text(
        f'#include "touch_decoder.h"\nint ram[sizeof(touch_decoder) == {decoder.cost.ram} ? 1 : -1];\n'
        f"int flash[0{program} == {decoder.table_bytes} ? 1 : -1];\n"
    )
    command = [str(COMPILER), "-std=c99", "-c", "size.c", "-o", "size.o"]
    made = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr


@pytest.mark.parametrize(("microphones", "faster"), [(4, False), (5, True)])
@pytest.mark.parametrize(
    ("board", "words"), [("cortex-m", "-DTOUCH_BAUD=230400"), ("zephyr", "current-speed = <230400>")]
)
def test_the_speed_of_a_line_that_is_too_slow_for_samples_is_stated(
    microphones: int, faster: bool, board: BoardName, words: str
) -> None:
    # Ten bits for each of 62.5 frames a second: 30 bytes, and 16 samples of two bytes of each microphone.
    assert raw_rate(microphones) == 625 * (30 + 32 * microphones)
    response = small(microphones, microphones)
    made = embed(response, microphone_noise=0.02, board=board, converter=Converter(full_scale=10.0))
    text = made.files["README.md"]
    assert (words in text) == ("--baud 230400" in text) == faster
    assert ("TOUCH_BAUD" in text) == (faster and board == "cortex-m")  # the source for Zephyr has no such constant


def test_a_decoder_beyond_the_linker_file_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    tight = replace(BOARDS["cortex-m"], flash=1024)
    monkeypatch.setitem(BOARDS, "cortex-m", tight)
    with pytest.warns(LargeDecoderWarning, match="linker file"):
        embed(small(2, 3), microphone_noise=0.02, converter=Converter(full_scale=10.0))

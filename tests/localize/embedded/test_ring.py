"""The ring between an interrupt and the main loop: no sample is torn or misplaced, with and without a sanitizer."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

import localize

SOURCES = Path(localize.embedded.__file__).parent / "sources"
RACE = Path(__file__).parents[2] / "support" / "ring_race.c"
COMPILERS = [name for name in ("gcc", "clang") if shutil.which(name)]
BOARD = "arm-none-eabi-gcc"
TABLES = "#define TOUCH_MICROPHONES 3\n"

pytestmark = pytest.mark.skipif(not COMPILERS, reason="there is no gcc and no clang")


def written(folder: Path) -> Path:
    """A folder with the ring of an array of three microphones."""
    for name in ("touch_ring.c", "touch_ring.h", "touch_compiler.h"):
        (folder / name).write_bytes((SOURCES / name).read_bytes())
    (folder / "touch_tables.h").write_text(TABLES, encoding="utf-8")
    return folder


def race(compiler: str, folder: Path, *options: str) -> subprocess.CompletedProcess[str]:
    command = [compiler, "-std=c11", "-Wall", "-Wextra", "-Wconversion", "-Werror", *options, "-I.", str(RACE)]
    subprocess.run([*command, "touch_ring.c", "-pthread", "-o", "race"], cwd=folder, check=True)
    done = subprocess.run(["./race"], cwd=folder, capture_output=True, text=True, check=False, timeout=300)
    if "FATAL: ThreadSanitizer: unexpected memory mapping" in done.stderr:
        pytest.skip("the addresses of this system are more random than its thread sanitizer allows")
    return done


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("options", [("-O3",), ("-O1", "-g", "-fsanitize=thread")], ids=["O3", "sanitizer"])
def test_what_a_thread_puts_another_one_gets(compiler: str, options: tuple[str, ...], tmp_path: Path) -> None:
    done = race(compiler, written(tmp_path), *options)
    assert done.returncode == 0, done.stdout + done.stderr[:2000]
    got, lost, gaps, end = map(int, done.stdout.split())
    assert got + lost == end
    assert got > 0
    assert gaps > 5


@pytest.mark.parametrize("compiler", COMPILERS)
def test_the_sanitizer_finds_a_ring_that_publishes_without_an_order(compiler: str, tmp_path: Path) -> None:
    """Counts that are volatile give the samples no order."""
    source = written(tmp_path) / "touch_ring.c"
    text = source.read_text(encoding="utf-8")
    text = text.replace("__atomic_load_n(count, __ATOMIC_ACQUIRE)", "*(const volatile uint32_t *)count")
    text = text.replace("__atomic_store_n(count, value, __ATOMIC_RELEASE)", "*(volatile uint32_t *)count = value")
    assert "__atomic" not in text
    source.write_text(text, encoding="utf-8")
    done = race(compiler, tmp_path, "-O1", "-g", "-fsanitize=thread")
    assert done.returncode != 0
    assert "data race" in done.stderr


@pytest.mark.skipif(not shutil.which(BOARD), reason=f"{BOARD} is not installed")
@pytest.mark.parametrize("core", ["cortex-m0plus", "cortex-m4", "cortex-m33"])
def test_on_a_cortex_the_order_is_a_barrier_and_no_call(core: str, tmp_path: Path) -> None:
    folder, options = written(tmp_path), ("-std=c99", "-O3", f"-mcpu={core}", "-mthumb", "-Wall", "-Wextra", "-Werror")
    subprocess.run([BOARD, *options, "-c", "touch_ring.c"], cwd=folder, check=True)
    shown = subprocess.run(
        ["arm-none-eabi-objdump", "-dr", "touch_ring.o"], cwd=folder, capture_output=True, text=True, check=True
    ).stdout
    assert "__atomic" not in shown
    assert "__sync" not in shown
    functions = [part for part in shown.split("\n\n") if part.lstrip("0123456789abcdef ").startswith("<touch_ring_")]
    assert len(functions) == 3
    for function in functions:
        # an M33 has instructions that load and store in order
        assert ("lda" in function and "stl" in function) if core == "cortex-m33" else "dmb" in function


def test_a_compiler_without_barriers_is_refused(tmp_path: Path) -> None:
    command = [COMPILERS[0], "-std=c99", "-U__GNUC__", "-E", "touch_ring.c"]
    found = subprocess.run(command, cwd=written(tmp_path), capture_output=True, text=True, check=False)
    assert found.returncode != 0
    assert "needs gcc, clang or C11 with atomics" in found.stderr


def test_c11_without_gnu_has_the_order_too(tmp_path: Path) -> None:
    source = written(tmp_path) / "touch_ring.c"
    text = source.read_text(encoding="utf-8").replace("#if defined(__GNUC__)", "#if defined(__NEVER__)")
    source.write_text(text, encoding="utf-8")
    done = race(COMPILERS[0], tmp_path, "-O3")
    assert done.returncode == 0, done.stdout

"""Sources for Zephyr and Arduino, run with stubs in place of these, send what the firmware of the host sends."""

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from embedded_bench import COMPILER, SANITIZED, STRICT, needs_compiler
from refusals import refused
from small_run import small_design

import acoustic_fem
from geometry import Kind
from localize.embedded import Converter, embed
from localize.live.serial_frames import FrameReader, StatusFrame

SUPPORT = Path(__file__).parents[2] / "support"
STUBS = SUPPORT / "board_stubs"
RAW = ("touch_firmware.c", "touch_ring.c", "touch_decimator.c", "touch_serial.c")
PLUS = shutil.which("g++") or shutil.which("clang++")
needs_plus = pytest.mark.skipif(PLUS is None, reason="there is no compiler of C++")


@pytest.fixture(scope="module")
def library():
    return acoustic_fem.solve(small_design(), np.linspace(1.0, 500.0, 20), "lumped")


@pytest.fixture(scope="module")
def samples():
    return np.random.default_rng(3).normal(0, 3000, (64 * 250, 2)).astype("<i2")


def write(folder, library, board):
    folder.mkdir()
    for name, text in embed(library, board=board).files.items():
        (folder / name).write_text(text, encoding="utf-8")
    return folder


def test_a_board_that_reads_two_microphones_is_refused_for_three():
    library = acoustic_fem.solve("glove", np.linspace(1.0, 500.0, 20), "lumped")
    with refused(Kind.UNSUITABLE, "board", "arduino"):
        embed(library, board="arduino")


def run(command, folder):
    made = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr


def sent(folder, samples, *words, **environment):
    command = ["./program", *words]
    done = subprocess.run(
        command, cwd=folder, input=samples.tobytes(), capture_output=True, env=environment, check=False
    )
    assert done.returncode == 0, done.stderr.decode()
    return done.stdout


@pytest.fixture(scope="module")
def expected(library, samples, tmp_path_factory):
    """Bytes that the firmware sends on the host."""
    folder = write(tmp_path_factory.mktemp("host") / "cortex", library, "cortex-m")
    run([COMPILER, *STRICT, "-I.", *RAW, SUPPORT / "firmware_host.c", "-o", "program"], folder)
    return sent(folder, samples, str(2**31), "1")  # a gap that never comes


@needs_compiler
def test_zephyr_sends_what_the_host_sends_and_a_block_that_is_lost_is_told(tmp_path, library, samples, expected):
    folder = write(tmp_path / "zephyr", library, "zephyr")
    assert "touch_board_mps2.c" not in {each.name for each in folder.iterdir()}
    strict = [each for each in STRICT if each not in ("-Wpedantic", "-std=c99")]
    own = ["touch_board_zephyr.c", STUBS / "zephyr_host.c"]
    run([COMPILER, *strict, "-std=c11", *SANITIZED, "-I.", f"-I{STUBS}", *RAW, *own, "-o", "program"], folder)
    assert sent(folder, samples) == expected
    reader = FrameReader()
    frames = reader.push(sent(folder, samples, STUB_FAILS="1"))
    states = [each for each in frames if isinstance(each, StatusFrame)]
    assert states[-1].lost == (64 + 240) / 16  # of 1 kHz: those that the low-pass makes of the block
    assert reader.counts.lost == 0


@needs_compiler
@needs_plus
@pytest.mark.parametrize("core", ["AVR", "MBED"])
def test_arduino_sends_what_the_host_sends(tmp_path, library, samples, expected, core):
    folder = write(tmp_path / "touch_arduino", library, "arduino")
    names = {each.name for each in folder.iterdir()}
    assert "touch_arduino.ino" in names
    assert "touch_bench.c" not in names  # the Arduino IDE compiles all that is in the folder
    run([COMPILER, *STRICT, *SANITIZED, "-I.", "-c", *RAW], folder)
    objects = [f"{Path(each).stem}.o" for each in RAW]
    strict = [each for each in STRICT if each != "-std=c99"]
    own = ["touch_board_arduino.cpp", STUBS / "arduino_host.cpp"]
    run(
        [
            PLUS,
            *strict,
            *SANITIZED,
            f"-DARDUINO_ARCH_{core}",
            "-I.",
            f"-I{STUBS / 'arduino'}",
            *objects,
            *own,
            "-o",
            "program",
        ],
        folder,
    )
    assert sent(folder, samples) == expected


@pytest.mark.filterwarnings("ignore::localize.embedded.CoarseConverterWarning")
@pytest.mark.parametrize(
    ("converter", "full_scale", "largest"),
    [
        (Converter(), 28.3, 32767),
        (Converter(volts=1.0, bits=12), 10 ** (38 / 20), 2047),
        (Converter(full_scale=10.0), 10.0, 32767),
    ],
)
def test_the_pressure_of_a_sample_follows_from_the_microphone_and_the_converter(
    library, converter, full_scale, largest
):
    made = embed(library, converter=converter)
    assert made.scale.full_scale == pytest.approx(full_scale, rel=1e-12)
    assert made.scale.pascals_per_step == pytest.approx(full_scale / largest, rel=1e-12)
    header = made.files["touch_tables.h"]
    stated = next(line for line in header.splitlines() if "define TOUCH_FULL_SCALE" in line)
    assert float(stated.split()[2].rstrip("f")) == pytest.approx(full_scale, rel=1e-6)
    assert f"#define TOUCH_LARGEST {largest} " in header
    assert f"{full_scale:.4g} Pa" in made.files["README.md"]


def test_a_converter_that_cannot_be_is_refused(library):
    with refused(Kind.MISMATCH, "full_scale", 3.0):
        Converter(volts=1.0, full_scale=3.0)
    with refused(Kind.OUT_OF_RANGE, "bits", 24):
        Converter(bits=24)
    with refused(Kind.OUT_OF_RANGE, "volts", 0.0):
        Converter(volts=0.0)
    with refused(Kind.OUT_OF_RANGE, "board", "stm32"):
        embed(library, board="stm32")


@pytest.mark.filterwarnings("ignore::localize.embedded.CoarseConverterWarning")
@pytest.mark.parametrize(("given", "field"), [({"volts": 0.5}, "volts"), ({"bits": 8}, "bits")])
@pytest.mark.parametrize("board", ["zephyr", "arduino"])
def test_boards_of_digital_microphones_take_no_voltage_and_no_bits(library, board, given, field):
    with refused(Kind.CONFLICT, field):
        embed(library, board=board, converter=Converter(**given))
    source = embed(library, board=board).scale.source
    assert "--full-scale" in source
    assert "amplify" not in source

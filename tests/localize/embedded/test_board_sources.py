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
import studies
from geometry import Kind, Refusal
from localize.embedded import Converter, embed
from localize.embedded.boards import BOARDS
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


@pytest.mark.filterwarnings("ignore::localize.embedded.CoarseConverterWarning")
@pytest.mark.parametrize("board", sorted(BOARDS))
def test_the_readme_of_a_board_names_only_what_works_there(library, board):
    files = embed(library, board=board, prefix="hand").files
    readme = files["README.md"]
    assert "--full-scale" in readme
    digital = BOARDS[board].digital
    for option, converter in (("--converter-volts", Converter(volts=0.5)), ("--converter-bits", Converter(bits=15))):
        assert (option in readme) is not digital
        if digital:
            with refused(Kind.CONFLICT):
                embed(library, board=board, converter=converter)
        else:
            embed(library, board=board, converter=converter)
    assert ("-DHAND_FULL_SCALE" in readme) is (board == "cortex-m")
    if board == "arduino":
        assert "`HAND_FULL_SCALE` in\n`hand_tables.h`" in readme
        assert "#define HAND_FULL_SCALE" in files["hand_tables.h"]
    if board == "zephyr":
        assert "`HAND_FULL_SCALE=...f` to\n`target_compile_definitions`" in readme
        assert "target_compile_definitions(app PRIVATE HAND_EVENT_MODE" in files["CMakeLists.txt"]


@needs_compiler
def test_projects_of_two_prefixes_keep_out_of_each_others_folder_and_fit_one_program(tmp_path, library):
    right, left = tmp_path / "right", tmp_path / "left"
    studies.embed_decoder(library, right, prefix="right")
    before = {each.name: each.read_bytes() for each in right.iterdir()}
    with refused(Kind.EXISTS, "out", file=right) as found:
        studies.embed_decoder(library, right, prefix="left")
    assert "right" in str(found.value)
    assert {each.name: each.read_bytes() for each in right.iterdir()} == before
    (right / "decoder-files.txt").unlink()
    with pytest.raises(Refusal):  # files of others, without the list
        studies.embed_decoder(library, right, prefix="left")
    (right / "decoder-files.txt").write_bytes(before["decoder-files.txt"])
    studies.embed_decoder(library, right, prefix="right", precision="int16")  # its own are replaced
    studies.embed_decoder(library, left, prefix="left")
    (tmp_path / "main.c").write_text(
        '#include "left_decoder.h"\n#include "right_decoder.h"\n'
        "static left_decoder left; static right_decoder right;\n"
        "int main(void) { left_init(&left, 0); right_init(&right, 0); return LEFT_POINTS - RIGHT_POINTS; }\n"
    )
    sources = [f"{name}/{name}_{part}.c" for name in ("left", "right") for part in ("decoder", "tables")]
    run([COMPILER, *STRICT, "-Ileft", "-Iright", "main.c", *sources, "-lm", "-o", "both"], tmp_path)
    run(["./both"], tmp_path)


def test_a_folder_of_a_version_without_a_list_keeps_its_project(tmp_path, library):
    (tmp_path / "touch_decoder.h").write_text("/* older */")
    with refused(Kind.EXISTS, "out", file=tmp_path):
        studies.embed_decoder(library, tmp_path, prefix="left")
    studies.embed_decoder(library, tmp_path)
    assert (tmp_path / "touch_decoder.h").read_text() != "/* older */"


def test_every_c_file_but_the_tables_includes_the_check_of_the_compiler(library):
    for board in BOARDS:
        files = embed(library, board=board).files
        sources = {name: text for name, text in files.items() if Path(name).suffix in (".c", ".cpp")}
        assert {name for name, text in sources.items() if "touch_compiler.h" not in text} == {"touch_tables.c"}

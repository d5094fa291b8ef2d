"""One reader of TOML: whatever is wrong with a file is one line that names it, in the caller's own class of errors."""

from __future__ import annotations

import subprocess
from functools import partial
from pathlib import Path

import pytest
from refusals import check_messages, refused

from acoustic_fem.calibration.manifest import ManifestError, read_manifest
from acoustic_fem.scatter.tolerances import read_tolerances
from geometry import DesignError, load_design
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import parse_json, parse_toml, read_toml
from geometry.schema.print_processes import find_process
from localize.recordings.touch_manifest import TouchManifestError, read_touch_manifest
from studies.optimization.problem import load_optimization
from studies.study.parameter import StudyError
from studies.study.study import load_study

ROOT = Path(__file__).parents[3]

READERS = {
    "design": (load_design, DesignError),
    "process": (find_process, Refusal),
    "calibration": (read_manifest, ManifestError),
    "touches": (lambda path: read_touch_manifest(path, 12), TouchManifestError),
    "study": (load_study, StudyError),
    "optimization": (load_optimization, StudyError),
    "tolerances": (read_tolerances, Refusal),
}
BROKEN = {
    "no text": b"\xff\xfe\x00",
    "no TOML": b"a = \n",
    "twice": b"a = 1\na = 2\n",
    "deep": b"a = " + b"[" * 100_000,
    "a number without end": b"a = " + b"1" * 5000,
    "a number of 5000 hexadecimal digits": b"a = 0x" + b"f" * 5000,
    "a number of 65 bits": b"a = [[9223372036854775808]]",
    "names without end": b".".join([b"a"] * 5000) + b" = 1",
    "large": b"#" * 1_000_001,
}
TEXTS: list[str | bytes] = ["[" * 100_000, "[" * 40 + "]" * 40, "1" * 5000, '{"a": 1e', b"\xff\xfe\xfd"]


@pytest.mark.parametrize("fault", BROKEN)
@pytest.mark.parametrize("kind", READERS)
def test_every_file_of_a_user_is_refused_in_one_line_that_names_it(kind: str, fault: str, tmp_path: Path) -> None:
    read, error = READERS[kind]
    path = tmp_path / "given.toml"
    path.write_bytes(BROKEN[fault])
    with refused(Kind.OUT_OF_RANGE if fault == "large" else Kind.UNREADABLE, file=path, error=error):
        read(path)


def test_messages(tmp_path: Path) -> None:
    for name, content in BROKEN.items():
        (tmp_path / name).write_bytes(content)
    cases = {name: partial(read_toml, tmp_path / name, "a file", Refusal) for name in BROKEN}
    cases |= {f"JSON {k + 1}": partial(parse_json, text, "a.json", Refusal) for k, text in enumerate(TEXTS)}
    check_messages(Path(__file__).with_name("messages_of_texts.txt"), cases, {f"{tmp_path}/": ""})


@pytest.mark.parametrize("kind", READERS)
def test_a_file_that_is_not_there_is_refused_too(kind: str, tmp_path: Path) -> None:
    read, error = READERS[kind]
    with refused(Kind.MISSING, file="none.toml", error=error):
        read(tmp_path / "none.toml")


def test_a_byte_order_mark_is_no_part_of_the_text(tmp_path: Path) -> None:
    path = tmp_path / "marked.toml"
    path.write_bytes(b"\xef\xbb\xbfa = 1\n")
    assert read_toml(path, "a file", Refusal) == {"a": 1} == parse_toml("a = 1", "text", Refusal)


@pytest.mark.parametrize("text", [*TEXTS, '{"a": -9223372036854775809}'])
def test_what_is_no_json_is_refused_in_one_line(text: str | bytes) -> None:
    with refused(Kind.UNREADABLE, file="a.json"):
        parse_json(text, "a.json", Refusal)
    assert parse_json('{"a": [1, null, 9223372036854775807]}', "a.json", Refusal) == {"a": [1, None, 2**63 - 1]}


@pytest.mark.parametrize(
    ("library", "module"),
    [
        ("tomllib|tomlkit.parse", "geometry/ground/text_files.py"),
        ("loadmat|ZipFile\\(path", "geometry/ground/array_files.py"),
        ("csv.reader", "geometry/ground/csv_files.py"),
        ("wavfile.read", "acoustic_fem/sound/sound_file.py"),
    ],
)
def test_every_kind_of_file_has_one_reader(library: str, module: str) -> None:
    modules = [module, "acoustic_fem/sound/recorded_table.py"] if library == "csv.reader" else [module]
    found = subprocess.run(
        ["git", "grep", "-l", "-E", library, "--", "geometry", "acoustic_fem", "localize", "studies"],
        cwd=ROOT, capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert sorted(found.stdout.split()) == sorted(modules)


LONG = ".".join(["a"] * 90_000)
BOMBS = {
    "a key": f"{LONG} = 1",
    "a table": f"[{LONG}]",
    "tables in a list": f"[[{LONG}]]",
    "a table in a line": f"x = {{ {LONG} = 1 }}",
    "blanks at the dots": " . ".join(["a"] * 90_000) + " = 1",
    "parts in quotes": ".".join(['"="'] * 90_000) + " = 1",
    "parts in quotes with a line separator": ".".join(['"\u2028"'] * 90_000) + " = 1",
    "parts in single quotes": ".".join(["'#'"] * 90_000) + " = 1",
    "after a text of several lines": f'x = """\n"" \\"""\n"""\n{LONG} = 1',
    "after a text with a backslash": f"x = '\\'\n{LONG} = 1",
}


@pytest.mark.parametrize("bomb", BOMBS)
def test_a_key_of_very_many_parts_is_refused_before_it_takes_memory(bomb: str) -> None:
    """The parser takes gigabytes for each of these: the test would not end."""
    with refused(Kind.UNREADABLE, file="a.toml"):
        parse_toml(BOMBS[bomb], "a.toml", Refusal)


def test_dots_that_are_of_no_key_are_read() -> None:
    many = "." * 100
    text = f'# {many}\na = "{many}"\nb = \'{many}\'\nc = [{", ".join(["1.5"] * 100)}]\nd = """\n{many}\n"""\n'
    read = parse_toml(text, "a.toml", Refusal)
    assert (read["a"], read["b"], read["c"], read["d"]) == (many, many, [1.5] * 100, f"{many}\n")


HIDDEN = {
    "a control": ('a = "x\\u001b[2J"', "a", "x\x1b[2J"),
    "a bell in a list": ('[b]\na = ["x", "\\u0007"]', "b.a.1", "\x07"),
    "a control of the second set": ('a = "\\u009b8m"', "a", "\x9b8m"),
    "a mark that turns the line": ('a = "\u202egpj.exe"', "a", "\u202egpj.exe"),
    "a mark that isolates": ('a = "\\u2066x"', "a", "\u2066x"),
    "a delete": ('a = "\\u007f"', "a", "\x7f"),
    "a name": ('[b]\n"\\u001b[8m" = 1', "b", "\x1b[8m"),
}


@pytest.mark.parametrize("what", HIDDEN)
def test_control_characters_are_refused_with_their_field(what: str) -> None:
    text, field, value = HIDDEN[what]
    with refused(Kind.UNREADABLE, field, value, file="a.toml"):
        parse_toml(text, "a.toml", Refusal)


@pytest.mark.parametrize("text", ['{"a": "\\u001b"}', '{"a": "\\ud800"}', '{"\\u202e": 1}', '["\\u0000"]', '"\\u0085"'])
def test_control_characters_in_json_are_refused(text: str) -> None:
    with refused(Kind.UNREADABLE, file="a.json"):
        parse_json(text, "a.json", Refusal)


def test_texts_of_several_lines_and_of_all_scripts_are_read() -> None:
    text = 'a = """one\ttwo\n\\r\\nשלום \u200f नमस्ते\u200d 👩\u200d🔬"""'
    assert parse_toml(text, "a.toml", Refusal)["a"].endswith("🔬")


def test_dotted_keys_are_counted_over_the_whole_file() -> None:
    key = ".".join("abcdefghij")
    parse_toml("".join(f"{key}{n} = 1\n" for n in range(100)), "a.toml", Refusal)
    with refused(Kind.UNREADABLE, file="a.toml"):
        parse_toml("".join(f"{key}{n} = 1\n" for n in range(6000)), "a.toml", Refusal)

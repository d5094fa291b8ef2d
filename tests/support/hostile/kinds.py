"""Kinds of bad input that real users' files, habits and neighbours brought, each with at least five variants."""

from __future__ import annotations

import os
import random
import shutil
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
import scipy.io.wavfile

from hostile.damage import Change, replaced, written

Words = tuple[str, ...]


class Variant(NamedTuple):
    """One variant of a kind; the fields of a :class:`hostile.cases.Case` that it needs."""

    name: str
    words: Words
    ending: str
    change: Change
    named: tuple[str, ...] = ()
    output: str = ""
    environment: tuple[tuple[str, str], ...] = ()
    limits: tuple[tuple[str, int], ...] = ()


def untouched(folder: Path, draw: random.Random) -> None:
    """Leave the files as they are."""


CHECK = ("-c", "import geometry; print(geometry.load_design('design.toml').name)")
SWEEP = ("sweep", "study.toml", "--dry-run")
SEARCH = ("optimize", "search.toml", "--out", "searched", "--workers", "1")
LOCATE = ("locate", "library.nc", "touches.wav", "--full-scale", "1")
PICTURE = (*LOCATE, "--picture", "new.png")
#: Twelve touches, enough to see how microphones are connected, and their library.
EXAMPLE = Path(__file__).parents[3] / "docs" / "examples" / "recordings"
TOML_READERS: tuple[tuple[str, Words, str], ...] = (
    ("design.toml", CHECK, ""),
    ("study.toml", SWEEP, ""),
    ("search.toml", SEARCH, "searched"),
    ("process.toml", ("-c", "import geometry; geometry.print_report({}, 'process.toml')"), ""),
    ("tolerances.toml", ("tolerance", "design.toml", "--out", "s", "--tolerances", "tolerances.toml"), "s"),
    ("calibration/calibration.toml", ("calibrate", "calibration", "--out", "made.nc"), "made.nc"),
)


# -- texts that grow ----------------------------------------------------------------------------------------------
def bombs() -> Iterator[Variant]:
    """TOML of few bytes that asks for gigabytes, and expressions that multiply."""
    parts = (100, 1_000, 10_000, 100_000)
    for name, words, output in TOML_READERS:
        for count in parts:
            for what, text in (
                ("dotted key", ".".join("a" * count) + " = 1\n"),
                ("dotted table", "[" + ".".join("a" * count) + "]\n"),
                ("dotted key in a table", "x = { " + ".".join("a" * count) + " = 1 }\n"),
                ("quoted dotted key", ".".join(['"a"'] * count) + " = 1\n"),
            ):
                yield Variant(f"{what} of {count} parts for {name}", words, "refused", written(name, text), (), output)
        for what, text in (
            ("20,000 tables", "".join(f"[t{k}]\n" for k in range(20_000))),
            ("a key 900,000 long", "a" * 900_000 + " = 1\n"),
            ("inline tables", "a = " + "{b=" * 300 + "1" + "}" * 300),
            ("arrays of tables", "[[a]]\n" * 60_000),
        ):
            yield Variant(f"{what} for {name}", words, "refused", written(name, text), (), output)
    for text in (
        '"a" * 1000000000 == "b"',
        '"a" * 99999 * 99999 == "b"',
        "[0] * 1000000000 == 1",
        "10 ** 10 ** 10 > 1",
        "(9 ** 9) ** 99999 > 1",
        "1 << 999999999 > 1",
        '"{:>999999999}".format(1) == "b"',
        "tube.length.__class__",
        "(" * 5000 + "1" + ")" * 5000,
        "-" * 50000 + "1 > 0",
        " + ".join(["tube.length"] * 20000) + " > 0",
        "tube.length > 1e999",
        "nan > 0",
        "",
    ):
        for name, words, output in TOML_READERS[1:3]:
            change = replaced(name, "[vary]", f"constraints = [{text!r}]\n[vary]")
            ending = "sane" if text.endswith("1e999") else "refused"  # infinity, which no length exceeds
            yield Variant(f"constraint {text[:40]} in {name}", words, ending, change, (), output)


# -- the environment --------------------------------------------------------------------------------------------------
def environments() -> Iterator[Variant]:
    """Variables that somebody set, and styles of pictures."""
    for name, values, ending in (
        ("COLUMNS", ("0", "-1", "1", "a", "", "99999999999999999999"), "done"),
        ("MPLBACKEND", ("", "nonsense", "module://nowhere", "tkagg", "Qt5Agg"), "sane"),
        ("SOURCE_DATE_EPOCH", ("", "now", "-1", "1e9", "9" * 5000, "1.5", "٣"), "refused"),
        ("ACOUSTIC_FEM_CACHE", ("/dev/null", "/proc/nowhere", "design.toml", "\u202ex", "a" * 300), "sane"),
        ("TMPDIR", ("/nowhere", "design.toml", "", "/proc", "a\x1bb"), "done"),
        ("TERM", ("", "dumb", "nonsense", "\x1b[31m", "xterm"), "done"),
    ):
        for value in values:
            for words in (("prototypes",), LOCATE, ("best", "results.zarr")):
                said = (name,) if ending == "refused" else ()
                environment = ((name, value),)
                yield Variant(f"{name} = {value[:20]!a}: {words[0]}", words, ending, untouched, said, "", environment)
    for line in (
        "text.usetex: True",
        "font.family: Nonsense",
        "figure.dpi: 100000",
        "backend: nonsense",
        "savefig.dpi: 1000000",
        "axes.prop_cycle: cycler('color', ['none'])",
        "figure.figsize: 10000, 10000",
        "savefig.format: pdf",
        "nonsense: 1",
        "image.cmap: nowhere",
        "\x00",
    ):
        change = written("matplotlibrc", line + "\n")
        yield Variant(f"matplotlibrc: {line[:30]!a}", PICTURE, "done", change, (), "new.png")
    for limit in (4096, 6000, 8192, 16384, 65536):  # what a command says must fit
        for words in (
            ("solve", "design.toml", "--out", "new.nc", "--fidelity", "lumped", "--frequencies", "1:100:5"),
            (*LOCATE, "--out", "new.csv"),
            PICTURE,
            ("check", "design.toml", "--out", "new.json"),
            ("convert", "library.nc", "--out", "new.npz"),
        ):
            output = words[words.index("--out") + 1] if "--out" in words else "new.png"
            variant = f"files of at most {limit} bytes: {words[0]}"
            yield Variant(variant, words, "sane", untouched, (), output, (), (("FSIZE", limit),))


# -- what is no file --------------------------------------------------------------------------------------------------
def _in_place_of(name: str, kind: str) -> Change:
    def change(folder: Path, draw: random.Random) -> None:
        path = folder / name
        if path.is_dir():
            shutil.rmtree(path)
        path.unlink(missing_ok=True)
        match kind:
            case "pipe":
                os.mkfifo(path)
            case "device":
                path.symlink_to("/dev/zero")
            case "terminal":
                path.symlink_to("/dev/tty")
            case "link to itself":
                path.symlink_to(path)
            case "folder":
                path.mkdir()
            case "link to nothing":
                path.symlink_to(folder / "nowhere")

    return change


KINDS_OF_ENTRIES = ("pipe", "device", "terminal", "link to itself", "folder", "link to nothing")


def entries() -> Iterator[Variant]:
    """Pipes, devices, links and folders where a store, a search or a log has files, and leftovers of killed calls."""
    best = ("best", "results.zarr")
    for kind in KINDS_OF_ENTRIES:
        for name in ("results.zarr/zarr.json", "results.zarr/records/study"):
            ending = "exact" if kind == "folder" else "refused"
            yield Variant(f"{kind} for {name}", best, ending, _in_place_of(name, kind), ("results.zarr",))
        change = _in_place_of("found/trials.journal", kind)
        yield Variant(f"{kind} for the journal", ("best", "found"), "refused", change, ("found",))
        for words, log in (
            (("sweep", "study.toml", "--out", "new.zarr", "--workers", "1"), "new.zarr.log"),
            (("optimize", "search.toml", "--out", "searched", "--workers", "1"), "searched.log"),
        ):
            variant = f"{kind} for {log}"
            yield Variant(variant, words, "sane", _in_place_of(log, kind), (), log.removesuffix(".log"))
        for file in ("MANIFEST.json", "design.toml", "parts/lid.stl"):
            yield Variant(
                f"{kind} for {file} of a run", ("verify", "ran"), "refused", _in_place_of(f"ran/{file}", kind), ("ran",)
            )


def manifests() -> Iterator[Variant]:
    """Lists of a run's files that are damaged or lie."""
    for what, text in (
        ("empty", ""),
        ("no JSON", "hello"),
        ("a list", "[]"),
        ("deep", "[" * 5000),
        ("a long number", '{"format": ' + "9" * 5000 + "}"),
        ("another format", '{"format": 2}'),
        ("no seal", '{"format": 1, "files": {}}'),
        ("nan", '{"format": NaN}'),
        ("controls", '{"format": "\\u001b[31m"}'),
        ("two megabytes", '"' + "a" * 2_000_000 + '"'),
    ):
        yield Variant(
            f"list of files: {what}", ("verify", "ran"), "refused", written("ran/MANIFEST.json", text), ("ran",)
        )
    for name in ("design.toml", "parts/lid.stl"):
        for data in (b"", b"x", b"soliD", b"solid\n", bytes(9999)):
            change = written(f"ran/{name}", data)
            yield Variant(f"{data[:8]!r} for {name} of a run", ("verify", "ran"), "refused", change, ("ran",))


# -- outputs ----------------------------------------------------------------------------------------------------------
def outputs() -> Iterator[Variant]:
    """Addresses instead of paths, and pictures under names of other kinds."""
    for scheme in ("s3", "gs", "http", "https", "ftp", "file", "memory"):
        for words in (
            ("sweep", "study.toml", "--workers", "1"),
            ("solve", "design.toml", "--fidelity", "lumped", "--frequencies", "1:100:5"),
            ("optimize", "search.toml", "--workers", "1"),
            LOCATE,
            ("convert", "library.nc"),
            ("parts", "design.toml", "--format", "stl"),
        ):
            suffix = {"solve": "r.nc", "locate": "r.csv", "convert": "r.npz"}.get(words[0], "r.zarr")
            out = f"{scheme}://bucket/{suffix}"
            yield Variant(f"{words[0]} --out {out}", (*words, "--out", out), "refused", untouched)
    for name in ("p.csv", "p.wav", "p.nc", "p.txt", "p.png.toml", "design.toml"):
        for words in (
            LOCATE,
            ("check", "design.toml"),
            ("track", "library.nc", "touches.wav"),
        ):
            yield Variant(f"{words[0]} --picture {name}", (*words, "--picture", name), "refused", untouched)
        yield Variant(f"wiring --out {name}", ("wiring", "4", "12", "--out", name), "refused", untouched)


# -- studies ----------------------------------------------------------------------------------------------------------
def studies() -> Iterator[Variant]:
    """Equal values of a list, no case that can be built, and cases by the million."""
    length = '"tube.length" = { from = 8, to = 30 }'
    for values in ("[12, 12]", "[12, 12.0]", "[12, 13, 12]", "[0.1, 0.1, 0.1]", "[12, 1.2e1]"):
        change = replaced("study.toml", length, f'"tube.length" = {values}')
        for words in (SWEEP, ("sweep", "study.toml", "--out", "new.zarr", "--workers", "1")):
            yield Variant(f"equal values {values}: {words[-1]}", words, "refused", change, ("study.toml",), "new.zarr")
    for values in ("[1e-6]", "[-5]", "[1e9]", "[0]", "{ from = 1e-9, to = 1e-8 }"):
        change = replaced("study.toml", length, f'"tube.length" = {values}')
        yield Variant(f"no case can be built: {values}", SWEEP, "sane", change, ())
    for count in (10**5, 10**6, 10**7, 10**9, 10**12):
        change = replaced("study.toml", "cases = 12", f"cases = {count}")
        yield Variant(f"{count} cases", SWEEP, "sane", change)
    for line in (
        '{"a": 1}',
        "[]",
        "null",
        "1",
        '"' + "a" * 100_000 + '"',
        "[" * 20_000,
        "9" * 6000,
        '{"op_code": 99}',
        '{"op_code": "x"}',
        '{"op_code": 0, "worker_id": 5}',
        '{"op_code": 4, "trial_id": 99999999}',
    ):
        change = _appended("found/trials.journal", line)
        yield Variant(f"journal line {line[:20]}", ("best", "found"), "sane", change, ("found/",))


def _appended(name: str, line: str) -> Change:
    def change(folder: Path, draw: random.Random) -> None:
        with (folder / name).open("a", encoding="utf-8") as file:
            file.write(line + "\n")

    return change


# -- recordings -------------------------------------------------------------------------------------------------------
def _wav(change_signals: str, **options: float) -> Change:
    """Puts the example with its twelve touches in place of library and recording, its signals changed."""

    def change(folder: Path, draw: random.Random) -> None:
        shutil.copy(EXAMPLE / "library.nc", folder / "library.nc")
        rate, signals = scipy.io.wavfile.read(EXAMPLE / "touches.wav")
        signals = np.array(signals, np.float32) / 32768
        match change_signals:
            case "reversed":
                signals[:, 0] *= -1
            case "both reversed":
                signals *= -1
            case "exchanged":
                signals = signals[:, ::-1]
            case "late":
                late = round(options["seconds"] * rate)
                signals[:, 1] = np.roll(signals[:, 1], late)
            case "louder":
                signals[:, 0] *= options["factor"]
            case "silent":
                signals[:, 1] = 0
        scipy.io.wavfile.write(folder / "touches.wav", rate, np.ascontiguousarray(signals))

    return change


def _header(place: bytes, value: int, added: bytes = b"") -> Change:
    """Sets the length after a chunk's name to another, with bytes before the chunk."""

    def change(folder: Path, draw: random.Random) -> None:
        path = folder / "touches.wav"
        data = path.read_bytes()
        at = data.index(place)
        path.write_bytes(data[:at] + added + data[at : at + 4] + struct.pack("<I", value) + data[at + 8 :])

    return change


def _table(text_of: str) -> Change:
    """Writes the table of samples as another program would, with half as many samples so that it is quickly read."""

    def change(folder: Path, draw: random.Random) -> None:
        lines = (folder / "touches.csv").read_text(encoding="utf-8").splitlines()
        match text_of:
            case "tabs":
                lines = [line.replace(",", "\t") for line in lines]
            case "semicolons":
                lines = [line.replace(",", ";") for line in lines]
            case "decimal commas":
                lines = [line.replace(",", ";").replace(".", ",") for line in lines]
            case "sep=":
                lines = ["sep=,", *lines]
            case "remarks":
                lines = ["# recorded in May", *lines]
            case "blank column":
                lines = [line + "," for line in lines]
            case "underscores":
                lines[5] = "0_0.1_0," + lines[5].split(",", 1)[1]
            case "other digits":
                lines[5] = "٠.١," + lines[5].split(",", 1)[1]
            case "exchanged names":
                lines[0] = "time,B,A"
            case "no time":
                lines = [line.split(",", 1)[1] for line in lines]
            case "three channels":
                lines = [line + ("," + ("C" if line.startswith("time") else "0.0")) for line in lines]
        encoding = "utf-16" if text_of == "UTF-16" else "utf-8"
        (folder / "touches.csv").write_text("\n".join(lines) + "\n", encoding=encoding)

    return change


def recordings() -> Iterator[Variant]:
    """Wrong connections, headers of recorders that died or stream, tables of other programs."""
    connected = (*LOCATE[:-1], "20")  # the full scale of the example
    named = ("reversed", "exchanged", "late", "no point explains", "louder", "silent", "dead channel")
    for what, options in (
        ("reversed", {}),
        ("exchanged", {}),
        *(("late", {"seconds": seconds}) for seconds in (0.01, 0.02, 0.05, 0.2, -0.02)),
        *(("louder", {"factor": factor}) for factor in (0.01, 0.1, 10.0, 100.0)),
        ("silent", {}),
    ):
        variant = f"{what} {' '.join(map(str, options.values()))}".strip()
        yield Variant(f"connection {variant}", connected, "noted", _wav(what, **options), named)
    for value in (0, 1, 0x7FFFF000, 0xFFFFFFFF, 20_000, 39_999):
        yield Variant(f"data length {value:x}", LOCATE, "exact", _header(b"data", value), ("touches.wav",))
    for value in (0, 8, 0xFFFFFFFF, 40_000):
        yield Variant(f"RIFF length {value:x}", LOCATE, "exact", _header(b"RIFF", value), ("touches.wav",))
    for size, added in ((3, b"LIST\x03\x00\x00\x00abc"), (5, b"junk\x05\x00\x00\x00abcde"), (0, b"LIST" + bytes(4))):
        change = _header(b"data", 40_000, added)
        yield Variant(f"odd chunk of {size} before the samples", LOCATE, "exact", change, ("touches.wav",))
    words = ("locate", "library.nc", "touches.csv", "--full-scale", "1")
    for what in (
        "tabs", "semicolons", "decimal commas", "sep=", "remarks", "blank column", "underscores", "other digits",
        "UTF-16", "three channels",
    ):  # fmt: skip
        yield Variant(f"table with {what}", words, "exact", _table(what), ("touches.csv",))


# -- solids -----------------------------------------------------------------------------------------------------------
_FAR = """
import cadquery as cq, numpy as np, acoustic_fem
from acoustic_fem.cell import port_admittance
air = cq.Workplane().box(4, 3, 2).union(cq.Workplane("YZ").circle(0.5).extrude(3.2))
medium = acoustic_fem.Medium.at(temperature_c=20, humidity=0.5)
def solved(x, y, z):
    ports = {{"mouth": (3.2 + x, y, z)}}
    options = {{"accuracy": 0.003, "fidelity": "helmholtz"}}
    return port_admittance(air.translate((x, y, z)), ports, [10.0], medium, **options)[0, 0, 0]
near, far = solved(0, 0, 0), solved(*{place})
assert abs(far / near - 1) < 1e-3, (near, far)
print("equal")
"""
_STEP = "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n{data}\nENDSEC;\nEND-ISO-10303-21;\n"


def solids() -> Iterator[Variant]:
    """Solids far from the origin, and files of solids that crash or stop their readers."""
    for place in ((60, 0, 0), (0, 100, 0), (0, 0, -500), (1000, 1000, 1000), (-60, 60, 60)):
        yield Variant(f"a solid at {place} mm", ("-c", _FAR.format(place=place)), "done", untouched)
    code = (
        "import numpy as np, acoustic_fem\nfrom acoustic_fem.cell import port_admittance\n"
        "port_admittance('bad.step', {'in': (0, 0, 1)}, [10.0], acoustic_fem.Medium.at(20.0, 0.5, 101325.0))"
    )
    for what, data in (
        ("deep parentheses", "#1 = POINT(" + "(" * 100_000 + ")" * 100_000 + ");"),
        ("open parentheses", "#1 = POINT(" + "(" * 1_000_000),
        ("a circle of references", "#1 = PRODUCT('a','a','',(#1));"),
        ("a huge number", "#1 = CARTESIAN_POINT('',(" + "9" * 100_000 + ",0.,0.));"),
        ("a long string", "#1 = PRODUCT('" + "a" * 5_000_000 + "','','',());"),
        ("nothing", ""),
    ):
        yield Variant(f"STEP with {what}", ("-c", code), "refused", written("bad.step", _STEP.format(data=data)))
    for value in ("nan", "inf", "1e308", "-1e308", "1e-320"):
        yield Variant(f"STEP with coordinates {value}", ("-c", code), "refused", _coordinates(value))


def _coordinates(value: str) -> Change:
    def change(folder: Path, draw: random.Random) -> None:
        text = (folder / "box.step").read_text(encoding="utf-8")
        (folder / "bad.step").write_text(text.replace("(-2.,-1.5,-1.)", f"({value},-1.5,-1.)"), encoding="utf-8")

    return change


# -- controls, live input ---------------------------------------------------------------------------------------------
def controls() -> Iterator[Variant]:
    """Characters that turn, break or end a line of the terminal, in texts of files."""
    old = 'name = "row-3"'
    for what, text in (
        ("escape", "\\u001b[31mred"),
        ("bell", "\\u0007"),
        ("bidi", "\\u202etxt"),
        ("line ends", "a\\nb\\rc"),
        ("title", "\\u001b]0;x\\u0007"),
        ("C1", "\\u009b31m"),
    ):
        change = replaced("design.toml", old, f'name = "{text}"')
        for words in (
            ("check", "design.toml"),
            ("solve", "design.toml", "--out", "new.nc", "--fidelity", "lumped", "--frequencies", "1:100:5"),
            SWEEP,
        ):
            yield Variant(f"{what} in a name: {words[0]}", words, "sane", change, (), "new.nc")
        study = replaced("study.toml", 'name = "bores"', f'name = "{text}"')
        yield Variant(f"{what} in a study's name", SWEEP, "sane", study)


def live() -> Iterator[Variant]:
    """Devices that are not there, and rates that none has."""
    for options in (
        ("--device", "nowhere"),
        ("--device", "nowhere, WASAPI"),
        ("--device", "-1"),
        ("--device", "99999"),
        ("--device", "\x1b[31m"),
        ("--device", "a" * 3000),
    ):
        yield Variant(f"live {options[0]} {options[1][:20]!a}", ("live", "library.nc", *options), "refused", untouched)


FAMILIES = {
    "bombs": bombs,
    "environment": environments,
    "entries that are no files": entries,
    "list of a run's files": manifests,
    "addresses and suffixes": outputs,
    "studies and journals": studies,
    "connections and recorders": recordings,
    "far solids and bad STEP": solids,
    "control characters": controls,
    "sound cards": live,
}

"""Over a thousand bad inputs: what is done to which file, the command that is given it, and how that may end."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Literal

from hostile import data_files, kinds, meshes, models, texts, uses
from hostile.damage import (
    Change,
    bit_flips,
    cut_off,
    no_file,
    noise_written,
    one_removed,
    replaced,
    without_member,
    written,
)

#: How a command may end: ``refused``; ``exact``: refused, or with what it says of the undamaged files, or with a note
#: that names the damaged one; ``sane``: refused, or done, for the change may be one that a user could have meant;
#: ``noted``: refused, or done with a note that has one of some words; ``done``: done.
Ending = Literal["refused", "exact", "sane", "noted", "done"]


@dataclass(frozen=True)
class Case:
    """One bad input."""

    group: str
    """Kind of the input, by which endings are counted."""
    name: str
    """What was done."""
    words: tuple[str, ...]
    """The command."""
    ending: Ending
    """How it may end."""
    change: Change
    """What is done to the good files before."""
    named: tuple[str, ...] = ()
    """Words of which a refusal must hold one."""
    output: str = ""
    """The file or folder that the command may write."""
    environment: tuple[tuple[str, str], ...] = ()
    """Variables that are set for it."""
    limits: tuple[tuple[str, int], ...] = ()
    """Limits of the system for it: ends of names of ``resource.RLIMIT_...``, and their values."""


#: What a library holds, told by the arrays that a user would use.
_TOLD = "import hashlib; print(hashlib.sha256(b''.join(a.tobytes() for a in arrays)).hexdigest())"


def library_told(name: str) -> tuple[str, ...]:
    """Python that loads a library and tells what it holds."""
    return (
        "-c",
        f"import acoustic_fem\nl = acoustic_fem.load({name!r})\n"
        "arrays = [l.frequency, l.transfer_function.values, l.source_response.values, l.point_impedance.values]\n"
        f"print(l.design.name, list(l.design.microphones), l.fidelity)\n{_TOLD}",
    )


def sweep_told(name: str) -> tuple[str, ...]:
    """Python that opens a sweep and tells what it holds."""
    return (
        "-c",
        f"from studies import open_sweep\nd = open_sweep({name!r}).to_xarray().load()\n"
        "held = repr([(k, d[k].values.tolist()) for k in sorted(d.variables)])\n"
        "import hashlib; print(hashlib.sha256(held.encode()).hexdigest())",
    )


def resumed(name: str) -> tuple[str, ...]:
    """Python that goes on with a sweep and tells what it then holds."""
    _, told = sweep_told(name)
    return (
        "-c",
        f"from studies import load_study, run_sweep\nrun_sweep(load_study('study.toml'), {name!r}, workers=1)\n{told}",
    )


def output_of(words: tuple[str, ...]) -> str:
    """What a command writes."""
    return next((after for word, after in pairwise(words) if word == "--out"), "")


SOLVE = ("solve", "design.toml", "--out", "new.nc", "--fidelity", "lumped", "--frequencies", "1:100:5")
CHECKED = ("-c", "import geometry; print(geometry.load_design('design.toml').name)")
LOCATE = ("locate", "library.nc", "touches.wav")
SWEEP = ("sweep", "study.toml", "--dry-run")
SEARCH = ("optimize", "search.toml", "--out", "searched", "--workers", "1")
CALIBRATE = ("calibrate", "calibration", "--out", "made.nc", "--frequencies", "5:100:8", "--fidelity", "lumped")
TRAIN = ("train", "library.nc", "--out", "trained", "--epochs", "1", "--recordings", "session/touches.toml")
PARTS = ("parts", "design.toml", "--out", "printed", "--process", "process.toml", "--format", "stl")
TOLERANCE = (
    "tolerance",
    "design.toml",
    "--out",
    "scatter",
    "--samples",
    "4",
    "--base",
    "0",
    "--frequencies",
    "1:100:4",
    "--tolerances",
    "tolerances.toml",
)

#: File, command that reads it, how the command may end when bits of it are turned, its output, how often.
_FILES: tuple[tuple[str, tuple[str, ...], Ending, str, int], ...] = (
    ("library.nc", library_told("library.nc"), "exact", "", 40),
    ("library.sofa", library_told("library.sofa"), "exact", "", 40),
    ("library.npz", library_told("library.npz"), "exact", "", 40),
    ("library.csv", library_told("library.csv"), "exact", "", 40),
    ("results.zarr", sweep_told("results.zarr"), "exact", "", 90),
    ("results.zarr", ("best", "results.zarr"), "exact", "", 30),
    ("results.zarr", resumed("results.zarr"), "exact", "results.zarr", 30),
    ("found", ("best", "found"), "exact", "", 25),
    ("localizer/localizer.json", ("locate", "localizer", "touches.wav"), "exact", "", 40),
    ("localizer", ("locate", "localizer", "touches.wav"), "exact", "", 25),
    ("decoder.onnx", ("locate", "decoder.onnx", "touches.wav"), "exact", "", 40),
    ("network.onnx", ("locate", "network.onnx", "touches.wav"), "exact", "", 25),
    ("touches.wav", LOCATE, "sane", "", 25),
    ("touches.csv", ("locate", "library.nc", "touches.csv"), "sane", "", 25),
    ("touches.npz", ("locate", "library.nc", "touches.npz"), "exact", "", 25),
    ("touches.mat", ("locate", "library.nc", "touches.mat"), "sane", "", 25),
    ("design.toml", SOLVE, "sane", "new.nc", 40),
    ("study.toml", SWEEP, "sane", "", 40),
    ("search.toml", SEARCH, "sane", "searched", 8),
    ("process.toml", ("-c", "import geometry; geometry.print_report({}, 'process.toml')"), "sane", "", 25),
    ("tolerances.toml", TOLERANCE, "sane", "scatter", 15),
    ("calibration/calibration.toml", CALIBRATE, "sane", "made.nc", 20),
    ("calibration", CALIBRATE, "sane", "made.nc", 8),
    ("session/touches.toml", TRAIN, "sane", "trained", 10),
)
#: Bytes of a WAV file that say what it is.
_WAV_HEADER = 58


def all_cases() -> list[Case]:
    """Every case, in an order that does not change."""
    return [
        *_damaged(),
        *_no_files(),
        *_texts(),
        *_archives(),
        *_recordings(),
        *_models(),
        *_designs(),
        *_options(),
        *_mismatched(),
        *_overwriting(),
        *_addresses(),
        *_solids(),
        *_bodies(),
        *_kinds(),
    ]


def _damaged() -> Iterator[Case]:
    """Bits turned, blocks of noise, ends cut off, members missing: drawn, of every kind of file."""
    for name, words, ending, output, count in _FILES:
        kind = f"damaged {name}" + (", continued" if output == "results.zarr" else "")
        named = (name.split("/")[0], name.split("/")[-1], "parts is empty")  # that of a process that is well
        for number in range(count):
            damage: tuple[str, Change]
            if number % 4 == 3:
                damage = ("cut off", cut_off(name))
            elif number % 4 == 2:
                damage = ("noise", noise_written(name))
            else:
                damage = ("bit", bit_flips(name))
            yield Case(kind, f"{damage[0]} {number}", words, ending, damage[1], named, output)
        if name in ("results.zarr", "found", "localizer"):
            for number in range(count // 2):
                yield Case(kind, f"one file missing {number}", words, ending, one_removed(name), (name,), output)
    for number in range(30):
        change = bit_flips("touches.wav", last=_WAV_HEADER)
        yield Case("damaged touches.wav", f"header {number}", LOCATE, "sane", change, ("touches.wav",))


_READERS: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("design.toml", SOLVE),
    ("design.toml", ("check", "design.toml")),
    ("design.toml", ("run", "design.toml", "--out", "ran")),
    ("process.toml", PARTS),
    ("study.toml", SWEEP),
    ("search.toml", SEARCH),
    ("tolerances.toml", TOLERANCE),
    ("calibration/calibration.toml", CALIBRATE),
    ("calibration/point-1.wav", CALIBRATE),
    ("session/touches.toml", TRAIN),
    ("session/point-01-taps-1.wav", TRAIN),
    ("library.nc", ("train", "library.nc", "--out", "trained")),
    ("library.nc", ("onnx", "library.nc", "--out", "new.onnx")),
    ("library.nc", LOCATE),
    ("library.nc", ("evaluate", "localizer", "library.nc")),
    ("library.nc", ("recalibrate", "library.nc", "touches.wav", "--out", "now.nc")),
    ("library.sofa", ("convert", "library.sofa", "--out", "new.nc")),
    ("library.npz", ("convert", "library.npz", "--out", "new.nc")),
    ("library.csv", ("convert", "library.csv", "--out", "new.nc")),
    ("touches.wav", LOCATE),
    ("touches.wav", ("live", "library.nc", "--replay", "touches.wav")),
    ("touches.wav", ("recalibrate", "library.nc", "touches.wav", "--out", "now.nc")),
    ("touches.csv", ("locate", "library.nc", "touches.csv")),
    ("touches.npz", ("locate", "library.nc", "touches.npz")),
    ("touches.mat", ("locate", "library.nc", "touches.mat")),
    ("decoder.onnx", ("locate", "decoder.onnx", "touches.wav")),
    ("decoder.onnx", ("evaluate", "decoder.onnx", "library.nc")),
    ("decoder.onnx", ("live", "decoder.onnx", "--replay", "touches.wav")),
    ("localizer/localizer.json", ("locate", "localizer", "touches.wav")),
    ("localizer/localizer.json", ("evaluate", "localizer", "library.nc")),
    ("localizer/localizer.json", ("onnx", "localizer", "--out", "new.onnx")),
    ("results.zarr/records/study", ("best", "results.zarr")),
    ("results.zarr/records/study", ("report", "results.zarr", "--out", "new.html")),
    ("found/trials.journal", ("best", "found")),
)


def _no_files() -> Iterator[Case]:
    """What is no ordinary file, or holds nothing of its kind, in the place of every file that a verb reads."""
    for name, words in _READERS:
        named = tuple(name.split("/"))
        output = output_of(words)
        for kind in ("nothing", "empty", "folder", "fifo", "zeros", "link", "itself"):
            ending: Ending = "sane" if name == "found/trials.journal" and kind == "empty" else "refused"
            if name.startswith("calibration/point"):
                ending = "exact"  # a bad recording is left out with its reason
            yield Case("no ordinary file", f"{kind} for {name}", words, ending, no_file(name, kind), named, output)
        for what, data in (("zeros inside", bytes(4096)), ("text", "Hello\n" * 40), ("html", "<html>\x00\xff</html>")):
            change, ending = written(name, data), "exact" if name.startswith("calibration/point") else "refused"
            yield Case("another kind of file", f"{what} for {name}", words, ending, change, named, output)
    for verb in (SOLVE, LOCATE, SWEEP, ("best", "results.zarr"), ("locate", "localizer", "touches.wav")):
        read = 2 if verb is LOCATE else 1
        for what, name in (
            ("a NUL", "a\0b"),
            ("a long name", "x" * 5000),
            ("lines", "a\nb\r\x1b[31mc"),
            ("none", ""),
            ("a bidi name", "\u202etxt.toml"),
            ("a deep path", "a/" * 2500 + "b"),
        ):
            words = (*verb[:read], name, *verb[read + 1 :])
            yield Case("names", f"{what} for {verb[0]}", words, "refused", uses.untouched, ())


def _texts() -> Iterator[Case]:
    """TOML that is well formed and wrong."""
    commands = {name: (words, outputs) for name, words, _, outputs, _ in _FILES if name.endswith(".toml")}
    for name, (words, output) in commands.items():
        named = (name.split("/")[-1],)
        for what, text in texts.TEXTS:
            change = written(name, text)
            yield Case("wrong TOML", f"{what} for {name}", words, "refused", change, named, output)
        for what, text in texts.ADDED:
            change = _added(name, text)
            yield Case("wrong TOML", f"{what} in {name}", words, "refused", change, named, output)
    for old, new in texts.STUDY_CHANGES:
        yield Case("wrong study", new, SWEEP, "refused", replaced("study.toml", old, new), ("study.toml",))
    for old, new in texts.MANIFEST_CHANGES:
        change = replaced("calibration/calibration.toml", old, new)
        # One recording that cannot be read is left out with its reason.
        ending: Ending = "exact" if new.startswith('1 = "') else "refused"
        named = ("calibration.toml", "point-", "nowhere", "/dev/zero", "started_late")
        yield Case("wrong manifest", new, CALIBRATE, ending, change, named, "made.nc")
    for old, new in texts.PROCESS_CHANGES:
        change = replaced("process.toml", old, new)
        yield Case("wrong process", new, PARTS, "refused", change, ("process.toml",), "printed")


def _added(name: str, text: str) -> Change:
    def change(folder: Path, draw: random.Random) -> None:
        path = folder / name
        path.write_text(text + path.read_text(encoding="utf-8"), encoding="utf-8")

    return change


def _archives() -> Iterator[Case]:
    """NPZ, CSV and netCDF that claim too much, lack something, or hold what no physics makes."""
    told = library_told
    for member in ("transfer_function_real", "source_response_imag", "frequency", "design_toml", "medium"):
        change = without_member("library.npz", f"{member}.npy")
        yield Case("wrong NPZ", f"without {member}", told("library.npz"), "refused", change, ("library.npz",))
    for what, change in data_files.NPZ_CHANGES:
        yield Case("wrong NPZ", what, told("library.npz"), "refused", change, ("library.npz",))
    for what, change in data_files.CSV_CHANGES:
        yield Case("wrong CSV", what, told("library.csv"), "refused", change, ("library.csv",))
    for what, change in data_files.NETCDF_CHANGES:
        yield Case("wrong netCDF", what, told("library.nc"), "refused", change, ("library.nc",))
    report = ("report", "results.zarr", "--out", "n.html")
    endings: tuple[Ending, Ending] = ("refused", "exact")
    for ending, changes in zip(endings, (data_files.RECORD_CHANGES, data_files.STORE_CHANGES), strict=True):
        for what, change in changes:
            for words in (sweep_told("results.zarr"), ("best", "results.zarr"), report):
                yield Case("wrong store", f"{what}: {words[0]}", words, ending, change, ("results.zarr",), "n.html")


def _recordings() -> Iterator[Case]:
    for what, change in data_files.WAV_CHANGES:
        for words in (LOCATE, ("live", "library.nc", "--replay", "touches.wav")):
            yield Case("wrong WAV", f"{what}: {words[0]}", words, "refused", change, ("touches.wav",))
    for what, change in data_files.WAVE_CHANGES:
        yield Case("wrong WAV", f"{what}: locate", LOCATE, "refused", change, ("touches.wav",))
    for name, changes in (
        ("touches.csv", data_files.TABLE_CHANGES),
        ("touches.npz", data_files.SIGNAL_CHANGES),
        ("touches.mat", data_files.MAT_CHANGES),
    ):
        for what, change in changes:
            yield Case(
                "wrong recording", f"{what} in {name}", ("locate", "library.nc", name), "refused", change, (name,)
            )


def _models() -> Iterator[Case]:
    words = ("locate", "localizer", "touches.wav")
    for what, change in models.LOCALIZER_CHANGES:
        yield Case("wrong localizer", what, words, "refused", change, ("localizer",))
    for what, change in models.ONNX_CHANGES:
        for verb in (
            ("locate", "decoder.onnx", "touches.wav"),
            ("evaluate", "decoder.onnx", "library.nc", "--touches", "2"),
        ):
            yield Case("wrong ONNX", f"{what}: {verb[0]}", verb, "refused", change, ("decoder.onnx",))


def _designs() -> Iterator[Case]:
    """Every number of a design out of its range, and of another kind."""
    for field, value in uses.design_values():
        change = uses.design_with(field, value)
        yield Case("design values", f"{field} = {value}", CHECKED, "sane", change, ("design.toml",))


def _options() -> Iterator[Case]:
    for words in uses.OPTIONS:
        yield Case("options", " ".join(words)[:80], words, "refused", uses.untouched, (), output_of(words))


def _mismatched() -> Iterator[Case]:
    for what, words, change in uses.MISMATCHED:
        yield Case("what does not belong together", what, words, "refused", change)


def _overwriting() -> Iterator[Case]:
    """Outputs on what is read, on what was measured, and into folders of others."""
    for words, change in uses.OVERWRITING:
        yield Case("outputs over inputs", " ".join(words), words, "refused", change)


def _addresses() -> Iterator[Case]:
    """Addresses of stores and sites in place of every output, and of every input that is a file."""
    for address in ("s3://bucket/a", "gs://bucket/a", "https://host/a", "file:///tmp/a", "zip::s3://bucket/a"):
        for words in (SOLVE, SEARCH, CALIBRATE, TRAIN, PARTS, TOLERANCE, ("sweep", "study.toml", "--out", "r.zarr")):
            out = words.index("--out") + 1
            place = f"{address}{Path(words[out]).suffix}"
            changed = (*words[:out], place, *words[out + 1 :])
            yield Case("addresses", f"{words[0]} --out {place}", changed, "refused", uses.untouched, ("--out",))
            source = f"{address}{Path(words[1]).suffix}"
            changed = (words[0], source, *words[2:])
            yield Case(
                "addresses", f"{words[0]} {source}", changed, "refused", uses.untouched, (address.split(":")[0],)
            )


def _solids() -> Iterator[Case]:
    for what, code in uses.SOLIDS:
        yield Case("solids", what, ("-c", code), "refused", uses.untouched)


def _bodies() -> Iterator[Case]:
    for what, name, change in meshes.BODIES:
        code = f"from geometry.body import read_body\nread_body({name!r}, least=3.0)"
        yield Case("bodies", what, ("-c", code), "refused", change, (name,))


def _kinds() -> Iterator[Case]:
    """What users' files, habits and neighbours brought."""
    for group, variants in kinds.FAMILIES.items():
        for variant in variants():
            yield Case(group, **variant._asdict())


def sample(cases: list[Case], count: int) -> list[Case]:
    """So many of the cases, of every group about its share, always the same."""
    by_group: dict[str, list[Case]] = {}
    for case in cases:
        by_group.setdefault(case.group, []).append(case)
    draw = random.Random(0)
    chosen: list[Case] = []
    for group in by_group.values():
        chosen += draw.sample(group, max(1, round(count * len(group) / len(cases))))
    return chosen[:count]

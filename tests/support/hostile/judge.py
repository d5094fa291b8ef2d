"""How commands end that were given bad input."""

from __future__ import annotations

import contextlib
import functools
import hashlib
import os
import random
import re
import shutil
import stat
import time
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from hostile.cases import Case
from hostile.commands import Commands, Ended

#: A command that takes longer hangs, s.
LONGEST = 30.0
#: What a command may hold, bytes.
MOST_MEMORY = 2 * 10**9
#: Characters of a refusal.
LONGEST_LINE = 2000
#: Age from which the time of a file tells a later change of it, ns: clocks of file systems tick every few ms.
SETTLED = 10**9
_CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f\u202a-\u202e\u2066-\u2069]")


@dataclass(frozen=True)
class Verdict:
    """How one case ended."""

    case: Case
    """The case."""
    fault: str
    """What is wrong with that: empty, or ``traceback``, ``hang``, ``memory``, ``accepted``, ``not named``, ``long``,
    ``changed an input``, ``not done``.
    """
    told: str
    """The last that the command said."""


def judged(cases: Iterable[Case], good: Path, work: Path, commands: Commands, first: int = 0) -> Iterator[Verdict]:
    """How each case ends.

    Args:
        cases: what to try.
        good: a folder of good files.
        work: an empty folder; each case finds a copy of the good files in it.
        commands: what runs them.
        first: number of the first case, from which what is drawn follows.
    """
    undamaged: dict[tuple[str, ...], str] = {}
    for number, case in enumerate(cases, first):
        if case.ending == "exact" and case.words not in undamaged:
            ended = _run(case, good, work, commands, damaged=False, seed=number)[0]
            assert ended.code == 0, (case.words, ended.err[-800:])
            undamaged[case.words] = ended.out
        ended, changed = _run(case, good, work, commands, damaged=True, seed=number)
        yield Verdict(case, _fault(case, ended, changed, undamaged.get(case.words, "")), _last(ended))


def counts(verdicts: Iterable[Verdict]) -> str:
    """A table: for every group of cases how many ended how."""
    table: dict[str, Counter[str]] = {}
    for verdict in verdicts:
        table.setdefault(verdict.case.group, Counter())[verdict.fault or "as it should"] += 1
    kinds = ["as it should", *sorted({kind for row in table.values() for kind in row} - {"as it should"})]
    width = max(len(group) for group in table)
    lines = ["  ".join([f"{'':<{width}}", *kinds])]
    lines += [
        "  ".join([f"{group:<{width}}", *(f"{row[kind]:>{len(kind)}}" for kind in kinds)])
        for group, row in table.items()
    ]
    total: Counter[str] = sum(table.values(), Counter())
    lines.append("  ".join([f"{'all':<{width}}", *(f"{total[kind]:>{len(kind)}}" for kind in kinds)]))
    return "\n".join(lines)


def _run(case: Case, good: Path, work: Path, commands: Commands, damaged: bool, seed: int) -> tuple[Ended, list[str]]:
    folder = work / "case"
    _restore(folder, good)
    if damaged:
        case.change(folder, random.Random(seed))
    before = _state(folder)
    environment = dict(case.environment) if damaged else {}
    limits = dict(case.limits) if damaged else {}
    ended = commands.run(list(case.words), folder, LONGEST, environment, limits)
    after = _state(folder)
    output = case.output.split("/")[0]
    changed = [name for name, state in before.items() if after.get(name) != state and name.split("/")[0] != output]
    return ended, changed


def _restore(folder: Path, good: Path) -> None:
    """Make a folder hold what a good one does: to copy every file for every case is slow where a disk is."""
    folder.mkdir(exist_ok=True)
    for name in {path.name for each in (folder, good) for path in each.iterdir()}:
        path, source = folder / name, good / name
        if _marks(path) == _marks(source):
            continue
        if path.is_dir() and not path.is_symlink():
            shutil.rmtree(path)
        else:
            path.unlink(missing_ok=True)
        if source.is_dir():
            shutil.copytree(source, path, symlinks=True)
        elif source.exists():
            shutil.copy2(source, path)


def _marks(top: Path) -> list[tuple[str, int, int, int]]:
    """Kind, size and time of whatever is at a path and below: who writes changes the time."""
    found = []
    with contextlib.suppress(FileNotFoundError):
        for path, status in [(str(top), top.lstat()), *_below(top)]:
            own = (0, 0) if stat.S_ISDIR(status.st_mode) else (status.st_size, status.st_mtime_ns)
            found.append((path.removeprefix(str(top)), status.st_mode, *own))
    return sorted(found)


def _state(folder: Path) -> dict[str, str]:
    """What every ordinary file holds; logs, which commands append to, left out."""
    return {
        os.path.relpath(path, folder): _digest(path, status)
        for path, status in _below(folder)
        if stat.S_ISREG(status.st_mode) and not path.endswith((".log", ".lock")) and status.st_size < 2**28
    }


def _below(folder: Path | str) -> Iterator[tuple[str, os.stat_result]]:
    """Whatever is in a folder and in those below; nothing where it is none."""
    if os.path.islink(folder) or not os.path.isdir(folder):
        return
    with os.scandir(folder) as entries:
        for entry in entries:
            yield entry.path, entry.stat(follow_symlinks=False)
            yield from _below(entry.path)


def _digest(path: str, status: os.stat_result) -> str:
    """Checksum of a file; one that nobody wrote to of late is read once for all cases."""
    written_lately = time.time_ns() - status.st_mtime_ns < SETTLED
    return _checksum(path) if written_lately else _known_checksum(path, status.st_size, status.st_mtime_ns)


def _checksum(path: str) -> str:
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


@functools.cache
def _known_checksum(path: str, size: int, written: int) -> str:
    return _checksum(path)


def _last(ended: Ended) -> str:
    lines = [line for line in (ended.err or ended.out).splitlines() if line.strip()]
    return lines[-1][:LONGEST_LINE] if lines else ""


def _fault(case: Case, ended: Ended, changed: list[str], undamaged: str) -> str:
    if not ended.in_time:
        return "hang"
    if ended.memory > MOST_MEMORY:
        return "memory"
    if "Traceback (most recent call last)" in ended.err or ended.code not in (0, 1, 2):
        return "traceback"
    if changed:
        return "changed an input"
    if case.ending == "done" and ended.code != 0:
        return "not done"
    if ended.code == 0:
        return _fault_of_acceptance(case, ended, undamaged)
    return _fault_of_refusal(case, ended)


def _fault_of_acceptance(case: Case, ended: Ended, undamaged: str) -> str:
    if case.ending == "refused" or (case.ending == "exact" and ended.out != undamaged and not _said(case, ended)):
        return "accepted"
    return "accepted" if case.ending == "noted" and not _said(case, ended) else ""


def _said(case: Case, ended: Ended) -> bool:
    """Whether what is damaged is named as such: in a note or warning, or in a table of what was left out."""
    lines = (ended.out + ended.err).splitlines()
    notes = [line for line in lines if "note" in line or "warning" in line.lower()]
    return "left out" in ended.out or any(word in line for line in notes for word in case.named)


def _fault_of_refusal(case: Case, ended: Ended) -> str:
    if ended.code == 2 and ended.err.rstrip("\n").endswith(" --help"):
        return ""
    refusals = [line for line in ended.err.splitlines() if line.startswith("acoustic-fem: ")]
    if len(refusals) != 1 or not ended.err.rstrip("\n").endswith(refusals[0]):
        return "not one line"
    if len(refusals[0]) > LONGEST_LINE or _CONTROL.search(refusals[0]):
        return "long"
    if case.named and not any(word in refusals[0] for word in case.named):
        return "not named"
    return ""

"""None of over three thousand bad inputs ends in a traceback, a hang, a changed input, or silence: a sample of them."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from filelock import FileLock
from hostile.cases import Case, all_cases, sample
from hostile.commands import Commands, commands
from hostile.good_files import PROCESS, SEARCH, STUDY, TOLERANCES, make
from hostile.judge import counts, judged
from shared import shared_folder
from small_run import small_design
from thorough import many

import geometry
import studies
from acoustic_fem.scatter.tolerances import read_tolerances
from geometry.schema.print_processes import find_process

#: Cases that are tried at every run of the slow tests, some of every group; all: python -m hostile.
SAMPLE = many(300)
#: Least variants of each kind that users' files, habits and neighbours brought.
LEAST = 5
#: Files that are only parsed, and what reads them in this process; larger ones are tried in a process with limits.
READERS: dict[str, tuple[str, Callable[[Path], object]]] = {
    "design.toml": ("", geometry.load_design),
    "study.toml": (STUDY, studies.load_study),
    "search.toml": (SEARCH, studies.load_optimization),
    "process.toml": (PROCESS, find_process),
    "tolerances.toml": (TOLERANCES, read_tolerances),
}
MOST_BYTES = 30_000


@pytest.fixture(scope="module")
def runner() -> Iterator[Commands]:
    with commands() as served:
        yield served


@pytest.fixture(scope="module")
def good(runner: Commands) -> Path:
    """Good files of every kind, made by whichever process comes first."""
    folder = shared_folder() / "good-files"
    with FileLock(folder.with_suffix(".lock")):
        if not (folder / "complete").exists():
            folder.mkdir(exist_ok=True)
            make(folder, runner)
            (folder / "complete").touch()
    return folder


def _read_file(case: Case) -> str:
    """The file of :data:`READERS` that is wrong in a case; empty where it is another."""
    named = [name for name in READERS if case.name.endswith((f" for {name}", f" in {name}"))]
    return named[0] if named else ""


def test_every_kind_has_variants_and_all_are_many() -> None:
    cases = all_cases()
    assert min(Counter(case.group for case in cases).values()) >= LEAST
    assert len(cases) >= 1500


def test_texts_that_are_wrong_are_refused_by_whoever_reads_them(tmp_path: Path) -> None:
    tried = 0
    for case in all_cases():
        name = _read_file(case)
        if case.group not in ("bombs", "wrong TOML") or case.ending != "refused" or not name:
            continue
        for other, (text, _) in READERS.items():
            (tmp_path / other).write_text(text, encoding="utf-8")
        geometry.save_design(small_design(), tmp_path / "design.toml")
        case.change(tmp_path, random.Random(0))
        if (tmp_path / name).stat().st_size > MOST_BYTES:
            continue
        tried += 1
        with pytest.raises(geometry.Refusal) as found:
            READERS[name][1](tmp_path / name)
        assert "\n" not in str(found.value), case
    assert tried > 80


@pytest.mark.slow
def test_many_bad_inputs_end_in_one_line_each(good: Path, tmp_path: Path, runner: Commands) -> None:
    verdicts = list(judged(sample(all_cases(), SAMPLE), good, tmp_path, runner))
    print(counts(verdicts))
    bad = [f"{v.fault}: {v.case.group}: {v.case.name}: {v.told}" for v in verdicts if v.fault]
    assert bad == []

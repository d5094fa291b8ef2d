"""None of a sample of over two thousand bad inputs ends in a traceback, a hang, a changed input, or silence."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from filelock import FileLock
from hostile.cases import all_cases, sample
from hostile.commands import Commands, commands
from hostile.good_files import make
from hostile.judge import counts, judged
from shared import shared_folder
from thorough import many

#: Cases that are tried at every run of the slow tests, some of every group; all: python -m hostile.
SAMPLE = many(120)


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


@pytest.mark.slow
def test_many_bad_inputs_end_in_one_line_each(good: Path, tmp_path: Path, runner: Commands) -> None:
    verdicts = list(judged(sample(all_cases(), SAMPLE), good, tmp_path, runner))
    print(counts(verdicts))
    bad = [f"{v.fault}: {v.case.group}: {v.case.name}: {v.told}" for v in verdicts if v.fault]
    assert bad == []

"""An environment that holds what the core of the package requires and nothing else, made of what is installed."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from importlib.metadata import Distribution, distribution
from pathlib import Path

from packaging.requirements import Requirement

ROOT = Path(__file__).parents[2]


def core_distributions() -> dict[str, Distribution]:
    """Installed distributions that the core requires, directly or through others, by name."""
    found: dict[str, Distribution] = {}
    waiting = list(_required(distribution("acoustic-fem"), frozenset()))
    while waiting:
        requirement = waiting.pop()
        if requirement.name not in found:
            found[requirement.name] = distribution(requirement.name)
        waiting += [
            each for each in _required(found[requirement.name], frozenset(requirement.extras)) if each.name not in found
        ]
    return found


def _required(owner: Distribution, extras: frozenset[str]) -> Iterator[Requirement]:
    for line in owner.requires or ():
        requirement = Requirement(line)
        if requirement.marker is None or any(requirement.marker.evaluate({"extra": e}) for e in {"", *extras}):
            yield requirement


def link_core(folder: Path) -> Path:
    """Fill an empty folder with links to all that the core requires; to be put on the path of a bare interpreter."""
    for owner in core_distributions().values():
        tops = {path.parts[0] for path in owner.files or () if ".." not in path.parts}
        for top in tops - {"__pycache__"}:
            target = Path(str(owner.locate_file(top)))
            if target.exists() and not (folder / top).exists():
                (folder / top).symlink_to(target)
    return folder


def megabytes() -> float:
    """Size of all files that the core requires, compiled modules as they are installed included, MB."""
    return (
        sum(
            Path(str(owner.locate_file(path))).stat().st_size
            for owner in core_distributions().values()
            for path in owner.files or ()
            if Path(str(owner.locate_file(path))).is_file()
        )
        / 1e6
    )


def acoustic_fem_of_core(core: Path, *arguments: str | Path, folder: Path) -> subprocess.CompletedProcess[str]:
    """Run the command line with the core alone.

    Args:
        core: folder of :func:`link_core`.
        arguments: of the command line.
        folder: to run in.
    """
    return subprocess.run(
        [sys.executable, "-S", "-m", "studies.cli", *map(str, arguments)],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT), str(core)])},
        capture_output=True,
        encoding="utf-8",
        check=False,
    )

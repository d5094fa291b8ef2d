"""An environment that holds what the core of the package requires and nothing else, made of what is installed."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tomllib
from collections.abc import Iterable, Iterator
from importlib.metadata import Distribution, distribution
from pathlib import Path

from packaging.requirements import Requirement

ROOT = Path(__file__).parents[2]


def core_distributions(*extras: str) -> dict[str, Distribution]:
    """Installed distributions that the core and some extras require, directly or through others, by name."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    found: dict[str, Distribution] = {}
    waiting = [*_needed(project["dependencies"], frozenset()), Requirement(f"acoustic-fem[{','.join(extras)}]")]
    while waiting:
        requirement = waiting.pop()
        if requirement.name == "acoustic-fem":  # of this tree, not of what is installed
            for each in requirement.extras:
                waiting += _needed(project["optional-dependencies"][each], frozenset())
            continue
        if requirement.name not in found:
            found[requirement.name] = distribution(requirement.name)
        lines = found[requirement.name].requires or []
        waiting += [each for each in _needed(lines, frozenset(requirement.extras)) if each.name not in found]
    return found


def _needed(lines: Iterable[str], extras: frozenset[str]) -> Iterator[Requirement]:
    for line in lines:
        requirement = Requirement(line)
        if requirement.marker is None or any(requirement.marker.evaluate({"extra": e}) for e in {"", *extras}):
            yield requirement


def link_core(folder: Path, *extras: str) -> Path:
    """Fill a new folder with links to all that the core requires; to be put on the path of a bare interpreter.

    Args:
        folder: the new one, or an empty one.
        extras: of the installation, which it has too.
    """
    folder.mkdir(exist_ok=True)
    for owner in core_distributions(*extras).values():
        tops = {path.parts[0] for path in owner.files or () if ".." not in path.parts}
        for top in tops - {"__pycache__"}:
            target = Path(str(owner.locate_file(top)))
            if target.exists() and not (folder / top).exists():
                (folder / top).symlink_to(target)
    return folder


def megabytes_on_disk(core: Path, folder: Path) -> float:
    """What ``du`` says of the site-packages of the core without pip, MB, all modules compiled as pip leaves them.

    Args:
        core: folder of :func:`link_core`.
        folder: an empty one, for what is ours.
    """
    (folder / "core").symlink_to(core)
    for package in ("geometry", "acoustic_fem", "localize", "studies"):
        shutil.copytree(ROOT / package, folder / package, ignore=shutil.ignore_patterns("__pycache__", "page"))
    subprocess.run([sys.executable, "-m", "compileall", "-q", str(folder)], check=True)
    said = subprocess.run(["du", "-skL", str(folder)], capture_output=True, text=True, check=True)
    return int(said.stdout.split()[0]) * 1024 / 1e6


def acoustic_fem_of_core(core: Path, *arguments: str | Path, folder: Path) -> subprocess.CompletedProcess[str]:
    """Run the command line with the core alone.

    Args:
        core: folder of :func:`link_core`.
        arguments: of the command line.
        folder: to run in.
    """
    return python_of_core(core, "-m", "studies.cli", *map(str, arguments), folder=folder)


def python_of_core(core: Path, *arguments: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Run Python with the core alone; as :func:`acoustic_fem_of_core`."""
    return subprocess.run(
        [sys.executable, "-S", *arguments],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT), str(core)])},
        capture_output=True,
        encoding="utf-8",
        check=False,
    )

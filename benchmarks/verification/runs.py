"""All subjects of the page, run one after the other."""

from __future__ import annotations

import json
import platform
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from acoustic_fem.numerics.linear_solver import backend
from benchmarks.verification import bends, cells, ducts, lines, membranes, openwind_tubes, page, solids
from benchmarks.verification.report import Report, Subject, from_json, to_json

COMMAND = "python -m benchmarks.verification --out docs"

#: In the order of the page.
SUBJECTS: dict[str, Callable[[bool], Subject]] = {
    "ducts": ducts.run,
    "openwind": openwind_tubes.run,
    "sections": lines.sections,
    "tapers": lines.tapers,
    "springs": lines.springs,
    "bends": bends.run,
    "tubes": solids.tubes,
    "heat": solids.heat,
    "sums": solids.sums,
    "cell": cells.cell,
    "openings": cells.openings,
    "arrays": cells.arrays,
    "membranes": membranes.run,
}

#: Subjects that take longer than seconds: no part of a quick run.
FULL_ONLY = ("bends", "sums", "cell", "arrays")

_LIBRARIES = ("numpy", "scipy", "scikit-fem", "gmsh", "cadquery", "mpmath", "openwind", "mkl")


def run(names: Sequence[str], quick: bool, say: Callable[[str], None] = lambda text: None) -> Report:
    """Compute subjects by name.

    Args:
        names: keys of SUBJECTS.
        quick: coarse meshes only.
        say: called with a line per subject.
    """
    subjects, started = [], time.process_time()
    for name in names:
        start = time.process_time()
        subject = SUBJECTS[name](quick)
        subjects.append(replace(subject, seconds=time.process_time() - start))
        say(f"{name}: {subjects[-1].seconds:.1f} s")
    return Report(
        command=COMMAND,
        versions={"Python": platform.python_version()} | _versions(),
        solver={"pardiso": "MKL PARDISO", "superlu": "SuperLU"}[backend()],
        seconds=time.process_time() - started,
        subjects=tuple(subjects),
    )


def save(report: Report, folder: Path) -> None:
    """Write page, figures and numbers; the page is made from the numbers as they are stored."""
    folder.mkdir(parents=True, exist_ok=True)
    text = json.dumps(to_json(report), indent=1, ensure_ascii=False) + "\n"
    (folder / "verification.json").write_text(text, encoding="utf-8")
    page.write(from_json(json.loads(text)), folder)


def _versions() -> dict[str, str]:
    found = {}
    for name in _LIBRARIES:
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            continue
    return found

"""Three jobs of a designer, each from an empty folder with the commands of its script: outcome and time.

    python -m benchmarks.jobs            # prints the table; one to two minutes of one core

The scripts are docs/examples/jobs/*.sh. Times are of the processor, of each command with its start; those of the
wall stand beside them, and mean something only if nothing else runs.
"""

from __future__ import annotations

import os
import re
import resource
import shlex
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).parents[1] / "docs" / "examples" / "jobs"
JOBS = ("pad", "wristband", "mat")


@dataclass(frozen=True)
class Step:
    """One command of a job."""

    command: str
    """The command, as the script states it."""
    code: int
    """Exit code."""
    out: str
    """Text on stdout."""
    err: str
    """Text on stderr."""
    processor: float
    """Processor time, s."""
    wall: float
    """Time on the clock, s."""

    @property
    def outcome(self) -> str:
        """Verdict that ``check`` printed, else the line in which a command was refused, else nothing."""
        if self.code:
            return self.err.strip().splitlines()[-1]
        found = re.search(r"^.*(does not work|marginal|works).*$", self.out, re.MULTILINE)
        return found.group(1) if found and " check " in self.command else ""


def commands(name: str) -> list[str]:
    """Commands of the script of a job."""
    lines = (FOLDER / f"{name}.sh").read_text(encoding="utf-8").splitlines()
    return [line for line in lines if line.startswith("acoustic-fem ")]


def run_job(name: str, folder: Path) -> list[Step]:
    """Run the commands of a job in a folder, one after the other, whatever each ends with."""
    steps = []
    for command in commands(name):
        words = [sys.executable, "-m", "studies.cli", *shlex.split(command)[1:]]
        before, begun = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        ended = subprocess.run(words, cwd=folder, capture_output=True, text=True, env=_environment(), check=False)
        wall, after = time.perf_counter() - begun, resource.getrusage(resource.RUSAGE_CHILDREN)
        processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        steps.append(Step(command, ended.returncode, ended.stdout, ended.stderr, processor, wall))
    return steps


def _environment() -> dict[str, str]:
    root = str(Path(__file__).parents[1])
    paths = [root, *filter(None, os.environ.get("PYTHONPATH", "").split(os.pathsep))]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(paths), "COLUMNS": "200"}


def main() -> None:
    """Print the table."""
    print("| job | command | exit code | processor (s) | wall (s) | outcome |\n|---|---|---|---|---|---|")
    for name in JOBS:
        with tempfile.TemporaryDirectory() as folder:
            for step in run_job(name, Path(folder)):
                command = step.command.replace("|", "\\|")
                print(
                    f"| {name} | `{command}` | {step.code} | {step.processor:.1f} | {step.wall:.1f} | {step.outcome} |",
                    flush=True,
                )


if __name__ == "__main__":
    main()

"""All parts of a sensor with their reports, from the command line: processor time.

``python benchmarks/parts.py`` prints it for the smallest and the largest prototypes.
"""

from __future__ import annotations

import resource
import subprocess
import sys
import tempfile
from pathlib import Path

PROTOTYPES = ("line-2", "array-2x6", "large-area-64")


def seconds(name: str) -> float:
    """Total of the verb and its child processes, its imports included."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:
        program = (sys.executable, "-m", "studies.cli", "parts", name, "--out", str(Path(folder) / "parts"))
        subprocess.run(program, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> None:
    print("| prototype | processor time (s) |")
    print("|---|---|")
    for name in PROTOTYPES:
        print(f"| {name} | {seconds(name):.0f} |", flush=True)


if __name__ == "__main__":
    main()

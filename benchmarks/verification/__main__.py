"""Write the verification page: every number on it is computed by this run.

    python -m benchmarks.verification [--out docs] [--quick] [--only SUBJECT ...]

Run from the checkout with the extras dev and verify installed. Writes verification.md, verification.json and
images/verification-*.png below the folder. ``--quick`` takes the coarse meshes only: seconds, not for the page.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from pathlib import Path

from threadpoolctl import threadpool_limits

from benchmarks.verification.runs import FULL_ONLY, SUBJECTS, run, save


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.verification", description="Write the verification page by running it."
    )
    parser.add_argument("--out", type=Path, default=Path("docs"), help="folder of the page (default: docs)")
    parser.add_argument("--quick", action="store_true", help="coarse meshes only, in seconds")
    parser.add_argument("--only", nargs="+", choices=sorted(SUBJECTS), metavar="SUBJECT", help=", ".join(SUBJECTS))
    options = parser.parse_args(arguments)
    if options.quick or options.only:
        page = options.out / "verification.md"
        if options.out.resolve() == Path("docs").resolve():
            parser.error(f"a part of the page would replace the whole of it in {page}: give another --out")
    # Cells are solved, not read from the cache of an earlier run.
    with tempfile.TemporaryDirectory() as cache, threadpool_limits(1):
        os.environ["ACOUSTIC_FEM_CACHE"] = cache
        names = options.only or [name for name in SUBJECTS if not (options.quick and name in FULL_ONLY)]
        report = run(names, options.quick, lambda text: print(text, file=sys.stderr, flush=True))
    save(report, options.out)
    missed = [study.title for study in report.studies.values() if not study.as_expected]
    missed += [check.what for check in report.checks.values() if not check.met]
    for what in missed:
        print(f"missed: {what}", file=sys.stderr)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())

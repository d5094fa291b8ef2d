"""Every bad input, or those of some groups, one line each and a table: ``python -m hostile [GROUP ...]``.

Run from the root of a checkout with ``PYTHONPATH=.:tests/support``; half an hour for all on an idle core.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

from hostile.cases import all_cases
from hostile.commands import commands
from hostile.good_files import make
from hostile.judge import counts, judged


def main(groups: list[str]) -> int:
    """Exit code: 1 where any input ends as it should not."""
    cases = [case for case in all_cases() if not groups or any(group in case.group for group in groups)]
    with tempfile.TemporaryDirectory() as folder, commands() as runner:
        good, work = Path(folder) / "good", Path(folder) / "work"
        good.mkdir()
        work.mkdir()
        make(good, runner)
        verdicts = []
        for number, verdict in enumerate(judged(cases, good, work, runner), start=1):
            verdicts.append(verdict)
            if verdict.fault:
                case = verdict.case
                print(
                    f"{number} of {len(cases)}: {verdict.fault}: {case.group}: {case.name}: {verdict.told}", flush=True
                )
    print(counts(verdicts))
    return int(any(verdict.fault for verdict in verdicts))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

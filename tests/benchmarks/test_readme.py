"""The figures of README are those of its command, within what other seeds and machines may change."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from benchmarks import readme

PAGE = Path(__file__).parents[2] / "README.md"
#: Points by which accuracies on fewer taps and rigs may differ from the page: two deviations of 25 taps at 12 points of
#: two sensors.
RANGE = 1.5


@pytest.mark.slow
def test_accuracies_are_those_of_the_page() -> None:
    cell = r" \| ([\d.]+) \(([\d.]+)\)"
    rows = re.findall(
        rf"^\| (nominal|as built, \w+).*?{cell}{cell} \|$", PAGE.read_text(encoding="utf-8"), re.MULTILINE
    )
    stated = {name: dict(zip(readme.KINDS, (figures[:2], figures[2:]), strict=True)) for name, *figures in rows}
    found = readme.finger_accuracy(25, readme.RIGS[:2])
    for name, by_kind in (
        ("nominal", found.nominal), ("as built, with", found.as_built), ("as built, calibrated", found.calibrated)
    ):  # fmt: skip
        for kind, values in by_kind.items():
            mean, worst = map(float, stated[name][kind])
            assert 100 * np.mean(values) == pytest.approx(mean, abs=RANGE), (name, kind)
            assert 100 * np.min(values) > worst - RANGE, (name, kind)

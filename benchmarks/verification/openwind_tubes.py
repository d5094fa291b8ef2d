"""Tubes, a ladder of tubes and a cone against OpenWind, computed live with the same air."""

from __future__ import annotations

import json
from importlib.util import find_spec
from pathlib import Path

import numpy as np

from acoustic_fem.quantities.medium import Medium
from benchmarks.verification.report import Check, Subject, Table
from tests.support import openwind_ladder

TEXT = """The input impedance of tubes with a closed end is compared with
[OpenWind](https://openwind.inria.fr) {version} (INRIA; GPL-3, extra `verify`). OpenWind runs with `losses="bessel"` and
without junction masses, and both programs use the air of its `Physics(20)`. OpenWind solves tubes by transfer matrices,
and the cone by finite elements of order 8. Each row holds the largest relative difference over {frequencies} Hz.
{source}."""

_TARGET = 1e-9
_STORED = Path(openwind_ladder.__file__).parents[1] / "reference" / "openwind.json"


def available() -> bool:
    """True if OpenWind is installed."""
    return find_spec("openwind") is not None


def run(quick: bool) -> Subject:
    """Differences of the input impedances; a quick run takes the stored numbers where OpenWind is missing.

    Raises:
        RuntimeError: a full run without OpenWind.
    """
    if available():
        numbers, source = openwind_ladder.reference(), "Both programs computed in this run"
    elif quick:
        numbers, source = (
            json.loads(_STORED.read_text(encoding="utf-8")),
            f"The values of OpenWind come from tests/reference/{_STORED.name}",
        )
    else:
        raise RuntimeError('the page compares with OpenWind: python -m pip install -e ".[verify]"')
    frequency, air = np.array(numbers["frequency"]), Medium(**numbers["air"])
    checks, table = [], []
    for case in numbers["cases"]:
        theirs = np.array([complex(*pair) for pair in case["impedance"]])
        difference = np.abs(openwind_ladder.driven_impedance(case["pieces"], frequency, air) / theirs - 1)
        checks.append(Check(f"openwind {case['name']}", case["name"], "OpenWind", float(difference.max()), _TARGET))
        table.append((case["name"], *(f"{value:.0e}" for value in difference)))
    text = TEXT.format(
        version=numbers["versions"]["openwind"], frequencies=", ".join(f"{f:g}" for f in frequency), source=source
    )
    header = ("case", *(f"{f:g} Hz" for f in frequency))
    return Subject(
        "openwind",
        "OpenWind",
        text,
        (),
        tuple(checks),
        (Table("Relative difference", header, tuple(table), detail=True),),
    )

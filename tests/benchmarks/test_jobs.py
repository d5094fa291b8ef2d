"""The three jobs of a designer end as they should, from an empty folder and with the commands of their scripts only."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import geometry
import studies
from benchmarks.jobs import Step, run_job
from geometry.layout import array_size
from geometry.stock import catalogue


def ended(name: str, folder: Path) -> list[Step]:
    """Steps of a job, with the processor time of each printed: it is no matter of a test."""
    steps = run_job(name, folder)
    for step in steps:
        print(f"{step.command}: {step.processor:.1f} s of processor time")
    return steps


@pytest.mark.slow
@pytest.mark.physics
def test_the_pad_of_a_gripper_works_within_its_size_and_of_parts_to_buy(tmp_path: Path) -> None:
    new, check = ended("pad", tmp_path)
    assert (new.code, check.code) == (0, 0), new.err + check.err
    assert check.out.startswith("pad: works\n")
    assert new.err.startswith("search: ")
    pad = geometry.load_design(tmp_path / "pad.toml")
    assert (pad.point_count, len(pad.microphones), pad.printing.process) == (16, 2, "sla-resin")
    assert max(array_size(pad)[:2]) <= 30.01
    assert catalogue().fit(pad).bought
    assert studies.Verdict(pad).figures.taps >= 0.98


@pytest.mark.slow
@pytest.mark.physics
def test_the_wristband_is_a_ring_of_ten(tmp_path: Path) -> None:
    new, check = ended("wristband", tmp_path)
    assert (new.code, check.code) == (0, 0), new.err + check.err
    assert check.out.startswith("band: works\n")
    band = geometry.load_design(tmp_path / "band.toml")
    assert (band.point_count, band.layout.kind, band.layout.columns) == (10, "cylinder", 10)
    assert band.layout.diameter == pytest.approx(160 / 3.14159, abs=0.01)
    assert catalogue().fit(band).bought


@pytest.mark.slow
@pytest.mark.physics
def test_the_mat_is_refused_in_a_line_that_says_what_works(tmp_path: Path) -> None:
    refused, new, check = ended("mat", tmp_path)
    assert refused.code == 1
    line = refused.err.strip().splitlines()[-1]
    assert "has no design that works: " in line
    remedy = line.partition("; try ")[2].partition(", or ")[0]
    told = dict(re.findall(r"(--[a-z]+)='?([^']+?)'?(?= and |$)", remedy))
    assert told, line
    given = dict(re.findall(r"(--[a-z]+) \"?([^\"]+?)\"?(?= --|$)", new.command))
    assert told.items() <= given.items()  # the second command is what the first one suggests
    assert (new.code, check.code) == (0, 0), new.err + check.err
    assert check.out.startswith("mat: works\n")
    assert not list(tmp_path.glob("*.new"))

"""How many processors a team of workers may count on."""

from pathlib import Path

import pytest

from acoustic_fem.numerics.processors import cores


def test_a_process_that_is_bound_to_some_processors_has_those(monkeypatch, tmp_path):
    monkeypatch.setattr("os.sched_getaffinity", lambda _: {1, 4, 6}, raising=False)
    monkeypatch.setattr("acoustic_fem.numerics.processors._SHARE", tmp_path / "none")
    assert cores() == 3


@pytest.mark.parametrize(
    ("share", "count"),
    [("max 100000", 64), ("200000 100000", 2), ("150000 100000", 2), ("5000 100000", 1), ("nonsense", 64)],
)
def test_a_container_has_its_share(monkeypatch, tmp_path: Path, share: str, count: int):
    (tmp_path / "cpu.max").write_text(share)
    monkeypatch.setattr("os.sched_getaffinity", lambda _: set(range(64)), raising=False)
    monkeypatch.setattr("acoustic_fem.numerics.processors._SHARE", tmp_path / "cpu.max")
    assert cores() == count


def test_cells_and_sweeps_ask_the_same_function():
    from acoustic_fem.cell import design_cells
    from studies.sweep import cost, workers

    assert design_cells.cores is cost.cores is workers.cores is cores

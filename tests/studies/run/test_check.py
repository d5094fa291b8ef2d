"""Check of a design before it is solved: the drawn parts fit together, or the obstacle is named."""

import pytest
from refusals import refused

from geometry import prototype
from geometry.ground.refusal import Kind, Refusal
from geometry.layout.overlaps import OverlapError
from geometry.pictures import mold_cut, viewer, views
from geometry.stock import VARIABLE
from studies.cli.check_tables import show_check
from studies.kit.making import export_parts
from studies.metrics import coverage
from studies.run.check import check_design
from studies.run.pipeline import run_design
from studies.study.study import read_study
from studies.sweep.survey import surveyed

AXES = '[vary]\n"tube.length" = [20.0, 21.0]\n'
#: They take ``array_model`` when they are first imported: here, before a test replaces it.
DRAWING = (mold_cut, viewer, views)
NARROW = {"layout": {"kind": "cylinder", "columns": 6, "diameter": 9.0}, "lines.0.points": 4}


@pytest.mark.slow
def test_parts_in_each_others_way_are_named_by_check(capsys):
    found = check_design(prototype("array-2x6").with_values(NARROW))
    assert any(line.startswith("shell 1 and shell 4 are in each other's way: they share ") for line in found.misfits)
    assert found.to_dict()["misfits"] == list(found.misfits)
    assert (found.error.file, [str(problem) for problem in found.error.problems[1:]]) == (
        "array-2x6", [f"array-2x6: {line}" for line in found.overlaps[1:]],
    )  # fmt: skip
    assert "layout.diameter" in found.error.remedy
    show_check(found)
    printed = capsys.readouterr().out
    lines = printed[printed.index("array-2x6: cannot be built") :].splitlines()
    listed = found.overlaps if len(found.overlaps) > 1 else ()  # the verdict states a single one
    assert lines[1 : len(listed) + 1] == [f"- {line}" for line in listed]
    assert lines[len(listed) + 1] == f"- {found.mend}"
    assert f"note: {found.misfits[0]}" in printed
    assert printed.count(" are in each other's way") == min(len(found.misfits), 10)


@pytest.mark.slow
def test_check_parts_run_and_sweep_count_the_same_problems(tmp_path):
    design = prototype("array-2x6").with_values(NARROW)
    found = check_design(design)
    study = read_study('base = "array-2x6"\nfidelity = "lumped"\nmetrics = ["volume"]\n' + AXES, base=design)
    for call in (
        lambda: export_parts(design, tmp_path / "out"),
        lambda: run_design(design, tmp_path / "out"),
        lambda: surveyed(study),
    ):
        with refused(Kind.CONFLICT, error=OverlapError, file="array-2x6") as error:
            call()
        assert [problem.problem for problem in error.value.others] == list(found.overlaps[1:])
        assert found.overlaps[0] in str(error.value)
        assert found.mend in str(error.value)


@pytest.mark.slow
def test_cells_too_large_for_a_mesh_are_lumped_and_the_check_says_why(monkeypatch, capsys):
    monkeypatch.setattr("studies.run.check.is_installed", lambda extra: False)
    wide = {"resonator.cavity_diameter": 50.0, "resonator.cavity_height": 20.0, "lines.0.points": 2}
    found = check_design(prototype("array-2x6").with_values({**wide, "layout.columns": 2}), quality=False)
    assert found.fidelity.name == "lumped"
    assert all(level < 0 for _, level, _ in found.attenuation)
    assert found.fidelities[-1].startswith("navier-stokes, the default: not for this design: resonator 50 x 20 mm")
    show_check(found)
    shown = " ".join(capsys.readouterr().out.split())  # other tests may state a width, by which lines are broken
    assert " ".join(f"transfer functions are {found.fidelity.words}".split()) in shown


def test_coverage_is_that_of_the_contact_of_the_target(monkeypatch):
    monkeypatch.setattr("studies.run.check.is_installed", lambda extra: False)
    design = prototype("array-2x6").with_values({"target.contact_radius": 3.0})
    found = check_design(design, quality=False)
    assert found.coverage == coverage(design, 3.0)
    assert "a contact of 3 mm radius" in found.covered


def test_a_wrong_file_of_parts_is_refused_before_any_work(monkeypatch, tmp_path):
    (tmp_path / "bad.toml").write_text("[[spring]]\n")
    monkeypatch.setenv(VARIABLE, str(tmp_path / "bad.toml"))
    monkeypatch.setattr("studies.run.check.lay_out", lambda *_: pytest.fail("work was done"))
    with pytest.raises(Refusal):
        check_design(prototype("array-2x6"))


@pytest.mark.slow
def test_a_tube_that_cannot_be_drawn_is_a_misfit_not_the_end_of_the_check(monkeypatch):
    def bent(*_):
        raise Refusal("sheath 0.44x0.9-1: bends to a radius of 0.4 mm, below its own 0.45 mm", kind=Kind.OUT_OF_RANGE)

    monkeypatch.setattr("studies.run.check.array_model", bent)
    assert check_design(prototype("line-2")).misfits == (
        "sheath 0.44x0.9-1: bends to a radius of 0.4 mm, below its own 0.45 mm",
    )


@pytest.mark.parametrize(("call", "drawing"), [(export_parts, "array_model"), (run_design, "draw_parts")])
def test_parts_in_each_others_way_are_refused_before_anything_is_drawn_unless_they_are_allowed(
    call, drawing, tmp_path, monkeypatch
):
    narrow = prototype("array-2x6").with_values(NARROW)
    out = tmp_path / "out"
    with refused(Kind.CONFLICT, file="array-2x6") as error:
        call(narrow, out)
    assert "allow_overlaps" in error.value.remedy
    assert error.value.sentence({"allow_overlaps": "--allow-overlaps"}).count("--allow-overlaps") == 1
    assert not out.exists()

    class Drawn(Exception):
        pass

    def draw(*_, **__):
        raise Drawn

    monkeypatch.setattr(f"{call.__module__}.{drawing}", draw)
    with pytest.raises(Drawn):
        call(narrow, out, allow_overlaps=True)

"""What is said of a design before it is solved: the parts as drawn go together, or what is in the way is named."""

from geometry import prototype
from geometry.refusal import Refusal
from studies.cli.tables import show_check
from studies.run.check import check_design


def test_parts_in_each_others_way_are_named_by_check(capsys):
    narrow = {"layout": {"kind": "cylinder", "columns": 6, "diameter": 9.0}, "lines.0.points": 4}
    found = check_design(prototype("array-2x6").with_values(narrow))
    assert any(line.startswith("shell 1 and shell 4 are in each other's way: they share ") for line in found.misfits)
    assert found.to_dict()["misfits"] == list(found.misfits)
    show_check(found)
    printed = capsys.readouterr().out
    assert f"note: {found.misfits[0]}" in printed
    assert printed.count(" are in each other's way") == min(len(found.misfits), 10)


def test_a_tube_that_cannot_be_drawn_is_a_misfit_not_the_end_of_the_check(monkeypatch):
    def refused(*_):
        raise Refusal("sheath 0.44x0.9-1: bends to a radius of 0.4 mm, below its own 0.45 mm")

    monkeypatch.setattr("geometry.assembly.model.array_model", refused)
    assert check_design(prototype("line-2")).misfits == (
        "sheath 0.44x0.9-1: bends to a radius of 0.4 mm, below its own 0.45 mm",
    )

"""The parts of a line of several kinds: each kind has its shells, membranes and molds, and they go together."""

import pytest

import geometry
from geometry.assembly.bill import bill_of_materials
from geometry.assembly.fit import misfits, port_fits
from geometry.assembly.model import array_model
from geometry.assembly.order_table import assembly_steps, assembly_text, write_assembly_table
from geometry.layout.cutting import cutting_list
from geometry.printing.printability import print_report

TUBE = {"length": 14.0, "inner_diameter": 0.44, "wire_diameter": 0.08, "outer_diameter": 0.9}
WIDE = {"length": 8.0, "inner_diameter": 0.6, "wire_diameter": 0.1, "outer_diameter": 1.1}


@pytest.fixture(scope="module")
def design():
    return geometry.prototype("array-2x6").with_values({
        "point_kinds": {"stiff": {}, "well": {"cavity_height": 4.0, "membrane_thickness": 0.8}},
        "tube_kinds": {"long": TUBE, "short": WIDE},
        "lines": [{
            "between": ["A", "B"], "points": 4,
            "pattern": {"points": ["stiff", "well"], "tubes": ["long", "short"], "mirrored": True},
        }],
        "mold.shim_count": 1,
    })  # fmt: skip


@pytest.fixture(scope="module")
def model(design):
    return array_model(design)


def test_each_kind_has_its_shells_membranes_and_molds(design, model):
    parts, thickness = model.parts, design.membrane.thickness
    shells = {name: count for name, count in parts.counts.items() if parts.kinds[name] == "shell"}
    assert sorted(shells.values()) == [2, 2]
    assert all("-h2.5-" in name or "-h4-" in name for name in shells)
    membranes = {name: count for name, count in parts.counts.items() if parts.kinds[name] == "membrane"}
    assert membranes == {f"membrane-{thickness:g}": 2, "membrane-0.8": 2}
    molds = {name for name in parts if parts.kinds[name].startswith("mold")}
    pieces = ("base", "lid", "shim-1", "plugs")
    assert molds == {f"mold-{part}-{size}" for part in pieces for size in (f"{thickness:g}", "0.8")}
    heights = {name: parts[name].val().BoundingBox().zlen for name in membranes}
    assert heights == pytest.approx({f"membrane-{thickness:g}": thickness, "membrane-0.8": 0.8}, rel=1e-6)
    deep, low = (next(name for name in shells if f"-h{height}-" in name) for height in ("4", "2.5"))
    assert parts.parameters[deep]["cavity_height"] == 4.0
    assert parts.parameters[deep]["port_height"] == parts.parameters[low]["port_height"] == 1.25
    assert parts.parameters["mold-base-0.8"]["thickness"] == 0.8


def test_the_parts_of_a_graded_line_go_together(model):
    assert misfits(model) == ()
    fits = port_fits(model)
    assert len(fits) == 2 * 5
    assert max(fit.axis_offset for fit in fits) < 1e-6
    assert {round(fit.glue_gap, 6) for fit in fits} == {0.05}


def test_a_membrane_lies_on_the_seat_of_its_own_shell(model):
    heights = [part.position[2] for part in model.placed if part.kind == "membrane"]
    assert heights == [2.5, 4.0, 4.0, 2.5]


def test_the_bill_counts_every_kind(design, model):
    bill = bill_of_materials(design, model.parts)
    items = {(item.item, item.note): item.count for item in bill.items}
    assert items["spring 0.8 mm, wire 0.1 mm", "cut to 7 mm, 70 turns, between points of line 1, kind short"] == 1
    assert items["spring 0.6 mm, wire 0.08 mm", "cut to 13 mm, 162 turns, between points of line 1, kind long"] == 2
    assert [(cut.kind, cut.count) for cut in cutting_list(design)] == [("", 2), ("long", 2), ("short", 1)]
    assert {item.item for item in bill.items} >= {"membrane-0.8", "mold-base-0.8"}


def test_the_assembly_table_says_the_kind_at_each_place(design, model, tmp_path):
    steps = assembly_steps(model)
    thick = f"membrane-{design.membrane.thickness:g}"
    assert [(step.kind, step.membrane) for step in steps] == [
        ("", ""), ("stiff", thick), ("well", "membrane-0.8"), ("well", "membrane-0.8"), ("stiff", thick), ("", ""),
    ]  # fmt: skip
    assert [step.tube.kind for step in steps[:-1]] == ["", "long", "short", "long", ""]
    text = assembly_text(design, steps)
    assert "point 2       well" in text
    table, _ = write_assembly_table(model, tmp_path)
    header, _, first, second, *_ = table.read_text(encoding="utf-8").splitlines()
    assert header.endswith(",kind,membrane,kind of tube")
    assert first.endswith(f",stiff,{thick},long")
    assert second.endswith(",well,membrane-0.8,short")


def test_the_tables_of_a_plain_design_say_nothing_of_kinds():
    design = geometry.prototype("array-2x6")
    assert "kind" not in assembly_text(design)
    assert all("kind" not in cut.place for cut in cutting_list(design))


def test_the_print_report_judges_every_kind(design, model):
    report = print_report(model.parts.only("membrane-0.8", "mold-shim-1-0.8"), design=design)
    assert {finding.part for finding in report.findings} == {"membrane-0.8", "mold-shim-1-0.8"}
    assert any(finding.part == "mold-shim-1-0.8" and "shim" in finding.rule for finding in report.findings)
    features = {effect.feature for effect in report.effects}
    assert features >= {"cavity, 2.5 mm high", "cavity, 4 mm high", "gap of the mold of 0.8 mm"}


def test_the_shells_of_a_carrier_have_the_heights_of_their_kinds(design):
    carried = design.with_values({"printing.carrier": "row"})
    part = geometry.build_parts(carried)["carrier"].val()
    assert part.BoundingBox().zmax == pytest.approx(4.0 + 0.4)
    assert part.isValid()

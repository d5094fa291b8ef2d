"""The assembly table says what stands where and which tube leads on."""

import csv
import itertools
import math
from collections import Counter

import numpy as np
import pytest
from built import built

import geometry
from geometry.assembly.order_table import assembly_steps, assembly_text, write_assembly_table
from geometry.assembly.part_list import place_parts
from geometry.layout.arrangement import lay_out
from geometry.plan.routing import path_length


@pytest.mark.parametrize("name", ["fingertip-3x4", "glove", "line-3"])
def test_the_assembly_table_says_what_stands_where_and_what_leads_on(name):
    design = geometry.prototype(name)
    layout, steps = lay_out(design), assembly_steps(design)
    placed = {
        part.group: part for part in place_parts(design, layout) if part.part.startswith(("shell", "microphone-h"))
    }
    tubes = {tube.label: tube for tube in layout.tubes}
    ports = {part: words["ports"] for part, words in built(name).parameters.items() if "ports" in words}
    assert len(steps) == sum(line.points + 2 for line in design.lines)
    assert [step.tube.name for step in steps if step.tube] == [tube.label for tube in layout.tubes]
    for step, after in itertools.pairwise(steps):
        part = placed[step.place]
        assert (step.part, step.position) == (part.part, part.position)
        assert step.rotation == pytest.approx(part.rotation, abs=0.05)
        for angle in (step.port_before, step.port_after):
            assert angle is None or f"{angle:g} deg" in ports[step.part]
        if step.tube is None:
            assert after.line == step.line + 1
            continue
        tube = tubes[step.tube.name]
        if tube.schematic:
            continue
        # The tube begins at this place, in the direction of its turned port, and ends at the next.
        for at, port, end in ((step, step.port_after, tube.path[0]), (after, after.port_before, tube.path[-1])):
            x, y = end[:2] - np.array(at.position[:2])
            direction = math.degrees(math.atan2(y, x))
            assert (direction - at.rotation - port + 180) % 360 - 180 == pytest.approx(0, abs=0.2)
        assert step.tube.sheath_length == pytest.approx(
            path_length(tube.course) - 2 * design.printing.port_lip, abs=1e-3
        )


def test_the_assembly_table_is_written_for_people_and_for_programs(tmp_path):
    design = geometry.prototype("fingertip-3x4")
    table, page = write_assembly_table(design, tmp_path)
    rows = list(csv.DictReader(table.open(encoding="utf-8")))
    assert [row["place"] for row in rows] == ["microphone A", *(f"point {k}" for k in range(1, 13)), "microphone B"]
    assert Counter(row["part"] for row in rows if row["place"].startswith("point")) == {
        name: count for name, count in built("fingertip-3x4").counts.items() if name.startswith("shell")
    }
    second = rows[2]
    assert (second["part"], second["tube to the next"]) == ("shell-corner-65.8-0.18x0.55", "tube 3 of line 1")
    assert (second["sheath length (mm)"], second["spring length (mm)"], second["turns"]) == ("3.6", "3.37", "67")
    assert page.read_text(encoding="utf-8") == assembly_text(design)
    assert "drawn schematically" not in assembly_text(design)
    assert "drawn schematically" in assembly_text(geometry.prototype("line-4"))

"""Studies of arrays on a body: what the places were fitted for cannot vary, and what lies inside can."""

from __future__ import annotations

import shutil
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from refusals import check_messages, refused

import acoustic_fem
import geometry
from geometry import Kind
from geometry.design import save_places
from geometry.design.frozen_rules import inputs_of
from studies.study.parameter import StudyError
from studies.study.study import read_study

ROBOT = Path(__file__).parents[3] / "docs/examples/robot"
#: Fields that the fit of an array on a body has settled, each with a value.
SETTLED: dict[str, float] = {
    "layout.pitch": 5.0,
    "surface.pitch": 5.0,
    "surface.base": 0.5,
    "resonator.cavity_diameter": 1.5,
    "resonator.wall_thickness": 0.5,
    "resonator.floor_thickness": 0.8,
    "microphone.chamber_diameter": 2.0,
    "microphone.wall_thickness": 1.1,
    "tube.length": 5.0,
    "microphone_tube.length": 13.0,
}


def study(name: str, value: float) -> str:
    head = f'base = "{ROBOT / "fingertip.toml"}"\nmetrics = ["distance_smallest"]\nfidelity = "lumped"\nstock = "off"\n'
    return f'{head}[vary]\n"{name}" = [{value}]\n'


@pytest.mark.parametrize(("name", "value"), SETTLED.items())
def test_a_field_that_the_fit_has_settled_cannot_vary(name: str, value: float) -> None:
    with refused(Kind.CONFLICT, f"vary.{name}", file="s.toml", error=StudyError):
        read_study(study(name, value), "s.toml")


def test_the_messages_on_settled_fields() -> None:
    calls = {name: partial(read_study, study(name, value), "s.toml") for name, value in SETTLED.items()}
    check_messages(Path(__file__).parent / "messages_of_surface_designs.txt", calls)


@pytest.mark.parametrize(
    ("name", "value"), [("membrane.thickness", 0.3), ("resonator.cavity_height", 1.1), ("tube.wire_diameter", 0.04)]
)
def test_what_lies_inside_the_parts_varies_while_the_places_stay(name: str, value: float) -> None:
    given = read_study(study(name, value), "s.toml")
    varied = given.base.with_values({name: value})
    assert varied.layout.frozen == given.base.layout.frozen
    assert [line.lengths for line in varied.lines] == [line.lengths for line in given.base.lines]


def in_pockets(folder: Path) -> geometry.ArrayDesign:
    """The fingertip with its places as if they had been fitted for pockets in the body."""
    for file in ("fingertip.toml", "fingertip.places.json", "fingertip.step"):
        shutil.copy(ROBOT / file, folder / file)
    text = (folder / "fingertip.toml").read_text("utf-8").replace("[surface]", '[surface]\nseat = "in"')
    (folder / "fingertip.toml").write_text(text, encoding="utf-8")
    design = geometry.load_design(ROBOT / "fingertip.toml")
    assert design.surface is not None
    assert design.layout.frozen is not None
    seated = design.surface.model_copy(update={"seat": "in"})
    places = design.layout.frozen.model_copy(update={"inputs": inputs_of(seated)})
    layout = design.layout.model_copy(update={"frozen": places})
    save_places(design.model_copy(update={"surface": seated, "layout": layout}), folder / "fingertip.places.json")
    return geometry.load_design(folder / "fingertip.toml")


def test_shells_in_pockets_keep_the_height_at_which_membranes_are_flush(tmp_path: Path) -> None:
    design = in_pockets(tmp_path)
    assert design.layout.frozen is not None
    assert design.layout.frozen.sizes.membrane_height == pytest.approx(1.3 + 0.2)
    with refused(Kind.CONFLICT, "resonator.cavity_height") as error:
        design.with_values({"resonator.cavity_height": 1.6})
    assert error.value.remedy == "fit again"
    with refused(Kind.CONFLICT, "vary.resonator.cavity_height", file="s.toml", error=StudyError):
        head = f'base = "{tmp_path / "fingertip.toml"}"\nmetrics = ["distance_smallest"]\nstock = "off"\n'
        read_study(f'{head}[vary]\n"resonator.cavity_height" = [1.4]\n', "s.toml")
    # A membrane that is a little thicker or thinner stays flush within what a finger feels.
    assert design.with_values({"membrane.thickness": 0.25}).membrane.thickness == 0.25
    with refused(Kind.CONFLICT, "resonator.cavity_height"):
        design.with_values({"membrane.thickness": 0.4})


def test_a_length_that_every_line_states_itself_changes_no_response() -> None:
    design = geometry.load_design(ROBOT / "fingertip.toml")
    one, other = (
        acoustic_fem.solve(each, [30.0], fidelity="lumped").transfer_function.values
        for each in (design, design.with_values({"tube.length": 9.0}))
    )
    np.testing.assert_array_equal(one, other)

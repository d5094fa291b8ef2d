"""Files for an array on a body: solids that a foreign slicer takes, the pattern at full scale, the clash test."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest
import trimesh

import geometry
from geometry.assembly.model import ArrayModel, array_model
from geometry.assembly.part_list import PartSet
from geometry.layout import lay_out
from geometry.pictures.viewer import write_gltf
from geometry.schema.print_processes import process_of
from geometry.surface import plan_in_space
from studies.kit.body_files import body_beside, write_body
from studies.kit.flat_pattern import write_pattern

EXAMPLES = Path("docs/examples/robot")


def drawn(name):
    """An example without its solids, which a pattern does not need."""
    design = geometry.load_design(EXAMPLES / f"{name}.toml")
    return ArrayModel(design, lay_out(design), PartSet(), {}, (), ())


def test_a_pattern_is_at_full_scale_and_states_its_stretch(tmp_path):
    model = drawn("palm")
    rms, worst = write_pattern(model, tmp_path)
    track = plan_in_space(model.design, model.layout)
    assert (rms, worst) == (track.stretch, track.worst)
    assert f"the unrolled plan is off by {100 * rms:.1f} % between neighbours" in model.design.layout.frozen.findings
    assert 0.001 < rms < 0.02
    assert rms < worst < 0.06
    content = (tmp_path / "pattern-a4.pdf").read_bytes()
    width, height = (float(each) for each in re.search(rb"MediaBox \[ 0 0 (\S+) (\S+) \]", content).groups())
    assert (width * 25.4 / 72, height * 25.4 / 72) == pytest.approx((210, 297), abs=0.1)
    assert (tmp_path / "pattern-letter.pdf").is_file()


def test_a_body_is_found_beside_its_design_only(tmp_path):
    path = EXAMPLES / "fingertip.toml"
    design = geometry.load_design(path)
    assert body_beside(path, design).extent == pytest.approx([18, 18, 27], abs=0.05)
    assert body_beside(design, design) is None
    for file in ("fingertip.toml", "fingertip.places.json"):
        shutil.copy(EXAMPLES / file, tmp_path / file)
    assert body_beside(tmp_path / "fingertip.toml", design) is None
    plain = geometry.prototype("array-2x6")
    assert body_beside("array-2x6", plain) is None


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """Files of the fingertip."""
    path, folder = EXAMPLES / "fingertip.toml", tmp_path_factory.mktemp("kit")
    design = geometry.load_design(path)
    model = array_model(design)
    body = body_beside(path, design)
    made = write_body(model, body, folder, ("stl", "3mf"), process_of(design.printing), lambda what, done: None)
    return model, made, folder


@pytest.mark.slow
def test_files_of_a_body_say_how_it_goes_together(written):
    model, made, folder = written
    assert sorted(path.name for path in (folder / "2-print/body").iterdir()) == [
        *("drill-template.3mf", "drill-template.stl", "skin.3mf", "skin.stl")
    ]
    text = (folder / "5-build/body.txt").read_text(encoding="utf-8")
    assert all(finding in text for finding in made.findings)
    assert "The skin is 2.4 mm thick" in text
    rows = (folder / "5-build/clash-test.csv").read_text(encoding="utf-8").splitlines()
    assert len(rows) == 1 + len(made.carved.clashes)
    scene = trimesh.load_scene(write_gltf(model, folder / "array.glb", made.shown))
    assert {"body", "skin", "shell_1"} <= set(scene.graph.nodes_geometry)


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("prusa-slicer") is None, reason="PrusaSlicer is not installed")
@pytest.mark.parametrize("name", ["skin", "drill-template"])
def test_a_slicer_says_that_the_solid_is_closed(written, name):
    path = written[2] / f"2-print/body/{name}.stl"
    done = subprocess.run(["prusa-slicer", "--info", path], capture_output=True, text=True, check=True, timeout=120)
    assert "manifold = yes" in done.stdout
    assert re.search(r"number_of_parts =\s+1\b", done.stdout)

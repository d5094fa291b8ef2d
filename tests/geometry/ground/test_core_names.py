"""Every public name, from Python, with the core alone: it is there, or the one line says what to type."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from core_only import ROOT, link_core, python_of_core
from house_rules import House

import studies

RECORDINGS = ROOT / "docs" / "examples" / "recordings"
LINE = re.compile(r"[\w. -]+(, which this needs,)? is not installed: pip install 'acoustic-fem\[([a-z,]+)\]'")
#: What the core is for.
THERE = {
    "acoustic_fem.load", "acoustic_fem.save", "acoustic_fem.solve", "acoustic_fem.library.export",
    "geometry.load_design", "geometry.prototype", "localize.BayesDecoder", "localize.LocalizerError",
    "localize.PathTracker", "localize.TolerantDecoder", "localize.TouchStream", "localize.read_recording",
    "studies.check_design", "studies.convert_library", "studies.embed_decoder", "studies.locate_recording",
    "studies.solve_library", "studies.track_recording",
}  # fmt: skip
#: Each name of each face; those that are there, and the lines of the others, are printed as JSON.
NAMES = """
import importlib, json, sys
from geometry.ground import MissingExtra

there, reported = [], {}
for face in json.loads(sys.argv[1]):
    module = importlib.import_module(face)
    for name in module.__all__:
        try:
            getattr(module, name)
            there.append(f"{face}.{name}")
        except MissingExtra as missing:
            reported[f"{face}.{name}"] = str(missing)
print(json.dumps([there, reported]))
"""
#: Calls -> the extra that they ask for.
CALLS = {
    "geometry.build_parts(design)": "cad",
    "geometry.pictures.draw_array(design, 'array.png')": "cad",
    "geometry.air.air_volume(cell)": "cad",
    "acoustic_fem.solve(design, [1.0, 2.0])": "fem",
    "acoustic_fem.solve(box, [1.0, 2.0], fidelity='lumped')": "fem",
    "acoustic_fem.cell.solve_cells([cell], [1.0], air)": "fem",
    "acoustic_fem.cell.port_admittance('air.step', {'a': (0, 0, 0)}, 1.0, air)": "cad",
    "acoustic_fem.library.export(library, 'new.sofa')": "sofa",
    "localize.train(library)": "train",
    "localize.load_localizer('trained')": "train",
    "localize.load_recognizer('trained')": "train",
    "localize.TouchGenerator(library)": "train",
    "localize.self_calibrate(library, [])": "train",
    "localize.export_onnx(localize.BayesDecoder(library), 'decoder.onnx')": "train",
    "localize.OnnxLocalizer('decoder.onnx')": "onnx",
    "studies.sweep_report('results.zarr', 'report.html')": "studies",
    "studies.run_sweep(studies.load_study('study.toml'), 'new.zarr', workers=2)": "studies",
    "studies.optimize('line-36-search.toml', 'found')": "studies",
    "studies.train_localizer('library.nc', 'trained')": "train",
    "studies.evaluate_localizer('library.nc', 'library.nc')": "train",
    "studies.export_decoder('library.nc', 'decoder.onnx')": "train",
    "studies.read_pulse('library.nc', 'touches.wav', 'pulse.csv')": "train",
    "studies.wiring_table(2, 6, 'wiring.png')": "plots",
    "studies.tolerance_study(design, 'tolerance')": "studies",
    "studies.export_parts(design, 'parts')": "cad",
    "studies.run_design(design, 'demo')": "cad",
    "studies.bending_study('bent')": "plots",
    "studies.calibrate_sensor('calibration', 'made.nc')": "plots",
    "studies.serve_studio(design)": "studio",
}
CALLING = """
import json, sys
import geometry, acoustic_fem, localize, studies
from geometry.ground import MissingExtra

design = geometry.prototype("array-2x6")
box = design.with_values({"resonator.shape": "box"})
cell = geometry.air.cell_catalogue(design, geometry.layout.lay_out(design)).distinct[0]
air = acoustic_fem.Medium.at(20, 0.5)
library = acoustic_fem.load("library.nc")
reported = {}
for call in json.loads(sys.argv[1]):
    try:
        eval(call)
        reported[call] = "nothing was asked for"
    except MissingExtra as missing:
        reported[call] = str(missing)
    except Exception as error:
        reported[call] = repr(error)
print(json.dumps(reported))
"""
STUDY = """
base = "array-2x6"
fidelity = "lumped"
frequency = "1:100:4"
metrics = ["sensitivity_force"]
[vary]
"tube.length" = [10, 12]
"""
pytestmark = [pytest.mark.slow, pytest.mark.end_to_end]


@pytest.fixture(scope="module")
def core(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return link_core(tmp_path_factory.mktemp("core"))


def test_a_name_is_there_or_says_what_to_type(core: Path, tmp_path: Path) -> None:
    done = python_of_core(core, "-c", NAMES, json.dumps(sorted(House(ROOT).handed_on)), folder=tmp_path)
    assert done.returncode == 0, done.stderr
    there, reported = json.loads(done.stdout)
    assert set(there) >= THERE
    assert {name: said for name, said in reported.items() if not LINE.fullmatch(said)} == {}


def test_a_call_says_what_to_type(core: Path, tmp_path: Path) -> None:
    (tmp_path / "library.nc").symlink_to(RECORDINGS / "library.nc")
    (tmp_path / "touches.wav").symlink_to(RECORDINGS / "touches.wav")
    (tmp_path / "calibration").symlink_to(RECORDINGS / "calibration")
    for name in ("line-36.toml", "line-36-search.toml"):
        (tmp_path / name).symlink_to(ROOT / "docs" / "examples" / name)
    (tmp_path / "study.toml").write_text(STUDY, "utf-8")
    studies.run_sweep(studies.load_study(tmp_path / "study.toml"), tmp_path / "results.zarr", workers=1)
    done = python_of_core(core, "-c", CALLING, json.dumps(list(CALLS)), folder=tmp_path)
    assert done.returncode == 0, done.stderr
    reported = json.loads(done.stdout)
    found = {call: match[2] if (match := LINE.fullmatch(reported[call])) else reported[call] for call in CALLS}
    assert {call: said for call, said in found.items() if said != CALLS[call]} == {}

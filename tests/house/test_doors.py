"""The public doors, each by its documented path: names and shapes that others rely on from outside."""

from __future__ import annotations

import os
import subprocess
import sys
import tarfile
from pathlib import Path

import numpy as np
import pytest

import acoustic_fem
import geometry
import localize

GRID = np.linspace(1, 100, 16)


@pytest.fixture(scope="module")
def design(tmp_path_factory: pytest.TempPathFactory) -> geometry.ArrayDesign:
    path = tmp_path_factory.mktemp("design") / "design.toml"
    geometry.save_design(geometry.prototype("array-2x6"), path)
    return geometry.load_design(path)


@pytest.fixture(scope="module")
def library(design: geometry.ArrayDesign) -> acoustic_fem.Library:
    return acoustic_fem.solve(design, frequency=GRID, fidelity="lumped")


def test_a_design_is_read_by_name_or_from_a_file(design: geometry.ArrayDesign) -> None:
    assert design == geometry.prototype("array-2x6") == geometry.resolve_design("array-2x6")
    assert "array-2x6" in geometry.prototype_names()
    with pytest.raises(geometry.DesignError, match="prototype = 'array-2x7' is not known"):
        geometry.prototype("array-2x7")
    assert issubclass(geometry.DesignError, geometry.Refusal)


def test_a_library_has_its_labelled_responses(library: acoustic_fem.Library) -> None:
    assert library.transfer_function.dims == ("point", "microphone", "frequency")
    assert library.transfer_function.shape == library.source_response.shape == (12, 2, 16)
    assert library.point_impedance.dims == ("point", "frequency")
    assert library.transfer_function.dtype == np.complex128
    assert library.fidelity in acoustic_fem.FIDELITIES == ("lumped", "atlas", "helmholtz", "navier-stokes")


def test_a_library_is_saved_and_loaded(library: acoustic_fem.Library, tmp_path: Path) -> None:
    acoustic_fem.save(library, tmp_path / "library.nc")
    found = acoustic_fem.load(tmp_path / "library.nc")
    np.testing.assert_array_equal(found.transfer_function, library.transfer_function)
    assert found.design == library.design
    with pytest.raises(acoustic_fem.LibraryError, match="no such file"):
        acoustic_fem.load(tmp_path / "none.nc")


def test_a_localizer_is_trained_and_the_decoder_needs_no_training(library: acoustic_fem.Library) -> None:
    localizer = localize.train(library, localize.TrainingPlan(epochs=1, seconds_per_point=4))
    decoder = localize.BayesDecoder(library, microphone_noise=1e-3)
    signals = np.random.default_rng(0).standard_normal((3, 2, 1000)) * 1e-3
    for each in (localizer, decoder):
        assert each.locate(signals[0]).shape == (12,)
        probability = each.locate(signals)
        assert probability.shape == (3, 12)
        np.testing.assert_allclose(probability.sum(1), 1, rtol=1e-5)


@pytest.mark.slow
def test_parts_are_built_exported_and_judged(tmp_path: Path) -> None:
    small = geometry.prototype("array-2x6").with_values(
        {"lines": [{"between": ["A", "B"], "points": 1}], "layout.columns": 1}
    )
    parts = geometry.build_parts(small)
    geometry.export(parts, tmp_path / "parts", formats=("stl", "step", "3mf"))
    assert {path.suffix for path in (tmp_path / "parts").iterdir()} >= {".stl", ".step", ".3mf"}
    report = geometry.print_report(parts, process="sla-resin")
    finding = report.findings[0]
    assert finding.part in parts
    assert {"rule", "value", "limit"} <= set(dir(finding))
    assert geometry.bill_of_materials(small)
    assert geometry.build_assembly(small)


# -- one floor down ------------------------------------------------------------------------------------
@pytest.fixture(scope="module")
def medium() -> acoustic_fem.Medium:
    return acoustic_fem.Medium(
        density=1.204, viscosity=1.825e-5, conductivity=0.02587, heat_capacity=1006.0, gamma=1.4, pressure=101325.0
    )


def test_air_is_made_of_its_state(medium: acoustic_fem.Medium) -> None:
    usual = acoustic_fem.Medium.at(temperature_c=20, humidity=0.5)
    assert usual.density == pytest.approx(medium.density, rel=0.01)


def test_the_duct_has_a_port_admittance(medium: acoustic_fem.Medium) -> None:
    admittance = acoustic_fem.duct.port_admittance(0.25e-3, 10e-3, GRID, medium)
    assert admittance.shape == (16, 2, 2)
    conductance = np.pi * 0.25e-3**4 / (8 * medium.viscosity * 10e-3)  # Hagen and Poiseuille
    assert abs(admittance[0, 0, 0]) == pytest.approx(conductance, rel=1e-3)


def test_the_closed_cylinder_has_a_compliance(medium: acoustic_fem.Medium) -> None:
    compliance = acoustic_fem.cavity.closed_cylinder_compliance(2e-3, 3e-3, np.array([1e-3, 1.0]), medium)
    assert compliance.shape == (2,)
    assert compliance[0] == pytest.approx(np.pi * 2e-3**2 * 3e-3 / medium.pressure, rel=1e-3)  # isothermal


def test_any_solid_of_air_has_a_port_admittance(medium: acoustic_fem.Medium) -> None:
    import cadquery as cq

    box = cq.Workplane().box(1, 1, 1).val()
    admittance = acoustic_fem.cell.port_admittance(
        box, {"a": (0, 0, 0.5), "b": (0, 0, -0.5)}, [10.0], medium, fidelity="helmholtz", accuracy=3e-3
    )
    assert admittance.shape == (1, 2, 2)
    assert admittance[0, 0, 1] == pytest.approx(admittance[0, 1, 0])


def test_the_membrane_has_a_compliance() -> None:
    clamped = acoustic_fem.membrane.disc_compliance(2e-3, 0.5e-3, 1e5, poisson_ratio=0.49, rim_width=0.0)
    glued = acoustic_fem.membrane.disc_compliance(2e-3, 0.5e-3, 1e5, rim_width=1e-3)
    assert 0 < clamped < glued


# -- without an installation beside it -----------------------------------------------------------------
@pytest.mark.slow
@pytest.mark.end_to_end
def test_a_wheel_holds_all_that_the_command_needs(tmp_path: Path) -> None:
    """Built from the files that git tracks, unpacked elsewhere, run there: nothing of the checkout is at hand."""
    root = Path(__file__).parents[2]
    checkout, site = tmp_path / "checkout", tmp_path / "site"
    files = subprocess.run(["git", "ls-files", "-z"], cwd=root, check=True, capture_output=True, text=True).stdout
    for name in filter(None, files.split("\0")):
        if (root / name).is_file():
            (checkout / name).parent.mkdir(parents=True, exist_ok=True)
            (checkout / name).write_bytes((root / name).read_bytes())
    build = "import sys; from setuptools import build_meta; build_meta.build_sdist(sys.argv[1])"
    subprocess.run([sys.executable, "-c", build, str(tmp_path)], cwd=checkout, check=True, capture_output=True)
    (source,) = tmp_path.glob("acoustic_fem-*.tar.gz")
    with tarfile.open(source) as archive:
        held = {name.partition("/")[2] for name in archive.getnames()}
    assert set(filter(None, files.split("\0"))) - held == set()

    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "install", "--quiet", "--no-deps"]
    subprocess.run(
        [*pip, "--no-build-isolation", "--target", str(site), str(checkout)], check=True, capture_output=True
    )

    def run(*arguments: str) -> str:
        code = (
            "import sys, studies.cli.app as a, studies.run.pipeline as c; "
            "assert a.__file__.startswith(sys.argv.pop(1)); "
            "c.EPOCHS = 1; a.main()"  # nothing is missing from a short training either
        )
        done = subprocess.run(
            [sys.executable, "-c", code, str(site), *arguments],
            cwd=tmp_path,
            env={**os.environ, "PYTHONPATH": str(site), "PYTHONIOENCODING": "utf-8"},
            capture_output=True,
            encoding="utf-8",
        )
        assert done.returncode in (0, 3), done.stderr  # 3: a marginal design
        return done.stdout

    assert "array-2x6" in run("prototypes")
    small = run("prototypes", "array-2x6").replace("points = 12", "points = 4")
    (tmp_path / "small.toml").write_text(small, encoding="utf-8")
    assert "more, with --full" in run("check", "small.toml")
    run("solve", "small.toml", "--fidelity", "lumped", "--out", "library.nc")
    run("run", "small.toml", "--out", "demo")
    assert (tmp_path / "demo" / "report.html").stat().st_size > 10_000
    assert (site / "share" / "doc" / "acoustic-fem" / "calibration.md").exists()

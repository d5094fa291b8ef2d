"""The labelled library: solve, labels, file round trip, bad input."""

import dataclasses
import json
import subprocess
import sys
import warnings
from pathlib import Path

import netCDF4
import numpy as np
import pytest
import xarray as xr
from refusals import check_messages, refused
from rings import triangle

import acoustic_fem
from acoustic_fem.library import sealed_netcdf
from acoustic_fem.membrane.design_discs import design_disc, design_rubber
from geometry.design.design_file import prototype, prototype_names, write_design
from geometry.ground.refusal import Kind

DESIGN = triangle()
BAND = np.linspace(1, 100, 5)
RESULTS = ("transfer_function", "source_response", "point_impedance", "microphone_impedance")


@pytest.fixture(scope="module")
def library():
    return acoustic_fem.solve(DESIGN, BAND, fidelity="lumped")


def test_results_are_labelled_by_point_microphone_and_frequency(library):
    points = DESIGN.point_count
    assert library.transfer_function.dims == ("point", "microphone", "frequency")
    assert library.transfer_function.shape == (points, 3, 5)
    assert library.point_impedance.dims == ("point", "frequency")
    assert library.transfer_function.dtype == np.complex128
    assert library.transfer_function.point.values.tolist() == list(range(1, points + 1))
    assert library.transfer_function.microphone.values.tolist() == list(DESIGN.microphones)
    np.testing.assert_array_equal(library.frequency, BAND)
    expected = [line for line, wiring in enumerate(DESIGN.lines) for _ in range(wiring.points)]
    assert library.transfer_function.line.values.tolist() == expected
    units = [getattr(library, name).attrs["units"] for name in RESULTS]
    assert units == ["Pa/Pa", "Pa s/m^3", "Pa s/m^3", "Pa s/m^3"]


def test_transfer_function_is_source_response_over_point_impedance(library):
    ratio = library.source_response / library.point_impedance
    np.testing.assert_allclose(ratio.transpose(*library.transfer_function.dims), library.transfer_function, rtol=1e-14)


def test_provenance_and_air_are_carried(library):
    assert library.fidelity == "lumped"
    assert library.design == DESIGN
    assert library.medium == acoustic_fem.Medium.at(20, 0.5)
    assert {"code_version", "libraries", "created", "seed", "frequency_sha256", "cells"} <= library.provenance.keys()
    assert {entry["method"] for entry in library.provenance["cells"]} == {"closed form"}


def test_the_air_may_be_given(library):
    cold = acoustic_fem.solve(DESIGN, BAND, "lumped", acoustic_fem.Medium.at(0, 0))
    assert cold.medium.viscosity < library.medium.viscosity
    assert np.abs(cold.transfer_function - library.transfer_function).max() > 1e-3


def test_progress_runs_from_start_to_one():
    seen = []
    acoustic_fem.solve(DESIGN, BAND, "lumped", progress=lambda message, fraction: seen.append((message, fraction)))
    fractions = [fraction for _, fraction in seen]
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1


def test_a_saved_library_comes_back_number_for_number(library, tmp_path):
    path = tmp_path / "library.nc"
    acoustic_fem.save(library, path)
    again = acoustic_fem.load(path)
    for name in RESULTS:
        xr.testing.assert_identical(getattr(again, name), getattr(library, name))
    assert again.design == library.design
    assert again.medium == library.medium
    assert again.fidelity == library.fidelity
    assert again.provenance == library.provenance
    assert [file.name for file in tmp_path.iterdir()] == ["library.nc"]


def test_the_microphone_impedance_is_symmetric_and_passive(library):
    impedance = library.microphone_impedance
    assert impedance.dims == ("microphone", "microphone_2", "frequency")
    matrices = impedance.transpose("frequency", ...).values
    np.testing.assert_allclose(matrices, matrices.swapaxes(1, 2), rtol=1e-9)
    assert np.all(np.linalg.eigvalsh(matrices.real) > 0)


def test_a_file_without_microphone_impedance_loads_and_saves_without_it(library, tmp_path):
    old = dataclasses.replace(library, microphone_impedance=None)
    acoustic_fem.save(old, tmp_path / "old.nc")
    again = acoustic_fem.load(tmp_path / "old.nc")
    assert again.microphone_impedance is None
    xr.testing.assert_identical(again.source_response, library.source_response)


def test_plain_netcdf_tools_read_the_file(library, tmp_path):
    acoustic_fem.save(library, tmp_path / "library.nc")
    with netCDF4.Dataset(tmp_path / "library.nc") as file:
        assert file.Conventions.startswith("CF-")
        real = file["transfer_function_real"]
        assert real.dimensions == ("point", "microphone", "frequency")
        assert real.units == "Pa/Pa"
        assert file["frequency"].units == "Hz"
        values = real[:] + 1j * file["transfer_function_imag"][:]
    np.testing.assert_array_equal(values, library.transfer_function.values)


def test_the_response_per_newton_is_that_of_the_membrane_and_is_in_the_file(library, tmp_path):
    """At low frequency j w times the static volume per force; also for tools that know nothing of the design."""
    disc = design_disc(DESIGN)
    per_newton = 2j * np.pi * BAND * disc.volume_per_force / design_rubber(DESIGN).ratio(BAND)
    response = library.force_response
    assert (response.name, response.attrs["units"]) == ("force_response", "Pa/N")
    assert response.dims == ("point", "microphone", "frequency")
    np.testing.assert_allclose(response.values[..., :1], (library.source_response * per_newton)[..., :1], rtol=1e-4)
    np.testing.assert_allclose(response.values, library.source_response * per_newton, rtol=0.1)
    acoustic_fem.save(library, tmp_path / "library.nc")
    with netCDF4.Dataset(tmp_path / "library.nc") as file:
        assert file["force_response_imag"].units == "Pa/N"
        assert file["force_response_imag"].long_name.endswith("of the membrane's radius, imag part")
        values = file["force_response_real"][:] + 1j * file["force_response_imag"][:]
    np.testing.assert_array_equal(values, response.values)
    xr.testing.assert_identical(acoustic_fem.load(tmp_path / "library.nc").force_response, response)


def test_a_write_that_fails_leaves_the_old_file(library, tmp_path, monkeypatch):
    path = tmp_path / "library.nc"
    acoustic_fem.save(library, path)
    before = path.read_bytes()

    def full_disk(self, content):
        with self.open("wb") as file:
            file.write(content[:1000])
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full_disk)
    with pytest.raises(acoustic_fem.LibraryError, match=r"library\.nc: cannot be written: No space left on device"):
        acoustic_fem.save(library, path)
    assert path.read_bytes() == before
    assert [file.name for file in tmp_path.iterdir()] == ["library.nc"]


def test_a_missing_cut_or_foreign_file_is_refused_in_one_line(library, tmp_path):
    good = tmp_path / "good.nc"
    acoustic_fem.save(library, good)
    (tmp_path / "cut.nc").write_bytes(good.read_bytes()[: good.stat().st_size // 2])
    (tmp_path / "text.nc").write_text("point,microphone\n1,A\n")
    xr.Dataset({"a": ("x", [1.0])}).to_netcdf(tmp_path / "foreign.nc", engine="netcdf4")
    with xr.open_dataset(good, engine="netcdf4") as opened:
        opened.load().drop_vars("source_response_imag").to_netcdf(tmp_path / "partial.nc", engine="netcdf4")
    for name, reason in {
        "none.nc": "no such file",
        "": "is a folder, not a library",
        "cut.nc": "cut short, damaged or not a library in netCDF: Unable to synchronously open file (",
        "text.nc": "its columns are point, microphone",
        "foreign.nc": "is a netCDF file but no library",
        "partial.nc": "source_response_imag is missing",
    }.items():
        with pytest.raises(acoustic_fem.LibraryError) as error:
            acoustic_fem.load(tmp_path / name)
        assert reason in str(error.value)
        assert str(tmp_path / name) in str(error.value)
        assert "\n" not in str(error.value)


def without(attribute, key):
    def change(data):
        values = json.loads(data.attrs[attribute])
        del values[key]
        return data.assign_attrs({attribute: json.dumps(values)})

    return change


def with_entry(attribute, key, value):
    def change(data):
        return data.assign_attrs({attribute: json.dumps({**json.loads(data.attrs[attribute]), key: value})})

    return change


def with_attribute(name, value):
    return lambda data: data.assign_attrs({name: value})


def with_value(variable, index, value):
    def change(data):
        values = data[variable].values.copy()
        values[index] = value
        return data.assign({variable: data[variable].copy(data=values)})

    return change


def with_coordinate(name, index, value):
    def change(data):
        values = data[name].values.copy()
        values[index] = value
        return data.assign_coords({name: (data[name].dims, values)})

    return change


def without_attribute(name):
    def change(data):
        del data.attrs[name]
        return data

    return change


def with_design(design):
    return with_attribute("design_toml", write_design(design))


ALTERED = {
    "medium-without-a-value": (without("medium", "gamma"), Kind.MISSING, "medium.gamma"),
    "medium-with-another": (with_entry("medium", "colour", 1.0), Kind.UNKNOWN, "medium"),
    "medium-with-text": (with_entry("medium", "density", "1.2"), Kind.WRONG_TYPE, "medium.density"),
    "medium-below-zero": (with_entry("medium", "density", -1.2), Kind.OUT_OF_RANGE, "medium.density"),
    "medium-not-finite": (with_entry("medium", "gamma", float("nan")), Kind.OUT_OF_RANGE, "medium.gamma"),
    "medium-cut": (with_attribute("medium", '{"density": 1.2'), Kind.UNREADABLE, "medium"),
    "medium-a-list": (with_attribute("medium", "[1.2]"), Kind.WRONG_TYPE, "medium"),
    "medium-a-number": (with_attribute("medium", 1.2), Kind.WRONG_TYPE, "medium"),
    "provenance-cut": (with_attribute("provenance", "{"), Kind.UNREADABLE, "provenance"),
    "fidelity-unknown": (with_attribute("fidelity", "exact"), Kind.OUT_OF_RANGE, "fidelity"),
    "design-cut": (with_attribute("design_toml", "name = "), None, "design_toml"),
    "design-not-valid": (
        with_attribute("design_toml", write_design(DESIGN).replace("thickness = 0.5", "thickness = -1.0")),
        None, "membrane.thickness",
    ),
    "no-fidelity": (
        lambda data: data.drop_attrs().assign_attrs(title=data.title, layout_version=1), Kind.MISSING, "fidelity",
    ),
    "no-checksums": (without_attribute("checksums"), Kind.MISSING, "checksums"),
    "no-line": (lambda data: data.drop_vars("line"), Kind.MISSING, "line"),
    "no-frequency": (lambda data: data.drop_vars("frequency"), Kind.MISSING, "frequency"),
    "cut-to-five-points": (lambda data: data.isel(point=slice(5)), Kind.MISMATCH, "point"),
    "points-reversed": (lambda data: data.isel(point=slice(None, None, -1)), Kind.MISMATCH, "point[0]"),
    "another-line": (with_coordinate("line", 3, 2), Kind.MISMATCH, "line[3]"),
    "another-place": (with_coordinate("place", 3, 4), Kind.MISMATCH, "place[3]"),
    "microphone-renamed": (with_coordinate("microphone", 1, "X"), Kind.MISMATCH, "microphone[1]"),
    "microphone-left-out": (lambda data: data.isel(microphone=[0, 1]), Kind.MISMATCH, "microphone"),
    "design-of-another-array": (with_design(prototype("array-2x6")), Kind.MISMATCH, "point"),
    "frequency-descending": (lambda data: data.isel(frequency=[1, 0]), None, "frequency"),
    "frequency-not-finite": (with_coordinate("frequency", 2, np.nan), None, "frequency"),
    "frequency-text": (
        lambda data: data.assign_coords(frequency=[f"{f} Hz" for f in data.frequency.values]),
        Kind.WRONG_TYPE, "frequency",
    ),
    "dimension-renamed": (
        lambda data: data.assign(point_impedance_imag=data.point_impedance_imag.rename(frequency="f").drop_vars("f")),
        Kind.WRONG_TYPE, "point_impedance_imag",
    ),
    "dimension-lost": (
        lambda data: data.assign(source_response_real=data.source_response_real.isel(microphone=0, drop=True)),
        Kind.WRONG_TYPE, "source_response_real",
    ),
    "not-a-number": (
        with_value("source_response_real", (6, 1, 2), np.nan), Kind.UNSUITABLE, "source_response_real",
    ),
    "infinite": (with_value("transfer_function_imag", (0, 2, 0), np.inf), Kind.UNSUITABLE, "transfer_function_imag"),
    "whole-numbers": (
        lambda data: data.assign(point_impedance_real=data.point_impedance_real.astype("int64").drop_attrs()),
        Kind.WRONG_TYPE, "point_impedance_real",
    ),
    "value-changed": (with_value("source_response_imag", (6, 1, 2), 1.0), Kind.DAMAGED, "source_response_imag"),
    "frequency-changed": (with_coordinate("frequency", 1, 25.0), Kind.DAMAGED, "frequency"),
    "medium-changed": (with_entry("medium", "density", 1.3), Kind.DAMAGED, "medium"),
    "provenance-changed": (with_entry("provenance", "seed", 1), Kind.DAMAGED, "provenance"),
    "impedance-lost": (
        lambda data: data.drop_vars(["microphone_impedance_real", "microphone_impedance_imag"]),
        Kind.DAMAGED, "microphone_impedance_real",
    ),
    "checksums-cut": (with_attribute("checksums", "{"), Kind.UNREADABLE, "checksums"),
    "checksums-a-number": (with_attribute("checksums", 1.0), Kind.WRONG_TYPE, "checksums"),
    "of-a-later-version": (with_attribute("layout_version", 2), Kind.MISMATCH, "layout_version"),
    "of-no-version": (with_attribute("layout_version", "1"), Kind.MISMATCH, "layout_version"),
}  # fmt: skip


def altered(library, folder, change):
    """File of a library that another program changed."""
    acoustic_fem.save(library, folder / "good.nc")
    with xr.open_dataset(folder / "good.nc", engine="netcdf4", mask_and_scale=False) as opened:
        changed = change(opened.load())
    changed.to_netcdf(folder / "altered.nc", engine="netcdf4")
    return folder / "altered.nc"


@pytest.mark.parametrize("name", ALTERED)
def test_an_altered_library_is_refused_by_the_name_of_what_was_altered(library, tmp_path, name, monkeypatch):
    monkeypatch.setattr(sealed_netcdf, "_try_apart", lambda *_: None)
    change, kind, field = ALTERED[name]
    path = altered(library, tmp_path, change)
    with pytest.raises(acoustic_fem.LibraryError) as error:
        acoustic_fem.load(path)
    assert error.value.file == str(path)
    assert field in str(error.value)
    assert kind is None or (error.value.kind, error.value.field) == (kind, field)


@pytest.mark.slow
def test_the_messages_of_libraries(library, tmp_path, monkeypatch):
    monkeypatch.setattr(sealed_netcdf, "_try_apart", lambda *_: None)
    told = {
        name: lambda change=change: acoustic_fem.load(altered(library, tmp_path, change))
        for name, (change, *_) in ALTERED.items()
    }
    check_messages(Path(__file__).with_name("messages.txt"), told, {str(tmp_path): "FOLDER"})


def test_a_library_with_its_axes_in_another_order_is_the_same(library, tmp_path):
    acoustic_fem.save(library, tmp_path / "library.nc")
    with xr.open_dataset(tmp_path / "library.nc", engine="netcdf4", mask_and_scale=False) as opened:
        opened.load().transpose("frequency", "microphone_2", "microphone", "point").to_netcdf(
            tmp_path / "t.nc", engine="netcdf4"
        )
    again = acoustic_fem.load(tmp_path / "t.nc")
    for name in RESULTS:
        xr.testing.assert_identical(getattr(again, name), getattr(library, name))


@pytest.mark.parametrize("name", prototype_names())
def test_neither_a_default_nor_its_closed_forms_warn_on_any_prototype(name):
    """At 500 Hz the widest bore has a shear number of 4.6; a library is solved up to there by default."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        library = acoustic_fem.solve(name, [1.0, 500.0], "lumped")
        library.in_air(altitude=1000.0)


def test_a_warning_points_at_the_line_of_the_caller():
    with pytest.warns(UserWarning, match="shear number") as found:
        acoustic_fem.solve("glove", [1000.0], "lumped")
    assert {each.filename for each in found} == {__file__}


@pytest.mark.parametrize("fidelity", ["exact", ""])
def test_an_unknown_fidelity_is_refused_with_the_known_ones(fidelity):
    with refused(Kind.OUT_OF_RANGE, "fidelity", fidelity) as found:
        acoustic_fem.solve(DESIGN, BAND, fidelity)
    assert found.value.allowed == acoustic_fem.FIDELITIES


def test_a_library_cannot_be_changed_by_accident(library):
    with pytest.raises(dataclasses.FrozenInstanceError):
        library.fidelity = "navier-stokes"


def test_closed_forms_are_at_hand_after_import_and_load_nothing_heavy():
    code = """
import sys
import acoustic_fem
air = acoustic_fem.Medium.at()
assert acoustic_fem.duct.port_admittance(2e-4, 0.01, [1.0, 10.0], air).shape == (2, 2, 2)
assert acoustic_fem.cavity.closed_cylinder_compliance(3e-3, 3e-3, [1.0], air).shape == (1,)
heavy = {"OCP", "cadquery", "gmsh", "vtk", "vtkmodules", "torch", "skfem", "xarray", "pydantic"} & set(sys.modules)
assert not heavy, heavy
"""
    subprocess.run([sys.executable, "-c", code], check=True)


def test_an_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="acoustic_fem attribute nonsense"):
        _ = acoustic_fem.nonsense


def test_what_is_done_to_the_labels_of_one_library_does_not_show_in_the_next():
    def labels(library):
        array = library.source_response
        return array.attrs, {name: (each.values.tolist(), each.attrs) for name, each in array.coords.items()}

    first = acoustic_fem.solve(DESIGN, BAND, "lumped")
    told = labels(acoustic_fem.solve(DESIGN, BAND, "lumped"))
    first.source_response.attrs["units"] = "none"
    first.source_response["line"].values[:] = -1
    first.source_response["line"].attrs["long_name"] = "none"
    assert labels(acoustic_fem.solve(DESIGN, BAND, "lumped")) == told

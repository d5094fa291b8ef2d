"""SOFA files as other programs write them: read with a design, and refused by the variable that does not fit."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import netCDF4
import numpy as np
import pytest
import sofar
from libraries import three_points
from typer.testing import CliRunner

import acoustic_fem
from acoustic_fem.library import MEASURED, library_from_sofa
from acoustic_fem.library.exchange import export
from acoustic_fem.library.netcdf_file import LibraryError
from acoustic_fem.library.transfer_functions import Library
from geometry.design.design_file import write_design
from geometry.ground.record import seal_file
from geometry.ground.refusal import Kind
from studies.cli.app import app


@pytest.fixture(scope="module")
def library() -> Library:
    """Library of three points, two microphones and seven frequencies."""
    return three_points()


def foreign(
    library: Library,
    path: Path,
    convention: str,
    change: Callable[[Any], None] = lambda sofa: None,
    alter: Callable[[h5py.File], None] | None = None,
    *,
    seal: bool = True,
) -> Path:
    """Transfer functions of a library, in a file that states nothing else of it.

    Sealed files are read without a process of their own, which takes a second.
    """
    h = library.transfer_function.transpose("point", "microphone", "frequency").values
    sofa = sofar.Sofa(convention)
    sofa.N = library.frequency
    if convention == "GeneralTF":
        data = h
    else:
        data = h.transpose(1, 2, 0)[None]
        sofa.EmitterPosition = np.arange(3 * len(h), dtype=float).reshape(-1, 3)
    sofa.Data_Real, sofa.Data_Imag = data.real, data.imag
    sofa.ReceiverPosition = np.arange(3 * h.shape[1], dtype=float).reshape(-1, 3)
    sofa.GLOBAL_Title, sofa.GLOBAL_ApplicationName = "mouth of a flute", "Another"
    change(sofa)
    sofar.write_sofa(str(path), sofa)
    if alter is not None:
        with h5py.File(path, "r+") as file:
            alter(file)
    if seal:
        seal_file(path)
    return path


@pytest.mark.parametrize("convention", ["GeneralTF", "GeneralTF-E"])
def test_emitters_or_measurements_are_points_and_receivers_are_microphones(
    library: Library, tmp_path: Path, convention: str
) -> None:
    path = foreign(library, tmp_path / "flute.sofa", convention, seal=convention == "GeneralTF")
    found = library_from_sofa(path, library.design)
    assert np.array_equal(found.transfer_function.values, library.transfer_function.values)
    assert np.array_equal(found.frequency, library.frequency)
    assert found.fidelity == MEASURED
    assert found.transfer_function_deviation is None
    assert found.provenance["sofa"]["title"] == "mouth of a flute"
    known = acoustic_fem.solve(library.design, library.frequency, "lumped")
    assert np.array_equal(found.point_impedance.values, known.point_impedance.values)
    export(found, tmp_path / "library.nc")
    again = acoustic_fem.load(tmp_path / "library.nc")
    assert np.array_equal(again.transfer_function.values, library.transfer_function.values)


def test_the_verb_takes_the_design_and_names_it_where_it_is_missing(library: Library, tmp_path: Path) -> None:
    path = foreign(library, tmp_path / "flute.sofa", "GeneralTF")
    design, out = tmp_path / "design.toml", tmp_path / "library.nc"
    design.write_text(write_design(library.design), encoding="utf-8")
    words = ["convert", str(path), "--out", str(out)]
    refused = CliRunner().invoke(app, words)
    problem = "design is missing, because another program wrote this file; run acoustic-fem convert with --design"
    assert problem in str(refused.exception)
    done = CliRunner().invoke(app, [*words, "--design", str(design)])
    assert done.exit_code == 0, done.output
    assert "3 points, 2 microphones, 7 frequencies" in done.output
    assert acoustic_fem.load(out).design == library.design


def test_a_file_of_this_program_keeps_its_own_design(library: Library, tmp_path: Path) -> None:
    export(library, tmp_path / "own.sofa")
    with pytest.raises(LibraryError, match="design must not be given, because the file states its own"):
        library_from_sofa(tmp_path / "own.sofa", library.design)
    export(library, tmp_path / "own.nc")
    with pytest.raises(LibraryError, match="design is only allowed with a SOFA file of another program"):
        library_from_sofa(tmp_path / "own.nc", library.design)


def set_values(**values: Any) -> Callable[[Any], None]:
    def change(sofa: Any) -> None:
        for name, value in values.items():
            setattr(sofa, name, value)

    return change


def shaped(*shape: int) -> Callable[[Any], None]:
    def change(sofa: Any) -> None:
        sofa.Data_Real = sofa.Data_Imag = np.linspace(0.1, 0.2, int(np.prod(shape))).reshape(shape)
        if len(shape) == 4:
            sofa.EmitterPosition = np.zeros((shape[3], 3))
        sofa.ReceiverPosition = np.zeros((shape[1], 3))

    return change


def not_finite(sofa: Any) -> None:
    sofa.Data_Imag = sofa.Data_Imag.copy()
    sofa.Data_Imag[1, 0, 2] = np.nan


@pytest.mark.parametrize(
    ("convention", "change", "kind", "field", "words"),
    [
        ("GeneralTF", shaped(4, 2, 7), Kind.MISMATCH, "M", "is 4 measurements, but must be the 3 points"),
        ("GeneralTF", shaped(3, 1, 7), Kind.MISMATCH, "R", "is 1 receiver, but must be the 2 microphones"),
        ("GeneralTF-E", shaped(1, 2, 7, 2), Kind.MISMATCH, "E", "is 2 emitters, but must be the 3 points"),
        ("GeneralTF-E", shaped(3, 2, 7, 3), Kind.MISMATCH, "M", "3 measurements of 3 emitters"),
        ("GeneralTF", not_finite, Kind.UNSUITABLE, "Data.Imag", "M 2, R 1, N 3 must be finite"),
        ("GeneralTF", set_values(N=np.arange(7.0)), Kind.OUT_OF_RANGE, "N", "0"),
        ("GeneralTF", set_values(N=np.arange(7.0, 0, -1)), Kind.OUT_OF_RANGE, "N", "must ascend"),
    ],
)
def test_values_that_do_not_fit_are_refused_by_their_name(
    library: Library,
    tmp_path: Path,
    convention: str,
    change: Callable[[Any], None],
    kind: Kind,
    field: str,
    words: str,
) -> None:
    path = foreign(library, tmp_path / "bad.sofa", convention, change)
    with pytest.raises(LibraryError) as refused:
        library_from_sofa(path, library.design)
    assert (refused.value.kind, refused.value.field, refused.value.file) == (kind, field, str(path))
    assert words in str(refused.value)


@pytest.mark.parametrize(("name", "field"), [("N", "N"), ("Data.Imag", "Data.Imag"), ("Data.Real", "Data.Real")])
def test_a_variable_that_is_missing_is_named(library: Library, tmp_path: Path, name: str, field: str) -> None:
    def alter(file: h5py.File) -> None:
        if name == "N":  # h5netcdf needs the dimension
            del file["Data.Real"], file["Data.Imag"]
        del file[name]

    path = foreign(library, tmp_path / "bad.sofa", "GeneralTF-E", alter=alter)
    with pytest.raises(LibraryError) as refused:
        library_from_sofa(path, library.design)
    assert (refused.value.kind, refused.value.field) == (Kind.MISSING, field)


@pytest.mark.parametrize(
    ("owner", "attribute", "value", "field"),
    [
        ("/", "DataType", "FIR", "DataType"),
        ("/", "SOFAConventions", "GeneralFIR", "SOFAConventions"),
        ("N", "Units", "radian per second", "N:Units"),
        ("Data.Real", "Units", "pascal second / metre^3", "Data.Real:Units"),
    ],
)
def test_attributes_of_other_data_are_refused(
    library: Library, tmp_path: Path, owner: str, attribute: str, value: str, field: str
) -> None:
    def alter(file: h5py.File) -> None:
        file[owner].attrs[attribute] = value

    path = foreign(library, tmp_path / "bad.sofa", "GeneralTF", alter=alter)
    with pytest.raises(LibraryError) as refused:
        library_from_sofa(path, library.design)
    assert refused.value.field == field


def test_impulse_responses_are_refused_by_their_convention(library: Library, tmp_path: Path) -> None:
    sofa = sofar.Sofa("GeneralFIR")
    sofa.Data_IR, sofa.Data_Delay = np.ones((3, 2, 16)), np.zeros((1, 2))
    sofa.ReceiverPosition = np.zeros((2, 3))
    path = tmp_path / "impulses.sofa"
    sofar.write_sofa(str(path), sofa)
    seal_file(path)
    with pytest.raises(LibraryError, match=r"SOFAConventions = 'GeneralFIR' .*GeneralTF.*GeneralTF-E"):
        library_from_sofa(path, library.design)


#: Written by Octave's own functions, whose order of dimensions is the reverse: h = (point + 10 microphone) / N - 1j N.
OCTAVE = """
pkg load netcdf
n = netcdf_create('octave.sofa', netcdf_getConstant('NETCDF4'));
M = netcdf_defDim(n, 'M', 12); R = netcdf_defDim(n, 'R', 2); N = netcdf_defDim(n, 'N', 50);
g = netcdf_getConstant('GLOBAL');
netcdf_putAtt(n, g, 'SOFAConventions', 'GeneralTF'); netcdf_putAtt(n, g, 'DataType', 'TF');
vn = netcdf_defVar(n, 'N', 'double', N); netcdf_putAtt(n, vn, 'Units', 'hertz');
vr = netcdf_defVar(n, 'Data.Real', 'float', [N R M]); vi = netcdf_defVar(n, 'Data.Imag', 'float', [N R M]);
netcdf_endDef(n);
[a, b, c] = ndgrid(1:50, 1:2, 1:12);
netcdf_putVar(n, vn, 1:50); netcdf_putVar(n, vr, single((c + 10 * b) ./ a)); netcdf_putVar(n, vi, single(-a));
netcdf_close(n);
"""


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("octave-cli"), reason="octave is not installed")
def test_a_file_that_octave_writes_is_read(tmp_path: Path) -> None:
    found = subprocess.run(["octave-cli", "--eval", "pkg load netcdf"], capture_output=True, check=False)
    if found.returncode:
        pytest.skip("octave-netcdf is not installed")
    (tmp_path / "writes.m").write_text(OCTAVE, encoding="utf-8")
    # Octave may fail while it ends, when the file is written
    subprocess.run(["octave-cli", "writes.m"], cwd=tmp_path, capture_output=True, check=False)
    h = library_from_sofa(tmp_path / "octave.sofa", "array-2x6").transfer_function.values
    point, microphone, frequency = np.ogrid[1:13, 1:3, 1:51]
    assert np.allclose(h, (point + 10 * microphone) / frequency - 1j * frequency, rtol=1e-6)


def test_texts_of_any_length_and_numbers_in_single_precision_are_read(library: Library, tmp_path: Path) -> None:
    path = tmp_path / "single.sofa"
    h = library.transfer_function.transpose("microphone", "frequency", "point").values[None]
    with netCDF4.Dataset(path, "w") as file:
        for name, text in (("SOFAConventions", "GeneralTF-E"), ("DataType", "TF-E")):
            file.setncattr_string(name, text)
        for name, size in zip("MRNE", h.shape, strict=True):
            file.createDimension(name, size)
        grid = file.createVariable("N", "f8", ("N",))
        grid[:] = library.frequency
        grid.setncattr_string("Units", "hertz")
        for name, part in (("Data.Real", h.real), ("Data.Imag", h.imag)):
            file.createVariable(name, "f4", tuple("MRNE"), zlib=True)[:] = part
    seal_file(path)
    found = library_from_sofa(path, library.design)
    assert found.transfer_function.dtype == np.complex128
    assert np.allclose(found.transfer_function.values, library.transfer_function.values, rtol=1e-6)

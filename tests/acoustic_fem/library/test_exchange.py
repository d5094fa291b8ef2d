"""Libraries in formats of other programs: round trips to the last digit, files that others accept, bad ones by name."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pytest
import scipy.io
import sofar
from libraries import GRID, assert_same_library, library_of, three_points
from refusals import refused

import acoustic_fem
import geometry
from acoustic_fem.circuit import fit_sensor, save_netlist, save_state_space, sensor_circuit
from acoustic_fem.library.exchange import export, load
from acoustic_fem.library.netcdf_file import LibraryError
from acoustic_fem.library.transfer_functions import MEASURED, VARIABLES, Library, library_from_arrays
from geometry.ground.refusal import Kind


@pytest.fixture(scope="module")
def library() -> Library:
    return three_points()


def with_deviation(library: Library) -> Library:
    values = {name: getattr(library, name).values for name in VARIABLES}
    deviation = np.random.default_rng(0).uniform(0, 0.1, values["transfer_function"].shape)
    return library_from_arrays(
        library.design, library.frequency, values, "measured", library.medium,
        library.provenance, deviation,
    )  # fmt: skip


@pytest.mark.parametrize("suffix", [".sofa", ".npz", ".mat", ".csv", ".nc"])
@pytest.mark.parametrize("measured", [False, True], ids=["computed", "measured"])
def test_what_is_read_back_is_what_was_written(suffix: str, measured: bool, library: Library, tmp_path: Path) -> None:
    expected = with_deviation(library) if measured else library
    path = tmp_path / f"library{suffix}"
    export(expected, path)
    assert_same_library(load(path), expected)


@pytest.mark.parametrize("suffix", [".sofa", ".npz", ".mat", ".csv"])
def test_one_point_one_frequency_and_three_microphones_come_back_too(suffix: str, tmp_path: Path) -> None:
    single = acoustic_fem.solve(
        geometry.prototype("array-2x6").with_values({"lines.0.points": 1, "layout.columns": 1}), [50.0], "lumped"
    )
    for number, expected in enumerate((single, library_of("fingertip-3x4"))):
        path = tmp_path / f"{number}{suffix}"
        export(expected, path)
        assert_same_library(load(path), expected)


def test_sofar_verifies_the_file_and_finds_points_as_emitters_and_microphones_as_receivers(
    library: Library, tmp_path: Path
) -> None:
    path = tmp_path / "library.sofa"
    export(with_deviation(library), path)
    sofa = sofar.read_sofa(str(path), verify=True, verbose=False)
    assert sofa.verify(issue_handling="return", mode="read") is None
    assert sofa.GLOBAL_SOFAConventions == "GeneralTF-E"
    assert sofa.Data_Real.shape == (1, 2, 7, 3)
    h = sofa.Data_Real[0, 1, 4, 2] + 1j * sofa.Data_Imag[0, 1, 4, 2]
    assert h == library.transfer_function.values[2, 1, 4]
    assert np.array_equal(sofa.N, GRID)
    step = np.diff(sofa.EmitterPosition.reshape(3, 3), axis=0)
    assert np.allclose(np.linalg.norm(step, axis=1), np.linalg.norm(step[0]))
    assert 0.01 < np.linalg.norm(step[0]) < 0.05


def test_a_table_whose_repeated_columns_disagree_is_refused(library: Library, tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    export(library, path)
    lines = path.read_text(encoding="utf-8").splitlines()
    lines[-1] = lines[-1].rpartition(",")[0] + ",1.5"  # of the last point, whose rows repeat those of the first
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    with pytest.raises(LibraryError, match=r"a\.csv: .*microphone_impedance_B_imag is not the same in the rows"):
        load(path)


def test_the_rows_of_a_table_are_readable_by_others(library: Library, tmp_path: Path) -> None:
    path = tmp_path / "library.csv"
    export(library, path)
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    assert len(rows) == 3 * 2 * 7
    (row,) = [r for r in rows if (r["point"], r["microphone"], float(r["frequency"])) == ("3", "B", GRID[4])]
    assert float(row["transfer_function_real"]) == library.transfer_function.values[2, 1, 4].real


def test_files_that_are_no_library_are_refused_in_one_line(library: Library, tmp_path: Path) -> None:
    foreign = sofar.Sofa("GeneralTF-E")
    sofar.write_sofa(str(tmp_path / "foreign.sofa"), foreign)
    sofar.write_sofa(str(tmp_path / "hrtf.sofa"), sofar.Sofa("SimpleFreeFieldHRIR"))
    np.savez(tmp_path / "foreign.npz", a=np.ones(3))
    (tmp_path / "foreign.csv").write_text("a,b\n1,2\n")
    (tmp_path / "a.wav").write_bytes(b"RIFF")
    for suffix in (".sofa", ".npz", ".csv"):
        whole = tmp_path / f"whole{suffix}"
        export(library, whole)
        content = whole.read_bytes()
        (tmp_path / f"short{suffix}").write_bytes(content[: len(content) * 2 // 3])
        (tmp_path / f"empty{suffix}").write_bytes(b"")
    text = (tmp_path / "whole.csv").read_text(encoding="utf-8")
    (tmp_path / "altered.csv").write_text(text.replace("layout.columns", "layout.column"), encoding="utf-8")
    (tmp_path / "number.csv").write_text(text + text.splitlines()[-1].rsplit(",", 1)[0] + ",x\n", encoding="utf-8")
    for name, kind, field in (
        ("foreign.sofa", Kind.MISSING, "design"),
        ("hrtf.sofa", Kind.UNREADABLE, ""),
        ("foreign.npz", Kind.MISSING, "frequency"),
        ("foreign.csv", Kind.UNREADABLE, ""),
        ("short.sofa", Kind.UNREADABLE, ""),
        ("short.npz", Kind.UNREADABLE, ""),
        ("short.csv", None, ""),
        ("empty.sofa", Kind.UNREADABLE, ""),
        ("empty.npz", Kind.UNREADABLE, ""),
        ("empty.csv", Kind.UNREADABLE, ""),
        ("number.csv", Kind.WRONG_TYPE, "row 43"),
        ("none.sofa", Kind.MISSING, ""),
        ("a.wav", Kind.UNSUITABLE, ""),
    ):
        with pytest.raises(LibraryError) as refused:
            load(tmp_path / name)
        assert refused.value.file == str(tmp_path / name)
        assert kind is None or (refused.value.kind, refused.value.field) == (kind, field), name
        assert "\n" not in str(refused.value), name


def test_what_convert_writes_beside_libraries_and_other_files_are_named_with_what_to_do(
    library: Library, tmp_path: Path
) -> None:
    many = acoustic_fem.solve(library.design, np.linspace(1.0, 100.0, 60), "lumped")
    for suffix in (".mat", ".npz"):
        save_state_space(fit_sensor(many, tolerance=0.1), tmp_path / f"sensor{suffix}")
    save_netlist(sensor_circuit(many), tmp_path / "sensor.cir")
    np.savez(tmp_path / "touches.npz", signals=np.ones((2, 300)), sample_rate=1000)
    for name, text in (
        ("other.cir", "* an amplifier\nR1 1 0 5\n.end\n"),
        ("a.s2p", "# HZ S RI R 50\n1 0 0 0 0 0 0 0 0\n"),
        ("b.s1p", "! a remark\n# GHz S MA R 50\n1 1 0\n"),
        ("c.ts", "[Version] 2.0\n# Hz Z RI\n"),
        ("a.toml", "schema = 3\n"),
        ("a.json", '{"time": 0}\n'),
    ):
        (tmp_path / name).write_text(text, encoding="utf-8")
    for name, what, remedy in (
        ("sensor.mat", "is a state space that convert wrote", "convert the library that it was made from"),
        ("sensor.npz", "is a state space that convert wrote", "convert the library that it was made from"),
        ("sensor.cir", "is a circuit that convert wrote", "convert the library that it was made from"),
        ("other.cir", "is a SPICE netlist", "convert reads no netlists"),
        ("touches.npz", "is a recording", "with calibrate"),
        ("a.s2p", "is a Touchstone file", "docs/formats.md"),
        ("b.s1p", "is a Touchstone file", "docs/formats.md"),
        ("c.ts", "is a Touchstone file", "docs/formats.md"),
        ("a.toml", "is a design, a study or a manifest", "with solve"),
        ("a.json", "holds JSON", "give a library"),
    ):
        with refused(Kind.UNSUITABLE, file=name, error=LibraryError) as found:
            load(tmp_path / name)
        assert f"{name}: {what}, not a library; " in str(found.value)
        assert str(found.value).endswith(remedy)


@pytest.mark.parametrize("name", ["touches.csv", "touches.npz", "other.sofa", "other.nc"])
def test_a_file_that_is_no_library_is_not_written_over(library: Library, tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_text("time,A\n0,1\n")
    with pytest.raises(LibraryError, match="exists, and is not a readable library; name another file"):
        export(library, path)
    assert path.read_text() == "time,A\n0,1\n"


def test_save_replaces_files_of_its_own_kind_only(library: Library, tmp_path: Path) -> None:
    recording = tmp_path / "touches.wav"
    recording.write_text("sound")
    with pytest.raises(LibraryError, match=r"touches\.wav: exists, and only a \.nc file is replaced"):
        acoustic_fem.save(library, recording)
    assert recording.read_text() == "sound"
    for _ in range(2):
        acoustic_fem.save(library, tmp_path / "library.nc")


@pytest.mark.parametrize("write", [acoustic_fem.save, export], ids=["save", "export"])
def test_what_cannot_be_computed_again_is_known_by_its_content(
    library: Library, tmp_path: Path, write: Callable[[Library, Path], None]
) -> None:
    path = tmp_path / "library.nc"
    path.write_bytes(b"CDF, of another program")
    with pytest.raises(LibraryError, match=r"library\.nc: exists, and is not a readable library; name another"):
        write(library, path)
    assert path.read_bytes() == b"CDF, of another program"
    path.unlink()
    write(replace(library, fidelity=MEASURED), path)
    before = path.read_bytes()
    with pytest.raises(LibraryError, match=r"library\.nc: exists, and a measured library is never overwritten; name"):
        write(library, path)
    assert path.read_bytes() == before


def test_every_format_says_its_units_names_and_time_convention(library: Library, tmp_path: Path) -> None:
    for suffix in (".sofa", ".npz", ".mat", ".csv", ".nc"):
        export(library, tmp_path / f"library{suffix}")
    with np.load(tmp_path / "library.npz") as arrays:
        assert "source_response_real: Pa s/m^3" in arrays["units"].tolist()
        assert arrays["microphone"].tolist() == ["A", "B"]
        assert arrays["point"].tolist() == [1, 2, 3]
        assert str(arrays["time_convention"]) == "exp(+j omega t)"
    content = scipy.io.loadmat(tmp_path / "library.mat", squeeze_me=True)
    assert content["units"]["source_response"] == "Pa s/m^3"
    assert content["units"]["frequency"] == "Hz"
    assert content["microphone"].tolist() == ["A", "B"]
    assert content["transfer_function"][2, 1, 4] == library.transfer_function.values[2, 1, 4]
    sofa = sofar.read_sofa(str(tmp_path / "library.sofa"), verify=True, verbose=False)
    assert sofa.SourceResponseReal_Units == "pascal second / metre^3"
    assert sofa.GLOBAL_ReceiverDescription == "microphones in this order: A, B"
    remarks = dict(
        line[2:].split(": ", 1)
        for line in (tmp_path / "library.csv").read_text(encoding="utf-8").splitlines()
        if line.startswith("# ")
    )
    assert json.loads(remarks["units"])["point_impedance_real"] == "Pa s/m^3"
    assert json.loads(remarks["time_convention"]) == "exp(+j omega t)"


def test_texts_of_a_netcdf_file_have_a_fixed_length_and_coordinates_no_fill_value(
    library: Library, tmp_path: Path
) -> None:
    path = tmp_path / "library.nc"
    named = replace(library, provenance={**library.provenance, "made by": "Zoë, µ"})
    export(named, path)
    with h5py.File(path) as file:
        for owner in (file, *file.values()):
            for name in owner.attrs:
                assert not h5py.check_string_dtype(owner.attrs.get_id(name).dtype) or (
                    h5py.check_string_dtype(owner.attrs.get_id(name).dtype).length is not None
                ), name
        assert "_FillValue" not in file["frequency"].attrs
        assert file["microphone"].dtype == "S1"
        assert library.fidelity in file.attrs["history"].decode()
    assert load(path).provenance["made by"] == "Zoë, µ"
    # as long as HDF5 takes no text of a fixed length
    long = replace(library, provenance={**library.provenance, "note": "x" * 70_000})
    export(long, path)
    assert load(path).provenance["note"] == "x" * 70_000

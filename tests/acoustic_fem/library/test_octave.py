"""Libraries as Octave reads them: all numbers, names, units and texts of every format that it knows."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.io
from libraries import three_points

from acoustic_fem.library.exchange import export
from acoustic_fem.library.library_parts import TEXTS, units_of
from acoustic_fem.library.netcdf_file import coordinates_of, dataset_of
from acoustic_fem.library.transfer_functions import VARIABLES, Library

#: All that Octave finds in a netCDF file: values by name, dimensions in the order of the file, and attributes as texts.
NETCDF = """
    pkg load netcdf
    info = ncinfo(file);
    for each = info.Attributes
        found.attributes.(each.Name) = each.Value;
    end
    for each = info.Variables
        name = strrep(each.Name, '.', '_');
        values = ncread(file, each.Name);
        found.values.(name) = permute(values, ndims(values):-1:1);
        for own = each.Attributes
            found.texts.(name).(strrep(own.Name, '_FillValue', 'fill_value')) = own.Value;
        end
    end
"""
SCRIPTS = {
    ".nc": NETCDF,
    ".sofa": NETCDF,
    ".mat": "found = load(file);",
    ".csv": """
        lines = strsplit(strtrim(fileread(file)), "\\n");
        is_remark = strncmp(lines, '# ', 2);
        for each = lines(is_remark)
            [name, text] = strtok(each{1}(3:end), ':');
            found.texts.(name) = text(3:end);
        end
        table = cellfun(@(line) strsplit(line, ','), lines(! is_remark), 'UniformOutput', false);
        found.microphone = cellfun(@(row) row{2}, table(2:end), 'UniformOutput', false);
        for k = 1:numel(table{1})
            found.values.(table{1}{k}) = cellfun(@(row) str2double(row{k}), table(2:end));
        end
    """,
}


def found_by_octave(library: Library, suffix: str, folder: Path) -> dict[str, Any]:
    """What Octave reads of a library in a format."""
    export(library, folder / f"library{suffix}")
    if "pkg load netcdf" in SCRIPTS[suffix]:
        loaded = subprocess.run(["octave-cli", "--eval", "pkg load netcdf"], capture_output=True, check=False)
        if loaded.returncode:
            pytest.skip("octave-netcdf is not installed")
    script = f"file = 'library{suffix}';\n{SCRIPTS[suffix]}\nsave('-v7', 'found.mat', 'found');\n"
    (folder / "reads.m").write_text(script)
    done = subprocess.run(["octave-cli", "reads.m"], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found: dict[str, Any] = scipy.io.loadmat(folder / "found.mat", simplify_cells=True)["found"]
    return found


def same(found: Any, expected: Any) -> None:
    """Equal to the last digit."""
    np.testing.assert_array_equal(np.squeeze(np.asarray(found)), np.squeeze(np.asarray(expected)))


def responses(library: Library, *more: str) -> dict[str, np.ndarray]:
    """Every response of a library, its dimensions in the order of files."""
    found = {name: getattr(library, name).transpose(*VARIABLES[name][0]).values for name in VARIABLES}
    return {**found, **{name: getattr(library, name).values for name in more}}


def check_netcdf(found: dict[str, Any], library: Library) -> None:
    dataset = dataset_of(library, (*VARIABLES, "force_response"))
    for name, expected in responses(library, "force_response").items():
        same(found["values"][f"{name}_real"] + 1j * found["values"][f"{name}_imag"], expected)
    for name in dataset.data_vars:
        assert found["texts"][name]["units"] == dataset[name].attrs["units"]
        assert found["texts"][name]["long_name"] == dataset[name].attrs["long_name"]
    for name in ("point", "line", "place"):
        same(found["values"][name], coordinates_of(library.design)[name])
    same(found["values"]["frequency"], library.frequency)
    assert found["texts"]["frequency"]["units"] == "Hz"
    assert "fill_value" not in found["texts"]["frequency"]
    assert "".join(found["values"]["microphone"].ravel()) == "AB"
    for name in (*TEXTS, "time_convention", "Conventions", "title", "history"):
        assert found["attributes"][name] == dataset.attrs[name], name


def check_sofa(found: dict[str, Any], library: Library) -> None:
    dataset, own = dataset_of(library), {"transfer_function": ("Data_Real", "Data_Imag")}
    for name, expected in responses(library).items():
        words = "".join(word.capitalize() for word in name.split("_"))
        real, imaginary = own.get(name, (f"{words}Real", f"{words}Imag"))
        values = np.asarray(found["values"][real] + 1j * found["values"][imaginary])
        if set(VARIABLES[name][0]) == {"point", "microphone", "frequency"}:
            values = np.squeeze(values).transpose(2, 0, 1)  # receivers, frequencies, emitters
        same(values, expected)
        if name not in own:
            assert found["texts"][real]["Units"] == "pascal second / metre^3"
            assert found["texts"][real]["LongName"] == dataset[f"{name}_real"].attrs["long_name"]
    same(found["values"]["N"], library.frequency)
    assert found["texts"]["N"]["Units"] == "hertz"
    assert found["attributes"]["ReceiverDescription"] == "microphones in this order: A, B"
    assert found["attributes"]["EmitterDescription"] == "points in this order: 1, 2, 3"
    assert found["attributes"]["Comment"].endswith("exp(+j omega t)")
    for name in TEXTS:
        assert found["attributes"]["".join(word.capitalize() for word in name.split("_"))] == dataset.attrs[name]


def check_mat(found: dict[str, Any], library: Library) -> None:
    dataset = dataset_of(library)
    for name, expected in responses(library).items():
        same(found[name], expected)
        assert found["units"][name] == dataset[f"{name}_real"].attrs["units"]
    same(found["frequency"], library.frequency)
    assert found["units"]["frequency"] == "Hz"
    assert list(found["microphone"]) == ["A", "B"]
    for name in ("point", "line", "place"):
        same(found[name], coordinates_of(library.design)[name])
    assert found["time_convention"] == "exp(+j omega t)"
    for name in TEXTS:
        assert found[name] == dataset.attrs[name]


def check_csv(found: dict[str, Any], library: Library) -> None:
    dataset, shape = dataset_of(library), (3, 2, 7)
    values = {name: column.reshape(shape) for name, column in found["values"].items()}
    for name, expected in responses(library).items():
        of = VARIABLES[name][0]
        if "microphone_2" in of:
            parts = [[values[f"{name}_{second}_{part}"][0] for second in "AB"] for part in ("real", "imag")]
            both = np.moveaxis(np.array(parts[0]) + 1j * np.array(parts[1]), 0, of.index("microphone_2"))
            same(both, expected)
            continue
        full = values[f"{name}_real"] + 1j * values[f"{name}_imag"]
        same(full, np.broadcast_to(expected[:, None] if "microphone" not in of else expected, shape))
    same(values["frequency"], np.broadcast_to(library.frequency, shape))
    same(values["point"][:, 0, 0], [1, 2, 3])
    assert list(found["microphone"].reshape(shape)[0, :, 0]) == ["A", "B"]
    assert json.loads(found["texts"]["units"]) == units_of(dataset)
    assert json.loads(found["texts"]["time_convention"]) == "exp(+j omega t)"
    for name in TEXTS:
        assert json.loads(found["texts"][name]) == dataset.attrs[name]


CHECKS: dict[str, Callable[[dict[str, Any], Library], None]] = {
    ".nc": check_netcdf,
    ".sofa": check_sofa,
    ".mat": check_mat,
    ".csv": check_csv,
}


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("octave-cli"), reason="octave is not installed")
@pytest.mark.parametrize("suffix", SCRIPTS)
def test_octave_reads_a_library_whole(suffix: str, tmp_path: Path) -> None:
    library = three_points()
    CHECKS[suffix](found_by_octave(library, suffix, tmp_path), library)

"""Libraries as Octave reads them: numbers, names, units and texts of every format."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from libraries import three_points

from acoustic_fem.library.exchange import export

#: What each format is read with, as Octave's words; prints a complex number, a unit, a name and the convention.
SCRIPTS = {
    ".nc": """
        pkg load netcdf
        h = ncread(file, 'transfer_function_real') + 1j * ncread(file, 'transfer_function_imag');
        h = h(5, 2, 3);
        unit = ncreadatt(file, 'transfer_function_real', 'units');
        name = ncread(file, 'microphone')(:, 2)';
        convention = ncreadatt(file, '/', 'time_convention');
        assert(any(strcmp({ncinfo(file).Attributes.Name}, 'design_toml')));
        assert(! any(strcmp({ncinfo(file, 'frequency').Attributes.Name}, '_FillValue')));
    """,
    ".mat": """
        library = load(file);
        h = library.transfer_function(3, 2, 5);
        unit = library.units.transfer_function;
        name = library.microphone{2};
        convention = library.time_convention;
    """,
    ".sofa": """
        pkg load netcdf
        h = ncread(file, 'Data.Real') + 1j * ncread(file, 'Data.Imag');
        h = h(3, 5, 2, 1);
        unit = 'Pa/Pa';
        assert(! isempty(ncreadatt(file, 'SourceResponseReal', 'Units')));
        name = ncreadatt(file, '/', 'ReceiverDescription')(end);
        convention = regexp(ncreadatt(file, '/', 'Comment'), 'exp.*', 'match'){1};
    """,
    ".csv": """
        lines = strsplit(fileread(file), "\\n");
        remarks = lines(strncmp(lines, '# ', 2));
        unit = jsondecode(remarks{strncmp(remarks, '# units', 7)}(10:end)).transfer_function_real;
        convention = jsondecode(['[' remarks{strncmp(remarks, '# time_convention', 17)}(20:end) ']']){1};
        table = lines(! strncmp(lines, '# ', 2));
        head = strsplit(table{1}, ',');
        row = strsplit(table{1 + 2 * 2 * 7 + 7 + 5}, ',');
        name = row{2};
        value = @(column) str2double(row{strcmp(head, column)});
        h = value('transfer_function_real') + 1j * value('transfer_function_imag');
    """,
}


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("octave-cli"), reason="octave is not installed")
@pytest.mark.parametrize("suffix", SCRIPTS)
def test_octave_reads_a_library_whole(suffix: str, tmp_path: Path) -> None:
    library = three_points()
    export(library, tmp_path / f"library{suffix}")
    if "pkg load netcdf" in SCRIPTS[suffix]:
        found = subprocess.run(["octave-cli", "--eval", "pkg load netcdf"], capture_output=True, check=False)
        if found.returncode:
            pytest.skip("octave-netcdf is not installed")
    shown = "printf('%.17g|%.17g|%s|%s|%s', real(h), imag(h), unit, name, convention);"
    (tmp_path / "reads.m").write_text(f"file = 'library{suffix}';\n{SCRIPTS[suffix]}\n{shown}\n")
    done = subprocess.run(["octave-cli", "reads.m"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    real, imaginary, *texts = done.stdout.split("|")
    assert complex(float(real), float(imaginary)) == library.transfer_function.values[2, 1, 4]
    assert texts == ["Pa/Pa", "B", "exp(+j omega t)"]

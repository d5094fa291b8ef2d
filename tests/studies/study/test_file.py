"""Study files: what they say is what the study has, and everything else is refused by name."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from geometry import DesignError, prototype, save_design
from geometry.ground.refusal import Refusal
from studies.study.cases import cases_of
from studies.study.file import load_study, read_study
from studies.study.study import StudyError

HEAD = 'base = "array-2x6"\nmetrics = ["distance_smallest"]\nfidelity = "lumped"\n'
PARAMETERS = '[parameters]\n"tube.length" = [12.5, 14]\n'


def study(head: str = "", parameters: str = PARAMETERS, base: str = HEAD) -> str:
    return base + head + "\n" + parameters


def test_a_study_has_what_its_file_says() -> None:
    given = read_study(
        study(
            'name = "tubes"\nsampling = "sobol"\ncases = 8\nseed = 3\nfrequencies = "0.5:200:25"\n'
            'constraints = ["tube.length > 20 * tube.inner_diameter"]\n',
            '[parameters]\n"tube.inner_diameter" = {from = 0.3, to = 0.6, scale = "log"}\n'
            'membrane.material = ["silicone-shore-a-30", "silicone-shore-a-10"]\n'
            '[[together]]\n"resonator.cavity_height" = [2.5, 3]\n"resonator.cavity_diameter" = [6, 7]\n',
        )
    )
    assert given.name == "tubes"
    assert (given.sampling, given.cases, given.seed) == ("sobol", 8, 3)
    np.testing.assert_array_equal(given.frequency, np.linspace(0.5, 200, 25))
    assert [[parameter.name for parameter in axis] for axis in given.axes] == [
        ["tube.inner_diameter"],
        ["membrane.material"],
        ["resonator.cavity_height", "resonator.cavity_diameter"],
    ]
    assert given.constraints[0].names == ("tube.length", "tube.inner_diameter")
    assert given.base == prototype("array-2x6")


def test_comments_and_order_of_lines_are_not_part_of_what_a_study_computes() -> None:
    assert read_study("# a comment\n" + study()).digest() == read_study(study()).digest()
    assert read_study(study("seed = 1\n")).digest() != read_study(study()).digest()


def test_the_base_design_is_looked_for_beside_the_study(tmp_path: Path) -> None:
    save_design(prototype("line-3").with_values({"tube.length": 20.0}), tmp_path / "mine.toml")
    (tmp_path / "study.toml").write_text(study(base=HEAD.replace("array-2x6", "mine.toml")))
    assert load_study(tmp_path / "study.toml").base.tube.length == 20


@pytest.mark.parametrize(
    ("head", "message"),
    [
        ("cases = 3", "cases = 3 must not be given for sampling = 'grid'"),
        ('sampling = "sobol"', "cases is missing: sampling = 'sobol' needs the number of samples"),
        ('sampling = "random"\ncases = 0', "cases = 0 must be a whole number between 1 and 10000000"),
        ('sampling = "grit"', "sampling = 'grit' must be one of: grid, latin-hypercube, sobol, random"),
        ("seed = -1", "seed = -1 must be a whole number between 0"),
        ("basis = 3", "basis = 3 is not a field of a study; did you mean 'base'?"),
        ('frequencies = "1:100"', "frequencies = '1:100' must be FIRST:LAST:COUNT in Hz"),
        ('frequencies = "-1:100:3"', "frequencies = '-1:100:3': frequency = -1 Hz must be between"),
        ('constraints = ["tube.lenth > 3"]', "constraint 'tube.lenth > 3': array-2x6: tube.lenth is not a field"),
        ('constraints = ["tube.length"]', "constraint 'tube.length' must compare values"),
        ('constraints = ["tube > 3"]', "tube must be a number or a text, not a table or a list"),
        ("constraints = [\"__import__('os')\"]", "holds what is not allowed"),
        ('constraints = ["().__class__ == 3"]', "holds what is not allowed"),
        ('constraints = ["tube.length > 9 ** 9 ** 9"]', "holds what is not allowed"),
        ('constraints = ["tube.length >"]', "cannot be read"),
    ],
)
def test_a_wrong_field_is_refused_by_name(head: str, message: str) -> None:
    with pytest.raises(StudyError) as refusal:
        read_study(study(head + "\n"), "s.toml")
    assert str(refusal.value).startswith("s.toml: ")
    assert message in str(refusal.value)
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ('"tube.inner_diameter" = [9]', "tube.inner_diameter = 9 mm must be between 0.05 and 5 mm"),
        ('"tube.inner_diameter" = ["x"]', "tube.inner_diameter = 'x' must be a number between 0.05 and 5 mm"),
        ('"tube.inner_diameter" = [nan]', "must be a finite number"),
        ('"tube.inner_diameter" = [true]', "must be a number"),
        ('"tube.inner_diameter" = 0.4', "must be a list of values, or a range"),
        ('"tube.inner_diameter" = []', "must be a list of values, or a range"),
        ('"tube.inner_diameter" = {from = 0.4}', "must be a list of values, or a range"),
        ('"tube.inner_diameter" = {from = 0.4, to = 0.3, count = 3}', "from = 0.4 must be below to = 0.3"),
        ('"tube.inner_diameter" = {from = 0.3, to = 0.4}', "count is missing: a grid needs the number of values"),
        ('"tube.inner_diameter" = {from = 0.3, to = 0.4, count = 1}', "count = 1 must be a whole number between 2"),
        ('"tube.inner_diamete" = [0.4]', "did you mean 'inner_diameter'?"),
        ('"tube" = [0.4]', "give the fields in it"),
        ('"resonator.cavity_volume" = [70.0]', "resonator.cavity_volume is not a field of this design"),
        ('"lines.3.points" = [3]', "lines.3.points is not a field of this design"),
        ('"lines.0.points" = {from = 2.5, to = 4}', "from = 2.5 must be a whole number"),
        ('"lines.0.tube.length" = [3.0]', "lines.0.tube is not given"),
        ('"membrane.material" = {from = 1, to = 2, count = 3}', "is a text: give a list of values"),
        ("", "parameters is missing: a study varies at least one field"),
    ],
)
def test_a_wrong_parameter_is_refused_by_name(line: str, message: str) -> None:
    with pytest.raises(StudyError) as refusal:
        read_study(study(parameters=f"[parameters]\n{line}\n"), "s.toml")
    assert message in str(refusal.value)


def test_parameters_that_go_together_must_have_equally_many_values() -> None:
    text = study(parameters='[[together]]\n"tube.length" = [9, 10]\n"tube.inner_diameter" = [0.3, 0.4, 0.5]\n')
    with pytest.raises(StudyError, match=r"tube\.length has 2, tube\.inner_diameter has 3"):
        read_study(text)


def test_a_parameter_given_twice_is_refused() -> None:
    with pytest.raises(StudyError, match=r"tube\.length must be given once"):
        read_study(study(parameters=PARAMETERS + '[[together]]\n"tube.length" = [9, 10]\n'))


@pytest.mark.parametrize(
    ("base", "message"),
    [
        ("x" * 300, "neither a file in .* nor a prototype"),
        ("folder", "neither a file in .* nor a prototype"),
        ("/dev/zero", "study.toml: base = '/dev/zero' is neither a file in .* nor a prototype"),
        ("", "study.toml: base = '' is neither a file in .* nor a prototype"),
        ("a\\u0000b", "neither a file in .* nor a prototype"),
    ],
)
def test_a_base_that_is_no_file_is_refused(base: str, message: str, tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    (tmp_path / "study.toml").write_text(f'base = "{base}"\nmetrics = ["distance_smallest"]\n')
    with pytest.raises(Refusal, match=message):
        load_study(tmp_path / "study.toml")


def test_an_unknown_metric_or_base_is_refused_with_the_known_ones() -> None:
    with pytest.raises(StudyError, match="did you mean distance_smallest"):
        read_study(study().replace("distance_smallest", "distance_smalest"))
    with pytest.raises(StudyError, match=r"neither a file in .* nor a prototype; known: array-2x6"):
        read_study(study().replace("array-2x6", "array-9"))


def test_a_file_that_is_no_study_is_refused(tmp_path: Path) -> None:
    with pytest.raises(StudyError, match="no such file"):
        load_study(tmp_path / "none.toml")
    with pytest.raises(StudyError, match="is a folder"):
        load_study(tmp_path)
    (tmp_path / "cut.toml").write_text(study()[:-4])
    with pytest.raises(StudyError, match=r"cut\.toml: is not TOML"):
        load_study(tmp_path / "cut.toml")
    (tmp_path / "binary.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(StudyError, match="byte 0 is not UTF-8"):
        load_study(tmp_path / "binary.toml")
    (tmp_path / "bad.toml").write_text('name = "a"\n')
    (tmp_path / "study.toml").write_text(study(base=HEAD.replace("array-2x6", "bad.toml")))
    with pytest.raises(DesignError, match=r"bad\.toml"):
        load_study(tmp_path / "study.toml")


SHEETS = """
base = "array-2x6"
metrics = ["distance_smallest"]
fidelity = "lumped"
{more}
[parameters]
"membrane.thickness" = {{from = 0.3, to = 0.75, step = {step}}}
"""


def test_a_range_with_a_step_has_only_sizes_that_can_be_bought() -> None:
    grid = cases_of(read_study(SHEETS.format(more="", step=0.1)))
    assert grid.columns[0].tolist() == [0.3, 0.4, 0.5, 0.6, 0.7]
    samples = cases_of(read_study(SHEETS.format(more='sampling = "random"\ncases = 60', step=0.1)))
    assert set(samples.columns[0].tolist()) == {0.3, 0.4, 0.5, 0.6, 0.7}


@pytest.mark.parametrize(
    ("given", "field", "digits"),
    [
        ("{from = 4, to = 7}", "resonator.cavity_diameter", 3),
        ("{from = 0.3123, to = 0.75}", "membrane.thickness", 4),
        ('{from = 8, to = 30.5, scale = "log"}', "tube.length", 3),
        ("{from = 101000, to = 101999}", "air.pressure", 0),
    ],
)
def test_values_of_a_plain_range_are_such_that_somebody_can_make_them(given: str, field: str, digits: int) -> None:
    text = SHEETS.format(more='sampling = "sobol"\ncases = 64', step=0.1).rpartition('"membrane')[0]
    (values,) = cases_of(read_study(f'{text}"{field}" = {given}')).columns
    assert values.tolist() == np.round(values, digits).tolist()
    assert all(len(f"{value:g}") <= 6 for value in values.tolist())
    assert len(set(values.tolist())) > 60
    low, high = (float(word) for word in re.findall(r"(?:from|to) = ([\d.]+)", given))
    assert low <= values.min() < values.max() <= high


def test_a_step_beyond_its_range_is_refused() -> None:
    with pytest.raises(StudyError, match=r"membrane\.thickness\.step = 0\.5 must be at most 0\.45, its range"):
        read_study(SHEETS.format(more="", step=0.5))

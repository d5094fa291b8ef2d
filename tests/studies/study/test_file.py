"""Study files: what they say is what the study has, and everything else is refused by name."""

from __future__ import annotations

import re
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from refusals import check_messages, refused

from geometry import DesignError, Kind, prototype, save_design
from geometry.design.design_file import prototype_text
from studies.study.cases import cases_of
from studies.study.parameter import StudyError
from studies.study.study import load_study, read_study, resolve_study

HEAD = 'base = "array-2x6"\nmetrics = ["distance_smallest"]\nfidelity = "lumped"\nstock = "off"\n'
PARAMETERS = '[vary]\n"tube.length" = [12.5, 14]\n'


def study(head: str = "", parameters: str = PARAMETERS, base: str = HEAD) -> str:
    return base + head + "\n" + parameters


def test_a_study_has_what_its_file_says() -> None:
    given = read_study(
        study(
            'name = "tubes"\nsampling = "sobol"\ncases = 8\nseed = 3\nfrequency = "0.5:200:25"\n'
            'constraints = ["tube.length > 20 * tube.inner_diameter"]\n',
            '[vary]\n"tube.inner_diameter" = {from = 0.3, to = 0.6, scale = "log"}\n'
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


def test_a_design_file_is_recognized_and_the_study_file_of_the_message_sweeps_it(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(prototype_text("array-2x6"))
    with refused(Kind.WRONG_TYPE, file=str(path), error=StudyError) as caught:
        load_study(path)
    example = str(caught.value).split("): ")[1].replace(" / ", "\n")
    assert len(read_study(example).axes) == 1


#: Mistakes in a study file -> kind and field of the refusal.
WRONG_FIELDS = {
    "cases = 3": (Kind.CONFLICT, "cases"),
    'sampling = "sobol"': (Kind.MISSING, "cases"),
    'sampling = "random"\ncases = 0': (Kind.OUT_OF_RANGE, "cases"),
    'sampling = "grit"': (Kind.OUT_OF_RANGE, "sampling"),
    "seed = -1": (Kind.OUT_OF_RANGE, "seed"),
    "basis = 3": (Kind.UNKNOWN, "basis"),
    'frequency = "1:100"': (Kind.WRONG_TYPE, "frequency"),
    'frequency = "-1:100:3"': (Kind.OUT_OF_RANGE, "frequency"),
    'frequency = "5:50:10"': (Kind.UNSUITABLE, "frequency"),
    'constraints = ["tube.lenth > 3"]': (Kind.UNKNOWN, "constraints"),
    'constraints = ["tube.length"]': (Kind.WRONG_TYPE, "constraints"),
    'constraints = ["tube > 3"]': (Kind.WRONG_TYPE, "constraints"),
    "constraints = [\"__import__('os')\"]": (Kind.WRONG_TYPE, "constraints"),
    'constraints = ["().__class__ == 3"]': (Kind.WRONG_TYPE, "constraints"),
    'constraints = ["tube.length > 9 ** 9 ** 9"]': (Kind.WRONG_TYPE, "constraints"),
    'constraints = ["tube.length >"]': (Kind.WRONG_TYPE, "constraints"),
}
BORE = "vary.tube.inner_diameter"
WRONG_PARAMETERS = {
    '"tube.inner_diameter" = [9]': (Kind.OUT_OF_RANGE, BORE),
    '"tube.inner_diameter" = ["x"]': (Kind.WRONG_TYPE, BORE),
    '"tube.inner_diameter" = [nan]': (Kind.OUT_OF_RANGE, BORE),
    '"tube.inner_diameter" = [true]': (Kind.WRONG_TYPE, BORE),
    '"tube.inner_diameter" = 0.4': (Kind.WRONG_TYPE, BORE),
    '"tube.inner_diameter" = []': (Kind.WRONG_TYPE, BORE),
    '"tube.inner_diameter" = {from = 0.4}': (Kind.WRONG_TYPE, BORE),
    '"tube.inner_diameter" = {from = 0.4, to = 0.3, count = 3}': (Kind.CONFLICT, f"{BORE}.from"),
    '"tube.inner_diameter" = {from = 0.3, to = 0.4}': (Kind.MISSING, f"{BORE}.count"),
    '"tube.inner_diameter" = {from = 0.3, to = 0.4, count = 1}': (Kind.OUT_OF_RANGE, f"{BORE}.count"),
    '"tube.inner_diameter" = {from = 0.3, to = 0.4, step = 0.5}': (Kind.CONFLICT, f"{BORE}.step"),
    '"tube.inner_diamete" = [0.4]': (Kind.UNKNOWN, "vary.tube.inner_diamete"),
    '"tube" = [0.4]': (Kind.WRONG_TYPE, "vary.tube"),
    '"resonator.cavity_volume" = [70.0]': (Kind.UNKNOWN, "vary.resonator.cavity_volume"),
    '"lines.3.points" = [3]': (Kind.UNKNOWN, "vary.lines.3.points"),
    '"lines.0.points" = {from = 2.5, to = 4}': (Kind.WRONG_TYPE, "vary.lines.0.points.from"),
    '"lines.0.tube.length" = [3.0]': (Kind.MISSING, "vary.lines.0.tube.length"),
    '"membrane.material" = {from = 1, to = 2, count = 3}': (Kind.WRONG_TYPE, "vary.membrane.material"),
    "": (Kind.MISSING, "vary"),
    '[[together]]\n"tube.length" = [9, 10]\n"tube.inner_diameter" = [0.3, 0.4, 0.5]': (Kind.CONFLICT, "together.0"),
    '"tube.length" = [9, 10, 9]': (Kind.CONFLICT, "vary.tube.length"),
    '"tube.length" = [9, 9.0]': (Kind.CONFLICT, "vary.tube.length"),
    '"lines.0.points" = [6, 12, 6]': (Kind.CONFLICT, "vary.lines.0.points"),
    '"membrane.material" = ["silicone-shore-a-10", "silicone-shore-a-10"]': (
        Kind.CONFLICT,
        "vary.membrane.material",
    ),
    '"tube.length" = {from = 9, to = 10, step = 0.5, count = 9}': (Kind.CONFLICT, "vary.tube.length"),
    '"tube.length" = {from = 9, to = 10, count = 5000}': (Kind.CONFLICT, "vary.tube.length"),
    '[[together]]\n"tube.length" = [9, 10, 9]\n"tube.inner_diameter" = [0.3, 0.4, 0.3]': (Kind.CONFLICT, "together.0"),
    '"tube.length" = [9]\n[[together]]\n"tube.length" = [9]': (Kind.CONFLICT, "together.0.tube.length"),
}
TEXTS = {name: study(name + "\n") for name in WRONG_FIELDS} | {
    name: study(parameters=f"[vary]\n{name}\n") for name in WRONG_PARAMETERS
}


@pytest.mark.parametrize(("name", "text"), TEXTS.items())
def test_a_wrong_field_is_refused_by_name(name: str, text: str) -> None:
    kind, field = (WRONG_FIELDS | WRONG_PARAMETERS)[name]
    with refused(kind, field, file="s.toml", error=StudyError):
        read_study(text, "s.toml")


def test_the_messages_of_wrong_studies() -> None:
    calls = {name.replace("\n", " "): partial(read_study, text, "s.toml") for name, text in TEXTS.items()}
    check_messages(Path(__file__).parent / "messages.txt", calls)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ('[vary]\n"tube.length" = [9, 10, 9.0]\n', 9.0),
        ('[[together]]\n"tube.length" = [9, 10, 10]\n"tube.inner_diameter" = [0.3, 0.4, 0.4]\n', [10.0, 0.4]),
    ],
)
@pytest.mark.parametrize("head", ["", 'sampling = "random"\ncases = 3\n'])
def test_values_that_are_there_twice_are_refused_with_the_value(text: str, value: object, head: str) -> None:
    with refused(Kind.CONFLICT, value=value, error=StudyError):
        read_study(study(head, text))


def test_rows_of_a_group_may_share_values() -> None:
    rows = '[[together]]\n"tube.length" = [9, 9, 10]\n"tube.inner_diameter" = [0.3, 0.4, 0.4]\n'
    assert len(cases_of(read_study(study(parameters=rows)))) == 3


@pytest.mark.parametrize("base", ["x" * 300, "folder", "/dev/zero", "", "array-9"])
def test_a_base_that_is_no_file_is_refused(base: str, tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    (tmp_path / "study.toml").write_text(f'base = "{base}"\nmetrics = ["distance_smallest"]\n')
    with refused(Kind.UNKNOWN, "base", file="study.toml", error=StudyError):
        load_study(tmp_path / "study.toml")


def test_an_unknown_metric_is_refused_with_the_nearest() -> None:
    with refused(Kind.UNKNOWN, "metrics", "distance_smalest", error=StudyError) as found:
        read_study(study().replace("distance_smallest", "distance_smalest"))
    assert "'distance_smallest'" in found.value.remedy


def test_a_study_may_be_given_as_its_file(tmp_path: Path) -> None:
    (tmp_path / "study.toml").write_text(study())
    given = read_study(study())
    assert resolve_study(given) is given
    assert resolve_study(tmp_path / "study.toml").digest() == given.digest()


def test_a_file_that_is_no_study_is_refused(tmp_path: Path) -> None:
    (tmp_path / "cut.toml").write_text(study()[:-4])
    (tmp_path / "binary.toml").write_bytes(b"\xff\xfe\x00")
    for name, kind in (("none.toml", Kind.MISSING), (".", None), ("cut.toml", None), ("binary.toml", None)):
        with refused(kind or Kind.UNREADABLE, file=tmp_path / name, error=StudyError):
            load_study(tmp_path / name)
    (tmp_path / "bad.toml").write_text('name = "a"\n')
    (tmp_path / "study.toml").write_text(study(base=HEAD.replace("array-2x6", "bad.toml")))
    with refused(Kind.MISSING, file=tmp_path / "bad.toml", error=DesignError):
        load_study(tmp_path / "study.toml")


SHEETS = """
base = "array-2x6"
metrics = ["distance_smallest"]
fidelity = "lumped"
stock = "off"
{more}
[vary]
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

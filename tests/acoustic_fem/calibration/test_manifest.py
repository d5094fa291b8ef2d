"""Manifests of a calibration: names of points are numbers of the design's points."""

from pathlib import Path

import pytest
from refusals import refused

from acoustic_fem.calibration.manifest import ManifestError, read_manifest
from geometry import Kind
from geometry.ground.argument_checks import whole_number

NAMES = ["0", "13", "9" * 5000, "1_0", "٣", "²", "+1", " 1", "1.0", "1e1", "-1", ""]


@pytest.mark.parametrize("name", NAMES)
def test_a_point_that_the_design_does_not_have_is_refused_by_its_name(name: str, tmp_path: Path) -> None:
    path = tmp_path / "calibration.toml"
    path.write_text(f'design = "array-2x6"\n[points]\n"{name}" = "a.wav"\n', encoding="utf-8")
    with refused(Kind.OUT_OF_RANGE, file=path, error=ManifestError) as found:
        read_manifest(path)
    assert found.value.field == f"points.{name}"


def test_a_point_twice_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "calibration.toml"
    path.write_text('design = "array-2x6"\n[points]\n1 = "a.wav"\n01 = "b.wav"\n')
    with refused(Kind.OUT_OF_RANGE, "points.01", file=path, error=ManifestError):
        read_manifest(path)


@pytest.mark.parametrize("number", ["9" * 5000, "0x" + "f" * 5000, "9" * 20])
def test_a_channel_of_very_many_digits_is_refused(number: str, tmp_path: Path) -> None:
    path = tmp_path / "calibration.toml"
    path.write_text(f'design = "array-2x6"\npoints = {{1 = "a.wav"}}\n[channels]\nA = {number}\n')
    with refused(Kind.UNREADABLE, file=path, error=ManifestError):
        read_manifest(path)


def test_whole_numbers_are_plain_digits() -> None:
    assert [whole_number(text) for text in ("0", "7", "007", "999999999")] == [0, 7, 7, 999_999_999]
    assert {whole_number(text) for text in (*NAMES[2:], "9999999999", "x")} == {-1}


def test_recordings_are_pressures_unless_the_manifest_says_otherwise(tmp_path: Path) -> None:
    path = tmp_path / "calibration.toml"
    text = 'design = "array-2x6"\n{}[points]\n1 = "a.wav"\n'
    for given, output in (("", "pressure"), ('output = "pressure"\n', "pressure"), ('output = "voltage"\n', "voltage")):
        path.write_text(text.format(given))
        assert read_manifest(path).output == output
    path.write_text(text.format('output = "volts"\n'))
    with refused(Kind.OUT_OF_RANGE, "output", "volts", file=path, error=ManifestError):
        read_manifest(path)

"""The verb convert: there and back, and what it must not replace."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from libraries import assert_same_library, three_points
from typer.testing import CliRunner

import acoustic_fem
import localize
from acoustic_fem.library import exchange
from acoustic_fem.library.exchange import export
from acoustic_fem.library.transfer_functions import MEASURED, Library
from acoustic_fem.sound.sound_file import SoundFileWarning
from geometry.ground.refusal import Kind, Refusal
from localize.signals.array_response import UncoveredWarning
from studies.cli.app import app


@pytest.fixture(scope="module")
def library() -> Library:
    return three_points()


def test_the_verb_converts_there_and_back(library: Library, tmp_path: Path) -> None:
    acoustic_fem.save(library, tmp_path / "library.nc")
    for source, target in (("library.nc", "library.sofa"), ("library.sofa", "again.nc")):
        result = CliRunner().invoke(app, ["convert", str(tmp_path / source), "--out", str(tmp_path / target)])
        assert result.exit_code == 0, result.output
        assert "3 points, 2 microphones, 7 frequencies" in result.output
    assert_same_library(acoustic_fem.load(tmp_path / "again.nc"), library)


@pytest.fixture(scope="module")
def localizer(library: Library, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A localizer that was hardly trained, on a library in another format."""
    folder = tmp_path_factory.mktemp("trained")
    export(library, folder / "library.sofa")
    plan = localize.TrainingPlan(seconds_per_point=24, epochs=1, as_built=0)
    localize.train(acoustic_fem.load(folder / "library.sofa"), plan).save(folder / "localizer")
    return folder / "localizer"


@pytest.mark.parametrize("suffix", [".nc", ".sofa", ".npz", ".mat", ".csv"])
def test_every_verb_reads_what_convert_writes(
    library: Library, localizer: Path, tmp_path: Path, suffix: str, recwarn: pytest.WarningsRecorder
) -> None:
    path, recording = tmp_path / f"library{suffix}", tmp_path / "quiet.csv"
    export(library, path)
    rows = np.random.default_rng(0).normal(0, 1e-4, (600, 2))
    recording.write_text("A,B\n" + "\n".join(f"{a:g},{b:g}" for a, b in rows), encoding="utf-8")
    for arguments in (
        ("evaluate", localizer, path, "--touches", "1"),
        ("locate", path, recording),
        ("locate", localizer, recording, "--library", path, "--reject", "1e-6"),
    ):
        result = CliRunner().invoke(app, [str(argument) for argument in arguments])
        assert result.exit_code == 0, (arguments, result.output, result.exception)
    assert {told.category for told in recwarn} <= {SoundFileWarning, UncoveredWarning}  # the recording has no rate


@pytest.mark.parametrize("arguments", [("train", "library.txt"), ("recalibrate", "library.txt", "touches.csv")])
def test_the_other_verbs_have_the_same_reader(
    tmp_path: Path, arguments: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for name in ("library.txt", "touches.csv"):
        Path(name).write_bytes(b"\0\1\2\3")
    refused = CliRunner().invoke(app, [*arguments, "--out", "made"])
    assert str(refused.exception) == "library.txt: holds neither netCDF, SOFA, NPZ, MAT nor CSV: it is not a library"


@pytest.mark.parametrize("suffix", [".nc", ".sofa", ".npz", ".mat", ".csv"])
def test_a_measured_library_is_not_replaced_but_a_computed_one_is(
    library: Library, tmp_path: Path, suffix: str
) -> None:
    source, target = tmp_path / "source.npz", tmp_path / f"target{suffix}"
    export(library, source)
    verbs = [["convert", str(source)]]
    if suffix == ".nc":
        verbs.append(["solve", "array-2x6", "--fidelity", "lumped", "--frequencies", "1:100:4"])
    for verb in verbs:
        export(replace(library, fidelity=MEASURED), target)
        before = target.read_bytes()
        refused = CliRunner().invoke(app, [*verb, "--out", str(target)])
        assert str(refused.exception).startswith(f"{target}: exists, and a measured library is never overwritten;")
        assert target.read_bytes() == before
        target.unlink()
        export(library, target)
        result = CliRunner().invoke(app, [*verb, "--out", str(target)])
        assert result.exit_code == 0, result.output


def test_what_is_there_is_read_once(library: Library, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    source, target, read = tmp_path / "source.npz", tmp_path / "target.nc", []
    for path in (source, target):
        export(library, path)
    own = exchange.load

    def load(path: Path) -> Library:
        read.append(Path(path))
        return own(path)

    monkeypatch.setattr(exchange, "load", load)
    monkeypatch.setattr("studies.run.library_files.load", load)
    assert CliRunner().invoke(app, ["convert", str(source), "--out", str(target)]).exit_code == 0
    assert sorted(read) == [source, target, target]  # what is replaced is looked at again by the only writer


@pytest.mark.parametrize(
    ("out", "option", "field"),
    [
        ("x.cir", ("--tolerance", "0.01"), "tolerance"),
        ("x.mat", ("--output", "voltage"), "output"),
        ("x.nc", ("--touch", "force"), "touch"),
    ],
)
def test_options_of_a_state_space_are_refused_beside_anything_else(
    library: Library, tmp_path: Path, out: str, option: tuple[str, str], field: str
) -> None:
    acoustic_fem.save(library, tmp_path / "library.nc")
    words = ["convert", str(tmp_path / "library.nc"), "--out", str(tmp_path / out), *option]
    result = CliRunner().invoke(app, words)
    assert isinstance(result.exception, Refusal)
    assert (result.exception.kind, result.exception.field) == (Kind.CONFLICT, field)
    assert not (tmp_path / out).exists()


def test_another_suffix_is_refused_with_all_that_convert_writes(library: Library, tmp_path: Path) -> None:
    acoustic_fem.save(library, tmp_path / "library.nc")
    words = ["convert", str(tmp_path / "library.nc"), "--out", str(tmp_path / "y.xyz")]
    with pytest.raises(Refusal) as found:
        CliRunner().invoke(app, words, catch_exceptions=False)
    assert (found.value.kind, found.value.field) == (Kind.OUT_OF_RANGE, "out")
    for suffix in (*exchange.FORMATS, ".cir", ".s14p"):
        assert suffix in found.value.allowed
    with pytest.raises(Refusal) as found:
        CliRunner().invoke(app, [*words, "--as", "library"], catch_exceptions=False)
    assert ".cir" not in found.value.allowed
    assert [each.name for each in tmp_path.iterdir()] == ["library.nc"]

"""Damaged stores of sweeps: refused by the record, computed again by the next run, or the same numbers."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from damage import damaged
from refusals import check_messages, refused
from stores import assert_same_store
from thorough import many

from geometry.ground.refusal import Kind
from studies.findings.reporting import best_designs
from studies.study.parameter import StudyError
from studies.study.study import Study, read_study
from studies.sweep import run
from studies.sweep.results import Sweep, open_sweep
from studies.sweep.run import run_sweep

TEXT = """
name = "bores"
base = "array-2x6"
fidelity = "lumped"
stock = "off"
frequency = "1:100:4"
metrics = ["distance_smallest", "volume"]
sampling = "random"
cases = 40
keep = "responses"

[vary]
"tube.inner_diameter" = {from = 0.3, to = 0.8}
"membrane.material" = ["silicone-shore-a-30", "silicone-shore-a-10"]
"""


@pytest.fixture(scope="module")
def study() -> Study:
    return read_study(TEXT)


@pytest.fixture(scope="module")
def finished(study: Study, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("sweep") / "results.zarr"
    run_sweep(study, out, workers=1)
    return out


@pytest.fixture
def store(finished: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(finished, tmp_path / "results.zarr"))


Change = Callable[[Path], None]


def flip(member: str) -> Change:
    def of(store: Path) -> None:
        content = bytearray((store / member).read_bytes())
        content[len(content) // 2] ^= 1
        (store / member).write_bytes(content)

    return of


def cut(member: str) -> Change:
    return lambda store: (store / member).write_bytes((store / member).read_bytes()[:100])  # type: ignore[func-returns-value]


def without(*members: str) -> Change:
    def of(store: Path) -> None:
        for member in members:
            shutil.rmtree(store / member) if (store / member).is_dir() else (store / member).unlink()

    return of


def of_format(member: str, old: str, new: str) -> Change:
    def of(store: Path) -> None:
        content = (store / member).read_bytes()
        assert content.count(old.encode()) == 1
        (store / member).write_bytes(content.replace(old.encode(), new.encode()))

    return of


def older(mark: object) -> Change:
    """A store of which only the Zarr part is there, as older versions wrote it."""

    def of(store: Path) -> None:
        shutil.rmtree(store / "records")
        document = json.loads((store / "zarr.json").read_text())
        document["attributes"]["acoustic_fem_sweep"] = mark
        (store / "zarr.json").write_text(json.dumps(document))

    return of


#: What every reader and writer refuses, and leaves as it is.
REFUSED = {
    "of format 4": older(4),
    "of format 1": older(1),
    "no sweep": older(None),
    "no records": without("records"),
    "no metadata and no records": without("records", "zarr.json"),
    "records of a later version": of_format("records/study", "sweep 6\n", "sweep 7\n"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_a_store_of_another_version_and_what_is_none_are_refused_by_name(name: str, study: Study, store: Path) -> None:
    REFUSED[name](store)
    before = {path: path.read_bytes() for path in store.rglob("*") if path.is_file()}
    for read in (open_sweep, lambda path: run_sweep(study, path, workers=1)):
        with pytest.raises(StudyError) as error:
            read(store)
        assert error.value.kind is Kind.MISMATCH
        assert str(error.value.file).startswith(str(store))
        if "format" in name:
            assert f"is {name}; this version of the program reads format 6" in str(error.value)
    assert before == {path: path.read_bytes() for path in store.rglob("*") if path.is_file()}


#: A change to the study, which makes it another one.
OTHERS = {
    "values": ("from = 0.3", "from = 0.31"),
    "parameter": ('"tube.inner_diameter"', '"microphone_tube.inner_diameter"'),
    "frequency": ("1:100:4", "1:100:5"),
    "cases": ("cases = 40", "cases = 41"),
    "base": ("array-2x6", "line-2"),
    "seed": ('"random"', '"random"\nseed = 7'),
    "metrics": (', "volume"]', "]"),
}


@pytest.mark.parametrize("name", OTHERS)
def test_the_store_of_another_study_is_refused(name: str, finished: Path) -> None:
    with refused(Kind.MISMATCH, file=finished, error=StudyError):
        run_sweep(read_study(TEXT.replace(*OTHERS[name], 1)), finished, workers=1)


METRICS_3, RESPONSES_2 = "records/000003.metrics", "responses/transfer_function_real/c/2/0/0/0"
#: Damage that the next run mends, the member, and what the run says.
MENDED = {
    "metrics": (flip(METRICS_3), METRICS_3, "cases 9 to 11 are computed again"),
    "metrics cut": (cut(METRICS_3), METRICS_3, "cases 9 to 11 are computed again"),
    "metrics of another version": (of_format(METRICS_3, "sweep 6\n", "sweep 4\n"), METRICS_3, "cases 9 to 11 are"),
    "metrics of another place": (
        lambda store: shutil.copy(store / "records/000002.metrics", store / METRICS_3), METRICS_3, "cases 9 to 11 are",
    ),
    "metrics missing": (without(METRICS_3), METRICS_3, "cases 9 to 11 are computed again"),
    "responses missing": (without(RESPONSES_2), RESPONSES_2, "cases 6 to 8 are computed again"),
    "study": (flip("records/study"), "records/study", "restored from the study"),
    "study cut": (cut("records/study"), "records/study", "restored from the study"),
    "study missing": (without("records/study"), "records/study", "restored from the study"),
}  # fmt: skip


@pytest.mark.parametrize("name", MENDED)
def test_what_is_damaged_is_named_and_the_next_run_makes_it_anew(
    name: str, study: Study, finished: Path, store: Path
) -> None:
    change, member, note = MENDED[name]
    change(store)
    for read in (open_sweep, best_designs):
        with pytest.raises(StudyError) as error:
            read(store)
        assert str(error.value).startswith(f"{store / member}: ")
        assert "another version" in name or "run the same sweep again" in str(error.value)
    summary = run_sweep(study, store, workers=1).summary
    assert len(summary.notes) == 1
    assert summary.notes[0].startswith(f"{store / member}: ")
    assert note in summary.notes[0]
    assert summary.computed == (0 if "study" in name else 3)
    assert_same_store(store, finished)
    assert run_sweep(study, store, workers=1).summary.notes == ()


@pytest.mark.parametrize(
    "change",
    [
        without("zarr.json"), without("volume"), without("tube.inner_diameter/c"), without("volume/c/3"),
        flip("volume/c/3"), flip("zarr.json"), flip("responses/zarr.json"), cut("volume/zarr.json"),
    ],
)  # fmt: skip
def test_damage_to_the_zarr_store_changes_no_result_and_the_next_run_writes_it_anew(
    change: Change, study: Study, finished: Path, store: Path
) -> None:
    change(store)
    assert_same_results(open_sweep(store), open_sweep(finished))
    assert (run_sweep(study, store, workers=1).summary.computed, run_sweep(study, store, workers=1).summary.notes) == (
        0,
        (),
    )
    assert_same_store(store, finished)


def test_xarray_notices_a_damaged_chunk(store: Path) -> None:
    flip("volume/c/3")(store)
    with pytest.raises(ValueError, match="checksum"):
        xr.open_zarr(store)["volume"].load()


def test_many_damaged_blocks_are_told_in_few_lines(study: Study, finished: Path, store: Path) -> None:
    for block in range(10):
        flip(f"responses/transfer_function_imag/c/{block}/0/0/0")(store)
    summary = run_sweep(study, store, workers=1).summary
    assert summary.computed == 30
    assert len(summary.notes) == 4
    assert "7 more blocks are damaged and computed again" in summary.notes[-1]
    assert_same_store(store, finished)


def test_a_block_that_waits_is_computed_whatever_lies_in_its_place(study: Study, finished: Path, store: Path) -> None:
    without("records/000001.metrics", "state/c/1")(store)
    waiting = open_sweep(store).to_xarray().isel(case=slice(2, 7)).load()
    known = [True, False, False, False, True]
    np.testing.assert_array_equal(np.isfinite(waiting["volume"].values), known)
    np.testing.assert_array_equal(np.isfinite(waiting["transfer_function"].values).all((1, 2, 3)), known)
    assert np.isnan(open_sweep(store).to_xarray()["transfer_function"][4].values).all()
    assert run_sweep(study, store, workers=1).summary.computed == 3
    assert_same_store(store, finished)


def test_damaged_responses_are_refused_where_they_are_used(study: Study, finished: Path, store: Path) -> None:
    damaged_part = "responses/transfer_function_real/c/1/0/0/0"
    flip(damaged_part)(store)
    response = open_sweep(store).to_xarray()["transfer_function"]
    assert np.isfinite(response[0].values).all()
    with pytest.raises(StudyError) as error:
        response[4].load()
    assert (error.value.kind, error.value.file) == (Kind.DAMAGED, str(store / damaged_part))
    assert "cases 3 to 5 are computed again" in " ".join(run_sweep(study, store, workers=1).summary.notes)
    assert_same_store(store, finished)


def test_a_damaged_record_of_the_study_is_not_restored_over_the_results_of_another(finished: Path, store: Path) -> None:
    flip("records/study")(store)
    before = {path: path.read_bytes() for path in store.rglob("*") if path.is_file()}
    with pytest.raises(StudyError) as error:
        run_sweep(read_study(TEXT.replace("cases = 40", "cases = 40\nseed = 7")), store, workers=1)
    assert (error.value.kind, error.value.file) == (Kind.DAMAGED, str(store / "records/study"))
    assert before == {path: path.read_bytes() for path in store.rglob("*") if path.is_file()}


def test_a_metric_that_this_version_does_not_know_is_refused(store: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("studies.sweep.results.METRICS", {"volume": None})
    with pytest.raises(StudyError) as error:
        open_sweep(store)
    assert (error.value.kind, error.value.value) == (Kind.UNKNOWN, "distance_smallest")


def test_the_messages_of_stores(finished: Path, tmp_path: Path) -> None:
    def opened(change: Change) -> None:
        store = tmp_path / "results.zarr"
        shutil.rmtree(store, ignore_errors=True)
        shutil.copytree(finished, store)
        change(store)
        open_sweep(store)

    def continued(old: str, new: str, out: Path = finished) -> None:
        run_sweep(read_study(TEXT.replace(old, new, 1)), out, workers=1)

    def stopped(error: OSError | MemoryError) -> None:
        raise run._stopped(finished, run._lack(error))

    changes = {**REFUSED, **{name: change for name, (change, *_) in MENDED.items()}}
    told: dict[str, Callable[[], object]] = {
        **{f"opened, {name}": partial(opened, change) for name, change in changes.items()},
        **{f"continued, other {name}": partial(continued, *pair) for name, pair in OTHERS.items()},
        "continued, no sweep": partial(continued, "", "", finished.parent),
        "stopped, full disk": partial(stopped, OSError(28, "No space left on device", str(finished))),
        "stopped, no memory": partial(stopped, MemoryError("Unable to allocate 3.1 GiB")),
    }
    hidden = {str(tmp_path): "FOLDER", str(finished.parent): "FOLDER"}
    check_messages(Path(__file__).with_name("messages.txt"), told, hidden)


def assert_same_results(found: Sweep, expected: Sweep) -> None:
    assert (found.parameters, found.metrics, found.base) == (expected.parameters, expected.metrics, expected.base)
    one, other = found.to_xarray().load(), expected.to_xarray().load()
    xr.testing.assert_identical(one, other)


def check_damage(study: Study, store: Path, finished: Path, count: int, seed: int, mended: int) -> None:
    """Any damage is refused by its name, or changes nothing; some of it is mended too."""
    expected = open_sweep(finished)
    count_refused = 0
    for number, done in enumerate(damaged(store, count, seed)):
        said = ""
        try:
            assert_same_results(open_sweep(store), expected)
        except StudyError as error:
            said = str(error)
        kept_once = done.startswith("records/") or (done.startswith("responses/transfer_function_") and "/c/" in done)
        assert bool(said) == kept_once, (done, said)
        count_refused += bool(said)
        assert not said or said.startswith((f"{store}/records/", f"{store}/responses/")), (done, said)
        assert "\n" not in said, done
        if number < mended:
            again = Path(shutil.copytree(store, store.parent / "again.zarr"))
            try:
                run_sweep(study, again, workers=1)
                assert_same_store(again, finished)
            except StudyError as error:
                assert str(error).startswith(f"{again}/records/study: "), (done, error)  # noqa: PT017
            shutil.rmtree(again)
    assert count_refused > count / 6


def test_any_damage_is_refused_or_changes_nothing(study: Study, store: Path, finished: Path) -> None:
    check_damage(study, store, finished, 20, 1, 3)


@pytest.mark.slow
def test_much_damage_is_refused_or_changes_nothing(study: Study, store: Path, finished: Path) -> None:
    check_damage(study, store, finished, many(100), 2, many(20))


def pipe(path: Path) -> None:
    os.mkfifo(path)


def endless(path: Path) -> None:
    path.symlink_to("/dev/zero")


def link(path: Path) -> None:
    path.symlink_to(path.parent.parent / "another's")


NO_LOGS = {"a pipe": pipe, "a device": endless, "a link": link, "a circle": lambda path: path.symlink_to(path)}


@pytest.mark.parametrize("what", [*NO_LOGS, "a folder"])
def test_a_log_that_is_no_file_is_refused_before_it_is_opened(what: str, study: Study, tmp_path: Path) -> None:
    out = tmp_path / "results.zarr"
    NO_LOGS.get(what, Path.mkdir)(tmp_path / "results.zarr.log")
    with refused(Kind.EXISTS, file=tmp_path / "results.zarr.log", error=StudyError):
        run_sweep(study, out, workers=1)
    assert not out.exists()
    assert not (tmp_path.parent / "another's").exists()


@pytest.mark.parametrize("make", [pipe, endless, link, lambda path: path.symlink_to(path)])
@pytest.mark.parametrize(
    "name", ["records/study", METRICS_3, RESPONSES_2, "zarr.json", "volume/c/3", "volume/zarr.json", "volume/c/more"]
)
def test_what_is_no_file_in_a_store_is_refused_until_it_is_removed(
    name: str, make: Callable[[Path], None], study: Study, finished: Path, store: Path
) -> None:
    (store / name).unlink(missing_ok=True)
    make(store / name)
    with refused(Kind.UNREADABLE, file=store / name, error=StudyError):
        open_sweep(store)
    with refused(Kind.UNREADABLE, file=store / name, error=StudyError):
        run_sweep(study, store, workers=1)
    (store / name).unlink()
    run_sweep(study, store, workers=1)
    assert_same_store(store, finished)


def test_a_link_to_a_folder_in_a_store_is_not_followed(study: Study, store: Path, tmp_path: Path) -> None:
    (store / "volume").rename(tmp_path / "elsewhere")
    (store / "volume").symlink_to(tmp_path / "elsewhere")
    with refused(Kind.UNREADABLE, file=store / "volume", error=StudyError):
        run_sweep(study, store, workers=1)


def test_the_store_itself_may_be_a_link(store: Path, tmp_path: Path) -> None:
    (tmp_path / "linked.zarr").symlink_to(store)
    assert (open_sweep(tmp_path / "linked.zarr").done | open_sweep(tmp_path / "linked.zarr").failed).all()


def test_a_folder_with_a_pipe_for_a_description_is_no_sweep(tmp_path: Path) -> None:
    (tmp_path / "old.zarr").mkdir()
    pipe(tmp_path / "old.zarr" / "zarr.json")
    with refused(Kind.MISMATCH, file=tmp_path / "old.zarr", error=StudyError):
        open_sweep(tmp_path / "old.zarr")

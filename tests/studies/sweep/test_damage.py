"""Damaged stores of sweeps: refused by the member, computed again by the next run, or the same numbers."""

from __future__ import annotations

import hashlib
import json
import shutil
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import zarr
from damage import damaged
from stores import assert_same_store
from thorough import many

from studies.findings.reporting import best_designs
from studies.output.checked_store import StoreWarning
from studies.study.file import read_study
from studies.study.study import Study, StudyError
from studies.sweep.new_store import TRANSFER_FUNCTIONS
from studies.sweep.run import run_sweep
from studies.sweep.store import FAILED, Sweep, open_sweep

TEXT = """
name = "bores"
base = "array-2x6"
fidelity = "lumped"
frequencies = "1:100:4"
metrics = ["distance_smallest", "volume"]
sampling = "random"
cases = 40
transfer_functions = true

[parameters]
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


@pytest.fixture(scope="module")
def other(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Store of the same study with other draws: every array has the shape of that of :func:`finished`."""
    out = tmp_path_factory.mktemp("other") / "results.zarr"
    run_sweep(read_study(TEXT.replace("cases = 40", "cases = 40\nseed = 7")), out, workers=1)
    return out


@pytest.fixture
def store(finished: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(finished, tmp_path / "results.zarr"))


def edit(change: Callable[[dict[str, Any]], None], member: str = "zarr.json") -> Callable[[Path], None]:
    def of(store: Path) -> None:
        document = json.loads((store / member).read_text())
        change(document)
        (store / member).write_text(json.dumps(document))

    return of


def flip(member: str) -> Callable[[Path], None]:
    def of(store: Path) -> None:
        content = bytearray((store / member).read_bytes())
        content[len(content) // 2] ^= 1
        (store / member).write_bytes(content)

    return of


def without(*members: str) -> Callable[[Path], None]:
    def of(store: Path) -> None:
        for member in members:
            shutil.rmtree(store / member) if (store / member).is_dir() else (store / member).unlink()

    return of


def attribute(name: str, value: object) -> Callable[[Path], None]:
    return edit(lambda document: document["attributes"].update({name: value}))


def unchecked(*then: Callable[[Path], None]) -> Callable[[Path], None]:
    """A store as an older version wrote it, and what happened to it."""

    def of(store: Path) -> None:
        edit(lambda document: document["attributes"].pop("checksums"))(store)
        attribute("acoustic_fem_sweep", 1)(store)
        for change in then:
            change(store)

    return of


def without_seals() -> Callable[[Path], None]:
    """A store as an older version wrote it, with checksums and without seals."""

    def of(store: Path) -> None:
        without("seals")(store)
        document = json.loads((store / "zarr.json").read_text())
        attributes = document["attributes"]
        del attributes["identity"]
        attributes["acoustic_fem_sweep"] = 2
        kept = {name for name in attributes["checksums"] if "identity" not in name and not name.startswith("seals/")}
        attributes["checksums"] = {
            name: digest for name, digest in attributes["checksums"].items() if name in kept and "/c/" not in name
        }
        attributes["checksums"]["attribute acoustic_fem_sweep"] = hashlib.sha256(b"2").hexdigest()
        (store / "zarr.json").write_text(json.dumps(document))

    return of


#: Damage that every reader refuses, and what it says.
REFUSED = {
    "no-metadata": (without("zarr.json"), "has no zarr.json"),
    "metadata-cut": (lambda store: (store / "zarr.json").write_text('{"zarr_format": 3,'), "zarr.json: is not JSON"),
    "metadata-a-list": (lambda store: (store / "zarr.json").write_text("[3]"), "zarr.json: its content: Input should"),
    "no-group": (edit(lambda document: document.update(node_type="array")), "zarr.json: node_type: Input should be"),
    "of-zarr-2": (edit(lambda document: document.update(zarr_format=2)), "zarr.json: zarr_format: Input should be 3"),
    "no-attributes": (edit(lambda document: document.pop("attributes")), "zarr.json: attributes: Field required"),
    "another-store": (attribute("acoustic_fem_sweep", None), "is not the results of a sweep"),
    "a-later-format": (attribute("acoustic_fem_sweep", 4), "is of format 4, which a later version wrote; this one"),
    "no-checksums": (edit(lambda document: document["attributes"].pop("checksums")), "attribute checksums is damaged"),
    "base-changed": (attribute("base_design", "x"), "zarr.json: attribute base_design is damaged"),
    "study-missing": (
        edit(lambda document: document["attributes"].pop("study_content")),
        "zarr.json: attribute study_content is missing",
    ),
    "of-an-older-format-with-a-text-for-a-number": (
        unchecked(attribute("block", "3")), "zarr.json: attribute block: Input should be a valid integer",
    ),
    "of-an-older-format-with-a-broken-study": (
        unchecked(attribute("study_content", "{")), "zarr.json: attribute study_content: Invalid JSON",
    ),
    "of-an-older-format-with-null": (unchecked(attribute("fidelity", None)), "attribute fidelity: Input should be"),
}  # fmt: skip


@pytest.mark.filterwarnings("ignore::studies.output.checked_store.StoreWarning")
@pytest.mark.parametrize("name", REFUSED)
def test_a_store_that_cannot_be_taken_is_refused_by_the_member(name: str, study: Study, store: Path) -> None:
    change, message = REFUSED[name]
    change(store)
    before = {path: path.read_bytes() for path in store.rglob("*") if path.is_file()}
    for read in (open_sweep, lambda path: run_sweep(study, path, workers=1)):
        with pytest.raises(StudyError) as refused:
            read(store)
        assert str(refused.value).startswith(f"{store}: ")
        assert message in str(refused.value)
    assert before == {path: path.read_bytes() for path in store.rglob("*") if path.is_file()}


#: Damage that the next run mends, what a reader says before, and what the run says.
MENDED = {
    "metric": (flip("volume/c/3"), "volume: cut short or not what was written", "cases 9 to 11 are computed again"),
    "no state": (without("state/c/0"), "state: chunk 0 is missing", "cases 0 to 2 are computed again"),
    "state": (flip("state/c/0"), "state: cut short or not what was written", "cases 0 to 2 are computed again"),
    "reason": (flip("reason/c/13"), "reason: cut short or not what was", "cases 39 to 39 are computed again"),
    "metric-missing": (without("volume/c/3"), "volume: chunk 3 is missing", "cases 9 to 11 are computed again"),
    "responses-missing": (
        without("transfer_function_imag/c/2/0/0/0"), "transfer_function_imag: chunk 2 is missing", "cases 6 to 8 are",
    ),
    "parameter": (flip("tube.inner_diameter/c/0"), "tube.inner_diameter: cut short or not what", "restored from the"),
    "parameter-missing": (
        without("tube.inner_diameter"), "tube.inner_diameter/zarr.json is missing", "restored from the study",
    ),
    "parameter-values-missing": (without("membrane.material/c"), "membrane.material/c/0 is missing", "restored from"),
    "frequency": (without("frequency"), "frequency/zarr.json is missing", "restored from the study"),
    "shape": (
        edit(lambda document: document.update(shape=[10**12]), "volume/zarr.json"), "volume/zarr.json is damaged",
        "restored from the study",
    ),
    "array-cut": (
        lambda store: (store / "volume" / "zarr.json").write_text("{"), "volume/zarr.json: is not JSON",
        "restored from the study",
    ),
    "array-missing": (without("volume"), "volume/zarr.json is missing", "volume: chunk 0 is missing; cases 0 to 2 are"),
}  # fmt: skip


@pytest.mark.parametrize("name", MENDED)
def test_what_is_damaged_is_named_and_the_next_run_makes_it_anew(
    name: str, study: Study, finished: Path, store: Path
) -> None:
    change, message, note = MENDED[name]
    change(store)
    for read in (open_sweep, best_designs):
        with pytest.raises(StudyError) as refused:
            read(store)
        assert str(refused.value).startswith(f"{store}: ")
        assert message in str(refused.value)
        assert "run the same sweep again" in str(refused.value)
    summary = run_sweep(study, store, workers=1)
    assert any(note in each for each in summary.notes), summary.notes
    assert summary.computed < 40 or name == "array-missing"
    assert len(summary.notes) <= 5
    assert_same_store(store, finished)
    assert run_sweep(study, store, workers=1).notes == ()


RESPONSES = "transfer_function_real/c/{}/0/0/0"
#: Members of a whole store that take the place of those of another one or of their own: source, target.
MIXED = {
    "a chunk of another seed": ("other", "volume/c/3", "volume/c/3"),
    "responses of another seed": ("other", RESPONSES.format(2), RESPONSES.format(2)),
    "a chunk of another place": ("own", "volume/c/2", "volume/c/3"),
    "responses of another place": ("own", RESPONSES.format(2), RESPONSES.format(3)),
    "a chunk of another array": ("own", "distance_smallest/c/3", "volume/c/3"),
    "responses of another array": ("own", RESPONSES.format(3), RESPONSES.format(3).replace("real", "imag")),
    "a seal of another place": ("own", "seals/c/2/0", "seals/c/3/0"),
    "a seal of another seed": ("other", "seals/c/3/0", "seals/c/3/0"),
    "an array of another seed": ("other", "volume", "volume"),
    "a parameter of another seed": ("other", "tube.inner_diameter", "tube.inner_diameter"),
    "a text parameter of another seed": ("other", "membrane.material", "membrane.material"),
    "an array and its seals of another seed": ("other", ("seals", "volume"), ("seals", "volume")),
}


@pytest.mark.parametrize("name", MIXED)
def test_parts_of_another_store_array_or_place_are_damage(
    name: str, study: Study, finished: Path, other: Path, store: Path
) -> None:
    whose, sources, targets = MIXED[name]
    pairs = zip(sources, targets, strict=True) if isinstance(sources, tuple) else [(sources, targets)]
    for source, target in pairs:
        put = (finished if whose == "own" else other) / source
        before = {path: path.read_bytes() for path in store.rglob("*") if path.is_file()}
        shutil.copytree(put, store / target, dirs_exist_ok=True) if put.is_dir() else shutil.copy(put, store / target)
        assert before != {path: path.read_bytes() for path in store.rglob("*") if path.is_file()}
    with pytest.raises(StudyError, match=r"^.*results.zarr: .* is not what was written there") as refused:
        open_sweep(store).dataset.load()
    assert str(refused.value).startswith(f"{store}: ")
    notes = run_sweep(study, store, workers=1).notes
    assert any("computed again" in note or "restored from the study" in note for note in notes)
    assert_same_store(store, finished)


def test_a_state_of_another_place_is_damage(study: Study, finished: Path, store: Path) -> None:
    with zarr.config.set({"array.write_empty_chunks": True}):
        zarr.open_array(store / "state", mode="r+", zarr_format=3)[3:6] = FAILED
    with pytest.raises(StudyError, match="state: chunk 1 is not what was written there"):
        open_sweep(store)
    run_sweep(study, store, workers=1)
    assert_same_store(store, finished)


def test_a_store_that_says_it_is_another_one_takes_none_of_its_blocks(
    study: Study, finished: Path, other: Path, store: Path
) -> None:
    shutil.copy(other / "zarr.json", store / "zarr.json")
    with pytest.raises(StudyError, match="is not what was written there"):
        open_sweep(store)
    with pytest.raises(StudyError, match="holds the results of another study"):
        run_sweep(study, store, workers=1)


def test_a_block_that_waits_is_computed_whatever_lies_in_its_place(
    study: Study, finished: Path, other: Path, store: Path
) -> None:
    with zarr.config.set({"array.write_empty_chunks": True}):
        zarr.open_array(store / "state", mode="r+", zarr_format=3)[3:6] = 0
    for member in ("volume/c/1", RESPONSES.format(1)):
        shutil.copy(other / member, store / member)
    waiting = open_sweep(store).dataset.isel(case=slice(2, 7)).load()
    known = [True, False, False, False, True]
    np.testing.assert_array_equal(np.isfinite(waiting["volume"].values), known)
    np.testing.assert_array_equal(np.isfinite(waiting["transfer_function_real"].values).all((1, 2, 3)), known)
    assert np.isnan(open_sweep(store).dataset["transfer_function_real"][4].values).all()
    assert run_sweep(study, store, workers=1).computed == 3
    assert_same_store(store, finished)


def test_damaged_responses_are_refused_where_they_are_used(study: Study, finished: Path, store: Path) -> None:
    flip("transfer_function_real/c/1/0/0/0")(store)
    sweep = open_sweep(store)
    response = sweep.dataset["transfer_function_real"]
    assert np.isfinite(response[0].values).all()
    with pytest.raises(StudyError, match=r"results.zarr: transfer_function_real: cut short or not what was written"):
        response[4].load()
    assert "cases 3 to 5 are computed again" in " ".join(run_sweep(study, store, workers=1).notes)
    assert_same_store(store, finished)


@pytest.mark.parametrize(
    ("change", "note"),
    [
        (attribute("title", "other"), "zarr.json: attribute title is damaged; it changes no result"),
        (edit(lambda document: document["attributes"].pop("seed")), "zarr.json: attribute seed is missing; it changes"),
        (
            edit(lambda document: document["attributes"].update(units="m"), "tube.inner_diameter/zarr.json"),
            "tube.inner_diameter/zarr.json attributes are damaged; they change no result",
        ),
        (unchecked(), "has no checksums, an older version wrote it; damage to it cannot be noticed"),
        (without_seals(), "has no identity, an older version wrote it; parts of other stores in it cannot be noticed"),
    ],
)
def test_damage_that_changes_no_result_is_told(
    change: Callable[[Path], None], note: str, study: Study, finished: Path, store: Path
) -> None:
    change(store)
    with pytest.warns(StoreWarning) as told:
        assert_same_results(open_sweep(store), open_sweep(finished))
    assert any(str(each.message).startswith(f"{store}: {note}") for each in told)
    with warnings.catch_warnings():
        warnings.simplefilter("error", StoreWarning)  # told once
        assert run_sweep(study, store, workers=1).computed == 0


@pytest.mark.filterwarnings("ignore::studies.output.checked_store.StoreWarning")
def test_a_store_of_an_older_version_without_an_array_cannot_be_restored(study: Study, store: Path) -> None:
    unchecked(without("volume"))(store)
    for read in (open_sweep, lambda path: run_sweep(study, path, workers=1)):
        with pytest.raises(StudyError, match=r"results.zarr: volume/zarr.json is missing; "):
            read(store)


def test_a_metric_that_this_version_does_not_know_is_refused(store: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("studies.sweep.store.METRICS", {"volume": None})
    with pytest.raises(StudyError, match="attribute metric_names: 'distance_smallest' is no metric of this version"):
        open_sweep(store)


def assert_same_results(found: Sweep, expected: Sweep) -> None:
    assert (found.parameters, found.metrics, found.base) == (expected.parameters, expected.metrics, expected.base)
    for name in ("case", "frequency", "state", "reason", *found.parameters, *found.metrics, *TRANSFER_FUNCTIONS):
        np.testing.assert_array_equal(found.dataset[name].values, expected.dataset[name].values)


def check_damage(study: Study, store: Path, finished: Path, count: int, seed: int, mended: int) -> None:
    """Any damage is refused by its name, or changes nothing; some of it is mended too."""
    expected = open_sweep(finished)
    refused = 0
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", StoreWarning)
        for number, done in enumerate(damaged(store, count, seed)):
            said = ""
            try:
                found = open_sweep(store)
                assert_same_results(found, expected)
            except StudyError as error:
                said = str(error)
            refused += bool(said)
            assert not said or said.startswith(f"{store}: "), (done, said)
            assert "\n" not in said, done
            if number < mended:
                again = Path(shutil.copytree(store, store.parent / "again.zarr"))
                try:
                    run_sweep(study, again, workers=1)
                    assert_same_results(open_sweep(again), expected)
                except StudyError as error:
                    assert str(error).startswith(f"{again}: "), (done, error)  # noqa: PT017
                shutil.rmtree(again)
    assert refused > count / 3


def test_any_damage_is_refused_or_changes_nothing(study: Study, store: Path, finished: Path) -> None:
    check_damage(study, store, finished, 15, 1, 2)


@pytest.mark.slow
def test_much_damage_is_refused_or_changes_nothing(study: Study, store: Path, finished: Path) -> None:
    check_damage(study, store, finished, many(100), 2, many(20))

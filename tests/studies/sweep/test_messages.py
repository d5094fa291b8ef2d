"""What the stores of sweeps say of what is damaged, of another version or of another study: their wording, once."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from refusals import check_messages, refused

from geometry.ground.refusal import Kind
from studies.scatter.perturbed_library import PerturbedLibrary
from studies.study.file import read_study
from studies.study.study import StudyError
from studies.sweep import run
from studies.sweep.run import run_sweep
from studies.sweep.store import open_sweep

TEXT = """
name = "bores"
base = "array-2x6"
fidelity = "lumped"
frequencies = "1:100:4"
metrics = ["distance_smallest", "volume"]
sampling = "random"
cases = 4
transfer_functions = true

[parameters]
"tube.inner_diameter" = {from = 0.3, to = 0.5}
"""
#: A change to the study, which makes it another one.
OTHERS = {
    "values": ("from = 0.3", "from = 0.31"),
    "parameter": ('"tube.inner_diameter"', '"microphone_tube.inner_diameter"'),
    "frequencies": ("1:100:4", "1:100:5"),
    "cases": ("cases = 4", "cases = 5"),
    "base": ("array-2x6", "line-2"),
    "seed": ('"random"', '"random"\nseed = 7'),
    "metrics": (', "volume"]', "]"),
}


@pytest.fixture(scope="module")
def finished(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("sweep") / "results.zarr"
    run_sweep(read_study(TEXT), out, workers=1)
    return out


def mark(value: object) -> Callable[[Path], None]:
    def of(store: Path) -> None:
        shutil.rmtree(store / "records")
        document = json.loads((store / "zarr.json").read_text())
        document["attributes"]["acoustic_fem_sweep"] = value
        (store / "zarr.json").write_text(json.dumps(document))

    return of


def replaced(member: str, old: bytes, new: bytes) -> Callable[[Path], None]:
    return lambda store: (store / member).write_bytes((store / member).read_bytes().replace(old, new))  # type: ignore[func-returns-value]


#: What happened to a store.
CHANGES: dict[str, Callable[[Path], object]] = {
    "older": mark(3),
    "no sweep": mark(None),
    "no records": lambda store: shutil.rmtree(store / "records"),
    "later": replaced("records/study", b"sweep 4\n", b"sweep 5\n"),
    "damaged": replaced("records/000001.metrics", b"acoustic-fem sweep 4\n", b"acoustic-fem sweep 4\n0"),
    "lost": lambda store: (store / "records/000001.responses").unlink(),
    "study damaged": replaced("records/study", b"acoustic-fem sweep 4\n", b"acoustic-fem sweep 4\n0"),
}


@pytest.mark.parametrize("name", OTHERS)
def test_the_store_of_another_study_is_refused(name: str, finished: Path) -> None:
    with refused(Kind.MISMATCH, file=finished, error=StudyError):
        run_sweep(read_study(TEXT.replace(*OTHERS[name], 1)), finished, workers=1)


def test_the_messages_of_stores(finished: Path, tmp_path: Path) -> None:
    def opened(change: Callable[[Path], object]) -> None:
        store = tmp_path / "results.zarr"
        shutil.rmtree(store, ignore_errors=True)
        shutil.copytree(finished, store)
        change(store)
        open_sweep(store)

    def continued(old: str, new: str) -> None:
        run_sweep(read_study(TEXT.replace(old, new, 1)), finished, workers=1)

    def stopped(error: OSError | MemoryError) -> None:
        raise run._stopped(finished, run._lack(error))

    told: dict[str, Callable[[], object]] = {
        **{f"opened, {name}": lambda change=change: opened(change) for name, change in CHANGES.items()},
        **{f"continued, other {name}": lambda pair=pair: continued(*pair) for name, pair in OTHERS.items()},
        "continued, no sweep": lambda: run_sweep(read_study(TEXT), finished.parent, workers=1),
        "stopped, full disk": lambda: stopped(OSError(28, "No space left on device", str(finished))),
        "stopped, no memory": lambda: stopped(MemoryError("Unable to allocate 3.1 GiB")),
        "perturbed, none": lambda: PerturbedLibrary(finished),
    }
    hidden = {str(tmp_path): "FOLDER", str(finished.parent): "FOLDER"}
    check_messages(Path(__file__).with_name("messages.txt"), told, hidden)

"""How commands end: mistakes of the program, files that fail, full disks, Ctrl-C, and processes told to stop."""

from __future__ import annotations

import errno
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from command import Command
from small_run import small_run

import acoustic_fem
from acoustic_fem.numerics.processors import cores
from localize.live.listener import Latencies
from studies.cli import app
from studies.inference.live import LiveSummary

ROOT = Path(__file__).parents[3]
STUDY = """
base = "array-2x6"
fidelity = "lumped"
stock = "off"
frequency = "1:100:4"
metrics = ["volume"]
sampling = "random"
cases = 3
[vary]
"tube.inner_diameter" = {from = 0.3, to = 0.4}
"""


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is full")
def test_a_full_disk_is_told_in_one_line(command: Command, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def full(*_: object, **__: object) -> None:
        with open("/dev/full", "w") as file:
            file.write("x" * 10_000)

    monkeypatch.setattr("geometry.ground.whole_files.os.replace", full)
    told = command("prototypes", "glove", "--out", tmp_path / "mine.toml")
    assert told.code == 1
    assert "No space left on device" in told.err.splitlines()[-1]
    assert "Traceback" not in told.err


def test_a_library_on_a_full_disk_is_told_by_its_name_in_every_format(
    command: Command, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    resource = pytest.importorskip("resource")
    library, own = small_run().folder / "library.nc", acoustic_fem.load
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)

    def loaded(path: Path) -> acoustic_fem.Library:
        found = own(path)
        resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, hard))
        return found

    monkeypatch.setattr("studies.run.library_files.load", loaded)
    for suffix in ("nc", "sofa", "npz", "csv"):
        try:
            told = command("convert", library, "--out", tmp_path / f"library.{suffix}")
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
        said = f"acoustic-fem: {tmp_path / 'library'}.{suffix}: cannot be written: File too large\n"
        assert (told.code, told.err) == (1, said)
        assert not list(tmp_path.iterdir())


def test_a_sweep_on_a_full_disk_names_its_store_and_goes_on_later(
    command: Command, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    study, out = tmp_path / "study.toml", tmp_path / "results.zarr"
    study.write_text(STUDY)

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with monkeypatch.context() as patch:
        patch.setattr("studies.sweep.records.Records.write", full)
        told = command("sweep", study, "--out", out, "--workers", 1)
    said = f"acoustic-fem: {out}: No space left on device ({out}); finished cases are kept, run again to continue"
    assert (told.code, told.err.splitlines()[-1]) == (1, said)
    assert command("sweep", study, "--out", out, "--workers", 1).code == 0


def test_a_recording_that_was_stopped_by_a_full_disk_ends_with_code_1(
    command: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    stopped = "a.wav: cannot be written: No space left on device"
    summary = LiveSummary(1.0, {}, 0, {"recording stopped": 1}, 0, Latencies(), (), "that nothing", None, stopped)
    monkeypatch.setattr("studies.inference.live.listen", lambda *_, **__: summary)
    told = command("live", "model")
    assert (told.code, told.err.splitlines()[-1].startswith(f"acoustic-fem: {stopped}")) == (1, True)


@pytest.mark.parametrize("error", [ImportError("initialization failed"), SystemError("error"), KeyboardInterrupt()])
def test_ctrl_c_ends_as_stopped_whatever_a_library_that_is_being_imported_makes_of_it(
    command: Command, monkeypatch: pytest.MonkeyPatch, error: BaseException
) -> None:
    def imported(_: str) -> None:
        try:
            signal.raise_signal(signal.SIGINT)
        except KeyboardInterrupt:
            raise error from None

    monkeypatch.setattr("studies.run.check.resolve_design", imported)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # what runs in the background may ignore it
    try:
        told = command("check", "array-2x6")
    finally:
        signal.signal(signal.SIGINT, before)
    assert (told.code, told.err) == (130, "acoustic-fem: stopped\n")


def test_a_ctrl_c_that_is_ignored_stays_so(command: Command) -> None:
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        assert command("prototypes").code == 0
        assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
    finally:
        signal.signal(signal.SIGINT, before)


def test_a_mistake_of_the_program_keeps_its_traceback(monkeypatch: pytest.MonkeyPatch) -> None:
    mistakes: list[Callable[[str], object]] = [
        lambda _: np.zeros(3) + np.zeros(4),
        lambda _: int("twelve"),
        lambda _: {}["name"],
        lambda _: np.linalg.inv(np.zeros((2, 3))),
    ]
    monkeypatch.setattr(sys, "argv", ["acoustic-fem", "check", "array-2x6"])
    for mistake in mistakes:
        monkeypatch.setattr("studies.run.check.resolve_design", mistake)
        with pytest.raises((ValueError, KeyError)):
            app.main()


def test_a_file_that_fails_is_named(command: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(_: str) -> None:
        raise OSError(5, "Input/output error", "disk/mine.toml")

    monkeypatch.setattr("studies.run.check.resolve_design", broken)
    told = command("check", "mine.toml")
    assert (told.code, told.err) == (1, "acoustic-fem: disk/mine.toml: Input/output error\n")


@pytest.mark.slow
def test_a_process_of_its_own_ends_the_same_way(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "studies.cli", "solve", "array-2x6", "--out", str(tmp_path / "none" / "library.nc")],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("acoustic-fem: ")
    assert done.stderr.count("\n") == 1


def test_what_is_done_is_told_in_plain_lines_where_there_is_no_terminal(command: Command, tmp_path: Path) -> None:
    told = command("solve", "array-2x6", "--out", tmp_path / "library.nc", "--fidelity", "lumped")
    assert "\x1b" not in told.err + told.out
    assert "Cells: network" in told.err.splitlines()
    assert told.err.count("closed form") == 3


def children_of(process: int) -> list[int]:
    """Child programs in which a process solves cells."""
    found = Path(f"/proc/{process}/task/{process}/children").read_text(encoding="ascii").split()
    return [int(each) for each in found if b"geometry.ground.child" in Path(f"/proc/{each}/cmdline").read_bytes()]


@pytest.mark.slow
@pytest.mark.skipif(cores() < 2, reason="cells are solved in child programs on several cores only")
def test_a_solve_that_is_told_to_stop_ends_its_child_programs_and_leaves_no_temporary_folder(tmp_path: Path) -> None:
    environment = {**os.environ, "ACOUSTIC_FEM_CACHE": str(tmp_path / "cache"), "TMPDIR": str(tmp_path)}
    program = subprocess.Popen(
        [sys.executable, "-m", "studies.cli", "solve", "array-2x6", "--out", str(tmp_path / "library.nc")],
        env=environment,
        stderr=subprocess.PIPE,
        text=True,
    )
    deadline = time.monotonic() + 600
    while not (children := children_of(program.pid)) and time.monotonic() < deadline:
        time.sleep(0.1)
    assert children
    program.terminate()
    _, said = program.communicate(timeout=600)
    assert program.returncode == 143
    assert "stopped" in said
    assert "Traceback" not in said
    while any(Path(f"/proc/{child}").exists() for child in children) and time.monotonic() < deadline:
        time.sleep(0.1)
    assert not any(Path(f"/proc/{child}").exists() for child in children)
    assert {path.name for path in tmp_path.iterdir()} <= {"cache"}

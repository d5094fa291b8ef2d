"""A study on several hosts: the same store as on one machine, whatever happens to workers, cables and the scheduler."""

from __future__ import annotations

import json
import re
import signal
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import pytest
from coarse_cells import coarse_cells, coarse_in_children
from hosts import PATIENCE, ROOT, Host, Hosts, NoHosts, wait_for
from stores import assert_same_store

from studies.study.study import load_study
from studies.sweep.run import run_sweep
from studies.sweep.survey import surveyed

pytestmark = pytest.mark.slow
STUDY = """
base = "array-2x6"
fidelity = "lumped"
stock = "off"
frequency = "1:100:12"
metrics = ["distance_smallest", "volume"]
sampling = "latin-hypercube"
cases = 32
seed = 5
keep = "responses"
[vary]
"tube.inner_diameter" = {from = 0.3, to = 0.76}
"tube.length" = {from = 8, to = 30}
"""
BLOCKS = 16
SUPPORT = ROOT / "tests" / "support"
#: Seconds after which a worker or scheduler is given up that shall be, and shall not be in the time of a test.
SOON, LATER, NEVER = "2", "10", "1000"


@dataclass
class Cluster:
    """Scheduler on one host, workers on three others, and the host of whoever asks."""

    hosts: Hosts
    folder: Path
    """The only one that all hosts see."""
    scheduler: subprocess.Popen[bytes]
    workers: dict[str, subprocess.Popen[bytes]]

    @property
    def address(self) -> str:
        return f"tcp://{self.hosts.hosts[1].address}:8786"

    def host(self, name: str) -> Host:
        return self.hosts.hosts[1 + int(name[-1])]

    def start_worker(
        self, name: str, *, label: str = "", address: str = "", **environment: str
    ) -> subprocess.Popen[bytes]:
        """A worker on the host that its name says; it has a cache of its own."""
        label = label or name
        own = Path("/tmp", label)  # of the host
        held = {"HELD_FOLDER": str(self.folder), "HELD_NAME": label, "PYTHONPATH": str(self.folder)}
        environment = {**held, **environment}
        host = self.host(name)
        process = host.start(
            "-m", "distributed.cli.dask_worker", address or self.address, "--nthreads", "1", "--no-nanny",
            "--no-dashboard", "--host", host.address, "--name", label, "--local-directory", str(own),
            "--preload", str(SUPPORT / "held_worker.py"), OMP_NUM_THREADS="1",
            ACOUSTIC_FEM_CACHE=str(own / "cells"), **environment,
        )  # fmt: skip
        self.workers[label] = process
        return process

    @contextmanager
    def sweep(
        self, study: Path, out: Path, worker: str = NEVER, scheduler: str = NEVER, address: str = "", **environment: str
    ) -> Iterator[subprocess.Popen[bytes]]:
        """A sweep that runs, of whoever asks, and the times after which it gives up a worker and the scheduler."""
        run = self.hosts.hosts[0].start(
            str(SUPPORT / "impatient_sweep.py"), worker, scheduler, "sweep", str(study), "--out", str(out),
            "--scheduler", address or self.address, told=True, **environment,
        )  # fmt: skip
        try:
            yield run
        finally:
            run.kill()
            run.wait()

    @contextmanager
    def held(self, *names: str) -> Iterator[None]:
        """Workers that wait in the block to which they come next."""
        for name in names:
            (self.folder / f"hold-{name}").touch()
            (self.folder / f"at-{name}").unlink(missing_ok=True)
        try:
            yield
        finally:
            for name in names:
                (self.folder / f"hold-{name}").unlink(missing_ok=True)

    def reached(self, name: str) -> bool:
        return (self.folder / f"at-{name}").exists()


@pytest.fixture(scope="module")
def cluster(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Cluster]:
    folder = tmp_path_factory.mktemp("cluster")
    try:
        hosts = Hosts(5, folder)
    except NoHosts as reason:
        pytest.skip(str(reason))
    coarse_in_children(folder)
    own = hosts.hosts[1]
    scheduler = own.start(
        "-m", "distributed.cli.dask_scheduler", "--host", own.address, "--port", "8786", "--no-dashboard"
    )
    found = Cluster(hosts, folder, scheduler, {})
    try:
        for name in ("w1", "w2", "w3"):
            found.start_worker(name)
        yield found
    finally:
        for process in (*found.workers.values(), scheduler):
            process.kill()
            process.wait()
        hosts.close()


@pytest.fixture(scope="module")
def alone(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """The study, and its store made by one process."""
    folder = tmp_path_factory.mktemp("alone")
    (folder / "study.toml").write_text(STUDY)
    run_sweep(load_study(folder / "study.toml"), folder / "results.zarr", workers=1)
    return folder / "study.toml", folder / "results.zarr"


def ended(run: subprocess.Popen[bytes]) -> tuple[int, list[str]]:
    """Exit code and lines on stderr but those of progress and notes."""
    _, error = run.communicate(timeout=PATIENCE)
    lines = error.decode().splitlines()
    return run.returncode, [line for line in lines if not line.startswith(("Sweep", "note: "))]


def events(out: Path, kind: str) -> list[dict[str, object]]:
    log = out.with_name(out.name + ".log")
    lines = log.read_text().splitlines() if log.exists() else []
    return [event for event in map(json.loads, lines) if event["event"] == kind]


def wrote_more(out: Path, blocks: int) -> bool:
    return len(events(out, "block")) > blocks


def test_hosts_share_a_folder_and_no_other(cluster: Cluster) -> None:
    look = "import sys, pathlib; print([pathlib.Path(each).exists() for each in sys.argv[1:]])"
    write = "import sys, pathlib; [pathlib.Path(each).touch() for each in sys.argv[1:]]"
    places = [str(Path(folder, "hosts-share")) for folder in (cluster.folder, Path.home(), "/tmp", "/dev/shm")]
    for _ in range(2):  # what the first wrote, the second finds, or not
        first, second = (cluster.host(name).start("-c", code, *places, told=True)
                         for name, code in (("w1", write), ("w2", look)))  # fmt: skip
        assert first.communicate() == (b"", b"")
        found, _ = second.communicate()
    assert json.loads(found.decode().lower()) == [True, False, False, False]
    assert [Path(place).exists() for place in places] == [True, False, False, False]


def test_a_worker_that_is_stopped_or_killed_changes_nothing(
    cluster: Cluster, alone: tuple[Path, Path], tmp_path: Path
) -> None:
    out = tmp_path / "r.zarr"
    with cluster.held("w1", "w2"), cluster.sweep(alone[0], out, SOON) as run:
        wait_for(lambda: cluster.reached("w1") and cluster.reached("w2"), run)
        cluster.workers["w1"].send_signal(signal.SIGSTOP)
        cluster.workers["w2"].kill()
        assert ended(run) == (0, [])
    cluster.workers["w1"].send_signal(signal.SIGCONT)
    assert len(events(out, "block")) == BLOCKS
    notes = [str(event["note"]) for event in events(out, "note")]
    silent = re.escape(cluster.host("w1").address)
    assert any(re.match(rf"worker tcp://{silent}:\d+ was silent for 2 s", note) for note in notes), notes
    assert_same_store(out, alone[1])
    cluster.workers["w2"].wait()
    cluster.start_worker("w2")


def test_a_worker_whose_cable_is_out_for_a_while_changes_nothing(
    cluster: Cluster, alone: tuple[Path, Path], tmp_path: Path
) -> None:
    out = tmp_path / "r.zarr"
    with cluster.sweep(alone[0], out, SOON) as run, cluster.held("w2", "w3"):
        wait_for(lambda: cluster.reached("w2") and cluster.reached("w3"), run)
        cluster.hosts.link(cluster.host("w3"), "down")
        wait_for(lambda: [event for event in events(out, "note") if "silent" in str(event["note"])], run)
        cluster.hosts.link(cluster.host("w3"), "up")
        # both hold blocks, one of them blocks that others have done
        (cluster.folder / "hold-w2").unlink()
        (cluster.folder / "hold-w3").unlink()
        assert ended(run) == (0, [])
    assert len(events(out, "block")) == BLOCKS
    assert_same_store(out, alone[1])


def test_a_worker_with_another_version_computes_nothing(
    cluster: Cluster, alone: tuple[Path, Path], tmp_path: Path
) -> None:
    about = cluster.folder / "older" / "numpy-0.0.1.dist-info"
    about.mkdir(parents=True)
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: numpy\nVersion: 0.0.1\n")
    process = cluster.start_worker("w3", label="other", PYTHONPATH=str(about.parent))
    out = tmp_path / "r.zarr"
    with cluster.held("w1", "w2", "w3"), cluster.sweep(alone[0], out) as run:
        wait_for(lambda: (cluster.folder / "asked-other").exists(), run, process)
        for name in ("w1", "w2", "w3"):
            (cluster.folder / f"hold-{name}").unlink()
        assert ended(run) == (0, [])
    process.kill()
    process.wait()
    unprotected, note = (str(event["note"]) for event in events(out, "note"))
    assert unprotected.startswith(f"{cluster.address} is not encrypted: ")
    host = re.escape(cluster.host("w3").address)
    assert re.fullmatch(rf"worker tcp://{host}:\d+ is not used: it has numpy 0\.0\.1 \(here [\d.]+\)", note), note
    assert not cluster.reached("other")
    assert_same_store(out, alone[1])


def certificate_in(folder: Path) -> dict[str, str]:
    """A certificate that signs itself, and the variables that name it."""
    certificate, key = folder / "cert.pem", folder / "key.pem"
    make = "openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 -subj /CN=cluster"
    subprocess.run([*make.split(), "-keyout", key, "-out", certificate], check=True, capture_output=True)
    named = {"DASK_DISTRIBUTED__COMM__TLS__CA_FILE": str(certificate)}
    for who in ("SCHEDULER", "WORKER", "CLIENT"):
        named[f"DASK_DISTRIBUTED__COMM__TLS__{who}__CERT"] = str(certificate)
        named[f"DASK_DISTRIBUTED__COMM__TLS__{who}__KEY"] = str(key)
    return named


def test_over_tls_the_result_is_the_same_and_nobody_without_a_certificate_gets_in(
    cluster: Cluster, alone: tuple[Path, Path], tmp_path: Path
) -> None:
    """With the variables that docs/cluster.md names."""
    tls = {"DASK_DISTRIBUTED__COMM__REQUIRE_ENCRYPTION": "true", **certificate_in(cluster.folder)}
    page = (ROOT / "docs" / "cluster.md").read_text(encoding="utf-8")
    assert all(re.sub("SCHEDULER|WORKER|CLIENT", "${who}", name) in page for name in tls)
    host = cluster.hosts.hosts[1]
    place = ("--host", host.address, "--port", "8789", "--no-dashboard", "--protocol", "tls")
    scheduler = host.start("-m", "distributed.cli.dask_scheduler", *place, **tls)
    address = f"tls://{host.address}:8789"
    worker = cluster.start_worker("w1", label="secret", address=address, **tls)
    try:
        with cluster.sweep(alone[0], tmp_path / "r.zarr", address=address, **tls) as run:
            assert ended(run) == (0, [])
        assert cluster.reached("secret")
        assert events(tmp_path / "r.zarr", "note") == []
        assert_same_store(tmp_path / "r.zarr", alone[1])
        strange = {**tls, **certificate_in(tmp_path)}  # a certificate that nobody of this cluster signed
        with cluster.sweep(alone[0], tmp_path / "none.zarr", address=address, **strange) as run:
            code, lines = ended(run)
        assert (code, len(lines)) == (1, 1), lines
        assert f"no scheduler answers at {address}" in lines[0]
    finally:
        for process in (worker, scheduler):
            process.kill()
            process.wait()


def test_cells_are_solved_once_whoever_solves_them(
    cluster: Cluster, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The workers have caches of their own; a second study finds the cells with whoever asked first."""
    study, out, cache = tmp_path / "study.toml", tmp_path / "r.zarr", str(tmp_path / "cells")
    study.write_text(
        'base = "line-3"\nfidelity = "helmholtz"\nfrequency = "1:100:6"\nmetrics = ["ipd_mean"]\n'
        '[vary]\n"tube.length" = [9, 10, 11, 12]\n'
    )
    needed = len(surveyed(load_study(study)).cells_of(range(4)))
    with cluster.sweep(study, out, ACOUSTIC_FEM_CACHE=cache, PYTHONPATH=str(cluster.folder)) as run:
        assert ended(run) == (0, [])
    assert len(events(out, "block")) == 4
    assert len(list(cluster.folder.glob("solved-*"))) == needed > 1
    study.write_text(study.read_text().replace("[9, 10, 11, 12]", "[13, 14]"))
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", cache)
    with coarse_cells():
        summary = run_sweep(load_study(study), tmp_path / "more.zarr", workers=1).summary
    assert (summary.cells, summary.cells_solved) == (needed, 0)


def test_a_scheduler_that_is_stopped_or_killed_ends_the_sweep_in_one_line_and_it_goes_on_later(
    cluster: Cluster, alone: tuple[Path, Path], tmp_path: Path
) -> None:
    out = tmp_path / "r.zarr"
    study, expected = alone
    for blow, silence, told in (
        (signal.SIGSTOP, LATER, f"the scheduler at {cluster.address} has not answered for {LATER} s"),
        (signal.SIGKILL, NEVER, "the connection to the scheduler was lost"),
    ):
        with cluster.held("w1", "w2", "w3"), cluster.sweep(study, out, scheduler=silence) as run:
            wait_for(lambda: all(cluster.reached(name) for name in ("w1", "w2", "w3")), run)
            (cluster.folder / "hold-w1").unlink()
            wait_for(partial(wrote_more, out, len(events(out, "block"))), run)
            cluster.scheduler.send_signal(blow)
            line = f"acoustic-fem: {out}: {told}; finished cases are kept, run again to continue"
            assert ended(run) == (1, [line])
        cluster.scheduler.send_signal(signal.SIGCONT)
    assert 0 < len(events(out, "block")) < BLOCKS
    run_sweep(load_study(study), out, workers=1)
    assert_same_store(out, expected)

"""Commands run one by one in forked children of a process that has everything loaded, with limits and a full account.

A command that starts anew takes seconds to import what it needs; a forked child takes none of that, and what it breaks
is gone with it.
"""

from __future__ import annotations

import contextlib
import gc
import io
import json
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time
import traceback
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path

ROOT = Path(__file__).parents[3]
#: Addresses that a command may take, bytes: beyond it the system refuses memory.
ADDRESSES = 24 * 2**30
#: What is loaded before the first command: whatever a verb may import.
MODULES = (
    "studies.cli.app, acoustic_fem.calibration, acoustic_fem.cell.design_cells, acoustic_fem.library.exchange, "
    "acoustic_fem.scatter, cadquery, dask.array, distributed, gmsh, localize, localize.decoders.bayes, "
    "localize.decoders.judgement, localize.decoders.tolerant, localize.graphs.onnx_localizer, localize.learned.onnx, "
    "localize.learned.training, localize.live.sources, h5netcdf, matplotlib.backends.backend_agg, matplotlib.pyplot, "
    "onnx, onnxruntime, optuna, PIL.features, pyvista, rich.table, safetensors.torch, scipy.cluster.hierarchy, "
    "scipy.fftpack, scipy.io, studies, studies.findings, studies.evaluation, studies.test_rig, studies.run, "
    "studies.sweep.run, studies.optimization.search, torch, torch._dynamo, trimesh, xarray, zarr"
)


@dataclass(frozen=True)
class Ended:
    """How a command ended."""

    code: int
    """Its exit code, negative where a signal ended it."""
    out: str
    """What it printed."""
    err: str
    """What it printed beside that."""
    seconds: float
    """How long it took, s."""
    memory: int
    """The most memory that it held at a time, bytes, that of what was loaded before included."""
    in_time: bool
    """Whether it ended before it was ended."""


class Commands:
    """The process that forks; one command at a time."""

    def __init__(self) -> None:
        self._process = subprocess.Popen(
            [sys.executable, __file__], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, encoding="utf-8"
        )

    def run(
        self,
        words: list[str],
        folder: Path,
        limit: float = 60.0,
        environment: Mapping[str, str] = {},
        limits: Mapping[str, int] = {},
    ) -> Ended:
        """How ``acoustic-fem`` with these words, or ``-c`` and Python, ended in a folder; killed after ``limit`` s.

        Args:
            words: the command.
            folder: where it runs.
            limit: s.
            environment: variables that are set for it; it then begins as a program of its own, as some are read only
                when a library is imported.
            limits: of the system, by the ends of their names in ``resource``.
        """
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        print(
            json.dumps([words, str(folder), limit, dict(environment), dict(limits)]),
            file=self._process.stdin,
            flush=True,
        )
        return Ended(**json.loads(self._process.stdout.readline()))

    def close(self) -> None:
        """End the process."""
        assert self._process.stdin is not None
        self._process.stdin.close()
        self._process.wait()


@contextlib.contextmanager
def commands() -> Iterator[Commands]:
    """A process to run commands in, ended with the block."""
    served = Commands()
    try:
        yield served
    finally:
        served.close()


# -- in the process that forks --------------------------------------------------------------------------------
def serve() -> None:
    """Run what is asked for on standard input, a line each, until it closes."""
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # nobody else writes among the answers
    for module in MODULES.split(", "):
        __import__(module)
    gc.collect()
    gc.freeze()  # what children share they need not copy
    for line in sys.stdin:
        print(json.dumps(asdict(_ended(*json.loads(line)))), file=answers, flush=True)


def _ended(words: list[str], folder: str, limit: float, environment: dict[str, str], limits: dict[str, int]) -> Ended:
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        began = time.monotonic()
        child = os.fork()
        if child == 0:
            _become(words, folder, out.fileno(), err.fileno(), environment, limits)
        in_time, status, used = _waited(child, began + limit)
        seconds = time.monotonic() - began
        texts = []
        for stream in (out, err):
            stream.seek(0)
            texts.append(stream.read(2_000_000).decode("utf-8", "replace"))
    return Ended(os.waitstatus_to_exitcode(status), texts[0], texts[1], seconds, used * 1024, in_time)


def _waited(child: int, until: float) -> tuple[bool, int, int]:
    while time.monotonic() < until:
        ended, status, used = os.wait4(child, os.WNOHANG)
        if ended:
            return True, status, used.ru_maxrss
        time.sleep(0.01)
    with contextlib.suppress(ProcessLookupError):
        os.killpg(child, signal.SIGKILL)
    _, status, used = os.wait4(child, 0)
    return False, status, used.ru_maxrss


def _become(
    words: list[str], folder: str, out: int, err: int, environment: dict[str, str], limits: dict[str, int]
) -> None:
    """Be the command and end as it does."""
    code = 70
    try:
        os.setsid()
        with open(os.devnull, "rb") as nothing:
            os.dup2(nothing.fileno(), 0)
        os.dup2(out, 1)
        os.dup2(err, 2)
        sys.stdin = io.StringIO()
        sys.stdout, sys.stderr = (os.fdopen(k, "w", encoding="utf-8", errors="replace") for k in (1, 2))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_AS, (ADDRESSES, ADDRESSES))
        os.chdir(folder)
        for name, value in limits.items():
            resource.setrlimit(getattr(resource, f"RLIMIT_{name}"), (value, value))
        if environment:
            command = ["-c", words[1]] if words[0] == "-c" else ["-m", "studies.cli", *words]
            own = {**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT), os.environ.get("PYTHONPATH", "")])}
            os.execve(sys.executable, [sys.executable, *command], {**own, **environment})
        code = _call(words)
    except SystemExit as ended:
        code = int(ended.code or 0)
    except BaseException:
        traceback.print_exc()
    finally:
        with contextlib.suppress(Exception):
            sys.stdout.flush()
            sys.stderr.flush()
        os._exit(code)


def _call(words: list[str]) -> int:
    """Run the command, or Python where the first word is ``-c``, as a user's program would: a refusal in one line."""
    if words[0] == "-c":
        from geometry.ground.refusal import Refusal

        try:
            exec(words[1], {"__name__": "__main__"})
        except Refusal as error:
            print(f"acoustic-fem: {error}", file=sys.stderr)
            return 1
        return 0
    from studies.cli import app

    sys.argv = ["acoustic-fem", *words]
    app.main()
    return 0


if __name__ == "__main__":
    serve()

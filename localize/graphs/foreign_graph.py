"""A graph of which nobody knows what it does, run in a process of its own with limits of time and memory."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from multiprocessing import Pipe
from multiprocessing.connection import Connection

import numpy as np
from numpy.typing import NDArray

from geometry.ground.refusal import Refusal

LONGEST = 10.0
"""Time that a batch of frames may take, s; the start of the process has as much on top."""
LARGEST_MEMORY = 1_500_000_000
"""Memory that the process may take, bytes."""


class ForeignGraph:
    """Graph that runs in a process of its own, which ends with this object, or when a limit is reached.

    Args:
        content: the ONNX file.
        source: its name, put before messages.
        refusal: class of the errors.

    Raises:
        Exception: by ``refusal``: the graph cannot be loaded within the limits.
    """

    def __init__(self, content: bytes, source: str, refusal: type[Refusal]) -> None:
        self._source, self._refusal = source, refusal
        self._ours, theirs = Pipe()
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p), "OMP_NUM_THREADS": "1"}
        self._process = subprocess.Popen(
            [sys.executable, "-m", __name__, str(theirs.fileno())],
            pass_fds=[theirs.fileno()],
            stdin=subprocess.PIPE,  # its end tells the child that its parent is gone
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            env=environment,
        )
        theirs.close()
        self._asked(content, 2 * LONGEST)

    def run(self, frames: NDArray[np.float32]) -> NDArray[np.float32]:
        """Log probabilities of frames.

        Args:
            frames: (n, n_microphone, 250) float32, Pa.

        Returns:
            (n, n_point) float32, whatever the graph gives.

        Raises:
            Exception: by the refusal: a limit was reached, or the graph cannot be run.
        """
        shape = np.array(frames.shape, np.int64).tobytes()
        answer = self._asked(shape + np.ascontiguousarray(frames, np.float32).tobytes(), LONGEST)
        rows, columns = np.frombuffer(answer[:16], np.int64)
        return np.frombuffer(answer[16:], np.float32).reshape(rows, columns)

    def close(self) -> None:
        """End the process."""
        self._process.kill()
        self._process.communicate()
        self._ours.close()

    def __del__(self) -> None:
        if hasattr(self, "_process") and self._process.poll() is None:
            self.close()

    def _asked(self, question: bytes, seconds: float) -> bytes:
        try:
            self._ours.send_bytes(question)
            if not self._ours.poll(seconds):
                self.close()
                raise self._refusal(f"{self._source}: its graph takes more than {seconds:g} s; it was stopped")
            answer = self._ours.recv_bytes()
        except (OSError, EOFError):
            self.close()
            raise self._refusal(
                f"{self._source}: its graph ended the process that ran it, which may take {LARGEST_MEMORY / 1e9:g} GB"
            ) from None
        if answer[:1] != b"+":
            self.close()
            raise self._refusal(f"{self._source}: its graph cannot be run: {answer[1:].decode(errors='replace')}")
        return answer[1:]


def serve(connection: Connection) -> None:
    """Run a graph for the process that started this one, until it is gone; no module of the project is needed here."""
    import resource

    import onnxruntime

    def end_with_parent() -> None:
        sys.stdin.read()
        os._exit(1)

    threading.Thread(target=end_with_parent, daemon=True).start()
    resource.setrlimit(resource.RLIMIT_AS, (LARGEST_MEMORY, LARGEST_MEMORY))
    session = None
    while True:
        try:
            question = connection.recv_bytes()
        except (OSError, EOFError):
            return
        try:
            if session is None:
                options = onnxruntime.SessionOptions()
                options.intra_op_num_threads = options.inter_op_num_threads = 1
                options.log_severity_level = 4
                session = onnxruntime.InferenceSession(question, options, providers=["CPUExecutionProvider"])
                answer = b""
            else:
                shape = np.frombuffer(question[:24], np.int64)
                frames = np.frombuffer(question[24:], np.float32).reshape(shape)
                (score,) = session.run(["log_probability"], {"frames": frames})
                rows, columns = score.shape
                answer = np.array([rows, columns], np.int64).tobytes() + np.asarray(score, np.float32).tobytes()
            connection.send_bytes(b"+" + answer)
        except Exception as error:  # of the runtime, about a graph that is not ours
            connection.send_bytes(b"-" + " ".join(str(error).split())[:500].encode())


if __name__ == "__main__":
    serve(Connection(int(sys.argv[1])))

"""A graph that this program did not write, run in a process of its own with limits of time and memory."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from geometry.ground.child import Child
from geometry.ground.process_messages import ChildError, Limits
from geometry.ground.refusal import Kind, Refusal

LONGEST = 10.0
"""Time that a batch of frames may take, s; the start of the process has as much on top."""
LARGEST_MEMORY = 1_500_000_000
"""Memory that the process may take, bytes."""


class ForeignGraph:
    """Graph that runs in a process of its own, which ends with this object, or when a limit is reached.

    Args:
        content: the ONNX file.
        source: its name.
        refusal: class of the error.

    Raises:
        Refusal: of that class: the graph cannot be loaded within the limits.
    """

    def __init__(self, content: bytes, source: str, refusal: type[Refusal]) -> None:
        self._source, self._refusal = source, refusal
        self._child = Child(
            "the graph",
            limits=Limits(memory=LARGEST_MEMORY),
            start=partial(_open, content),
            environment={"OMP_NUM_THREADS": "1"},
            quiet=True,
            trusted=False,
        )
        self._ask(2 * LONGEST)

    def run(self, frames: NDArray[np.float32]) -> NDArray[np.float32]:
        """Log probabilities of frames.

        Args:
            frames: (n, n_microphone, 250) float32, Pa.

        Returns:
            (n, n_point) float32, whatever the graph gives.

        Raises:
            Refusal: of the class: a limit was reached, or the graph cannot be run.
        """
        answer = self._ask(LONGEST, frames)
        rows, columns = np.frombuffer(answer[:16], np.int64)
        return np.frombuffer(answer[16:], np.float32).reshape(rows, columns)

    def close(self) -> None:
        """End the process."""
        self._child.kill()

    def _ask(self, seconds: float, *frames: NDArray[np.float32]) -> bytes:
        try:
            answer = self._child.call(_answer, *frames, seconds=seconds)
        except ChildError as error:
            problem = f"takes more than {seconds:g} s; it was stopped"
            if error.status is not None:
                problem = f"ended the process that ran it, which may take {LARGEST_MEMORY / 1e9:g} GB"
            raise self._refusal(f"its graph {problem}", kind=Kind.STOPPED, file=self._source) from None
        if answer[:1] != b"+":
            self._child.kill()
            problem = f"its graph cannot be run: {answer[1:].decode(errors='replace')}"
            raise self._refusal(problem, kind=Kind.UNREADABLE, file=self._source)
        return answer[1:]


def _open(content: bytes) -> Any:
    """In the process: the graph, or why it cannot be loaded."""
    import onnxruntime

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    options.log_severity_level = 4
    try:
        return onnxruntime.InferenceSession(content, options, providers=["CPUExecutionProvider"])
    except Exception as error:  # of the runtime, about a graph that is not ours
        return error


def _answer(graph: Any, *frames: NDArray[np.float32]) -> bytes:
    """In the process: what the graph makes of frames, if there are any, behind ``+``; what is wrong behind ``-``."""
    try:
        if isinstance(graph, Exception):
            raise graph
        if not frames:
            return b"+"
        (score,) = graph.run(["log_probability"], {"frames": frames[0]})
        rows, columns = score.shape
        return b"+" + np.array([rows, columns], np.int64).tobytes() + np.asarray(score, np.float32).tobytes()
    except Exception as error:
        return b"-" + " ".join(str(error).split())[:500].encode()

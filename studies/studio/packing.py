"""Messages to a page that hold many numbers: a header as JSON, then float32."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from studies.panels.curves import Curves
from studies.studio.stage import Job


def packed_signals(header: Mapping[str, Any], found: Mapping[str, Any]) -> bytes:
    """Signals with what was decoded of them, as :func:`packed` has curves."""
    told = {name: value for name, value in found.items() if name != "signals"}
    return _framed({**header, **told}, found["signals"])


def packed(job: Job, curves: Curves) -> bytes:
    """Curves as one message: the length of a header in four bytes, the header as JSON, the values as float32."""
    header = {
        "stage": job.stage,
        "revision": job.revision,
        "quantity": curves.quantity,
        "unit": curves.unit,
        "points": list(curves.points),
        "heard_by": list(curves.heard_by),
        "frequency": [float(f"{value:.7g}") for value in curves.frequency],
    }
    return _framed(header, curves.values.astype("<f4").tobytes())


def _framed(header: Mapping[str, Any], values: bytes) -> bytes:
    text = json.dumps(header, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    return len(text).to_bytes(4, "little") + text + values

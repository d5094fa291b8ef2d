"""Sizes of the convolutional networks that a plan of training may ask for by name."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

#: What a training plan may ask for by name.
NETWORKS: Mapping[str, Mapping[str, Any]] = {
    "patches": {"width": 32, "depths": (1, 2, 2), "patch": (4, 8)},
    "stride-2": {"width": 12, "depths": (1, 1, 2, 2, 2), "patch": (2, 2)},
    "paper": {"width": 12, "depths": (1, 1, 2, 2, 2), "patch": (1, 1), "merge_last": True},
    "two-stage": {"width": 64, "depths": (1, 2), "patch": (16, 8), "merge_last": True},
    "small-patches": {"width": 24, "depths": (1, 1, 2), "patch": (4, 2), "merge_last": True},
}

"""A hash of each array and text of a library, stored with it: what a file holds is what was written, or is refused."""

from __future__ import annotations

import hashlib
import json

import numpy as np
import xarray as xr

from geometry.ground.refusal import Refusal

CHECKSUMS = "checksums"
"""Attribute of a data set: SHA-256 of its members by name, as JSON."""


class NoChecksumWarning(UserWarning):
    """A file without checksums: of an older version, or changed on purpose."""


def checksums(dataset: xr.Dataset, texts: tuple[str, ...], arrays: dict[str, tuple[str, ...]]) -> str:
    """What belongs into the attribute :data:`CHECKSUMS`.

    Args:
        dataset: what is written.
        texts: names of attributes.
        arrays: dimensions by names of real variables, in the order in which they count; what is not there has none.
    """
    return json.dumps(_digests(dataset, texts, arrays))


def check_checksums(dataset: xr.Dataset, texts: tuple[str, ...], arrays: dict[str, tuple[str, ...]]) -> None:
    """Refuse a data set of which a member is not the one that was written; without checksums anything goes.

    Arguments as for :func:`checksums`.

    Raises:
        Refusal: names the member.
    """
    if CHECKSUMS not in dataset.attrs:
        return
    try:
        stored = json.loads(dataset.attrs[CHECKSUMS])
    except (TypeError, ValueError, RecursionError):
        stored = None
    if not isinstance(stored, dict):
        raise Refusal(f"attribute {CHECKSUMS} is damaged: it must be a JSON object")
    found = _digests(dataset, texts, arrays)
    for name in stored:
        if name not in found:
            raise Refusal(f"{name} is missing, which was written (attribute {CHECKSUMS})")
    for name, digest in found.items():
        if stored.get(name) != digest:
            raise Refusal(
                f"{name} is not what was written (its SHA-256 differs): it is damaged or was altered; who altered it "
                f"on purpose removes {CHECKSUMS}"
            )


def _digests(dataset: xr.Dataset, texts: tuple[str, ...], arrays: dict[str, tuple[str, ...]]) -> dict[str, str]:
    found = {name: hashlib.sha256(str(dataset.attrs[name]).encode()).hexdigest() for name in texts}
    for name, dimensions in arrays.items():
        if name in dataset.variables:
            values = np.ascontiguousarray(dataset[name].transpose(*dimensions).values, "<f8")
            found[name] = hashlib.sha256(str(values.shape).encode() + values.tobytes()).hexdigest()
    return found

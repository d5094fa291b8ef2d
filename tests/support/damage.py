"""Damage to files: single bits that flip, and ends that are missing."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np


def damaged(folder: Path, count: int, seed: int) -> Iterator[str]:
    """Damage one file of a folder at a time, at random, and mend it again.

    Args:
        folder: with the files, at any depth.
        count: how often.
        seed: of the draws.

    Yields:
        What was done, in words, while it is so.
    """
    generator = np.random.default_rng(seed)
    files = sorted(path for path in folder.rglob("*") if path.is_file() and path.stat().st_size)
    sizes = np.array([path.stat().st_size for path in files], float)
    for _ in range(count):
        # half of them by size, as bits flip; half by file, so that small ones have their turn
        share = sizes / sizes.sum() if generator.random() < 0.5 else None
        path = files[generator.choice(len(files), p=share)]
        whole = path.read_bytes()
        if generator.random() < 0.8:
            place, bit = int(generator.integers(len(whole))), int(generator.integers(8))
            content = bytearray(whole)
            content[place] ^= 1 << bit
            done = f"bit {bit} of byte {place}"
        else:
            place = int(generator.integers(len(whole)))
            content = bytearray(whole[:place])
            done = f"from byte {place}"
        path.write_bytes(content)
        try:
            yield f"{path.relative_to(folder)}: {done} of {len(whole)}"
        finally:
            path.write_bytes(whole)

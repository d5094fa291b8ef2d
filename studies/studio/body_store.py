"""Files of bodies that arrays are laid on: that of the design file, and those that pages have handed in."""

from __future__ import annotations

import hashlib
import re
from pathlib import Path, PurePosixPath
from shutil import rmtree

from geometry.design.array_design import ArrayDesign

#: Bodies that are kept; beyond, the one that was handed in first goes.
MOST_BODIES = 16
#: Longest name of a file, and what may not stand in one.
_LONGEST, _STRANGE = 80, re.compile(r"[^\w.()+-]+")


class BodyStore:
    """Bodies at hand.

    Args:
        folder: where bodies that are handed in are kept.
        beside: folder of the design file that the studio was started with; None if there is none.
        design: that the studio was started with.
    """

    def __init__(self, folder: Path, beside: Path | None = None, design: ArrayDesign | None = None) -> None:
        self._folder, self._beside = folder, beside
        stated = None if design is None else design.surface
        self._own = None if stated is None else stated.body
        self._kept: dict[str, Path] = {}

    def keep(self, content: bytes, name: str) -> Path:
        """Write a body that is handed in to a file.

        Args:
            content: of the file.
            name: that it has elsewhere.

        Returns:
            Its path. The last part is the name, without what may not stand in one.
        """
        digest = hashlib.sha256(content).hexdigest()
        own = PurePosixPath(name.replace("\\", "/")).name
        path = self._folder / digest / (_STRANGE.sub("_", own)[-_LONGEST:].lstrip(".-") or "body")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
        self._kept.pop(digest, None)
        self._kept[digest] = path
        for old in [*self._kept][:-MOST_BODIES]:
            rmtree(self._kept.pop(old).parent, ignore_errors=True)
        return path

    def of(self, design: ArrayDesign) -> Path | None:
        """The file of the body that a design names; None where it is not at hand.

        A file beside the design is named also where there is none: its reader says that it is missing.
        """
        stated, frozen = design.surface, design.layout.frozen
        if stated is None:
            return None
        if frozen is not None and frozen.body in self._kept:
            return self._kept[frozen.body]
        if self._beside is None:
            return None
        path = (self._beside / stated.body).resolve()
        # A page may name any file, and shall see none but those of the design's own folder.
        return path if stated.body == self._own or path.is_relative_to(self._beside.resolve()) else None

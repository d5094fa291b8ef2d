"""Files of what comes in while a stream is listened to: WAV files that survive a kill."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.sound.growing_wav import GrowingWav


class LiveRecorder:
    """Recorder of samples as fractions of full scale; a file for each time that the source is opened.

    A file that is full is followed by another one. Samples that were lost within a file are zeros in it, so that its
    times are right; between files nothing is known.

    Args:
        path: of the first file; the next ones are called ``name-2.wav``, ``name-3.wav`` and so on, and pass over names
            that are taken.
        rate: of the samples, Hz.
        channels: how many.
        full_scale: pressure of a fraction of 1, Pa.
    """

    def __init__(self, path: str | os.PathLike[str], rate: float, channels: int, full_scale: float = 1.0) -> None:
        self._path, self._rate, self._channels, self._scale = Path(path), round(rate), channels, full_scale
        self._file: GrowingWav | None = None
        self.paths: list[Path] = []
        """Files so far."""

    def begin(self) -> None:
        """Open the next file.

        Raises:
            OSError: it cannot be written.
        """
        self.close()
        path, number = self._path, len(self.paths) + 1
        while self.paths and (path in self.paths or path.exists()):
            path = self._path.with_name(f"{self._path.stem}-{number}{self._path.suffix}")
            number += 1
        self._file = GrowingWav(path, self._rate, self._channels)
        self.paths.append(path)

    def write(self, samples: NDArray[np.float64]) -> None:
        """Append samples to the file.

        Args:
            samples: (n_channel, n) float64, Pa.

        Raises:
            OSError: it cannot be written.
        """
        if self._file is None or self._file.full:
            self.begin()
        assert self._file is not None
        self._file.write(samples / self._scale)

    def skip(self, count: int) -> None:
        """Append zeros in place of a number of samples that were lost."""
        for first in range(0, count, self._rate):
            self.write(np.zeros((self._channels, min(self._rate, count - first))))

    def close(self) -> None:
        """Close the file."""
        if self._file is not None:
            self._file.close()
            self._file = None

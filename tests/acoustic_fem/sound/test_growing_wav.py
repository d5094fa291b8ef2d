"""A WAV file that grows can be read at every moment, also when its writer is killed."""

from __future__ import annotations

import itertools
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from refusals import refused

from acoustic_fem.sound.growing_wav import GrowingWav
from acoustic_fem.sound.sound_file import read_wav
from geometry.ground.refusal import Kind

ROOT = Path(__file__).parents[3]


def test_a_file_is_whole_after_every_write(tmp_path: Path) -> None:
    path = tmp_path / "grows.wav"
    samples = np.random.default_rng(0).standard_normal((3, 1000)).astype(np.float32).astype(np.float64)
    edges = [0, 1, 17, 500, 500, 1000]
    with GrowingWav(path, 44_100, 3) as file:
        for first, last in itertools.pairwise(edges):
            file.write(samples[:, first:last])
            sound = read_wav(path)
            np.testing.assert_array_equal(np.stack(list(sound.channels.values())), samples[:, :last])
            assert (sound.rate, sound.full_scale) == (44_100.0, None)


def test_what_was_appended_but_not_stated_is_passed_over(tmp_path: Path) -> None:
    path = tmp_path / "cut.wav"
    with GrowingWav(path, 1000, 2) as file:
        file.write(np.ones((2, 10)))
    with path.open("ab") as end:
        end.write(b"\1" * 13)  # samples of a write that was cut off
    assert len(read_wav(path).channels["2"]) == 10


WRITER = """
import sys
import numpy as np
from acoustic_fem.sound.growing_wav import GrowingWav
with GrowingWav(sys.argv[1], 1000, 2) as file:
    count = 0
    while True:
        number = np.arange(count, count + 37)
        file.write(np.stack([number, -number]).astype(float))
        count += 37
        print(count, flush=True)
"""


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="needs a system that kills")
def test_a_killed_writer_leaves_a_file_with_all_that_it_had_written(tmp_path: Path) -> None:
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    for turn in range(3):
        path = tmp_path / f"killed-{turn}.wav"
        with subprocess.Popen(
            [sys.executable, "-c", WRITER, str(path)], env=environment, stdout=subprocess.PIPE, text=True
        ) as process:
            assert process.stdout is not None
            written = int(process.stdout.readline())
            while written < 37 * (20 + 700 * turn):
                written = int(process.stdout.readline())
            time.sleep(1e-4 * turn)
            process.send_signal(signal.SIGKILL)
            left = process.stdout.read().splitlines()[:-1]  # the last line may be cut
        assert process.returncode == -signal.SIGKILL
        channels = read_wav(path).channels
        count = len(channels["1"])
        assert count >= max([written, *map(int, left)])
        np.testing.assert_array_equal(channels["1"], np.arange(count))
        np.testing.assert_array_equal(channels["2"], -channels["1"])


def test_a_disk_that_is_full_is_an_error_and_leaves_what_was_written(tmp_path: Path) -> None:
    with GrowingWav(tmp_path / "a.wav", 1000, 2) as file:
        assert not file.full
        with refused(Kind.WRONG_TYPE, "samples"):
            file.write(np.zeros((3, 5)))
        file.samples = 2**28 - 999
        assert file.full
        file.samples = 2**29
        with refused(Kind.OUT_OF_RANGE, file="a.wav"):
            file.write(np.zeros((2, 1)))
        file.samples = 0
    with refused(Kind.OUT_OF_RANGE, "rate", 0):
        GrowingWav(tmp_path / "b.wav", 0, 2)
    if Path("/dev/full").exists():
        with pytest.raises(OSError, match="No space left"):
            GrowingWav("/dev/full", 1000, 2)

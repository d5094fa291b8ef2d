"""Frames that the board's C writes are read in Python; damaged and lost ones are counted and never taken for others."""

from binascii import crc_hqx

import numpy as np
import pytest
from embedded_bench import needs_compiler
from hypothesis import given, strategies as st
from refusals import refused
from serial_line import Board, encoder

from geometry import Kind
from localize.live.serial_frames import FrameReader, SampleFrame, StatusFrame, TouchFrame

pytestmark = needs_compiler
SINGLE = st.floats(0, 100, width=32)
WORD = st.integers(0, 2**32 - 1)
TOUCH = st.tuples(
    st.just("touch"),
    WORD,
    WORD,
    st.sampled_from(["down", "moved", "beat", "up"]),
    st.integers(0, 65535),
    SINGLE,
    SINGLE,
    SINGLE,
)
STATUS = st.tuples(
    st.just("status"), WORD, WORD, WORD, SINGLE, st.integers(0, 65535), st.integers(0, 255),
    st.sampled_from(["raw", "events"]), st.text("aé-2x6", max_size=16),
)  # fmt: skip
SAMPLES = st.tuples(
    st.just("samples"), WORD, st.integers(1, 16), st.integers(1, 16), st.integers(0, 2**32 - 1), st.integers(1, 65535),
    SINGLE,
)  # fmt: skip


def written(board, frame):
    """Bytes of a frame, and the frame that they should be read as."""
    kind, *values = frame
    counter = board.counter
    if kind == "touch":
        return board.touch(*values), TouchFrame(counter, *values)
    if kind == "status":
        return board.status(*values), StatusFrame(counter, *values)
    first, microphones, count, seed, rate, limit = values
    samples = np.random.default_rng(seed).normal(size=(microphones, count)).astype(np.float32)
    samples[samples > 1.5] = np.nan
    return board.samples(first, samples, rate, limit), SampleFrame(counter, first, rate, limit, samples.astype(float))


def assert_same(found, expected):
    if not isinstance(expected, SampleFrame):
        assert found == expected
        return
    assert (found.counter, found.first, found.rate) == (expected.counter, expected.first, expected.rate)
    assert found.limit == expected.limit
    step = np.nanmax(np.abs(expected.samples), initial=1e-30) / 32767
    np.testing.assert_allclose(found.samples, expected.samples, rtol=0, atol=0.51 * step)


@given(st.lists(st.one_of(TOUCH, STATUS, SAMPLES), min_size=1, max_size=8), st.data())
def test_frames_come_back_whatever_the_chunks_and_what_is_damaged_or_lost_is_counted(frames, data):
    board, reader = Board(data.draw(WORD, "counter")), FrameReader()
    sent = [written(board, each) for each in [*frames, ("touch", 1, 2, "up", 3, 0.5, 0.5, 0.5)]]
    line, good = bytearray(data.draw(st.binary(max_size=5), "before")), []
    for number, (frame, expected) in enumerate(sent):
        fate = data.draw(st.sampled_from(["whole", "lost", "damaged", "cut"]), "fate")
        if fate == "whole" or number == len(sent) - 1:
            good.append(expected)
        elif fate == "lost":
            continue
        elif fate == "damaged":  # up to 16 bits in a row, which a CRC-16 never misses
            at = data.draw(st.integers(0, len(frame) - 2), "at")
            wrong = data.draw(st.integers(1, 65535), "bits").to_bytes(2, "big")
            frame = frame[:at] + bytes(a ^ b for a, b in zip(frame[at:], wrong, strict=False)) + frame[at + 2 :]
        else:
            at = data.draw(st.integers(0, len(frame) - 1), "at")
            frame = frame[:at] + frame[at + data.draw(st.integers(1, 20), "count") :]
        line += frame
    found, at = [], 0
    while at < len(line):
        size = data.draw(st.integers(1, 200), "chunk")
        found += reader.push(bytes(line[at : at + size]))
        at += size
    assert len(found) == len(good) == reader.counts.frames
    for a, b in zip(found, good, strict=True):
        assert_same(a, b)
    assert reader.counts.restarts == 0
    assert reader.counts.lost == (good[-1].counter - good[0].counter) % 2**32 + 1 - len(good)


def test_with_one_percent_damaged_and_one_percent_lost_no_frame_is_wrong_and_every_loss_counts():
    random, board, reader = np.random.default_rng(4), Board(), FrameReader()
    sent = [board.touch(k, k // 3, ("down", "moved", "up")[k % 3], k % 12 + 1) for k in range(20_000)]
    fate = random.choice(3, len(sent), p=[0.98, 0.01, 0.01])
    fate[[0, -1]] = 0
    line = bytearray()
    for frame, each in zip(sent, fate, strict=True):
        if each == 1:
            length = int(random.integers(1, len(frame)))
            at = int(random.integers(0, len(frame) - length + 1))
            line += frame[:at] + random.bytes(length) + frame[at + length :]
        elif each == 0:
            line += frame
    found = [each for at in range(0, len(line), 997) for each in reader.push(bytes(line[at : at + 997]))]
    whole = np.flatnonzero(fate == 0)
    assert [each.counter for each in found] == whole.tolist()
    assert all(each.touch == each.counter // 3 and each.point == each.counter % 12 + 1 for each in found)
    assert reader.counts.lost == len(sent) - len(whole) > 300
    assert 100 < reader.counts.damaged <= (fate == 1).sum()


@pytest.mark.parametrize("size", [1, 2, 7, 50])
def test_a_whole_line_has_no_damage_wherever_it_is_cut(size):
    line = b"".join(Board().stream(np.random.default_rng(0).normal(size=(2, 8000))))
    reader = FrameReader()
    assert sum(len(reader.push(line[at : at + size])) for at in range(0, len(line), size)) == 532
    assert (reader.counts.lost, reader.counts.damaged) == (0, 0)


def test_the_check_is_that_of_the_catalogues():
    text = b"123456789"
    assert encoder().touch_serial_crc(text, len(text)) == crc_hqx(text, 0xFFFF) == 0x29B1


def test_a_board_that_starts_anew_is_no_loss_and_another_version_is_refused():
    reader = FrameReader()
    frame = Board(1000).status()
    assert len(reader.push(frame + Board().status() + Board(5).status())) == 3
    assert (reader.counts.restarts, reader.counts.lost) == (1, 4)
    other = bytearray(frame)
    other[2] = 2
    other[10:12] = crc_hqx(bytes(other[:10]), 0xFFFF).to_bytes(2, "little")
    with refused(Kind.UNSUITABLE, "serial"):
        reader.push(bytes(other))


@pytest.mark.parametrize("shape", [(17, 1), (2, 129), (1, 256)])
def test_a_frame_holds_no_more_samples_than_it_has_room_for(shape):
    assert Board().samples(0, np.zeros(shape)) == b""

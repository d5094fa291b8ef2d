"""Shards on disk are whole or absent, the same whenever they are made, and never mixed with others."""

import os

import pytest
import torch
from rc_line import rc_line

from localize import TouchGenerator
from localize.signals.finger_stimuli import taps
from localize.signals.shards import ShardError, read_shards, write_shards


def touches(**change):
    settings = {"response": rc_line(3), "seed": 4, "purpose": "training", "microphone_noise": 1e-3, **change}
    return TouchGenerator(**settings)


def content(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_shards_hold_the_samples_of_the_stream_in_their_order(tmp_path):
    done = []
    write_shards(tmp_path, touches(), 25, shard=10, progress=lambda k, n: done.append((k, n)))
    parts = list(read_shards(tmp_path))
    assert [len(part.point) for part in parts] == [10, 10, 5]
    assert done == [(1, 3), (2, 3), (3, 3)]
    whole = touches().samples(0, 25)
    for name in ("signals", "point", "interval"):
        assert torch.allclose(torch.cat([getattr(part, name) for part in parts]), getattr(whole, name), atol=1e-7)


def test_a_missing_shard_is_made_again_alone_and_the_same(tmp_path, monkeypatch):
    write_shards(tmp_path, touches(), 30, shard=10)
    before = content(tmp_path)
    (tmp_path / "shard-000001.safetensors").unlink()
    drawn, samples = [], TouchGenerator.samples
    monkeypatch.setattr(TouchGenerator, "samples", lambda self, *which: drawn.append(which) or samples(self, *which))
    write_shards(tmp_path, touches(), 30, shard=10)
    assert drawn == [(10, 10)]
    assert content(tmp_path) == before


def test_a_stop_while_a_shard_is_written_leaves_whole_ones_only(tmp_path, monkeypatch):
    replace = os.replace

    def stopped(source, target):
        if "shard-000001" in str(target):
            raise KeyboardInterrupt
        replace(source, target)

    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", stopped)
        with pytest.raises(KeyboardInterrupt):
            write_shards(tmp_path, touches(), 30, shard=10)
    (tmp_path / ".shard-000001.99.safetensors").write_bytes(b"half of it")  # as a process that is killed leaves it
    assert {path.name for path in tmp_path.glob("shard-*")} == {"shard-000000.safetensors"}
    with pytest.raises(ShardError, match=r"shard-000001\.safetensors: missing or damaged"):
        list(read_shards(tmp_path))
    write_shards(tmp_path, touches(), 30, shard=10)
    assert len(list(read_shards(tmp_path))) == 3
    assert not list(tmp_path.glob(".*"))


@pytest.mark.parametrize(
    ("change", "name"),
    [
        ({"seed": 5}, "seed"),
        ({"stimuli": taps}, "stimuli"),
        ({"microphone_noise": 0.0}, "microphone_noise"),
        ({"response": rc_line(3, spread=2.0)}, "transfer_functions"),
        ({"method": "stft"}, "method"),
    ],
)
def test_shards_of_other_touches_are_not_mixed(tmp_path, change, name):
    write_shards(tmp_path, touches(), 10)
    before = content(tmp_path)
    with pytest.raises(ShardError, match=rf"touches\.json: holds other touches: their {name} differs"):
        write_shards(tmp_path, touches(**change), 10)
    assert content(tmp_path) == before


@pytest.mark.parametrize(
    ("text", "message"),
    [(None, "cannot be read: No such file"), ("{", "cut short or not JSON"), ("[]", "does not describe touches")],
)
def test_folders_without_a_description_are_refused(tmp_path, text, message):
    if text is not None:
        (tmp_path / "touches.json").write_text(text)
    with pytest.raises(ShardError, match=message):
        list(read_shards(tmp_path))


@pytest.mark.parametrize("change", [{"count": 0}, {"shard": 0}])
def test_numbers_of_samples_are_positive(tmp_path, change):
    with pytest.raises(ValueError, match=r"= 0 must be at least 1"):
        write_shards(tmp_path, touches(), **{"count": 5, **change})

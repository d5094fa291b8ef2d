"""A training that is stopped at any moment goes on to the weights that it would have had."""

import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch
from clocks import ticking
from rc_line import rc_line
from refusals import refused

import localize
from geometry import Kind
from geometry.ground.record import sealed
from localize.learned import epochs
from localize.learned.checkpoint import CheckpointError

PLAN = localize.TrainingPlan(seconds_per_point=24, epochs=4, batch=16, seed=3, microphone_noise=1e-3)


@pytest.fixture(scope="module")
def array():
    return rc_line(4)


@pytest.fixture(scope="module")
def whole(array):
    return localize.train(array, PLAN)


def weights(localizer):
    return localizer.classifier.state_dict()


def same(one, other):
    return all(torch.equal(value, other[name]) for name, value in one.items())


class Stop(Exception):
    """Raised where a process might be killed."""


@pytest.mark.slow
@pytest.mark.parametrize("step", [1, 3, 6, 11])
def test_weights_after_a_stop_within_or_between_epochs_are_those_without(array, whole, tmp_path, monkeypatch, step):
    # A checkpoint at every step; one of them is then never made.
    made = epochs._step

    def failing(*lesson):
        if lesson[-1] == step:
            raise Stop
        return made(*lesson)

    path = tmp_path / "checkpoint.safetensors"
    with monkeypatch.context() as patch:
        patch.setattr(epochs, "_step", failing)
        with pytest.raises(Stop):
            localize.train(array, replace(PLAN, checkpoint_interval=0.0), checkpoint=path)
    again = localize.train(array, PLAN, checkpoint=path)
    assert same(weights(whole), weights(again))
    assert again.training["loss"] == whole.training["loss"]
    assert again.training["held_out_accuracy"] == whole.training["held_out_accuracy"]


def test_a_finished_training_gives_its_result_again_and_reports_its_epochs(array, whole, tmp_path):
    path = tmp_path / "checkpoint.safetensors"
    localize.train(array, PLAN, checkpoint=path)
    reports = []
    again = localize.train(array, PLAN, reports.append, checkpoint=path)
    assert same(weights(whole), weights(again))
    assert [entry.epoch for entry in reports] == [1, 2, 3, 4]


KILLED = """
import sys
import time
sys.path.insert(0, "tests/support")
import localize
from geometry.ground.record import sealed
from localize.learned import epochs
from rc_line import rc_line
def told(progress):
    print(progress.epoch, flush=True)
    if progress.epoch == 9:
        time.sleep(3600)  # until it is killed
plan = localize.TrainingPlan(
    seconds_per_point=24, epochs=10, batch=16, seed=3, microphone_noise=1e-3, checkpoint_interval=0.0
)
localize.train(rc_line(4), plan, told, checkpoint=sys.argv[1])
"""


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="needs a system that kills")
def test_a_killed_process_leaves_a_whole_checkpoint_that_leads_to_the_same_weights(array, tmp_path):
    path, root = tmp_path / "checkpoint.safetensors", Path(__file__).parents[3]
    environment = {**os.environ, "PYTHONPATH": str(root)}
    # Killed anywhere in a step or in the writing of one of the checkpoints, of which there is one after each step.
    for last_epoch, wait in ((2, 0.0), (5, 0.02)):
        with subprocess.Popen(
            [sys.executable, "-c", KILLED, str(path)], cwd=root, env=environment, stdout=subprocess.PIPE, text=True
        ) as process:
            while int(process.stdout.readline()) < last_epoch:
                pass
            time.sleep(wait)
            process.send_signal(signal.SIGKILL)
        assert process.returncode == -signal.SIGKILL
        assert path.exists()
    plan = replace(PLAN, epochs=10)
    resumed, straight = localize.train(array, plan, checkpoint=path), localize.train(array, plan)
    assert same(weights(resumed), weights(straight))
    assert resumed.training["loss"] == straight.training["loss"]
    assert not list(tmp_path.glob(".*"))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"plan": replace(PLAN, epochs=5)}, r"plan\.epochs was 4, is 5"),
        ({"library": rc_line(4, spread=2.0)}, "transfer_function has changed"),
    ],
)
def test_a_checkpoint_of_another_training_is_refused_by_what_differs(array, tmp_path, change, message):
    path = tmp_path / "checkpoint.safetensors"
    localize.train(array, PLAN, checkpoint=path)
    with pytest.raises(CheckpointError, match=f"checkpoint.safetensors: is of another training: {message}"):
        localize.train(**{"library": array, "plan": PLAN, **change}, checkpoint=path)


def cut_short(path):
    path.write_bytes(path.read_bytes()[:-100])


def flipped(path):
    content = bytearray(path.read_bytes())
    content[-1000] ^= 1
    path.write_bytes(content)


def negative(path):
    from safetensors.torch import load, save

    from localize.learned.checkpoint import _content, _metadata

    tensors, said = load(path.read_bytes()), _metadata(path.read_bytes())
    del said["sha256"]
    said["progress"] = json.dumps({**json.loads(said["progress"]), "step": -3})
    path.write_bytes(save(tensors, sealed(said, _content(tensors))))


def foreign(path):
    from safetensors.torch import save_file

    save_file({"x": torch.zeros(2)}, path)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("damage", "kind"),
    [
        (cut_short, Kind.UNREADABLE),
        (lambda path: path.write_text("{}"), Kind.UNREADABLE),
        (flipped, Kind.DAMAGED),
        (negative, Kind.OUT_OF_RANGE),
        (foreign, Kind.MISMATCH),
    ],
)
def test_a_file_that_is_no_checkpoint_is_refused_and_kept(array, tmp_path, damage, kind):
    path = tmp_path / "checkpoint.safetensors"
    localize.train(array, PLAN, checkpoint=path)
    damage(path)
    with refused(kind, error=CheckpointError):
        localize.train(array, PLAN, checkpoint=path)
    assert path.exists()


def test_a_training_that_ended_by_its_limit_of_time_is_not_gone_on_with(array, tmp_path, monkeypatch):
    monkeypatch.setattr(epochs, "perf_counter", ticking(0.01))
    path, plan = tmp_path / "checkpoint.safetensors", replace(PLAN, epochs=5000, time_limit=1.0)
    ended = localize.train(array, plan, checkpoint=path)
    again = localize.train(array, plan, checkpoint=path)
    assert ended.training["cut_short"]
    assert again.training["touches"] == ended.training["touches"]
    assert same(weights(ended), weights(again))


def test_progress_in_the_file_is_json_that_gives_the_numbers_back(array, whole, tmp_path):
    from safetensors import safe_open

    path = tmp_path / "checkpoint.safetensors"
    localize.train(array, PLAN, checkpoint=path)
    with safe_open(path, "pt") as file:
        progress = json.loads(file.metadata()["progress"])
    assert [entry[2] for entry in progress["curve"]] == whole.training["loss"]
    assert progress["step"] == 4 * 6
    assert np.isclose(progress["turned"], 1.0)

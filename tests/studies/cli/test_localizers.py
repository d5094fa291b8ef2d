"""Verbs on a localizer: train and evaluate."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command import Command
from small_run import small_design, small_run

import acoustic_fem
import localize
from localize.signals.stimulus_kinds import STIMULI
from studies.output.sole_writer import sole_writer_of

SEARCH = """
base = "array-2x6"
fidelity = "lumped"
stock = "off"
frequency = "1:100:4"
metrics = ["distance_smallest"]
[vary]
"tube.inner_diameter" = {from = 0.3, to = 0.8}
[optimize]
trials = 2
[[optimize.objectives]]
metric = "distance_smallest"
"""


@pytest.mark.slow
def test_solve_train_and_evaluate_lead_from_a_design_to_a_judged_localizer(
    command: Command, row: Path, tmp_path: Path
) -> None:
    library, model, verdict = tmp_path / "library.nc", tmp_path / "localizer", tmp_path / "verdict"
    told = command("solve", row, "--out", library, "--fidelity", "lumped", "--frequencies", "1:100:100")
    assert (told.code, "3 points, 2 microphones, 100 frequencies" in told.out) == (0, True)
    loaded = acoustic_fem.load(library)
    assert np.array_equal(loaded.frequency, np.arange(1.0, 101.0))
    assert loaded.design == small_design()

    told = command("train", library, "--out", model, "--epochs", 3, "--seed", 5)
    assert told.code == 0, told.err
    assert json.loads((model / "localizer.json").read_text(encoding="utf-8"))["plan"]["seed"] == 5
    curves = (model / "training.csv").read_text(encoding="utf-8").splitlines()
    assert (curves[0], len(curves)) == ("epoch,loss,held_out_accuracy", 4)
    confusion = np.genfromtxt(model / "confusion.csv", delimiter=",", skip_header=1, dtype=int)
    assert confusion[:, 1:].sum(1).tolist() == [50, 50, 50]
    weights = next(model.glob("weights-*.safetensors")).name
    assert {path.name for path in model.iterdir()} == {
        "localizer.json", weights, "training.csv", "training.png", "confusion.csv", "confusion.png"
    }  # fmt: skip

    told = command("evaluate", model, library, "--touches", 50, "--out", verdict)
    assert told.code == 0, told.err
    found = json.loads((verdict / "evaluation.json").read_text(encoding="utf-8"))
    assert found["Bayes decoder"]["multi_sines"]["top1"] > 0.99
    assert found["network"]["top1"] > 0.5  # three short epochs; chance is 0.33
    # A tap and a press of three points on 20 sensors: 50 touches of a point are 1.25 of each.
    assert np.sum(found["network"]["confusion"]) == 120
    assert f"{100 * found['network']['top1']:.1f}" in told.out
    assert told.out.endswith(f"{verdict / 'evaluation.html'}\n{verdict / 'evaluation.json'}\n")


@pytest.mark.slow
def test_a_network_is_trained_on_the_stimuli_that_are_named(command: Command, tmp_path: Path) -> None:
    library, model = small_run().folder / "library.nc", tmp_path / "localizer"
    words = ("--plan", "maps", "--epochs", 2, "--stimuli", "taps", "--stimuli", "friction")
    told = command("train", library, "--out", model, *words)
    assert told.code == 0, told.err
    plan = json.loads((model / "localizer.json").read_text(encoding="utf-8"))["plan"]
    assert plan["stimuli"] == ["taps", "friction"]
    trained, array = localize.load_localizer(model), acoustic_fem.load(library)
    # Two short epochs; chance is 0.33.
    assert localize.evaluate(trained, array, 50, "design", stimuli=STIMULI["friction"]).top1 > 0.5
    told = command("train", library, "--out", tmp_path / "none", "--stimuli", "knocks")
    assert (told.code, "--stimuli" in told.err, (tmp_path / "none").exists()) == (1, True, False)


@pytest.mark.slow
def test_train_goes_on_where_it_was_stopped(command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    library = small_run().folder / "library.nc"
    whole, stopped = tmp_path / "whole", tmp_path / "stopped"
    words = ("--plan", "maps", "--epochs", 3, "--seed", 5)
    assert command("train", library, "--out", whole, *words).code == 0
    train = localize.train

    def interrupted(*arguments: Any, **named: Any) -> None:
        def at_the_second(progress: localize.TrainingProgress) -> None:
            if progress.epoch == 2:
                raise KeyboardInterrupt

        train(arguments[0], arguments[1], at_the_second, **named)

    with monkeypatch.context() as patch:
        patch.setattr(localize, "train", interrupted, raising=False)
        assert command("train", library, "--out", stopped, *words).code != 0
    assert [path.name for path in stopped.iterdir()] == ["checkpoint.safetensors"]
    told = command("train", library, "--out", stopped, "--plan", "maps", "--epochs", 4, "--seed", 5)
    assert (told.code, "plan.epochs was 3, is 4; remove it to train anew" in told.err) == (1, True)
    assert command("train", library, "--out", stopped, *words).code == 0
    told = command("train", library, "--out", whole, *words)
    assert (told.code, "holds a finished localizer; remove it" in told.err) == (1, True)
    # The name of the weights is their checksum.
    assert [path.name for path in whole.glob("weights-*")] == [path.name for path in stopped.glob("weights-*")]


def test_train_has_the_defaults_of_the_plan_and_the_noise_of_the_design(
    command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plans, library = [], small_run().folder / "library.nc"

    def seen(
        library: object, plan: localize.TrainingPlan, progress: object, checkpoint: Path, recordings: Path | None
    ) -> None:
        assert recordings is None
        plans.append(plan)
        raise KeyboardInterrupt

    monkeypatch.setattr(localize, "train", seen, raising=False)
    command("train", library, "--out", tmp_path / "localizer")
    assert plans == [localize.TrainingPlan(microphone_noise="design")]
    command("train", library, "--out", tmp_path / "localizer", "--plan", "paper", "--epochs", 2, "--noise", 0.001)
    assert plans[1:] == [replace(localize.TrainingPlan.paper(), epochs=2, microphone_noise=1e-3)]
    told = command("train", library, "--out", tmp_path / "localizer", "--plan", "best")
    assert (told.code, "--plan = 'best' must be one of: usual, maps, paper" in told.err) == (1, True)
    told = command("train", library, "--out", tmp_path / "localizer", "--plan", "paper", "--kind", "events")
    assert (told.code, "--plan is for localizers" in told.err) == (2, True)


@pytest.mark.slow
def test_evaluate_takes_the_noise_of_the_design_unless_told(
    command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        "studies.evaluation.evaluation_report.render", lambda found: ""
    )  # the numbers are what matters here
    folder, verdict = small_run().folder, tmp_path / "verdict"
    used = []
    for words in ((), ("--noise", "1e-3"), ("--noise", "0")):
        told = command(
            "evaluate", folder / "localizer", folder / "library.nc", "--touches", 5, "--out", verdict, *words
        )
        assert told.code == 0, told.err
        found = json.loads((verdict / "evaluation.json").read_text(encoding="utf-8"))
        names = ("network", "Bayes decoder")
        used.append([(found[name]["microphone_noise"], found[name]["noise_source"]) for name in names])
    rms, source = small_run().network.microphone_noise, small_run().network.noise_source
    assert source.startswith("microphone SPH1878LR5H-C: ")
    assert used == [[(rms, source)] * 2, [(1e-3, "white")] * 2, [(0.0, "white")] * 2]


@pytest.mark.parametrize("verb", ["train", "optimize"])
def test_a_second_writer_of_a_folder_is_refused_at_the_start(command: Command, tmp_path: Path, verb: str) -> None:
    pytest.importorskip("fcntl")
    out, study = tmp_path / "out", tmp_path / "study.toml"
    study.write_text(SEARCH)
    with sole_writer_of(out, verb, ValueError):
        told = command(verb, small_run().folder / "library.nc" if verb == "train" else study, "--out", out)
    name = "search" if verb == "optimize" else verb
    assert (told.code, told.err.splitlines()[-1]) == (1, f"acoustic-fem: {out}: another {name} is writing to it")
    assert not out.exists() or not list(out.iterdir())

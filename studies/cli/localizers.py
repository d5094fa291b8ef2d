"""Verbs on a localizer: train, evaluate."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

import localize
import studies
from geometry.ground.refusal import counted
from localize.learned.training_plan import PLANS, TrainingPlan
from studies.cli.options import LibraryFile, Noise, display_on_stderr, noise_choice
from studies.cli.terminal_tables import show, table_of, tell
from studies.output.call_defaults import HELD_OUT_TOUCHES, SEED

if TYPE_CHECKING:
    from localize import Localizer
    from studies.evaluation.headline import Headline


def train(
    library: LibraryFile,
    out: Annotated[Path, typer.Option(help="Folder to write the network to.")],
    seconds: Annotated[
        float | None,
        typer.Option(
            help="Time limit of the training. If it is reached, the result depends on the speed of the machine. "
            "Default: no limit.",
        ),
    ] = None,
    plan: Annotated[
        str,
        typer.Option(
            help="usual: strokes of fingers and multi-sine touches on 3,000 as-built sensors. "
            "maps: a convolutional network, multi-sine touches in room sound. paper: the paper's network on 14,000 "
            "touches of every point in short windows, no noise; takes hours. The options below override all three."
        ),
    ] = PLANS[0],
    epochs: Annotated[
        int | None, typer.Option(help="Number of epochs. Default: 6, 20 with --plan maps, 30 with --plan paper.")
    ] = None,
    noise: Noise = None,
    seed: Annotated[int, typer.Option(help="Seed of the touches and the network.")] = TrainingPlan.seed,
    network: Annotated[
        str | None,
        typer.Option(
            help="hypotheses compares each touch with many possible as-built sensors. patches, stride-2 and paper are "
            "convolutional, each larger and slower than the one before; two-stage is the paper's network for letters, "
            "small-patches needs fewer epochs for them. Default: hypotheses; patches with --plan maps or --kind, paper "
            "with --plan paper, small-patches with --kind letters."
        ),
    ] = None,
    stimuli: Annotated[
        list[str] | None,
        typer.Option(
            help="Signals of the touches: multi-sines, tap-strokes, press-strokes, slide-strokes, taps, presses, "
            "slides, friction or pulse-wave; repeat it for a mixture. Default: multi-sines and the three strokes."
        ),
    ] = None,
    as_built: Annotated[
        int | None,
        typer.Option(
            help="Number of random as-built sensors that are touched. 0: only the sensor of the library, for a "
            "calibrated one. Default: 3000, 0 with the other plans."
        ),
    ] = None,
    recordings: Annotated[
        Path | None,
        typer.Option(
            metavar="MANIFEST",
            help="Recorded touches of your sensor, which become half of the training data: docs/localizer.md. A fifth "
            "of them is held out to measure the accuracy.",
        ),
    ] = None,
    kind: Annotated[
        str | None,
        typer.Option(
            help="Train a recognizer of events, textures, letters (docs/letters.md) or labels, which are those of the "
            "recordings (docs/kinds.md). Default: a localizer of points."
        ),
    ] = None,
) -> None:
    """Train a network that locates touches, or one that recognizes kinds of touch.

    Touches are simulated through the library; add recorded ones with --recordings. With --kind the network recognizes
    kinds of touch in place of points.

    Writes the network, training.csv and confusion.csv, and a picture of each. If training is killed, start it again: it
    continues from checkpoint.safetensors and ends with identical weights.

    Example: [bold]acoustic-fem train library.nc --out localizer --epochs 10[/bold]
    """
    if kind is not None:
        localizer_options = {
            "--stimuli": bool(stimuli),
            "--plan": plan != PLANS[0],
            "--as-built": as_built is not None,
        }
        _train_kinds(library, out, kind, seconds, epochs, noise, seed, network, recordings, localizer_options)
        return
    base = TrainingPlan.of(plan)
    chosen = replace(
        base,
        time_limit=seconds,
        epochs=base.epochs if epochs is None else epochs,
        microphone_noise=base.microphone_noise if noise is None else noise_choice(noise),
        seed=seed,
        network=network or base.network,
        stimuli=tuple(stimuli) if stimuli else base.stimuli,
        as_built=base.as_built if as_built is None else as_built,
    )
    with display_on_stderr() as display:
        localizer = studies.train_localizer(library, out, plan=chosen, recordings=recordings, display=display).localizer
    accuracy = localizer.training["held_out_accuracy"][-1]
    short = f", cut short by --seconds {seconds:g}" if localizer.training["cut_short"] else ""
    _show_recorded(localizer)
    tell(
        f"{out}: {counted(localizer.training['epochs'], 'epoch')}{short}, {accuracy:.1%} of held-out touches "
        f"({', '.join(chosen.stimuli)} on {_sensors(localizer)}{_room(localizer)}) classified correctly"
    )


def _sensors(localizer: Localizer) -> str:
    """The sensors that the touches were on, in words."""
    count = localizer.training["sensors"]
    return "the sensor of the library" if count == 1 else "as-built sensors"


def _room(localizer: Localizer) -> str:
    """The sound in which the touches were, in words."""
    levels = localizer.training.get("ambient")
    return f", in sound of {levels[0]:g} to {levels[1]:g} dB SPL" if levels else ""


def _train_kinds(
    library: Path,
    out: Path,
    kind: str,
    seconds: float | None,
    epochs: int | None,
    noise: str | None,
    seed: int,
    network: str | None,
    recordings: Path | None,
    localizer_options: dict[str, bool],
) -> None:
    """A recognizer in place of a localizer; the options of localizers alone, and whether they were given."""
    for option, is_given in localizer_options.items():
        if is_given:
            raise typer.BadParameter(f"{option} is for localizers and cannot be given with --kind")
    usual = localize.RecognitionPlan.of(kind)
    plan = replace(
        usual,
        epochs=usual.epochs if epochs is None else epochs,
        microphone_noise=noise_choice(noise),
        seed=seed,
        time_limit=seconds,
        network=network or usual.network,
    )
    with display_on_stderr() as display:
        recognizer = studies.train_kinds(library, out, kind, plan=plan, recordings=recordings, display=display)
    record = recognizer.training
    # A long touch makes several windows.
    cut = "letters" if kind == "letters" else "windows"
    simulated = "held-out simulated takes on the sensor of the library"
    judged = simulated if recordings is None else f"{cut} of held-out recordings"
    tell(
        f"{out}: {counted(len(recognizer.labels), 'kind')}, {counted(record['epochs'], 'epoch')}, "
        f"{record['held_out_accuracy'][-1]:.1%} of {record['held_out_takes']} {judged} classified correctly"
    )


def evaluate(
    model: Annotated[
        Path, typer.Argument(metavar="MODEL", help="Trained localizer, a folder from train or run, or an .onnx file.")
    ],
    library: LibraryFile,
    touches: Annotated[
        int,
        typer.Option(
            help="Number of held-out taps and presses of every point, on all as-built sensors together, but at least "
            "one tap and one press on each of 20 sensors."
        ),
    ] = HELD_OUT_TOUCHES,
    noise: Noise = None,
    seed: Annotated[int, typer.Option(min=0, help="Seed of the touches.")] = SEED,
    out: Annotated[
        Path | None,
        typer.Option(
            help="Folder for evaluation.json and evaluation.html, which add other noise, room sound, kinds and lengths "
            "of touches, as-built sensors and virtual rigs."
        ),
    ] = None,
) -> None:
    """Measure how accurately a trained network locates touches it was not trained on.

    Prints the accuracy of the network and, for comparison, of decoders of the library that need no training. The first
    line of each is for taps and presses on as-built sensors. The lines below it are for taps, presses, virtual rigs,
    the nominal sensor and multi-sine touches.

    Example: [bold]acoustic-fem evaluate localizer library.nc --out evaluation[/bold]
    """
    level = noise_choice(noise)
    with display_on_stderr() as display:
        results = studies.evaluate_localizer(
            model, library, out, touches=touches, microphone_noise=level, seed=seed, display=display
        )
    _show_evaluations(results)
    if out is not None:
        from studies.evaluation.evaluation_report import FILES

        for name in FILES:
            tell(str(out / name))


def _show_evaluations(results: dict[str, Headline]) -> None:
    """Print the headline of each localizer, and below it the figures for other touches and sensors."""
    table = table_of("localizer, and touches", "top-1 (%)", "top-2 (%)", "within one place (%)",
                     "calibration error (%)", numbers=(1, 2, 3, 4))  # fmt: skip

    def row(touches: str, shares: tuple[float, ...], remark: str) -> None:
        table.add_row(f"  {touches}" + f"\n    {remark}" * bool(remark), *(f"{100 * share:.1f}" for share in shares))

    for title, result in results.items():
        table.add_row(title, *4 * [""])
        pair = result.hardest_pair
        remarks = [_worst_in_words(result.worst)]
        remarks += [] if pair is None else [f"most confused: {pair[0]} and {pair[1]}, {100 * pair[2]:.1f} %"]
        shares = (result.top1, result.top2, result.within_one, result.reliability.expected_error)
        row(result.signals, shares, "\n    ".join(filter(None, remarks)))
        for name, each in result.beside:
            shares = (each.top1, each.top2, each.within_one, each.expected_calibration_error)
            row(name, shares, _worst_in_words(each.worst))
    show(table)
    unscattered = next(iter(results.values())).unscattered
    if unscattered:
        tell(f"as-built sensors are left out: {unscattered}")


def _worst_in_words(worst: float | None) -> str:
    """Accuracy on the worst of several sensors, for a remark; empty for one sensor."""
    return "" if worst is None else f"the worst sensor: {100 * worst:.1f} % correct"


def _show_recorded(localizer: Localizer) -> None:
    """Print the accuracy on held-out recordings, by part, if there are any."""
    if "held_out_recordings" not in localizer.training:
        return
    table = table_of("recorded", "held-out recordings", "frames", "classified correctly (%)", numbers=(1, 2, 3))
    for part, found in localizer.training["held_out_recordings"].items():
        table.add_row(part, str(found["recordings"]), str(found["frames"]), f"{100 * found['top1']:.1f}")
    show(table)

"""Verbs on a localizer: train, evaluate."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from geometry.ground.refusal import counted
from localize.learned.training_plan import PLANS, TrainingPlan
from localize.recognition.recognition_plan import RecognitionPlan
from studies.cli.options import LibraryFile, Noise, defaults_of, display_on_stderr, noise_choice
from studies.cli.terminal_tables import show, table_of, tell
from studies.evaluation.localizer_evaluation import evaluate_localizer
from studies.evaluation.localizer_training import train_kinds, train_localizer

if TYPE_CHECKING:
    from localize import Localizer
    from studies.evaluation.headline import Headline

_EVALUATION = defaults_of(evaluate_localizer)


def train(
    library: LibraryFile,
    out: Annotated[Path, typer.Option(help="The folder to write the localizer to.", show_default=False)],
    seconds: Annotated[
        float | None,
        typer.Option(
            help="Cut training short where it would take longer; the result then depends on the machine.",
            show_default="no limit",
        ),
    ] = None,
    plan: Annotated[
        str,
        typer.Option(
            help="usual: new touches in every epoch, 200 of every point, in sound of 30 to 95 dB SPL. paper: 14,000 "
            "touches of every point by short windows, the paper's network, no noise: hours. The options below change "
            "either."
        ),
    ] = PLANS[0],
    epochs: Annotated[int | None, typer.Option(help="How many epochs.", show_default="20; paper: 30")] = None,
    noise: Noise = None,
    seed: Annotated[int, typer.Option(help="Of the touches and the network.")] = TrainingPlan.seed,
    network: Annotated[
        str | None,
        typer.Option(
            help="patches, stride-2, or paper: ever larger and slower; two-stage, the paper's of letters.",
            show_default="patches; --plan paper: paper; --kind letters: two-stage",
        ),
    ] = None,
    stimuli: Annotated[
        list[str] | None,
        typer.Option(
            help="What touches are made of: multi-sines, taps, friction or pulse-wave; again for a mixture. A network "
            "names only what it was trained on.",
            show_default="multi-sines",
        ),
    ] = None,
    recordings: Annotated[
        Path | None,
        typer.Option(
            metavar="MANIFEST",
            help="Recorded touches of the made sensor, half of all that is trained on: docs/localizer.md. A fifth of "
            "the recordings is held out and judged.",
            show_default=False,
        ),
    ] = None,
    kind: Annotated[
        str | None,
        typer.Option(
            help="Tell kinds of touch instead of points: events, textures, letters (docs/letters.md), or labels, "
            "those of the recordings: docs/kinds.md.",
            show_default="points",
        ),
    ] = None,
) -> None:
    """Train a localizer on touches made from a library, and on recorded ones where there are some.

    With --kind it is a recognizer, which tells what a touch is instead of where.

    Killed and started again it goes on where it was, to the same weights: its state is kept in checkpoint.safetensors
    until it is done. Beside the localizer come training.csv and confusion.csv, and a picture of each.

    Example: [bold]acoustic-fem train library.nc --out localizer --epochs 10[/bold]
    """
    if kind is not None:
        of_localizers = {"--stimuli": bool(stimuli), "--plan": plan != PLANS[0]}
        _train_kinds(library, out, kind, seconds, epochs, noise, seed, network, recordings, of_localizers)
        return
    base = TrainingPlan.of(plan)
    chosen = replace(
        base,
        time_limit=seconds,
        epochs=base.epochs if epochs is None else epochs,
        microphone_noise=base.microphone_noise if noise is None else noise,
        seed=seed,
        network=network or base.network,
        stimuli=tuple(stimuli) if stimuli else base.stimuli,
    )
    with display_on_stderr() as display:
        localizer = train_localizer(library, out, plan=chosen, recordings=recordings, display=display).localizer
    accuracy = localizer.training["held_out_accuracy"][-1]
    short = f", cut short by --seconds {seconds:g}" if localizer.training["cut_short"] else ""
    _show_recorded(localizer)
    tell(
        f"{out}: {counted(localizer.training['epochs'], 'epoch')}{short}, {accuracy:.1%} of held-out touches "
        f"({', '.join(chosen.stimuli)} on the sensor of the library{_room(localizer)}) classified correctly"
    )


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
    noise: float | None,
    seed: int,
    network: str | None,
    recordings: Path | None,
    of_localizers: dict[str, bool],
) -> None:
    """A recognizer in place of a localizer; the options of localizers alone, and whether they were given."""
    for option, is_given in of_localizers.items():
        if is_given:
            raise typer.BadParameter(f"{option} is of localizers; with --kind it says nothing")
    usual = RecognitionPlan.of(kind)
    plan = replace(
        usual,
        epochs=TrainingPlan.epochs if epochs is None else epochs,
        microphone_noise=noise_choice(noise),
        seed=seed,
        time_limit=seconds,
        network=network or usual.network,
    )
    with display_on_stderr() as display:
        recognizer = train_kinds(library, out, kind, plan=plan, recordings=recordings, display=display)
    record = recognizer.training
    # A long touch makes several windows.
    cut = "letters" if kind == "letters" else "windows"
    simulated = "held-out simulated takes on the sensor of the library"
    judged = simulated if recordings is None else f"{cut} of held-out recordings"
    tell(
        f"{out}: {counted(len(recognizer.labels), 'kind')}, {counted(record['epochs'], 'epoch')}, "
        f"{record['held_out_accuracy'][-1]:.1%} of {record['held_out_takes']} {judged} told right"
    )


def evaluate(
    model: Annotated[
        Path,
        typer.Argument(
            metavar="MODEL",
            help="A localizer, from train or run (a folder), or an .onnx file.",
            show_default=False,
        ),
    ],
    library: LibraryFile,
    touches: Annotated[int, typer.Option(help="Held-out touches of every point.")] = _EVALUATION["touches"],
    noise: Noise = None,
    seed: Annotated[int, typer.Option(min=0, help="Of the touches.")] = _EVALUATION["seed"],
    out: Annotated[
        Path | None,
        typer.Option(
            help="A folder for evaluation.json and evaluation.html: also under other noise, ambient sound, touches, "
            "lengths, on as-built sensors and virtual rigs.",
            show_default=False,
        ),
    ] = None,
) -> None:
    """How often a localizer names the touched point, on touches it has never heard; the Bayes decoder beside it.

    The first line of each localizer is for multi-sine touches on the nominal sensor. The lines below are for taps on
    it, and for multi-sine touches on sensors with manufacturing scatter.

    Example: [bold]acoustic-fem evaluate localizer library.nc --out judged[/bold]
    """
    level = noise_choice(noise)
    with display_on_stderr() as display:
        results = evaluate_localizer(model, library, out, touches=touches, noise=level, seed=seed, display=display)
    _show_evaluations(results)
    if out is not None:
        from studies.evaluation.evaluation_report import FILES

        for name in FILES:
            tell(str(out / name))


def _show_evaluations(results: dict[str, Headline]) -> None:
    """A line for the headline of each localizer, and below it one for each of what stands beside it."""
    table = table_of("localizer, and touches", "top-1 (%)", "top-2 (%)", "within one place (%)",
                     "calibration error (%)", numbers=(1, 2, 3, 4))  # fmt: skip

    def row(touches: str, shares: tuple[float, ...], remark: str) -> None:
        table.add_row(f"  {touches}" + f"\n    {remark}" * bool(remark), *(f"{100 * share:.1f}" for share in shares))

    for title, result in results.items():
        table.add_row(title, *4 * [""])
        pair = result.hardest_pair
        confused = "" if pair is None else f"most confused: {pair[0]} and {pair[1]}, {100 * pair[2]:.1f} %"
        row(result.signals, (result.top1, result.top2, result.within_one, result.reliability.expected_error), confused)
        for name, each in result.beside:
            worst = "" if each.worst is None else f"the worst sensor: {100 * each.worst:.1f} % right"
            row(name, (each.top1, each.top2, each.within_one, each.expected_calibration_error), worst)
    show(table)
    unscattered = next(iter(results.values())).unscattered
    if unscattered:
        tell(f"as-built sensors are left out: {unscattered}")


def _show_recorded(localizer: Localizer) -> None:
    """How held-out recordings were named, by part, where there are any."""
    if "held_out_recordings" not in localizer.training:
        return
    table = table_of("recorded", "held-out recordings", "frames", "classified correctly (%)", numbers=(1, 2, 3))
    for part, found in localizer.training["held_out_recordings"].items():
        table.add_row(part, str(found["recordings"]), str(found["frames"]), f"{100 * found['top1']:.1f}")
    show(table)

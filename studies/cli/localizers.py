"""Verbs on a localizer: train, evaluate."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from geometry.refusal import Refusal
from studies.cli.options import LibraryFile, Noise, display_on_stderr, named, noise_choice
from studies.cli.tables import show, table_of

if TYPE_CHECKING:
    from localize import Evaluation
    from localize.evaluation.accuracy import Locator

#: White noise that the Bayes decoder assumes where touches have less, Pa rms.
LEAST_NOISE = 1e-6


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
    epochs: Annotated[int, typer.Option(help="How many epochs, of 200 touches of every point.")] = 20,
    noise: Noise = None,
    seed: Annotated[int, typer.Option(help="Of the touches and the network.")] = 0,
    network: Annotated[str, typer.Option(help="patches, stride-2, or paper: ever larger and slower.")] = "patches",
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
) -> None:
    """Train a localizer on touches made from a library, and on recorded ones where there are some.

    Killed and started again it goes on where it was, to the same weights: its state is kept in checkpoint.safetensors
    until it is done. Beside the localizer come training.csv and confusion.csv, and a picture of each.

    Example: [bold]acoustic-fem train library.nc --out localizer --epochs 10[/bold]
    """
    import acoustic_fem
    from studies.output.folders import check_folder

    check_folder(out)
    from localize import TrainingPlan, evaluate as evaluate_localizer, train as train_localizer
    from localize.signals.array_response import response_of
    from studies.judging.training_files import TOUCHES, write_training_files

    with named(
        time_limit="--seconds",
        epochs="--epochs",
        microphone_noise="--noise",
        seed="--seed",
        network="--network",
        stimuli="--stimuli",
    ):
        plan = TrainingPlan(
            time_limit=seconds,
            epochs=epochs,
            microphone_noise=noise_choice(noise),
            seed=seed,
            network=network,
            stimuli=tuple(stimuli) if stimuli else TrainingPlan.stimuli,
        )
    loaded = response_of(acoustic_fem.load(library))
    out.mkdir(parents=True, exist_ok=True)
    checkpoint = out / "checkpoint.safetensors"
    if (out / "localizer.json").exists() and not checkpoint.exists():
        raise Refusal(f"{out}: holds a finished localizer; remove it, or choose another folder")
    with display_on_stderr() as display, display.stage("Localizer") as report:
        report("training", 0.0)
        localizer = train_localizer(
            loaded,
            plan,
            lambda p: report(f"epoch {p.epoch} of {p.epochs}: {p.accuracy:.1%}", p.epoch / p.epochs),
            checkpoint=checkpoint,
            recordings=recordings,
        )
        localizer.save(out)
        judged = evaluate_localizer(localizer, loaded, TOUCHES, plan.microphone_noise, seed=seed)
        write_training_files(out, localizer, judged)
        checkpoint.unlink()
    accuracy = localizer.training["held_out_accuracy"][-1]
    short = f", cut short by --seconds {seconds:g}" if localizer.training["cut_short"] else ""
    if recordings is not None:
        table = table_of("recorded", "held-out recordings", "frames", "named right (%)", numbers=(1, 2, 3))
        for part, found in localizer.training["held_out_recordings"].items():
            table.add_row(part, str(found["recordings"]), str(found["frames"]), f"{100 * found['right']:.1f}")
        show(table)
    print(f"{out}: {localizer.training['epochs']} epochs{short}, {accuracy:.1%} of held-out touches named right")


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
    touches: Annotated[int, typer.Option(help="Held-out touches of every point.")] = 200,
    noise: Noise = None,
    seed: Annotated[int, typer.Option(min=0, help="Of the touches.")] = 0,
    out: Annotated[
        Path | None,
        typer.Option(
            help="A folder for evaluation.json and evaluation.html: also under other noise, ambient sound, touches, "
            "lengths, and on mis-made sensors.",
            show_default=False,
        ),
    ] = None,
) -> None:
    """How often a localizer names the touched point, on touches it has never heard; the Bayes decoder beside it.

    Example: [bold]acoustic-fem evaluate localizer library.nc --out judged[/bold]
    """
    import acoustic_fem
    from studies.output.folders import check_folder

    if out is not None:
        check_folder(out)
    from localize import BayesDecoder, OnnxLocalizer, evaluate as evaluate_localizer, load_localizer
    from localize.evaluation.accuracy import check_evaluation
    from localize.signals.array_response import response_of

    localizer = OnnxLocalizer(model) if model.suffix == ".onnx" else load_localizer(model)
    solved = acoustic_fem.load(library)
    loaded = response_of(solved)
    level = noise_choice(noise)
    with named(touches_per_point="--touches", microphone_noise="--noise"):
        check_evaluation(localizer, loaded, touches, level)
        decoder = BayesDecoder(loaded, level if level == "design" else max(level, LEAST_NOISE))
    name = localizer.kind if isinstance(localizer, OnnxLocalizer) else "network"
    locators: dict[str, Locator] = {name: localizer, "Bayes decoder": decoder}
    results: dict[str, Evaluation] = {}
    with display_on_stderr() as display, display.stage("Evaluation") as report:
        if out is None:
            for number, (title, locator) in enumerate(locators.items()):
                report(title, number / len(locators))
                results[title] = evaluate_localizer(locator, loaded, touches, level, seed=seed)
        else:
            from studies.judging.full_evaluation import evaluate_fully
            from studies.judging.report import write_evaluation

            found = evaluate_fully(locators, solved, loaded, touches, level, seed, report)
            results = {each.name: each.overall for each in found.judged}
            report("report", 1.0)
            write_evaluation(found, out)
    table = table_of("", "top-1 (%)", "top-2 (%)", "within one place (%)", "calibration error (%)", "most confused",
                     numbers=(1, 2, 3, 4))  # fmt: skip
    for title, result in results.items():
        pair = result.hardest_pair
        confused = "none" if pair is None else f"points {pair[0]} and {pair[1]}, {100 * pair[2]:.1f} %"
        wanted = (result.top1, result.top2, result.within_one, result.reliability.expected_error)
        table.add_row(title, *(f"{100 * share:.1f}" for share in wanted), confused)
    show(table)

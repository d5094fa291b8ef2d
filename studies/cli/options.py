"""What the verbs of the command line share: arguments, options and their readers."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeVar

import typer

from studies.output.display import Display

if TYPE_CHECKING:
    from localize.signals.noise_model import NoiseChoice

Answer = TypeVar("Answer", str, int, float)

Design = Annotated[
    str, typer.Argument(metavar="DESIGN", help="A design file, or the name of a prototype.", show_default=False)
]
LibraryFile = Annotated[
    Path,
    typer.Argument(
        metavar="LIBRARY", help="A library, from solve, run or convert: .nc, .sofa, .npz or .csv.", show_default=False
    ),
]
Noise = Annotated[
    float | None,
    typer.Option(
        help="White noise of the microphones instead, Pa rms over 0 to 500 Hz.",
        show_default="that of the design's microphone",
    ),
]
Frequencies = Annotated[str, typer.Option(metavar="FIRST:LAST:COUNT", help="Frequencies in Hz, evenly spaced.")]
Tolerances = Annotated[
    Path | None,
    typer.Option(help="Scatter of your workshop, TOML: docs/tolerances.md.", show_default="assumed ones"),
]
WorkerCount = Annotated[
    int | None,
    typer.Option(help="Processes on this machine; 1 computes in this one.", show_default="one per core"),
]
Scheduler = Annotated[
    str | None,
    typer.Option(metavar="tcp://HOST:PORT", help="A dask scheduler, whose workers are used.", show_default=False),
]


Pressure = Annotated[
    float | None,
    typer.Option(metavar="PA", help="Air pressure there, not reduced to sea level, Pa.", show_default="the design's"),
]
Altitude = Annotated[
    float | None,
    typer.Option(metavar="M", help="Or height above the sea, m: the standard atmosphere's.", show_default=False),
]
Temperature = Annotated[
    float | None,
    typer.Option("--temperature", metavar="DEGC", help="Temperature of the air there.", show_default="the design's"),
]
Model = Annotated[
    Path,
    typer.Argument(
        metavar="MODEL",
        help="A trained localizer (a folder), an .onnx file, or a library for the model-based decoder, which "
        "expects the tolerances of manufacturing unless the library is a calibrated one.",
        show_default=False,
    ),
]
Recording = Annotated[
    Path,
    typer.Argument(
        metavar="RECORDING",
        help="WAV with a channel per microphone; CSV with their names on top; NPZ or MAT with 'signals'.",
        show_default=False,
    ),
]
FullScale = Annotated[
    float | None,
    typer.Option(
        help="Pa: of WAV files the pressure at full scale, of others that at which they clip.",
        show_default="1 Pa; flat tops",
    ),
]


def noise_choice(given: float | None) -> NoiseChoice:
    """Noise of the microphones by an option that may be left out: then the noise of the design's microphone."""
    return "design" if given is None else given


def display_on_stderr() -> Display:
    """Progress for the user; what a verb finds goes to stdout."""
    return Display(sys.stderr)


def asked(given: Answer | None, question: str, usual: Answer) -> Answer | None:
    """What an option says; without it the answer to a question on a terminal, elsewhere nothing."""
    if given is not None or not sys.stdin.isatty():
        return given
    answer: Answer = typer.prompt(question, default=usual, type=type(usual))
    return answer


def check_workers(workers: int | None, scheduler: str | None) -> None:
    """Refuse ``--workers`` and ``--scheduler`` that do not go together."""
    if scheduler is not None and workers is not None:
        raise typer.BadParameter("--workers must not be given beside --scheduler, which has its own")
    if workers is not None and not 1 <= workers <= 1024:
        raise typer.BadParameter(f"--workers {workers} must be between 1 and 1024")


def defaults_of(call: Callable[..., Any]) -> dict[str, Any]:
    """The defaults of a call by argument: those of a verb are its call's, and stand there alone."""
    parameters = inspect.signature(call).parameters.values()
    return {each.name: each.default for each in parameters if each.default is not each.empty}

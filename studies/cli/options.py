"""Arguments and options that several verbs of the command line share, and their readers."""

from __future__ import annotations

import inspect
import os
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeVar

import typer

import studies
from acoustic_fem.quantities.microphone_signals import Output
from geometry.ground.argument_checks import whole_number
from geometry.stock import VARIABLE
from studies.output.display import Display

if TYPE_CHECKING:
    from localize.recordings.accelerometer import AccelerationFile
    from localize.signals.noise_model import NoiseChoice

Answer = TypeVar("Answer", str, int, float)

Design = Annotated[str, typer.Argument(metavar="DESIGN", help="Design file, or the name of a prototype.")]
LibraryFile = Annotated[
    Path,
    typer.Argument(metavar="LIBRARY", help="Library of solve, run or calibrate: .nc, .sofa, .npz, .mat, .csv."),
]
Noise = Annotated[
    str | None,
    typer.Option(
        metavar="PA",
        help="White noise of the microphones, Pa rms over 0 to 500 Hz. Default: design, that of its microphone.",
    ),
]
Frequencies = Annotated[
    str,
    typer.Option(
        metavar="GRID",
        help="Frequencies in Hz: FIRST:LAST:COUNT, evenly spaced; log:FIRST:LAST:COUNT, of a constant ratio; "
        "or a .txt or .csv file that lists them, below at most one heading.",
    ),
]
Tolerances = Annotated[
    Path | None,
    typer.Option(help="TOML file of your workshop's tolerances: docs/tolerances.md. Default: assumed ones."),
]
WorkerCount = Annotated[
    int | None,
    typer.Option(help="Number of worker processes on this machine; 1 starts none. Default: one per core."),
]
Scheduler = Annotated[
    str | None, typer.Option(metavar="tcp://HOST:PORT", help="Dask scheduler whose workers are used.")
]


Pressure = Annotated[
    float | None,
    typer.Option(metavar="PA", help="Air pressure of the place, Pa, not reduced to sea level. Default: the design's."),
]
Altitude = Annotated[float | None, typer.Option(metavar="M", help="Height above the sea, m, in place of --pressure.")]
Temperature = Annotated[
    float | None,
    typer.Option(
        "--temperature", metavar="DEGC", help="Temperature of the air, degrees Celsius. Default: the design's."
    ),
]
Model = Annotated[
    Path,
    typer.Argument(
        metavar="MODEL",
        help="A library, the folder of a trained localizer, or an .onnx file. With a library its Bayes decoder is "
        "used, which is tolerance-aware unless the library is calibrated.",
    ),
]
Recording = Annotated[
    Path,
    typer.Argument(
        metavar="RECORDING",
        help="WAV, FLAC or AIFF with a channel per microphone, CSV with the microphones' names in the first line, "
        "NPZ or MAT with 'signals'.",
    ),
]
FullScale = Annotated[
    float | None,
    typer.Option(
        help="Pressure at full scale of WAV files, Pa. For other files, the pressure at which the recorder clipped. "
        "Default: 1 Pa for WAV files; in other files, clipping is detected by its flat tops.",
    ),
]
MicrophoneOutput = Annotated[
    Output,
    typer.Option(
        help="Content of the recording: pressures in front of the microphones, or voltages, the outputs of "
        "microphones that nobody has equalised."
    ),
]
Lowest = Annotated[
    float | None,
    typer.Option(
        metavar="HZ",
        help="Frequency down to which voltages are equalised to pressures, Hz, 0.1 to 20. Default: 1, and 0.2 for a "
        "pulse.",
    ),
]
Channels = Annotated[
    str | None,
    typer.Option(
        metavar="A=2,B=1",
        help="Channel of each microphone in the recording, counted from 1. Default: by their names, or in the order of "
        "the design.",
    ),
]
AccelerationPath = Annotated[
    Path | None,
    typer.Option(
        "--acceleration",
        metavar="FILE",
        help="Recording of an accelerometer on the housing. The pressures of this motion are subtracted from the "
        "signals. Its channels are x_m_per_s2, y_m_per_s2 and z_m_per_s2, without gravity, sampled with the "
        "microphones. It may be RECORDING itself. Needs a library. Default: the sensor lies still.",
    ),
]
AccelerationFullScale = Annotated[
    float | None,
    typer.Option(metavar="M/S2", help="Acceleration at full scale of a WAV, FLAC or AIFF file of --acceleration."),
]
AccelerationChannels = Annotated[
    str | None,
    typer.Option(
        metavar="X=3,Z=5",
        help="Channel of each axis in a file of --acceleration without names of channels, counted from 1. Default: "
        "three channels are x, y and z.",
    ),
]
DecoderNoise = Annotated[
    str | None,
    typer.Option(
        metavar="PA",
        help="White noise of the microphones that the decoder of a library assumes, Pa rms over 0 to 500 Hz. Default: "
        "design, that of the design's microphone.",
    ),
]
DecoderAmbient = Annotated[
    float | None,
    typer.Option(
        metavar="DB",
        help="Loudest room sound in which touches must be located, dB SPL; slower. Sound without a touch is detected "
        "in any case. Default: a quiet room.",
        min=0,
        max=140,
    ),
]
ArrayLibrary = Annotated[
    Path | None,
    typer.Option(
        help="Library of the array. It is needed to detect room sound, and for --waveform, --ambient and --reject. "
        "Default: MODEL, if it is a library.",
    ),
]
RejectedFraction = Annotated[
    float | None,
    typer.Option(
        metavar="FRACTION",
        help="Report as 'other' the frames that no single point explains. The value is the fraction of true touches "
        "that may be rejected, such as 1e-6. For a calibrated sensor. Default: the likeliest point is reported.",
    ),
]
TwoTouches = Annotated[
    bool,
    typer.Option(
        "--two-touches",
        help="Search each contact for two taps or presses at once, such as of two fingers; needs a library.",
    ),
]
Motion = Annotated[
    float | None,
    typer.Option(
        metavar="M/S2",
        help="Largest acceleration of a sensor that is worn or carried, without gravity, such as 5 for a waved hand; "
        "needs a library. Motion without a touch is then reported as such; slow touches may be taken for it. Default: "
        "the sensor lies still.",
    ),
]
FollowDrift = Annotated[
    bool,
    typer.Option(
        "--follow-drift",
        help="Follow slow changes of the sensor's stiffness, such as ageing rubber or other air. For a calibrated "
        "library.",
    ),
]
OwnStock = Annotated[
    Path | None,
    typer.Option(
        "--stock",
        metavar="PATH",
        help="File or folder of parts that you can get, beside those of the program: docs/stock.md. Default: what "
        "ACOUSTIC_FEM_STOCK names, else stock.toml beside the design or the study.",
    ),
]


@contextmanager
def own_stock(given: Mapping[str, Any]) -> Iterator[None]:
    """Parts of the user's own for one verb, by its arguments; the environment is then as before."""
    before = os.environ.get(VARIABLE)
    places = [given[name] for name in ("design", "study") if isinstance(given.get(name), str)]
    beside = [
        path for place in places if (path := Path(place).parent / "stock.toml").is_file() and Path(place).is_file()
    ]
    chosen = given.get("own") or (beside[0] if beside and not before else None)
    if chosen is not None:
        os.environ[VARIABLE] = str(chosen)
    try:
        yield
    finally:
        if before is None:
            os.environ.pop(VARIABLE, None)
        else:
            os.environ[VARIABLE] = before


def channel_map(text: str | None, option: str = "--channels", what: str = "microphone") -> dict[str, int] | None:
    """``A=1,B=2`` as microphone -> channel, or axis -> channel; None for None."""
    if text is None:
        return None
    pairs = [part.partition("=") for part in text.split(",")]
    for name, equals, value in pairs:
        if not (name.strip() and equals and whole_number(value.strip()) >= 1):
            raise typer.BadParameter(f"{option} {text} must be like A=1,B=2: {what} and channel from 1")
    names = [name.strip() for name, _, _ in pairs]
    if len(set(names)) < len(names):
        raise typer.BadParameter(f"{option} {text} must give each {what} once")
    return {name: whole_number(value.strip()) for name, (_, _, value) in zip(names, pairs, strict=True)}


def acceleration_file(path: Path | None, full_scale: float | None, channels: str | None) -> AccelerationFile | None:
    """File of an accelerometer by its three options; None without one."""
    for name, given in (("--acceleration-full-scale", full_scale), ("--acceleration-channels", channels)):
        if path is None and given is not None:
            raise typer.BadParameter(f"{name} needs --acceleration")
    if path is None:
        return None
    axes = channel_map(None if channels is None else channels.lower(), "--acceleration-channels", "axis")
    return studies.AccelerationFile(path, full_scale, axes)


def noise_choice(given: str | None) -> NoiseChoice:
    """Noise of the microphones from an option; without it, the noise of the design's microphone."""
    if given is None or given == "design":
        return "design"
    try:
        return float(given)
    except ValueError:
        raise typer.BadParameter(f"--noise = {given!r} must be a number or design") from None


def display_on_stderr() -> Display:
    """Progress for the user on stderr, because results go to stdout."""
    return Display(sys.stderr)


def asked(given: Answer | None, question: str, usual: Answer) -> Answer | None:
    """Value of an option; without it the answer to a question on a terminal, elsewhere nothing."""
    if given is not None or not sys.stdin.isatty():
        return given
    answer: Answer = typer.prompt(question, default=usual, type=type(usual))
    return answer


def check_workers(workers: int | None, scheduler: str | None) -> None:
    """Refuse ``--workers`` and ``--scheduler`` that do not go together."""
    if scheduler is not None and workers is not None:
        raise typer.BadParameter("--workers cannot be given with --scheduler, which has workers of its own")
    if workers is not None and not 1 <= workers <= 1024:
        raise typer.BadParameter(f"--workers {workers} must be between 1 and 1024")


def defaults_of(call: Callable[..., Any]) -> dict[str, Any]:
    """Defaults of a call by argument, so that a verb repeats none of them."""
    parameters = inspect.signature(call).parameters.values()
    return {each.name: each.default for each in parameters if each.default is not each.empty}

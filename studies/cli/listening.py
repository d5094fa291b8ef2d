"""From the options of a command to what listens: a localizer of any kind, and a stream with all it shall tell."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from geometry.refusal import Refusal
from studies.cli.options import named, noise_choice

if TYPE_CHECKING:
    from localize import BayesDecoder, Localizer, OnnxLocalizer, TouchStream

#: White noise that waveforms are reconstructed with where a localizer knows none, Pa rms.
LEAST_NOISE = 1e-6


@dataclass(frozen=True)
class Extras:
    """What a stream shall tell beside the point; each needs the array's library."""

    waveform: bool = False
    ambient: float | None = None
    """dB SPL: sound up to this level is told from touches."""
    refuse: float | None = None
    """Share of the frames of true touches that may be refused with those that no single point explains."""

    @property
    def asked(self) -> str | None:
        """The first option that needs a library."""
        options = {
            "--waveform": self.waveform,
            "--ambient": self.ambient is not None,
            "--refuse": self.refuse is not None,
        }
        return next((name for name, given in options.items() if given), None)


def open_trained(model: Path, noise: float | None, ambient: float | None) -> Localizer | BayesDecoder:
    """A trained localizer from its folder, or the model-based decoder of a library.

    Args:
        model: a folder or a library.
        noise: of the microphones, Pa rms, for a library; None for that of the design's.
        ambient: sound in the room up to this level, dB SPL, for a library; None for quiet.

    Raises:
        Refusal: a noise for a trained localizer, or a file that is neither.
    """
    from localize import BayesDecoder, load_localizer
    from localize.decoders.bayes import sound_levels

    if _is_trained(model):
        if noise is not None:
            raise Refusal(f"--noise = {noise} is for a library; {model} was trained with a noise of its own")
        return load_localizer(model)
    import acoustic_fem

    with named(microphone_noise="--noise"):
        return BayesDecoder(acoustic_fem.load(model), noise_choice(noise), ambient=sound_levels(ambient))


def open_localizer(
    model: Path, noise: float | None, ambient: float | None
) -> Localizer | BayesDecoder | OnnxLocalizer:  # fmt: skip
    """The same, or an ONNX file.

    Raises:
        Refusal: as :func:`open_trained`.
    """
    if model.suffix != ".onnx":
        return open_trained(model, noise, ambient)
    if noise is not None:
        raise Refusal(f"--noise = {noise} is for a library; {model} was made for the noise it names itself")
    from localize import OnnxLocalizer

    return OnnxLocalizer(model)


def open_stream(
    model: Path,
    localizer: Localizer | BayesDecoder | OnnxLocalizer,
    library: Path | None,
    extras: Extras,
    limit: float | None = None,
) -> TouchStream:
    """A stream that listens with a localizer.

    Args:
        model: where the localizer came from.
        localizer: of :func:`open_localizer`.
        library: of the array, where the model is none.
        extras: what to tell beside the point.
        limit: Pa; a sample that reaches it is clipped. By default nothing is.

    Raises:
        Refusal: an extra without a library, a library without an extra, or a figure out of range.
    """
    from localize import BayesDecoder, Reconstructor, ResidualTest, SoundTest, TouchStream
    from localize.live.stream import REFUSED
    from localize.signals.array_response import response_of

    if extras.asked is None:
        if library is not None:
            raise Refusal(f"--library {library} is for --waveform, --ambient and --refuse; give one of them")
        return TouchStream(localizer, limit=limit)
    import acoustic_fem

    path = library or (None if _is_trained(model) or model.suffix == ".onnx" else model)
    if path is None:
        raise Refusal(f"{extras.asked} needs the library of the array: {model} is none; give --library")
    response = response_of(acoustic_fem.load(path))
    noise = localizer.microphone_noise if isinstance(localizer, BayesDecoder) else localizer.noise_rms or "design"
    reconstructor = Reconstructor(response, max(localizer.noise_rms, LEAST_NOISE)) if extras.waveform else None
    with named(loudest="--ambient"):
        sound = None if extras.ambient is None else SoundTest(response, noise, loudest=extras.ambient)
    residual = None if extras.refuse is None else ResidualTest(response, noise, ambient=extras.ambient)
    with named(refused="--refuse"):
        return TouchStream(
            localizer,
            limit=limit,
            reconstructor=reconstructor,
            sound_test=sound,
            residual_test=residual,
            refused=REFUSED if extras.refuse is None else extras.refuse,
        )


def _is_trained(model: Path) -> bool:
    """Whether a MODEL is the folder of a trained localizer."""
    return model.is_dir() or not model.suffix

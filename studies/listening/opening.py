"""What listens: a localizer of any kind, and a stream with all it shall tell."""

from __future__ import annotations

import os
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from geometry.ground.refusal import Refusal
from localize.contacts.contact import RADII

if TYPE_CHECKING:
    from acoustic_fem import Library
    from acoustic_fem.quantities.local_air import LocalAir
    from localize import BayesDecoder, Localizer, OnnxLocalizer, PathTracker, TouchStream
    from localize.live.spare import Judges, StreamLocator
    from localize.signals.array_response import ArrayResponse
    from localize.signals.noise_model import NoiseChoice

#: White noise that waveforms are reconstructed with where a localizer knows none, Pa rms.
LEAST_NOISE = 1e-6
#: White noise that sound is told from at least where nobody asked for it, Pa rms: below, rounding is all there is.
LEAST_SOUND_NOISE = 1e-5


@dataclass(frozen=True)
class Decoding:
    """Choice of how signals are read and what is told beside the point."""

    noise: float | None = None
    """White noise, for a library as model: that of the microphones, Pa rms over 0 to 500 Hz; by default that of the
    design's."""
    library: str | os.PathLike[str] | None = None
    """File of the library of the array, which tells sound from touches and which the fields below need; by default the
    model, where that is one."""
    waveform: bool = False
    """Whether the pressure in the touched cavity is reconstructed."""
    ambient: float | None = None
    """Level of sound in the room up to which touches are named in it, dB SPL; by default a quiet room. Sound alone is
    told from touches in any case, up to 80 dB SPL or this level."""
    refuse: float | None = None
    """Share of the frames of true touches that may be refused with those that no single point explains; by default the
    likeliest point is named."""
    air: LocalAir | None = None
    """Air of the place, to which a library is brought; by default that of the library."""
    follow_drift: bool = False
    """Whether the stiffness of a calibrated sensor is followed over the touches, for a library as model."""

    @property
    def needs_library(self) -> str | None:
        """Name of the first field given that needs a library; None where none is."""
        given = {"waveform": self.waveform, "ambient": self.ambient is not None, "refuse": self.refuse is not None}
        return next((name for name, wanted in given.items() if wanted), None)


def open_trained(
    model: Path, noise: float | None, ambient: float | None, air: LocalAir | None = None
) -> Localizer | BayesDecoder:
    """Trained localizer from its folder, or the model-based decoder of a library.

    Args:
        model: a folder or a library.
        noise: of the microphones, Pa rms, for a library; None for that of the design's.
        ambient: sound in the room up to this level, dB SPL, for a library; None for quiet.
        air: of the place, for a library; None for that of the library.

    Raises:
        Refusal: a noise or air for a trained localizer, or a file that is neither.
    """
    from localize import BayesDecoder, load_localizer
    from localize.decoders.bayes import sound_levels

    if _is_trained(model):
        if noise is not None:
            raise Refusal(f"`noise` = {noise} is for a library; {model} was trained with a noise of its own")
        _refuse_air(model, air)
        return load_localizer(model)
    return BayesDecoder(library_there(model, air), "design" if noise is None else noise, sound_levels(ambient))


def open_tracker(library: Path, decoding: Decoding, radius: float) -> tuple[BayesDecoder, PathTracker]:
    """Decoder of a library that tells what is heard, and the tracker of its paths.

    Args:
        library: of the array; its sensor is decoded as it is.
        decoding: how signals are read.
        radius: of the contact, mm.

    Raises:
        Refusal: a model that is no library, or as :class:`localize.PathTracker`.
    """
    from acoustic_fem.quantities.checks import in_range
    from localize import BayesDecoder, PathTracker
    from localize.decoders.bayes import sound_levels

    in_range("radius", radius, *RADII, "mm")
    if library.suffix == ".onnx" or _is_trained(library):
        raise Refusal(f"{library}: is no library; paths need one, which tells what is heard of a contact at any place")
    found = library_there(library, decoding.air)
    noise: NoiseChoice = "design" if decoding.noise is None else decoding.noise
    tracker = PathTracker(found, radius, noise, decoding.ambient)
    return BayesDecoder(found, noise, sound_levels(decoding.ambient)), tracker


def open_localizer(model: Path, decoding: Decoding) -> Localizer | BayesDecoder | OnnxLocalizer:
    """Localizer of :func:`open_trained`, that of an ONNX file, or of a library the decoder that its sensor asks for.

    A library that was computed tells what the sensor was designed to be: it is decoded with the tolerances of
    manufacturing. A calibrated one, and one of a design whose scatter is not known, is decoded as it is, or with the
    drift that is to be followed.

    Args:
        model: a folder, an ONNX file or a library.
        decoding: how signals are read.

    Raises:
        Refusal: as :func:`open_trained`; a drift to follow of what is no library, or of one that is not calibrated.
    """
    noise, ambient, air = decoding.noise, decoding.ambient, decoding.air
    if decoding.follow_drift:
        return _open_following(model, decoding)
    if model.suffix != ".onnx" and _is_trained(model):
        return open_trained(model, noise, ambient, air)
    if model.suffix != ".onnx":
        return _decoder(library_there(model, air), "design" if noise is None else noise, ambient)
    if noise is not None:
        raise Refusal(f"`noise` = {noise} is for a library; {model} was made for the noise it names itself")
    _refuse_air(model, air)
    from localize import OnnxLocalizer

    return OnnxLocalizer(model)


def _open_following(model: Path, decoding: Decoding) -> BayesDecoder:
    from localize.decoders.bayes import sound_levels
    from localize.decoders.drift import DriftDecoder, objection_to_drift
    from localize.live.events import HOP
    from localize.signals.frames import FRAME

    if _is_trained(model) or model.suffix == ".onnx":
        raise Refusal(f"`follow_drift` needs a calibrated library as model: {model} is none")
    library = library_there(model, decoding.air)
    objection = objection_to_drift(library)
    if objection is not None:
        raise Refusal(f"{model}: {objection}")
    level: NoiseChoice = "design" if decoding.noise is None else decoding.noise
    return DriftDecoder(library, level, sound_levels(decoding.ambient), new=HOP / FRAME)


def assumed_by(model: Path, localizer: Localizer | BayesDecoder | OnnxLocalizer, decoding: Decoding) -> str:
    """What a localizer takes for granted, in words.

    Args:
        model: where it came from.
        localizer: of :func:`open_localizer` or :func:`open_trained`.
        decoding: how signals are read.
    """
    from localize import BayesDecoder
    from localize.decoders.bayes import assumed_of
    from localize.decoders.tolerant import TolerantDecoder, objection_to_tolerances

    if isinstance(localizer, TolerantDecoder):
        return localizer.assumes
    if isinstance(localizer, BayesDecoder):
        objection = objection_to_tolerances(library_there(model, decoding.air))
        return localizer.assumes if objection is None else f"{localizer.assumes} ({objection})"
    if localizer.kind == "network":
        return "that touches are like those of the training"
    return assumed_of(localizer.provenance)


def open_stream(
    model: Path,
    localizer: Localizer | BayesDecoder | OnnxLocalizer,
    decoding: Decoding,
    limit: float | None = None,
    frames: bool = False,
) -> TouchStream:
    """Stream that listens with a localizer.

    Args:
        model: where the localizer came from.
        localizer: of :func:`open_localizer`.
        decoding: what to tell beside the point.
        limit: Pa; a sample that reaches it is clipped. By default nothing is.
        frames: whether decisions carry the samples that were judged.

    Raises:
        Refusal: a field that needs a library without one, a library of another design than the localizer's, or a figure
            out of range.
    """
    from localize import BayesDecoder, DriftDecoder, Listening, Reconstructor, TouchStream
    from localize.live.stream import REFUSED
    from localize.signals.array_response import response_of
    from localize.signals.same_array import check_same_design

    # A noise that is told is what there is: then nothing is measured.
    listening = Listening(follow=decoding.noise is None, frames=frames)
    needy = decoding.needs_library
    path = decoding.library or (None if _is_trained(model) or model.suffix == ".onnx" else model)
    if path is None and needy is None:
        return TouchStream(localizer, limit=limit, listening=listening)
    if path is None:
        raise Refusal(f"`{needy}` needs the library of the array: {model} is none; give `library`")
    library = library_there(path, decoding.air)
    response = response_of(library)
    check_same_design(localizer, response, path)
    noise = localizer.microphone_noise if isinstance(localizer, BayesDecoder) else localizer.noise_rms or "design"
    wave = Reconstructor(response, max(localizer.noise_rms, LEAST_NOISE)) if decoding.waveform else None
    judges = _judges(localizer, response, noise, decoding)

    def without(microphones: tuple[str, ...]) -> Judges:
        if isinstance(localizer, DriftDecoder):
            rest: BayesDecoder = localizer.heard_by(microphones)
        else:
            rest = _decoder(library, noise, decoding.ambient, microphones)
        return _judges(rest, response.heard_by(microphones), noise, decoding)

    return TouchStream(
        localizer,
        limit=limit,
        reconstructor=wave,
        sound_test=judges.sound_test,
        residual_test=judges.residual_test,
        refused=REFUSED if decoding.refuse is None else decoding.refuse,
        listening=listening,
        # A network knows nothing of the array without one of its microphones.
        spare=without if isinstance(localizer, BayesDecoder) else None,
    )


def _decoder(
    library: Library, noise: NoiseChoice, ambient: float | None, microphones: tuple[str, ...] | None = None
) -> BayesDecoder:
    """Decoder of a library for all of its microphones, or some."""
    from localize import BayesDecoder
    from localize.decoders.bayes import sound_levels
    from localize.decoders.tolerant import tolerant_decoder
    from localize.signals.array_response import response_of

    levels = sound_levels(ambient)
    response = response_of(library)
    known = response if microphones is None else response.heard_by(microphones)
    return tolerant_decoder(library, noise, levels, microphones) or BayesDecoder(known, noise, levels)


def _judges(locator: StreamLocator, response: ArrayResponse, noise: NoiseChoice, decoding: Decoding) -> Judges:
    """Locator with the tests that are asked for, and that of sound where the library is of a design."""
    from localize import ResidualTest, SoundTest
    from localize.live.spare import Judges

    sound = None
    if decoding.ambient is not None:
        sound = SoundTest(response, noise, loudest=decoding.ambient)
    elif response.ambient_response is not None:
        sound = SoundTest(response, noise if isinstance(noise, str) else max(noise, LEAST_SOUND_NOISE))
    residual = None if decoding.refuse is None else ResidualTest(response, noise, ambient=decoding.ambient)
    return Judges(locator, sound, residual)


def library_there(path: str | os.PathLike[str], air: LocalAir | None) -> Library:
    """Library of a file, brought to the air of the place."""
    import acoustic_fem

    library = acoustic_fem.load(path)
    return library if air is None else library.in_air(**asdict(air))


def _refuse_air(model: Path, air: LocalAir | None) -> None:
    """What was trained, or made a graph, keeps the air of the library that it came from."""
    given = {} if air is None else {name: value for name, value in asdict(air).items() if value is not None}
    for name, value in given.items():
        raise Refusal(
            f"{name} = {value:g} is for a library; {model} was made in air of its own: make it again from a library "
            "in that air"
        )


def _is_trained(model: Path) -> bool:
    """Whether a model is the folder of a trained localizer."""
    return model.is_dir() or not model.suffix

"""A model from its source: a file, a folder, a library or a localizer in memory, with its options."""

from __future__ import annotations

import os
from dataclasses import asdict, fields, replace
from pathlib import Path
from typing import TypeAlias

import acoustic_fem
import localize
from acoustic_fem.library.transfer_functions import Library
from acoustic_fem.quantities.local_air import LocalAir
from acoustic_fem.quantities.microphone_signals import Output
from geometry.ground.argument_checks import check_type
from geometry.ground.refusal import Field, Kind, Refusal
from localize.decoders.bayes import BayesDecoder
from localize.decoders.drift import DriftDecoder, check_drift
from localize.decoders.library_decoder import LibraryDecoder
from localize.decoders.surroundings import sound_levels
from localize.decoders.tolerant import decoder_of, unknown_tolerances
from localize.graphs.onnx_localizer import OnnxLocalizer
from localize.live.events import HOP
from localize.model.decoding import Decoding, LibrarySource
from localize.model.file_contents import FileContent, file_content
from localize.model.opened_model import Model
from localize.signals.array_response import response_of
from localize.signals.frames import FRAME
from localize.signals.locator import Locator
from localize.signals.noise_model import NoiseChoice
from localize.signals.same_array import check_same_design

ModelSource: TypeAlias = str | os.PathLike[str] | Library | Locator | Model
"""A model: its path (a library, the folder of a trained localizer, an ONNX file), or one in memory."""


def open_model(
    source: ModelSource,
    *,
    air: LocalAir | None = None,
    microphone_noise: NoiseChoice = "design",
    ambient: float | None = None,
    library: LibrarySource | None = None,
    waveform: bool = False,
    rejected_fraction: float | None = None,
    follow_drift: bool = False,
    tolerances: bool = True,
    microphone_output: Output = "pressure",
    lowest: float | None = None,
    two_touches: bool = False,
    motion: float | None = None,
) -> Model:
    """Model from a file, a folder, a library or a localizer in memory; a file is recognised by its content.

    A computed library says what the sensor was designed to be, so it is decoded with manufacturing tolerances. A
    calibrated library, and one of a design whose scatter is not known, is decoded as it is, or with its drift followed.

    Args:
        source: a library, the folder of a trained localizer or an ONNX file; or a library or a localizer in memory.
        air: air in which the sensor is used, to which the library is converted; by default that of the library.
        microphone_noise: white noise of the microphones that the decoder of a library assumes, Pa rms over 0 to 500 Hz,
            or "design" for that of the design's microphone.
        ambient: highest level of room sound in which touches are classified, dB SPL; by default a quiet room. Frames
            that hold only sound are detected in any case, up to 80 dB SPL or this level.
        library: library of the array, for a network or graph that is to detect sound, and for the arguments below; by
            default the source, where that is one.
        waveform: whether the pressure in the touched cavity is reconstructed.
        rejected_fraction: fraction of the frames of true touches that may be rejected with those that no single point
            explains, above 0, below 1; by default the likeliest point is always given.
        follow_drift: whether the stiffness of a calibrated sensor is followed over the touches.
        tolerances: whether a computed library is decoded with manufacturing tolerances.
        microphone_output: content of the signals that are read or listened to: ``pressure`` in front of the
            microphones, or ``voltage``, outputs of the microphones that nobody has equalised.
        lowest: frequency down to which outputs are equalised to pressures, Hz; by default 1 Hz.
        two_touches: whether each contact is searched for two touches at once, which needs a library.
        motion: largest acceleration of the sensor in use, gravity left out, m/s^2; it needs a library. Frames that hold
            only motion are then detected. By default the sensor lies still.

    Returns:
        The model; a :class:`Model` is handed back as it is.

    Raises:
        Refusal: a file that cannot be read or holds no model; noise, air or a drift for a model that is not a library;
            an argument that needs the library of the array without one; a library of another design; a value out of
            range.
    """
    decoding = Decoding(
        microphone_noise,
        library,
        waveform,
        ambient,
        rejected_fraction,
        air,
        follow_drift,
        tolerances,
        microphone_output,
        lowest,
        two_touches,
        motion,
    )
    return opened(source, decoding, "source")


def opened(source: ModelSource, decoding: Decoding | None = None, name: str = "model") -> Model:
    """Model as of :func:`open_model`, with its arguments as one object; a model that is open takes no others.

    Args:
        source: as of :func:`open_model`.
        decoding: its other arguments.
        name: name of the argument that is the source.
    """
    given = decoding or Decoding()
    if isinstance(source, Model):
        _refuse_other_choices(source, given)
        return source
    allowed = "the path of a model, or a library, a localizer or an open model in memory"
    check_type(name, source, (str, os.PathLike, Library, Locator), allowed)
    content = file_content(Path(source)) if isinstance(source, (str, os.PathLike)) else None
    is_library = isinstance(source, Library) or content is FileContent.LIBRARY
    library = open_library(source, given.air) if is_library else None
    beside = library if given.library is None else open_library(given.library, given.air)
    reason = None if library is None else unknown_tolerances(library)
    locator = _network(source, content, given) if library is None else _decoder(library, source, given)
    response = locator.response if beside is None else response_of(beside)
    if beside is not None and beside is not library:
        check_same_design(locator.array, response_of(beside).array, _name(given.library))
    if response is None:
        _refuse_without_library(source, given)
    return Model(
        locator,
        beside,
        response,
        given,
        locator.assumptions if reason is None else f"{locator.assumptions} ({reason})",
        () if reason is None else (f"manufacturing tolerances are not modelled: {reason}",),
        (*files_of(source), *files_of(given.library)),
    )


def opened_as_designed(source: ModelSource, decoding: Decoding | None = None) -> Model:
    """Model as of :func:`opened`, but its library is decoded as it is, without manufacturing tolerances."""
    if not isinstance(source, Model):
        return opened(source, replace(decoding or Decoding(), tolerances=False))
    model = opened(source, decoding)
    if model.library is None or not model.decoding.tolerances:
        return model
    again = opened(model.library, replace(model.decoding, library=None, air=None, tolerances=False))
    return replace(again, files=model.files)


def open_library(source: ModelSource, air: LocalAir | None = None) -> Library:
    """Library of a path, a library in memory, or that of an open model, brought to the air of the place.

    Raises:
        Refusal: a file that cannot be read, a model that has no library, another type, or air out of range.
    """
    if isinstance(source, Model) and source.library is not None:
        found = source.library
    elif isinstance(source, Library):
        found = source
    elif isinstance(source, (Model, Locator)):
        raise Refusal("is no library", kind=Kind.UNSUITABLE, field="library")
    else:
        allowed = "the path of a library, or a library or an open model in memory"
        check_type("library", source, (str, os.PathLike), allowed)
        found = acoustic_fem.load(source)
    return found if air is None else found.in_air(air)


def files_of(source: object) -> tuple[Path, ...]:
    """Files and folders that a model or a library is read from; none for one in memory."""
    if isinstance(source, Model):
        return source.files
    return (Path(source),) if isinstance(source, (str, os.PathLike)) else ()


def _refuse_other_choices(model: Model, given: Decoding) -> None:
    """Refuse arguments beside an open model that differ from those it was opened with."""
    for each in fields(Decoding):
        value = getattr(given, each.name)
        if value != each.default and value != getattr(model.decoding, each.name):
            problem = "must be given when the model is opened, to localize.open_model"
            shown = value if isinstance(value, (str, int, float)) else Refusal.NOT_GIVEN
            raise Refusal(problem, kind=Kind.CONFLICT, field=each.name, value=shown)


def _decoder(library: Library, source: ModelSource, given: Decoding) -> LibraryDecoder:
    """Decoder of a library, for all of its microphones."""
    levels = sound_levels(given.ambient)
    if given.follow_drift:
        try:
            check_drift(library)
        except Refusal as error:
            raise Refusal.of(error, file=_name(source), field="") from None
        return DriftDecoder(library, given.microphone_noise, levels, new=HOP / FRAME)
    return (
        decoder_of(library, given.microphone_noise, levels)
        if given.tolerances
        else BayesDecoder(library, given.microphone_noise, levels)
    )


def _network(source: ModelSource, content: FileContent | None, given: Decoding) -> Locator:
    """Localizer in memory, a graph, or a trained localizer: each keeps its own noise and air."""
    if given.microphone_noise != "design":
        problem = f"is for a library; {_name(source)} was made for a fixed noise"
        raise Refusal(problem, kind=Kind.CONFLICT, field="microphone_noise", value=given.microphone_noise, unit="Pa")
    for name, value in ({} if given.air is None else asdict(given.air)).items():
        if value is not None:
            problem = f"is for a library; {_name(source)} was made in air of its own"
            remedy = "make it again from a library in that air"
            raise Refusal(problem, kind=Kind.CONFLICT, field=name, value=value, remedy=remedy)
    if given.follow_drift:
        problem = f"needs a calibrated library as model: {_name(source)} is not a library"
        raise Refusal(problem, kind=Kind.CONFLICT, field="follow_drift")
    if isinstance(source, Locator):
        return source
    assert isinstance(source, (str, os.PathLike))
    if content is FileContent.GRAPH:
        return OnnxLocalizer(source)
    return localize.load_localizer(source)


def _refuse_without_library(source: ModelSource, given: Decoding) -> None:
    for name in ("waveform", "ambient", "rejected_fraction", "motion"):
        if getattr(given, name) != getattr(Decoding, name):
            problem = f"needs the library of the array: {_name(source)} is not a library"
            remedy = ("give it as ", Field("library"))
            raise Refusal(problem, kind=Kind.MISSING, field=name, value=getattr(given, name), remedy=remedy)


def _name(source: object) -> str:
    """Source of a model in words: its path, or its kind."""
    return str(source) if isinstance(source, (str, os.PathLike)) else f"a {type(source).__name__} in memory"

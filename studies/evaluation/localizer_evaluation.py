"""A localizer evaluated on touches that it was not trained on, the Bayes decoder beside it."""

from __future__ import annotations

import os
import warnings
from pathlib import Path
from typing import TYPE_CHECKING

from acoustic_fem.library.transfer_functions import Library
from geometry.ground.refusal import Kind, Refusal
from localize import evaluation
from localize.decoders.bayes import BayesDecoder
from localize.decoders.tolerant import tolerant_decoder
from localize.model.opened_model import Model
from localize.model.opening import ModelSource, files_of, open_library, opened
from localize.signals.array_response import response_of
from localize.signals.locator import Locator
from localize.signals.noise_model import NoiseChoice, check_noise_choice
from localize.signals.same_array import check_same_array, design_difference
from studies.output.call_defaults import HELD_OUT_TOUCHES, SEED
from studies.output.display import Display
from studies.output.folders import check_folder, claimed_folder

if TYPE_CHECKING:
    from studies.evaluation.headline import Headline

#: White noise that the Bayes decoder assumes where touches have less, Pa rms.
LEAST_NOISE = 1e-6


def evaluate_localizer(
    model: ModelSource,
    library: ModelSource | None = None,
    out: str | os.PathLike[str] | None = None,
    *,
    touches: int = HELD_OUT_TOUCHES,
    microphone_noise: NoiseChoice = "design",
    seed: int = SEED,
    display: Display | None = None,
) -> dict[str, Headline]:
    """Evaluations of a localizer and, for comparison, of the Bayes decoder, on touches that were not used in training.

    The headline is for taps and presses on as-built sensors, which deviate as assumed where nobody calibrated them.
    Beside it are taps and presses apart, virtual rigs, the nominal sensor and multi-sine touches. Where as-built
    sensors are not known, such as for a measured library, the headline is for the nominal sensor.

    Args:
        model: a path, a library, a localizer or an open model, see :func:`localize.open_model`.
        library: library that the touches are simulated with: its path, or a library or an open model in memory. By
            default the library of the model, if it has one.
        out: a folder for ``evaluation.json`` and ``evaluation.html``. If you give it, both are also evaluated with
            other noise, room sound, kinds and lengths of touches, and on sensors with other tolerances.
        touches: number of held-out touches of each point in the headline, on all its sensors together and half of them
            taps, but at least one tap and one press on each sensor.
        microphone_noise: white noise of the microphones, Pa rms over 0 to 500 Hz, or "design" for that of the design's
            microphone.
        seed: seed of the touches.
        display: shows progress.

    Returns:
        Evaluation of each localizer by its name: ``"network"`` or the kind of an ONNX file, ``"Bayes decoder"`` and,
        unless the library was measured, ``"tolerance-aware decoder"``.

    Raises:
        Refusal: no library for a model without one, a folder that cannot be written, a file that cannot be read, a
            localizer of another array, or a value out of range.
    """
    from studies.evaluation.evaluation_report import JSON_FILE, write_evaluation
    from studies.evaluation.full_evaluation import evaluate_fully
    from studies.evaluation.headline import TOLERANT, evaluate_headlines

    check_noise_choice(microphone_noise, "microphone_noise")
    folder = None if out is None else Path(out)
    if folder is not None:
        check_folder(folder, "evaluate", JSON_FILE, reads=(*files_of(model), *files_of(library)))
    found_model = opened(model)
    localizer, solved = found_model.locator, _library_of(found_model, model, library)
    response = response_of(solved)
    evaluation.check_evaluation(localizer, response, touches, microphone_noise)
    source = ", ".join(map(str, files_of(model if library is None else library))) or "library"
    check_same_array(localizer.array, response.array, source)
    difference = design_difference(localizer.array, response.array)
    if difference:
        warnings.warn(f"{source}: is of another design than the localizer: {difference}", stacklevel=2)
    decoder = BayesDecoder(
        response, microphone_noise if isinstance(microphone_noise, str) else max(microphone_noise, LEAST_NOISE)
    )
    locators: dict[str, Locator] = {localizer.kind: localizer, "Bayes decoder": decoder}
    tolerant = tolerant_decoder(solved, decoder.microphone_noise)
    if tolerant is not None:
        locators[TOLERANT] = tolerant
    with (display or Display()).stage("Evaluation") as report:
        if folder is None:
            return evaluate_headlines(locators, solved, response, touches, microphone_noise, seed, report)
        with claimed_folder(folder, "evaluate", JSON_FILE, reads=(*files_of(model), *files_of(library))):
            found = evaluate_fully(locators, solved, response, touches, microphone_noise, seed, report)
            report("report", 1.0)
            write_evaluation(found, folder)
    return {each.name: each.headline for each in found.results}


def _library_of(opened_model: Model, model: ModelSource, library: ModelSource | None) -> Library:
    """Library from which touches are made; a path that is given as model and as library is read once.

    Raises:
        Refusal: none is given and the model holds no library, or as :func:`localize.model.opening.open_library`.
    """
    same = isinstance(library, (str, os.PathLike)) and isinstance(model, (str, os.PathLike))
    if library is not None and not (same and Path(str(library)) == Path(str(model))):
        return open_library(library)
    if opened_model.library is None:
        allowed = "the library of the array, because the model holds none and touches are made from it"
        raise Refusal(kind=Kind.MISSING, field="library", allowed=allowed)
    return opened_model.library

"""A localizer judged on touches that it has never heard, the model-based decoder beside it."""

from __future__ import annotations

import os
import warnings
from pathlib import Path
from typing import TYPE_CHECKING

import acoustic_fem
from localize import BayesDecoder, OnnxLocalizer
from localize.decoders.tolerant import tolerant_decoder
from localize.signals.array_response import response_of
from localize.signals.noise_model import NoiseChoice
from localize.signals.same_array import check_same_array, design_difference
from studies.evaluation.full_evaluation import SENSORS, evaluate_fully
from studies.output.display import Display
from studies.output.folders import check_folder

if TYPE_CHECKING:
    from localize.evaluation.accuracy import Locator
    from studies.evaluation.headline import Headline

#: White noise that the Bayes decoder assumes where touches have less, Pa rms.
LEAST_NOISE = 1e-6


def evaluate_localizer(
    model: str | os.PathLike[str],
    library: str | os.PathLike[str],
    out: str | os.PathLike[str] | None = None,
    *,
    touches: int = 200,
    noise: float | None = None,
    seed: int = 0,
    display: Display | None = None,
) -> dict[str, Headline]:
    """Evaluations of a localizer on touches that it has never heard, the Bayes decoder beside it.

    The touches are sums of sines on the nominal sensor; beside them stand taps, and sensors that are made with a
    workshop's tolerances.

    Args:
        model: the folder of a trained localizer, or an ONNX file.
        library: the file of the library that touches are made from.
        out: a folder for ``evaluation.json`` and ``evaluation.html``: with it, both are also judged under other noise,
            ambient sound, touches and lengths, and on mis-made sensors.
        touches: held-out touches of every point.
        noise: of the microphones, white, Pa rms over 0 to 500 Hz; by default that of the design's.
        seed: of the touches.
        display: shows what is being done.

    Returns:
        Each localizer's evaluation by its name: ``"network"``, or the kind of an ONNX file, ``"Bayes decoder"``,
        and where the library is not that of a measured sensor ``"tolerant decoder"``.

    Raises:
        Refusal: a folder that cannot be written, a file that cannot be read, a localizer of another array, or a value
            out of range.
    """
    folder = None if out is None else Path(out)
    from studies.evaluation.evaluation_report import JSON_FILE

    if folder is not None:
        check_folder(folder, "evaluate", JSON_FILE, reads=(model, library))
    from localize import load_localizer
    from localize.evaluation.accuracy import check_evaluation
    from studies.evaluation.evaluation_report import write_evaluation
    from studies.evaluation.headline import TOLERANT, Headline, judge_headlines

    localizer = OnnxLocalizer(model) if Path(model).suffix == ".onnx" else load_localizer(model)
    solved = acoustic_fem.load(library)
    response = response_of(solved)
    level: NoiseChoice = "design" if noise is None else noise
    check_evaluation(localizer, response, touches, level)
    check_same_array(localizer, response, library)
    difference = design_difference(localizer, response)
    if difference:
        warnings.warn(f"{library}: is of another design than the localizer: {difference}", stacklevel=2)
    decoder = BayesDecoder(response, "design" if noise is None else max(noise, LEAST_NOISE))
    name = localizer.kind if isinstance(localizer, OnnxLocalizer) else "network"
    locators: dict[str, Locator] = {name: localizer, "Bayes decoder": decoder}
    tolerant = tolerant_decoder(solved, decoder.microphone_noise)
    if tolerant is not None:
        locators[TOLERANT] = tolerant
    with (display or Display()).stage("Evaluation") as report:
        if folder is None:
            return judge_headlines(locators, solved, response, touches, level, seed, report)
        found = evaluate_fully(locators, solved, response, touches, level, seed, report)
        report("report", 1.0)
        write_evaluation(found, folder)
    return {each.name: Headline.of(each.overall, each.outcomes, SENSORS, found.unscattered) for each in found.judged}

"""Value of a fitted library before anything more is measured: the accuracy to be expected on the as-built sensor.

A fit to a few points leaves sensors that differ and agree with the measurement equally well. The as-built one is a draw
from that posterior, with what the model lacks; the decoder knows its mean only. Its top-1 accuracy on such draws
says if another point should be measured.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.calibration.fitted_model import Posterior
from acoustic_fem.calibration.model_discrepancy import draw
from acoustic_fem.calibration.model_updating import Update
from acoustic_fem.library.transfer_functions import MEASURED
from localize.decoders.bayes import BayesDecoder
from localize.evaluation.accuracy import evaluate
from localize.recalibration.recalibration_options import AccuracyOptions
from localize.signals.array_response import response_of
from localize.signals.noise_model import NoiseChoice


def expected_accuracy(
    posterior: Posterior,
    microphone_noise: NoiseChoice = "design",
    seed: int = 0,
    options: AccuracyOptions = AccuracyOptions(),
) -> NDArray[np.float64]:
    """Top-1 accuracies on sensors that agree with a measurement, by the decoder of the most probable one.

    Args:
        posterior: of :func:`acoustic_fem.calibration.model_updating.update` or a self-calibration, on 1 to 100 Hz.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        seed: of the sensors and touches.
        options: how many sensors and touches.

    Returns:
        (n_draw,) float64 from 0 to 1, ascending.

    Raises:
        Refusal: frequencies that do not cover 1 to 100 Hz, or a noise out of range.
    """
    response = response_of(posterior.model.library)
    # The fitted sensor stands for a measured one, whose library ends with its sweeps.
    response = replace(response, provenance={**response.provenance, "fidelity": MEASURED})
    random = np.random.default_rng(seed)
    apart = random.standard_normal((options.draws, posterior.model.count)) / np.sqrt(1 + posterior.eigenvalues)
    drawn = posterior.parameters + apart @ posterior.directions.T
    decoder = BayesDecoder(replace(response, transfer_function=posterior.transfer_function), microphone_noise)
    sensors = np.asarray(posterior.model.transfer_function(drawn))
    sensors = sensors * (1 + draw(random, posterior.model.frequency, sensors.shape[:3]))
    touches = options.touches_per_point
    return np.sort(
        [
            evaluate(decoder, replace(response, transfer_function=h), touches, microphone_noise, seed=seed).top1
            for h in sensors
        ]
    )


def is_enough(fit: Update, accuracy: NDArray[np.float64], options: AccuracyOptions = AccuracyOptions()) -> bool:
    """True if no other point needs to be measured.

    Args:
        fit: to some points.
        accuracy: (n_draw,) float64, from 0 to 1, of :func:`expected_accuracy`.
        options: what is enough.
    """
    return len(fit.points) >= options.fewest_points and bool(accuracy.min() >= options.enough)


def least_known(posterior: Posterior) -> int:
    """Number of the point, from 1, whose transfer functions are known least: the one to measure next."""
    relative = posterior.deviation / np.abs(posterior.transfer_function)
    return int(np.sqrt((relative**2).mean((1, 2))).argmax()) + 1

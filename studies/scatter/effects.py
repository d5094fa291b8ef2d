"""Effects of manufacturing scatter on a design: spread of its responses and of its accuracy, and what matters most.

Three accuracies are predicted for each sensor with scatter (:mod:`studies.metrics.confusion`):

- ``calibrated``: every sensor is measured and has a localizer of its own;
- ``nominal``: one localizer for all, trained on the nominal design;
- ``trained``: one localizer for all, trained on a library of sensors with scatter
  (:mod:`studies.scatter.perturbed_library`); a lower bound, for the likelihoods of 32 of them are averaged.

The largest effects are found by Sobol indices of groups: all deviations of one quantity, part by part, are one factor.
The first-order index is the share of the variance that would go, on average, if that quantity were known; the total
one the share that would be left if all others were known. Estimated by pick-freeze (first order: Saltelli et al.,
Comput. Phys. Commun. 181 (2010) 259, table 2; total: Jansen, Comput. Phys. Commun. 117 (1999) 35).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.atlas.fidelity_choice import QuickFidelity
from acoustic_fem.membrane.disc import KnownDiscs
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter.as_built_sensors import AsBuiltSensors, as_built_fidelity
from acoustic_fem.scatter.tolerances import TOLERANCES, ScatteredDesign, Tolerance
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_range
from geometry.ground.typed import Array, ComplexArray
from localize.signals import noise_model
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from studies.metrics.batch_responses import Responses
from studies.metrics.confusion import check_grid, predict_confusion
from studies.metrics.separation import pair_distances

#: Predicted accuracies by name, and the localizer that decides.
ACCURACIES = {
    "calibrated": "a localizer for each sensor",
    "nominal": "one localizer, trained on the nominal design",
    "trained": "one localizer, trained on sensors with scatter",
}
#: Sensors that the localizer of ``trained`` has seen; it is evaluated on others.
_SEEN = 32
_BLOCK = 256


@dataclass(frozen=True)
class SobolIndex:
    """Shares of a variance that are due to one quantity; estimates, which may leave 0 to 1 by their error."""

    quantity: str
    """Name of the quantity."""
    first: float
    """Share of the quantity by itself."""
    total: float
    """Share of the quantity with all its interactions."""
    error: float
    """Standard error of ``total``, by bootstrap."""


@dataclass(frozen=True, eq=False)
class ToleranceResult:
    """Result of a tolerance study: scatter of one design, samples along the first axis."""

    design: ArrayDesign
    """Nominal design."""
    tolerances: tuple[Tolerance, ...]
    """Quantities that scatter."""
    frequency: Array
    """Frequencies of the transfer functions; (n_freq,) float64, Hz."""
    nominal: ComplexArray
    """Transfer functions of the nominal design; (n_point, n_microphone, n_freq) complex128, Pa/Pa."""
    transfer_function: ComplexArray
    """Transfer functions of the sensors with scatter; (n_sample, n_point, n_microphone, n_freq) complex128, Pa/Pa."""
    nominal_accuracy: float
    """Predicted top-1 of the nominal design, with its own localizer."""
    accuracy: dict[str, Array]
    """Predicted top-1 of each sensor per entry of :data:`ACCURACIES`; (n_sample,) float64 each, 0 to 1."""
    deviation: Array
    """Deviation of each sensor: rms over points, microphone pairs and frequencies of |log(r / r_nominal)|, r = H_a /
    H_b; (n_sample,) float64."""
    closest: Array
    """Smallest distance of two points of each sensor, as the metric distance_smallest; (n_sample,) float64."""
    sobol: dict[str, tuple[SobolIndex, ...]]
    """Sobol indices of ``deviation`` and of the accuracy ``nominal``: one per quantity, the largest total first."""
    noise: str
    """Noise of the microphones, in words."""
    seed: int
    """Seed of all draws."""
    fidelity: QuickFidelity
    """Fidelity of all transfer functions, and why it is not the atlas."""

    def summary(self) -> dict[str, Any]:
        """Figures of the study, all but the transfer functions, as JSON can hold them."""
        return {
            "design": self.design.name,
            "samples": len(self.deviation),
            "seed": self.seed,
            "fidelity": self.fidelity.name,
            "outside_atlas": self.fidelity.outside,
            "noise": self.noise,
            "tolerances": {
                t.quantity: {"deviation": t.deviation, "kind": t.kind, "unit": _unit(t), "source": t.source}
                for t in self.tolerances
            },
            "nominal_accuracy": self.nominal_accuracy,
            "accuracy": {name: _spread(values) for name, values in self.accuracy.items()},
            "deviation": _spread(self.deviation),
            "distance_smallest": _spread(self.closest),
            "sobol": {
                name: {i.quantity: {"first": i.first, "total": i.total, "error": i.error} for i in indices}
                for name, indices in self.sobol.items()
            },
        }


def scatter_effects(
    design: ArrayDesign,
    frequency: FrequencyLike,
    *,
    samples: int = 256,
    base_samples: int = 128,
    tolerances: Sequence[Tolerance] = TOLERANCES,
    microphone_noise: NoiseChoice = "design",
    seed: int = 0,
    progress: Callable[[str, float], None] | None = None,
) -> ToleranceResult:
    """Result of a Monte Carlo over manufacturing scatter, every part with its own deviation.

    At fidelity ``atlas`` if that covers the design and all sensors that can be drawn about it, otherwise with a
    nominal design that is solved in 3-D.

    Args:
        design: the nominal array.
        frequency: (n_freq,) Hz, over 1 to 100 Hz, or FIRST:LAST:COUNT.
        samples: number of sensors with manufacturing scatter.
        base_samples: base samples of the Sobol indices, for which (number of tolerances + 2) times as many sensors are
            computed; 0 for no indices.
        tolerances: quantities that scatter.
        microphone_noise: white noise of every microphone, Pa rms over 0 to 500 Hz; by default the noise of the
            design's microphone.
        seed: seed of all draws.
        progress: function that is called with the name of the step and the fraction done.

    Raises:
        Refusal: a value out of range, or a design that the batch does not take.
    """
    for name, value, least in (("samples", samples, 2), ("base_samples", base_samples, 0)):
        check_range(name, value, least, 1_000_000, whole=True)
    if microphone_noise != "design":
        check_range("microphone_noise", microphone_noise, 0, 100, "Pa", excluded="low")
    report = progress or (lambda message, fraction: None)
    grid, air = frequency_grid(frequency), design_air(design)
    check_grid(grid)
    report("membranes", 0.0)
    scattered = ScatteredDesign(design, tolerances)
    level, fidelity = _noise(design, microphone_noise), as_built_fidelity(scattered, grid, air)
    sensors = AsBuiltSensors(scattered, grid, air, fidelity.name)
    nominal, made = sensors.nominal, sensors.transfer_functions

    blocks = ((first, min(_BLOCK, samples - first)) for first in range(0, samples, _BLOCK))
    h = np.concatenate([made(scattered.draws(first, count, seed)) for first, count in blocks])
    seen = made(scattered.draws(samples, _SEEN, seed))
    report("accuracy", 0.2)
    accuracy = {
        name: predict_confusion(h, grid, level, assumed=assumed).top1
        for name, assumed in (("calibrated", None), ("nominal", nominal), ("trained", seen))
    }
    outputs = {
        "deviation": lambda values: deviation(values, nominal),
        "nominal": lambda values: predict_confusion(values, grid, level, assumed=nominal).top1,
    }
    return ToleranceResult(
        design=design,
        tolerances=scattered.tolerances,
        frequency=grid,
        nominal=nominal[0],
        transfer_function=h,
        nominal_accuracy=float(predict_confusion(nominal, grid, level).top1[0]),
        accuracy=accuracy,
        deviation=deviation(h, nominal),
        closest=pair_distances(Responses(grid, h)).combined.min(axis=1),
        sobol=_sobol(scattered, made, outputs, base_samples, seed, report) if base_samples else {},
        noise=f"white, {level:g} Pa rms over 0 to 500 Hz" if isinstance(level, float) else level.source,
        seed=seed,
        fidelity=fidelity,
    )


def scattered_accuracy(
    design: DesignLike,
    frequency: FrequencyLike,
    *,
    sensors: int,
    tolerances: Sequence[Tolerance] = TOLERANCES,
    microphone_noise: NoiseChoice = "design",
    seed: int = 0,
    known: KnownDiscs | None = None,
    fidelity: str = "lumped",
    parts: int = 1,
) -> Array:
    """Predicted top-1 of sensors with manufacturing scatter and one localizer, trained on the nominal design.

    The same deviations for every design of a topology, so that designs are compared by what differs in them. Takes
    a second for the elastic solutions of the membranes, and about six milliseconds per sensor of 12 points.

    Args:
        design: the nominal array.
        frequency: (n_freq,) Hz, over 1 to 100 Hz, or FIRST:LAST:COUNT.
        sensors: number of sensors.
        tolerances: quantities that scatter.
        microphone_noise: as for :func:`scatter_effects`.
        seed: seed of the draws.
        known: membranes that need not be solved.
        fidelity: of all transfer functions.
        parts: number of parts into which the touches are divided; each sensor is touched by one of them.

    Returns:
        (sensors,) float64, 0 to 1.

    Raises:
        Refusal: a design that the batch does not take, or a grid that does not cover the band.
    """
    design = resolve_design(design)
    scattered, grid = ScatteredDesign(design, tolerances, known), frequency_grid(frequency)
    return _accuracy(scattered, grid, sensors, _noise(design, microphone_noise), seed, fidelity, parts)


def _accuracy(
    scattered: ScatteredDesign,
    grid: Array,
    sensors: int,
    noise: float | NoiseSpectrum,
    seed: int,
    fidelity: str,
    parts: int = 1,
) -> Array:
    drawn = AsBuiltSensors(scattered, grid, design_air(scattered.design), fidelity)
    h = drawn.transfer_functions(scattered.draws(0, sensors, seed))
    return predict_confusion(h, grid, noise, assumed=drawn.nominal, parts=parts).top1


def deviation(transfer_function: ComplexArray, nominal: ComplexArray) -> Array:
    """Deviation of sensors: rms over points, microphone pairs and frequencies of |log(r / r_nominal)|, r = H_a / H_b.

    Args:
        transfer_function: (n_sample, n_point, n_microphone, n_freq) complex128, Pa/Pa.
        nominal: (1, n_point, n_microphone, n_freq) complex128, Pa/Pa.

    Returns:
        (n_sample,) float64, nepers and radians.
    """
    change = np.log(transfer_function / nominal)
    first, second = np.triu_indices(change.shape[2], 1)
    ratio = change[:, :, first] - change[:, :, second]
    phase = ratio.imag - 2 * np.pi * np.round(ratio.imag / (2 * np.pi))
    return np.asarray(np.sqrt((ratio.real**2 + phase**2).mean(axis=(1, 2, 3))))


def sobol_indices(
    names: Sequence[str], at_a: Array, at_b: Array, mixed: Array, seed: int = 0, resamples: int = 100
) -> tuple[SobolIndex, ...]:
    """Sobol indices of groups of inputs, the largest total first.

    Args:
        names: of the groups.
        at_a: (n,) float64, outputs at the first half of the draws.
        at_b: (n,) float64, outputs at the second half.
        mixed: (n_group, n) float64, outputs at the first half with one group from the second.
        seed: of the bootstrap.
        resamples: of the bootstrap, how many.
    """
    at_a, at_b, mixed = (np.asarray(values, np.float64) for values in (at_a, at_b, mixed))

    def estimate(chosen: NDArray[np.int64]) -> tuple[Array, Array]:
        a, b, ab = at_a[chosen], at_b[chosen], mixed[:, chosen]
        variance = np.var(np.concatenate([a, b]))
        if variance == 0:
            return np.zeros(len(mixed)), np.zeros(len(mixed))
        centre = b - np.concatenate([a, b]).mean()
        return (centre * (ab - a)).mean(axis=1) / variance, ((a - ab) ** 2).mean(axis=1) / (2 * variance)

    first, total = estimate(np.arange(len(at_a)))
    random = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(2**32 - 1,)))
    again = np.array([estimate(random.integers(0, len(at_a), len(at_a)))[1] for _ in range(resamples)])
    columns = names, first.tolist(), total.tolist(), again.std(axis=0).tolist()
    indices = [SobolIndex(*entry) for entry in zip(*columns, strict=True)]
    return tuple(sorted(indices, key=lambda index: -index.total))


def _sobol(
    scattered: ScatteredDesign,
    made: Callable[[Mapping[str, Array]], ComplexArray],
    outputs: dict[str, Callable[[ComplexArray], Array]],
    base: int,
    seed: int,
    report: Callable[[str, float], None],
) -> dict[str, tuple[SobolIndex, ...]]:
    """Indices of every output for every tolerance."""
    names = [tolerance.quantity for tolerance in scattered.tolerances]
    # streams of their own: not the sensors that the accuracies are of
    first, second = (scattered.draws(0, base, seed + 1 + k) for k in (0, 1))
    mixtures = [first, second, *({**first, name: second[name]} for name in names)]
    found: dict[str, list[Array]] = {name: [] for name in outputs}
    for number, mixture in enumerate(mixtures):
        report("what matters most", 0.4 + 0.6 * number / len(mixtures))
        h = made(mixture)
        for name, output in outputs.items():
            found[name].append(output(h))
    return {name: sobol_indices(names, at[0], at[1], np.stack(at[2:]), seed) for name, at in found.items()}


def _noise(design: ArrayDesign, noise: NoiseChoice) -> float | NoiseSpectrum:
    return noise_model.microphone_noise(design.microphone, design_air(design)) if noise == "design" else noise


def _spread(values: Array) -> dict[str, float]:
    low, middle, high = np.quantile(values, [0.05, 0.5, 0.95]).tolist()
    return {"mean": float(values.mean()), "std": float(values.std()), "q05": low, "median": middle, "q95": high}


def _unit(tolerance: Tolerance) -> str:
    return "mm" if tolerance.kind == "absolute" else "1"

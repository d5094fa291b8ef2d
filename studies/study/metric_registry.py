"""The figures of merit of a design by name: unit, definition, and how they are computed for many designs at once.

A study names them (``metrics = ["distance_smallest", "predicted_top1"]``); docs/metrics.md explains each.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

import studies
from geometry import ArrayDesign
from geometry.ground.refusal import Kind, Refusal
from geometry.schema.field_errors import nearest
from localize.signals.stimulus import BAND
from studies.metrics import build, touch_metrics
from studies.metrics.batch_responses import Responses, required
from studies.metrics.confusion import check_grid as check_confusion_grid
from studies.metrics.covered_area import coverage
from studies.metrics.pairs import check_band
from studies.metrics.shared import SWEPT_SENSORS, SharedFigures

if TYPE_CHECKING:
    from acoustic_fem import Library
    from acoustic_fem.membrane.disc import KnownDiscs

Values = NDArray[np.float64]


@dataclass(frozen=True)
class Metric:
    """Figure of merit: its name, definition and computation."""

    name: str
    """Name by which a study asks for it."""
    unit: str
    """Unit of the values, "1" for ratios."""
    long_name: str
    """Title for axes and tables, a few words."""
    definition: str
    """Definition in one or two sentences."""
    compute: Callable[[SharedFigures], Values]
    """Function from the responses of a batch to values (n_design,) float64."""
    needs: frozenset[str] = frozenset()
    """Fields of :class:`studies.metrics.Responses` beside frequency and transfer function that must not be None."""
    better: str = "larger"
    """Word for the values that a designer wants, "larger" or "smaller"."""
    band: tuple[float, float] | None = None
    """Lowest and highest frequency of its definition, Hz, which the grid must cover."""
    slopes: Callable[[ArrayDesign, Sequence[str], KnownDiscs | None], tuple[float, Values]] | None = None
    """Function of a design, dotted names of its fields and membranes that need not be solved: the logarithm of the
    value, and its derivatives by the logarithms of the fields, (n_name,) float64. None where there is none."""
    noise_levels: tuple[float | None, ...] = ()
    """Levels of the noise of the confusions that it is made of, as :meth:`studies.metrics.SharedFigures.confusion`
    takes them."""
    caution: str = ""
    """Caution to whoever ranks designs by it alone, one sentence; empty where there is none."""
    extras: tuple[str, ...] = ()
    """Extras of the installation that compute it, see :mod:`geometry.ground.extras`."""

    @property
    def words(self) -> dict[str, str]:
        """Title, unit, definition and the better direction, for a page."""
        return {
            "title": self.long_name,
            "unit": self.unit,
            "definition": self.definition,
            "better": self.better,
        }

    def check_grid(self, frequency: Values) -> None:
        """Refuse a grid that does not cover the band: the value would not be what its definition says.

        Args:
            frequency: (n_freq,) float64, Hz, ascending.

        Raises:
            Refusal: it does not, its steps are wider than half the band, or it is too coarse for a confusion.
        """
        if self.band is not None:
            check_band(frequency, self.band, self.name)
        if self.noise_levels:
            check_confusion_grid(frequency)

    def of_batch(self, responses: Responses, figures: SharedFigures | None = None) -> Values:
        """Value of each design of a batch; (n_design,) float64, in the unit of the metric.

        Args:
            responses: of the designs.
            figures: what several metrics of these responses share, where there are several.

        Raises:
            Refusal: something the metric needs is missing, or the grid does not reach over its band.
        """
        missing = sorted(name for name in self.needs if getattr(responses, name) is None)
        if missing:
            problem = f"has no {', '.join(missing)}, which metric {self.name} needs"
            raise Refusal(problem, kind=Kind.MISSING, field="responses")
        self.check_grid(responses.frequency)
        return np.asarray(self.compute(figures or SharedFigures(responses)), np.float64)

    def of_library(self, library: Library) -> float:
        """Value of one design.

        Raises:
            Refusal: as :meth:`of_batch`.
        """
        return float(self.of_batch(Responses.of_library(library))[0])


def metrics_named(names: Iterable[str]) -> tuple[Metric, ...]:
    """Metrics of these names, in their order.

    Raises:
        Refusal: an unknown name, with the nearest known one.
    """
    found = []
    for name in names:
        if name not in METRICS:
            raise Refusal(kind=Kind.UNKNOWN, field="metrics", value=name, remedy=nearest(str(name), list(METRICS)))
        found.append(METRICS[name])
    return tuple(found)


def _of_distances(
    field: str, reduce: Callable[..., Values], band: tuple[float, float], figures: SharedFigures
) -> Values:
    return reduce(getattr(figures.distances(band), field), axis=1)


_OVER = "The rms is taken over 1 to 100 Hz and over all pairs of microphones."
_EXTENTS = {"smallest": "Smallest value over all", "mean": "Mean over all"}
#: Where slow presses and pulse waves have their energy, Hz.
LOW_BAND = (1.0, 20.0)
_IGNORES_NOISE = (
    "Distances of points ignore noise, so ranking by them alone favours narrow bores, whose signals are weak; look at "
    "an accuracy or a sensitivity beside them."
)


def _separation() -> Iterable[Metric]:
    for kind, field, unit, title, what in (
        ("ild", "level", "dB", "level difference", "20 log10 |r_i / r_j|"),
        ("ipd", "phase", "degree", "phase difference", "arg(r_i / r_j), between -180 and 180 degrees"),
        (
            "distance",
            "combined",
            "1",
            "distance",
            "|log(r_i / r_j)|, with the level in nepers and the phase in radians",
        ),
    ):
        for extent, reduce in (("smallest", np.min), ("mean", np.mean)):
            yield Metric(
                name=f"{kind}_{extent}",
                unit=unit,
                long_name=f"{extent} {title} of two points",
                definition=f"{_EXTENTS[extent]} pairs of points i and j of the rms of {what}. {_OVER}",
                compute=partial(_of_distances, field, reduce, BAND),
                band=BAND,
                caution=_IGNORES_NOISE,
            )
    for extent, reduce in (("smallest", np.min), ("mean", np.mean)):
        yield Metric(
            name=f"distance_{extent}_low",
            unit="1",
            long_name=f"{extent} distance of two points below {LOW_BAND[1]:g} Hz",
            definition=f"Like distance_{extent}, but over {LOW_BAND[0]:g} to {LOW_BAND[1]:g} Hz only.",
            compute=partial(_of_distances, "combined", reduce, LOW_BAND),
            band=LOW_BAND,
            caution=_IGNORES_NOISE,
        )


def _top1(level: float | None, figures: SharedFigures) -> Values:
    return figures.confusion(level).top1


def _hardest_pair(level: float | None, figures: SharedFigures) -> Values:
    return np.asarray(figures.confusion(level).pairwise.max(axis=(1, 2)))


#: Incoherent white noise at each microphone, Pa rms over 0 to 500 Hz: a stand-in for what transfer functions leave out.
WHITE_NOISE = 0.05


def _predicted() -> Iterable[Metric]:
    for suffix, level, where, needs in (
        ("", None, "the noise of the design's microphone", frozenset({"designs", "medium"})),
        (
            *("_white_noise", WHITE_NOISE),
            *(
                f"incoherent white noise of {WHITE_NOISE:g} Pa rms over 0 to 500 Hz at each microphone",
                frozenset[str](),
            ),
        ),
    ):
        yield Metric(
            name=f"predicted_top1{suffix}",
            unit="1",
            long_name=f"predicted top-1 accuracy{', 0.05 Pa of noise' * bool(level)}",
            definition="Fraction of simulated touches that a trained network is predicted to assign to the correct "
            f"point, with {where} and 64 multi-sine touches per point.",
            compute=partial(_top1, level),
            needs=needs,
            band=BAND,
            noise_levels=(level,),
            extras=("train",),
        )
        yield Metric(
            name=f"confused_pair{suffix}",
            unit="1",
            long_name=f"confusion of the hardest pair{', 0.05 Pa of noise' * bool(level)}",
            definition="Fraction of touches of the two points of the hardest pair for which the other point of the "
            f"pair is more likely than the touched one, with {where}. Chance is 0.5.",
            compute=partial(_hardest_pair, level),
            needs=needs,
            better="smaller",
            band=BAND,
            noise_levels=(level,),
            extras=("train",),
        )


#: Sensors with manufacturing scatter of ``scattered_top1``, with the same deviations for every design of a topology.
SENSORS = 64
#: Parts into which the 64 touches of ``scattered_top1`` are divided. Each sensor is touched by one of them, because
#: sensors differ more than touches do: the mean of 64 sensors changes by 0.2 percentage points rms.
PARTS = 8


def _scattered_top1(figures: SharedFigures) -> Values:
    own = figures.responses

    def of_design(design: ArrayDesign) -> float:
        return float(
            studies.scatter.scattered_accuracy(
                design, own.frequency, sensors=SENSORS, known=own.discs, parts=PARTS
            ).mean()
        )

    return _of_designs(of_design, figures)


def _scatter_detection(figures: SharedFigures) -> Values:
    from studies.metrics.scatter_detection import scatter_detection

    own = figures.responses
    return scatter_detection(required(own.designs), own.discs, own.parameters)


def _scatter_slopes(design: ArrayDesign, names: Sequence[str], discs: KnownDiscs | None) -> tuple[float, Values]:
    from studies.metrics.scatter_detection import scatter_slopes

    return scatter_slopes(design, names, discs)


def _as_built(touch: str, figures: SharedFigures) -> Values:
    return figures.as_built(touch)


def _as_built_accuracies() -> Iterable[Metric]:
    for touch, title in (("taps", "taps"), ("presses", "presses"), ("multi_sines", "multi-sine touches")):
        yield Metric(
            name=f"as_built_{touch}",
            unit="1",
            long_name=f"predicted top-1 accuracy of as-built sensors, {title}",
            definition=f"Mean fraction of {title}, as a run has them, that the tolerance-aware decoder assigns to the "
            f"correct point on {SWEPT_SENSORS} as-built sensors (acoustic_fem.scatter.UNCALIBRATED) that nobody "
            "calibrated. Predicted in frequency bins with lumped fidelity.",
            compute=partial(_as_built, touch),
            needs=frozenset({"designs"}),
            extras=("train",),
        )


def _forgiving() -> Iterable[Metric]:
    yield Metric(
        "scattered_top1", "1", "predicted top-1 accuracy of sensors with manufacturing scatter",
        f"Mean predicted top-1 accuracy of {SENSORS} as-built sensors (acoustic_fem.scatter.TOLERANCES) with a "
        "localizer that is trained on the nominal design, with the noise of the design's microphone. Each sensor is "
        "touched eight times per point. Computed with lumped fidelity; takes 40 ms per design of 12 points.",
        _scattered_top1, frozenset({"designs"}), band=BAND, extras=("train",),
    )  # fmt: skip
    yield Metric(
        "scatter_detection", "1", "ranking score under manufacturing scatter",
        "Score that ranks designs for as-built sensors (acoustic_fem.scatter.UNCALIBRATED); it is not an error "
        "rate and may exceed 1. For a decoder of the nominal design, the probability that another point is more "
        "likely than the touched one is summed over all other points and averaged over the touched ones. This mean to "
        "the power 5/6 is multiplied by the fourth-power mean, which weighs the worst pairs, to the power 1/6. "
        "Computed to first order at eight frequencies with lumped fidelity.",
        _scatter_detection, frozenset({"designs"}), "smaller", slopes=_scatter_slopes,
    )  # fmt: skip


def _verdict(figures: SharedFigures) -> Values:
    from studies.verdict.rules import OUTCOMES
    from studies.verdict.swept_verdicts import swept_outcomes

    own = figures.responses
    outcomes = swept_outcomes(required(own.designs), figures.swept, own.discs)
    return np.array([1 - OUTCOMES.index(outcome) / (len(OUTCOMES) - 1) for outcome in outcomes])


def _judged() -> Iterable[Metric]:
    yield Metric(
        "verdict", "1", "verdict",
        "Worst outcome of all rules of studies.Verdict: 1 for a design that works, 0.5 for a marginal one, and 0 for "
        "one that does not work. Takes up to a tenth of a second per design of 12 points.",
        _verdict, frozenset({"designs"}), extras=("train",),
    )  # fmt: skip


def _touches() -> Iterable[Metric]:
    worst = "rms over 1 to 100 Hz, at the loudest microphone, for the point where this is smallest"
    yield Metric(
        "sensitivity_force", "Pa/N", "sensitivity to force", f"Microphone pressure per force on the membrane: {worst}.",
        lambda figures: touch_metrics.smallest_sensitivity(figures.responses, figures.touch_response("force")),
        touch_metrics.NEEDS, band=BAND,
    )  # fmt: skip
    yield Metric(
        "sensitivity_displacement", "Pa/um", "sensitivity to displacement",
        f"Microphone pressure per displacement of the touched patch: {worst}.",
        lambda figures: (
            1e-6 * touch_metrics.smallest_sensitivity(figures.responses, figures.touch_response("displacement"))
        ),
        touch_metrics.NEEDS, band=BAND,
    )  # fmt: skip
    yield Metric(
        "noise_equivalent_force", "N", "noise-equivalent force",
        "Rms force with a flat spectrum from 1 to 100 Hz whose signal equals the thermal noise and the noise of the "
        "microphones, with all microphones combined optimally, for the point where this force is largest.",
        lambda figures: touch_metrics.noise_equivalent_force(figures.responses, figures.touch_response("force")),
        touch_metrics.NOISE_NEEDS, "smaller", BAND,
    )  # fmt: skip
    yield Metric(
        "bandwidth", "Hz", "bandwidth",
        "Width of the frequency range around the maximum in which the pressure per force at the point's loudest "
        "microphone is within 3 dB of this maximum, for the point where this range is narrowest.",
        lambda figures: touch_metrics.bandwidth(figures.responses, figures.touch_response("force")),
        touch_metrics.NEEDS,
    )  # fmt: skip


def _build() -> Iterable[Metric]:
    for name, unit, long_name, definition, compute, better in (
        ("coverage", "1", "coverage", "Fraction of the area in which a contact of the radius target.contact_radius "
         "reaches a membrane. The area is the convex hull of all membranes in plan, or the region of a body.",
         partial(_of_designs, coverage), "larger"),
        ("length", "mm", "length", "Longer side of the box around the whole array, with its tubes and boards.",
         lambda figures: figures.sizes[:, 0], "smaller"),
        ("width", "mm", "width", "Shorter side of that box.", lambda figures: figures.sizes[:, 1], "smaller"),
        ("height", "mm", "height", "Height of the array, from the lowest floor to the highest membrane or microphone.",
         lambda figures: figures.sizes[:, 2], "smaller"),
        ("volume", "mm^3", "volume of all parts",
         "Volume of shells, housings, boards, membranes and tubes, without their air.",
         partial(_of_parts, build.volume), "smaller"),
        ("mass", "g", "mass", "Mass of the parts that `volume` counts and of the microphones.",
         partial(_of_parts, build.mass), "smaller"),
        ("cost", "USD", "cost of materials", "Cost of the bill of materials for one array, without molds.",
         partial(_of_parts, build.cost), "smaller"),
        ("smallest_wall", "mm", "thinnest printed wall",
         "Thickness of the thinnest wall, floor, lip or cover of a socket.",
         partial(_of_designs, build.smallest_wall), "larger"),
    ):  # fmt: skip
        yield Metric(
            name=name, unit=unit, long_name=long_name, definition=definition, needs=frozenset({"designs"}),
            better=better, compute=compute,
        )  # fmt: skip


def _of_designs(of_design: Callable[[ArrayDesign], float], figures: SharedFigures) -> Values:
    return np.array([of_design(design) for design in required(figures.responses.designs)])


def _of_parts(of_design: Callable[[ArrayDesign, build.Volumes], float], figures: SharedFigures) -> Values:
    designs = required(figures.responses.designs)
    return np.array([of_design(*each) for each in zip(designs, figures.volumes, strict=True)])


#: All metrics by name.
METRICS: dict[str, Metric] = {
    metric.name: metric
    for metrics in (_separation(), _predicted(), _as_built_accuracies(), _forgiving(), _judged(), _touches(), _build())
    for metric in metrics
}

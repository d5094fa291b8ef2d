"""Quantities that a comparison lists: title, unit, the better direction, and how a value is written."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from studies.output.display import number
from studies.output.report_texts import percent
from studies.study.metric_registry import METRICS, metrics_named
from studies.verdict.rules import OUTCOMES

#: Metrics of a design that tables and the studio list, by the names by which a study asks for them.
FIGURES = (
    "predicted_top1", "predicted_top1_white_noise", "confused_pair", "distance_smallest", "ild_smallest",
    "ipd_smallest", "scatter_detection", "sensitivity_force", "noise_equivalent_force", "bandwidth", "coverage",
    "length", "width", "height", "volume", "mass", "cost", "smallest_wall",
)  # fmt: skip
#: Metrics that are fractions and are written as percentages.
_FRACTIONS = frozenset({"predicted_top1", "predicted_top1_white_noise", "confused_pair", "coverage"})
#: Accuracies nearer to each other than this are called equal: their touches are drawn at random.
ACCURACY_STEP = 0.005
#: Values nearer to each other than this fraction of the better one are called equal: they look alike when written.
_ALIKE = 5e-3
_PREFIXES = ((1.0, ""), (1e-3, "m"), (1e-6, "\N{MICRO SIGN}"), (1e-9, "n"), (1e-12, "p"))

#: Groups of a table in their order: what a designer asks first, then the rest.
OVERVIEW, REASONS, ACCURACY, APART, SIGNALS, BUILD, TRAINED, STORED, ORIGIN = (
    "Overview",
    "Reasons",
    "Accuracy",
    "Separability",
    "Signals",
    "Parts",
    "As trained by the run",
    "As stored with the case",
    "Origin",
)
GROUPS = (OVERVIEW, REASONS, ACCURACY, APART, SIGNALS, BUILD, TRAINED, STORED, ORIGIN)

Value = float | str
"""Value of a quantity: a number in its unit, or a text."""


@dataclass(frozen=True)
class Quantity:
    """Quantity of a comparison."""

    name: str
    """Name for programs."""
    title: str
    """Title of a row, a few words."""
    group: str
    """Group of the table, one of :data:`GROUPS`."""
    unit: str = ""
    """Unit of the values; empty for ratios and texts."""
    better: str = ""
    """Word for the values that a designer wants, "larger" or "smaller"; empty where there is no better one."""
    definition: str = ""
    """Definition in one or two sentences."""
    fraction: bool = False
    """True if it is a fraction that is written as a percentage."""
    step: float = 0.0
    """Difference up to which two values are called equal, in the unit."""
    order: tuple[str, ...] = ()
    """Texts that it may be, the best first; empty for numbers and for texts without an order."""

    def best(self, values: Iterable[Value | None]) -> tuple[int, ...]:
        """Indices of the subjects that are better than the others; none if all known values are equal.

        Args:
            values: of each subject, in the unit; None where it is not known.
        """
        ranks = {place: self._rank(value) for place, value in enumerate(values) if value is not None}
        known = {place: rank for place, rank in ranks.items() if rank is not None}
        if len(known) < 2:
            return ()
        top = max(known.values())
        alike = 0.0 if self.order else max(self.step, _ALIKE * abs(top))
        best = tuple(place for place, rank in known.items() if rank >= top - alike)
        return best if len(best) < len(known) else ()

    def _rank(self, value: Value) -> float | None:
        """Number that is larger for a better value; None where there is no better one."""
        if self.order:
            return -float(self.order.index(value)) if value in self.order else None
        if not self.better or isinstance(value, str):
            return None
        return value if self.better == "larger" else -value

    def written(self, values: Iterable[Value | None]) -> list[str]:
        """Values as people read them, with the unit; a row of forces has one prefix. Empty where not known."""
        row = list(values)
        scale, prefix = self._prefix(row)
        return [self._written(value, scale, prefix) for value in row]

    def _prefix(self, row: list[Value | None]) -> tuple[float, str]:
        sizes = [abs(value) for value in row if isinstance(value, (int, float)) and value]
        if self.unit != "N" or not sizes:
            return 1.0, ""
        return next((pair for pair in _PREFIXES if max(sizes) >= pair[0]), _PREFIXES[-1])

    def _written(self, value: Value | None, scale: float, prefix: str) -> str:
        if value is None:
            return ""
        if isinstance(value, str):
            return value
        if self.fraction:
            return percent(value)
        unit = self.unit.replace("^3", "\N{SUPERSCRIPT THREE}")
        return f"{number(value / scale)} {prefix}{unit}".rstrip()


#: Titles of metrics that say more than their own, because other accuracies stand beside them.
_TITLES = {
    "predicted_top1": "nominal accuracy of a trained network, multi-sine touches",
    "predicted_top1_white_noise": "nominal accuracy of a trained network, 0.05 Pa of noise",
}


def of_metric(name: str, group: str) -> Quantity:
    """Quantity of a metric of a study, with its own title, unit and definition."""
    metric = METRICS[name]
    accuracy = name.startswith("predicted_top1")
    return Quantity(
        name,
        _TITLES.get(name, metric.long_name),
        group,
        "" if metric.unit == "1" else metric.unit,
        metric.better,
        metric.definition,
        fraction=name in _FRACTIONS,
        step=ACCURACY_STEP if accuracy or name == "confused_pair" else 0.0,
    )


def figure_words() -> dict[str, dict[str, str]]:
    """Title, unit, definition and the better direction of each of :data:`FIGURES`, by name."""
    return {metric.name: metric.words for metric in metrics_named(FIGURES)}


#: Group of each metric of :data:`FIGURES` that is not in the group of the parts.
_GROUP_OF = {
    **dict.fromkeys(("length", "width", "height", "cost"), OVERVIEW),
    **dict.fromkeys(("predicted_top1", "predicted_top1_white_noise", "confused_pair"), ACCURACY),
    **dict.fromkeys(("distance_smallest", "ild_smallest", "ipd_smallest", "scatter_detection"), APART),
    **dict.fromkeys(("noise_equivalent_force", "sensitivity_force", "bandwidth"), SIGNALS),
}
PRINT_VERDICTS = ("ok", "warn", "fail")
"""Verdicts of the print rules, the best first."""
#: Kinds of touches that accuracies are predicted for, and their names in words.
TOUCH_WORDS = {"taps": "taps", "presses": "presses", "multi_sines": "multi-sine touches"}
_METRICS = {name: of_metric(name, _GROUP_OF.get(name, BUILD)) for name in FIGURES}
_OWN = (
    Quantity("verdict", "verdict", OVERVIEW, order=OUTCOMES,
             definition="Verdict of acoustic-fem check."),
    Quantity("reason", "worst reason", REASONS, definition="Rule of the verdict that is broken worst."),
    Quantity("smallest_force", "smallest tap", OVERVIEW, "N", "smaller",
             "Smallest force of a tap that every point can locate: it must stand out of the noise at two microphones."),
    *(Quantity(f"as_built_{touch}", f"as-built accuracy of {words}", OVERVIEW if touch == "taps" else ACCURACY,
               better="larger", fraction=True, step=ACCURACY_STEP,
               definition=f"Predicted top-1 accuracy for {words}: mean over 64 as-built sensors that nobody "
               "calibrated, with the tolerance-aware decoder. The range in brackets held the accuracy of sensors "
               "decoded in full for 9 of 10 designs.") for touch, words in TOUCH_WORDS.items()),
    *(Quantity(f"nominal_{touch}", f"nominal accuracy of {words}", ACCURACY, better="larger", fraction=True,
               step=ACCURACY_STEP, definition=f"The as-built accuracy for {words}, but of the sensor as designed.")
      for touch, words in TOUCH_WORDS.items()),
    Quantity("hardest_pair", "hardest pair of points", APART,
             definition="Two points whose ratios of microphone signals have the smallest distance."),
    *(Quantity(f"level_{hertz}_hz", f"level of the weakest point at {hertz} Hz", SIGNALS, "dB", "larger",
               "Level 20 log |H| of the point that is weakest at its second-loudest microphone, because a ratio needs "
               "two microphones.") for hertz in (10, 100)),
    Quantity("points", "points", BUILD), Quantity("microphones", "microphones", BUILD),
    Quantity("lines", "lines", BUILD),
    Quantity("printing", "print verdict", BUILD, order=PRINT_VERDICTS,
             definition="Verdict of the print rules on the drawn parts."),
    Quantity("problems", "problems of building it", BUILD, better="smaller",
             definition="Number of overlaps, misfits and failed print rules."),
    Quantity("fidelity", "fidelity", ORIGIN, definition="Model of the cells behind the figures and curves."),
    Quantity("frequencies", "frequencies", ORIGIN),
    Quantity("air", "air", ORIGIN),
    Quantity("target", "force and contact", ORIGIN,
             definition="Force and contact radius of the target, which the verdict and the accuracies are for."),
    Quantity("given", "given as", ORIGIN),
)  # fmt: skip
#: Order of the rows within the groups of a table; names that are not listed follow.
_ORDER = (
    "verdict", "as_built_taps", "smallest_force", "length", "width", "height", "cost",
    "as_built_presses", "as_built_multi_sines", "nominal_taps", "nominal_presses", "nominal_multi_sines",
    "hardest_pair", "distance_smallest", "ild_smallest", "ipd_smallest", "scatter_detection",
    "points", "microphones", "lines", "coverage", "printing", "problems",
)  # fmt: skip
_ALL: Mapping[str, Quantity] = {**_METRICS, **{each.name: each for each in _OWN}}


def quantity_named(name: str) -> Quantity:
    """Quantity of a name: those of a design and a library, ``trained.*`` of a run, ``stored.*`` of a sweep's case, and
    ``fact.*`` of the origin.
    """
    if name in _ALL:
        return _ALL[name]
    kind, _, own = name.partition(".")
    if kind == "trained":
        return Quantity(name, own, TRAINED, better="larger", fraction=True, step=ACCURACY_STEP,
                        definition="Top-1 accuracy that the run measured on simulated touches; that of the worst "
                        "sensor in brackets.")  # fmt: skip
    if kind == "stored":
        found = of_metric(own, STORED)
        return Quantity(**{**found.__dict__, "name": name})
    return Quantity(name, own, ORIGIN)


def in_order(names: Iterable[str]) -> list[str]:
    """Names of quantities in the order of a table."""
    known = list(dict.fromkeys(names))
    places = {name: place for place, name in enumerate(_ORDER)}
    return sorted(known, key=lambda name: (GROUPS.index(quantity_named(name).group), places.get(name, len(places))))

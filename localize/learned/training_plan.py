"""How a localizer is trained: a choice, which loads nothing of what it names until it is made."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any, Literal

import localize
from geometry.ground.refusal import Kind, Refusal
from localize.learned.network_sizes import NETWORKS
from localize.signals.disturbances import ROOM_LEVELS, MicrophoneMismatch, check_ambient
from localize.signals.stimulus import StimulusSource

if TYPE_CHECKING:
    from localize.learned.features import FeatureChoice
    from localize.signals.array_response import ArrayResponse
    from localize.signals.noise_model import NoiseChoice

HYPOTHESES = "hypotheses"
"""Name of the network of :mod:`localize.learned.hypothesis_network`."""
LOCALIZER_NETWORKS = (HYPOTHESES, *NETWORKS)
"""Names of the networks that locate touches."""
TOUCHES = (36_000, 12_000)
"""Number of touches of an epoch where a plan does not say how many of each point: of up to :data:`FEW_POINTS`, and the
least of larger arrays. Every touch of these is compared with more points."""
FEW_POINTS = 12
"""Number of points of the arrays that have the most touches."""
PLANS = ("usual", "maps", "paper")
"""Names of the plans of :meth:`TrainingPlan.of`."""

#: Fields that every plan of a training has, and their ranges.
WHOLE = {"epochs": (1, 10_000), "batch": (2, 65_536), "seed": (0, 2**63 - 1), "warm_up_steps": (1, 1_000_000)}
REAL = {
    "learning_rate": (1e-8, 1.0),
    "weight_decay": (0.0, 1.0),
    "microphone_noise": (0.0, 100.0),
    "time_limit": (1e-3, 1e9),
    "settling_fraction": (0.0, 1.0),
    "checkpoint_interval": (0.0, 1e9),
}


def check_ranges(
    field: dict[str, Any],
    whole: dict[str, tuple[int, int]],
    real: dict[str, tuple[float, float]],
    networks: Collection[str],
) -> None:
    """Refuse a plan with a field out of range, or a network that nobody knows.

    Args:
        field: the fields of the plan by name.
        whole: lowest and highest value of the whole numbers that it alone has, by name.
        real: of its other numbers.
        networks: names of the networks that it may ask for.

    Raises:
        Refusal: field, value and range.
    """
    for name, (least, most) in (whole | WHOLE).items():
        value = field[name]
        if (name, value) == ("seconds_per_point", None):
            continue
        if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
            raise Refusal(
                kind=Kind.OUT_OF_RANGE, field=name, value=value, allowed=f"a whole number from {least} to {most}"
            )
    for name, (low, high) in (real | REAL).items():
        value = field[name]
        if (name, value) in (("time_limit", None), ("microphone_noise", "design")):
            continue
        if isinstance(value, str) or not low <= value <= high:
            raise Refusal(kind=Kind.OUT_OF_RANGE, field=name, value=value, allowed=f"between {low:g} and {high:g}")
    if field["network"] not in networks:
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="network", value=field["network"], allowed=networks)


def identity_of(plan: Any) -> dict[str, Any]:
    """Fields of a plan, a frozen data class, that its training's result depends on."""
    return {name: value for name, value in asdict(plan).items() if name != "checkpoint_interval"}


@dataclass(frozen=True)
class TrainingPlan:
    """Plan of a training. The same plan on the same library and machine gives the same localizer.

    Raises:
        Refusal: a field outside its range, with field, value and range.
    """

    seconds_per_point: int | None = None
    """Number of one-second touches of every point in an epoch; each touch gives one frame, its last. None for
    :data:`TOUCHES` of all points together."""
    new_touches: bool = False
    """True if each epoch draws new touches; else all epochs have those of the first, in another order, which are kept
    in memory where there is room for them."""
    method: Literal["exact", "stft"] = "exact"
    """Path from the cavity to the microphones, as of :class:`localize.TouchGenerator`: exact, or products of
    short-window transforms, which are aliased. Held-out touches are made in the same way."""
    epochs: int = 6
    """Number of epochs."""
    held_out_fraction: float = 0.25
    """Number of held-out touches, drawn once from seeds of their own, as a fraction of an epoch's: 4 to 1, as in the
    paper."""
    batch: int = 128
    """Number of touches of a step."""
    learning_rate: float = 3e-3
    """Highest learning rate; a cosine takes it to zero."""
    weight_decay: float = 0.01
    """Weight decay of AdamW."""
    label_sigma: float = 0.0
    """Standard deviation over which labels are smoothed, in places; 0 for hard labels. The paper's 1 made half a
    percent more errors on array-2x6 with microphone noise, and its probabilities say too little of the point."""
    label_neighbours: Literal["line", "number"] = "line"
    """Neighbours that share a label: those on the same line, or those of the next numbers, so that the end of one line
    is a neighbour of the beginning of the next wherever that lies."""
    microphone_noise: NoiseChoice = "design"
    """Noise added to the training signals; held-out ones have the same. Pa rms over 0 to 500 Hz, white; or "design" for
    the noise of the microphone of the library's design, see :mod:`localize.signals.noise_model`."""
    microphone_gain: float = 0.0
    """Standard deviation of the microphones' gains, drawn anew for each touch, dB."""
    ambient: tuple[float, float] | Literal["rooms"] | None = None
    """Lowest and highest level of the sound outside, dB SPL, drawn anew for each touch; None for silence; "rooms" for
    :data:`localize.signals.disturbances.ROOM_LEVELS` where the library knows what sound does, silence where not."""
    stimuli: tuple[str, ...] = ("multi-sines", "tap-strokes", "press-strokes", "slide-strokes")
    """Kinds of touches, each as often as the others: names of :data:`localize.signals.stimulus_kinds.STIMULI`."""
    as_built: int = 3000
    """Number of as-built sensors that are touched, drawn with the tolerances of a sensor that nobody calibrated; 0 for
    the sensor of the library alone. A measured library, and one whose design's scatter is not known, is always
    alone."""
    designed_share: float = 1 / 6
    """Share of these sensors that are the sensor of the library."""
    high_passed: float = 0.7
    """Share of the touches that are behind the high-pass of a stream; the others are as they come."""
    touch_level: float = 0.0
    """Level of the touches above that of their sources, dB: noise and sound are then so much fainter beside them."""
    recorded: float = 0.5
    """Share of the touches that are frames of recordings, where there are recordings to train on."""
    seed: int = 0
    """Seed of touches, initial weights and splits."""
    time_limit: float | None = None
    """Time limit, s; None trains as planned, with the same result on a busy machine. Where the plan would take longer,
    training is cut short, the cosine still ending at zero: the result then depends on the speed of the machine, and
    ``training["cut_short"]`` of the localizer says so."""
    network: str = HYPOTHESES
    """Name of the network: "hypotheses" for :mod:`localize.learned.hypothesis_network`, or a convolutional one of
    :data:`localize.learned.network_sizes.NETWORKS`."""
    shapes: int = 6
    """Number of shapes in which a hypothesis deviates, at most; three lose 1 to 3 % of the presses."""
    features: FeatureChoice = "rooms"
    """Choice of a convolutional network's maps, see :mod:`localize.learned.features`; "rooms" is "phasors" where
    touches have no sound around them."""
    bfloat16: bool = False
    """True if the network computes in bfloat16 while it is trained: the paper's is a third faster where the
    processor has instructions for it, and slower elsewhere. Weights and finished localizer are in single precision."""

    warm_up_steps: int = 20
    """Number of steps over which the learning rate rises: a fresh batch normalisation does not bear the full one."""
    settling_fraction: float = 0.25
    """Fraction of a time limit after which the speed of training is estimated: the first steps are slow."""
    checkpoint_interval: float = 60.0
    """Time between checkpoints within an epoch, s; there is one at the end of every epoch too."""
    normalisation_touches: int = 20
    """Number of touches per point that the maps are normalised by."""
    run_length: int = 16
    """Number of consecutive touches that stay together where the touches of all epochs are those of the first: making
    them singly takes longer."""
    judged_frames: int = 64
    """Largest number of frames of a held-out recording that are judged, evenly spread."""

    def __post_init__(self) -> None:
        from localize.learned.features import map_count
        from localize.signals.stimulus_kinds import STIMULI

        check_ranges(
            vars(self),
            whole={
                "seconds_per_point": (1, 1_000_000),
                "as_built": (0, 1_000_000),
                "shapes": (0, 6),
                "normalisation_touches": (1, 10_000),
                "run_length": (1, 65_536),
                "judged_frames": (1, 1_000_000),
            },
            real={
                "held_out_fraction": (1e-6, 10.0),
                "label_sigma": (0.0, 100.0),
                "microphone_gain": (0.0, 20.0),
                "touch_level": (-60.0, 60.0),
                "recorded": (0.0, 1.0),
                "designed_share": (0.0, 1.0),
                "high_passed": (0.0, 1.0),
            },
            networks=LOCALIZER_NETWORKS,
        )
        if isinstance(self.ambient, str) and self.ambient != "rooms":
            raise Refusal(
                kind=Kind.OUT_OF_RANGE,
                field="ambient",
                value=self.ambient,
                allowed="'rooms', or the lowest and highest level, dB SPL",
            )
        if self.ambient is not None and self.ambient != "rooms":
            check_ambient(self.ambient)
        for stimuli in self.stimuli or ("",):
            if stimuli not in STIMULI:
                raise Refusal(
                    kind=Kind.OUT_OF_RANGE,
                    field="stimuli",
                    value=self.stimuli,
                    allowed=f"at least one of: {', '.join(STIMULI)}",
                )
        for name, allowed in (("method", ("exact", "stft")), ("label_neighbours", ("line", "number"))):
            if getattr(self, name) not in allowed:
                raise Refusal(kind=Kind.OUT_OF_RANGE, field=name, value=getattr(self, name), allowed=allowed)
        map_count(2, self.features)

    @classmethod
    def of(cls, name: str) -> TrainingPlan:
        """Plan by its name: the usual one, that of a convolutional network, or the paper's.

        Args:
            name: one of :data:`PLANS`.

        Raises:
            Refusal: another name.
        """
        if name not in PLANS:
            raise Refusal(kind=Kind.OUT_OF_RANGE, field="plan", value=name, allowed=PLANS)
        made: dict[str, Callable[[], TrainingPlan]] = {"usual": cls, "maps": cls.on_maps, "paper": cls.paper}
        return made[name]()

    @classmethod
    def on_maps(cls) -> TrainingPlan:
        """Plan of a convolutional network on maps: multi-sine touches of the sensor of the library, in room sound.

        It takes sound out of its maps where there are three microphones or more, and names only touches of the kind
        that it was trained on.
        """
        return cls(
            seconds_per_point=200,
            new_touches=True,
            epochs=20,
            batch=32,
            label_sigma=0.35,
            ambient="rooms",
            stimuli=("multi-sines",),
            as_built=0,
            high_passed=0.0,
            network="patches",
        )

    @classmethod
    def paper(cls) -> TrainingPlan:
        """Plan by which the paper trains its localizer on simulated touches.

        FasterNet on level and phase; 14,000 touches of every point, the same in all 30 epochs, of which one in five is
        held out; AdamW with a cosine from 1e-3; labels smoothed over one place of the classes in their order; touches
        by products of short-window transforms; no microphone noise, no sound.

        Ours, for want of a figure there: the window of the data, 32 samples with a hop of 16, which the paper states
        for reconstruction; the batch of 128 and the weight decay; one frame of each second, its last; the number of
        sinusoids drawn for each touch where the paper has 2,000 of each interval; Pa as the unit of the amplitudes;
        the width of the wavelets. Touches are made in Pa and maps normalised row by row, which the paper does not say.
        """
        return cls(
            seconds_per_point=11_200,
            new_touches=False,
            method="stft",
            epochs=30,
            held_out_fraction=0.25,
            batch=128,
            learning_rate=1e-3,
            label_sigma=1.0,
            label_neighbours="number",
            microphone_noise=0.0,
            stimuli=("multi-sines",),
            as_built=0,
            high_passed=0.0,
            network="paper",
            features="paper",
        )

    def sound(self, response: ArrayResponse) -> tuple[float, float] | None:
        """Lowest and highest level of the sound outside that touches on an array have, dB SPL; None for silence."""
        if self.ambient != "rooms":
            return self.ambient
        return None if response.ambient_response is None else ROOM_LEVELS

    def maps(self, response: ArrayResponse) -> FeatureChoice:
        """Choice of the network's maps on an array."""
        return "phasors" if self.features == "rooms" and self.sound(response) is None else self.features

    def touches_per_point(self, points: int) -> int:
        """Number of touches of each of so many points in an epoch."""
        most, least = TOUCHES
        touches = min(most, max(least, most * FEW_POINTS / points))
        return self.seconds_per_point or math.ceil(touches / points)

    @property
    def source(self) -> StimulusSource:
        """Source of the stimuli: one kind, or a mixture of several, at the plan's level."""
        sources = tuple(localize.signals.STIMULI[name] for name in self.stimuli)
        source = sources[0] if len(sources) == 1 else localize.signals.Mixture(sources)
        return localize.signals.Louder(source, self.touch_level) if self.touch_level else source

    @property
    def mismatch(self) -> MicrophoneMismatch | None:
        """Scatter that the microphones' gains are drawn from; None where they are all alike."""
        return MicrophoneMismatch(self.microphone_gain) if self.microphone_gain else None

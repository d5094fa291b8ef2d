"""How a recognizer is trained: a choice, which loads nothing of what it names until it is made."""

from __future__ import annotations

from dataclasses import dataclass

from localize.learned.network_sizes import NETWORKS
from localize.learned.training_plan import check_ranges
from localize.signals.noise_model import NoiseChoice


@dataclass(frozen=True)
class RecognitionPlan:
    """Plan of the training of a recognizer. The same plan on the same library and machine gives the same one.

    Raises:
        Refusal: a field outside its range, with field, value and range.
    """

    takes: int = 300
    """Number of simulated takes of every kind, the same in every epoch; recordings replace them."""
    epochs: int = 15
    """Number of epochs."""
    batch: int = 64
    """Number of takes of a step."""
    learning_rate: float = 3e-3
    """Highest learning rate; a cosine takes it to zero."""
    weight_decay: float = 0.01
    """Weight decay of AdamW."""
    smoothing: float = 0.02
    """Share of a label that is spread over all kinds."""
    salt_and_pepper: float = 0.0
    """Share of the values of a map that are set to its lowest or highest, drawn anew in every step."""
    microphone_noise: NoiseChoice = "design"
    """Noise of the microphones: Pa rms over 0 to 500 Hz, white; or "design" for that of the library's design."""
    seed: int = 0
    """Seed of takes, initial weights and splits."""
    time_limit: float | None = None
    """Time limit of the training behind the takes, s; None trains as planned, with the same result on a busy
    machine."""
    network: str = "patches"
    """Name of the network's shape, one of :data:`localize.learned.network_sizes.NETWORKS`."""
    bfloat16: bool = False
    """True if the network computes in bfloat16 while it is trained."""
    warm_up_steps: int = 20
    """Number of steps over which the learning rate rises: a fresh batch normalisation does not bear the full one."""
    settling_fraction: float = 0.25
    """Fraction of a time limit after which the speed of training is estimated: the first steps are slow."""
    checkpoint_interval: float = 60.0
    """Time between checkpoints within an epoch, s; there is one at the end of every epoch too."""
    held_out_fraction: float = 0.25
    """Number of simulated takes that are held out, as a fraction of those that are trained on: 4 to 1."""
    passing: float = 1 / 3
    """Fraction of the simulated textures in which the contact passes the point; in the others it stays on it."""
    letter_speeds: tuple[float, float] = (25.0, 120.0)
    """Slowest and fastest speed at which simulated letters are written, mm/s."""
    letter_variants: int = 6
    """Number of pictures of each letter, each a little turned, moved and stretched."""
    letter_fonts: tuple[str, ...] = ("timesr", "timesi", "scriptc")
    """Stroke fonts of :data:`localize.recognition.stroke_fonts.FONTS` of which letters are written beside those of our
    own shapes, with the extra "fonts"; none for our shapes alone."""
    least_noise: float = 1e-5
    """Least noise that waveforms are made with, Pa rms: a filter for no noise at all amplifies rounding."""

    @classmethod
    def of(cls, subject: str) -> RecognitionPlan:
        """Plan of a subject: for letters 90 samples of each, small patches that need fewer epochs, the paper's salt
        and pepper; for textures half as many takes again, for a third of them pass their point.
        """
        if subject == "letters":
            return cls(
                takes=90,
                epochs=15,
                salt_and_pepper=0.05,
                network="small-patches",
                letter_variants=8,
                held_out_fraction=0.1,
            )
        return cls(takes=450) if subject == "textures" else cls()

    def __post_init__(self) -> None:
        check_ranges(
            vars(self),
            whole={"takes": (5, 1_000_000), "letter_variants": (1, 1000)},
            real={
                "smoothing": (0.0, 0.5),
                "salt_and_pepper": (0.0, 0.5),
                "held_out_fraction": (1e-6, 10.0),
                "passing": (0.0, 1.0),
                "least_noise": (1e-12, 1.0),
            },
            networks=NETWORKS,
        )

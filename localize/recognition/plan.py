"""How a recognizer is trained: a choice, which loads nothing of what it names until it is made."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from geometry.refusal import Refusal

if TYPE_CHECKING:
    from localize.signals.noise import NoiseChoice


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
    """Name of the network's shape, one of :data:`localize.learned.classifier.NETWORKS`."""
    bfloat16: bool = False
    """Whether the network computes in bfloat16 while it is trained."""

    @classmethod
    def of(cls, subject: str) -> RecognitionPlan:
        """Plan of a subject: for letters the paper's two stages of blocks, 60 samples of each and salt and pepper."""
        if subject == "letters":
            return cls(takes=60, epochs=10, salt_and_pepper=0.05, network="two-stage")
        return cls()

    def __post_init__(self) -> None:
        from localize.learned.classifier import NETWORKS

        for name, least, most in (
            ("takes", 5, 1_000_000),
            ("epochs", 1, 10_000),
            ("batch", 2, 65_536),
            ("seed", 0, 2**63 - 1),
        ):
            value = getattr(self, name)
            if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
                raise Refusal(f"{name} = {value!r} must be a whole number from {least} to {most}")
        for name, low, high in (
            ("learning_rate", 1e-8, 1.0),
            ("weight_decay", 0.0, 1.0),
            ("smoothing", 0.0, 0.5),
            ("salt_and_pepper", 0.0, 0.5),
            ("microphone_noise", 0.0, 100.0),
            ("time_limit", 1e-3, 1e9),
        ):
            value = getattr(self, name)
            if (name, value) in (("time_limit", None), ("microphone_noise", "design")):
                continue
            if isinstance(value, str) or not low <= value <= high:
                raise Refusal(f"{name} = {value!r} must be between {low:g} and {high:g}")
        if self.network not in NETWORKS:
            raise Refusal(f"network = {self.network!r} must be one of: {', '.join(NETWORKS)}")

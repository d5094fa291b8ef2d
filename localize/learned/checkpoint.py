"""The state of a training in one file, from which it goes on to the very same weights.

One safetensors file, written beside and renamed: whatever stops the process, the file on disk is a whole one, the last
or the one before it. Its metadata hold, as JSON, the progress and what the training is of, and a checksum of all; a
file of another training, and a damaged one, is refused.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import torch
from torch import Tensor, nn

from geometry.ground.file_checks import library_reads, read_bytes
from geometry.ground.record import is_sealed, sealed, sha256
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import parse_json
from geometry.ground.whole_files import whole_file
from localize.graphs.description import LARGEST_MODEL, described
from localize.learned.localizer_description import TrainingState
from localize.signals.touch_generator import TouchGenerator

FORMAT = "acoustic-fem checkpoint 2"
_MOMENTS = ("step", "exp_avg", "exp_avg_sq")
"""Names of the state that AdamW keeps for each parameter."""


class CheckpointError(Refusal):
    """Refusal of a checkpoint that cannot be gone on from: one line that names the file and the reason."""


@dataclass
class Progress:
    """Progress of a training."""

    step: int = 0
    """Number of steps that are done."""
    turned: float = 0.0
    """Share of the cosine that is behind."""
    seconds: float = 0.0
    """Time that training has taken, in all processes together, s."""
    losses: list[float] = field(default_factory=list)
    """Losses of the steps of the epoch under way."""
    curve: list[list[Any]] = field(default_factory=list)
    """Fields of :class:`localize.learned.epochs.TrainingProgress`, per epoch."""


def training_identity(plan: Mapping[str, Any], touches: TouchGenerator) -> dict[str, str]:
    """Facts that must agree for one training to be the continuation of another.

    Args:
        plan: fields of the plan, as JSON can hold them.
        touches: what it is trained on.
    """
    return {
        **{f"plan.{name}": json.dumps(value) for name, value in plan.items()},
        "transfer_function": touches.transfer_function_sha256(),
        "device": torch.device(touches.device).type,
        "torch": torch.__version__,
    }


class Checkpoint:
    """Checkpoint of one training: a file that is replaced as a whole.

    Args:
        path: of the file; its folder must exist.
        identity: from :func:`training_identity`.
    """

    def __init__(self, path: str | os.PathLike[str], identity: Mapping[str, str]) -> None:
        self.path = Path(path)
        self.identity = dict(identity)
        # What a process that was killed while writing has left behind.
        for stale in self.path.parent.glob(f".{self.path.stem}.*{self.path.suffix}"):
            stale.unlink(missing_ok=True)

    def save(self, network: nn.Module, optimizer: torch.optim.Optimizer, progress: Progress) -> None:
        """Replace the file by the present state."""
        from safetensors.torch import save

        tensors = {f"network.{name}": value for name, value in network.state_dict().items()}
        for number, state in optimizer.state_dict()["state"].items():
            tensors |= {f"optimizer.{number}.{name}": state[name] for name in _MOMENTS}
        tensors = {name: value.cpu().contiguous() for name, value in tensors.items()}
        metadata = {
            "format": FORMAT,
            "identity": json.dumps(self.identity),
            "progress": json.dumps(vars(progress)),
        }
        content = save(tensors, sealed(metadata, _content(tensors)))
        with whole_file(self.path) as beside:
            beside.write_bytes(content)

    def load(self, network: nn.Module, optimizer: torch.optim.Optimizer) -> Progress | None:
        """Take the state from the file, if there is one.

        Raises:
            CheckpointError: the file is damaged, no checkpoint, or that of another training.
        """
        from safetensors.torch import load

        if not self.path.exists():
            return None
        held = read_bytes(self.path, "a checkpoint", CheckpointError, LARGEST_MODEL)
        with library_reads(self.path, "a checkpoint", CheckpointError):
            tensors = load(held)
        said = _metadata(held)
        if said.get("format") != FORMAT:
            raise self._refused("is not a checkpoint of this version", Kind.MISMATCH)
        if not is_sealed(said, _content(tensors)):
            raise self._refused("is damaged: its SHA-256 differs from the recorded one", Kind.DAMAGED)
        progress = parse_json(said["progress"], str(self.path), CheckpointError)
        described(TrainingState, said["progress"], f"{self.path}: progress", CheckpointError)
        self._compare(parse_json(said["identity"], str(self.path), CheckpointError))
        network.load_state_dict(_with_prefix(tensors, "network."))
        parameters = optimizer.param_groups[0]["params"]
        state = {
            number: {
                name: _laid_out_as(parameter, tensors[f"optimizer.{number}.{name}"])
                for name in _MOMENTS
            }
            for number, parameter in enumerate(parameters)
            if f"optimizer.{number}.step" in tensors
        }  # fmt: skip
        optimizer.load_state_dict({**optimizer.state_dict(), "state": state})
        return Progress(**progress)

    def remove(self) -> None:
        """Delete the file: the training is done and its result is safe."""
        self.path.unlink(missing_ok=True)

    def _compare(self, found: Mapping[str, str]) -> None:
        for name in sorted({*self.identity, *found}):
            mine, other = (source.get(name, "absent") for source in (self.identity, found))
            if mine != other:
                readable = name != "transfer_function"
                what = f"{name} was {other}, is {mine}" if readable else f"{name} has changed"
                raise self._refused(f"is of another training: {what}", Kind.MISMATCH)

    def _refused(self, why: str, kind: Kind) -> CheckpointError:
        return CheckpointError(why, kind=kind, file=self.path, remedy="remove it to train anew")


def _metadata(held: bytes) -> dict[str, Any]:
    """Texts beside the tensors of a file that was read: after eight bytes with its length stands a table as JSON."""
    length = int.from_bytes(held[:8], "little")
    return dict(json.loads(held[8 : 8 + length]).get("__metadata__", {}))


def _content(tensors: Mapping[str, Tensor]) -> bytes:
    """Digest of tensors, each with its name, type and shape."""
    parts: list[str | bytes] = []
    for name in sorted(tensors):
        value = tensors[name].contiguous()
        parts += [f"{name} {value.dtype} {tuple(value.shape)}\n", value.numpy().tobytes()]
    return bytes.fromhex(sha256(*parts))


def _with_prefix(tensors: Mapping[str, Tensor], prefix: str) -> dict[str, Tensor]:
    return {name.removeprefix(prefix): value for name, value in tensors.items() if name.startswith(prefix)}


def _laid_out_as(parameter: Tensor, value: Tensor) -> Tensor:
    """The same values in the parameter's memory layout, without which sums may come in another order."""
    return torch.empty_like(parameter).copy_(value) if value.shape == parameter.shape else value

"""Files of networks: what they say of themselves, as schemas, and their weights."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Self, TypeVar, get_type_hints

import torch
from pydantic import ConfigDict, Discriminator, Field, Tag, create_model, model_validator
from torch import Tensor

from geometry.ground.file_checks import library_reads, read_bytes
from geometry.ground.record import is_sealed, sealed, sha256
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.text_files import parse_json
from geometry.ground.whole_files import made_folder, whole_file, write_text
from localize.graphs.description import (
    LARGEST_DESCRIPTION,
    LARGEST_MODEL,
    ArrayDescription,
    Count,
    Digest,
    Share,
    Strict,
    check_format,
    described,
)
from localize.learned.classifier import Classifier, NetworkShape, TouchClassifier
from localize.learned.features import FeatureChoice, map_count
from localize.learned.hypothesis_network import HypothesisClassifier, HypothesisShape
from localize.learned.training_plan import TrainingPlan
from localize.signals.noise_model import NoiseChoice

_Model = TypeVar("_Model", bound=Strict)
_Classifier = TypeVar("_Classifier", bound=Classifier)


class Network(Strict):
    """Fields of :class:`localize.learned.classifier.NetworkShape`, which checks how they go together."""

    maps: Annotated[int, Field(ge=1, le=1000)]
    points: Annotated[int, Field(ge=2, le=120_000)]
    width: Annotated[int, Field(ge=1, le=1024)]
    depths: Annotated[list[Annotated[int, Field(ge=1, le=32)]], Field(min_length=1, max_length=8)]
    patch: Annotated[list[Annotated[int, Field(ge=1, le=64)]], Field(min_length=2, max_length=2)]
    merge_last: bool
    features: FeatureChoice

    def shape(self) -> NetworkShape:
        """Sizes of the network.

        Raises:
            Refusal: sizes that do not go together.
        """
        cut = (self.patch[0], self.patch[1])
        return NetworkShape(**{**self.model_dump(), "depths": tuple(self.depths), "patch": cut})

    def fits(self, microphones: int) -> None:
        """Refuse a number of microphones that the network is not for."""
        maps = map_count(microphones, self.features)
        if self.maps != maps:
            allowed = f"{maps} for {counted(microphones, 'microphone')}"
            raise Refusal(kind=Kind.MISMATCH, field="network.maps", value=self.maps, allowed=allowed)


class HypothesisNetwork(Strict):
    """Fields of :class:`localize.learned.hypothesis_network.HypothesisShape`."""

    points: Annotated[int, Field(ge=2, le=120_000)]
    hypotheses: Annotated[int, Field(ge=1, le=1000)]
    microphones: Annotated[int, Field(ge=2, le=64)]
    size: Annotated[int, Field(ge=2, le=10_000)]
    rank: Annotated[int, Field(ge=1, le=10_000)]
    shapes: Annotated[int, Field(ge=0, le=64)]
    width: Annotated[int, Field(ge=1, le=1024)]

    def shape(self) -> HypothesisShape:
        """Sizes of the network.

        Raises:
            Refusal: sizes that do not go together.
        """
        return HypothesisShape(**self.model_dump())

    def fits(self, microphones: int) -> None:
        """Refuse a number of microphones that the network is not for."""
        if self.microphones != microphones:
            raise Refusal(
                kind=Kind.MISMATCH, field="network.microphones", value=self.microphones, allowed=str(microphones)
            )


class _Plan(Strict):
    @model_validator(mode="after")
    def _in_range(self) -> Self:
        TrainingPlan(**{name: getattr(self, name) for name in type(self).model_fields})
        return self


def _plan_model() -> type[_Plan]:
    """Schema of the fields of a plan, whose ranges it checks itself."""
    later = {"FeatureChoice": FeatureChoice, "NoiseChoice": NoiseChoice}
    kinds = get_type_hints(TrainingPlan, localns=later)
    fields: dict[str, Any] = {each.name: (kinds[each.name], each.default) for each in dataclasses.fields(TrainingPlan)}
    return create_model("Plan", __base__=_Plan, **fields)


if TYPE_CHECKING:
    Plan = _Plan
else:
    Plan = _plan_model()


class Training(Strict):
    """The record of a training; that of recordings comes on top."""

    model_config = ConfigDict(extra="allow")

    loss: Annotated[list[float], Field(max_length=10_000)]
    held_out_accuracy: Annotated[list[Share], Field(max_length=10_000)]
    epochs: Count
    touches: Count
    held_out_touches: Count
    seconds: Annotated[float, Field(ge=0)]
    cut_short: bool
    microphone_noise: Annotated[float, Field(ge=0, le=100)]
    sensors: Count
    device: str


def _kind_of_network(value: object) -> str:
    """Tag of the model of a network, told by a field that it alone has."""
    is_of_maps = "maps" in value if isinstance(value, dict) else isinstance(value, Network)
    return "(maps)" if is_of_maps else "(hypotheses)"


class LocalizerDescription(ArrayDescription):
    """Schema of ``localizer.json``."""

    format: str
    version: int
    weights: Annotated[str, Field(pattern=r"^weights-[0-9a-f]{12}\.safetensors$")]
    weights_sha256: Digest
    network: Annotated[
        Annotated[Network, Tag("(maps)")] | Annotated[HypothesisNetwork, Tag("(hypotheses)")],
        Discriminator(_kind_of_network),
    ]
    plan: Plan
    training: Training
    sha256: Digest

    @model_validator(mode="after")
    def _fits(self) -> Self:
        if len(self.line) != self.network.points:
            raise Refusal(
                f"line and place must hold {self.network.points} values, as network.points says", kind=Kind.MISMATCH
            )
        self.network.fits(len(self.microphones))
        return self


def classifier_of(shape: NetworkShape | HypothesisShape, microphones: int) -> TouchClassifier | HypothesisClassifier:
    """Network of some sizes, whose weights are not yet those of any training."""
    return HypothesisClassifier(shape) if isinstance(shape, HypothesisShape) else TouchClassifier(microphones, shape)


class TrainingState(Strict):
    """Fields of :class:`localize.learned.checkpoint.Progress`."""

    step: Count
    turned: Share
    seconds: Annotated[float, Field(ge=0)]
    losses: list[float]
    curve: Annotated[list[tuple[Count, Count, float, Share, float, dict[str, Share]]], Field(max_length=10_000)]


def save_model(path: Path, description: Mapping[str, Any], classifier: Classifier) -> None:
    """Write a description and the weights it names into a folder, which is made.

    The description is renamed into place last: a run that is killed leaves the model that was there before.

    Args:
        path: of the description.
        description: what it says, but for the weights and its checksum.
        classifier: the network.
    """
    from safetensors.torch import save

    made_folder(path.parent)
    weights = save({name: value.contiguous() for name, value in classifier.state_dict().items()})
    digest = sha256(weights)
    name = f"weights-{digest[:12]}.safetensors"
    with whole_file(path.parent / name) as beside:
        beside.write_bytes(weights)
    write_text(path, json.dumps(sealed({**description, "weights": name, "weights_sha256": digest}), indent=1))
    for old in path.parent.glob("weights-*.safetensors"):
        if old.name != name:
            old.unlink()


def read_model(
    path: Path, model: type[_Model], kind: tuple[str, int, str], refusal: type[Refusal]
) -> tuple[dict[str, Any], _Model, dict[str, Tensor]]:
    """Read what :func:`save_model` wrote.

    Args:
        path: of the description.
        model: its schema, with the fields ``weights`` and ``weights_sha256``.
        kind: its format and version, and what it is of, such as "a localizer".
        refusal: class of the errors.

    Returns:
        The description as JSON values, the checked description, and the weights by name, each of the shape of its
        layer.

    Raises:
        Refusal: of the class given: a file is missing, cut short, changed, too large or of something else, or a value
            in it is not allowed.
    """
    from safetensors.torch import load

    format, version, what = kind
    text = read_bytes(path, f"{what}'s description", refusal, LARGEST_DESCRIPTION)
    values = parse_json(text, str(path), refusal)
    check_format(values, format, version, path, refusal, what)
    said = described(model, text, path, refusal)
    if not is_sealed(values):
        raise refusal("is changed or damaged: its checksum differs from the one in it", kind=Kind.DAMAGED, file=path)
    weights_path = path.parent / values["weights"]
    weights = read_bytes(weights_path, f"the weights of {what}", refusal, LARGEST_MODEL)
    if sha256(weights) != values["weights_sha256"]:
        raise refusal(
            f"is cut short or changed: its checksum differs from the one in {path.name}",
            kind=Kind.DAMAGED,
            file=weights_path,
        )
    with library_reads(weights_path, f"the weights of {what}", refusal):
        return values, said, load(weights)


def with_weights(make: Callable[[], _Classifier], weights: Mapping[str, Tensor]) -> _Classifier:
    """Network with weights that fit it, ready to name; it is laid out without memory first, so that it never takes
    more than they do.

    Args:
        make: makes the network.
        weights: of it, by name.

    Raises:
        Refusal: other weights than the network has, or some that are not finite.
    """
    with torch.device("meta"):
        wanted = make().state_dict()
    for name in sorted({*wanted, *weights}):
        if name not in wanted or name not in weights:
            state = "not one of its layers" if name in weights else "missing"
            raise Refusal(
                f"the weights do not fit the network: {name} is {state}",
                kind=Kind.MISMATCH,
            )
        mine, other = ((tuple(each[name].shape), each[name].dtype) for each in (wanted, weights))
        if mine != other:
            raise Refusal(f"the weights do not fit the network: {name} is {other}, must be {mine}", kind=Kind.MISMATCH)
        if not torch.isfinite(weights[name]).all():
            raise Refusal(f"the weights hold a value of {name} that is not finite", kind=Kind.UNSUITABLE)
    classifier = make()
    classifier.load_state_dict(dict(weights))
    return classifier.eval()

"""Touches for training networks of one's own: an iterable data set of torch, every sample reproducible by itself.

Sample ``index`` of a case depends on the seed, the split, the case and the index alone. The samples of a case are made
in visits of 256, because what a visit needs of the case is worked out once. The visits of an epoch are drawn in random
order, those of four neighbouring cases together. At most sixteen are shuffled together, and their batches go to one
worker: no two workers, on whatever machines, make the same batch, and batches hold the same samples however many
workers there are. Only the order in which batches arrive depends on the number of workers.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, TypedDict, cast

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor
from torch.utils.data import IterableDataset, get_worker_info

from acoustic_fem import Library
from geometry.ground.argument_checks import check_choice, check_range, check_type
from geometry.ground.refusal import Kind, Refusal
from localize.datasets.array_source import ArraySource, source_of
from localize.datasets.splits import DEFAULT_SHARES, PURPOSE_OF, SPLITS, Split, check_shares, split_of
from localize.learned.features import FeatureChoice, PairFeatures, map_count
from localize.signals.array_response import ArrayResponse
from localize.signals.disturbances import check_ambient
from localize.signals.frames import FRAME
from localize.signals.noise_model import NoiseChoice, check_noise_choice
from localize.signals.stimulus import SAMPLE_LENGTH
from localize.signals.stimulus_kinds import RUN, STIMULI, Mixture
from localize.signals.threads import one_thread
from localize.signals.touch_generator import TouchGenerator

VISIT = 256
"""Samples of a case that are made at a time."""
NEIGHBOURS = 4
"""Cases next to each other whose visits stay together."""
TOGETHER = 16
"""Visits that are shuffled together."""
DEFAULT_MIX: Mapping[str, float] = {
    "taps": 0.3, "presses": 0.3, "slides": 0.2, "multi-sines": 0.1, "friction": 0.05, "pulse-wave": 0.05,
}  # fmt: skip
"""Share of each kind of touch where a caller gives none: mostly those of fingers."""


class TouchBatch(TypedDict):
    """Samples as a data set yields them; without ``batch_size`` each entry lacks its first axis, n."""

    signals: Tensor
    """Pressures at the microphones; (n, n_microphone, 1000) float32, Pa, at 1 kHz, or the maps of ``features``,
    (n, n_map, 64, 32) float32. Arrays with fewer microphones than others have zeros in their place."""
    point: Tensor
    """Touched point, from 1; (n,) int64."""
    position: Tensor
    """Middle of its membrane in plan, mm; (n, 2) float32; not a number where the library has no design."""
    parameters: Tensor
    """Parameters of the case, as ``parameter_names`` has them; (n, n_parameter) float32."""
    points: Tensor
    """Points that the array has; (n, n_point) bool, as wide as the largest array: a mask for the classes."""
    microphones: Tensor
    """Microphones that the array has; (n, n_microphone) bool."""
    kind: Tensor
    """Kind of the touch, an index into ``kinds``; (n,) int64."""
    case: Tensor
    """Number of the case; (n,) int64."""
    index: Tensor
    """Number of the sample among those of its case, from 0; (n,) int64."""


class TouchDataset(IterableDataset[TouchBatch]):
    """Simulated touches on one array, or on the arrays of many designs, for a ``DataLoader``.

    Args:
        source: a library; a sweep that keeps libraries; as-built sensors; or an :class:`ArraySource` of your own.
        mix: fraction of each kind of touch, by its name in :data:`localize.signals.STIMULI`; by default mostly finger
            touches, :data:`DEFAULT_MIX`.
        touches: samples of every case in an epoch, 1 to 2^31.
        split: "train", "validation" or "test": the cases that :func:`split_of` deals to it. A source of a single case
            has it in all splits, which then differ in their touches only. None takes all cases, with the touches of
            "train".
        shares: fraction of the cases in each split.
        seed: of touches and order; any non-negative integer.
        split_seed: of the splits; data sets that are compared must have the same.
        batch_size: samples of a batch; give the ``DataLoader`` ``batch_size=None`` then, which is several times as
            fast. None yields single samples.
        features: maps in place of signals, as of :class:`localize.learned.PairFeatures`, of the last 250 samples of
            each; all arrays must have the same microphones then.
        microphone_noise: Pa rms over 0 to 500 Hz, white, or "design" for that of each design's microphone.
        ambient: lowest and highest level of room sound, dB SPL, drawn for each sample; None for a quiet room.
        shuffle: whether cases and samples come in random order; if not, case by case, in the order of the samples.
        epoch: number of the epoch, from 0; each has new touches. :meth:`set_epoch` changes it.
        rank: number of this machine, from 0.
        machines: number of machines, which share an epoch without overlap.

    Raises:
        Refusal: an argument out of range; a split without a case; maps of arrays with different microphones; as
            :class:`localize.TouchGenerator`.
    """

    def __init__(
        self,
        source: ArraySource | Library | ArrayResponse,
        *,
        mix: Mapping[str, float] = DEFAULT_MIX,
        touches: int = 4096,
        split: Split | None = None,
        shares: Mapping[Split, float] = DEFAULT_SHARES,
        seed: int = 0,
        split_seed: int = 0,
        batch_size: int | None = None,
        features: FeatureChoice | None = None,
        microphone_noise: NoiseChoice = "design",
        ambient: tuple[float, float] | None = None,
        shuffle: bool = True,
        epoch: int = 0,
        rank: int = 0,
        machines: int = 1,
    ) -> None:
        check_range("touches", touches, 1, 2**31, whole=True)
        check_range("seed", seed, 0, 2**63 - 1, whole=True)
        check_range("split_seed", split_seed, 0, 2**63 - 1, whole=True)
        check_range("machines", machines, 1, 2**20, whole=True)
        check_range("rank", rank, 0, machines - 1, whole=True)
        check_noise_choice(microphone_noise)
        check_shares(shares)
        if batch_size is not None:
            check_range("batch_size", batch_size, 1, VISIT * TOGETHER, whole=True)
        if ambient is not None:
            check_ambient(ambient)
        self.source = source_of(source)
        self.parameter_names, self.parameter_units = self.source.parameter_names, self.source.parameter_units
        self._mixture = _mixture(mix)
        #: Names of the kinds of touches.
        self.kinds = tuple(mix)
        #: Share of each of them, relative to the others.
        self.mix_shares = tuple(float(share) for share in mix.values())
        #: Numbers of the cases of this split; (n_case,) int64.
        self.cases = cases_of(self.source, split, split_seed, shares)
        self.touches, self.seed, self.batch_size, self.shuffle = touches, seed, batch_size, shuffle
        self.features, self.microphone_noise, self.ambient = features, microphone_noise, ambient
        self.rank, self.machines = rank, machines
        self.purpose = PURPOSE_OF[split or "train"]
        self.set_epoch(epoch)
        sizes = np.asarray(self.source.array_sizes, np.int64)
        #: Most points and most microphones of an array.
        self.most_points, self.most_microphones = sizes.max(0).tolist()
        self._maps: PairFeatures | None = None
        if features is not None:
            map_count(self.most_microphones, features)
            if sizes[:, 1].min() < self.most_microphones:
                raise Refusal(
                    "needs arrays with the same number of microphones", kind=Kind.MISMATCH, field="features",
                    value=features,
                )  # fmt: skip
            self._maps = PairFeatures(self.most_microphones, features)
        self._ready: dict[int, tuple[TouchGenerator, dict[str, Tensor]]] = {}
        self._visit: tuple[int, int, TouchBatch] | None = None
        self._open([int(self.cases[0])])  # refuses noise or sound that the arrays do not allow before any work

    def __repr__(self) -> str:
        """Cases, touches and what they are made of."""
        return (
            f"TouchDataset({len(self.cases)} cases, {self.touches} touches each, {', '.join(self.kinds)}; "
            f"{self.most_points} points, {self.most_microphones} microphones, epoch {self.epoch})"
        )

    def set_epoch(self, epoch: int) -> None:
        """Take the touches of another epoch, from 0; with persistent workers, before these are started."""
        check_range("epoch", epoch, 0, 2**31, whole=True)
        self.epoch = epoch

    def __len__(self) -> int:
        """Number of batches, or of samples without a batch size, in an epoch on this machine."""
        counts = [sum(count for *_, count in chunk) for _, chunk in self._chunks(self.rank, self.machines)]
        return sum(counts if self.batch_size is None else (math.ceil(count / self.batch_size) for count in counts))

    def __iter__(self) -> Iterator[TouchBatch]:
        """Batches, or single samples, of this machine and worker."""
        worker = get_worker_info()
        workers, number = (worker.num_workers, worker.id) if worker else (1, 0)
        for place, chunk in self._chunks(self.rank + self.machines * number, self.machines * workers):
            yield from self._batches(place, chunk)

    def __getstate__(self) -> dict[str, Any]:
        """Everything but the arrays at hand: each worker opens its own."""
        return {**self.__dict__, "_ready": {}, "_visit": None}

    def sample(self, case: int, index: int) -> TouchBatch:
        """One sample by its case and index, the same as in the stream to the last bit.

        It is made with the other samples of its visit, which stay in memory until one of another visit is asked for.

        Raises:
            Refusal: a case that is not of this split, an index below zero.
        """
        if case not in self.cases:
            raise Refusal(kind=Kind.UNKNOWN, field="case", value=case, allowed="a case of this split")
        check_range("index", index, 0, 2**62, whole=True)
        # With those it is made with in the stream: products of matrices round by the number of their rows.
        epoch, within = divmod(index, self.touches)
        first = within // VISIT * VISIT
        start, count = epoch * self.touches + first, min(VISIT, self.touches - first)
        if self._visit is None or self._visit[:2] != (case, start):
            self._open([case])
            self._visit = case, start, self._made(case, start, count)
        return _row(self._visit[2], index - start)

    # -- order ---------------------------------------------------------------------------------------------
    def _visits(self) -> NDArray[np.int64]:
        """(n_visit,) int64: visits of the epoch in their order; visit v is of case v // n and starts at 256 (v % n).

        Visits of neighbouring cases stay together, because sources read these together.
        """
        each = math.ceil(self.touches / VISIT)
        if not self.shuffle:
            return np.arange(len(self.cases) * each)
        runs = math.ceil(len(self.cases) / NEIGHBOURS)
        order = np.random.default_rng((self.seed, 1, self.epoch)).permutation(runs * each)
        case = order[:, None] // each * NEIGHBOURS + np.arange(NEIGHBOURS)
        visits = case * each + order[:, None] % each
        return np.asarray(visits[case < len(self.cases)])

    def _chunks(self, first: int, step: int) -> Iterator[tuple[int, list[tuple[int, int, int]]]]:
        """Every so many of the groups of visits that are shuffled together: its place, and of each visit the case, the
        first sample and the number of samples.
        """
        each, visits = math.ceil(self.touches / VISIT), self._visits()
        together = min(TOGETHER, max(1, len(visits) // TOGETHER))  # small sets too are spread over many workers
        for place in range(first, math.ceil(len(visits) / together), step):
            chunk = []
            for visit in visits[place * together : (place + 1) * together].tolist():
                start = visit % each * VISIT
                count = min(VISIT, self.touches - start)
                chunk.append((int(self.cases[visit // each]), self.epoch * self.touches + start, count))
            yield place, chunk

    def group_sizes(self) -> list[int]:
        """Number of samples in each group of an epoch: what is shuffled together, in the order of one worker."""
        return [sum(count for *_, count in chunk) for _, chunk in self._chunks(0, 1)]

    def group(self, place: int) -> TouchBatch:
        """All samples of a group in their order, the same whatever was asked for before.

        Args:
            place: of the group in the epoch, from 0.

        Raises:
            Refusal: no such group.
        """
        for _, chunk in self._chunks(place, 2**62) if place >= 0 else ():
            return self._shuffled(place, chunk)
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="place", value=place, allowed="a group of the epoch, from 0")

    def _batches(self, place: int, chunk: list[tuple[int, int, int]]) -> Iterator[TouchBatch]:
        whole = self._shuffled(place, chunk)
        count = len(whole["point"])
        if self.batch_size is None:
            yield from (_row(whole, row) for row in range(count))
            return
        for first in range(0, count, self.batch_size):
            yield _row(whole, slice(first, first + self.batch_size))

    def _shuffled(self, place: int, chunk: list[tuple[int, int, int]]) -> TouchBatch:
        self._open([case for case, *_ in chunk])
        count = sum(samples for *_, samples in chunk)
        goes_to = torch.arange(count)
        if self.shuffle:
            random = np.random.default_rng((self.seed, 2, self.epoch, place))
            goes_to = torch.from_numpy(random.permutation(count))
        whole: dict[str, Tensor] = {}
        done = 0
        for visit in chunk:
            made = cast("dict[str, Tensor]", self._made(*visit))
            rows = goes_to[done : done + visit[2]]
            for name, values in made.items():
                if name not in whole:
                    whole[name] = torch.empty((count, *values.shape[1:]), dtype=values.dtype)
                whole[name][rows] = values
            done += visit[2]
        return cast("TouchBatch", whole)

    # -- samples -------------------------------------------------------------------------------------------
    def _open(self, cases: Sequence[int]) -> None:
        """Make the touches of some cases ready, and drop those of the earliest ones."""
        wanted = dict.fromkeys(cases)
        missing = [case for case in wanted if case not in self._ready]
        self._ready = {case: each for case, each in self._ready.items() if case in wanted}
        for case, array in zip(
            missing, self.source.arrays(missing, self.ambient is not None) if missing else [], strict=True
        ):
            self._ready[case] = self._touches_of(case, array)

    def _touches_of(self, case: int, array: ArrayResponse) -> tuple[TouchGenerator, dict[str, Tensor]]:
        """Touches of a case, and what is the same for all of them."""
        generator = TouchGenerator(
            array,
            int(np.random.SeedSequence(self.seed, spawn_key=(case,)).generate_state(1, np.uint64)[0] >> 1),
            self.purpose,
            self.microphone_noise,
            stimuli=self._mixture,
            ambient=self.ambient,
        )
        place = np.full((array.point_count, 2), np.nan) if array.position is None else array.position
        return generator, {
            "position": torch.from_numpy(np.asarray(place, np.float32)),
            "parameters": torch.from_numpy(np.asarray(self.source.parameter_values(case), np.float32)),
            "points": torch.arange(self.most_points) < array.point_count,
            "microphones": torch.arange(self.most_microphones) < len(array.microphones),
        }

    def _made(self, case: int, start: int, count: int) -> TouchBatch:
        """Samples ``start`` to ``start + count - 1`` of a case."""
        generator, facts = self._ready[case]
        touched = generator.samples(start, count)
        signals = touched.signals
        if self._maps is not None:
            with torch.no_grad(), one_thread():  # the last bits depend on the number of threads
                signals = self._maps(signals[..., -FRAME:])
        elif signals.shape[1] < self.most_microphones:
            padded = signals.new_zeros(count, self.most_microphones, SAMPLE_LENGTH)
            padded[:, : signals.shape[1]] = signals
            signals = padded
        index = torch.arange(start, start + count)
        first, last = start // RUN, (start + count - 1) // RUN
        runs = torch.tensor(self._mixture.which(generator.seed, self.purpose, first, last - first + 1))
        return {
            "signals": signals,
            "point": touched.point,
            "position": facts["position"][touched.point - 1],
            "parameters": facts["parameters"].expand(count, -1),
            "points": facts["points"].expand(count, -1),
            "microphones": facts["microphones"].expand(count, -1),
            "kind": runs[index // RUN - first],
            "case": torch.full((count,), case),
            "index": index,
        }


def _row(batch: TouchBatch, rows: int | slice) -> TouchBatch:
    """One sample, or some, of a batch."""
    tensors = cast("dict[str, Tensor]", batch)
    return cast("TouchBatch", {name: values[rows] for name, values in tensors.items()})


def _mixture(mix: Mapping[str, float]) -> Mixture:
    check_type("mix", mix, (Mapping,), "kinds of touches with their shares, such as {'taps': 0.5, 'slides': 0.5}")
    for name in mix:
        check_choice("mix", name, STIMULI)
    if not mix or not all(0 < share < math.inf for share in mix.values()):
        raise Refusal(
            kind=Kind.OUT_OF_RANGE,
            field="mix",
            value=dict(mix),
            allowed="at least one kind, each with a share above zero",
        )
    return Mixture(tuple(STIMULI[name] for name in mix), tuple(float(share) for share in mix.values()))


def cases_of(source: ArraySource, split: Split | None, seed: int, shares: Mapping[Split, float]) -> NDArray[np.int64]:
    """Cases of a split, ascending, (n,) int64; a single case is in every split.

    Raises:
        Refusal: no such split, or none of the cases is in it.
    """
    cases = np.asarray(source.case_numbers, np.int64)
    if split is None:
        return cases
    check_choice("split", split, SPLITS)
    if len(cases) == 1:
        return cases
    own = cases[split_of(source.case_keys, seed, shares) == split]
    if not len(own):
        raise Refusal(
            f"gets none of the {len(cases)} cases", kind=Kind.UNSUITABLE, field="split", value=split,
            remedy="take more cases, or larger shares for this split",
        )  # fmt: skip
    return own

"""Touches as a data set of torch: each sample by itself, the same from any number of workers, split by design."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
import torch
from refusals import refused
from torch.utils.data import DataLoader

import acoustic_fem
import localize
from geometry import Kind
from localize.datasets import source_of
from localize.datasets.splits import SPLITS, split_of
from localize.signals.array_response import ArrayResponse, response_of


class Family:
    """Arrays of several sizes: some points and a microphone left out of one array, each case louder than the last."""

    parameter_names = ("gain",)
    parameter_units = ("1",)

    def __init__(self, array: ArrayResponse, points: Sequence[int], microphones: Sequence[int] | None = None) -> None:
        self._array, self._points = array, list(points)
        self._microphones = [2] * len(points) if microphones is None else list(microphones)

    @property
    def case_numbers(self):
        return np.arange(len(self._points))

    @property
    def case_keys(self):
        return tuple(map(str, self.case_numbers))

    @property
    def array_sizes(self):
        return np.column_stack([self._points, self._microphones])

    def parameter_values(self, case):
        return np.array([1.0 + case])

    def arrays(self, cases, sound=False):
        whole = self._array
        return [
            replace(
                whole.heard_by(whole.microphones[: self._microphones[case]]),
                transfer_function=(1 + case) * whole.transfer_function[: self._points[case], : self._microphones[case]],
                cavity_response=None,
                closed_form=None,
                position=whole.position[: self._points[case]],
                membrane_radius=whole.membrane_radius[: self._points[case]],
                line=whole.line[: self._points[case]],
                place=whole.place[: self._points[case]],
            )
            for case in cases
        ]


@pytest.fixture(scope="module")
def array() -> ArrayResponse:
    return response_of(acoustic_fem.solve("array-2x6", np.arange(1.0, 201.0), "lumped"))


@pytest.fixture(scope="module")
def wide() -> ArrayResponse:
    return response_of(acoustic_fem.solve("large-area-64", np.arange(1.0, 201.0), "lumped"))


def keyed(batches) -> dict[tuple[int, int], torch.Tensor]:
    """Signals by case and index; no sample twice."""
    found = {}
    for batch in batches:
        for case, index, signals in zip(batch["case"].tolist(), batch["index"].tolist(), batch["signals"], strict=True):
            assert (case, index) not in found
            found[case, index] = signals
    return found


@pytest.mark.slow
def test_samples_are_the_same_from_none_two_and_four_workers(array):
    data = localize.TouchDataset(Family(array, [12] * 20), touches=130, batch_size=64, seed=3)
    whole = keyed(data)
    assert set(whole) == {(case, index) for case in range(20) for index in range(130)}
    for workers in (2, 4):
        found = keyed(DataLoader(data, batch_size=None, num_workers=workers))
        assert set(found) == set(whole)
        assert all(torch.equal(found[key], whole[key]) for key in whole)


def test_batches_hold_the_same_samples_whoever_makes_them(array):
    data = localize.TouchDataset(Family(array, [12] * 20), touches=130, batch_size=100)

    def batches(source):
        return {tuple(zip(batch["case"].tolist(), batch["index"].tolist(), strict=True)) for batch in source}

    assert batches(DataLoader(data, batch_size=None, num_workers=2)) == batches(data)


def test_machines_share_an_epoch_without_overlap(array):
    of_all = [
        localize.TouchDataset(Family(array, [12] * 20), touches=130, batch_size=64, rank=rank, machines=3)
        for rank in range(3)
    ]
    parts = [keyed(each) for each in of_all]
    assert sum(map(len, parts)) == len(set().union(*parts)) == 20 * 130
    assert [len(each) for each in of_all] == [len(list(each)) for each in of_all]


@pytest.mark.parametrize("features", [None, "phasors"])
@pytest.mark.parametrize("ambient", [None, (40.0, 60.0)])
def test_a_sample_is_made_again_by_its_case_and_index_to_the_last_bit(array, features, ambient):
    data, again = (
        localize.TouchDataset(
            Family(array, [12] * 5), touches=300, batch_size=32, seed=8, epoch=1, features=features, ambient=ambient
        )
        for _ in range(2)
    )
    for batch in list(data)[::7]:
        for row in (0, 1, -1):
            alone = again.sample(int(batch["case"][row]), int(batch["index"][row]))
            for name, value in alone.items():
                torch.testing.assert_close(value, batch[name][row], rtol=0, atol=0, equal_nan=True)


def test_samples_of_other_seeds_differ(array):
    data = localize.TouchDataset(Family(array, [12] * 5), touches=130, batch_size=32, seed=8)
    other = localize.TouchDataset(Family(array, [12] * 5), touches=130, batch_size=32, seed=9)
    assert not torch.equal(other.sample(1, 4)["signals"], data.sample(1, 4)["signals"])


def test_a_touch_on_one_library_is_that_of_the_generator(array):
    data = localize.TouchDataset(array, mix={"taps": 1.0}, touches=64, microphone_noise=0.0, shuffle=False)
    samples = list(data)
    assert len(samples) == len(data) == 64
    points = torch.stack([sample["point"] for sample in samples])
    assert torch.equal(points, 1 + torch.arange(64) % 12)
    assert torch.equal(samples[5]["position"], torch.from_numpy(array.position.astype(np.float32))[points[5] - 1])
    # Linear: the signal over that of another array, twice as loud, is one half.
    louder = replace(array, transfer_function=2 * array.transfer_function, sealed=False, closed_form=None)
    quiet = replace(array, sealed=False, closed_form=None)
    twice, once = (
        localize.TouchDataset(each, mix={"taps": 1.0}, touches=4, microphone_noise=0.0).sample(0, 2)["signals"]
        for each in (louder, quiet)
    )
    torch.testing.assert_close(twice, 2 * once)


def test_kinds_come_in_their_shares_and_are_named(array):
    data = localize.TouchDataset(array, mix={"taps": 3, "presses": 1}, touches=40_000, batch_size=1000)
    assert data.kinds == ("taps", "presses")
    kinds = torch.cat([batch["kind"] for _, batch in zip(range(20), data, strict=False)])
    assert float((kinds == 0).float().mean()) == pytest.approx(0.75, abs=0.08)  # 312 runs: 3 deviations are 0.074
    only = localize.TouchDataset(array, mix={"presses": 1}, touches=200, microphone_noise=0.0, shuffle=False)
    assert len(only) == 200


def test_epochs_have_touches_of_their_own_and_never_repeat_one(array):
    data = localize.TouchDataset(array, touches=100, batch_size=50)
    first = keyed(data)
    data.set_epoch(1)
    second = keyed(data)
    assert {index for _, index in first} == set(range(100))
    assert {index for _, index in second} == set(range(100, 200))


def test_splits_are_by_design_and_stay_when_cases_are_added(array):
    family = Family(array, [12] * 60)
    of = {split: set(localize.TouchDataset(family, split=split, touches=1).cases.tolist()) for split in SPLITS}
    assert set.union(*of.values()) == set(range(60))
    assert sum(map(len, of.values())) == 60
    larger = localize.TouchDataset(Family(array, [12] * 90), split="test", touches=1)
    assert {case for case in larger.cases.tolist() if case < 60} == of["test"]
    assert not np.array_equal(split_of(map(str, range(60)), 0), split_of(map(str, range(60)), 1))
    counts = {name: int((split_of(list(map(str, range(20_000)))) == name).sum()) for name in SPLITS}
    assert counts["train"] == pytest.approx(16_000, abs=250)
    assert counts["test"] == pytest.approx(2_000, abs=200)


def test_touches_of_two_splits_on_one_array_are_not_the_same(array):
    train, test = (localize.TouchDataset(array, split=split, touches=20) for split in ("train", "test"))
    assert not torch.equal(train.sample(0, 3)["signals"], test.sample(0, 3)["signals"])


def test_arrays_of_several_sizes_are_padded_with_masks(array):
    batches = list(localize.TouchDataset(Family(array, [12, 5, 9]), touches=60, batch_size=180))
    batch = {name: torch.cat([each[name] for each in batches]) for name in batches[0]}
    assert batch["points"].shape == (180, 12)
    assert [int(batch["points"][batch["case"] == case][0].sum()) for case in range(3)] == [12, 5, 9]
    assert all(int(batch["point"][batch["case"] == case].max()) == size for case, size in ((0, 12), (1, 5), (2, 9)))
    assert torch.equal(batch["parameters"][:, 0], 1.0 + batch["case"])


def test_missing_microphones_are_silent_and_masked(wide):
    whole = len(wide.microphones)
    batches = list(localize.TouchDataset(Family(wide, [12, 12], [whole, 2]), touches=20, batch_size=40))
    batch = {name: torch.cat([each[name] for each in batches]) for name in batches[0]}
    few = batch["signals"][batch["case"] == 1]
    assert few.shape[1] == whole > 2
    assert (few[:, 2:] == 0).all()
    assert not (few[:, :2] == 0).any()
    assert torch.equal(batch["microphones"].sum(1), torch.where(batch["case"] == 1, 2, whole))
    with refused(Kind.MISMATCH, "features", "phasors"):
        localize.TouchDataset(Family(wide, [12, 12], [whole, 2]), features="phasors")


def test_features_are_those_of_the_network_on_the_last_frame(array):
    plain, maps = (localize.TouchDataset(array, touches=10, features=features) for features in (None, "phasors"))
    frames = torch.stack([plain.sample(0, k)["signals"][:, -250:] for k in range(3)])
    expected = localize.learned.PairFeatures(2, "phasors")(frames)
    found = torch.stack([maps.sample(0, k)["signals"] for k in range(3)])
    torch.testing.assert_close(found, expected, rtol=1e-4, atol=1e-3)


def test_a_loader_of_torch_batches_single_samples(array):
    loader = DataLoader(localize.TouchDataset(array, touches=64), batch_size=16)
    (first, *rest) = loader
    assert first["signals"].shape == (16, 2, 1000)
    assert len(rest) == 3 == len(loader) - 1


@pytest.mark.parametrize(
    ("arguments", "kind", "field"),
    [
        ({"touches": 0}, Kind.OUT_OF_RANGE, "touches"),
        ({"seed": -1}, Kind.OUT_OF_RANGE, "seed"),
        ({"batch_size": 0}, Kind.OUT_OF_RANGE, "batch_size"),
        ({"rank": 2, "machines": 2}, Kind.OUT_OF_RANGE, "rank"),
        ({"mix": {"stabs": 1}}, Kind.OUT_OF_RANGE, "mix"),
        ({"mix": {}}, Kind.OUT_OF_RANGE, "mix"),
        ({"mix": ["taps"]}, Kind.WRONG_TYPE, "mix"),
        ({"mix": {"taps": 0.0}}, Kind.OUT_OF_RANGE, "mix"),
        ({"split": "dev"}, Kind.OUT_OF_RANGE, "split"),
        ({"shares": {"train": 0.5}, "split": "train"}, Kind.OUT_OF_RANGE, "shares"),
        ({"microphone_noise": -1.0}, Kind.OUT_OF_RANGE, "microphone_noise"),
        ({"ambient": (90.0, 30.0)}, Kind.OUT_OF_RANGE, "ambient"),
        ({"features": "wavelets"}, Kind.OUT_OF_RANGE, "features"),
        ({"epoch": -1}, Kind.OUT_OF_RANGE, "epoch"),
    ],
)
def test_a_bad_argument_is_refused_before_any_touch(array, arguments, kind, field):
    with refused(kind, field):
        localize.TouchDataset(Family(array, [12] * 4), **arguments)


def test_an_empty_split_and_a_thing_that_is_no_source_are_refused(array):
    with refused(Kind.UNSUITABLE, "split", "test"):
        localize.TouchDataset(Family(array, [12] * 2), split="test", shares={"train": 1.0})
    for thing in ("library.nc", 3, None, {"array": array}):
        with refused(Kind.WRONG_TYPE, "source"):
            localize.TouchDataset(thing)
    with refused(Kind.UNSUITABLE, "source"):
        source_of(Family(array, []))
    data = localize.TouchDataset(array, touches=2)
    with refused(Kind.UNKNOWN, "case", 7):
        data.sample(7, 0)
    with refused(Kind.OUT_OF_RANGE, "index", -1):
        data.sample(0, -1)


def test_transfer_functions_by_design(array):
    data = localize.TransferFunctionDataset(Family(array, [12, 5, 9]))
    assert len(data) == 3
    second = data[1]
    assert second["transfer_function"].shape == (12, 2, 200)
    np.testing.assert_allclose(second["transfer_function"][:5].numpy(), 2 * array.transfer_function[:5], rtol=1e-6)
    assert (second["transfer_function"][5:] == 0).all()
    assert (int(second["points"].sum()), float(second["parameters"])) == (5, 2.0)
    channels = localize.TransferFunctionDataset(Family(array, [12, 5, 9]), form="two channels")[1]
    torch.testing.assert_close(
        torch.complex(*channels["transfer_function"]), second["transfer_function"], rtol=0, atol=0
    )
    batches = list(DataLoader(data, batch_size=2))
    assert [batch["case"].tolist() for batch in batches] == [[0, 1], [2]]
    with refused(Kind.OUT_OF_RANGE, "form", "polar"):
        localize.TransferFunctionDataset(Family(array, [12]), form="polar")


def test_equal_designs_are_of_one_split(array):
    family = Family(array, [12] * 60)
    family.__class__ = type("Repeated", (Family,), {"case_keys": property(lambda self: ("a", "b", "c") * 20)})
    shares = {"train": 0.5, "validation": 0.25, "test": 0.25}
    splits = split_of(family.case_keys, 0, shares)
    assert all(len(set(splits[k::3])) == 1 for k in range(3))


def test_small_sets_are_spread_over_workers_and_machines(array):
    data = localize.TouchDataset(array, touches=4096, batch_size=256)
    assert len(data.group_sizes()) == 16
    counts = [len(localize.TouchDataset(array, touches=4096, batch_size=256, rank=k, machines=4)) for k in range(4)]
    assert counts == [4, 4, 4, 4]

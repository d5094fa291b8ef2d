"""Sensors with one part off, multiplied out together: against each of them as a network of its own."""

from __future__ import annotations

import numpy as np
import pytest
import torch
from hypothesis import given, settings, strategies as st

from acoustic_fem.batch.elements import Chambers, Points, Tubes
from acoustic_fem.batch.network import join_parts
from acoustic_fem.batch.one_part_off import PartsOff, one_part_off
from acoustic_fem.batch.topology import LineWiring, Topology

DESIGNS, FREQUENCIES = 2, 3
#: Microphones at the ends of each line, and its points.
WIRINGS = (
    (((0, 1), 1),),
    (((0, 1), 5),),
    (((0, 1), 2), ((1, 2), 3), ((2, 0), 1)),
    (((0, 1), 3), ((1, 0), 3)),
)


def topology_of(wiring: tuple[tuple[tuple[int, int], int], ...], alike: bool) -> Topology:
    """One column for all parts of a kind, or columns in turn."""
    columns = 1 if alike else 3
    lines, tube, point = [], 0, 0
    for (first, last), count in wiring:
        tubes = tuple((tube + k) % columns for k in range(count + 1))
        points = tuple((point + k) % columns for k in range(count))
        lines.append(LineWiring(first, last, tubes, points))
        tube, point = tube + count + 1, point + count
    microphones = 1 + max(max(ends) for ends, _ in wiring)
    return Topology(tuple(k % columns for k in range(microphones)), tuple(lines), ("tube",) * columns)


def random_parts(seed: int, columns: int, low: float) -> PartsOff:
    """Parts off by some percent; ``low``: how small shunts are, as they are at low frequency."""
    random = np.random.default_rng(seed)
    shape = DESIGNS, columns, FREQUENCIES

    def passive(scale: float) -> np.ndarray:
        return scale * (random.uniform(0.1, 1, shape) + 1j * random.uniform(-0.5, 1, shape))

    tube = Tubes(passive(1.0), passive(low), passive(low))
    chamber = Chambers(passive(low), 1 + 0.1 * passive(1.0), passive(1.0))

    def off(part: tuple[np.ndarray, ...]) -> list[np.ndarray]:
        return [values * random.uniform(0.9, 1.1, shape) for values in part]

    shunt = passive(low)
    shunts = (shunt, *(values for _ in range(3) for values in off((shunt,))))
    return PartsOff((tube, Tubes(*off(tube))), shunts, (chamber, Chambers(*off(chamber))))


def each_alone(topology: Topology, parts: PartsOff) -> np.ndarray:
    """Transfer functions of every sensor, joined from its own parts."""
    tubes = [column for line in topology.lines for column in line.tubes]
    points = [column for line in topology.lines for column in line.points]

    def response(tube: int = -1, point: tuple[int, int] = (-1, 0), chamber: int = -1, together: bool = False):
        own = Tubes(*(
            np.stack([values[k == tube][:, column] for k, column in enumerate(tubes)], 1)
            for values in zip(*parts.tubes, strict=True)
        ))  # fmt: skip
        which = [-1 if together else point[1] if k == point[0] else 0 for k in range(len(points))]
        loads = Points(np.stack([parts.shunts[w][:, column] for w, column in zip(which, points, strict=True)], 1))
        chambers = Chambers(*(
            np.stack([values[k == chamber][:, column] for k, column in enumerate(topology.microphones)], 1)
            for values in zip(*parts.chambers, strict=True)
        ))  # fmt: skip
        return join_parts(topology.individual(), own, loads, chambers, DESIGNS).transfer_function

    sensors, tube, point = [response()], 0, 0
    for line in topology.lines:
        sensors += [response(tube=tube + k) for k in range(len(line.tubes))]
        for deviation in (1, 2):
            sensors += [response(point=(point + k, deviation)) for k in range(len(line.points))]
        tube, point = tube + len(line.tubes), point + len(line.points)
    sensors += [response(chamber=k) for k in range(len(topology.microphones))]
    return np.stack([*sensors, response(together=True)], 1)


@settings(max_examples=30, derandomize=True, deadline=None)
@given(wiring=st.sampled_from(WIRINGS), alike=st.booleans(), seed=st.integers(0, 100), low=st.sampled_from([1.0, 1e-8]))
def test_ratios_of_microphones_are_those_of_each_sensor_alone(wiring, alike, seed, low):
    topology = topology_of(wiring, alike)
    parts = random_parts(seed, 1 if alike else 3, low)
    found, expected = np.stack(one_part_off(topology, parts), 3), each_alone(topology, parts)
    assert found.shape == expected.shape
    ratio, known = found[:, :, :, 1:] / found[:, :, :, :1], expected[:, :, :, 1:] / expected[:, :, :, :1]
    assert np.abs(ratio / known - 1).max() < 1e-13
    moved, expected_move = ratio[:, 1:] / ratio[:, :1] - 1, known[:, 1:] / known[:, :1] - 1
    assert np.abs(moved - expected_move).max() < 1e-13


def test_tensors_give_what_arrays_give_and_can_be_differentiated():
    topology = topology_of(WIRINGS[2], alike=False)
    parts = random_parts(1, 3, 0.1)

    def tensors(part):
        return type(part)(*(torch.from_numpy(values) for values in part))

    shunts = tuple(torch.from_numpy(values).requires_grad_() for values in parts.shunts)
    followed = PartsOff(tuple(map(tensors, parts.tubes)), shunts, tuple(map(tensors, parts.chambers)))
    found = torch.stack(one_part_off(topology, followed), 3)
    assert found.detach().numpy() == pytest.approx(np.stack(one_part_off(topology, parts), 3), rel=1e-13)
    found.abs().sum().backward()
    assert all(values.grad is not None and values.grad.abs().min() > 0 for values in shunts)

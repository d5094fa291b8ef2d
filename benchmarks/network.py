"""Speed of the lumped network: designs per second, growth with the number of points, cost of gradients.

    python benchmarks/network.py [--quick]

One thread. Rates are per second of processor time, so that a busy machine does not change them much; the best
of several runs.
"""

from __future__ import annotations

import argparse
import platform
import time
from collections.abc import Callable
from dataclasses import fields

import numpy as np
import torch
from threadpoolctl import threadpool_limits

import acoustic_fem
from acoustic_fem.batch.network import batch_response, batch_transfer_function
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.batch.topology import LineWiring, Topology
from acoustic_fem.quantities.local_air import design_air
from geometry.design.design_file import prototype

FREQUENCY = np.linspace(1, 100, 64)
DESIGN = prototype("array-2x6")
AIR = design_air(DESIGN)


def processor_time(call: Callable[[], object], runs: int) -> float:
    call()
    best = np.inf
    for _ in range(runs):
        start = time.process_time()
        call()
        best = min(best, time.process_time() - start)
    return float(best)


def varied(parameters: ArrayParameters, designs: int) -> ArrayParameters:
    """Designs that differ in every number by up to 10 %."""
    generator = np.random.default_rng(0)
    return parameters.map(lambda values: values * generator.uniform(0.9, 1.1, (designs, *values.shape[1:])))


def batches(designs: int, runs: int) -> None:
    topology, parameters = Topology.of(DESIGN), ArrayParameters.from_design(DESIGN)
    own = parameters.individual(topology), topology.individual()
    print(f"\n{designs} designs of {topology.point_count} points x {len(FREQUENCY)} frequencies in one call, one core")
    print(f"{'numbers':<34}{'arrays':<8}{'us/design':>10}{'designs/s':>11}{'with gradient':>15}{'ratio':>7}")
    for name, numbers, wiring in (
        (f"of the design file ({count(parameters)} each)", parameters, topology),
        (f"of every part ({count(own[0])} each)", *own),
    ):
        several = varied(numbers, designs)
        plain = processor_time(lambda p=several, w=wiring: batch_transfer_function(p, w, FREQUENCY, AIR), runs)
        print(f"{name:<34}{'numpy':<8}{plain / designs * 1e6:>10.0f}{designs / plain:>11.0f}")
        tensors = several.tensors()
        forward = processor_time(lambda p=tensors, w=wiring: batch_transfer_function(p, w, FREQUENCY, AIR), runs)
        leaves = several.tensors(requires_grad=True)

        def with_gradient(leaves: ArrayParameters = leaves, wiring: Topology = wiring) -> None:
            transfer = batch_transfer_function(leaves, wiring, FREQUENCY, AIR)
            (transfer.real**2 + transfer.imag**2).sum().backward()

        both = processor_time(with_gradient, runs)
        print(
            f"{name:<34}{'torch':<8}{forward / designs * 1e6:>10.0f}{designs / forward:>11.0f}"
            f"{both / designs * 1e6:>12.0f} us{both / forward:>7.2f}"
        )


def count(parameters: ArrayParameters) -> int:
    return sum(int(getattr(parameters, field.name).size) for field in fields(parameters))


def chain(points: int) -> Topology:
    return Topology((0, 0), (LineWiring(0, 1, (0,) + (1,) * (points - 1) + (0,), (0,) * points),), ("outer", "inner"))


def growth(sizes: list[int], runs: int) -> None:
    parameters = ArrayParameters.from_design(DESIGN)
    print(f"\none chain, one design, {len(FREQUENCY)} frequencies")
    print(
        f"{'points':>8}{'numpy ms':>11}{'us/point':>10}{'torch ms':>11}{'us/point':>10}"
        f"{'own numbers ms':>16}{'us/point':>10}"
    )
    for points in sizes:
        topology = chain(points)
        own = varied(parameters.individual(topology), 1), topology.individual()
        times = [
            processor_time(lambda p=p, w=w: batch_response(p, w, FREQUENCY, AIR), runs)
            for p, w in ((parameters, topology), (parameters.tensors(), topology), own)
        ]
        print(
            f"{points:>8}"
            + "".join(f"{t * 1e3:>{w}.1f}{t / points * 1e6:>10.1f}" for t, w in zip(times, (11, 11, 16), strict=True))
        )


def dense(parameters: ArrayParameters, topology: Topology) -> np.ndarray:
    """The same elements, one matrix of all cavities and chambers per frequency, inverted."""
    from acoustic_fem.batch.elements import Conditions, chambers, points, tubes

    air = Conditions.of(2 * np.pi * FREQUENCY, AIR)
    tube, point, chamber = tubes(parameters, air), points(parameters, air), chambers(parameters, air)
    (line,) = topology.lines
    size = len(line.points) + 2
    nodal = np.zeros((len(FREQUENCY), size, size), dtype=np.complex128)
    for place, column in enumerate(line.tubes):
        series, own = tube.series[0, column], tube.series[0, column] + tube.first[0, column]
        nodal[:, place, place] += own
        nodal[:, place + 1, place + 1] += own
        nodal[:, place, place + 1] = nodal[:, place + 1, place] = -series
    for place, column in enumerate(line.points, 1):
        nodal[:, place, place] += point.shunt[0, column]
    for node in (0, -1):
        nodal[:, node, node] += chamber.shunt[0, 0]
    impedance = np.linalg.inv(nodal)
    at_points = np.einsum("fpp->pf", impedance)[1:-1]
    received = np.transpose(impedance[:, 1:-1][:, :, [0, -1]], (1, 2, 0)) * chamber.ratio[0, 0]
    return received / at_points[:, None]


def naive(sizes: list[int], designs: int, runs: int) -> None:
    parameters = ArrayParameters.from_design(DESIGN)
    print(f"\nagainst the naive routes, ms per design of {len(FREQUENCY)} frequencies (batches of {designs} designs)")
    print(f"{'points':>8}{'batch':>10}{'solve()':>10}{'ratio':>8}{'dense':>10}{'ratio':>8}{'difference of dense':>21}")
    for points in sizes:
        topology = chain(points)
        several = varied(parameters, designs)
        batch = (
            processor_time(lambda p=several, w=topology: batch_transfer_function(p, w, FREQUENCY, AIR), runs) / designs
        )
        design = DESIGN.with_values({"lines.0.points": points})
        plain = processor_time(lambda d=design: acoustic_fem.solve(d, FREQUENCY, "lumped"), runs)
        matrix = processor_time(lambda w=topology: dense(parameters, w), 1)
        reference = batch_transfer_function(parameters, topology, FREQUENCY, AIR)[0]
        difference = np.abs(dense(parameters, topology) / reference - 1).max()
        print(
            f"{points:>8}{batch * 1e3:>10.3f}{plain * 1e3:>10.1f}{plain / batch:>8.0f}"
            f"{matrix * 1e3:>10.1f}{matrix / batch:>8.0f}{difference:>21.1e}"
        )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="smaller batches and chains")
    quick = parser.parse_args().quick
    torch.set_num_threads(1)
    threadpool_limits(1)
    print(
        f"Python {platform.python_version()}, numpy {np.__version__}, torch {torch.__version__}, {platform.machine()}"
    )
    batches(128 if quick else 1024, 2 if quick else 5)
    growth([10, 100, 1000] if quick else [10, 100, 1000, 10_000], 1 if quick else 2)
    naive([12, 48] if quick else [12, 48, 192], 32, 1 if quick else 2)


if __name__ == "__main__":
    main()

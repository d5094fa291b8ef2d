"""Batches of designs: equal to networks of cells and to dense solves, physical on random networks, differentiable."""

import subprocess
import sys
from dataclasses import fields, replace

import mpmath
import numpy as np
import pytest
import torch
from hypothesis import given, settings, strategies as st
from joined_cells import library_of_cells
from random_networks import every_node_at_once, random_parameters, topologies
from refusals import refused
from rings import triangle
from scipy.special import jn_zeros, jve

import acoustic_fem
from acoustic_fem.batch import elements, interpolation, means, network, series
from acoustic_fem.batch.interpolation import cylinder_means, disc_means
from acoustic_fem.batch.network import batch_response, batch_transfer_function, each_alone
from acoustic_fem.batch.parameters import ArrayParameters, MediumParameters
from acoustic_fem.batch.topology import LineWiring, Topology
from acoustic_fem.membrane.design_discs import design_compliance
from acoustic_fem.quantities.fidelity import CLOSED_FORMS
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.medium import Medium
from geometry.design.design_file import prototype
from geometry.ground.refusal import Kind

pytestmark = pytest.mark.filterwarnings("ignore:entrance loss")  # wide bores at 400 Hz

AIR = Medium.at(20, 0.5)
BAND = np.array([0.1, 2.0, 30.0, 400.0])
RESULTS = ("source_response", "point_impedance", "microphone_impedance", "transfer_function")
seeds = st.integers(0, 2**32 - 1)
NAMES = [
    "array-2x6", "fingertip-3x4", "fingertip-4x6", "glove", "large-area-64", "line-2", "line-3", "line-4",
]  # fmt: skip


def scaled(parameters, designs, seed=1, spread=0.1):
    """Copies with every number changed by up to a factor 1 +- spread."""
    generator = np.random.default_rng(seed)
    return parameters.map(
        lambda values: values * generator.uniform(1 - spread, 1 + spread, (designs, *values.shape[1:]))
    )


def one(parameters, design):
    return parameters.map(lambda values: values[design : design + 1])


# -- the closed forms -------------------------------------------------------------------------------
@pytest.mark.parametrize("order", [0, 0.5])
def test_means_of_disc_and_ball_are_ratios_of_bessel_functions(order):
    t = np.geomspace(1e-8, 4e4, 200)
    argument = np.sqrt(-1j * t)
    expected = -jve(order + 2, argument) / jve(order, argument)
    np.testing.assert_allclose(means.ball_mean(order, t), expected, rtol=2e-14)


@pytest.mark.parametrize("aspect", [0.01, 0.2, 0.4, 1.0, 30.0])
def test_mean_of_the_cylinder_is_its_series(aspect):
    t = np.array([1e-6, 1e-2, 1.0, 20.0, 300.0, 1e5])
    zeros = jn_zeros(0, 30)
    beta = np.pi * (np.arange(31, 100_001) - 0.25)
    zeros = np.concatenate([zeros, beta + 1 / (8 * beta) - 31 / (384 * beta**3)])[:, None]
    wave = np.sqrt(zeros**2 + 1j * t) * aspect
    terms = 4 / zeros**2 * 1j * t / (zeros**2 + 1j * t) * (1 - np.tanh(wave) / wave)
    end = np.pi * (100_000 + 0.25)  # the rest as an integral
    expected = terms[::-1].sum(0) + 4j * t / np.pi * (1 / (3 * end**3) - 1 / (4 * aspect * end**4))
    mean = means.cylinder_mean(t, np.full(len(t), aspect))
    np.testing.assert_allclose(mean, expected, rtol=1e-11)


def test_hyperbolic_functions_of_the_square_do_not_cancel():
    square = np.concatenate([np.geomspace(1e-12, 3e4, 40) * np.exp(1j * angle) for angle in (0, 1.0, 1.6)])
    rise, ratio = means.hyperbolic(square)
    root = [mpmath.sqrt(mpmath.mpc(value)) for value in square]
    np.testing.assert_allclose(rise, [complex(2 * mpmath.sinh(x / 2) ** 2) for x in root], rtol=1e-13)
    np.testing.assert_allclose(ratio, [complex(mpmath.sinh(x) / x) for x in root], rtol=1e-13)


@settings(max_examples=20)
@given(seeds, st.floats(-8, 1), st.floats(-3, 3), st.floats(0.05, 2))
def test_interpolated_means_are_the_exact_ones_in_both_parts(seed, scale, aspect, spread):
    """At sizes anywhere and over several tiles, also beside sizes too few to be interpolated."""
    generator = np.random.default_rng(seed)
    omega = 2 * np.pi * np.geomspace(0.1, 500, 5)
    scales = np.exp(scale + spread * generator.uniform(-1, 1, (150, 4, 1)))
    aspects = np.exp(aspect + spread * generator.uniform(-1, 1, (150, 4, 1)))
    pairs = [
        (disc_means(scales, omega), means.ball_mean(0, scales * omega), 5e-13),
        (cylinder_means(scales, aspects, omega), means.cylinder_mean(scales * omega, aspects), 2e-11),
    ]
    for found, exact, tolerance in pairs:
        np.testing.assert_allclose(found.real, exact.real, rtol=tolerance)
        np.testing.assert_allclose(found.imag, exact.imag, rtol=tolerance)


def test_interpolated_means_have_the_exact_derivatives():
    generator = np.random.default_rng(0)
    scales, aspects = (torch.tensor(value * np.exp(generator.uniform(-0.3, 0.3, (150, 4, 1)))) for value in (0.1, 0.5))
    omega = torch.tensor([1.0, 60.0, 600.0], dtype=torch.float64)
    sizes = [scales.requires_grad_(), aspects.requires_grad_()]

    disc = disc_means(scales, omega)
    exact = means.ball_mean(0, scales * omega)
    np.testing.assert_allclose(*(torch.autograd.grad(v.real.sum(), scales)[0] for v in (disc, exact)), rtol=1e-11)
    for found, expected in zip(
        *(
            torch.autograd.grad((value.real + 0.3 * value.imag).sum(), sizes)
            for value in (
                cylinder_means(scales, aspects, omega),
                means.cylinder_mean(scales * omega, aspects),
            )
        ),
        strict=True,
    ):
        np.testing.assert_allclose(found, expected, rtol=1e-9)


@pytest.mark.parametrize("highest", [1.0, 400.0, 600.0])
def test_a_power_series_of_the_membrane_modes_is_their_sum(monkeypatch, highest):
    design = prototype("array-2x6")
    parameters = ArrayParameters.from_design(design, AIR)
    omega = 2 * np.pi * np.geomspace(0.1, highest, 7)
    expected = design_compliance(design, omega / (2 * np.pi))
    for limit in (0.0, 0.6):  # one by one; as a series: f_1 is 814 Hz
        monkeypatch.setattr(elements, "_SERIES", limit)
        modes = elements._modes(parameters, elements.Conditions.of(omega, AIR))
        np.testing.assert_allclose(modes[0, 0] * parameters.membrane_compliance[0, 0], expected, rtol=1e-13)


# -- the network ------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", NAMES)
def test_every_prototype_has_the_responses_of_the_network_of_its_cells(name):
    design = prototype(name)
    library = library_of_cells(design, np.geomspace(1, 100, 9))
    topology, parameters = Topology.of(design), ArrayParameters.from_design(design)
    own_columns = (parameters.individual(topology), topology.individual())
    for numbers, wiring in ((parameters, topology), own_columns, (parameters.tensors(), topology)):
        response = batch_response(numbers, wiring, library.frequency, library.medium)
        for result in RESULTS:
            np.testing.assert_allclose(
                np.asarray(getattr(response, result))[0], getattr(library, result).values, rtol=1e-10
            )


@pytest.mark.parametrize("name", ["line-3", "array-2x6"])
@pytest.mark.parametrize("fidelity", CLOSED_FORMS)
def test_the_difference_from_the_network_of_cells_is_the_error_of_its_mean_of_a_cavity(name, fidelity, monkeypatch):
    """A long line amplifies it: 3e-9 of a cavity at 500 Hz become 6e-8 of a transfer function, 140 dB down."""
    design, band = prototype(name), [1.0, 50.0, 200.0, 500.0]
    found = acoustic_fem.solve(design, band, fidelity).transfer_function.values

    def off():
        return np.abs(library_of_cells(design, band, fidelity).transfer_function.values / found - 1).max()

    def accurate(radius, height, frequency, medium):
        rate = radius**2 / medium.thermal_diffusivity * 2 * np.pi * np.asarray(frequency)
        mean = means.cylinder_mean(rate, np.full(rate.shape, height / (2 * radius)))
        volume = np.pi * radius**2 * height
        return volume / medium.pressure * (1 - (medium.gamma - 1) / medium.gamma * mean)

    stated = off()
    for module in ("cell.lumped", "atlas.cell_in_atlas"):
        monkeypatch.setattr(f"acoustic_fem.{module}.closed_cylinder_compliance", accurate)
    assert off() < 1e-11
    assert 1e-9 < stated < 1e-7


def test_a_design_with_tubes_of_its_own_on_one_line_has_the_responses_of_the_network_of_its_cells():
    design = prototype("line-4")
    thin = {**design.tube.model_dump(), "inner_diameter": 0.3, "length": 20.0}
    design = design.with_values({"lines.1.tube": thin, "lines.2.microphone_tube": thin, "lines.0.points": 3})
    topology = Topology.of(design)
    assert sorted(topology.tube_names) == ["lines.1.tube", "lines.2.microphone_tube", "microphone_tube", "tube"]
    library = library_of_cells(design, BAND[1:3])
    response = batch_response(ArrayParameters.from_design(design), topology, library.frequency, library.medium)
    for result in RESULTS:
        np.testing.assert_allclose(getattr(response, result)[0], getattr(library, result).values, rtol=1e-10)


@settings(max_examples=25)
@given(topologies(), seeds, st.floats(0.02, 0.98))
def test_random_networks_equal_a_dense_solve_with_every_duct_cut_in_two(topology, seed, cut):
    parameters = random_parameters(topology, seed)
    response = batch_response(parameters, topology, BAND, AIR)
    direct = every_node_at_once(parameters, topology, BAND, AIR, cut)
    count = topology.point_count
    # reciprocity: the batch injects at the points, here the dense solve at the microphones; at 0.1 Hz it is the
    # dense solve that loses digits
    np.testing.assert_allclose(
        response.source_response[0], np.transpose(direct[:, :count, count:], (1, 2, 0)), rtol=1e-7
    )
    np.testing.assert_allclose(response.point_impedance[0], np.einsum("fpp->pf", direct[:, :count, :count]), rtol=1e-7)
    np.testing.assert_allclose(
        response.microphone_impedance[0], np.moveaxis(direct[:, count:, count:], 0, -1), rtol=1e-7
    )


@settings(max_examples=25)
@given(topologies(), seeds)
def test_random_networks_are_reciprocal_and_take_power_from_any_injection(topology, seed):
    response = batch_response(random_parameters(topology, seed), topology, BAND, AIR)
    among = response.microphone_impedance[0]
    np.testing.assert_allclose(among, np.swapaxes(among, 0, 1), rtol=1e-12)
    for point in range(topology.point_count):
        row = response.source_response[0, point]
        corner = response.point_impedance[0, point][None, None]
        whole = np.concatenate([np.concatenate([corner, row[None]], 1), np.concatenate([row[:, None], among], 1)], 0)
        power = np.linalg.eigvalsh(np.moveaxis(whole, -1, 0).real)
        assert np.all(power.min(1) >= -1e-12 * np.abs(whole).max((0, 1)))
        assert np.all(corner.real > 0)


@settings(max_examples=15)
@given(topologies(), seeds)
def test_all_pressures_of_a_random_sealed_network_become_equal_at_low_frequency(topology, seed):
    parameters = random_parameters(topology, seed)
    sealed = replace(parameters, leak_conductance=0 * parameters.leak_conductance)
    transfer = batch_transfer_function(sealed, topology, [1e-3, 1e-2], AIR)
    away = np.abs(transfer - 1).max((0, 1, 2))
    assert away[0] < 0.05
    assert away[0] < 0.11 * away[1]  # first order in frequency


@settings(max_examples=15)
@given(st.integers(1, 7), seeds)
def test_a_symmetric_random_line_has_mirrored_responses(count, seed):
    columns = [min(k, count - k) for k in range(count + 1)], [min(k, count - 1 - k) for k in range(count)]
    topology = Topology((0, 0), (LineWiring(0, 1, tuple(columns[0]), tuple(columns[1])),), ())
    response = batch_response(random_parameters(topology, seed), topology, BAND[:3], AIR)
    np.testing.assert_allclose(response.source_response, response.source_response[:, ::-1, ::-1], rtol=1e-11)
    np.testing.assert_allclose(response.point_impedance, response.point_impedance[:, ::-1], rtol=1e-11)


@settings(max_examples=15)
@given(topologies(), seeds)
def test_turning_a_line_round_changes_only_the_numbers_of_its_points(topology, seed):
    parameters = random_parameters(topology, seed)
    line = topology.lines[0]
    turned = LineWiring(line.last, line.first, line.tubes[::-1], line.points[::-1])
    order = np.arange(topology.point_count)
    order[: len(line.points)] = order[: len(line.points)][::-1]
    response = batch_response(parameters, topology, BAND[:3], AIR)
    other = batch_response(parameters, replace(topology, lines=(turned, *topology.lines[1:])), BAND[:3], AIR)
    np.testing.assert_allclose(other.source_response[:, order], response.source_response, rtol=1e-11)
    np.testing.assert_allclose(other.point_impedance[:, order], response.point_impedance, rtol=1e-11)


@settings(max_examples=10)
@given(topologies(), seeds)
def test_two_touches_at_once_give_the_sum_of_their_pressures(topology, seed):
    parameters = random_parameters(topology, seed)
    response = batch_response(parameters, topology, BAND[:3], AIR)
    direct = every_node_at_once(parameters, topology, BAND[:3], AIR)
    count = topology.point_count
    injected = np.zeros(direct.shape[1], dtype=complex)
    injected[0] += 2e-9
    injected[count - 1] += (1 - 3j) * 1e-9
    both = (direct @ injected)[:, count:]
    summed = 2e-9 * response.source_response[0, 0] + (1 - 3j) * 1e-9 * response.source_response[0, count - 1]
    np.testing.assert_allclose(summed.T, both, rtol=1e-7)


def test_nothing_cancels_at_low_frequency():
    # one point between two microphones as star and chain of impedances, in 40 digits from the same elements
    topology = Topology((0, 0), (LineWiring(0, 1, (0, 0), (0,)),), ())
    parameters = random_parameters(topology, 3)
    low = np.array([1e-3])
    response = batch_response(parameters, topology, low, AIR)
    air = network.Conditions.of(2 * np.pi * low, AIR)
    tube, point = network.tubes(parameters, air), network.points(parameters, air)
    chamber = network.chambers(parameters, air)
    with mpmath.workdps(40):
        b, g, m, c = (mpmath.mpc(complex(v[0, 0, 0])) for v in (tube.series, tube.first, point.shunt, chamber.shunt))
        nodal = mpmath.matrix([[c + g + b, -b, 0], [-b, m + 2 * g + 2 * b, -b], [0, -b, c + g + b]])
        exact = mpmath.inverse(nodal)
        own, received = complex(exact[1, 1]), complex(exact[0, 1]) * complex(chamber.ratio[0, 0, 0])
    np.testing.assert_allclose(response.point_impedance[0, 0, 0], own, rtol=1e-14)
    np.testing.assert_allclose(response.source_response[0, 0, :, 0], received, rtol=1e-14)


# -- batches ----------------------------------------------------------------------------------------
def test_a_batch_is_its_designs_one_by_one(monkeypatch):
    design = triangle()
    topology, parameters = Topology.of(design), scaled(ArrayParameters.from_design(design), 5)
    parameters = replace(parameters, hole_length=parameters.hole_length[:1], tube_radius=parameters.tube_radius[:1])
    whole = batch_response(parameters, topology, BAND, AIR)
    monkeypatch.setattr(network, "_CHUNK", 2 * topology.point_count * len(BAND))  # two designs at once
    monkeypatch.setattr(series, "_BLOCK", 7)
    pieces = batch_response(parameters, topology, BAND, AIR)
    assert whole.source_response.shape == (5, 15, 3, 4)
    for k in range(5):
        row = parameters.map(lambda values, k=k: values[min(k, len(values) - 1)][None])
        single = batch_response(row, topology, BAND, AIR)
        for result in RESULTS:
            np.testing.assert_allclose(getattr(whole, result)[k], getattr(single, result)[0], rtol=1e-12)
            np.testing.assert_allclose(getattr(pieces, result)[k], getattr(single, result)[0], rtol=1e-12)


@pytest.mark.parametrize("kind", ["numpy", "torch"])
def test_every_part_of_many_designs_is_interpolated_and_equal_to_solving_it_alone(kind):
    design = prototype("array-2x6")
    topology = Topology.of(design)
    parameters = scaled(ArrayParameters.from_design(design, AIR).individual(topology), 300, spread=0.3)
    numbers = parameters if kind == "numpy" else parameters.tensors()
    made = interpolation._series.cache_info()
    whole = batch_response(numbers, topology.individual(), BAND, AIR)
    used = interpolation._series.cache_info()
    assert used.hits + used.misses > made.hits + made.misses + 8  # several tiles of discs and cylinders
    for k in (0, 150, 299):
        single = batch_response(one(parameters, k), topology.individual(), BAND, AIR)
        for result in RESULTS:
            np.testing.assert_allclose(getattr(whole, result)[k], getattr(single, result)[0], rtol=1e-12)


def test_designs_of_one_wiring_make_a_batch():
    design = prototype("array-2x6")
    designs = [design.with_values({"tube.length": length}) for length in (10.0, 12.5, 15.0)]
    band = [1.0, 10.0, 100.0]
    transfer = batch_transfer_function(ArrayParameters.from_designs(designs, AIR), Topology.of(design), band, AIR)
    for row, each in zip(transfer, designs, strict=True):
        library = library_of_cells(each, band, "lumped", AIR)
        np.testing.assert_allclose(row, library.transfer_function.values, rtol=1e-10)


def test_every_design_may_have_its_own_air():
    design = prototype("array-2x6")
    topology, parameters = Topology.of(design), ArrayParameters.from_design(design, AIR)
    media = [AIR, Medium.at(40, 0.9), Medium.at(5, 0.1, 8e4)]
    together = batch_transfer_function(parameters, topology, BAND, MediumParameters.from_media(media))
    for row, medium in zip(together, media, strict=True):
        np.testing.assert_allclose(row, batch_transfer_function(parameters, topology, BAND, medium)[0], rtol=1e-12)


@pytest.mark.parametrize("fidelity", CLOSED_FORMS)
@pytest.mark.parametrize("air", ["one", "each"])
def test_designs_one_by_one_are_those_of_solve_to_the_last_bit(fidelity, air):
    base = prototype("array-2x6")
    designs = [
        base.with_values({"tube.inner_diameter": bore, "resonator.cavity_height": height, "air.temperature": warmth})
        for bore, height, warmth in zip(
            (0.3, 0.5, 0.45), (2.0, 3.0, 2.5), (20, 35, 5) if air == "each" else (20, 20, 20), strict=True
        )
    ]
    media = [design_air(each) for each in designs]
    medium = media[0] if air == "one" else MediumParameters.from_media(media)
    parts = [ArrayParameters.from_design(each) for each in designs]
    parameters = ArrayParameters(
        **{name: np.concatenate([getattr(part, name) for part in parts]) for name in vars(parts[0])}
    )
    frequency = np.arange(1.0, 501.0)  # NumPy works in place on arrays of this size, with other last bits
    found = each_alone(parameters, Topology.of(base), frequency, medium, fidelity)
    together = batch_response(parameters, Topology.of(base), frequency, medium, fidelity)
    for number, (design, one) in enumerate(zip(designs, found, strict=True)):
        library = acoustic_fem.solve(design, frequency, fidelity)
        for name in ("transfer_function", "point_impedance", "microphone_impedance"):
            np.testing.assert_array_equal(getattr(one, name)[0], getattr(library, name).values)
            np.testing.assert_allclose(getattr(one, name)[0], getattr(together, name)[number], rtol=1e-12)


# -- gradients --------------------------------------------------------------------------------------
SMALL = Topology(
    (0, 1, 0),
    (LineWiring(0, 1, (0, 1, 0), (0, 1)), LineWiring(1, 2, (0, 0), (1,)), LineWiring(0, 2, (1, 1, 0), (1, 0))),
    ("outer", "inner"),
)


@pytest.mark.slow
def test_torch_finds_the_gradient_by_every_parameter_and_by_the_air():
    parameters = random_parameters(SMALL, 5, modes=2)
    medium = MediumParameters.from_media([AIR])
    counted = [field.name for field in fields(parameters) if field.name != "port_height"]  # which counts at atlas
    names = counted + [f"air {field.name}" for field in fields(medium)]
    start = [getattr(parameters, name) for name in counted] + [getattr(medium, f.name) for f in fields(medium)]

    def response(*logarithms):
        values = [torch.exp(shift) * torch.as_tensor(value) for shift, value in zip(logarithms, start, strict=True)]
        height = torch.as_tensor(parameters.port_height)
        numbers = ArrayParameters(**dict(zip(names, values[:-6], strict=False)), port_height=height)
        gas = MediumParameters(*values[-6:])
        found = batch_response(numbers, SMALL, [3.0, 200.0], gas)
        return found.transfer_function, 1e-9 * found.microphone_impedance

    shifts = [torch.zeros(value.shape, dtype=torch.float64, requires_grad=True) for value in start]
    assert torch.autograd.gradcheck(response, shifts, atol=1e-8, rtol=1e-6)
    for result in response(*shifts):
        grown = torch.autograd.grad(result.abs().sum(), shifts, retain_graph=True)
        assert all(torch.isfinite(part).all() and part.abs().sum() > 0 for part in grown), names


def test_torch_gradients_are_the_differences_of_the_numpy_path():
    design = prototype("array-2x6")
    topology, parameters = Topology.of(design), scaled(ArrayParameters.from_design(design), 2)
    frequency = [1.0, 10.0, 100.0]

    def level_difference(numbers):
        transfer = batch_transfer_function(numbers, topology, frequency, AIR)
        power = transfer.real**2 + transfer.imag**2
        return (power[:, :, 0] / power[:, :, 1]).sum()

    tensors = parameters.tensors(requires_grad=True)
    level_difference(tensors).backward()
    for field in fields(parameters):
        if field.name == "port_height":  # counts at atlas only
            continue
        values = getattr(parameters, field.name)
        for design_number in range(2):
            step = np.zeros_like(values)
            step[design_number] = 1e-5 * values[design_number]
            up, down = (replace(parameters, **{field.name: values + sign * step}) for sign in (1, -1))
            difference = (level_difference(up) - level_difference(down)) / 2
            gradient = float((getattr(tensors, field.name).grad * torch.as_tensor(step)).sum())
            assert gradient == pytest.approx(difference, rel=1e-6, abs=1e-12), field.name


def test_gradients_of_a_large_batch_are_computed_again_block_by_block(monkeypatch):
    design = prototype("array-2x6")
    topology, parameters = Topology.of(design), scaled(ArrayParameters.from_design(design, AIR), 4)
    monkeypatch.setattr(network, "_CHUNK", 2 * topology.point_count * len(BAND))
    slopes, kept = [], []
    for limit in (10**9, 1):
        monkeypatch.setattr(network, "_LARGEST_GRAPH", limit)
        tensors = parameters.tensors(requires_grad=True)
        before = sum(kept)
        with torch.autograd.graph.saved_tensors_hooks(lambda t: kept.append(t.numel()) or t, lambda t: t):
            transfer = batch_transfer_function(tensors, topology, BAND, AIR)
        transfer.abs().sum().backward()
        counted = [field.name for field in fields(tensors) if field.name != "port_height"]
        slopes.append(([getattr(tensors, name).grad for name in counted], sum(kept) - before))
    for whole, blocks in zip(slopes[0][0], slopes[1][0], strict=True):
        np.testing.assert_allclose(blocks, whole, rtol=1e-13)
    assert slopes[1][1] < 0.2 * slopes[0][1]


def test_second_derivatives_through_a_cavity_are_refused():
    parameters = ArrayParameters.from_design(prototype("array-2x6"), AIR).tensors(requires_grad=True)
    transfer = batch_transfer_function(parameters, Topology.of(prototype("array-2x6")), [10.0], AIR)
    (slope,) = torch.autograd.grad(transfer.abs().sum(), parameters.cavity_radius, create_graph=True)
    with pytest.raises(RuntimeError, match="differentiate twice"):
        slope.sum().backward()


# -- what is refused --------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("frequency", "kind"),
    [([0.0, 1.0], Kind.OUT_OF_RANGE), ([2.0, 1.0], Kind.OUT_OF_RANGE), ([], Kind.WRONG_TYPE)],
)
def test_bad_frequencies_are_refused(frequency, kind):
    design = prototype("array-2x6")
    with refused(kind, "frequency"):
        batch_response(ArrayParameters.from_design(design, AIR), Topology.of(design), frequency, AIR)


@pytest.mark.parametrize(
    ("field", "values", "kind"),
    [
        ("tube_radius", np.full((1, 1), 2e-4), Kind.WRONG_TYPE),
        ("membrane_fraction", np.ones((1, 1)), Kind.WRONG_TYPE),
        ("membrane_fraction", np.ones((1, 1, 2)), Kind.MISMATCH),
        ("cavity_height", np.full((1, 1), -1e-3), Kind.OUT_OF_RANGE),
        ("membrane_loss", np.full((1, 1), np.nan), Kind.OUT_OF_RANGE),
        ("back_volume", np.full((1, 1), 2, dtype=np.float32), Kind.WRONG_TYPE),
        ("back_volume", torch.ones(1, 1), Kind.WRONG_TYPE),
    ],
)
def test_parameters_that_do_not_fit_are_refused(field, values, kind):
    design = prototype("array-2x6")
    parameters = replace(ArrayParameters.from_design(design, AIR), **{field: values})
    with refused(kind, field):
        batch_response(parameters, Topology.of(design), BAND, AIR)


def test_air_that_does_not_fit_is_refused():
    design = prototype("array-2x6")
    parameters, topology = scaled(ArrayParameters.from_design(design, AIR), 3), Topology.of(design)
    air = MediumParameters.from_media([AIR, AIR])
    with refused(Kind.WRONG_TYPE, "air.density"):
        batch_response(parameters, topology, BAND, air)
    with refused(Kind.OUT_OF_RANGE, "air.gamma"):
        batch_response(parameters, topology, BAND, replace(MediumParameters.from_media([AIR]), gamma=np.zeros(1)))
    with refused(Kind.WRONG_TYPE, "air.density"):
        batch_response(parameters.tensors(), topology, BAND, air)


@pytest.mark.parametrize(
    ("lines", "field", "kind"),
    [
        ((LineWiring(0, 2, (0, 0), (0,)),), "lines.1", Kind.OUT_OF_RANGE),
        ((LineWiring(1, 1, (0, 0), (0,)),), "lines.1", Kind.OUT_OF_RANGE),
        ((LineWiring(0, 1, (0,), (0,)),), "lines.1", Kind.MISMATCH),
        ((), "lines", Kind.CONFLICT),
    ],
)
def test_wirings_that_are_no_array_are_refused(lines, field, kind):
    with refused(kind, field):
        Topology((0, 0), lines, ("tube",))


def test_a_batch_takes_any_mounting_and_refuses_a_stretch_whose_tension_has_no_loss():
    design = prototype("line-2").with_values({"membrane.mounting": "clamped"})
    library = library_of_cells(design, BAND[1:3], "lumped", AIR)
    transfer = batch_transfer_function(ArrayParameters.from_design(design, AIR), Topology.of(design), BAND[1:3], AIR)
    np.testing.assert_allclose(transfer[0], library.transfer_function.values, rtol=1e-10)
    with refused(Kind.OUT_OF_RANGE, "membrane.stretch", 1.2):
        ArrayParameters.from_design(design.with_values({"membrane.stretch": 1.2}))


def test_designs_of_different_wiring_are_no_batch():
    designs = [prototype("array-2x6"), prototype("glove")]
    with refused(Kind.MISMATCH, "designs.2"):
        ArrayParameters.from_designs(designs)
    with refused(Kind.MISSING, "designs"):
        ArrayParameters.from_designs([])


def test_the_warnings_of_the_lumped_fidelity_are_given():
    design = prototype("array-2x6")
    parameters, topology = ArrayParameters.from_design(design, AIR), Topology.of(design)
    with pytest.warns(UserWarning, match=r"shear number a sqrt\(w/nu\) = 6.* is above 5"):
        batch_response(parameters, topology, [2000.0], AIR)
    soft = replace(parameters, membrane_frequency=parameters.membrane_frequency / 100)
    with pytest.warns(UserWarning, match=r"membrane: 100 Hz is above half of the highest mode that is kept"):
        batch_response(soft, topology, [100.0], AIR)


def test_the_numpy_path_does_not_load_torch():
    code = (
        "import sys; from acoustic_fem.batch.network import *; from geometry.design.design_file import prototype;"
        "d = prototype('array-2x6');"
        "batch_transfer_function(ArrayParameters.from_design(d), Topology.of(d), [1.0], Medium.at());"
        "assert 'torch' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_gradients_reach_individual_parts():
    design = prototype("array-2x6")
    topology = Topology.of(design)
    parameters = ArrayParameters.from_design(design, AIR).individual(topology).tensors(requires_grad=True)
    transfer = batch_transfer_function(parameters, topology.individual(), [10.0], AIR)
    # nearer the first microphone, the last tube matters less for the first point
    transfer[0, 0, 0, 0].abs().backward()
    gradient = parameters.tube_length.grad[0] * parameters.tube_length[0]
    assert gradient.shape == (13,)
    assert abs(gradient[12]) < abs(gradient[0])

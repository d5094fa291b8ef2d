"""Sound from outside has the level and the path that the network gives; microphones scatter as their model says."""

import numpy as np
import pytest
from rc_line import rc_line
from refusals import refused

import acoustic_fem
import geometry
from acoustic_fem.network.microphone import response as microphone_response, vent_ratio
from geometry import Kind
from localize import TouchGenerator
from localize.signals.array_response import response_of
from localize.signals.disturbances import MicrophoneMismatch, ambient_sound


@pytest.fixture(scope="module")
def array():
    return response_of(acoustic_fem.solve(geometry.prototype("array-2x6"), np.arange(1.0, 501.0), fidelity="lumped"))


def difference(array, seed=0, count=240, **change):
    """What is recorded with a change, less what is without."""
    quiet, changed = (
        TouchGenerator(array, seed, "training", 0.0, **kind).samples(0, count).signals for kind in ({}, change)
    )
    return (changed - quiet).double().numpy()


def test_sound_of_90_db_has_0_63_pa_and_equal_power_in_every_octave():
    sound = ambient_sound(0, "training", 0, 2000, (90.0, 90.0), 500.0)
    power = 2 * (sound.abs() ** 2).double().mean(0).numpy()
    assert np.sqrt(power.sum()) == pytest.approx(20e-6 * 10 ** (90 / 20), rel=0.01)
    octaves = [power[low : 2 * low].sum() for low in (25, 50, 100, 200)]
    assert np.ptp(octaves) < 0.1 * np.mean(octaves)
    assert power[:20].sum() == 0


def test_levels_are_drawn_between_two():
    sound = ambient_sound(0, "training", 0, 2000, (40.0, 80.0), 500.0)
    level = 10 * np.log10(2 * (sound.abs() ** 2).sum(1).numpy()) - 20 * np.log10(20e-6)
    assert (level.min() > 37, level.max() < 83) == (True, True)
    assert np.quantile(level, [0.25, 0.5, 0.75]) == pytest.approx([50, 60, 70], abs=2.5)


def test_sound_reaches_the_microphones_through_all_membranes_at_once(array):
    heard = difference(array, ambient=(90.0, 90.0))
    # One second of steady state: lines of the transform are those of the sound.
    lines = np.fft.rfft(heard, norm="forward")[..., 30:400:37]
    sound = ambient_sound(0, "training", 0, 240, (90.0, 90.0), 499.75).numpy()[:, None, 30:400:37]
    library = acoustic_fem.solve(geometry.prototype("array-2x6"), np.arange(30.0, 400.0, 37.0), fidelity="lumped")
    through = library.touch_response("pressure").values
    assert np.abs(lines / sound - through.sum(0)).max() < 1e-3 * np.abs(through.sum(0)).max()
    assert np.abs(through.sum(0))[0, 0] > 2 * np.abs(through)[:, 0, 0].max()


def test_gains_scatter_by_so_many_db_and_stay_for_the_whole_sample(array):
    plain, other = (
        TouchGenerator(array, 0, "training", 0.0, mismatch=kind).samples(0, 900).signals.double().numpy()
        for kind in (None, MicrophoneMismatch(gain=0.5))
    )
    gain = 20 * np.log10(np.einsum("nmt,nmt->nm", plain, other) / np.einsum("nmt,nmt->nm", plain, plain))
    assert gain.std(0) == pytest.approx([0.5, 0.5], rel=0.08)
    assert abs(np.corrcoef(gain.T)[0, 1]) < 0.1
    assert np.abs(other - 10 ** (gain[..., None] / 20) * plain).max() < 1e-5


def test_a_vent_that_scatters_changes_the_response_as_that_of_another_corner(array):
    generator = TouchGenerator(array, 0, "training", 0.0, mismatch=MicrophoneMismatch(vent=0.2))
    factors = MicrophoneMismatch(vent=0.2).factors(0, "training", 0, 500, 2, generator._vent_on_lines).numpy()
    microphone, medium = geometry.prototype("array-2x6").microphone, acoustic_fem.Medium.at(20.0)
    f = np.array([2.0, 20.0, 100.0])
    at = np.rint(f / 0.25).astype(int)
    # The corner follows the conductance: 20 Hz becomes 26 Hz where it conducts 1.3 times as well.
    other = microphone.model_copy(update={"vent_corner": 1.3 * microphone.vent_corner})
    expected = microphone_response(other, f, medium) / microphone_response(microphone, f, medium)
    closest = np.abs(factors[..., at] - expected).max(-1).min()
    assert closest < 0.01
    # Between the frequencies of the library and below the lowest of them as well.
    between = np.array([0.25, 1.5, 2.75])
    nominal, one = (generator._vent_on_lines.numpy()[[1, 6, 11]], factors[0, 0, [1, 6, 11]])
    exact = vent_ratio(microphone, between, medium)
    assert np.abs(nominal / exact - 1).max() < 1e-3
    conductance = 1 / np.abs(factors[0, 0, 0])
    assert np.abs(one - (1 + exact) / (conductance + exact)).max() < 1e-3
    spread = np.log(np.abs(factors[..., 4])).std()  # far below the corner the response goes as 1 / conductance
    assert spread == pytest.approx(np.sqrt(np.log1p(0.2**2)), rel=0.1)
    assert np.abs(factors[..., -1] - 1).max() < 0.1


def test_samples_with_disturbances_are_made_again_alone(array):
    def generator():
        return TouchGenerator(
            array, 3, "training", "design", ambient=(50.0, 90.0), mismatch=MicrophoneMismatch(0.5, 0.1)
        )

    whole = generator().samples(0, 40).signals
    assert np.allclose(generator().samples(17, 5).signals, whole[17:22], atol=1e-6)


@pytest.mark.parametrize(
    ("choice", "field"),
    [({"ambient": (30.0, 90.0)}, "ambient"), ({"mismatch": MicrophoneMismatch(vent=0.1)}, "mismatch.vent")],
)
def test_arrays_without_a_design_have_no_outside_and_no_vents(choice, field):
    with refused(Kind.MISMATCH, field):
        TouchGenerator(rc_line(3), 0, "training", 0.0, **choice)


@pytest.mark.parametrize("levels", [(90.0, 30.0), (-200.0, 30.0), (0.0, 150.0), (float("nan"), 30.0)])
def test_levels_that_are_no_range_of_sound_are_refused(array, levels):
    with refused(Kind.OUT_OF_RANGE, "ambient", levels):
        TouchGenerator(array, 0, "training", 0.0, ambient=levels)


@pytest.mark.parametrize("choice", [{"gain": -1.0}, {"gain": 21.0}, {"vent": 1.1}, {"vent": float("nan")}])
def test_a_mismatch_outside_its_range_is_refused(choice):
    with refused(Kind.OUT_OF_RANGE, f"mismatch.{next(iter(choice))}"):
        MicrophoneMismatch(**choice)

"""Families of libraries, beside the decoder of one library."""

import pytest
from rc_line import rc_line
from refusals import refused

import localize
from geometry import Kind


@pytest.fixture(scope="module")
def arrays():
    return [rc_line(8, spread=spread) for spread in (0.7, 1.0, 1.4)]


def accuracy(locator, array, noise=1e-3):
    return localize.evaluate(locator, array, 20, noise).top1


def test_a_family_of_one_is_the_decoder_of_its_library(arrays):
    signals = localize.TouchGenerator(arrays[1], 0, "evaluation", 0.1).samples(0, 40).signals[..., :500]
    one, family = localize.BayesDecoder(arrays[1], 1e-3), localize.FamilyDecoder(arrays[1:2], 1e-3)
    assert family.locate(signals) == pytest.approx(one.locate(signals), abs=1e-9)
    assert family.locate(signals[3]) == pytest.approx(one.locate(signals[3]), abs=1e-9)


def test_a_family_that_holds_the_truth_decodes_a_sensor_that_the_nominal_library_does_not(arrays):
    made = rc_line(8, spread=1.4)
    nominal, family = localize.BayesDecoder(arrays[1], 1e-3), localize.FamilyDecoder(arrays, 1e-3)
    assert accuracy(nominal, made) < 0.9
    assert accuracy(family, made) > 0.97
    signals = localize.TouchGenerator(made, 0, "evaluation", 1e-3).samples(0, 40).signals
    assert (family.hypotheses(signals).argmax(1) == 2).mean() > 0.9


def test_the_prior_of_a_hypothesis_multiplies_its_likelihood(arrays):
    signals = localize.TouchGenerator(arrays[0], 0, "evaluation", 0.3).samples(0, 20).signals[..., :250]
    even = localize.FamilyDecoder(arrays, 0.3).hypotheses(signals)
    weighted = localize.FamilyDecoder(arrays, 0.3, prior=[1, 2, 5]).hypotheses(signals)
    expected = even * [1, 2, 5]
    assert weighted == pytest.approx(expected / expected.sum(1, keepdims=True), rel=1e-9)


def test_families_that_do_not_fit_are_refused(arrays):
    with refused(Kind.MISSING, "libraries"):
        localize.FamilyDecoder([])
    with refused(Kind.MISMATCH, "libraries.2"):
        localize.FamilyDecoder([arrays[0], rc_line(7)], 1e-3)
    with refused(Kind.OUT_OF_RANGE, "prior", [1, 0, 1]):
        localize.FamilyDecoder(arrays, 1e-3, prior=[1, 0, 1])

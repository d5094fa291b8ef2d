"""Refinement of meshes whose errors are known."""

import pytest
from refusals import refused

from acoustic_fem.numerics.refinement import ConvergenceError, refined
from geometry.air.mesh import InvertedElementsError
from geometry.ground.refusal import Kind

ACCURACY = 1e-3


def converged(error_at, order=2.0, scale=1.0):
    """The error of the mesh that is taken, the one that is stated, and the scales of all meshes."""
    answer, stated, meshes = refined(
        "flow",
        lambda scale, advance: (error_at(scale), 100),
        lambda fine, coarse: abs(fine - coarse),
        scale,
        ACCURACY,
        order,
        lambda done: None,
    )
    return answer, stated, [mesh.scale for mesh in meshes]


@pytest.mark.parametrize("order", [2.0, 3.0, 4.0])
@pytest.mark.parametrize("size", [3e-4, 1e-3, 4e-3])
def test_the_stated_error_is_no_less_than_the_true_one_where_the_order_is_at_least_that_believed(order, size):
    error, stated, scales = converged(lambda scale: size * scale**order)
    assert error <= stated * (1 + 1e-9) <= ACCURACY * (1 + 1e-9)
    assert scales[:2] == [1.5, 1.0]
    assert scales == sorted(scales, reverse=True)


def test_two_meshes_do_where_they_agree_and_the_next_is_no_finer_than_it_must_be():
    assert converged(lambda scale: 5e-4 * scale**2)[2] == [1.5, 1.0]
    scales = converged(lambda scale: 1e-3 * scale**3)[2]
    assert len(scales) == 3
    assert 1 / 1.5 < scales[2] < 1 / 1.15


def test_three_fine_meshes_show_an_order_above_the_least_and_are_believed():
    def error_at(scale):
        return 1.2e-2 * scale**3

    error, stated, scales = converged(error_at, scale=0.4)
    assert scales == pytest.approx([0.9, 0.6, 0.4])
    assert stated == pytest.approx(error)


def test_a_mesh_too_coarse_for_the_shape_is_passed_over():
    def error_at(scale):
        if scale > 1.2:
            raise InvertedElementsError("inverted", kind=Kind.OUT_OF_RANGE)
        return 5e-4 * scale**2

    assert converged(error_at)[2] == pytest.approx([1.0, 1 / 1.5])


def test_what_does_not_converge_is_an_error():
    with refused(Kind.NO_RESULT, error=ConvergenceError):
        converged(lambda scale: 0.02 * scale**0.5)

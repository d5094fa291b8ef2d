"""Reflections turn a frame into the directions of a point, in both precisions."""

import numpy as np
import pytest

from localize.embedded.reflections import BLOCK, reflections

SIZE = 24
DIRECTIONS, _ = np.linalg.qr(np.random.default_rng(1).standard_normal((SIZE, SIZE)))


def turned(found):
    """Matrix of the product of the reflections, rows are directions; and their vectors."""
    matrix, vectors, at = np.eye(SIZE), [], 0
    for stage in range(0, SIZE, BLOCK):
        length = SIZE - stage
        block = found.numbers[at : at + BLOCK * length].reshape(length, BLOCK).T.astype(float)
        at += BLOCK * length
        for k in range(BLOCK):
            vector = np.zeros(SIZE)
            vector[stage:] = block[k]
            if found.steps is not None:
                step, first = found.steps.reshape(2, -1)[:, stage + k]
                vector *= float(step)
                vector[stage + k] += float(first)
            vectors.append(vector)
            matrix -= np.outer(vector, vector @ matrix)
    assert at == len(found.numbers)
    return matrix, np.array(vectors)


@pytest.mark.parametrize(("in_16_bits", "error"), [(False, 1e-6), (True, 2e-4)])
def test_the_product_of_the_reflections_is_the_directions_up_to_signs(in_16_bits: bool, error: float) -> None:
    found = reflections(DIRECTIONS, in_16_bits)
    matrix, vectors = turned(found)
    np.testing.assert_allclose(matrix @ matrix.T, np.eye(SIZE), atol=1e-6)  # whatever is rounded, lengths are kept
    np.testing.assert_allclose(np.abs(matrix @ DIRECTIONS), np.eye(SIZE), atol=error)
    np.testing.assert_allclose((vectors[:-1] ** 2).sum(1), 2.0, atol=1e-6)
    pairs = [(1, 0), (2, 0), (2, 1), (3, 0), (3, 1), (3, 2)]
    expected = [[vectors[s + j] @ vectors[s + k] for j, k in pairs] for s in range(0, SIZE, BLOCK)]
    np.testing.assert_allclose(found.couplings.reshape(-1, 6), expected, atol=1e-6)


def test_numbers_of_16_bits_have_a_step_of_their_own_for_each_vector() -> None:
    found = reflections(DIRECTIONS, True)
    assert found.numbers.dtype == np.int16
    assert found.steps is not None
    assert np.abs(found.numbers.astype(int)).max() == 32767
    assert len(np.unique(found.steps[0, : SIZE - 1])) == SIZE - 1

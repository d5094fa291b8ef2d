"""A whole array of three points in one mesh against cells joined by plane-wave ducts: the substructuring itself."""

import numpy as np
import pytest

from benchmarks.one_mesh import in_one_mesh, in_pieces, transfer_functions

FREQUENCY = np.array([1.0, 10.0, 100.0])


@pytest.mark.slow
def test_three_points_in_one_mesh_agree_with_cells_and_plane_waves_between_them():
    whole = transfer_functions(in_one_mesh(3, FREQUENCY).nodal_admittance(FREQUENCY), FREQUENCY)
    pieces = transfer_functions(in_pieces(3, FREQUENCY)[0], FREQUENCY)
    assert np.abs(pieces[-1]).min() < 0.6  # enough loss at 100 Hz for the comparison to say something
    ratio = whole / pieces
    assert np.abs(20 * np.log10(np.abs(ratio))).max() < 0.05
    assert np.abs(np.degrees(np.angle(ratio))).max() < 0.3

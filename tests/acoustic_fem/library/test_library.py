"""Libraries made from measurements: what is measured, and what stays of the library known before."""

import numpy as np
import pytest

import acoustic_fem
from acoustic_fem.library.transfer_functions import described, measured_library
from geometry.design.design_file import prototype

BAND = np.linspace(1, 100, 5)


@pytest.fixture(scope="module")
def known():
    return acoustic_fem.solve(prototype("glove"), BAND, fidelity="lumped")


def test_a_measured_library_has_the_known_impedances_and_states_what_it_comes_from(known, tmp_path):
    measured = 1.1 * known.transfer_function.values
    made = measured_library(
        known.design, known, measured, 0.01 * np.abs(measured), ("numpy", "scipy"), {"model": described(known)}
    )
    assert made.fidelity == "measured"
    np.testing.assert_array_equal(made.transfer_function, measured)
    np.testing.assert_array_equal(made.transfer_function_deviation, 0.01 * np.abs(measured))
    np.testing.assert_array_equal(made.point_impedance, known.point_impedance)
    np.testing.assert_allclose(made.source_response, 1.1 * known.source_response, rtol=1e-14)
    assert made.microphone_impedance is None
    assert (made.design, made.medium) == (known.design, known.medium)
    assert list(made.provenance["libraries"]) == ["numpy", "scipy"]
    assert made.provenance["frequency_sha256"] == known.provenance["frequency_sha256"]
    assert made.provenance["model"] == {"fidelity": "lumped", **known.provenance}
    acoustic_fem.save(made, tmp_path / "made.nc")
    np.testing.assert_array_equal(acoustic_fem.load(tmp_path / "made.nc").source_response, made.source_response)

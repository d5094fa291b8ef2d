"""Quick discs are near enough to the usual ones to rank designs by them."""

import pytest

from acoustic_fem.membrane.design_discs import design_disc, design_shape
from studies.proposals.candidates import Candidates
from studies.proposals.designer_question import question
from studies.proposals.grids import grids
from studies.proposals.quick_discs import QuickDiscs


@pytest.mark.slow
def test_quick_discs_are_within_half_a_percent_of_solved_ones():
    asked = question(points=12)
    designs = [design for design, _ in Candidates(asked, "mine", grids(asked, 12)[0]).drawn(160)]
    known = QuickDiscs(designs)
    assert known._tables.tables  # interpolated, most of them
    for design in designs[::20]:
        quick, solved = known.find(design_shape(design)), design_disc(design).model
        for name in ("compliance", "volume_per_force", "displacement_per_force"):
            assert getattr(quick, name) == pytest.approx(getattr(solved, name), rel=5e-3)
        assert quick.eigenvalues[0] == pytest.approx(solved.eigenvalues[0], rel=5e-3)

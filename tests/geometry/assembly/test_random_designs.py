"""Random designs: what the layout says can be built has no two solids in each other's way."""

from dataclasses import dataclass, field

import cadquery as cq
import pytest
from hypothesis import HealthCheck, assume, given, settings
from random_designs import designs
from thorough import many

from geometry.assembly.fit import interferences
from geometry.assembly.model import array_model
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import overlaps


@dataclass(frozen=True)
class NoMold:
    """In place of a mold, which takes half of the time to draw and lies in nobody's way."""

    parts: dict[str, cq.Workplane] = field(default_factory=dict)


@pytest.fixture(scope="module", autouse=True)
def _no_mold():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("geometry.assembly.part_list.build_mold", lambda design: NoMold())
        yield


HEALTH = [HealthCheck.filter_too_much, HealthCheck.too_slow]


@pytest.mark.slow
@settings(max_examples=many(20), deadline=None, suppress_health_check=HEALTH)
@given(design=designs())
def test_many_random_designs_that_are_said_to_be_buildable_have_no_overlap(design):
    assume(design is not None)
    layout = lay_out(design)
    assume(not overlaps(design, layout))
    assert interferences(array_model(design, layout=layout)) == ()

"""A case whose parts get into each other's way fails by name; the others are computed."""

import numpy as np

from studies.study.cases import cases_of
from studies.study.file import read_study
from studies.sweep.block import Job, solve_block
from studies.sweep.survey import surveyed

STUDY = """
base = "array-2x6"
fidelity = "lumped"
frequencies = "1:100:4"
metrics = ["distance_smallest"]
[parameters]
"microphone_tube.length" = [3.1, 12.5]
"""


def test_a_case_that_cannot_be_built_fails_with_the_reason_and_is_counted_beforehand() -> None:
    study = read_study(STUDY)
    job = Job("lumped", study.frequency, study.metrics, False)
    result, _ = solve_block(job, cases_of(study), 0, {})
    assert result.reason[0].startswith("array-2x6: cannot be built: shell 1 overlaps microphone A by ")
    assert result.reason[1] == ""
    assert np.isfinite(result.values["distance_smallest"]).tolist() == [False, True]
    assert surveyed(study, every=True).refused == {0: result.reason[0]}

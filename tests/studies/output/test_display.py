"""What the user sees while something runs."""

from __future__ import annotations

import io

from studies.output.display import Display


def test_without_a_terminal_every_line_is_told_once_though_two_report_by_turns() -> None:
    told = io.StringIO()
    with Display(told) as display, display.stage("Cells") as report:
        for fraction in (0.1, 0.2, 0.3):
            report("1 of 2: shell", fraction)
            report("2 of 2: microphone", fraction)
        report("done", 1.0)
    assert told.getvalue().splitlines()[:-1] == ["Cells: 1 of 2: shell", "Cells: 2 of 2: microphone"]

"""Display for the user while something runs."""

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


def test_stages_of_a_job_say_which_of_how_many_they_are() -> None:
    told = io.StringIO()
    with Display(told) as display:
        for name in ("Search", "Parts"):
            with display.stage(name, of=2) as report:
                report("half of it", 0.5)
    assert [line.split(": ")[0] for line in told.getvalue().splitlines()] == [
        *["Search (1 of 2)"] * 2,
        *["Parts (2 of 2)"] * 2,
    ]
    assert set(display.seconds) == {"Search", "Parts"}

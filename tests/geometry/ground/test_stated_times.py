"""The clock of written files: that of the system, or stopped by SOURCE_DATE_EPOCH, which must be a time."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest
from refusals import refused

from geometry.ground.refusal import Kind
from geometry.ground.stated_times import VARIABLE, stated_seconds, stated_time, stopped_time


def test_without_the_variable_files_state_the_time_of_the_clock(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(VARIABLE, raising=False)
    before = datetime.now(UTC)
    assert before <= stated_time() <= datetime.now(UTC)
    assert stopped_time() is None
    assert stated_seconds(2.5) == 2.5


@pytest.mark.parametrize(
    ("text", "time"),
    [("0", datetime(1970, 1, 1, tzinfo=UTC)), ("1700000000", datetime(2023, 11, 14, 22, 13, 20, tzinfo=UTC))],
)
def test_the_variable_stops_the_clock(monkeypatch: pytest.MonkeyPatch, text: str, time: datetime) -> None:
    monkeypatch.setenv(VARIABLE, text)
    assert stated_time() == stopped_time() == time
    assert stated_seconds(2.5) == 0


@pytest.mark.parametrize("text", ["", "now", "-1", "1e9", "1.5", " 1", "٣", "9" * 5000, "253402300800", "0x10"])
def test_a_variable_that_is_no_time_is_not_accepted(monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    monkeypatch.setenv(VARIABLE, text)
    with refused(Kind.OUT_OF_RANGE, VARIABLE, text):
        stated_time()

"""Refusals in tests: kind, field and value are asserted where they arise, wording in one snapshot for a family."""

from __future__ import annotations

import os
import traceback
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from geometry import Kind, Refusal

_ANY: Any = object()


@contextmanager
def refused(
    kind: Kind, field: str | None = None, value: object = _ANY, *, file: object = _ANY, error: type[Refusal] = Refusal
) -> Iterator[pytest.ExceptionInfo[Refusal]]:
    """A block that ends in a refusal of this kind, class and, where they are given, field, value and file.

    ``file`` may be a path or the last part of its name. The sentence must be one line that names field and file.
    """
    with pytest.raises(error) as found:
        yield found
    refusal = found.value
    where = "".join(traceback.format_tb(found.tb)[-1:])
    assert refusal.kind is kind, f"{refusal.kind!r}: {refusal}\n{where}"
    if field is not None:
        assert refusal.field == field, f"{refusal.field!r}: {refusal}\n{where}"
        assert field in str(refusal)
    if value is not _ANY:
        assert refusal.value == value, f"{refusal.value!r}: {refusal}\n{where}"
    if file is not _ANY:
        assert refusal.file is not None
        assert file in (refusal.file, Path(refusal.file), Path(refusal.file).name), refusal.file
        assert str(refusal).startswith(refusal.file)


def check_messages(snapshot: Path, cases: Mapping[str, Callable[[], object]], hidden: Mapping[str, str] = {}) -> None:
    """Compare the sentences of a family of refusals with those of a text file: the one place where wording is pinned.

    Args:
        snapshot: ``messages.txt`` beside the test: a line ``name: sentence`` for each case.
        cases: what each case calls; it must end in a refusal.
        hidden: texts that differ from run to run, such as a temporary folder, and what stands for each.
    """
    lines = []
    for name, call in cases.items():
        with pytest.raises(Refusal) as found:
            call()
        sentence = str(found.value)
        for text, mark in hidden.items():
            sentence = sentence.replace(text, mark)
        lines.append(f"{name}: {sentence}\n")
    text = "".join(lines)
    if os.environ.get("UPDATE_MESSAGES"):
        snapshot.write_text(text, encoding="utf-8")
    assert snapshot.read_text(encoding="utf-8") == text, "set UPDATE_MESSAGES=1 to accept the new wording, and read it"

"""No table of figures in the documentation stands without the command that made it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGES = [page for page in sorted([ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]) if "build" not in page.parts]
#: A program of ours, such as benchmarks/sweep.py, -m benchmarks.verification or tests/..., or a verb of figures.
MADE = re.compile(
    r"\b(?:benchmarks[/.][\w/.]*\w|docs/make_\w+\.py|tests/[\w/]+|"
    r"acoustic-fem (?:bend|check|fit|optimize|parts|run|tolerance)\b)"
)
#: A number, but no range of them.
NUMBER = re.compile(r"[-+±<>~ ]*\**\d(?!.*\d to \d)")
CODE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)


def sections(text: str) -> Iterator[str]:
    """The sections of a page, each with what stands before the first of them."""
    first, *rest = re.split(r"^## ", text, flags=re.MULTILINE)
    yield first
    yield from (f"{first}\n{section}" for section in rest)


def tables(text: str) -> list[str]:
    """The tables of a text as they are written; none of code."""
    return re.findall(r"(?:^\|.*\n)+", CODE.sub("", text) + "\n", re.MULTILINE)


def has_figures(table: str) -> bool:
    """Whether most cells of a table, but for its first column, begin with a number."""
    cells = [cell.strip() for row in table.splitlines()[2:] for cell in re.split(r"(?<!\\)\|", row)[2:-1]]
    numbers = sum(bool(NUMBER.match(cell)) for cell in cells)
    return numbers > 3 and 2 * numbers > sum(bool(cell) for cell in cells)


def unmade(text: str) -> list[str]:
    """Heads of tables of figures in whose section no program of ours is named that there is."""
    found = []
    for section in sections(text):
        names = [match.group() for match in MADE.finditer(section)]
        if not any(is_there(name) for name in names):
            found += [table.splitlines()[0] for table in tables(section) if has_figures(table)]
    return found


def is_there(name: str) -> bool:
    """Whether a program of ours exists."""
    return name.startswith("acoustic-fem") or any(
        (ROOT / path).exists() for path in (name, name.replace(".", "/"), f"{name.replace('.', '/')}.py")
    )


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_every_table_of_figures_has_its_command_in_its_section(page: Path) -> None:
    assert unmade(page.read_text(encoding="utf-8")) == []


def test_a_table_without_its_command_is_found() -> None:
    table = "| a | b (%) | c |\n|---|---|---|\n| x | 1.0 | **2** |\n| y | 3 ± 1 | -4 |\n"
    words = table.replace("1.0", "one").replace("3 ±", "three ±").replace("-4", "four")
    assert unmade(f"# P\n\n## S\n\n{table}") == ["| a | b (%) | c |"]
    assert unmade(f"# P\n\n## S\n\n{table}\n`python benchmarks/nothing.py`\n") == ["| a | b (%) | c |"]
    assert unmade(f"# P\n\n## S\n\n{table}\n`python benchmarks/sweep.py`\n") == []
    assert unmade(f"# P\n\n`python -m benchmarks.verification`\n\n## S\n\n{table}\n") == []
    assert unmade(f"# P\n\n## S\n\n{words}") == []

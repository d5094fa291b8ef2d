"""What the documentation says is so: its Python runs, its tables are those of the code, its links lead somewhere."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import yaml

from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import read_design
from geometry.stated.fields import fields_of

ROOT = Path(__file__).parents[2]
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])
PYTHON = re.compile(r"^```python\n(.*?)^```", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")


def page_name(page: Path) -> str:
    return str(page.relative_to(ROOT))


@pytest.mark.parametrize("page", PAGES, ids=page_name)
def test_the_python_of_a_page_runs(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The blocks of a page run one after the other, in one namespace and an empty folder."""
    monkeypatch.chdir(tmp_path)
    text = page.read_text(encoding="utf-8")
    namespace: dict[str, object] = {"__name__": "__page__"}
    for block in PYTHON.finditer(text):
        first_line = text.count("\n", 0, block.start(1))
        exec(compile("\n" * first_line + block.group(1), str(page), "exec"), namespace)


@pytest.mark.parametrize("page", PAGES, ids=page_name)
def test_the_links_of_a_page_lead_to_files(page: Path) -> None:
    for target in LINK.findall(page.read_text(encoding="utf-8")):
        if not target.startswith(("http://", "https://", "mailto:")):
            assert (page.parent / target).exists(), target


def test_the_design_page_lists_every_field_with_its_range() -> None:
    rows = {}
    for line in (ROOT / "docs" / "design-file.md").read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("| `") and len(cells) == 4:
            rows[cells[0].strip("`")] = cells
    fields = {
        field.name: field
        for field in fields_of(ArrayDesign)
        if field.kind != "a table" and not field.name.startswith(("microphone_tube.", "lines.*.tube.", "lines.*.micro"))
    }
    assert rows.keys() == fields.keys()
    for name, field in fields.items():
        default = "required" if field.required else "" if field.default in (None, "") else f"`{field.default}`"
        assert rows[name][1:] == [field_range(field.kind, field.allowed), default, field.description], name


def test_the_cluster_of_the_page_is_the_one_whose_scheduler_is_forwarded() -> None:
    page = (ROOT / "docs" / "studies.md").read_text(encoding="utf-8")
    (cluster,) = (yaml.safe_load(text) for text in re.findall(r"^```yaml\n(.*?)^```", page, re.MULTILINE | re.DOTALL))
    name, service = cluster["metadata"]["name"], cluster["spec"]["scheduler"]["service"]
    assert service["selector"]["dask.org/cluster-name"] == name
    assert f"port-forward service/{name}-scheduler {service['ports'][0]['port']}:8786" in page
    for part in ("worker", "scheduler"):
        (container,) = cluster["spec"][part]["spec"]["containers"]
        assert all(isinstance(word, str) for word in container["args"])


def field_range(kind: str, allowed: str) -> str:
    if kind == "a number":
        return allowed
    return f"{kind.split(' ', 1)[1]} {allowed}".strip()


def test_the_example_of_the_design_page_is_a_valid_design() -> None:
    text = (ROOT / "docs" / "design-file.md").read_text(encoding="utf-8")
    example = re.search(r"^```toml\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    assert example is not None
    assert read_design(example.group(1)).point_count == 12

"""What the documentation says is so: its Python runs, its tables are the code's, its paths and links lead somewhere."""

from __future__ import annotations

import ast
import importlib
import re
from functools import cache
from pathlib import Path

import house_rules
import pytest
import yaml
from imports import PACKAGES, House

from acoustic_fem.scatter.tolerances import TOLERANCES, UNCALIBRATED, Tolerance
from geometry.design.design_file import read_design
from geometry.ground.extras import EXTRAS
from studies.cli.verbs import VERBS

ROOT = Path(__file__).parents[2]
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])
PYTHON = re.compile(r"^```python\n(.*?)^```", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")


#: Pages whose blocks take 4 s and more.
LONG = {
    "CONTRIBUTING.md",
    *(
        f"docs/{name}.md"
        for name in (
            "bending",
            "calibration",
            "decoder",
            "diagnosis",
            "enclosed-air",
            "first-minutes",
            "localizer",
            "own-cavity",
            "parts",
            "python",
            "realtime",
            "training-libraries",
            "verdict",
        )
    ),
}


def page_name(page: Path) -> str:
    return str(page.relative_to(ROOT))


@pytest.mark.parametrize(
    "page",
    [
        pytest.param(page, marks=pytest.mark.slow if page_name(page) in LONG else (), id=page_name(page))
        for page in PAGES
    ],
)
def test_the_python_of_a_page_runs(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The blocks of a page run one after the other, in one namespace and an empty folder."""
    monkeypatch.chdir(tmp_path)
    text = page.read_text(encoding="utf-8")
    namespace: dict[str, object] = {"__name__": "__page__"}
    for block in PYTHON.finditer(text):
        first_line = text.count("\n", 0, block.start(1))
        code = "\n" * first_line + block.group(1)
        exec(compile(code, str(page), "exec", dont_inherit=True), namespace)


DOTTED = re.compile(rf"(?<![\w./-])(?:{'|'.join(PACKAGES)})(?:\.[A-Za-z_]\w*)+")
#: Names of files, not of Python.
ENDINGS = {"toml", "json", "html", "png", "zarr", "nc", "md", "csv", "py", "onnx", "wav"}


@cache
def leads_somewhere(path: str) -> bool:
    """Whether a dotted path is that of a module, or of a name, member or field in one."""
    parts = path.split(".")
    depth = max(k for k in range(1, len(parts) + 1) if is_module(ROOT.joinpath(*parts[:k])))
    place = importlib.import_module(".".join(parts[:depth]))
    for part in parts[depth:]:
        if part in {**getattr(place, "__annotations__", {}), **getattr(place, "model_fields", {})}:
            return True
        if not hasattr(place, part):
            return False
        place = getattr(place, part)
    return True


def is_module(path: Path) -> bool:
    return path.is_dir() or path.with_suffix(".py").is_file()


def lost_paths(text: str) -> list[str]:
    """Dotted paths of ours in a text that lead nowhere."""
    found = {match.group() for match in DOTTED.finditer(text) if match.group().rsplit(".", 1)[1] not in ENDINGS}
    return sorted(path for path in found if not leads_somewhere(path))


@pytest.mark.parametrize("page", PAGES, ids=page_name)
def test_the_dotted_paths_of_a_page_exist(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    if page.name == "CHANGELOG.md":  # old names stand on the left of its tables
        text = re.sub(r"^\|[^|]*\|", "|", text, flags=re.MULTILINE)
    assert lost_paths(text) == []


@pytest.mark.parametrize("package", PACKAGES)
def test_the_dotted_paths_of_docstrings_exist(package: str) -> None:
    lost = {}
    for path in sorted((ROOT / package).rglob("*.py")):
        texts = [
            node.value
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
            if isinstance(node, ast.Constant) and isinstance(node.value, str)
        ]
        if found := lost_paths("\n".join(texts)):
            lost[str(path)] = found
    assert lost == {}


def test_a_lost_path_is_found() -> None:
    assert lost_paths("Call `geometry.prototype`, geometry.nowhere.cell, acoustic_fem.Library.frequency_grid.") == [
        "acoustic_fem.Library.frequency_grid",
        "geometry.nowhere.cell",
    ]


@pytest.mark.parametrize("page", PAGES, ids=page_name)
def test_the_python_of_a_page_uses_public_doors_only(page: Path) -> None:
    """A package's or a room's face; what lies behind may move without notice."""
    assert private_doors(page.read_text(encoding="utf-8")) == []


def private_doors(text: str) -> list[str]:
    """Imports of a page, and what it reaches by attributes, that no face hands on."""
    house = house_of_the_checkout()
    found = []
    for block in PYTHON.finditer(text):
        for node in ast.walk(ast.parse(block.group(1))):
            if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] in PACKAGES:
                module = str(node.module)
                found += [
                    f"{module}.{alias.name}"
                    for alias in node.names
                    if alias.name not in house.handed_on.get(module, {})
                    and f"{module}.{alias.name}" not in house.handed_on
                ]
            elif isinstance(node, ast.Import):
                found += [
                    alias.name
                    for alias in node.names
                    if alias.name.split(".")[0] in PACKAGES and alias.name not in house.handed_on
                ]
            elif isinstance(node, ast.Attribute) and ast.unparse(node.value) in house.handed_on:
                face = ast.unparse(node.value)
                if not is_public(house, face, node.attr):
                    found.append(f"{face}.{node.attr}")
    return found


def is_public(house: House, face: str, name: str) -> bool:
    """Whether a face hands a name on, or the name is that of a room with a face of its own."""
    return name in house.handed_on.get(face, {}) or f"{face}.{name}" in house.handed_on


@cache
def house_of_the_checkout() -> House:
    return House(house_rules.ROOT)


def test_a_private_door_is_found() -> None:
    first = "from geometry.schema.declared_fields import fields_of", "import acoustic_fem"
    code = "\n".join([*first, "acoustic_fem.library.netcdf_file.load", ""])
    page = f"```python\n{code}```\n"
    assert private_doors(page) == ["geometry.schema.declared_fields.fields_of", "acoustic_fem.library.netcdf_file"]


@pytest.mark.parametrize("page", PAGES, ids=page_name)
def test_the_links_of_a_page_lead_to_files(page: Path) -> None:
    for target in LINK.findall(page.read_text(encoding="utf-8")):
        if not target.startswith(("http://", "https://", "mailto:")):
            assert (page.parent / target).exists(), target


@pytest.mark.parametrize("page", PAGES, ids=page_name)
def test_no_line_of_a_page_is_a_comment_of_the_site(page: Path) -> None:
    """What begins with % is shown by the forge and left out by MyST: a percentage that was wrapped."""
    prose = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    assert re.findall(r"^%.*", prose, re.MULTILINE) == []


FILE = re.compile(rf"(?<![\w./-])(?:tests|benchmarks|docs|{'|'.join(PACKAGES)})/[\w/-]+\.(?:py|md|toml|json|html)\b")


@pytest.mark.parametrize("page", PAGES, ids=page_name)
def test_the_files_that_a_page_names_exist(page: Path) -> None:
    named = FILE.findall(page.read_text(encoding="utf-8"))
    assert [path for path in named if not (ROOT / path).exists() and not (page.parent / path).exists()] == []


def test_the_cluster_of_the_page_is_the_one_whose_scheduler_is_forwarded() -> None:
    page = (ROOT / "docs" / "cluster.md").read_text(encoding="utf-8")
    (cluster,) = (yaml.safe_load(text) for text in re.findall(r"^```yaml\n(.*?)^```", page, re.MULTILINE | re.DOTALL))
    name, service = cluster["metadata"]["name"], cluster["spec"]["scheduler"]["service"]
    assert service["selector"]["dask.org/cluster-name"] == name
    assert f"port-forward service/{name}-scheduler {service['ports'][0]['port']}:8786" in page
    for part in ("worker", "scheduler"):
        (container,) = cluster["spec"][part]["spec"]["containers"]
        assert all(isinstance(word, str) for word in container["args"])


def test_the_example_of_the_design_page_is_a_valid_design() -> None:
    text = (ROOT / "docs" / "design-file.md").read_text(encoding="utf-8")
    example = re.search(r"^```toml\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    assert example is not None
    assert read_design(example.group(1)).point_count == 12


@pytest.mark.parametrize(
    ("heading", "tolerances"), [("Assumed deviations", TOLERANCES), ("Sensors that nobody calibrated", UNCALIBRATED)]
)
def test_the_deviations_of_the_tolerances_page_are_those_of_the_program(
    heading: str, tolerances: tuple[Tolerance, ...]
) -> None:
    page = (ROOT / "docs" / "tolerances.md").read_text(encoding="utf-8")
    section = re.split(r"^##", page.partition(f"# {heading}\n")[2], flags=re.MULTILINE)[0]
    rows = re.findall(r"^\| `(\w+)`[^|]*\| ([\d.]+)", section, re.MULTILINE)
    stated = {each.quantity: each.deviation * (100 if each.kind == "relative" else 1) for each in tolerances}
    assert {quantity: float(value) for quantity, value in rows} == pytest.approx(stated)


def test_the_table_of_the_installation_has_every_extra_and_every_verb_beside_what_it_needs() -> None:
    page = (ROOT / "docs" / "install.md").read_text(encoding="utf-8")
    rows = dict(re.findall(r"^\| `?(\w+)`? \| (.*?) \|", page, re.MULTILINE))
    assert set(rows) >= {*EXTRAS, "none", "all"}
    for name, verb in VERBS.items():
        found = [extra for extra, row in rows.items() if f"`{name}`" in row or f"`{name} " in row]
        wanted = {name} if name == "studio" else {*verb.needs, "all"} if name == "run" else set(verb.needs) or {"none"}
        assert wanted & set(found), f"{name} stands beside {found}, needs {verb.needs}"

"""The manual's site: every public name has one entry, and nothing is asked of another host."""

from __future__ import annotations

import importlib
import json
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from imports import PACKAGES
from matplotlib.image import imsave

from studies.study import METRICS

ROOT = Path(__file__).parents[2]


@pytest.fixture
def site(monkeypatch: pytest.MonkeyPatch):
    """Import a module of docs/site."""
    monkeypatch.syspath_prepend(str(ROOT / "docs"))
    monkeypatch.syspath_prepend(str(ROOT / "docs" / "site"))

    def load(name: str) -> ModuleType:
        return importlib.import_module(name)

    yield load
    for name in (
        "public_names",
        "built",
        "accessible",
        "cards",
        "in_browser",
        "queries",
        "search_words",
        "fields",
        "models",
        "make_architecture",
    ):
        sys.modules.pop(name, None)


def test_every_public_name_belongs_to_an_entry_on_the_page_of_a_face(site) -> None:
    names = site("public_names")
    assert tuple(PACKAGES) == names.PACKAGES
    entries = names.entries()
    pages = {face.path for face in names.faces()}
    for name, entry in entries.items():
        assert entry.rsplit(".", 1)[0] in pages, name
        assert entries[entry] == entry, name
    assert entries["acoustic_fem.solve"] == "acoustic_fem.library.solve"
    assert names.entry_of("acoustic_fem.Library.in_air") == "acoustic_fem.library.Library.in_air"
    assert names.entry_of("acoustic_fem.nothing") is None


def test_requests_to_other_hosts_and_lost_words_are_found(site, tmp_path: Path) -> None:
    built = pytest.importorskip("sphinx") and site("built")
    (tmp_path / "a.html").write_text('<a href="https://x.org"></a><script src="//x.org/y.js"></script>', "utf-8")
    (tmp_path / "b.css").write_text("@import 'https://x.org/f.css'; a {background: url(data:x)}", "utf-8")
    index = {"terms": {"mold": 1, "calibr": 2, "altitud": 3, "port": 4}, "titleterms": {}, "objects": {}}
    searched = tmp_path / "searchindex.js"
    searched.write_text(f"Search.setIndex({json.dumps(index)})", "utf-8")
    assert built.outside_requests(tmp_path) == ["a.html: //x.org/y.js", "b.css: https://x.org/f.css"]
    assert built.not_found(tmp_path) == ["port_admittance"]
    assert built.main(tmp_path) == 1
    index["objects"] = {"acoustic_fem.duct": [[0, 1, 2, "", "port_admittance"]]}
    searched.write_text(f"Search.setIndex({json.dumps(index)})", "utf-8")
    assert built.not_found(tmp_path) == []


def test_signatures_that_show_what_pydantic_makes_are_found(site, tmp_path: Path) -> None:
    built = pytest.importorskip("sphinx") and site("built")
    (tmp_path / "a.html").write_text(
        '<dl><dt class="sig py"><em>f</em>(n: Annot<b>ated</b>[int, Le(le=50)])</dt><dd>Annotated</dd>'
        '<dt class="sig">g(n: int)</dt></dl>',
        "utf-8",
    )
    assert built.machinery(tmp_path) == ["a.html: f(n: Annotated[int, Le(le=50)])"]


def test_the_reference_has_every_field_of_a_file_with_type_range_and_words(site) -> None:
    models = pytest.importorskip("sphinx") and site("models")
    from geometry import ArrayDesign
    from geometry.schema import Membrane, Resonator, StatedArray

    lines = models.field_lines(Resonator)
    at = lines.index(".. py:attribute:: floor_thickness")
    assert lines[at + 1 : at + 3] == ["   :type: float", "   :value: 1.0"]
    assert lines[at + 4] == "   Thickness of the floor; between 0.3 and 20 mm."
    assert "   Diameter of the air cavity; between 0.8 and 50 mm; required." in lines
    assert any("between 1 and 1.9; a ratio." in line for line in models.field_lines(Membrane))
    assert sum(line.startswith(".. py:attribute::") for line in models.field_lines(StatedArray)) == len(
        StatedArray.model_fields
    )
    (inherited, _) = models.field_lines(ArrayDesign)
    assert inherited.startswith("Fields of :py:obj:`geometry.schema.StatedArray`:")
    assert all(f"`{name} <" in inherited for name in ArrayDesign.model_fields)


def test_the_design_page_has_every_field_once_with_range_unit_and_words(site) -> None:
    fields = site("fields")
    page = (ROOT / "docs" / "design-file.md").read_text(encoding="utf-8")
    listed = [
        field.name
        for words in re.findall(r"^```\{fields\} (.*)$", page, re.MULTILINE)
        for field in fields.fields_named(words.split())
    ]
    assert sorted(listed) == sorted(fields.stated_fields())
    assert (
        "| `resonator.cavity_diameter` | between 0.8 and 50 mm | required | diameter of the air cavity |\n"
        in fields.field_table(["resonator"])
    )
    with pytest.raises(ValueError, match="'resonators' is neither"):
        fields.fields_named(["resonators"])


def test_the_fields_of_a_study_file_are_those_that_are_read(site) -> None:
    fields = site("fields")
    assert "| `cases` | whole number between 1 and 10000000 |" in fields.study_table("study")
    assert "| `from` |" in fields.study_table("range")
    assert "| `objectives.*.better` | text 'larger', 'smaller' |" in fields.study_table("optimize")
    with pytest.raises(ValueError, match="'search' must be one of: study, range, optimize"):
        fields.study_table("search")


def test_the_page_of_metrics_has_them_all(site) -> None:
    table = site("fields").metric_table()
    assert (
        "| `volume` | mm^3 | smaller | Volume of shells, housings, boards, membranes and tubes, without their air. |"
        in table
    )
    assert [line.split("`")[1] for line in table.splitlines()[2:]] == list(METRICS)
    assert "```{metrics}" in (ROOT / "docs" / "metrics.md").read_text(encoding="utf-8")


@pytest.mark.slow
def test_the_gallery_says_what_check_says() -> None:
    import geometry
    import studies
    from studies.run import design_quality

    design = geometry.load_design(ROOT / "docs" / "examples" / "wristband-16.toml")
    quality, verdict = design_quality(design), studies.Verdict(design)
    row = next(row for row in json.loads((ROOT / "docs/gallery.json").read_text("utf-8")) if row["name"] == design.name)
    found = {"as_built": quality.as_built, "worst": quality.worst, "nominal": quality.nominal}
    assert {key: row[key] for key in found} == {key: round(100 * value, 1) for key, value in found.items()}
    assert (row["verdict"], row["taps"]) == (verdict.outcome, round(100 * verdict.figures.taps, 1))


def test_the_gallery_has_a_card_and_a_section_for_every_design(site) -> None:
    import geometry

    cards = pytest.importorskip("sphinx") and site("cards")
    page = (ROOT / "docs" / "gallery.md").read_text(encoding="utf-8")
    rows = cards.read_rows(ROOT / "docs")
    names = [row["name"] for row in rows]
    assert set(names) <= set(re.findall(r"^### (.*)$", page, re.MULTILINE))
    assert set(geometry.prototype_names()) <= set(names)
    for row in rows:
        assert all((ROOT / f"docs/images/gallery/{row['name']}.{kind}").is_file() for kind in ("png", "webp"))
        assert f'data-verdict="{row["verdict"]}"' in cards.data_of(row)
        assert f"<dd>{row['cost']:.2f} USD</dd>" in cards.facts(row)
    form = cards.form(rows)
    assert re.findall(r'<select name="(\w+)"', form) == ["verdict", "process", "points", "cost", "length"]
    assert all(f'value="{row["process"]}"' in form for row in rows)


def test_people_search_for_forty_things_and_each_has_its_page(site) -> None:
    queries, words = site("queries").QUERIES, pytest.importorskip("sphinx") and site("search_words").WORDS
    assert sum(map(len, queries.values())) >= 40
    for page in {**queries, **words}:
        assert (ROOT / "docs" / f"{page}.md").is_file(), page
    typed = " ".join(query for each in queries.values() for query in each)
    asked = ("robot", "gripper", "battery", "spring supplier", "silicone supplier", "cost", "latency", "waterproof")
    for word in (*asked, "calibrat", "arduino"):
        assert word in typed


def test_no_group_of_the_side_bar_is_longer_than_a_glance() -> None:
    index = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    groups = re.findall(r"^:caption: \w+\n:hidden:\n\n(.*?)^```", index, re.MULTILINE | re.DOTALL)
    assert len(groups) == 10
    assert max(len(group.split()) for group in groups) <= 9


#: Job of a designer -> the guide to it.
JOBS = {
    "design a sensor": "tutorial",
    "choose its wiring": "studies/topology/README",
    "compare designs": "compare",
    "sweep": "studies",
    "sweep on many machines": "cluster",
    "print and cast": "parts",
    "assemble": "assemble",
    "calibrate": "calibration",
    "listen": "live",
    "follow a finger": "tracks",
    "train kinds of one's own": "kinds",
    "read letters": "letters",
    "bring a cavity": "own-cavity",
    "put it on a chip": "embed",
}


@pytest.mark.parametrize("job", JOBS)
def test_every_job_has_a_guide_that_is_found_and_shows_a_picture(job: str) -> None:
    page = JOBS[job]
    index, text = ((ROOT / "docs" / f"{name}.md").read_text(encoding="utf-8") for name in ("index", page))
    groups = re.findall(r"^:caption: (?:Start|Design|Make|Use)\n:hidden:\n\n(.*?)^```", index, re.MULTILINE | re.DOTALL)
    assert len(groups) == 4
    assert page in "".join(groups).splitlines()
    assert f"]({page}.md)" in index
    assert re.search(r"^!\[[^\]]+\]\(\S+\.png\)$", text, re.MULTILINE), "no picture"


def test_a_newcomer_types_every_block_and_looks_at_the_pictures(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "docs"))
    newcomer = importlib.import_module("newcomer")
    monkeypatch.delitem(sys.modules, "newcomer")
    page = tmp_path / "page.md"
    page.write_text(
        "`a.toml`:\n\n```toml\nyes = 1\n```\n\n```sh\nacoustic-fem check a --picture a.png\n```\n\n"
        "```toml\nno = 1\n```\n\n```bash\nmine\n```\n\n```sh\ntrue  # draws b/c.html\n```\n",
        "utf-8",
    )
    script = newcomer.typed(page).splitlines()
    assert script == [
        "set -eo pipefail",
        newcomer.MARGINAL,
        *("cat > a.toml <<'END'", "yes = 1", "END"),
        "acoustic-fem check a --picture a.png",
        ".venv/bin/python docs/newcomer.py --look a.png",
        "true  # draws b/c.html",
        ".venv/bin/python docs/newcomer.py --look b/c.html",
    ]
    for name in (*newcomer.START, *newcomer.GUIDES):
        blocks = newcomer.blocks_of(newcomer.page_of(ROOT, name))
        # From page to page in one terminal: nobody is led elsewhere.
        assert not re.search(r"^cd ", "".join(blocks), re.MULTILINE), name
        assert name in ("README", "studio") or any(map(newcomer.pictures_of, blocks)), f"{name}: no picture to look at"


def test_a_newcomer_sees_whether_a_picture_shows_anything(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "docs"))
    newcomer = importlib.import_module("newcomer")
    monkeypatch.delitem(sys.modules, "newcomer")
    blank, page = tmp_path / "blank.png", tmp_path / "page.html"
    imsave(blank, np.ones((900, 1400, 3)))
    page.write_text("<html><head>" + "x" * 9000 + "</head><body></body></html>", "utf-8")
    assert not newcomer.shows_something(blank)
    assert not newcomer.shows_something(page)
    assert newcomer.shows_something(ROOT / "docs" / "images" / "array-2x6.png")


@pytest.mark.parametrize(
    ("visit", "farewell", "ends_with", "code"),
    [
        ("well", "The studio has ended", 0, 0),
        ("well", "", 0, 1),
        ("with a fault", "The studio has ended", 0, 1),
        ("well", "The studio has ended", 3, 3),
    ],
)
def test_a_newcomer_ends_what_serves_by_ctrl_c(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, visit: str, farewell: str, ends_with: int, code: int
) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "docs"))
    newcomer = importlib.import_module("newcomer")
    monkeypatch.delitem(sys.modules, "newcomer")
    # Many short pauses: a shell that is interrupted while it starts a command handles the trap after that command.
    serves = "set +x; for _ in $(seq 600); do sleep 0.1; done"
    script = f"trap 'printf \"{farewell}\"; exit {ends_with}' INT; echo {newcomer.VISITED}{visit}; {serves}"
    before = time.monotonic()
    assert newcomer.in_terminal(script, tmp_path, dict(os.environ)) == code
    assert time.monotonic() - before < 55


@pytest.mark.slow
@pytest.mark.parametrize("page", ["first-minutes", "studio"])
@pytest.mark.skipif(sys.prefix == sys.base_prefix, reason="a newcomer works in a virtual environment")
def test_a_newcomer_gets_through_the_first_minutes(page: str) -> None:
    """The commands of a page as printed, in a clone of what is committed, and the picture or page that they show."""
    if page == "studio" and not (shutil.which("chromium") or shutil.which("chromium-browser")):
        pytest.skip("there is no chromium; Debian: apt install chromium")
    words = [sys.executable, str(ROOT / "docs" / "newcomer.py"), "--venv", sys.prefix, page]
    # What the commands print is UTF-8, whatever the locale is.
    done = subprocess.run(words, capture_output=True, encoding="utf-8", timeout=600, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    assert done.stdout.rstrip().endswith(f"{page}: done")


def test_pages_are_put_right_for_readers_of_screens_once(site) -> None:
    accessible = pytest.importorskip("sphinx") and site("accessible").accessible
    page = '<pre id="a"></pre><dl>\n<dd>n: int</dd>\n</dl><dl><dt>a</dt></dl>'
    better = accessible(page)
    assert better == (
        '<pre tabindex="0" id="a"></pre>'
        '<span class="arguments">\n<span class="argument">n: int</span>\n</span><dl><dt>a</dt></dl>'
    )
    assert accessible(better) == better


@pytest.mark.parametrize(("page", "opened"), [(' class="current-page"', "Guides"), ("", "Start")])
def test_sections_of_the_navigation_close_but_that_of_the_page(site, page: str, opened: str) -> None:
    accessible = pytest.importorskip("sphinx") and site("accessible").accessible
    caption = '<p class="caption" role="heading"><span class="caption-text">{}</span></p>\n<ul>\n<li{}>x</li>\n</ul>\n'
    text = f"<div>\n{caption.format('Start', '')}{caption.format('Guides', page)}\n</div>"
    better = accessible(text)
    parts = re.findall(r"<details( open)?><summary class=\"caption\"><span class=\"caption-text\">(\w+)<", better)
    assert parts == [(" open" if name == opened else "", name) for name in ("Start", "Guides")]
    assert better.count("</ul></details>") == 2
    assert accessible(better) == better


@pytest.mark.slow
@pytest.mark.end_to_end
def test_the_browser_finds_what_is_too_wide_and_what_axe_core_calls_serious(site, tmp_path: Path, capsys) -> None:
    in_browser = site("in_browser")
    if not (shutil.which("chromium") or shutil.which("chromium-browser")):
        pytest.skip("there is no chromium; Debian: apt install chromium")
    pytest.importorskip("axe_playwright_python")
    page = '<!doctype html><html lang="en"><title>x</title><main><h1>x</h1>{}</main></html>'
    (tmp_path / "good.html").write_text(page.format("<p>x</p>"), "utf-8")
    (tmp_path / "bad.html").write_text(page.format('<div style="width: 800px">x</div><img src="x.png">'), "utf-8")
    assert in_browser.main(tmp_path, ("good",), {}) == 0
    assert capsys.readouterr().err == ""
    assert in_browser.main(tmp_path, ("good", "bad"), {}) == 1
    found = capsys.readouterr().err
    assert "good" not in found
    assert "bad, 390 px, dark: 4" in found
    assert "bad, 1440 px, light: image-alt (critical): img" in found
    assert "bad, 1440 px, light: 4" not in found
    (tmp_path / "search.html").write_text(
        page.format('<p class="search-summary">1</p><ul class="search"><li><a href="x.html?h=1#y">x</a></ul>'), "utf-8"
    )
    assert in_browser.main(tmp_path, (), {"x": ["word"]}) == 0
    assert in_browser.main(tmp_path, (), {"y": ["word"]}) == 1
    assert "search for 'word': finds x first, must find y" in capsys.readouterr().err


def test_without_chromium_the_site_is_not_looked_at_and_that_is_said(site, tmp_path: Path, capsys, monkeypatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    assert site("in_browser").main(tmp_path) == 0
    assert "there is no chromium" in capsys.readouterr().out

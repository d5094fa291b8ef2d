"""The manual's site: every public name has one entry, and nothing is asked of another host."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path
from types import ModuleType

import pytest
from imports import PACKAGES

ROOT = Path(__file__).parents[2]


@pytest.fixture
def site(monkeypatch: pytest.MonkeyPatch):
    """Import a module of docs/site."""
    monkeypatch.syspath_prepend(str(ROOT / "docs" / "site"))

    def load(name: str) -> ModuleType:
        return importlib.import_module(name)

    yield load
    for name in ("public_names", "built"):
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
    built = site("built")
    (tmp_path / "a.html").write_text('<a href="https://x.org"></a><script src="//x.org/y.js"></script>', "utf-8")
    (tmp_path / "b.css").write_text("@import 'https://x.org/f.css'; a {background: url(data:x)}", "utf-8")
    (tmp_path / "searchindex.js").write_text(
        'Search.setIndex({"terms": {"mold": 1, "calibr": 2, "altitud": 3}, "titleterms": {}, "objects": {}})', "utf-8"
    )
    assert built.outside_requests(tmp_path) == ["a.html: //x.org/y.js", "b.css: https://x.org/f.css"]
    assert built.not_found(tmp_path) == ["port_admittance"]
    assert built.main(tmp_path) == 1

"""The bundle that the browser loads is built from the page's source, and small."""

from __future__ import annotations

import gzip
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
STUDIO = ROOT / "studies" / "studio"
#: Folders that are built into, below the root.
BUILT = (Path("studies/studio/static"), Path("geometry/templates"))
MOST = 300_000


def test_the_page_is_small() -> None:
    page = [path.read_bytes() for path in sorted((STUDIO / "static").iterdir())]
    assert sum(len(gzip.compress(content)) for content in page) <= MOST


@pytest.mark.slow
def test_the_bundle_is_made_of_the_source(tmp_path: Path) -> None:
    """With the exact tools that package-lock.json names, in a folder of its own."""
    npm = shutil.which("npm")
    if npm is None:
        pytest.skip("npm is not installed")
    page = tmp_path / "studies" / "studio" / "page"
    shutil.copytree(STUDIO / "page", page, ignore=shutil.ignore_patterns("node_modules"))
    for folder in BUILT:
        (tmp_path / folder).mkdir(parents=True)

    def run(*words: str) -> subprocess.CompletedProcess[str]:
        # What npm prints is UTF-8, whatever the locale.
        return subprocess.run([npm, *words], cwd=page, capture_output=True, encoding="utf-8", check=False)

    installed = run("ci", "--silent", "--no-audit", "--no-fund")
    if installed.returncode != 0:
        pytest.skip(f"npm ci: {installed.stderr.strip()[-200:]}")
    for task in ("check", "build"):
        done = run("run", task)
        assert done.returncode == 0, done.stdout + done.stderr
    for folder in BUILT:
        made = sorted((tmp_path / folder).iterdir())
        assert made
        for path in made:
            assert path.read_bytes() == (ROOT / folder / path.name).read_bytes(), f"npm run build: {path.name}"

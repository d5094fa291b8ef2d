"""Do what the manual says, as printed: ``python docs/newcomer.py [--guides] [PAGE ...]``; by default README and Start.

Writes the files that a page gives (a ``toml`` block below the file's name) and types its ``sh`` blocks, unchanged and
in order, into one shell in a fresh clone of the checkout. It ends with exit code 1 at the first command that fails, or
picture or page that a block names and nobody drew, or that shows nothing. What takes recordings of one's own is in
``bash`` blocks: nobody types it. On a bare machine the first block of README installs everything; ``--venv .venv``
takes an installation that there is. What listens to a sound card or serves a page until it is stopped cannot be done
this way.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
START = ("README", "install", "first-minutes", "tutorial")
GUIDES = (
    *("studies/topology/README", "compare", "first-study", "studies", "cluster", "optimize", "tolerances", "parts"),
    *("assemble", "bending", "calibration", "realtime", "live", "tracks", "kinds", "letters", "pulse", "embed"),
    *("own-cavity", "applications/gripper-pad", "applications/first-day"),
)
BLOCK = re.compile(r"^```sh\n(.*?)^```", re.MULTILINE | re.DOTALL)
FILE = re.compile(r"`([\w-]+\.toml)`:\n\n```toml\n(.*?)^```", re.MULTILINE | re.DOTALL)
PICTURE = re.compile(r"(?<![\w./-])[\w./-]+\.(?:png|html)\b")
#: The exit code 3 of ``check`` is that of a marginal design, and a page goes on with it.
MARGINAL = 'acoustic-fem() { command acoustic-fem "$@" || { local code=$?; [ $code = 3 ] || return $code; }; }'
#: Of a picture that shows something: the least share of pixels unlike its corner; of a page: bytes of its body.
INKED, SMALLEST = 0.01, 5_000


def page_of(root: Path, name: str) -> Path:
    """The file of a page: README at the top of a checkout, all others in the manual."""
    return root / "README.md" if name == "README" else root / "docs" / f"{name}.md"


def blocks_of(page: Path) -> list[str]:
    """The shell blocks of a page."""
    return BLOCK.findall(page.read_text(encoding="utf-8"))


def pictures_of(block: str) -> list[str]:
    """The pictures and pages that a block names."""
    return list(dict.fromkeys(PICTURE.findall(block)))


def shows_something(path: Path) -> bool:
    """Whether a picture is more than its background, or a page has anything in its body."""
    if path.suffix == ".html":
        return len(path.read_bytes().partition(b"<body")[2]) > SMALLEST
    from matplotlib.image import imread

    pixels = imread(path)[..., :3]
    return bool((pixels != pixels[0, 0]).any(-1).mean() > INKED)


def typed(page: Path) -> str:
    """A script that types the blocks of a page, stops where one fails, and looks at the pictures of each."""
    lines = ["set -eo pipefail", MARGINAL]
    for name, text in FILE.findall(page.read_text(encoding="utf-8")):
        lines += [f"cat > {name} <<'END'", text + "END"]
    for block in blocks_of(page):
        lines += [block.rstrip()]
        lines += [f".venv/bin/python docs/newcomer.py --look {name}" for name in pictures_of(block)]
    return "\n".join(lines) + "\n"


def main() -> int:
    """Exit code: 0 where all pages could be done."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pages", nargs="*", metavar="PAGE")
    parser.add_argument("--guides", action="store_true", help="the pages of Guides, an hour or so of one core")
    parser.add_argument("--venv", type=Path, help="an installation to use as .venv of the clone")
    parser.add_argument(
        "--look", type=Path, metavar="FILE", help="only say whether this picture or page shows anything"
    )
    asked = parser.parse_args()
    if asked.look is not None:
        print(f"{asked.look}: {'seen' if (seen := shows_something(asked.look)) else 'shows nothing'}")
        return 0 if seen else 1
    with tempfile.TemporaryDirectory() as folder:
        clone = Path(folder) / "acoustic-fem"
        subprocess.run(["git", "clone", "--quiet", str(ROOT), str(clone)], check=True)
        if asked.venv is not None:
            (clone / ".venv").symlink_to(asked.venv.resolve())
            for name in ("pyproject.toml", "constraints.txt"):
                os.utime(clone / name, (0, 0))  # older than the installation: make leaves it as it is
        for name in asked.pages or (GUIDES if asked.guides else START):
            script = typed(page_of(clone, name))
            if name not in START[:2]:  # both install
                script = ". .venv/bin/activate\n" + script  # what the page says was done before
            own = {"PYTHONPATH": str(clone)} if asked.venv is not None else {}
            done = subprocess.run(["bash", "-x", "-c", script], cwd=clone, check=False, env={**os.environ, **own})
            print(f"{name}: {'done' if done.returncode == 0 else f'ended with {done.returncode}'}", flush=True)
            if done.returncode:
                return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

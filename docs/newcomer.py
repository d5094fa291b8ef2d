"""Do what the manual says, as printed: ``python docs/newcomer.py [--guides] [PAGE ...]``; by default README and Start.

Writes the files that a page gives (a ``toml`` block below the file's name) and types its ``sh`` blocks, unchanged and
in order, into one shell in a fresh clone of the checkout. It ends with exit code 1 at the first command that fails, or
picture or page that a block names and nobody drew, or that shows nothing. What takes recordings of one's own is in
``bash`` blocks: nobody types it. On a bare machine the first block of README installs everything; ``--venv .venv``
takes an installation that there is, and with ``--wheel`` its package, too. What listens to a sound card cannot be done
this way. The studio serves its page until it is stopped, so it runs in a terminal of its own. The browser that it opens
is ``--visit`` of this script, which changes one field of the page in Chromium. Then Ctrl-C ends the studio.
"""

from __future__ import annotations

import argparse
import os
import pty
import re
import select
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
START = ("README", "install", "first-minutes", "tutorial", "studio")
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
#: Command that serves until Ctrl-C, and the longest time in s that it may take.
SERVES, LONGEST, CTRL_C = re.compile(r"^acoustic-fem studio\b", re.MULTILINE), 400.0, b"\x03"
#: Seconds after which Ctrl-C is pressed again.
AGAIN = 5.0
#: Lines that the visitor of its page prints at the end, and the studio after Ctrl-C.
VISITED, ENDED = "The visit has ended: ", "The studio has ended"
#: Field of the page that the visitor changes, to which value.
FIELD, VALUE = "tube.length", "14"
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


def in_shell(script: str, clone: Path, environment: dict[str, str]) -> int:
    """Run a script in a folder and return its exit code."""
    return subprocess.run(["bash", "-x", "-c", script], cwd=clone, check=False, env=environment).returncode


def in_terminal(script: str, clone: Path, environment: dict[str, str]) -> int:
    """Run a script that serves a page in a terminal, press Ctrl-C after the visit, and return the exit code.

    A shell may lose a Ctrl-C while it starts a command, so it is pressed again if nothing has ended after a while.

    The exit code is 1 if the visit failed or did not end in time, or if the studio does not say that it has ended.
    """
    child, terminal = pty.fork()
    if child == 0:
        os.chdir(clone)
        os.execvpe("bash", ["bash", "-x", "-c", script], environment)
    end, printed, pressed = time.monotonic() + LONGEST, "", 0.0
    while (now := time.monotonic()) < end:
        if VISITED in printed and now > pressed + AGAIN:
            os.write(terminal, CTRL_C)
            pressed = now
        if not select.select([terminal], [], [], min(AGAIN, end - now))[0]:
            continue
        try:
            chunk = os.read(terminal, 4096)
        except OSError:  # Linux says so when nobody holds the other end any more
            break
        print(chunk.decode("utf-8", "replace"), end="", flush=True)
        printed += chunk.decode("utf-8", "replace")
    os.close(terminal)  # hangs up on what still runs
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    return code if f"{VISITED}well" in printed and ENDED in printed else code or 1


def visit(address: str) -> bool:
    """Open the page of a studio, change a field, and return whether the page has followed without a fault."""
    sys.path.append(str(ROOT / "tests" / "support"))
    from browser import chromium, give, opened_at, shown

    with chromium() as browser:
        page = opened_at(browser.new_context(), address)
        stages, curves = ("model", "points", "verdict", "as_built"), page.locator("#plots canvas").first
        shown(page, *stages)
        before = curves.screenshot(), page.inner_text("#verdict-shown")
        give(page, FIELD, VALUE)
        shown(page, *stages)
        after = curves.screenshot(), page.inner_text("#verdict-shown")
        print(f"before: {before[1]}\n{FIELD} = {VALUE}: {after[1]}", *page.problems, sep="\n")
        return not page.problems and before[0] != after[0]


def main() -> int:
    """Exit code: 0 where all pages could be done."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pages", nargs="*", metavar="PAGE")
    parser.add_argument("--guides", action="store_true", help="the pages of Guides, an hour or so of one core")
    parser.add_argument("--venv", type=Path, help="an installation to use as .venv of the clone")
    parser.add_argument("--wheel", action="store_true", help="run the package that --venv has, not that of the clone")
    parser.add_argument(
        "--look", type=Path, metavar="FILE", help="only say whether this picture or page shows anything"
    )
    parser.add_argument("--visit", metavar="ADDRESS", help="only open a studio in Chromium and change a field")
    asked = parser.parse_args()
    if asked.look is not None:
        print(f"{asked.look}: {'seen' if (seen := shows_something(asked.look)) else 'shows nothing'}")
        return 0 if seen else 1
    if asked.visit is not None:
        followed = False
        try:
            followed = visit(asked.visit)
        finally:
            print(f"{VISITED}{'well' if followed else 'with a fault'}", flush=True)
        return 0 if followed else 1
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
            own = {"PYTHONPATH": str(clone)} if asked.venv is not None and not asked.wheel else {}
            own["BROWSER"] = f"{sys.executable} {clone}/docs/newcomer.py --visit %s"
            run = in_terminal if SERVES.search(script) else in_shell
            code = run(script, clone, {**os.environ, **own})
            print(f"{name}: {f'ended with {code}' if code else 'done'}", flush=True)
            if code:
                return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

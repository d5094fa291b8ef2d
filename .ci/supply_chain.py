"""What an installation consists of: a lock with hashes and an SBOM for each extra, and an audit for known flaws.

    python .ci/supply_chain.py lock [EXTRA ...]     build/supply-chain/EXTRA.lock, for pip install --require-hashes
    python .ci/supply_chain.py sbom [EXTRA ...]     build/supply-chain/EXTRA.cdx.json, CycloneDX, of those locks
    python .ci/supply_chain.py audit                packages of .venv against published advisories, by pip-audit

Without EXTRA all extras of users are taken, and ``core``, which is the installation without one. The tools get an
environment of their own, build/tools. The audit needs an index: where it cannot be had, it says why and ends with
exit code 0; known flaws end it with exit code 1.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[1]
OUT = ROOT / "build" / "supply-chain"
TOOLS = ROOT / "build" / "tools"
PACKAGES = ("cyclonedx-bom>=7", "pip-audit>=2.9", "pip-tools>=7.5")
#: Extras of those who work on the program.
OF_DEVELOPERS = {"dev", "docs", "verify"}


def main(words: list[str]) -> int:
    """Exit code."""
    verb, *extras = words or [""]
    every = ["core", *_extras()]
    if verb not in ("lock", "sbom", "audit") or set(extras) - set(every):
        print(__doc__, file=sys.stderr)
        return 2
    if not _have_tools():
        if verb == "audit":
            print("audit skipped: its tools cannot be installed, as pip reaches no index")
            return 0
        print("The tools cannot be installed, as pip reaches no index.", file=sys.stderr)
        return 1
    if verb == "audit":
        return audit()
    OUT.mkdir(parents=True, exist_ok=True)
    for extra in extras or every:
        print((lock if verb == "lock" else sbom)(extra).relative_to(ROOT), flush=True)
    return 0


def _extras() -> list[str]:
    content = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    return [name for name in content["project"]["optional-dependencies"] if name not in OF_DEVELOPERS]


def _have_tools() -> bool:
    """True if the tools are there, or could be installed."""
    mark = TOOLS / ".installed"
    if mark.exists() and mark.read_text(encoding="utf-8").split() == list(PACKAGES):
        return True
    subprocess.run([sys.executable, "-m", "venv", str(TOOLS)], check=True)
    command = [str(TOOLS / "bin" / "python"), "-m", "pip", "install", "--quiet", "--retries", "1", *PACKAGES]
    if subprocess.run(command, check=False, stderr=subprocess.DEVNULL).returncode != 0:
        return False
    mark.write_text("\n".join(PACKAGES), encoding="utf-8")
    return True


def lock(extra: str) -> Path:
    """File of the exact versions that an extra brings, each with the hashes of its files; no address of an index."""
    path = OUT / f"{extra}.lock"
    options = ["--generate-hashes", "--allow-unsafe", "--strip-extras", "--no-header", "--no-annotate", "--quiet"]
    options += ["--no-emit-index-url", "--no-emit-trusted-host", "--no-emit-find-links"]
    chosen = [] if extra == "core" else ["--extra", extra]
    command = [str(TOOLS / "bin" / "pip-compile"), *options, "--constraint", "constraints.txt", *chosen]
    subprocess.run([*command, "--output-file", str(path), "pyproject.toml"], cwd=ROOT, check=True)
    return path


def sbom(extra: str) -> Path:
    """CycloneDX file of what the lock of an extra lists; the lock is made where it is missing."""
    source, path = OUT / f"{extra}.lock", OUT / f"{extra}.cdx.json"
    if not source.exists():
        lock(extra)
    command = [str(TOOLS / "bin" / "cyclonedx-py"), "requirements", "--output-reproducible", "--of", "JSON"]
    command += ["--pyproject", "pyproject.toml", "--output-file", str(path), str(source)]
    subprocess.run(command, cwd=ROOT, check=True)
    listed = {component["name"] for component in json.loads(path.read_text(encoding="utf-8"))["components"]}
    locked = set(re.findall(r"^([A-Za-z0-9._-]+)==", source.read_text(encoding="utf-8"), re.MULTILINE))
    if listed != locked:
        raise RuntimeError(f"{path} and {source} differ in {sorted(listed ^ locked)}")
    return path


def audit() -> int:
    """Exit code: 1 where an installed package has a known flaw."""
    command = [str(ROOT / ".venv" / "bin" / "python"), "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"]
    installed = subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()
    options = [
        "--path",
        installed,
        "--skip-editable",
        "--format",
        "json",
        "--progress-spinner",
        "off",
        "--timeout",
        "10",
    ]
    done = subprocess.run(
        [str(TOOLS / "bin" / "pip-audit"), *options], check=False, capture_output=True, text=True, cwd=ROOT
    )
    try:
        found = json.loads(done.stdout)["dependencies"]
    except (ValueError, KeyError):
        lines = done.stderr.strip().splitlines() or ["no answer"]
        print(f"audit skipped: pip-audit had no advisories: {lines[-1]}")
        return 0
    audited = [each for each in found if "skip_reason" not in each]
    if not audited:
        print(f"audit skipped: the index has advisories for none of the {len(found)} packages")
        return 0
    flawed = [each for each in audited if each["vulns"]]
    for each in flawed:
        for flaw in each["vulns"]:
            fixed = ", ".join(flaw["fix_versions"]) or "no version yet"
            print(f"{each['name']} {each['version']}: {flaw['id']}, fixed in {fixed}")
    print(f"audit: {len(audited)} packages, {len(flawed)} with a known flaw, {len(found) - len(audited)} not audited")
    return int(bool(flawed))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

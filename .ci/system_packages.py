"""Look for the system libraries that the CAD kernel, the mesher and the renderer load; install what is missing.

Needs only Python's own library, as it runs before anything is installed. Installs with apt-get where it may
(Debian or Ubuntu, as root); otherwise prints the one line to type and ends with exit code 1. With --tests it also
installs, where it may, the browser that drives the studio's page, compiler and emulator of microcontrollers, and other
programs that read our files; without them those tests are skipped.
"""

from __future__ import annotations

import ctypes
import importlib.util
import os
import runpy
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

OLDEST_PYTHON = (3, 11)

ROOT = Path(__file__).parents[1]
#: Library as the loader knows it: Debian package.
LIBRARIES = runpy.run_path(str(ROOT / "geometry" / "ground" / "system_libraries.py"))["LIBRARIES"]
#: Command that some tests run: Debian packages.
TEST_TOOLS = {
    "chromium": ("chromium", "libatomic1"),  # the library is of the Node in Playwright
    "arm-none-eabi-gcc": ("gcc-arm-none-eabi", "libnewlib-arm-none-eabi"),
    "qemu-system-arm": ("qemu-system-arm",),
    "octave-cli": ("octave", "octave-netcdf"),
    "ngspice": ("ngspice",),
    "prusa-slicer": ("prusa-slicer",),
}


def main() -> int:
    """Exit code: 0 where everything is there or was installed."""
    if sys.version_info < OLDEST_PYTHON:
        found, needed = (".".join(map(str, version[:2])) for version in (sys.version_info, OLDEST_PYTHON))
        print(f"acoustic-fem needs Python {needed} or later; {sys.executable} is {found}.", file=sys.stderr)
        print("Name another one: make PYTHON=python3.12 demo", file=sys.stderr)
        return 1
    if "--tests" in sys.argv[1:] and shutil.which("apt-get") and os.geteuid() == 0:
        for tool, names in TEST_TOOLS.items():
            if not shutil.which(tool):
                install([*names])  # what cannot be had is no obstacle
    packages = missing_packages()
    if not packages:
        return 0
    print(f"Missing system packages: {' '.join(packages)}", flush=True)
    if shutil.which("apt-get") and os.geteuid() == 0:
        if install(packages):
            packages = missing_packages()
            if not packages:
                return 0
            print(f"Still missing after the installation: {' '.join(packages)}", file=sys.stderr)
        else:
            print("apt-get failed; its messages are above.", file=sys.stderr)
    command = ["apt-get", "install", "-y", "--no-install-recommends", *packages]
    as_root = [] if os.name != "posix" or os.geteuid() == 0 else ["sudo"]
    print("Type this line (or what does the same on your system), then make again:", file=sys.stderr)
    print(f"    {shlex.join([*as_root, *command])}", file=sys.stderr)
    return 1


def missing_packages() -> list[str]:
    """Debian packages of what this Python cannot load."""
    packages = [] if importlib.util.find_spec("ensurepip") else ["python3-venv"]
    if sys.platform == "linux":  # the wheels for macOS and Windows bring their own
        packages += [package for library, package in LIBRARIES.items() if not can_load(library)]
    return packages


def can_load(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True


def install(packages: list[str]) -> bool:
    """Install with apt-get, showing its messages only where it fails. A minimal machine has no lists yet."""
    environment = os.environ | {"DEBIAN_FRONTEND": "noninteractive"}
    for command in (["update"], ["install", "-y", "--no-install-recommends", *packages]):
        print(f"apt-get {command[0]} ...", flush=True)
        result = subprocess.run(
            ["apt-get", "-q", *command],
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            check=False,
        )
        if result.returncode != 0:
            print(result.stdout, file=sys.stderr)
            return False
    return True


if __name__ == "__main__":
    sys.exit(main())

"""Libraries of the system that the CAD kernel, the mesher and the renderer load, and what to install without them."""

from __future__ import annotations

import ctypes
import re
import sys

#: Library as the loader knows it: Debian package. Found with ldd on the wheels of gmsh, OpenCascade and VTK.
LIBRARIES = {
    "libEGL.so.1": "libegl1",  # loaded by name: without it VTK's off-screen rendering ends in a segmentation fault
    "libGL.so.1": "libgl1",
    "libGLU.so.1": "libglu1-mesa",
    "libX11.so.6": "libx11-6",
    "libXcursor.so.1": "libxcursor1",
    "libXext.so.6": "libxext6",
    "libXfixes.so.3": "libxfixes3",
    "libXft.so.2": "libxft2",
    "libXinerama.so.1": "libxinerama1",
    "libXrender.so.1": "libxrender1",
    "libfontconfig.so.1": "libfontconfig1",
    "libgomp.so.1": "libgomp1",
}


def missing_libraries() -> list[str]:
    """Libraries that this process cannot load; none on systems other than Linux, where wheels bring their own."""
    return [each for each in LIBRARIES if not _can_load(each)] if sys.platform == "linux" else []


def what_is_missing(message: str) -> str:
    """One line on the libraries of the system without which a module cannot be loaded; empty for other failures.

    Args:
        message: of the error with which it was to be loaded.
    """
    found = re.match(r"(lib[^\s:/]+\.so[^\s:/]*): cannot open shared object file", message)
    if found is None:
        return ""
    name = found[1]
    if name not in LIBRARIES:
        return f"{name}: this library of the system is missing; install the package that holds it"
    packages = dict.fromkeys([LIBRARIES[name], *(LIBRARIES[each] for each in missing_libraries())])
    return (
        f"{name}: this library of the system is missing; on Debian and Ubuntu type: sudo apt-get install -y "
        f"--no-install-recommends {' '.join(packages)}"
    )


def _can_load(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True

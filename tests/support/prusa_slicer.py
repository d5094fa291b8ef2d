"""PrusaSlicer as another reader of our files: the pictures that it would project, layer by layer."""

import shutil
import subprocess
import zipfile
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from scipy import ndimage

from geometry.schema.print_processes import PrintProcess

#: Pixels of fine machines are made this wide, mm: pictures of a whole plate would fill the memory.
FINEST = 0.03
#: Neighbours of a pixel, those at its corners too.
_AROUND = np.ones((3, 3))


@dataclass(frozen=True)
class Sliced:
    """Layers of a file."""

    lit: np.ndarray
    """Number of pixels of each layer that are lit at least by half."""
    islands: int
    """Number of connected patches that nothing in the layer below touches, from the second layer on."""
    said: str
    """Messages of the program, in small letters."""


def _islands(below: np.ndarray, layer: np.ndarray) -> int:
    """Number of connected patches of a layer that the layer below does not touch."""
    if np.array_equal(below, layer):
        return 0
    rows, columns = (np.flatnonzero((below | layer).any(axis)) for axis in (1, 0))
    if not len(rows):
        return 0
    window = np.s_[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    labels, number = ndimage.label(layer[window], _AROUND)
    held = labels[layer[window] & ndimage.binary_dilation(below[window], _AROUND)]
    return int(number - len(np.unique(held)))


def slice_file(path: Path, process: PrintProcess, folder: Path) -> Sliced:
    """Slice a 3MF or STL file by a profile of a process; skips the test where PrusaSlicer is missing."""
    program = shutil.which("prusa-slicer")
    if program is None:
        pytest.skip("there is no prusa-slicer; Debian: apt install prusa-slicer")
    profile, sliced = folder / "process.ini", folder / f"{path.stem}.sl1"
    profile.write_text(_profile(process), encoding="utf-8")
    line = [program, "--export-sla", "--load", str(profile), "--output", str(sliced), str(path)]
    done = subprocess.run(line, capture_output=True, text=True, timeout=600, check=False)
    said = (done.stdout + done.stderr).lower()
    assert done.returncode == 0, said[-500:]
    lit, islands, below = list[int](), 0, None
    with zipfile.ZipFile(sliced) as archive:  # picture by picture: those of thin layers would fill the memory
        for name in sorted(each for each in archive.namelist() if each.endswith(".png") and "thumbnail" not in each):
            layer = np.asarray(Image.open(BytesIO(archive.read(name))).convert("L")) >= 128
            lit.append(int(layer.sum()))
            islands += 0 if below is None else _islands(below, layer)
            below = layer
    sliced.unlink()
    return Sliced(np.array(lit), islands, said)


def _profile(process: PrintProcess) -> str:
    """Profile of PrusaSlicer for a resin printer with the figures of a process."""
    width, depth, height = process.build_volume
    pixels = (round(width / max(process.pixel, FINEST)), round(depth / max(process.pixel, FINEST)))
    values = {
        "printer_technology": "SLA",
        "bed_shape": f"0x0,{width}x0,{width}x{depth},0x{depth}",
        **{"display_width": width, "display_height": depth},
        **{"display_pixels_x": pixels[0], "display_pixels_y": pixels[1], "display_orientation": "landscape"},
        **{"display_mirror_x": 0, "display_mirror_y": 0, "max_print_height": height},
        **{"layer_height": process.layer, "initial_layer_height": process.layer, "faded_layers": 3},
        **{"supports_enable": 0, "pad_enable": 0, "elefant_foot_compensation": 0, "absolute_correction": 0},
    }
    return "".join(f"{name} = {value}\n" for name, value in values.items())

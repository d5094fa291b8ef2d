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
_FINEST = 0.03
#: Neighbours of a pixel, those at its corners too.
_AROUND = np.ones((3, 3))


@dataclass(frozen=True)
class Sliced:
    """Layers of a file."""

    layers: list[np.ndarray]
    """Pixels that are lit at least by half, one picture a layer."""
    said: str
    """Messages of the program, in small letters."""

    @property
    def islands(self) -> int:
        """Number of connected patches that nothing in the layer below touches, from the second layer on."""
        count = 0
        for below, layer in zip(self.layers, self.layers[1:], strict=False):
            labels, number = ndimage.label(layer, _AROUND)
            count += number - len(np.unique(labels[layer & ndimage.binary_dilation(below, _AROUND)]))
        return count


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
    with zipfile.ZipFile(sliced) as archive:
        names = sorted(name for name in archive.namelist() if name.endswith(".png") and "thumbnail" not in name)
        layers = [np.asarray(Image.open(BytesIO(archive.read(name))).convert("L")) >= 128 for name in names]
    sliced.unlink()
    return Sliced(layers, said)


def _profile(process: PrintProcess) -> str:
    """Profile of PrusaSlicer for a resin printer with the figures of a process."""
    width, depth, height = process.build_volume
    pixels = (round(width / max(process.pixel, _FINEST)), round(depth / max(process.pixel, _FINEST)))
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

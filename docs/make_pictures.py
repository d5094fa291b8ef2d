"""Draw pictures of the pages: top view, exploded view and mold section of every prototype that was made (parts.md), and
waveforms of kinds of touch (kinds.md).

python docs/make_pictures.py [NAME ...]
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

import geometry
from geometry.assembly.model import array_model
from geometry.pictures.mold_cut import mold_section
from geometry.pictures.views import exploded_view, top_view
from studies.output.figure_style import WIDTH, figure_in_style, save_figure

IMAGES = Path(__file__).parent / "images"
#: The prototypes that were made; the others are simulated studies.
MADE = ("array-2x6", "fingertip-3x4", "fingertip-4x6", "glove", "large-area-64")


def draw(name: str) -> list[Path]:
    """The three pictures of one prototype."""
    model = array_model(geometry.prototype(name))
    return [
        top_view(model, IMAGES / f"{name}-top.png", (1200, 750)),
        exploded_view(model, IMAGES / f"{name}-exploded.png", (1200, 750)),
        mold_section(model, IMAGES / f"{name}-mold.png", (1200, 600)),
    ]


def draw_kinds() -> list[Path]:
    """One waveform of each kind of event and texture."""
    from localize.recognition import EVENTS, PROFILES, SPEED, event_pressure, texture_pressure

    random = np.random.default_rng(3)
    waves = {name: event_pressure(name, 1024, random) for name in EVENTS}
    waves |= {profile.name: texture_pressure(profile, 1024, SPEED, random) for profile in PROFILES}
    with figure_in_style((WIDTH, 6.0)) as figure:
        for axes, (name, wave) in zip(figure.subplots(5, 4, sharex=True).flat, waves.items(), strict=True):
            axes.plot(np.arange(len(wave)), wave / np.abs(wave).max(), linewidth=0.6)
            axes.set_title(name, fontsize="small")
            axes.set_yticks([])
        figure.supxlabel("time  (ms)")
        return [save_figure(figure, IMAGES / "kinds-waveforms.png")]


#: Pictures that are of no prototype.
OTHERS = {"kinds": draw_kinds}


def main() -> None:
    """Draw those named on the command line, or all."""
    names = sys.argv[1:] or (*MADE, *OTHERS)
    for name in names:
        if name not in (*MADE, *OTHERS):
            raise SystemExit(f"{name}: must be of {', '.join((*MADE, *OTHERS))}")
    for name in names:
        for path in OTHERS[name]() if name in OTHERS else draw(name):
            print(path)


if __name__ == "__main__":
    main()

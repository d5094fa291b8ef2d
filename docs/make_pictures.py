"""Draw pictures of the pages: top view, exploded view and open mold of every prototype that was made (parts.md), and
waveforms of kinds of touch (kinds.md), a finger's path with its signals (touches.md), flash of decoders
(embed.md), and levels of two designs (compare.md).

python docs/make_pictures.py [NAME ...]
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

import numpy as np

import geometry
from geometry.assembly.model import array_model
from geometry.pictures.mold_cut import open_mold
from geometry.pictures.views import exploded_view, top_view
from studies.output.figure_style import WIDTH, figure_in_style, save_figure

IMAGES = Path(__file__).parent / "images"
#: The prototypes that were made; the others are simulated studies.
MADE = ("array-2x6", "fingertip-3x4", "fingertip-4x6", "glove", "large-area-64")

#: Flash for everything but the decoder, KiB.
REST = 32


def draw(name: str) -> list[Path]:
    """The three pictures of one prototype."""
    model = array_model(geometry.prototype(name))
    return [
        top_view(model, IMAGES / f"{name}-top.png", (1200, 750)),
        exploded_view(model, IMAGES / f"{name}-exploded.png", (1200, 750)),
        open_mold(model, IMAGES / f"{name}-mold.png", (1200, 750)),
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


def draw_touches() -> list[Path]:
    """A finger that writes an S on the large area: its path over the membranes, and the microphones' signals."""
    from matplotlib.patches import Circle

    import acoustic_fem
    from localize.contacts import finger, record
    from localize.signals import response_of

    library = acoustic_fem.solve(geometry.prototype("large-area-64"), np.arange(1.0, 201.0), fidelity="lumped")
    array = response_of(library)
    turn = np.linspace(0.15 * np.pi, 1.5 * np.pi, 60)
    upper = np.column_stack([70 + 34 * np.cos(turn), 90 + 27 * np.sin(turn)])
    path = np.vstack([upper, np.array([140.0, 126.0]) - upper[::-1]])
    take = record(finger(path, 60.0, sample=4), library, microphone_noise="design")
    pressed = np.flatnonzero(take.force)[::20]
    with figure_in_style((WIDTH, 4.0)) as figure:
        over, beside = figure.subplots(1, 2, width_ratios=(1, 1.2))
        for place, radius in zip(array.position, array.membrane_radius, strict=True):
            over.add_patch(Circle(tuple(place), radius, facecolor="#e8c9bd", edgecolor="#999999", linewidth=0.5))
        dots = over.scatter(*take.path[pressed].T, c=take.time[pressed], s=6, zorder=3)
        figure.colorbar(dots, ax=over, label="time  (s)", shrink=0.7)
        over.set(aspect="equal", xlabel="x  (mm)", ylabel="y  (mm)", title="path of the finger's middle")
        over.grid(visible=False)
        apart = np.ptp(take.signals)
        for row, (name, signal) in enumerate(zip(array.microphones, take.signals, strict=True)):
            beside.plot(take.time, signal - row * apart, linewidth=0.8)
            beside.annotate(name, (take.time[-1], -row * apart), xytext=(4, 6), textcoords="offset points")
        beside.set(yticks=[], xlabel="time  (s)", title=f"microphones, {apart:.1f} Pa from line to line")
        return [save_figure(figure, IMAGES / "touches.png")]


def draw_letters() -> list[Path]:
    """Each letter as it is written on the large area, and where the array hears it."""
    import acoustic_fem
    from localize.contacts import ContactRecorder
    from localize.recognition import LETTERS, Hand, LineReader, written
    from localize.signals import response_of

    library = acoustic_fem.solve(geometry.prototype("large-area-64"), np.arange(0.5, 501.0, 1.5), "lumped")
    array = response_of(library)
    reader, recorder = LineReader(array, "design"), ContactRecorder(array, microphone_noise="design")
    with figure_in_style((WIDTH, 2.0)) as figure:
        for number, (axes, letter) in enumerate(zip(figure.subplots(2, 13).flat, LETTERS, strict=True)):
            contact = written(letter, array, Hand(), 3, sample=number)
            line = reader.line(recorder.take(contact, number).signals)
            axes.plot(*array.position.T, ".", color="0.85", markersize=2)
            axes.plot(*contact.path[contact.force > 0].T, ".", markersize=0.8)
            axes.scatter(line[:, 1], line[:, 2], s=8 * line[:, 3], color="C3")
            axes.set(xticks=[], yticks=[], aspect="equal")
        return [save_figure(figure, IMAGES / "letters-written.png")]


def draw_chips() -> list[Path]:
    """Flash that the decoder of every prototype takes, as the evidence tells it, beside what chips have."""
    page = (IMAGES.parent / "evidence" / "embed.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| ([\w-]+ \(\d+, \d\)) \| (\d+), (\d+) \|", page, re.MULTILINE)
    places = np.arange(len(rows))
    with figure_in_style((WIDTH, 2.8)) as figure:
        axes = figure.subplots()
        for k, label in enumerate(("float32", "int16")):
            axes.barh(places + 0.4 * k, [int(row[1 + k]) for row in rows], 0.38, label=label)
        for flash in (256, 512, 1024, 2048):
            axes.axvline(flash - REST, color="gray", linestyle=":", linewidth=0.8)
        axes.set_xscale("log", base=2)
        axes.set_xticks([256, 512, 1024, 2048, 8192], ["256 KiB", "512 KiB", "1 MiB", "2 MiB", "8 MiB"])
        axes.set_yticks(places + 0.2, [row[0] for row in rows])
        axes.invert_yaxis()
        axes.set_xlabel(f"flash; dotted: a chip's, less {REST} KiB for other code")
        axes.legend()
        return [save_figure(figure, IMAGES / "chips.png")]


def draw_compared() -> list[Path]:
    """Levels of two prototypes over each other."""
    import studies

    figure = studies.compare("array-2x6", "glove", printing=False).plot()
    return [save_figure(figure, IMAGES / "compared.png")]


#: Pictures that are of no prototype.
OTHERS = {
    "chips": draw_chips,
    "compared": draw_compared,
    "kinds": draw_kinds,
    "letters": draw_letters,
    "touches": draw_touches,
}


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

"""Files of a circuit board: a KiCad project, and what a board maker takes, also as one archive to upload."""

from __future__ import annotations

import zipfile
from pathlib import Path

from geometry.boards.board_picture import board_drawing
from geometry.boards.board_pieces import BoardPlan
from geometry.boards.gerber_layers import gerber_layers
from geometry.boards.kicad_board import kicad_board, kicad_project
from geometry.ground.typed import PathLike
from geometry.ground.whole_files import made_folder, whole_file, write_text

#: Name of the files.
_NAME = "microphone-board"
#: Date of the files in an archive: the first that the format knows, so that two archives of one board are equal.
_DATE = (1980, 1, 1, 0, 0, 0)


def write_board(plan: BoardPlan, folder: PathLike) -> tuple[Path, ...]:
    """Write the files of a board; existing files are replaced only by complete ones.

    Args:
        plan: the board.
        folder: created if needed.

    Returns:
        Paths of the files: KiCad project, picture, archive for the board maker, then its layers and holes.
    """
    folder = made_folder(folder)
    words = f"Board of microphone {plan.microphone} from above: head with connector, neck, seat with the sound hole"
    texts = {
        f"{_NAME}.kicad_pcb": kicad_board(plan),
        f"{_NAME}.kicad_pro": kicad_project(plan, _NAME),
        f"{_NAME}.svg": board_drawing(plan, words) + "\n",
    }
    layers = {f"{_NAME}-{end}": text for end, text in gerber_layers(plan).items()}
    for name, text in texts.items():
        write_text(folder / name, text)
    archive = folder / f"{_NAME}-gerber.zip"
    with whole_file(archive) as beside, zipfile.ZipFile(beside, "w", zipfile.ZIP_DEFLATED) as packed:
        for name, text in layers.items():
            packed.writestr(zipfile.ZipInfo(name, _DATE), text, zipfile.ZIP_DEFLATED)
    gerber = made_folder(folder / "gerber")
    for name, text in layers.items():
        write_text(gerber / name, text)
    return (*(folder / name for name in texts), archive, *(gerber / name for name in layers))

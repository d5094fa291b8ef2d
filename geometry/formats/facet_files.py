"""Files of solids that have facets and no CAD surface, such as a body with pockets: written, read back and compared."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from geometry.formats.three_mf import Body, read_3mf, write_3mf
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.whole_files import made_folder, whole_file

if TYPE_CHECKING:
    from geometry.solids.measure import Tessellation

#: Formats that hold facets.
FACET_FORMATS = ("stl", "3mf")
#: Largest difference of the volume of a file from that of its facets, as a fraction: files hold single precision.
_VOLUME = 1e-5


def export_facets(
    name: str,
    facets: Tessellation,
    genus: int,
    folder: Path,
    formats: Sequence[str],
    parameters: Mapping[str, float | int | str],
    design_toml: str = "",
) -> tuple[Path, ...]:
    """Write one closed body to ``folder/NAME.FORMAT``, in mm.

    Args:
        name: of the file and of the body in it.
        facets: closed, outwards.
        genus: ways through the body.
        folder: created if needed.
        formats: of the files; those that hold no facets are left out.
        parameters: written into a 3MF file.
        design_toml: text of the design, written into a 3MF file.

    Returns:
        The files.

    Raises:
        Refusal: a file that was read back is not one closed body of the genus and the volume.
    """
    import trimesh

    folder = made_folder(folder)
    files = []
    for format_ in (each for each in formats if each in FACET_FORMATS):
        path = folder / f"{name}.{format_}"
        with whole_file(path) as beside:
            if format_ == "stl":
                trimesh.Trimesh(facets.vertices, facets.triangles, process=False).export(beside, file_type="stl")
                read = trimesh.load_mesh(beside, file_type="stl")
            else:
                write_3mf([Body(name, facets, parameters)], name, beside, design_toml=design_toml)
                read = read_3mf(beside)[name]
            error = float(read.volume) / facets.volume - 1
            if not read.is_volume or read.euler_number != 2 - 2 * genus or abs(error) > _VOLUME:
                problem = (
                    f"is not the closed body that was written (closed: {read.is_watertight}, Euler number: "
                    f"{read.euler_number}, volume off by {error:.1g})"
                )
                raise Refusal(problem, kind=Kind.NO_RESULT, file=path)
        files.append(path)
    return tuple(files)

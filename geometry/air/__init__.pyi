from .cells import (
    Cell as Cell,
    CellCatalogue as CellCatalogue,
    CellUse as CellUse,
    cell_catalogue as cell_catalogue,
)
from .mesh import (
    InvertedElementsError as InvertedElementsError,
    MeshSizes as MeshSizes,
    Point as Point,
    SolidMesh as SolidMesh,
    mesh_solid as mesh_solid,
)
from .mirror_symmetry import mirror_half as mirror_half
from .volume import MIDPLANE as MIDPLANE, MIRROR as MIRROR, OPENING as OPENING, air_volume as air_volume
from .wound_tube import (
    FIRST as FIRST,
    LAST as LAST,
    Winding as Winding,
    closest_pitch as closest_pitch,
    swept_mesh as swept_mesh,
)

from . import (
    atlas as atlas,
    batch as batch,
    calibration as calibration,
    cavity as cavity,
    cell as cell,
    circuit as circuit,
    duct as duct,
    enclosed as enclosed,
    fields as fields,
    library as library,
    membrane as membrane,
    network as network,
    numerics as numerics,
    quantities as quantities,
    scatter as scatter,
    sound as sound,
)
from .library.exchange import load as load, save as save
from .library.netcdf_file import LibraryError as LibraryError
from .library.solving import solve as solve
from .library.transfer_functions import Library as Library
from .quantities.fidelity import FIDELITIES as FIDELITIES
from .quantities.local_air import LocalAir as LocalAir
from .quantities.medium import Medium as Medium

from .network import (
    batch_response as batch_response,
    batch_transfer_function as batch_transfer_function,
    each_alone as each_alone,
)
from .numpy_or_torch import namespace as namespace
from .parameters import (
    ArrayParameters as ArrayParameters,
    MediumParameters as MediumParameters,
    fits_batch as fits_batch,
)
from .topology import Topology as Topology

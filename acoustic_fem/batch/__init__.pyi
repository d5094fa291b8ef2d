from .network import batch_response as batch_response, batch_transfer_function as batch_transfer_function
from .numpy_or_torch import namespace as namespace
from .parameters import (
    ArrayParameters as ArrayParameters,
    MediumParameters as MediumParameters,
)
from .topology import Topology as Topology

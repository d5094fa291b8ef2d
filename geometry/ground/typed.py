"""Types of arrays and paths that signatures share."""

from __future__ import annotations

import os
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
"""An array of real numbers; its shape and unit stand in the docstring."""
ComplexArray: TypeAlias = NDArray[np.complex128]
"""An array of complex numbers, exp(+j omega t)."""
NumpyOrTorch: TypeAlias = Any
"""An array of NumPy or a tensor of torch: code that takes it runs on either."""
PathLike: TypeAlias = str | os.PathLike[str]
"""The path of a file or folder."""

"""Defaults of calls that the help of a verb shows too: ``--help`` reads them here and imports no call."""

from __future__ import annotations

from typing import Literal

SEED = 0
"""Seed of touches, of simulated sensors and of draws."""
HELD_OUT_TOUCHES = 200
"""Number of held-out touches of every point in an evaluation."""
SENSORS, BASE_SAMPLES, STORED_SENSORS = 256, 128, 0
"""Numbers of a tolerance study: as-built sensors, base samples of the Sobol indices, and sensors that are stored."""
BEST_DESIGNS = 10
"""Number of designs in a list of the best."""
FULL_SCALE = 1.0
"""Pressure at full scale of live input, Pa."""
RECALIBRATION_SECONDS = 60.0
"""Processor time after which the search of a recalibration ends, s."""
PRECISION: Literal["float32"] = "float32"
"""Numbers of the tables of an exported decoder."""
EMBEDDED_PREFIX = "touch"
"""First part of the names in an exported decoder."""
BOARD: Literal["cortex-m"] = "cortex-m"
"""Board that a decoder is exported for."""
CONVERTER_BITS = 16
"""Bits of a sample of the converter of a board."""
TAKES, TAKE_SECONDS = 2, 6.0
"""Numbers of the touches of a virtual rig: recordings of each part at each point, and the length of each, s."""
MANIFEST = "calibration.toml"
"""Manifest that a folder of calibration recordings must contain."""
TOUCHES, SAMPLES_PER_SHARD = 4096, 4096
"""Numbers of a data set: samples of every design, and of a shard."""
DATASET_FORMAT: Literal["npz"] = "npz"
"""Files of the shards of a data set."""
CONTENTS = ("library", "state-space", "circuit")
"""Contents of a file that a library is converted to."""
STATE_SPACE_ERROR = 1e-3
"""Largest error of a state space, relative to each response at each frequency."""

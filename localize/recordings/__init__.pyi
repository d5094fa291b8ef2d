from .accelerometer import (
    Acceleration as Acceleration,
    AccelerationFile as AccelerationFile,
    read_acceleration as read_acceleration,
)
from .recording import (
    HIGHEST_RATE as HIGHEST_RATE,
    LOWEST_RATE as LOWEST_RATE,
    read_recording as read_recording,
)
from .same_take import find_same_take as find_same_take
from .touch_manifest import (
    PARTS as PARTS,
    Part as Part,
    TouchManifestError as TouchManifestError,
    TouchRecording as TouchRecording,
    read_touch_manifest as read_touch_manifest,
    split as split,
)

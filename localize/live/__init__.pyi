from .events import (
    HOP as HOP,
    Decision as Decision,
    Fault as Fault,
    State as State,
    TrackedPlace as TrackedPlace,
)
from .listener import Heard as Heard, Latencies as Latencies, LiveListener as LiveListener, Notice as Notice
from .recorder import LiveRecorder as LiveRecorder
from .sound_device import DeviceSource as DeviceSource, input_devices as input_devices
from .sources import ReplaySource as ReplaySource, Source as Source
from .spare import StreamLocator as StreamLocator
from .stream import REFUSED as REFUSED, TouchStream as TouchStream
from .touches import Array as Array

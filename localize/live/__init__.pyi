from .events import (
    HOP as HOP,
    Decision as Decision,
    DownTouch as DownTouch,
    Fault as Fault,
    SeveralTouches as SeveralTouches,
    State as State,
    TrackedPlace as TrackedPlace,
)
from .listener import Heard as Heard, Latencies as Latencies, LiveListener as LiveListener, Notice as Notice
from .recorder import LiveRecorder as LiveRecorder
from .serial_frames import FrameReader as FrameReader
from .sound_device import DeviceSource as DeviceSource, input_devices as input_devices, no_device as no_device
from .sources import ReplaySource as ReplaySource, Source as Source
from .stream import TouchStream as TouchStream
from .stream_options import AS_IT_COMES as AS_IT_COMES, StreamOptions as StreamOptions, TouchOptions as TouchOptions

from .features import PairFeatures as PairFeatures
from .recorded_frames import RecordedFrames as RecordedFrames
from .wavelets import BANDWIDTH as BANDWIDTH, CONTINUATION as CONTINUATION, GRID as GRID, TAIL as TAIL

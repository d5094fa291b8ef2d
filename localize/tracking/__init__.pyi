from .footprints import pitch_of as pitch_of
from .path import PathTracker as PathTracker, Track as Track
from .path_gestures import Gesture as Gesture, GestureTracker as GestureTracker, gesture_of as gesture_of
from .position import PositionDecoder as PositionDecoder, Positions as Positions
from .signal_track import track as track, tracks_of as tracks_of
from .sliding import Slide as Slide, straight_slide as straight_slide

from .footprints import pitch_of as pitch_of
from .gestures import Gesture as Gesture, GestureTracker as GestureTracker, gesture_of as gesture_of
from .path import PathTracker as PathTracker, Track as Track
from .position import PositionDecoder as PositionDecoder, Positions as Positions
from .recorded import track as track, tracks_of as tracks_of
from .sliding import Slide as Slide, straight_slide as straight_slide

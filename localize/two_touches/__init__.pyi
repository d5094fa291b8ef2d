from .touch_watch import TwoTouchWatch as TwoTouchWatch
from .two_touch_decoder import (
    FoundTouch as FoundTouch,
    TouchesAtOnce as TouchesAtOnce,
    TwoTouchDecoder as TwoTouchDecoder,
)
from .two_touch_options import TwoTouchOptions as TwoTouchOptions

from .contact import Contact as Contact, covered_force as covered_force, hertz_fraction as hertz_fraction
from .contact_shapes import (
    BRUSH as BRUSH,
    FEATHER as FEATHER,
    FINGER as FINGER,
    STYLUS as STYLUS,
    Tool as Tool,
    air_puff as air_puff,
    brush as brush,
    falling_grain as falling_grain,
    feather as feather,
    finger as finger,
    insect as insect,
    joined as joined,
    rolling_ball as rolling_ball,
    stroke as stroke,
    stylus as stylus,
)
from .draws import Stream as Stream
from .finger_gestures import (
    double_tap as double_tap,
    press as press,
    slide as slide,
    tap as tap,
)
from .large_presses import LargePresses as LargePresses
from .overload import loudest_outputs as loudest_outputs
from .pulses import (
    PulseShape as PulseShape,
    Rhythm as Rhythm,
    pulse_times as pulse_times,
    pulse_wave as pulse_wave,
)
from .simulated_recording import ContactRecorder as ContactRecorder, Take as Take, record as record

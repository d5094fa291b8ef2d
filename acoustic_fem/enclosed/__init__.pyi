from .enclosed_state import EnclosedAir as EnclosedAir, enclosed_air as enclosed_air
from .sealed_sensor import SealedSensor as SealedSensor
from .vents import (
    Vent as Vent,
    design_vent as design_vent,
    suggested_vent as suggested_vent,
    vent_level as vent_level,
)

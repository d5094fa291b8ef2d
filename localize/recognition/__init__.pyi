from .event_kinds import EVENTS as EVENTS, event_pressure as event_pressure
from .handwriting import LetterMaker as LetterMaker, LineReader as LineReader, letter_maps as letter_maps
from .letter_classifier import Hand as Hand, written as written
from .letter_shapes import LETTERS as LETTERS
from .pulse import PulseReader as PulseReader, PulseReading as PulseReading, waves_of as waves_of
from .recorded_takes import windows_of as windows_of
from .takes import SUBJECTS as SUBJECTS, TakeMaker as TakeMaker, at_usual_speed as at_usual_speed
from .textures import (
    PROFILES as PROFILES,
    SPEED as SPEED,
    Profile as Profile,
    texture_force as texture_force,
    texture_pressure as texture_pressure,
)

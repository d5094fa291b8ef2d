from .bayes import BayesDecoder as BayesDecoder
from .decoder_options import DecoderOptions as DecoderOptions, TolerantOptions as TolerantOptions
from .frame_covariance import (
    low_pass as low_pass,
    sampled_waves as sampled_waves,
    source_density as source_density,
    whitening as whitening,
)
from .hand_motion import HandMotion as HandMotion
from .judgement import ResidualTest as ResidualTest
from .likelihood import DecoderTables as DecoderTables
from .motion_test import MotionTest as MotionTest
from .reconstruct import Reconstructor as Reconstructor
from .sound_test import SoundTest as SoundTest
from .surroundings import ROOM as ROOM, sound_levels as sound_levels
from .tolerant import (
    TolerantDecoder as TolerantDecoder,
    decoder_of as decoder_of,
    tolerant_decoder as tolerant_decoder,
)

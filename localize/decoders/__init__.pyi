from .bayes import (
    ROOM as ROOM,
    BayesDecoder as BayesDecoder,
    sound_levels as sound_levels,
)
from .frame_covariance import (
    low_pass as low_pass,
    sampled_waves as sampled_waves,
    source_density as source_density,
    whitening as whitening,
)
from .judgement import ResidualTest as ResidualTest
from .likelihood import (
    POWERS as POWERS,
    SCREEN_ERROR as SCREEN_ERROR,
    SURE as SURE,
    TEMPERATURE as TEMPERATURE,
    DecoderTables as DecoderTables,
)
from .reconstruct import Reconstructor as Reconstructor
from .sound_test import SoundTest as SoundTest
from .tolerant import (
    TolerantDecoder as TolerantDecoder,
    tolerant_decoder as tolerant_decoder,
)

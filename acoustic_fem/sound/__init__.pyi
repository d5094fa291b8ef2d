from .clipping import first_clipped as first_clipped
from .estimate import (
    Estimator as Estimator,
    TransferEstimate as TransferEstimate,
    amplitudes as amplitudes,
    shortest_record as shortest_record,
    transfer_estimate as transfer_estimate,
)
from .growing_wav import GrowingWav as GrowingWav
from .sound_file import (
    MATRIX as MATRIX,
    Sound as Sound,
    SoundFileError as SoundFileError,
    read_sound as read_sound,
    read_wav as read_wav,
    write_wav as write_wav,
)

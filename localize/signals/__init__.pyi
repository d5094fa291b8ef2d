from .array_response import (
    ArrayResponse as ArrayResponse,
    TransferFunctionSource as TransferFunctionSource,
    response_of as response_of,
)
from .disturbances import (
    LOWEST_SOUND as LOWEST_SOUND,
    REFERENCE as REFERENCE,
    MicrophoneMismatch as MicrophoneMismatch,
    check_ambient as check_ambient,
)
from .finger_stimuli import (
    RecordedStimulus as RecordedStimulus,
    friction as friction,
    presses as presses,
    pulse_wave as pulse_wave,
    slides as slides,
    taps as taps,
)
from .finger_strokes import (
    press_strokes as press_strokes,
    slide_strokes as slide_strokes,
    tap_strokes as tap_strokes,
)
from .frames import (
    FRAME as FRAME,
    checked_signals as checked_signals,
    combined_probability as combined_probability,
    cut_frames as cut_frames,
)
from .motion import (
    fitted_motion as fitted_motion,
    motion_signals as motion_signals,
    pressures_of_motion as pressures_of_motion,
    without_motion as without_motion,
)
from .noise_model import (
    NoiseChoice as NoiseChoice,
    NoiseSpectrum as NoiseSpectrum,
    microphone_noise as microphone_noise,
)
from .propagation import (
    impulse_response as impulse_response,
    late_energy as late_energy,
    microphone_signals as microphone_signals,
    short_window_signals as short_window_signals,
)
from .random_streams import Purpose as Purpose, choice as choice, random_words as random_words, uniform as uniform
from .resampling import StreamResampler as StreamResampler, at_one_kilohertz as at_one_kilohertz
from .same_array import (
    check_same_array as check_same_array,
    check_same_design as check_same_design,
    design_difference as design_difference,
)
from .stimulus import (
    BAND as BAND,
    COMPONENT_INTERVALS as COMPONENT_INTERVALS,
    NOISE as NOISE,
    SAMPLE_LENGTH as SAMPLE_LENGTH,
    SAMPLE_RATE as SAMPLE_RATE,
    Device as Device,
    StimulusSource as StimulusSource,
    line_frequencies as line_frequencies,
    multi_sines as multi_sines,
    time_signal as time_signal,
)
from .stimulus_kinds import STIMULI as STIMULI, Louder as Louder, Mixture as Mixture
from .threads import one_thread as one_thread
from .touch_generator import (
    TouchGenerator as TouchGenerator,
    TouchSignals as TouchSignals,
)

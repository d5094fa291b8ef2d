from .boards import BoardName as BoardName
from .budget import (
    Budget as Budget,
    Cost as Cost,
    LargeDecoderWarning as LargeDecoderWarning,
    cost_of as cost_of,
    in_units as in_units,
)
from .c_export import EmbeddedDecoder as EmbeddedDecoder, embed as embed
from .converter import (
    CoarseConverterWarning as CoarseConverterWarning,
    Converter as Converter,
    SampleScale as SampleScale,
)
from .decoder_tables import Precision as Precision

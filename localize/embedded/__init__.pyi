from .budget import Budget as Budget, Cost as Cost, cost_of as cost_of, in_units as in_units
from .embedding import EmbeddedDecoder as EmbeddedDecoder, embed as embed
from .tables import Precision as Precision

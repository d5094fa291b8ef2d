from .budget import Budget as Budget, Cost as Cost, cost_of as cost_of
from .embedding import embed as embed
from .tables import EmbeddedTables as EmbeddedTables, Precision as Precision, embedded_tables as embedded_tables

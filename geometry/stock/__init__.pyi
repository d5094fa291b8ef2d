from .fitting import StockChange as StockChange, StockFit as StockFit
from .land_patterns import LandPad as LandPad, LandPattern as LandPattern, find_land_pattern as find_land_pattern
from .stock_catalogue import Catalogue as Catalogue, catalogue as catalogue
from .stock_files import VARIABLE as VARIABLE, stock_places as stock_places
from .stock_parts import Found as Found, StockParts as StockParts
from .stock_rows import (
    KINDS as KINDS,
    SIGNALS as SIGNALS,
    Glue as Glue,
    Logger as Logger,
    PartKind as PartKind,
    Resin as Resin,
    Sheath as Sheath,
    Sheet as Sheet,
    Silicone as Silicone,
    Sleeve as Sleeve,
    Spring as Spring,
    StockMicrophone as StockMicrophone,
    StockPart as StockPart,
    Sundry as Sundry,
    Tubing as Tubing,
)
from .tube_stock import TubePart as TubePart, TubeStock as TubeStock

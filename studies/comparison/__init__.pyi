from .compared import Comparison as Comparison
from .compared_rows import (
    ComparedFigure as ComparedFigure,
    DifferingField as DifferingField,
    compared_figures as compared_figures,
    differing_fields as differing_fields,
)
from .comparing import compare as compare
from .level_curves import LevelCurves as LevelCurves, ResponseDifference as ResponseDifference
from .own_figures import OwnFigure as OwnFigure, library_figures as library_figures
from .quantities import FIGURES as FIGURES, Quantity as Quantity, figure_words as figure_words
from .subjects import Subject as Subject, SubjectLike as SubjectLike

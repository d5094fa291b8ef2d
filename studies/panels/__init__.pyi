from .comparing import comparison as comparison
from .curves import (
    CURVES as CURVES,
    Curves as Curves,
    curves_of as curves_of,
    quick_library as quick_library,
)
from .designing import DesignState as DesignState, Refused as Refused, design_key as design_key
from .exploring import (
    FoundDesigns as FoundDesigns,
    metric_words as metric_words,
    run_study as run_study,
    study_figures as study_figures,
    study_file as study_file,
    study_so_far as study_so_far,
    write_study as write_study,
)
from .export_files import EXPORTS as EXPORTS, make_export as make_export
from .form import (
    addable_tables as addable_tables,
    form_of as form_of,
    removable_tables as removable_tables,
    stated_values as stated_values,
)
from .live import hear_live as hear_live, sound_cards as sound_cards
from .making import check_figures as check_figures, model_of_array as model_of_array, read_upload as read_upload
from .points import figure_words as figure_words, mis_made_figures as mis_made_figures, point_figures as point_figures
from .recognizing import keep_recognizer as keep_recognizer, recognized as recognized, wrote as wrote
from .touching import (
    TOUCHES as TOUCHES,
    replayed as replayed,
    slid as slid,
    surface as surface,
    touched as touched,
)

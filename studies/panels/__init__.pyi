from .cad_panel import check_figures as check_figures, model_of_array as model_of_array, read_upload as read_upload
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
from .job_panel import job_words as job_words, plan_of as plan_of, proposals_for as proposals_for
from .live_panel import listen_live as listen_live, sound_cards as sound_cards
from .pinned_panel import (
    COMPARISON as COMPARISON,
    field_rows as field_rows,
    figure_rows as figure_rows,
    make_comparison as make_comparison,
)
from .points import as_built_figures as as_built_figures, point_figures as point_figures
from .recognizing import store_recognizer as store_recognizer, with_kinds as with_kinds, write_letter as write_letter
from .touching import (
    TOUCHES as TOUCHES,
    membranes as membranes,
    replay_recording as replay_recording,
    simulate_slide as simulate_slide,
    simulate_touch as simulate_touch,
)
from .verdict_panel import verdict_figures as verdict_figures

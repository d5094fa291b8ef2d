from .display import Display as Display, Report as Report, duration as duration, number as number
from .figure_style import (
    WIDTH as WIDTH,
    crop_picture as crop_picture,
    figure_in_style as figure_in_style,
    frequency_panels as frequency_panels,
    line_colours as line_colours,
    save_figure as save_figure,
)
from .folders import (
    check_folder as check_folder,
    check_new_file as check_new_file,
    check_new_library as check_new_library,
    claim_folder as claim_folder,
    make_folder as make_folder,
    replaced_files as replaced_files,
    replaced_folder as replaced_folder,
    write_json as write_json,
)
from .frequencies import FREQUENCIES as FREQUENCIES, LIBRARY_FREQUENCIES as LIBRARY_FREQUENCIES
from .response_figures import draw_confusion as draw_confusion, draw_training as draw_training

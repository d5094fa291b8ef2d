from .mold_cut import mold_section as mold_section, open_mold as open_mold
from .viewer import write_gltf as write_gltf, write_viewer as write_viewer
from .views import (
    draw_array as draw_array,
    draw_point as draw_point,
    exploded_view as exploded_view,
    top_view as top_view,
)

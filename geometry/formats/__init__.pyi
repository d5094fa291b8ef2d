from .facet_files import FACET_FORMATS as FACET_FORMATS, export_facets as export_facets
from .part_files import (
    FORMATS as FORMATS,
    ExportedFile as ExportedFile,
    SharedShape as SharedShape,
    tessellate_distinct as tessellate_distinct,
    tessellation_tolerance as tessellation_tolerance,
)
from .step_assembly import write_step as write_step
from .step_file import read_step as read_step
from .three_mf import Body as Body, write_3mf as write_3mf

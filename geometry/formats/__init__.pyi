from .names import FORMATS as FORMATS
from .part_files import (
    ExportedFile as ExportedFile,
    SharedShape as SharedShape,
    tessellate_distinct as tessellate_distinct,
    tessellation_tolerance as tessellation_tolerance,
)
from .step_assembly import write_step as write_step
from .three_mf import Body as Body, write_3mf as write_3mf

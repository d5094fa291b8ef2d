from .as_built_arrays import AsBuiltArrays as AsBuiltArrays, as_built as as_built
from .columns import COLUMNS as COLUMNS, FileFormat as FileFormat
from .export import ExportedDataset as ExportedDataset, export_dataset as export_dataset
from .shard_files import FORMATS as FORMATS

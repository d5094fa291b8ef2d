from .array_source import ArraySource as ArraySource, OneArray as OneArray, source_of as source_of
from .splits import DEFAULT_SHARES as DEFAULT_SHARES, SPLITS as SPLITS, Split as Split, split_of as split_of
from .touch_dataset import TouchBatch as TouchBatch, TouchDataset as TouchDataset
from .transfer_function_dataset import TransferFunctionDataset as TransferFunctionDataset

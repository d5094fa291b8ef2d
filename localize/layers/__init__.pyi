from .partial_block import PartialBlock as PartialBlock, PatchConvolution as PatchConvolution

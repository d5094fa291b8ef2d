"""Transfer functions by design, for surrogate models: a map-style data set of torch."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, TypedDict

import numpy as np
import torch
from torch import Tensor
from torch.utils.data import Dataset

from geometry.ground.argument_checks import check_choice
from geometry.ground.refusal import Kind, Refusal
from localize.datasets.array_source import ArraySource, source_of
from localize.datasets.splits import DEFAULT_SHARES, Split
from localize.datasets.touch_dataset import cases_of
from localize.signals.array_response import ArrayResponse

#: How a complex number is stored: as one, or as its real and imaginary part on an axis of their own.
ComplexForm = Literal["complex", "two channels"]
FORMS: tuple[ComplexForm, ...] = ("complex", "two channels")


class DesignSample(TypedDict):
    """One design as the data set hands it out."""

    parameters: Tensor
    """Parameters of the case, as ``parameter_names`` has them; (n_parameter,) float32."""
    transfer_function: Tensor
    """Pressure at a microphone over pressure in the touched cavity, Pa/Pa; (n_point, n_microphone, n_freq) complex64,
    or (2, n_point, n_microphone, n_freq) float32, real part first. Zero where an array has fewer points or microphones
    than the largest."""
    points: Tensor
    """Points that the array has; (n_point,) bool."""
    microphones: Tensor
    """Microphones that the array has; (n_microphone,) bool."""
    case: Tensor
    """Number of the case; () int64."""


class TransferFunctionDataset(Dataset[DesignSample]):
    """Designs of a sweep, or as-built sensors, with their transfer functions.

    Args:
        source: a sweep that keeps libraries, as-built sensors, or an :class:`ArraySource` of your own.
        split: "train", "validation" or "test"; None takes all cases.
        shares: fraction of the cases in each split.
        split_seed: of the splits, as of :class:`localize.TouchDataset`.
        form: "complex", or "two channels" for real and imaginary part.

    Raises:
        Refusal: an argument out of range, a split without a case, cases on different frequencies.
    """

    def __init__(
        self,
        source: ArraySource,
        *,
        split: Split | None = None,
        shares: Mapping[Split, float] = DEFAULT_SHARES,
        split_seed: int = 0,
        form: ComplexForm = "complex",
    ) -> None:
        check_choice("form", form, FORMS)
        self.source = source_of(source)
        self.form = form
        self.parameter_names, self.parameter_units = self.source.parameter_names, self.source.parameter_units
        #: Numbers of the cases of this split; (n_case,) int64.
        self.cases = cases_of(self.source, split, split_seed, shares)
        #: (n_freq,) float64, Hz.
        self.frequency = self.source.arrays([int(self.cases[0])])[0].frequency
        self._size = np.asarray(self.source.array_sizes, np.int64).max(0).tolist()

    def __repr__(self) -> str:
        """Designs, parameters and shape of a transfer function."""
        shape = (*self._size, len(self.frequency))
        return f"TransferFunctionDataset({len(self)} designs, {len(self.parameter_names)} parameters, {shape})"

    def __len__(self) -> int:
        """Number of designs."""
        return len(self.cases)

    def __getitem__(self, place: int) -> DesignSample:
        """Design at a place of the split, from 0.

        Raises:
            IndexError: no such place.
            Refusal: a case on other frequencies than the first.
        """
        return self.__getitems__([place])[0]

    def __getitems__(self, places: list[int]) -> list[DesignSample]:
        """Designs at some places, as a ``DataLoader`` asks for them: less work than one after the other."""
        cases = [int(self.cases[place]) for place in places]
        return [self._sample(case, array) for case, array in zip(cases, self.source.arrays(cases), strict=True)]

    def _sample(self, case: int, array: ArrayResponse) -> DesignSample:
        if not np.array_equal(array.frequency, self.frequency):
            raise Refusal(
                f"case {case} has other frequencies than case {self.cases[0]}", kind=Kind.MISMATCH, field="source"
            )
        points, microphones = array.transfer_function.shape[:2]
        values = torch.zeros(*self._size, len(self.frequency), dtype=torch.complex64)
        values[:points, :microphones] = torch.from_numpy(array.transfer_function.astype(np.complex64))
        return {
            "parameters": torch.from_numpy(np.asarray(self.source.parameter_values(case), np.float32)),
            "transfer_function": values if self.form == "complex" else torch.stack([values.real, values.imag]),
            "points": torch.arange(self._size[0]) < points,
            "microphones": torch.arange(self._size[1]) < microphones,
            "case": torch.tensor(case),
        }

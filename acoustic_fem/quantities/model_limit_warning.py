"""Category of the warnings on limits of the models, so that whoever lists those limits can leave the warnings out."""

from __future__ import annotations


class ModelLimitWarning(UserWarning):
    """Warning of a design, an air or frequencies for which a model neglects something that counts."""

"""Designs, runs, libraries and cases of sweeps side by side: fields that differ, figures, curves, and their page.

Stands on: findings, metrics, optimization, output, run, study, sweep, verdict.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

"""The command line: arguments in, tables out, no workflow of its own.

Stands on: bending, findings, judging, made_sensor, optimization, output, run, scatter, study, sweep.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

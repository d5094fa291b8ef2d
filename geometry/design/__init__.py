"""The checked design: rules between fields, changed copies, TOML in and out.

Stands on: ground, plan, schema.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

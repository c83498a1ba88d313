"""The paper's experiments as data, and its claims with verdicts. The names below are loaded when first used."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

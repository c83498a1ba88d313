"""The Fetch: its model, the page, the path of the pen and the joints that follow it."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

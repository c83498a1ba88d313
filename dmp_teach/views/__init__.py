"""What is looked at: the 3-D scene, as a live view, a file and a picture."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

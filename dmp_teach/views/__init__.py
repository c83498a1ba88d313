"""Views: the 3-D scene, live, as a file and as a picture; figures in `views.figures`."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

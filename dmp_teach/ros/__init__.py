"""The motion for a real Fetch, as a ROS 1 bag."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

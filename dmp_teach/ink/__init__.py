"""Recordings of handwriting: our alphabets, strokes from a pad, and their plain JSON.

Read in this order:

    recording         the value: the pen's path, its clock, its strokes
    recording_json    recordings as files
    alphabet          our own letters
    pen_lifts         heights for flat ink
    pad               events of a mouse, a finger or a stylus become a recording
    svg_repr          a small picture for a notebook
    marks             how a server knows such a picture
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

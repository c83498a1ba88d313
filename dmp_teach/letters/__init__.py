"""A letter, learned and written again; new letters, styles and words made of what was learned.

Read in this order:

    letter      what flows: strokes, a primitive for each; learned (`learning`), written, kept in a file (`saved`)
    shelf       letters taken apart: every stroke under its name, a `piece` that can be led, moved, turned and cut
    recipes     the table of new letters, a line each (`roles`: which stroke is the bar; `outline`: how that is seen)
    styles      one letter by several writers: blends, principal styles, chance (`alike`: so that weights add up)
    words       text on one clock: a `hand` gives its letters, `spacing` sets them, `linking` joins them where they meet
                (`meeting`), `write_lines` fills a sheet
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

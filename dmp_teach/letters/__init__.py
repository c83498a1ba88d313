"""Letters: learned and written again; new letters, styles and text made of what was learned.

Read in this order:

    letter          strokes and a primitive for each: learned, written, saved (`letter_json`)
    compose/shelf   letters taken apart into strokes (`piece`) that can be moved, scaled and cut
    compose/recipes the table of new letters, a line each (`roles` finds bars and bowls by shape)
    styles          one letter by several writers: blends, principal styles, samples
    text/words      words on one clock; `handwriting` gives the letters, `spacing` places them,
                    `connections` joins them; text/lines fills a sheet
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

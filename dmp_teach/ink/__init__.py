"""Recordings in every format, the strokes in them, and how near one letter is to another.

Read in this order:

    recording       what flows: the pen's way, its clock, its strokes
    strokes         ... found from the height (`motion`: on an even clock; `writing`: what of it left a line);
                    `printed_rules`: the paper's way; `cuts`: moved by hand
    reader          a file becomes recordings; what is in it tells which of these reads it:
      capture         motion capture (`motive` reads the file, `motive_table` its columns, `motive_markers` the pen,
                      `plane` the paper)
      inkml           digital ink (`inkml_channels`, `inkml_mappings`, `inkml_points`, `inkml_times`, `inkml_views`)
      reference_sets  Character Trajectories and LASA (`matfile` reads MATLAB's files)
      svg             drawings (`svg_frames`, `svg_style`, `svg_shapes`; `pace`: when a hand would be where)
      our_json        what we write ourselves (`plain_json`: strictly, never run)
      for all         `opening` (bounded files), `markup` (XML from strangers), `flat` and `lifts` (ink without height)
    writer          a recording becomes a file; `drawing`: a small picture for a notebook
    pad             events of a mouse, a finger or a stylus become a recording
    alphabet        our own letters
    score           how well a letter is written, in a sentence, by
      matching        which stroke is which, whatever their order (`laying`: stroke upon stroke; `points`: evenly along)
      fitting         size, place and lean (`mapping`: by least squares; `trimming`: without a piece that is missing)
      faults          what to say first; `distances`: shape; `movement`: smoothness
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

"""Motion capture as OptiTrack's Motive exports it."""

from dmp_teach.formats.motive.reader import FORMAT as FORMAT

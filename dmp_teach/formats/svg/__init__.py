"""Drawings: SVG."""

from dmp_teach.formats.svg.reader import FORMAT as FORMAT

"""The field's reference sets in MATLAB's files."""

from dmp_teach.formats.mat.reader import FORMAT as FORMAT

"""Digital ink as the W3C's InkML has it."""

from dmp_teach.formats.inkml.reader import FORMAT as FORMAT

from .even_clock import lowpass_hertz as lowpass_hertz
from .even_clock import runs as runs
from .paper_rules import RULES as RULES
from .paper_rules import rule_named as rule_named
from .strokes import find_strokes as find_strokes

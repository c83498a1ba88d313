from .even_clock import Spans as Spans
from .even_clock import find_runs as find_runs
from .even_clock import lowpass_hertz as lowpass_hertz
from .manual_cuts import cut_at_times as cut_at_times
from .paper_rules import RULES as RULES
from .paper_rules import get_rule as get_rule
from .strokes import find_strokes as find_strokes

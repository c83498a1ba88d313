from .all import check as check
from .all import class_overview as class_overview
from .all import lesson as lesson
from .all import lessons as lessons

from .panels.explore import explore as explore
from .panels.pad import pad as pad
from .panels.resting import RESTING_SCRIPT as RESTING_SCRIPT

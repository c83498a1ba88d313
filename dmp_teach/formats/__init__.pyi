from .read import is_ink as is_ink
from .read import read_recording as read_recording
from .read import read_recordings as read_recordings
from .registry import known_formats as known_formats
from .script import use_script as use_script
from .write import write_recording as write_recording

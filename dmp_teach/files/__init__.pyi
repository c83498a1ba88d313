from .javascript import bundle as bundle
from .reading import contents as contents
from .strict_json import is_number as is_number
from .strict_json import is_pseudonym as is_pseudonym
from .strict_json import loaded as loaded
from .strict_json import must as must
from .writing import ASSETS as ASSETS
from .writing import write_whole as write_whole

from .language import gettext as gettext
from .language import javascript_texts as javascript_texts
from .language import marked as marked
from .language import ngettext as ngettext
from .language import set_language as set_language

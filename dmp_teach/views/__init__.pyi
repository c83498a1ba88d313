from .page_file import render_page as render_page
from .scene.view import STYLE_TOKENS as STYLE_TOKENS
from .scene.view import SceneView as SceneView
from .scene.view import view as view
from .stamp_code import read_stamp as read_stamp
from .stamp_code import stamp_text as stamp_text
from .stamp_code import write_stamp as write_stamp
from .unsaved import UnsavedWidget as UnsavedWidget

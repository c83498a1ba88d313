from .page_file import render_page as render_page
from .scene.view import STYLE_TOKENS as STYLE_TOKENS
from .scene.view import SceneView as SceneView
from .scene.view import view as view

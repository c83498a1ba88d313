from .scene.page_file import read_beside as read_beside
from .scene.view import SceneView as SceneView
from .scene.view import view as view

"""The shapes of a drawing, each with its look and its place on the page."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from xml.etree.ElementTree import Element

import numpy as np
from svgelements import Path

from dmp_teach.errors import RecordingError
from dmp_teach.formats.safe_xml import local_tag
from dmp_teach.formats.svg.frames import (
    coordinate,
    fitted,
    page_view,
    transform_matrix,
    translation,
    view_box,
)
from dmp_teach.formats.svg.look import Look, apply_styles, check_followed, colour
from dmp_teach.formats.svg.seen import BESIDE, CUT, Clip, Outline
from dmp_teach.formats.svg.shapes import SHAPES, path_of_shape, path_strokes
from dmp_teach.trajectory import Array

VIEWS = {"svg", "symbol"}
NO_LINES = {"image", "text"}
KNOWN = {"g", "a", "switch", "use", *VIEWS, *SHAPES, *NO_LINES}
HREFS = ("href", "{http://www.w3.org/1999/xlink}href")
MOST_CLONES = 1000
DEEPEST_CLONE = 10  # clones of clones
CLIP_POINTS = 32  # on a curve of a clip
UPWARD = np.diag([1.0, -1.0, 1.0])
LINK = re.compile(r"url\(\s*[\"']?#([^\"')]+)[\"']?\s*\)")
PLAIN_COLOUR = re.compile(r"#[\da-fA-F]+|rgba?\([^()]+\)|black")
UNLINK = "unlink clones, or convert them to paths."


@dataclass(frozen=True)
class Place:
    """Where an element is.

    Args:
        matrix: From its units to the page [m], y up, shape (3, 3).
        view: How wide and high the view is that it is in, in its units, shape (2,).
        clips: What cuts it.
    """

    matrix: Array
    view: Array
    clips: tuple[Clip, ...] = ()

    def moved(self, matrix: Array) -> Place:
        """Return a place within, whose units `matrix` (3, 3) brings to these."""
        return replace(self, matrix=self.matrix @ matrix)

    def cut(self, why: int, left: float, top: float, size: Array) -> Place:
        """Return the place where only what is in a box of a `size` (2,) is seen."""
        corners = np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) * size + [left, top]
        outline = Outline([corners @ self.matrix[:2, :2].T + self.matrix[:2, 2]])
        return replace(self, clips=(*self.clips, (why, [outline])))


@dataclass(frozen=True)
class Shape:
    """A shape of a drawing."""

    path: Path
    look: Look
    place: Place


class ShapeFinder:
    """A drawing while its shapes are found.

    Attributes:
        others: The kinds of what is seen beside shapes, such as "image".
        paper: The colour of its page, shape (4,).
    """

    def __init__(self, root: Element) -> None:
        apply_styles(root)
        self._root = root
        self._named = {each.get("id"): each for each in root.iter()}
        self._clones = 0
        self._clips: dict[tuple[int, bytes], Clip] = {}
        self.others: set[str] = set()
        text = root.get("background-color", root.get("background", ""))
        paper = colour(text) if PLAIN_COLOUR.fullmatch(text) else np.ones(4)
        self.paper = paper if paper[3] == 1 else np.ones(4)

    def shapes(self) -> Iterator[Shape]:
        """Yield every shape that is shown, the lowest first."""
        matrix, view, page = page_view(self._root)
        place = Place(UPWARD, view)
        if page is not None:
            place = place.cut(BESIDE, 0.0, 0.0, page)
        yield from self._shapes(self._root, Look({}, 1.0), place.moved(matrix))

    def _shapes(
        self,
        element: Element,
        above: Look,
        place: Place,
        depth: int = 0,
        use: Element | None = None,
    ) -> Iterator[Shape]:
        """Yield every shape in an element, which is in so many clones, the nearest of them `use`.

        How what holds it looks is `above`, and where that is, `place`.
        """
        kind, look = local_tag(element), above.within(element)
        if kind not in KNOWN or look.opacity <= 0:
            return
        if kind in NO_LINES:
            self.others.add(kind)
            return
        check_followed(element)
        place = place.moved(transform_matrix(element.get("transform")))
        place = self._clipped(element, place, depth + 1)
        if kind == "use":
            yield from self._clone(element, look, place, depth + 1)
        elif kind in SHAPES:
            path = path_of_shape(element, place.view)
            if path is not None:
                yield Shape(path, look, place)
        elif kind != "symbol" or use is not None:
            if kind in VIEWS and element is not self._root:
                place = _inner_view(element, element if use is None else use, place)
            shown = [child for child in element if local_tag(child) in KNOWN]
            for child in shown[:1] if kind == "switch" else shown:
                yield from self._shapes(child, look, place, depth)

    def _clone(self, use: Element, look: Look, place: Place, depth: int) -> Iterator[Shape]:
        """Yield the shapes of a clone."""
        name = next((text for href in HREFS if (text := use.get(href))), "")
        target = self._named.get(name.removeprefix("#")) if name.startswith("#") else None
        if target is None:
            raise RecordingError(f"has a clone (use) of {name[:40]!r}, not of a shape; {UNLINK}")
        self._count_clone(depth)
        x, y = (coordinate(use, axis, place.view) or 0.0 for axis in "xy")
        yield from self._shapes(target, look, place.moved(translation(x, y)), depth, use)

    def _count_clone(self, depth: int) -> None:
        """Raise a RecordingError where there are too many clones."""
        self._clones += 1
        if self._clones > MOST_CLONES or depth > DEEPEST_CLONE:
            raise RecordingError(
                f"has more than {MOST_CLONES} clones (use), or clones of clones of themselves; "
                f"{UNLINK}"
            )

    def _clipped(self, element: Element, place: Place, depth: int) -> Place:
        """Return a place with the clip of the element there."""
        text = element.get("clip-path", "none")
        if text == "none":
            return place
        link = LINK.fullmatch(text)
        clip = self._named.get(link[1]) if link else None
        is_plain = clip is not None and clip.get("clipPathUnits") != "objectBoundingBox"
        if clip is None or not is_plain or local_tag(clip) != "clipPath":
            raise RecordingError(
                "has the style clip-path, which is not followed here; apply it in your drawing "
                "program."
            )
        if depth > 1:
            self._count_clone(depth)
        within = self._clipped(clip, replace(place, clips=()), depth + 1)
        within = within.moved(transform_matrix(clip.get("transform")))
        key = (id(clip), within.matrix.tobytes())
        if key not in self._clips:
            look = Look({}, 1.0).within(clip)
            shapes = [each for child in clip for each in self._shapes(child, look, within, depth)]
            outlines = [
                Outline(
                    path_strokes(shape.path, shape.place.matrix, CLIP_POINTS),
                    shape.look.said.get("clip-rule") == "evenodd",
                )
                for shape in shapes
            ]
            self._clips[key] = (CUT, outlines)
        return replace(place, clips=(*place.clips, *within.clips, self._clips[key]))


def _inner_view(element: Element, sized: Element, place: Place) -> Place:
    """Return the place in a drawing within the drawing, or in a symbol; `sized` says its size."""

    def said(name: str, usual: float) -> float:
        values = [coordinate(each, name, place.view) for each in (sized, element)]
        return next((value for value in values if value is not None), usual)

    x, y = (coordinate(element, axis, place.view) or 0.0 for axis in "xy")
    size = np.array([said("width", place.view[0]), said("height", place.view[1])])
    box = view_box(element)
    if element.get("overflow", "hidden") not in ("visible", "auto"):
        place = place.cut(CUT, x, y, size)
    place = replace(place.moved(translation(x, y)), view=size)
    if box is None:
        return place
    return replace(place.moved(fitted(element, box, size)), view=box[2:])

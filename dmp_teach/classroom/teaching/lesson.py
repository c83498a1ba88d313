"""A lesson in which a robot is taught, and a panel to show it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dmp_teach.classroom.lesson.lesson import Lesson
from dmp_teach.classroom.teaching.content import TeachingContent

if TYPE_CHECKING:
    from dmp_teach.classroom.teaching.panel import TeachingPanel


class TeachingLesson(TeachingContent, Lesson):
    """A lesson whose sheet, in the second step, is a writing pad."""

    def panel(self) -> TeachingPanel:
        """Return the lesson as a pupil sees it, where it was left."""
        # As in `Lesson`.
        from dmp_teach.classroom.teaching.panel import TeachingPanel  # noqa: PLC0415

        return TeachingPanel(self)

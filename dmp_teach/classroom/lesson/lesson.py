"""A lesson: its content, and a panel to show it."""

from __future__ import annotations

from dmp_teach.classroom.lesson.content import LessonContent
from dmp_teach.classroom.lesson.panel import LessonPanel


class Lesson(LessonContent):
    """One question of 15 to 25 minutes: bet, try, challenge."""

    def panel(self) -> LessonPanel:
        """Return the lesson as a pupil sees it, where it was left."""
        return LessonPanel(self)

"""A lesson: its content, and a panel to show it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dmp_teach.classroom.lesson.content import LessonContent

if TYPE_CHECKING:
    from dmp_teach.classroom.lesson.panel import LessonPanel


class Lesson(LessonContent):
    """One question of 15 to 25 minutes: bet, try, challenge."""

    def panel(self) -> LessonPanel:
        """Return the lesson as a pupil sees it, where it was left."""
        # A check needs no widgets, which take a second to import.
        from dmp_teach.classroom.lesson.panel import LessonPanel  # noqa: PLC0415

        return LessonPanel(self)

"""What a lesson in which a robot is taught has beside other lessons: a session."""

from __future__ import annotations

from dmp_teach.classroom.lesson.check import Answer
from dmp_teach.classroom.lesson.content import LessonContent
from dmp_teach.classroom.teaching.session import TeachingSession
from dmp_teach.classroom.teaching.traits import PupilTraits
from dmp_teach.trajectory import Trajectory


class TeachingContent(LessonContent):
    """A lesson with a session, which its panel goes on with; a check needs none."""

    letter: str
    session: TeachingSession | None = None
    ink: tuple[Trajectory, ...] = ()
    # A page of its own has no kernel to write to.
    takes_ink = True
    # A pupil that gets wrong what was weakest in what was shown last by hand.
    echo = PupilTraits("Echo", {"lean": 25.0})

    def traits_of(self, values: Answer) -> PupilTraits:
        """Return what the pupil is like that is set."""
        raise NotImplementedError

    def session_with(self, values: Answer) -> TeachingSession:
        """Return the session with the pupil that is set; another pupil begins another one."""
        traits = self.traits_of(values)
        if self.session is None or self.session.traits != traits:
            self.session, self.ink = TeachingSession.begin(traits, self.letter), ()
        return self.session

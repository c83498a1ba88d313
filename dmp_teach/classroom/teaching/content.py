"""What a lesson in which a robot is taught has beside other lessons: a session."""

from __future__ import annotations

from dmp_teach.classroom.lesson.check import Answer
from dmp_teach.classroom.lesson.content import LessonContent
from dmp_teach.classroom.teaching.session import TeachingSession
from dmp_teach.classroom.teaching.traits import PupilTraits
from dmp_teach.trajectory import Trajectory

# What can be set of a pupil [%].
HABITS = {"pace": (5, 95), "forgetting": (0, 90)}


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

    @property
    def has_guest(self) -> bool:
        """Whether a pupil of a teacher's own has taken the place of the echo."""
        return self.echo.name != TeachingContent.echo.name

    def pupil_named(self, name: str) -> PupilTraits:
        """Return the pupil of this name as it comes."""
        return self.echo if name == self.echo.name else PupilTraits.load(name)

    def habits_of(self, name: str) -> Answer:
        """Return the pace and the forgetting of the pupil of this name [%], as can be set."""
        traits = self.pupil_named(name)
        return {
            habit: min(max(round(100 * getattr(traits, habit)), low), high)
            for habit, (low, high) in HABITS.items()
        }

    def session_with(self, values: Answer) -> TeachingSession:
        """Return the session with the pupil that is set; another pupil begins another one."""
        traits = self.traits_of(values)
        if self.session is None or self.session.traits != traits:
            self.session, self.ink = TeachingSession.begin(traits, self.letter), ()
        return self.session

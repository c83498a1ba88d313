"""A robot that is taught: a pupil as data, its memory, its letter, and the log of a session."""

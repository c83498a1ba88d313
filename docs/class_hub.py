"""A JupyterHub for a class; a_class_on_a_hub.md says where this file goes, and what else to do."""

import os

from jupyterhub.orm import Spawner
from tornado.web import HTTPError

c = get_config()  # noqa: F821 (JupyterHub gives it)

# Each pupil's copies of the lessons, in a home folder that nobody else can open.
c.Spawner.environment.update({"DMP_TEACH_LESSONS": "~/lessons"})
c.Spawner.default_url = "/doc/tree/00_start_here.ipynb"

# With accounts of the computer, those of this group may sign in.
c.PAMAuthenticator.allowed_groups = {"pupils"}

# The network reaches the proxy alone; the hub and the pupils' servers listen to this computer.
c.JupyterHub.hub_ip = "127.0.0.1"
c.Spawner.ip = "127.0.0.1"

# JupyterHub's own server, which starts in half of its time.
c.Spawner.cmd = ["python3", "-P", "-m", "dmp_teach.launcher.quick_start", "jupyterhub.singleuser"]

# A class comes all at once, and its servers share the processor.
c.Spawner.start_timeout = 300
c.Spawner.http_timeout = 300

# So many pupils have room: each with 400 MB, and one gigabyte for the computer itself.
PLACES = int((os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") - 1e9) / 400e6)


class FullError(HTTPError):
    """What a pupil reads for whom there is no memory, so that nobody else has to wait for it."""

    jupyterhub_message = (
        "All places of this class are taken: the computer has no memory for one more pupil. What "
        "you have saved is safe. Tell your teacher, and try again when somebody has left."
    )
    # JupyterHub would set a word of its own as the heading.
    reason = property(lambda self: "The class is full", lambda self, word: None)


def look_for_a_place(spawner):
    """Refuse one pupil too many; a server that begins is counted with the others."""
    if spawner.db.query(Spawner).filter(Spawner.server_id.is_not(None)).count() > PLACES:
        raise FullError(503)


c.Spawner.pre_spawn_hook = look_for_a_place

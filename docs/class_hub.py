"""A JupyterHub for a class; a_class_on_a_hub.md says where this file goes, and what else to do."""

c = get_config()  # noqa: F821 (JupyterHub gives it)

# Each pupil's copies of the lessons, in a home folder that nobody else can open.
c.Spawner.environment.update({"DMP_TEACH_LESSONS": "~/lessons"})
c.Spawner.default_url = "/doc/tree/00_start_here.ipynb"

# With accounts of the computer, those of this group may sign in.
c.PAMAuthenticator.allowed_groups = {"pupils"}

# The network reaches the proxy alone; the hub and the pupils' servers listen to this computer.
c.JupyterHub.hub_ip = "127.0.0.1"
c.Spawner.ip = "127.0.0.1"

# A class comes all at once, and each server wants a processor core for some 9 seconds.
c.Spawner.start_timeout = 300
c.Spawner.http_timeout = 300

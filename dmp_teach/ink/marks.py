"""How a notebook's server knows our pictures of ink, without what draws them."""

INK_CLASS = "dmp-teach-ink"
"""The class of every picture: by it a server with our extension leaves them out when it saves."""
PICTURES_STAY_OUT = "DMP_TEACH_PICTURES_STAY_OUT"
"""The environment variable that says that a server does so; nothing is drawn for any other."""

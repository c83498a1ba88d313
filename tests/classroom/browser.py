"""What a browser sends to a panel."""

import logging


class Raise(logging.Handler):
    """Raises what widgets only log: an error of ours that the browser would never hear of."""

    def emit(self, record):
        raise record.exc_info[1]


def send(panel, content, *buffers):
    """Send a panel a message as Jupyter brings it from the browser."""
    message = {"data": {"method": "custom", "content": content}}
    handler = Raise(logging.WARNING)
    panel.log.addHandler(handler)
    try:
        panel.comm.handle_msg({"content": message, "buffers": list(buffers)})
    finally:
        panel.log.removeHandler(handler)

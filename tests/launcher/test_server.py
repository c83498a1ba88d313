"""What a panel sends leaves at once."""

import asyncio
import socket

from jupyter_server.services.kernels.connection.channels import ZMQChannelsWebsocketConnection
from tornado.httpserver import HTTPServer
from tornado.testing import bind_unused_port
from tornado.web import Application
from tornado.websocket import WebSocketHandler, websocket_connect

from dmp_teach.launcher.server import PromptConnection


def test_the_kernels_websocket_never_waits_to_fill_a_packet(monkeypatch):
    monkeypatch.setattr(ZMQChannelsWebsocketConnection, "connect", lambda self: "connected")
    seen = []

    class Probe(PromptConnection):
        websocket_handler = None

    class Handler(WebSocketHandler):
        def open(self):
            probe = Probe()
            probe.websocket_handler = self
            nodelay = (socket.IPPROTO_TCP, socket.TCP_NODELAY)
            before = self.ws_connection.stream.socket.getsockopt(*nodelay)
            seen.extend(
                [before, probe.connect(), self.ws_connection.stream.socket.getsockopt(*nodelay)]
            )
            self.write_message("done")

    async def talk():
        door, port = bind_unused_port()
        server = HTTPServer(Application([("/", Handler)]))
        server.add_socket(door)
        client = await websocket_connect(f"ws://127.0.0.1:{port}/")
        await client.read_message()
        client.close()
        server.stop()

    asyncio.run(talk())
    assert [bool(seen[0]), seen[1], bool(seen[2])] == [False, "connected", True]

"""A simulated pupil: signs in at a hub, opens a panel and drags, without a browser."""

import asyncio
import itertools
import re
import time
import uuid
from typing import Any
from urllib.parse import urljoin

import aiohttp
from jupyter_server.services.kernels.connection.base import deserialize_binary_message

PANEL = "import dmp_teach as teach\npanel = teach.explore()\npanel"
# A hand's events come at most so often [s].
FRAME = 1 / 60
PATIENCE = 200  # [s]
ASSET = re.compile(r'(?:src|href)="(/[^"]+\.(?:js|css)[^"]*)"')


class Pupil:
    """One pupil with a browser's cookies; `async with` ends the connection, not the server."""

    def __init__(self, url: str, name: str):
        self.url, self.name = url, name
        self.home = f"{url}/user/{name}/"
        self.panel = ""
        self.signed_in = self.panel_shown = 0.0

    async def __aenter__(self) -> "Pupil":
        jar = aiohttp.CookieJar(unsafe=True)
        self.http = aiohttp.ClientSession(
            cookie_jar=jar, timeout=aiohttp.ClientTimeout(total=PATIENCE)
        )
        return self

    async def __aexit__(self, *_: object) -> None:
        await self.http.close()

    async def begin(self) -> None:
        """Sign in, open the first lesson and wait for its panel."""
        began = time.monotonic()
        await self.sign_in()
        self.signed_in = time.monotonic() - began
        await self.open_kernel()
        await self.run(PANEL)
        self.panel_shown = time.monotonic() - began

    async def sign_in(self) -> str:
        """Sign in as the form does, and return the page that is seen in the end."""
        async with self.http.get(f"{self.url}/hub/login") as page:
            form = await page.text()
        (xsrf,) = re.findall(r'name="_xsrf"\s+value="([^"]+)"', form)
        data = {"username": self.name, "password": "any", "_xsrf": xsrf}
        async with self.http.post(f"{self.url}/hub/login?next=", data=data) as page:
            text, at = await page.text(), str(page.url)
        while "/spawn-pending/" in at:
            await asyncio.sleep(0.5)
            async with self.http.get(at) as page:
                text, at = await page.text(), str(page.url)
        if at.startswith(self.home):
            for path in ASSET.findall(text):
                async with self.http.get(urljoin(self.url, path)) as asset:
                    await asset.read()
        return text

    async def open_kernel(self) -> None:
        """Start a kernel and connect to it as JupyterLab does."""
        cookies = self.http.cookie_jar.filter_cookies(self.home)  # type: ignore[arg-type]
        headers = {"X-XSRFToken": cookies["_xsrf"].value}
        api = f"{self.home}api/kernels"
        async with self.http.post(api, json={"name": "python3"}, headers=headers) as answer:
            answer.raise_for_status()
            self.kernel = (await answer.json())["id"]
        self.socket = await self.http.ws_connect(f"{api}/{self.kernel}/channels", max_msg_size=0)

    # Any, here and below: JSON.
    async def send(self, kind: str, content: dict[str, Any]) -> str:
        """Send a message to the kernel, and return its name."""
        name = uuid.uuid4().hex
        header = {"msg_id": name, "msg_type": kind, "session": self.name, "version": "5.3"}
        await self.socket.send_json(
            {
                "header": header | {"username": self.name, "date": "2000-01-01T00:00:00Z"},
                "parent_header": {},
                "metadata": {},
                "content": content,
                "channel": "shell",
            }
        )
        return name

    async def hear(self) -> dict[str, Any]:
        """Return the next message."""
        heard = await self.socket.receive(timeout=PATIENCE)
        if heard.type == aiohttp.WSMsgType.BINARY:
            return deserialize_binary_message(heard.data)
        return heard.json()

    async def run(self, code: str) -> None:
        """Run a cell to its end, and note the panel that it opens."""
        content = {"code": code, "silent": False, "store_history": False, "allow_stdin": False}
        sent = await self.send("execute_request", content)
        while True:
            heard = await self.hear()
            kind, content = heard["header"]["msg_type"], heard["content"]
            if kind == "error":
                raise RuntimeError(f"{content['ename']}: {content['evalue']}")
            if kind == "comm_open" and "n_kernels" in content["data"].get("state", {}):
                self.panel = content["comm_id"]
            if _is_the_end(heard, sent):
                return

    async def drag(self, seconds: float) -> list[float]:
        """Move the slider of bumps as a hand does; how long each new letter took [s].

        As the browser's side of a panel: a step is sent when the one before it is done.
        """
        took, until = [], time.monotonic() + seconds
        for step in itertools.count(1):
            began = time.monotonic()
            if began > until:
                break
            state = {"n_kernels": 8 + step % 30, "asked": step}
            data = {"method": "update", "state": state, "buffer_paths": []}
            sent = await self.send("comm_msg", {"comm_id": self.panel, "data": data})
            while True:
                heard = await self.hear()
                said = heard["content"].get("data", {}).get("content", {})
                if '"drawing"' in said.get("json", ""):
                    took.append(time.monotonic() - began)
                if _is_the_end(heard, sent):
                    break
            await asyncio.sleep(max(0.0, began + FRAME - time.monotonic()))
        return took


def _is_the_end(heard: dict[str, Any], sent: str) -> bool:
    """Whether the kernel says that it has done all that a message asked for."""
    return (
        heard["header"]["msg_type"] == "status"
        and heard["content"]["execution_state"] == "idle"
        and heard["parent_header"].get("msg_id") == sent
    )

"""What a class asks of a hub's computer: `python -m tests.benchmarks.load [--pupils 24]`.

Simulated pupils sign in at a real JupyterHub with the teachers' settings, each with a server and a
kernel of its own, open a panel and drag. At most 24 pupils and four minutes; where memory becomes
short, it ends. No test: what else a computer does decides too, so nothing here fails.
"""

import argparse
import asyncio
import json
import os
import re
import tempfile
from contextlib import AsyncExitStack
from pathlib import Path
from typing import Any

import numpy as np
import psutil

from tests.benchmarks.load_hub import Hub, check_room, memory_of, processor_time, serve_class
from tests.benchmarks.load_page import drag_in_page
from tests.benchmarks.load_pupil import PANEL, Pupil

MOST = 24
AT_MOST = 220  # [s]
DRAGGING = 5  # [s]
WAIT = """import asyncio
panel.write()
while panel.work["state"] == "working":
    await asyncio.sleep(0.1)
panel.motion.t"""
STARTS = ("signed_in", "panel_shown")
# What a kernel is asked for, one after the other.
STEPS = {
    "bare": "1",
    "with a panel": PANEL,
    "and the robot": WAIT,
    "and physics": "run = teach.simulate(panel.motion)",
}


async def alone(hub: Hub) -> dict[str, Any]:
    """How soon a panel is there for one pupil, and how soon it follows a hand [s]."""
    async with Pupil(hub.url, "w00") as pupil:
        await pupil.begin()
        return {**_starts([pupil]), "took": await pupil.drag(DRAGGING)}


async def class_of(hub: Hub, count: int) -> dict[str, Any]:
    """A class that starts at once and then drags, some of it, and all of it at once."""
    async with AsyncExitStack() as stack:
        names = [f"w{n:02}" for n in range(1, count + 1)]
        pupils = [await stack.enter_async_context(Pupil(hub.url, name)) for name in names]
        before = processor_time(hub.process), processor_time(hub.proxy())
        await _watched(*(pupil.begin() for pupil in pupils))
        servers = [hub.server(name) for name in names]
        kernels = [server.children()[0] for server in servers]
        processor = {
            "server": np.mean([processor_time(each) for each in servers]),
            "kernel": np.mean([processor_time(each) for each in kernels]),
            "hub": (processor_time(hub.process) - before[0]) / count,
            "proxy": (processor_time(hub.proxy()) - before[1]) / count,
        }
        took = {}
        for some in sorted({min(8, count), count}):
            each = await _watched(*(pupil.drag(DRAGGING) for pupil in pupils[:some]))
            took[some] = [seconds for own in each for seconds in own]
        async with Pupil(hub.url, "w99") as late:
            page = await late.sign_in()
        memory = {"server": float(np.mean([memory_of(each) for each in servers]))}
        memory |= await _memory_by_steps(hub, pupils[:2])
    return {
        **_starts(pupils),
        "processor": {name: float(seconds) for name, seconds in processor.items()},
        "memory": memory,
        "took": took,
        "too_many": " ".join(re.findall(r"<(?:h1|p)>\s*(.*?)\s*</(?:h1|p)>", page, re.S)[:2]),
    }


def _starts(pupils: list[Pupil]) -> dict[str, list[float]]:
    return {name: [getattr(pupil, name) for pupil in pupils] for name in STARTS}


async def _memory_by_steps(hub: Hub, pupils: list[Pupil]) -> dict[str, float]:
    """What a kernel takes after each step; two take it, so that what they share counts for none."""
    for pupil in pupils:
        await pupil.open_kernel()
    kernel = max(hub.server(pupils[0].name).children(), key=psutil.Process.create_time)
    memory = {}
    for name, code in STEPS.items():
        await _watched(*(pupil.run(code) for pupil in pupils))
        memory[name] = memory_of(kernel)
    return memory


async def _watched(*work: Any) -> list[Any]:
    """Do all at once, and end where memory becomes short or time is over."""
    tasks = asyncio.gather(*work)
    while not tasks.done():
        try:
            check_room()
        except Exception:
            tasks.cancel()
            raise
        await asyncio.wait([tasks], timeout=1)
    return await tasks


def measure(count: int) -> dict[str, Any]:
    """Measure one pupil, a page and a class, each on a hub of its own."""
    with tempfile.TemporaryDirectory() as folder, serve_class(Path(folder)) as hub:
        one = asyncio.run(asyncio.wait_for(alone(hub), AT_MOST))
        page = drag_in_page(hub)
    own = processor_time(psutil.Process())
    with tempfile.TemporaryDirectory() as folder, serve_class(Path(folder), count) as hub:
        many = asyncio.run(asyncio.wait_for(class_of(hub, count), AT_MOST))
    return {
        "pupils": count,
        "cores": os.cpu_count(),
        "alone": one,
        "page": page,
        "class": many,
        "simulating": processor_time(psutil.Process()) - own,
    }


def lines(found: dict[str, Any]) -> list[str]:
    """The figures as a plain table."""
    one, many, count = found["alone"], found["class"], found["pupils"]
    memory, used = many["memory"], many["processor"]
    server = memory["server"]
    rows = [f"{count} pupils, {found['cores']} cores", "", "Memory that is nobody else's, USS"]
    rows += [f"{'a server':24}{server:8.0f} MB{'pupils a GB':>16}"]
    for name in STEPS:
        kernel = memory[name]
        rows.append(f"{'a kernel, ' + name:24}{kernel:8.0f} MB{1000 / (server + kernel):16.1f}")
    rows += ["", f"{'Starting at once':24}{'signed in':>20}{'first panel':>20}"]
    for name, who in {"a pupil alone": one, f"{count} at once": many}.items():
        cells = [f"{np.median(who[key]):8.1f}, last{max(who[key]):6.1f} s" for key in STARTS]
        rows.append(f"{name:22}" + "".join(cells))
    parts = ", ".join(f"{name} {seconds:.2f}" for name, seconds in used.items())
    rows += [f"Processor time of a pupil: {sum(used.values()):.2f} s: {parts}"]
    rows += ["", f"{'Dragging a slider':24}{'letters/s each':>16}{'median':>12}{'p95':>12}"]
    for some, took in {1: one["took"], **many["took"]}.items():
        middle, late = np.percentile(took, [50, 95]) * 1e3
        rate = len(took) / some / DRAGGING
        rows.append(f"{f'{some} at once':24}{rate:16.1f}{middle:9.0f} ms{late:9.0f} ms")
    for name, seen in found["page"].items():
        rows.append(
            f"In a page, the {name}: {seen['messages']} messages and {seen['processor']:.2f} s of "
            f"processor time in {seen['seconds']:.1f} s"
        )
    rows += ["", f"One more pupil reads: {many['too_many']}"]
    rows += [f"Simulating the class took {found['simulating']:.1f} s of processor time."]
    return rows


def main() -> None:
    """Measure, print, and write the figures where asked."""
    asked = argparse.ArgumentParser(prog="python -m tests.benchmarks.load", description=__doc__)
    asked.add_argument("--pupils", type=int, default=MOST, choices=range(1, MOST + 1), metavar="N")
    asked.add_argument("--json", type=Path, help="where to write the figures, too")
    options = asked.parse_args()
    found = measure(options.pupils)
    print("\n".join(lines(found)))
    if options.json:
        options.json.write_text(json.dumps(found, indent=2), encoding="utf-8")


if __name__ == "__main__":
    main()

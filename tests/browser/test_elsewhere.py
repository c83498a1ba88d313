"""Panels in a program that gives no more than anywidget promises, as VS Code and Colab do."""

import base64
import json

import comm
import pytest
from comm.base_comm import BaseComm

import dmp_teach as teach
from tests.browser.conftest import PATIENCE, listen

# No more than anywidget promises a script, in a frame that belongs to nobody and may fetch nothing.
HOST = """<!doctype html>
<meta http-equiv="Content-Security-Policy" content="default-src 'none';
    script-src 'unsafe-inline' blob:; style-src 'unsafe-inline'; img-src data:">
<body style="background: #1f1f1f; color: #cccccc"><main></main>
<script type="module">
const widgets = {};
let unsent = [];
const bytes = text => new DataView(Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer);
const base64 = part => btoa(String.fromCharCode(...new Uint8Array(part.buffer ?? part)));
const end = new AbortController();

function modelOf(id, state) {
    const listeners = {};
    const changed = {};
    const tell = (event, ...given) => listeners[event]?.forEach(call => call(...given));
    const model = {
        get: name => state[name],
        set(name, value) {
            state[name] = changed[name] = value;
            tell(`change:${name}`);
        },
        on: (event, call) => (listeners[event] ??= []).push(call),
        off: (event, call) => {
            listeners[event] = listeners[event].filter(each => each !== call);
        },
        save_changes() {
            const data = { method: "update", state: { ...changed }, buffer_paths: [] };
            for (const name of Object.keys(changed)) delete changed[name];
            unsent.push({ id, data, buffers: [] });
        },
        send(content, callbacks, buffers = []) {
            unsent.push({ id, data: { method: "custom", content }, buffers: buffers.map(base64) });
        },
    };
    const take = news => {
        Object.assign(state, news);
        for (const name of Object.keys(news)) tell(`change:${name}`);
    };
    return { model, tell, take };
}

async function open(id, { _esm, _css, ...traits }) {
    // ipywidgets' own layout.
    if (!_esm) return;
    const widget = widgets[id] = modelOf(id, traits);
    document.head.append(Object.assign(document.createElement("style"), { textContent: _css }));
    const url = URL.createObjectURL(new Blob([_esm], { type: "text/javascript" }));
    widget.script = import(url).then(({ default: made }) => made()).then(async made => {
        await made.initialize({ model: widget.model, signal: end.signal });
        return made;
    });
}

async function render(id, el, signal) {
    const { model, script } = widgets[id];
    const host = {
        getWidget: async name => ({
            render: place => render(name.replace("anywidget:", ""), place.el, place.signal),
        }),
    };
    await (await script).render({ model, el, signal, host });
}

const hear = {
    open: (id, { state }) => open(id, state),
    update: (id, { state }) => widgets[id].take(state),
    custom: (id, { content }, buffers) =>
        widgets[id].tell("msg:custom", content, buffers.map(bytes)),
    echo_update() {},
    show: id => render(id, document.querySelector("main"), end.signal),
};
while (!window.exchange) await new Promise(requestAnimationFrame);
for (;;) {
    const sent = unsent;
    unsent = [];
    for (const { id, data, buffers } of JSON.parse(await window.exchange(JSON.stringify(sent))))
        hear[data.method ?? "open"](id, data, buffers);
    await new Promise(done => setTimeout(done, 50));
}
</script>"""


class Kernel:
    """Widgets in this process, and messages that a page sends and fetches."""

    def __init__(self):
        self.comms = {}
        self.unsent = []

    def open(self, **options):
        kernel = self

        class Comm(BaseComm):
            def publish_msg(self, msg_type, data=None, metadata=None, buffers=None, **keys):
                kernel.say(self.comm_id, data, buffers or [])

        made = Comm(**options)
        self.comms[made.comm_id] = made
        return made

    def say(self, name, data, buffers=()):
        packed = [base64.b64encode(part).decode() for part in buffers]
        self.unsent.append({"id": name, "data": data, "buffers": packed})

    def exchange(self, text):
        for each in json.loads(text):
            buffers = [memoryview(base64.b64decode(part)) for part in each["buffers"]]
            message = {"content": {"data": each["data"]}, "buffers": buffers}
            self.comms[each["id"]].handle_msg(message)
        unsent, self.unsent = self.unsent, []
        return json.dumps(unsent)


@pytest.fixture
def strict(chromium, monkeypatch):
    """Show a panel in the strict host; the frame with it."""
    context = chromium.new_context(viewport={"width": 1366, "height": 900})
    kernel = Kernel()
    context.expose_function("exchange", kernel.exchange)
    page = context.new_page()
    listen(page)
    page.set_default_timeout(PATIENCE / 2)

    def show(make):
        monkeypatch.setattr(comm, "create_comm", kernel.open)
        panel = make()
        kernel.say(panel.comm.comm_id, {"method": "show"})
        page.set_content(
            "<body style='margin: 0'><iframe sandbox='allow-scripts' "
            "style='width: 100%; height: 890px; border: 0'></iframe>"
        )
        page.locator("iframe").evaluate("(frame, text) => { frame.srcdoc = text; }", HOST)
        frame = page.frame_locator("iframe")
        frame.locator(".dt-panel[data-dt-drawing]").wait_for()
        return panel, frame, page

    yield show
    troubles = page.troubles
    context.close()
    assert troubles == []


def test_explore_and_its_robot_need_no_more_than_a_widget_is_promised(strict, shot):
    panel, frame, page = strict(teach.explore)
    look = "node => getComputedStyle(node).backgroundColor"
    assert frame.locator(".dt-panel").evaluate(look) == "rgb(17, 20, 23)", "dark as its host"
    said = frame.locator(".dt-says").inner_text()
    bumps = frame.get_by_role("slider", name="How many bumps")
    bumps.press("ArrowLeft")
    assert bumps.evaluate("node => node.matches('[data-lm-suppress-shortcuts]')")
    frame.locator(".dt-explore[data-dt-drawing='2']").wait_for()
    assert frame.locator(".dt-says").inner_text() != said
    assert panel.n_kernels == int(bumps.input_value())
    frame.get_by_role("button", name="Robot, write it").click()
    frame.locator(".dt-scene[data-dt-awake='true']").wait_for()
    shot(page, "strict_explore")


def test_what_is_drawn_on_a_pad_arrives(strict, shot):
    pad, frame, page = strict(teach.pad)
    box = frame.locator(".dt-sheet canvas").first.bounding_box()
    places = [(box["x"] + 60 + 2 * n, box["y"] + 80 + n % 30) for n in range(60)]
    page.mouse.move(*places[0])
    page.mouse.down()
    for place in places:
        page.mouse.move(*place)
    page.mouse.up()
    frame.locator(".dt-pad[data-dt-strokes='1']").wait_for()
    shot(page, "strict_pad")
    assert len(pad.recording.strokes()) == 1


def test_a_lesson_wakes_where_nothing_can_be_stored(strict, shot):
    _, frame, page = strict(teach.lesson("05").panel)
    shot(page, "strict_lesson")
    assert frame.get_by_role("button").count() > 0

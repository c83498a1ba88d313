"""In another, longer language no English is left behind, and every text has its room."""

from tests.browser.test_lab import notebook_of

PANELS = (
    """import dmp_teach as teach
teach.set_language("pseudo")
teach.explore()""",
    """pad = teach.pad("D")
pad""",
    """pad.load(teach.recording_of("D"))
pad.load(teach.recording_of("D", "slanted"))""",
    "from dmp_teach.views import SceneView\nSceneView()",
)
SIZES = {
    "laptop": {"width": 1366, "height": 768},
    "tablet": {"width": 820, "height": 1180},
}

TEXTS = """() => {
    const told = new Set();
    const tell = text => text && told.add(text.trim());
    for (const panel of document.querySelectorAll('.dt-panel, .dt-scene')) {
        panel.innerText.split(/[\\n\\t]/).forEach(tell);
        for (const node of panel.querySelectorAll('svg title, svg text, option'))
            if (node.checkVisibility() || node.matches('title')) tell(node.textContent);
        for (const node of panel.querySelectorAll('*'))
            for (const name of ['aria-label', 'aria-valuetext', 'aria-roledescription', 'title'])
                tell(node.getAttribute(name));
    }
    return [...told];
}"""

CROWDED = """() => {
    const found = [];
    const unseen = '.dt-spoken, legend, .dts-hidden, svg, select, input';
    const isLeftOut = node => node.closest(unseen);
    for (const panel of document.querySelectorAll('.dt-panel, .dt-scene')) {
        const edge = panel.getBoundingClientRect();
        for (const node of panel.querySelectorAll('*')) {
            if (!node.checkVisibility() || isLeftOut(node)) continue;
            const box = node.getBoundingClientRect();
            const isWide = node.clientWidth > 0 && node.scrollWidth > node.clientWidth + 1;
            const isOff = box.right > edge.right + 1 || box.left < edge.left - 1;
            const words = (node.innerText ?? '').slice(0, 60).replaceAll('\\n', ' ');
            if (isWide || isOff) found.push(`${node.className || node.tagName}: ${words}`);
        }
        for (const text of panel.querySelectorAll('svg text')) {
            const [box, sheet] = [text, text.ownerSVGElement].map(n => n.getBoundingClientRect());
            const isOff = box.right > sheet.right + 1 || box.left < sheet.left - 1;
            if (box.width && isOff) found.push(`${text.classList}: ${text.textContent}`);
        }
    }
    return found;
}"""

ENGLISH = """told => {
    const rest = text => {
        const left = text.replace(/\\[[^[\\]]*\\]/g, '');
        return left === text ? text : rest(left);
    };
    return told.filter(text => /\\p{L}{2}/u.test(rest(text)));
}"""


def test_no_string_is_left_behind_and_no_box_overflows(open_notebook, lab, shot):
    (lab.folder / "pseudo.ipynb").write_text(notebook_of(*PANELS))
    page = open_notebook("pseudo.ipynb", viewport=SIZES["laptop"])
    page.evaluate("() => window.jupyterapp.shell.collapseLeft()")
    for size, viewport in SIZES.items():
        page.set_viewport_size(viewport)
        for kind in ("explore", "pad"):
            page.locator(f".dt-{kind}").scroll_into_view_if_needed()
            page.wait_for_selector(f".dt-{kind}[data-dt-drawing]")
            page.wait_for_timeout(300)
            shot(page, f"pseudo_{kind}_{size}")
        page.locator(".dt-tries li").nth(1).wait_for()
        told = page.evaluate(TEXTS)
        assert len(told) > 60
        assert page.evaluate(ENGLISH, ["Undo", "[Üñdö] 3 [á [b]]"]) == ["Undo"]
        assert "\n".join(page.evaluate(ENGLISH, told)) == ""
        assert "\n".join(page.evaluate(CROWDED)) == "", size

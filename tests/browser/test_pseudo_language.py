"""In another, longer language no English is left behind, and every text has its room."""

import re

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


# Units are the same in every language, and so are the paper's names and those of robot pupils.
UNITS = re.compile(r"(?<!\w)(mm|cm|ms|/s|DMP|Δw|Δz|Bo|Ida|Leo|Mia|Zoe)(?!\w)")
LESSONS = """import dmp_teach as teach
from dmp_teach.lessons import lessons
teach.set_language("pseudo")
panels = [teach.lesson(key).panel() for key in lessons()]
for panel in panels:
    bet = panel.lesson.bet.described()
    panel.bet(bet["handles"] if "handles" in bet else bet["options"][0][0])"""
STEPS_OF_LESSONS = (
    "for panel in panels: display(panel)",
    "for panel in panels: panel.reveal(); panel.go('try')",
    "for panel in panels: panel.go('challenge'); panel.check(); panel.check(); panel.show_hint()",
    "for panel in panels: panel.values = panel.lesson.solution; panel.check(); panel.save()",
)


def test_lessons_speak_the_language_in_every_step(open_notebook, lab, shot):
    (lab.folder / "pseudo_lessons.ipynb").write_text(
        notebook_of(LESSONS, *STEPS_OF_LESSONS[:1]).replace(
            "import dmp_teach", "from IPython.display import display\\nimport dmp_teach"
        )
    )
    page = open_notebook("pseudo_lessons.ipynb", viewport=SIZES["laptop"])
    page.evaluate("() => window.jupyterapp.shell.collapseLeft()")
    run = """async (code) => {
        const kernel = window.jupyterapp.shell.currentWidget.sessionContext.session.kernel;
        const reply = await kernel.requestExecute({code}).done;
        return reply.content.status + (reply.content.evalue ?? "");
    }"""
    for number, step in enumerate(("pass", *STEPS_OF_LESSONS[1:])):
        assert page.evaluate(run, step) == "ok"
        for size, viewport in SIZES.items():
            page.set_viewport_size(viewport)
            page.wait_for_timeout(1000)
            shot(page, f"pseudo_lessons_{number}_{size}")
            told = [UNITS.sub("", text) for text in page.evaluate(TEXTS)]
            assert "\n".join(page.evaluate(ENGLISH, told)) == ""
            assert "\n".join(page.evaluate(CROWDED)) == "", (step, size)

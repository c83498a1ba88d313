"""The docs as files: every link leads somewhere, nothing is fetched, and a lesson's panel lives."""

import re
from html import unescape
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

from dmp_teach.launcher.docs_site import make_docs
from dmp_teach.launcher.lab import NOTEBOOKS

LESSON = NOTEBOOKS / "05_move_the_goal.ipynb"
LINE = "nodes => nodes.map(node => node.getAttribute('d')).join('')"
pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def docs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("docs") / "site"
    make_docs(folder, [LESSON], [8])
    return folder


@pytest.fixture
def page(docs, chromium, request):
    """The first page, opened from disk with the network cut."""
    seen = []
    context = chromium.new_context(offline=True, viewport={"width": 1366, "height": 768})
    page = context.new_page()
    page.on("request", lambda request: seen.append(request.url))
    page.on("pageerror", lambda error: seen.append(f"page error: {error}"))
    page.on("console", lambda said: said.type == "error" and seen.append(f"console: {said.text}"))
    page.goto((docs / "index.html").as_uri())
    yield page
    context.close()
    ours = (docs.as_uri(), "data:", "blob:")
    assert [each for each in seen if each and not each.startswith(ours)] == []


def broken(file):
    """The links of a page to a file or a place that is not there."""
    text = file.read_text(encoding="utf-8")
    for link in re.findall(r'\b(?:href|src)="([^"]*)"', text):
        parts = urlsplit(unescape(link))
        if parts.scheme or parts.netloc:
            continue
        target = (file.parent / unquote(parts.path)).resolve() if parts.path else file
        place = f'id="{parts.fragment}"'
        if not target.is_file() or (parts.fragment and place not in target.read_text("utf-8")):
            yield link


def test_every_link_leads_somewhere_and_no_formula_is_left_as_it_was_typed(docs):
    pages = [file for file in docs.rglob("*.html") if file.parent.name != "live"]
    assert len(pages) > 30
    found = {str(Path(file).relative_to(docs)): list(broken(file)) for file in pages}
    assert {name: links for name, links in found.items() if links} == {}
    api = "".join(page.read_text(encoding="utf-8") for page in (docs / "api").glob("*.html"))
    assert (
        re.findall(rf"{re.escape(str(NOTEBOOKS.parent))}|_SupportsArray|TypeAliasForwardRef", api)
        == []
    )
    lesson = (docs / "lessons" / f"{LESSON.stem}.html").read_text(encoding="utf-8")
    assert lesson.count("<math") >= 5
    assert "$" not in re.sub(r"<(script|pre)\b.*?</\1>", "", lesson, flags=re.DOTALL)


def test_from_the_first_page_to_letter_and_to_a_ring_that_leads_the_line(page, shot):
    shot(page, "docs_home")
    page.get_by_role("link", name="dmp_teach.letters").click()
    page.locator("[id='dmp_teach.Letter']").wait_for()
    assert "learn(" in page.locator("[id='dmp_teach.Letter.learn']").inner_text()
    shot(page, "docs_api")
    page.get_by_role("link", name="What happens when the goal moves?").click()
    panel = page.frame_locator("iframe.live").first
    panel.locator(".dt-handle").first.press("ArrowDown")
    panel.get_by_role("button", name="Lay the truth over it").click()
    panel.get_by_role("button", name="Now try it").click()
    line = panel.locator(".dt-paper .dt-robot-line")
    before = line.evaluate_all(LINE)
    ring = panel.locator(".dt-goal .dt-ring").first
    ring.scroll_into_view_if_needed()
    box = ring.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 40, y + 30, steps=5)
    page.mouse.up()
    assert line.evaluate_all(LINE) != before
    shot(page, "docs_lesson")
    page.set_viewport_size({"width": 390, "height": 844})
    assert page.evaluate("document.documentElement.scrollWidth") == 390
    shot(page, "docs_lesson_on_a_phone")

// Sheets with writing lines: the child's ink as dots, the robot's letter as a line that grows, numbers at the starts.

const STILLS = 3;
const SVG_DOT = "h0.01";

/** A sheet. Gives {node, title, view(), draw({box, lines, dots, line, rest, pen, numbered, title})}; lengths are metres. */
function writingSheet({ small = false } = {}) {
  const title = make("title", { id: newId("title") });
  const [rules, rest, line, dots, marks] = [make("g"), make("g"), make("g"), make("g"), make("g")];
  const node = make("svg", { class: "dt-paper", role: "img", "aria-labelledby": title.id }, title, rules, rest, line, dots, marks);
  const state = { size: [0, 0], scene: null };
  const view = () => viewOf(state.scene.box, state.size);
  const redraw = () => {
    if (!state.size[0] || !state.scene) return;
    const { scene } = state;
    const [now, ink] = [view(), [...scene.dots, ...scene.line]];
    rules.replaceChildren(...scene.lines.map((y, i) => writingLine(now, y, i === 0)));
    fill(rest, scene.rest ?? [], "dt-rest", now);
    fill(line, scene.line, "dt-robot-line", now);
    fill(dots, scene.dots, "dt-child-dots", now);
    marks.replaceChildren(...(small ? [] : startsOf(now, scene.numbered, ink)), ...penOf(now, scene.pen));
    title.textContent = scene.title;
  };
  new ResizeObserver(() => ((state.size = [node.clientWidth, node.clientHeight]), redraw())).observe(node);
  return { node, view, draw: (scene) => ((state.scene = scene), redraw()) };
}

/** As many paths as there are strokes; a stroke that stays in its place is a dot. */
function fill(group, strokes, name, view) {
  while (group.childElementCount > strokes.length) group.lastChild.remove();
  while (group.childElementCount < strokes.length) group.append(make("path", { class: name }));
  strokes.forEach((points, i) => {
    const places = points.map((p) => view.px(p).map((v) => v.toFixed(2)).join(" "));
    const still = places.every((place) => place === places[0]);
    group.children[i].setAttribute("d", places.length ? `M${still ? places[0] + SVG_DOT : places.join("L")}` : "");
  });
}

/** The line that letters stand on is solid, the one above it is dashed. */
function writingLine(view, y, base) {
  const at = view.px([0, y])[1].toFixed(1);
  return make("line", { class: base ? "dt-baseline" : "dt-midline", x1: 16, x2: view.w - 16, y1: at, y2: at });
}

/** A circle and a number where each stroke starts, a number at a dot; numbers of starts that lie on each other share one label. */
function startsOf(view, strokes, ink) {
  const isLong = ([start, ...rest]) => rest.some((p) => view.k * Math.hypot(p[0] - start[0], p[1] - start[1]) > 8);
  const ring = ([cx, cy]) => make("g", { class: "dt-start" }, make("circle", { cx, cy, r: 6 }));
  const rings = strokes.filter(isLong).map(([start]) => ring(view.px(start)));
  const labels = startLabels(view, { demo: strokes }, String);
  return [...rings, ...labels.map(({ at, words }) => make("text", { class: "dt-small", ...labelPlace(view, at, { demo: ink }, 12) }, words))];
}

function penOf(view, pen) {
  if (!pen) return [];
  const [cx, cy] = view.px(pen.at);
  return [make("circle", { class: pen.down ? "dt-pen dt-down" : "dt-pen", cx, cy, r: 7 })];
}

/** What is written of a letter at one moment: {line, rest, pen, numbered}. `times` are seconds from its first point. */
function momentOf(strokes, times, moment) {
  const begun = strokes.filter((_, i) => times[i][0] <= moment);
  const line = begun.map((points, i) => {
    const end = times[i].findIndex((t) => t > moment);
    if (end < 0) return points;
    const part = (moment - times[i][end - 1]) / (times[i][end] - times[i][end - 1]);
    const tip = points[end].map((v, axis) => points[end - 1][axis] + part * (v - points[end - 1][axis]));
    return [...points.slice(0, end), tip];
  });
  const last = line[line.length - 1];
  return { line, rest: strokes, numbered: begun, pen: last && { at: last[last.length - 1], down: true } };
}

/** Let a letter be written at its own tempo: `draw(moment)` every frame, `done()` at the end. Gives a function that ends it. */
function playLetter(times, draw, done) {
  const end = times[times.length - 1].at(-1);
  let begin = null;
  let frame = null;
  const step = (now) => {
    begin ??= now;
    const moment = (now - begin) / 1000;
    if (moment >= end) return done();
    draw(moment);
    frame = requestAnimationFrame(step);
  };
  frame = requestAnimationFrame(step);
  return () => cancelAnimationFrame(frame);
}

/** The moments of a letter in stills: the end of each stroke, or thirds of a single one. */
function stillsOf(times) {
  const ends = times.map((t) => t.at(-1));
  return ends.length > 1 ? ends : Array.from({ length: STILLS }, (_, i) => (ends[0] * (i + 1)) / STILLS);
}

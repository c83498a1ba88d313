// The sheet: the child's dots, the robot's line, starts, and a goal ring for each stroke that can be dragged.
// Lengths from Python are metres; everything drawn is in screen pixels, so that labels keep their size.

const RING = 10;
const CATCH = 22;
const AROUND = Array.from({ length: 16 }, (_, i) => [Math.cos((Math.PI * i) / 8), Math.sin((Math.PI * i) / 8)]);

/**
 * A sheet of paper. `onGoal(stroke, [x, y], done)` is called while a ring moves, with the place in metres.
 * Gives {node, sheet(box), draw({demo, robot, taught, goals, stroke, title})}.
 */
function paper({ onGoal, onHome, onPick }) {
  const clip = newId("clip");
  const title = make("title", { id: newId("title") });
  const frame = make("rect", { width: "100%", height: "100%", rx: 6 });
  const grid = make("g");
  const robot = make("g", { "clip-path": `url(#${clip})` });
  const demo = make("g", { "clip-path": `url(#${clip})` });
  const marks = make("g");
  const rings = make("g");
  const node = make(
    "svg", { class: "dt-paper", role: "group", "aria-labelledby": title.id },
    title, make("defs", {}, make("clipPath", { id: clip }, frame)), grid, robot, demo, marks, rings,
  );
  const state = { box: [-0.1, -0.1, 0.1, 0.1], scene: null, size: [0, 0], badges: [], words: {} };

  const look = () => viewOf(state.box, state.size);
  const redraw = () => {
    if (!state.size[0] || !state.scene) return;
    const view = look();
    drawGrid(grid, view);
    drawLetter(view);
    drawMarks(marks, view, state.scene);
    drawRings(view);
  };
  const drawLetter = (view) => {
    const path = (points) => "M" + points.map((p) => view.px(p).map((v) => v.toFixed(2)).join(" ")).join("L");
    const fit = (group, strokes, name) => {
      while (group.childElementCount > strokes.length) group.lastChild.remove();
      while (group.childElementCount < strokes.length) group.append(make("path", { class: name }));
      strokes.forEach((points, i) => group.children[i].setAttribute("d", path(points)));
    };
    fit(robot, state.scene.robot, "dt-robot-line");
    fit(demo, state.scene.demo, "dt-child-dots");
    title.textContent = state.scene.title;
  };
  const drawRings = (view) => {
    const { goals, names } = state.scene;
    while (rings.childElementCount > goals.length) rings.lastChild.remove();
    while (rings.childElementCount < goals.length) rings.append(ring(rings.childElementCount));
    if (!state.dragging) {
      state.badges = badgePlaces(view, state.scene);
      state.words = goals.length > 1 ? null : wordPlace(view, goals[0], state.scene);
    }
    goals.forEach((goal, i) => placeRing(rings.children[i], view, goal, names[i], state, i));
  };

  /** One goal: it takes focus, arrow keys move it 1 mm (Shift 1 cm), Home puts it back. */
  const ring = (i) => {
    const [wide, thin] = [newId("ring"), "dt-goal"];
    const group = make(
      "g", { id: wide, class: thin, tabindex: 0, role: "slider", "aria-valuemin": -1000, "aria-valuemax": 1000 },
      make("line", { class: "dt-rule dt-stalk" }), make("circle", { class: "dt-catch", r: CATCH }), make("circle", { class: "dt-halo", r: 17 }),
      make("circle", { class: "dt-focus", r: 17 }), make("path", { class: "dt-ring", d: CROSS }),
      make("circle", { class: "dt-catch dt-catch-badge", r: CATCH }), make("circle", { class: "dt-badge", r: 14 }), make("text", { class: "dt-count", dy: 5 }), make("text", { class: "dt-name" }),
    );
    const move = (place, done) => onGoal(i, place, done);
    group.addEventListener("pointerdown", (event) => {
      if (event.button) return;
      group.setPointerCapture(event.pointerId);
      onPick(i);
      state.dragging = { i, id: event.pointerId, from: [event.clientX, event.clientY], goal: state.scene.goals[i] };
      event.preventDefault();
      group.focus({ preventScroll: true, focusVisible: false });
    });
    // Chromium heeds no `touch-action` inside an SVG: a finger on a ring would scroll the notebook away.
    group.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
    group.addEventListener("pointermove", (event) => {
      const drag = state.dragging;
      if (!drag || drag.i !== i || drag.id !== event.pointerId) return;
      const { k } = look();
      move([drag.goal[0] + (event.clientX - drag.from[0]) / k, drag.goal[1] - (event.clientY - drag.from[1]) / k], false);
    });
    const drop = () => {
      if (!state.dragging) return;
      state.dragging = null;
      move(state.scene.goals[i], true);
      redraw();
    };
    group.addEventListener("pointerup", drop);
    group.addEventListener("pointercancel", drop);
    group.addEventListener("focus", () => onPick(i));
    group.addEventListener("keydown", (event) => {
      const step = event.shiftKey ? 0.01 : 0.001;
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (!way && event.key !== "Home") return;
      event.preventDefault();
      event.stopPropagation();
      if (event.key === "Home") return onHome(i);
      const goal = state.scene.goals[i];
      move([goal[0] + step * way[0], goal[1] + step * way[1]], true);
    });
    return group;
  };

  new ResizeObserver(() => {
    state.size = [node.clientWidth, node.clientHeight];
    redraw();
  }).observe(node);
  return {
    node,
    sheet: (box) => (state.box = box),
    bounds: () => {
      const view = look();
      if (!view.w) return state.box;
      const [left, bottom] = view.metres([16, view.h - 16]);
      const [right, top] = view.metres([view.w - 16, 16]);
      return [left, bottom, right, top];
    },
    draw: (scene) => {
      state.scene = scene;
      redraw();
    },
  };
}

/** How a sheet of `size` [px] shows a box of metres: {w, h, k, px(place), metres(pixel)}; k is pixels a metre. */
function viewOf([x0, y0, x1, y1], [w, h]) {
  const k = Math.min(w / (x1 - x0), h / (y1 - y0));
  const middle = [(x0 + x1) / 2, (y0 + y1) / 2];
  const px = ([x, y]) => [w / 2 + (x - middle[0]) * k, h / 2 - (y - middle[1]) * k];
  return { w, h, k, px, metres: ([x, y]) => [middle[0] + (x - w / 2) / k, middle[1] - (y - h / 2) / k] };
}

const CROSS = `M${RING} 0A${RING} ${RING} 0 1 1 ${-RING} 0A${RING} ${RING} 0 1 1 ${RING} 0` + "M-16 0H-5M5 0H16M0 -16V-5M0 5V16";

/** How long the bar is that shows centimetres, and where its words end. */
const rulerLength = ({ k }) => [1, 2, 5, 10, 20].find((n) => n * 0.01 * k > 48) ?? 50;
const rulerEnd = (view) => 24 + rulerLength(view) * 0.01 * view.k + 44;

/** Squares of 1 cm (5 cm where they would be too small), and a bar that says how long a centimetre is. */
function drawGrid(group, { w, h, k, metres, px }) {
  const square = 0.01 * k > 7 ? 0.01 : 0.05;
  const [left, bottom] = metres([0, h]);
  const lines = [];
  for (let x = Math.ceil(left / square) * square; px([x, 0])[0] < w; x += square) lines.push(`M${px([x, 0])[0].toFixed(1)} 0V${h}`);
  for (let y = Math.ceil(bottom / square) * square; px([0, y])[1] > 0; y += square) lines.push(`M0 ${px([0, y])[1].toFixed(1)}H${w}`);
  const cm = rulerLength({ k });
  const bar = `M16 ${h - 24}v8h${(cm * 0.01 * k).toFixed(1)}v-8`;
  const words = make("text", { class: "dt-small", x: 24 + cm * 0.01 * k, y: h - 12 }, `${cm} cm`);
  group.replaceChildren(make("path", { class: "dt-grid", d: lines.join("") }), make("path", { class: "dt-rule", d: bar }), words);
}

/** Starts, the goals as they were taught, and an arrow where the robot's line has left the sheet. */
function drawMarks(group, view, scene) {
  const { demo, robot, taught, goals } = scene;
  group.replaceChildren(...demo.map((points) => {
    const [x, y] = view.px(points[0]);
    return make("g", { class: "dt-start" }, make("circle", { cx: x, cy: y, r: 6 }));
  }));
  for (const { at, words } of startLabels(view, scene)) group.append(make("text", { class: "dt-small", ...labelPlace(view, at, scene) }, words));
  taught.forEach((place, i) => {
    const [[x0, y0], [x1, y1]] = [view.px(place), view.px(goals[i])];
    if (Math.hypot(x1 - x0, y1 - y0) < 3) return;
    group.append(make("circle", { class: "dt-before", cx: x0, cy: y0, r: RING }), make("path", { class: "dt-before", d: `M${x0} ${y0}L${x1} ${y1}` }));
  });
  const away = outside(view, robot.flat());
  if (away) group.append(make("path", { class: "dt-robot-line", d: away.arrow }), make("text", { ...away.at }, away.words));
}

/** One label for starts that lie on each other: "start 1, 2". */
function startLabels(view, { demo }, name = (number) => (demo.length > 1 ? `start ${number}` : "start")) {
  const labels = [];
  demo.forEach((points, i) => {
    const at = view.px(points[0]);
    const near = labels.find((label) => Math.hypot(label.at[0] - at[0], label.at[1] - at[1]) < 24);
    if (near) near.words += `, ${i + 1}`;
    else labels.push({ at, words: name(i + 1) });
  });
  return labels;
}

/** Where a label of `wide` pixels hides the least ink: right, left, above or below its point. */
function labelPlace(view, [x, y], { demo }, wide = 50) {
  const ink = demo.flat().filter((_, i) => i % 4 === 0).map(view.px);
  const places = [[14, 5, "start"], [-14, 5, "end"], [0, -14, "middle"], [12, -10, "start"], [-12, -10, "end"], [0, 26, "middle"]];
  const cost = ([dx, dy, anchor]) => {
    const left = x + dx - { start: 0, middle: wide / 2, end: wide }[anchor];
    const hidden = ink.filter(([px, py]) => px > left - 4 && px < left + wide + 4 && Math.abs(py - y - dy + 5) < 11).length;
    return hidden + 100 * (left < 4 || left + wide > view.w - 4 || y + dy < 16 || y + dy > view.h - 6);
  };
  const [dx, dy, anchor] = places.reduce((a, b) => (cost(b) < cost(a) ? b : a));
  return { x: x + dx, y: y + dy, "text-anchor": anchor };
}

/** The side where the line is furthest off the sheet, and by how much: "0.4 m further right". */
function outside(view, points) {
  const { w, h, k, px } = view;
  let worst = null;
  for (const point of points) {
    const [x, y] = px(point);
    const sides = [[x - w, "right", [w - 30, y], "M-8 -8L8 0L-8 8"], [-x, "left", [30, y], "M8 -8L-8 0L8 8"], [-y, "up", [x, 30], "M-8 8L0 -8L8 8"], [y - h, "down", [x, h - 30], "M-8 -8L0 8L8 -8"]];
    for (const [far, way, at, arrow] of sides) if (far > 4 && (!worst || far > worst.far)) worst = { far, way, at, arrow };
  }
  if (!worst) return null;
  const x = Math.min(Math.max(worst.at[0], 30), w - 30);
  const y = Math.min(Math.max(worst.at[1], 30), h - 44);
  const metres = worst.far / k;
  const words = metres < 0.1 ? `${Math.ceil(100 * metres)} cm further ${worst.way}` : `${metres.toFixed(1)} m further ${worst.way}`;
  const anchor = x > w / 2 ? "end" : "start";
  const shifted = worst.arrow.replace(/([ML])(-?\d+) (-?\d+)/g, (_, c, a, b) => `${c}${x + Number(a)} ${y + Number(b)}`);
  return { arrow: shifted, at: { x: anchor === "end" ? x + 12 : x - 12, y: y + 28, "text-anchor": anchor }, words };
}

/** A place for each stroke's number, away from the other rings and numbers, so that each can be caught. */
function badgePlaces(view, { goals, robot }) {
  if (goals.length < 2) return [null];
  const places = goals.map(view.px);
  const ink = robot.flat().filter((_, i) => i % 6 === 0).map(view.px);
  const taken = [];
  for (const [i, [x, y]] of places.entries()) {
    const cost = ([dx, dy]) => {
      const at = [x + 40 * dx, y + 40 * dy];
      const away = (points, reach) => points.reduce((sum, p) => sum + Math.max(0, reach - Math.hypot(p[0] - at[0], p[1] - at[1])), 0);
      const off = Math.max(0, 24 - at[0], 24 - at[1], at[0] - view.w + 24, at[1] - view.h + 24);
      const onRuler = Math.max(0, Math.min(rulerEnd(view) + 20 - at[0], at[1] - view.h + 48));
      return 30 * (off + onRuler) + 8 * away(taken, 46) + 4 * away(places.filter((_, j) => j !== i), 30) + away(ink, 22);
    };
    const best = AROUND.reduce((a, b) => (cost(b) < cost(a) - 1e-9 ? b : a));
    taken.push([x + 40 * best[0], y + 40 * best[1]]);
  }
  return taken.map(([x, y], i) => [x - places[i][0], y - places[i][1]]);
}

/** A place for the word "goal" where it hides the least ink: above, below, right or left of its ring. */
function wordPlace(view, goal, { robot, demo }) {
  const [x, y] = view.px(goal);
  const ink = [...robot.flat(), ...demo.flat()].filter((_, i) => i % 3 === 0).map(view.px);
  const places = [[0, -24, "middle", -18], [0, 36, "middle", -18], [24, 5, "start", 0], [-24, 5, "end", -36]];
  const cost = ([dx, dy, , left]) => {
    const [x0, y0] = [x + dx + left, y + dy - 5];
    const hidden = ink.filter(([px, py]) => px > x0 - 4 && px < x0 + 40 && Math.abs(py - y0) < 12).length;
    return hidden + 100 * (x0 < 4 || x0 + 36 > view.w - 4 || y0 < 12 || y0 > view.h - 12);
  };
  const [dx, dy, anchor] = places.reduce((a, b) => (cost(b) < cost(a) ? b : a));
  return { x: dx, y: dy, "text-anchor": anchor };
}

/** Move one ring, its number and its words to where the goal is. */
function placeRing(group, view, goal, name, state, i) {
  const [x, y] = view.px(goal);
  change(group, { transform: `translate(${x.toFixed(2)} ${y.toFixed(2)})`, "aria-label": name.label, "aria-valuenow": name.now, "aria-valuetext": name.text });
  const badge = state.badges[i];
  const chosen = state.scene.stroke === i ? "dt-chosen" : "";
  const [stalk, dot, number, words, far] = [".dt-stalk", ".dt-badge", ".dt-count", ".dt-name", ".dt-catch-badge"].map((s) => group.querySelector(s));
  for (const node of [stalk, dot, number, far]) node.style.display = badge ? "" : "none";
  words.style.display = badge ? "none" : "";
  if (!badge) return change(words, state.words).replaceChildren("goal");
  const part = (Math.hypot(...badge) - 14) / Math.hypot(...badge);
  change(stalk, { x1: badge[0] * 0.4, y1: badge[1] * 0.4, x2: badge[0] * part, y2: badge[1] * part });
  for (const node of [dot, far]) change(node, { cx: badge[0], cy: badge[1] });
  change(dot, { class: `dt-badge ${chosen}` });
  change(number, { x: badge[0], y: badge[1], class: `dt-count ${chosen}` }).replaceChildren(String(i + 1));
}

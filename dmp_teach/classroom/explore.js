// The start panel: a letter, the robot's copy of it, sliders, and the robot that writes what is seen.

function render({ model, el, host, signal }) {
  const root = keepKeys(make("div", { class: "dt-panel dt-explore" }));
  const parts = { ...head(model), ...stage(model), says: says(model), ...knobs(model) };
  parts.write = parts.says.write;
  parts.write.addEventListener("click", () => letRobotWrite(model, parts));
  root.append(parts.head, parts.stage, make("div", { class: "dt-says" }, parts.says.node, parts.asleep), parts.knobs, parts.more);
  el.append(root);

  const redraw = () => (drawLetter(model, parts), root.setAttribute("data-dt-drawing", model.get("drawing")));
  const redrawWork = () => drawWork(model, parts);
  model.on("change:drawing", redraw);
  model.on("change:work", () => (redrawWork(), tellWork(model, parts)));
  model.on("change:older", () => drawOlder(model, parts));
  const redrawLetters = () => drawLetters(model, parts, { onChange: (letter) => ask(model, { letter }) });
  model.on("change:choices change:letter", redrawLetters);
  const stopWatching = watch(model, root, parts);
  redrawLetters();
  redraw();
  redrawWork();
  drawOlder(model, parts);
  showRobot(model, host, parts.robotHost, signal);
  return stopWatching;
}

/** Ask Python for a new letter. The front end merges events by itself while the kernel is busy. */
function ask(model, changes) {
  for (const [name, value] of Object.entries(changes)) model.set(name, value);
  model.set("asked", model.get("asked") + 1);
  model.save_changes();
}

// Rows ---------------------------------------------------------------------------------------------------------------

function head(model) {
  const letters = make("div", { style: "display:contents" });
  return { head: make("div", { class: "dt-head" }, letters, legend("the person", "the robot")), letters };
}

function stage(model) {
  const sheet = paper({
    onPick: (stroke) => stroke !== model.get("stroke") && ask(model, { stroke }),
    onHome: (stroke) => moveGoal(model, stroke, [0, 0]),
    onGoal: (stroke, place) => {
      const taught = taughtGoals(model)[stroke];
      const [left, bottom, right, top] = sheet.bounds();
      const inside = [Math.min(Math.max(place[0], left), right), Math.min(Math.max(place[1], bottom), top)];
      moveGoal(model, stroke, [inside[0] - taught[0], inside[1] - taught[1]]);
      drawLetter(model, sheet.parts);
    },
  });
  const hint = make("span", {}, "drag the ring to move the goal");
  const older = make("span", {}, FETCH);
  const robotHost = make("div", { class: "dt-robot" });
  const left = make("div", {}, make("div", { class: "dt-caption" }, make("b", {}, "On paper"), hint), sheet.node);
  const work = make("div", { class: "dt-work", hidden: true });
  const spoken = spokenBox();
  const right = make("div", { class: "dt-table" }, make("div", { class: "dt-caption" }, make("b", {}, "At the table"), older), robotHost, work, spoken);
  return { stage: make("div", { class: "dt-stage" }, left, right), sheet, hint, older, robotHost, work, workSpoken: spoken };
}

function says(model) {
  const bar = sentence();
  const write = button("Robot, write it", { drawing: icon(ICONS.pen), main: true });
  write.classList.add("dt-write");
  bar.node.append(write);
  return { ...bar, write };
}

function knobs(model) {
  const { n_kernels: n, kernel_width: width } = model.get("knobs");
  const cm = (value) => `${value < -5e-5 ? "−" : value > 5e-5 ? "+" : ""}${Math.abs(100 * value).toFixed(1)} cm`;
  const goal = (axis, label, term, [less, more]) =>
    slider({ label, term, low: -0.1, high: 0.1, step: 0.001, zero: 0, mark: "as written", text: cm, onInput: (value) => moveAxis(model, axis, value),
      spoken: (value) => (Math.abs(value) < 5e-5 ? "as written" : `${Math.abs(100 * value).toFixed(1)} centimetres ${value < 0 ? less : more}`) });
  const parts = {
    count: slider({ ...n, step: 1, text: String, spoken: (v) => `${v} bumps in each stroke`, icons: [bump("one"), bump("many")], onInput: (v) => ask(model, { n_kernels: v }) }),
    width: slider({ ...width, step: 0.01, scale: LOG, text: widthText, spoken: widthSpoken, icons: [bump("narrow"), bump("one")], onInput: (v) => ask(model, { kernel_width: v }) }),
    goalX: goal(0, "Goal, left and right", "x", ["to the left", "to the right"]),
    goalY: goal(1, "Goal, down and up", "y", ["down", "up"]),
  };
  const strokes = make("div", { style: "display:contents" });
  const home = button("Put the goals back", { drawing: icon(ICONS.back), onClick: () => ask(model, { goal_shifts: model.get("goal_shifts").map(() => [0, 0]) }) });
  const asleep = make("div", { class: "dt-asleep", hidden: true, role: "status" }, "The robot does not answer. If it stays so, run the cell above again: Shift and Enter.");
  const more = make("div", { class: "dt-more" }, strokes, home, fileButton(model), make("span", { class: "dt-quiet" }, "Arrow keys move a ring 1 mm, with Shift 1 cm"));
  const rows = [parts.count, parts.width, parts.goalX, parts.goalY].map((part) => part.node);
  return { knobs: make("div", { class: "dt-knobs" }, ...rows), ...parts, strokes, home, asleep, more };
}

const widthText = (value) => (value < 1 ? value.toFixed(2) : value.toFixed(1));
function widthSpoken(value) {
  if (value < 0.995) return `${widthText(value)}, with gaps between the bumps`;
  if (value < 1.005) return "1.0, the bumps just touch";
  return `${widthText(value)}, each bump covers the places of ${widthText(value)}`;
}

// What is seen -------------------------------------------------------------------------------------------------------

const taughtGoals = (model) => strokesOf(model, "demo").map((points) => points[points.length - 1]);

function moveGoal(model, stroke, shift) {
  const shifts = model.get("goal_shifts").map((pair, i) => (i === stroke ? shift.map((v) => Math.round(v * 1e4) / 1e4) : pair));
  ask(model, { goal_shifts: shifts, stroke });
}

function moveAxis(model, axis, value) {
  const stroke = model.get("stroke");
  const shift = [...model.get("goal_shifts")[stroke]];
  shift[axis] = value;
  moveGoal(model, stroke, shift);
}

function drawLetter(model, parts) {
  const { sheet } = parts;
  sheet.parts = parts;
  const [taught, shifts, stroke] = [taughtGoals(model), model.get("goal_shifts"), model.get("stroke")];
  if (shifts.length !== taught.length) return;
  const many = taught.length > 1;
  const names = shifts.map(([x, y], i) => ringName(many ? `Goal of stroke ${i + 1}` : "Goal", x, y));
  sheet.sheet(model.get("sheet"));
  sheet.draw({
    demo: strokesOf(model, "demo"), robot: strokesOf(model, "robot"), taught, stroke, names, title: model.get("title"),
    goals: taught.map(([x, y], i) => [x + shifts[i][0], y + shifts[i][1]]),
  });
  parts.hint.textContent = many ? "drag a number to move its goal" : "drag the ring to move the goal";
  parts.says.show(model.get("message"));
  showKnobs(model, parts, taught[stroke], shifts[stroke]);
}

function ringName(label, x, y) {
  const side = (value, less, more) => (Math.abs(value) < 5e-5 ? "" : `${Math.abs(100 * value).toFixed(1)} centimetres ${value < 0 ? less : more}`);
  const text = [side(x, "left", "right"), side(y, "down", "up")].filter(Boolean).join(", ") || "as written";
  return { label: `${label}. Arrow keys move it, Home puts it back.`, now: Math.round(1000 * x), text };
}

function showKnobs(model, parts, taught, shift) {
  const [left, bottom, right, top] = parts.sheet.bounds();
  const mm = (value) => Math.round(value * 1000) / 1000;
  const high = Math.min(model.get("knobs").n_kernels.high, model.get("most_kernels"));
  parts.count.show(model.get("n_kernels"), model.get("knobs").n_kernels.low, high);
  parts.width.show(model.get("kernel_width"));
  parts.goalX.show(shift[0], Math.min(mm(left - taught[0]), shift[0]), Math.max(mm(right - taught[0]), shift[0]));
  parts.goalY.show(shift[1], Math.min(mm(bottom - taught[1]), shift[1]), Math.max(mm(top - taught[1]), shift[1]));
  const strokes = model.get("counts").length;
  if (parts.strokes.dataset.strokes !== String(strokes)) {
    const options = Array.from({ length: strokes }, (_, i) => ({ value: String(i), label: `stroke ${i + 1}`, name: `Goal sliders move stroke ${i + 1}` }));
    parts.picker = strokes > 1 ? choice({ legend: "Which stroke’s goal", options, value: model.get("stroke"), onChange: (v) => ask(model, { stroke: Number(v) }) }) : null;
    parts.strokes.replaceChildren(...(parts.picker ? [parts.picker.node] : []));
    parts.strokes.dataset.strokes = strokes;
  }
  parts.picker?.show(model.get("stroke"));
}

export default { render };

// What every panel with a robot shares: its letters, its steps and cures, its 3-D view, and whether the kernel is awake.
// `parts` holds {robotHost, older, work, workSpoken, write, asleep, letters} of the panel.

const FETCH = "a robot named Fetch";
const SLEEPY = 4000;
const LATE = 300;

/** Who is who: the child is dotted, the robot is a line. */
function legend(person, robot) {
  const key = (kind, words) => make("span", {}, make("svg", { "aria-hidden": "true" }, make("path", { class: kind, d: "M2 5H36" })), words);
  return make("div", { class: "dt-legend" }, key("dt-child-dots", person), key("dt-robot-line", robot));
}

/** The letters that are near, as one bar, and the rest as a list. */
function drawLetters(model, parts, { trait = "letter", onChange }) {
  const options = model.get("choices").map(([value, label, name, group]) => ({ value, label, group, name: aloud(label, name) }));
  const focused = parts.letters.contains(document.activeElement);
  const [near, more] = [options.filter((o) => model.get("near").includes(o.value)), options.filter((o) => !model.get("near").includes(o.value))];
  const bar = choice({ legend: "Letter", kind: "dt-letters", options: near, value: model.get(trait), onChange });
  const rest = list({ name: "More letters", options: more, value: model.get(trait), onChange });
  parts.letters.replaceChildren(bar.node, rest);
  if (focused) (bar.node.querySelector("input:checked") ?? rest).focus();
}

/** Read aloud, m and M sound the same, and so do é and É. */
function aloud(label, name) {
  return /^\p{Lu}$/u.test(label) ? `${name}, capital` : /^\p{Ll}$/u.test(label) ? `${name}, small` : name;
}

/** Bytes of float32 x, y, x, y ... [m], cut into strokes of `counts` points. */
function strokesOf(model, name, counts = model.get("counts")) {
  const bytes = model.get(name);
  const numbers = new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
  let at = 0;
  return counts.map((n) => Array.from({ length: n }, () => [numbers[at++], numbers[at++]]));
}

/** A person's own recording, read by the kernel of this notebook and kept nowhere. */
function fileButton(model) {
  const input = make("input", { type: "file", accept: ".csv,.json,.inkml,.svg,.mat", "aria-label": "Open your own recording, a CSV, JSON, InkML, SVG or MAT file" });
  const node = make("label", { class: "dt-button" }, icon(ICONS.file), make("span", {}, "Your own recording"), input);
  input.addEventListener("change", async () => {
    const file = input.files[0];
    if (!file) return;
    if (file.size > 8e6) model.send({ kind: "too large", name: file.name, size: file.size });
    else model.send({ kind: "file", name: file.name }, undefined, [await file.arrayBuffer()]);
    input.value = "";
  });
  return node;
}

/** Dim the number when an answer is late; say so when the kernel sleeps. */
function watch(model, root, parts) {
  let since = null;
  const asked = () => (since ??= performance.now());
  const answered = () => (since = parts.awaitsRobot = null);
  model.on("change:asked", asked);
  model.on("change:answered change:work", answered);
  parts.waits = asked;
  keepOutOfFiles(model, model.get("own_id"));
  const timer = setInterval(() => {
    const waiting = since === null ? 0 : performance.now() - since;
    root.classList.toggle("dt-late", waiting > LATE);
    if (parts.asleep.hidden === waiting < SLEEPY) return;
    parts.asleep.hidden = waiting < SLEEPY;
    if (!parts.asleep.hidden && parts.awaitsRobot) bringIntoSight(parts.asleep); // a press has led elsewhere
  }, 100);
  return () => clearInterval(timer);
}

const bringIntoSight = (node) => node.scrollIntoView({ block: "nearest" });

/** Let the robot write, where it is seen. A kernel that was started anew cannot hear: then the panel says so. */
function letRobotWrite(model, parts) {
  if (model.get("work").state === "working") return;
  bringIntoSight(parts.robotHost.parentElement);
  parts.waits();
  parts.awaitsRobot = true;
  try {
    model.send({ kind: "write" });
  } catch (error) {
    console.warn(error);
  }
}

function drawOlder(model, parts) {
  parts.older.textContent = model.get("older") ? "older letter" : FETCH;
  parts.robotHost.toggleAttribute("data-dt-older", model.get("older"));
}

/** Named steps with a bar while the robot plans; or what cannot be done, by how much, and the cure. */
function drawWork(model, parts) {
  const [work, host] = [model.get("work"), parts.work];
  host.hidden = work.state === "idle";
  host.className = `dt-work ${work.state === "cannot" ? "dt-cannot" : ""}`;
  change(parts.write, { "aria-disabled": work.state === "working" ? "true" : null });
  if (work.state === "working") showSteps(model, parts, work);
  if (work.state === "cannot") {
    const words = make("span", {}, make("b", {}, work.strong), ` ${work.text}`);
    const cure = work.cure ? button(work.cure, { main: true, onClick: () => model.send({ kind: "cure" }) }) : null;
    const close = button("Close", { onClick: () => model.send({ kind: "close" }) });
    host.replaceChildren(make("p", { role: "alert" }, icon(ICONS.warning), words), make("div", { class: "dt-cures" }, cure, close));
  }
}

/** The list is made anew at every report; the button stays, or a press between two reports would be lost. */
function showSteps(model, parts, work) {
  const list = parts.work.querySelector(".dt-steps");
  const stop = () => (model.send({ kind: "stop" }), (parts.stopped = true));
  if (list) list.replaceWith(stepList(work));
  else parts.work.replaceChildren(stepList(work), workFooter(stop));
}

/** For those who do not see the bar: that the robot plans, that it writes, or that it was stopped. */
function tellWork(model, parts) {
  const state = model.get("work").state;
  if (state === parts.workState) return;
  const ended = parts.workState === "working" && state === "idle";
  const says = state === "working" ? "The robot plans." : !ended ? "" : parts.stopped ? "The robot stopped." : "The robot has its plan and writes.";
  parts.workSpoken.textContent = says;
  parts.workState = state;
  parts.stopped = false;
}

function stepList(work) {
  const items = work.steps.map((words, i) => {
    const [done, now] = [i < work.at, i === work.at];
    const drawing = icon(done ? ICONS.tick : now ? ICONS.arrow : ICONS.later);
    if (done) drawing.classList.add("dt-done");
    const figure = done ? "yes" : now ? `${Math.round(100 * work.fraction)} %` : "";
    const item = make("li", { "aria-current": now ? "step" : null }, drawing, make("span", {}, words), make("span", {}, figure));
    if (now) item.append(progressBar(words, work.fraction));
    return item;
  });
  return make("ol", { class: "dt-steps" }, ...items);
}

function progressBar(words, fraction) {
  const inner = make("div", { style: `width:${100 * fraction}%` });
  return make("div", { class: "dt-bar", role: "progressbar", "aria-label": words, "aria-valuemin": 0, "aria-valuemax": 100, "aria-valuenow": Math.round(100 * fraction) }, inner);
}

function workFooter(stop) {
  return make("footer", {}, make("span", { class: "dt-quiet" }, ""), button("Stop", { onClick: stop }));
}

/** JupyterLab can keep the state of panels in the notebook. Of these it keeps a sentence: no ink leaves the memory. */
async function keepOutOfFiles(model, id) {
  const kept = await model.widget_manager?.get_model?.(id);
  if (!kept) return;
  const [state, resting] = [kept.get_state.bind(kept), model.get("resting")];
  kept.get_state = (...how) => ({ ...Object.fromEntries(Object.entries(state(...how)).filter(([name]) => name.startsWith("_"))), _esm: resting, _css: "" });
}

/** The 3-D view is a widget of its own; here it stands inside this card. */
async function showRobot(model, host, el, signal) {
  const scene = model.get("scene");
  keepOutOfFiles(model, scene.split(":").pop());
  const child = await host.getWidget(scene);
  await child.render({ el, signal });
}

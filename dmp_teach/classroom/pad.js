// The writing pad: the robot shows its letter, somebody writes it, the robot learns that and writes it again.

const CALM = "(prefers-reduced-motion: reduce)";

function render({ model, el, host, signal }) {
  const root = keepKeys(make("div", { class: "dt-panel dt-pad" }));
  const parts = { sent: 0, pending: [], ...head(model), ...table(), says: sentence() };
  Object.assign(parts, childSheet(model, parts), robotSheet(model, parts), results(), footer(model, parts));
  const asleep = make("div", { class: "dt-asleep", hidden: true, role: "status" }, "The pad does not answer. If it stays so, run the cell above again: Shift and Enter.");
  root.append(
    parts.head, make("div", { class: "dt-stage" }, parts.left, parts.right), make("div", { class: "dt-says" }, parts.says.node, asleep),
    parts.table, parts.rows, parts.strip, parts.footer,
  );
  el.append(root);
  parts.asleep = asleep;
  parts.root = root;

  const letters = () => drawLetters(model, parts, { trait: "character", onChange: (character) => ask(model, parts, { character }) });
  const redraw = () => (turnTheSheet(model, parts), drawPad(model, parts), drawRows(model, parts), drawTries(model, parts), change(root, { "data-dt-drawing": model.get("drawing"), "data-dt-strokes": model.get("counts").length }));
  const redrawWork = () => (showTable(model, parts), drawWork(model, parts));
  const redrawScene = async () => {
    if (!model.get("scene")) return;
    parts.robotHost.replaceChildren();
    await showRobot(model, host, parts.robotHost, signal);
  };
  const stopWatching = watch(model, root, parts);
  model.on("change:drawing", redraw);
  model.on("change:answered", () => ((parts.pending = parts.pending.filter((stroke) => stroke.n > model.get("answered"))), drawPad(model, parts)));
  model.on("change:caught", () => (parts.caught.textContent = model.get("caught")));
  model.on("change:kept", () => drawKept(model, parts));
  model.on("change:character", () => (letters(), endShow(parts)));
  model.on("change:character change:sheet", () => parts.dropInk("Another sheet: that stroke is gone.")); // its points would lie elsewhere
  model.on("change:work", () => (redrawWork(), tellWork(model, parts)));
  model.on("change:older", () => drawOlder(model, parts));
  model.on("change:scene", () => (showTable(model, parts), redrawScene().then(() => bringIntoSight(parts.table))));
  parts.caught.textContent = model.get("caught");
  letters();
  redraw();
  drawKept(model, parts);
  redrawWork();
  drawOlder(model, parts);
  redrawScene();
  return () => (stopWatching(), endShow(parts));
}

/** Tell Python what was done. Its answer carries the number of the message. */
function tell(model, parts, message, content) {
  parts.sent = Math.max(parts.sent, model.get("answered")) + 1;
  parts.waits();
  try {
    model.send({ ...message, n: parts.sent }, undefined, content && [content]);
  } catch (error) {
    console.warn(error);
  }
  return parts.sent;
}

function ask(model, parts, changes) {
  for (const [name, value] of Object.entries(changes)) model.set(name, value);
  model.save_changes();
  parts.pending = [];
}

// Rows ---------------------------------------------------------------------------------------------------------------

function head(model) {
  const letters = make("div", { style: "display:contents" });
  return { head: make("div", { class: "dt-head" }, letters, legend("your letter", "the robot’s letter")), letters };
}

/** Where the child writes, and the buttons below it. */
function childSheet(model, parts) {
  const sheet = writingSheet();
  const caught = make("span", { class: "dt-caught", role: "status" });
  const spoken = spokenBox();
  const [hintWords, more] = [make("span"), make("span", { class: "dt-roomy" }, ", with finger, pen or mouse")];
  const hint = make("p", { class: "dt-hint", "aria-hidden": "true" }, make("span", {}, hintWords, more));
  const speak = later((words) => (spoken.textContent = words), 500);
  const ink = inkCanvas({
    view: sheet.view,
    home: () => robotStrokes(model, "model")[model.get("counts").length]?.[0] ?? [0, model.get("lines")[1]],
    onBegin: () => ((hint.hidden = true), (caught.textContent = "")),
    onStroke: (rows, kind, outside) => {
      const n = tell(model, parts, { kind: "stroke", pointer: kind, outside }, new Float64Array(rows.flat()).buffer);
      parts.pending.push({ n, points: rows.map((row) => row.slice(1, 3)) });
      drawPad(model, parts);
    },
    onKeys: (pen, words) => ((parts.pen = pen), drawPad(model, parts), speak(words)),
    onLost: (words) => ((caught.textContent = words), drawPad(model, parts)),
  });
  const undo = button("Undo", { drawing: icon(ICONS.back), onClick: () => tell(model, parts, { kind: "undo" }) });
  const again = button("Start again", { onClick: () => tell(model, parts, { kind: "again" }) });
  const all = button("That is all", { onClick: () => tell(model, parts, { kind: "all" }) });
  const caption = make("div", { class: "dt-caption" }, make("b", {}, "Your sheet"), caught);
  const stack = make("div", { class: "dt-sheet" }, sheet.node, hint, ink.node);
  const hands = make("div", { class: "dt-hands" }, undo, again);
  parts.says.node.append(all);
  return { left: make("div", {}, caption, stack, hands, spoken), sheet, ink: ink.node, dropInk: ink.drop, hint, hintWords, caught, undo, again, all };
}

/** Where the robot shows its own letter, or what it has learned. */
function robotSheet(model, parts) {
  const sheet = writingSheet();
  const caption = make("p", { class: "dt-told", role: "status" });
  const show = button("Show it", { main: true, onClick: () => showIt(model, parts) });
  const write = button("Robot, write it", { drawing: icon(ICONS.pen), onClick: () => ((parts.table.hidden = false), letRobotWrite(model, parts)) });
  const options = [
    { value: "model", label: "its own", name: "The robot’s own letter" },
    { value: "copy", label: "learned", name: "What the robot has learned from you" },
  ];
  const views = choice({ legend: "The robot’s sheet shows", options, value: "model", onChange: (value) => parts.robotView(value) });
  const robotHint = make("span");
  const hint = make("p", { class: "dt-hint" }, robotHint);
  const robotView = (value) => {
    endShow(parts);
    parts.seen = value;
    views.show(value);
    drawPad(model, parts);
  };
  const head = make("div", { class: "dt-caption" }, make("b", {}, "The robot’s letter"), views.node);
  const stack = make("div", { class: "dt-sheet" }, sheet.node, hint, caption);
  const hands = make("div", { class: "dt-hands" }, show, write);
  return { right: make("div", {}, head, stack, hands), robotPaper: sheet, robotCaption: caption, robotHint, show, write, robotView, seen: "model" };
}

function table() {
  const [older, robotHost] = [make("span", {}, FETCH), make("div", { class: "dt-robot" })];
  const [work, spoken] = [make("div", { class: "dt-work", hidden: true }), spokenBox()];
  const caption = make("div", { class: "dt-caption" }, make("b", {}, "At the table"), older);
  return { table: make("div", { class: "dt-table", hidden: true }, caption, robotHost, work, spoken), older, robotHost, work, workSpoken: spoken };
}

const results = () => ({ rows: make("ul", { class: "dt-rows", "aria-label": "How near it is", hidden: true }), strip: make("ol", { class: "dt-tries", "aria-label": "Your tries, in order" }) });

/** What is kept, and what is forgotten; forgetting asks once more. */
function footer(model, parts) {
  const words = make("p", { class: "dt-quiet", role: "status" });
  const save = button("Save", { drawing: icon(ICONS.file), onClick: () => tell(model, parts, { kind: "save" }) });
  const forget = button("Forget", { onClick: () => surely(true) });
  const yes = button("Yes, forget all", { onClick: () => (tell(model, parts, { kind: "forget" }), surely(false)) });
  const no = button("Keep", { onClick: () => surely(false) });
  const ask = make("div", { class: "dt-surely", hidden: true }, make("span", {}, "Forget every try, and remove what was saved?"), yes, no);
  const surely = (open) => {
    ask.hidden = !open;
    forget.setAttribute("aria-expanded", String(open));
    (open ? no : forget).focus();
  };
  forget.setAttribute("aria-expanded", "false");
  return { footer: make("div", { class: "dt-footer" }, words, make("div", { class: "dt-hands" }, fileButton(model), forget, save), ask), keptWords: words };
}

/** Call `act` with the last words once `wait` ms have passed without new ones. */
function later(act, wait) {
  let timer = null;
  return (words) => (clearTimeout(timer), (timer = setTimeout(() => act(words), wait)));
}

/** The robot's sheet shows its own letter while somebody writes, and what it has learned once the letter is there. */
function turnTheSheet(model, parts) {
  const strokes = model.get("counts").length;
  if (!strokes && parts.strokes) parts.robotView("model");
  if (strokes > (parts.strokes ?? 0) && !model.get("unfinished")) parts.robotView("copy");
  parts.strokes = strokes;
}

// What is seen -------------------------------------------------------------------------------------------------------

const robotStrokes = (model, name) => strokesOf(model, name, name === "model" ? model.get("model_times").map((t) => t.length) : model.get(`${name}_counts`));

function drawPad(model, parts) {
  const written = [...strokesOf(model, "ink"), ...parts.pending.map((stroke) => stroke.points)];
  const [box, lines, character] = [model.get("sheet"), model.get("lines"), model.get("character")];
  const letter = character ? `${anA(character)}` : "a letter";
  parts.sheet.draw({ box, lines, dots: written, line: [], numbered: written, pen: parts.pen, title: model.get("title") });
  parts.ink.setAttribute("aria-label", `${model.get("title")} Write ${letter} with finger, pen or mouse; or with keys: Space puts the pen down and lifts it, arrows move it, with Shift further, Home goes to the start.`);
  parts.hintWords.textContent = `Write ${letter} here`;
  parts.hint.hidden = written.length > 0 || Boolean(parts.pen);
  parts.all.hidden = !model.get("unfinished");
  parts.says.show(model.get("message"));
  if (!parts.playing) drawRobot(model, parts, { box, lines, written });
}

/** "an a", "a b": the name of the letter is what is heard. */
const anA = (character) => `${"aefhilmnorsxAEFHILMNORSX8".includes(character) ? "an" : "a"} ${character}`;

function drawRobot(model, parts, { box, lines, written }) {
  const own = parts.seen === "model";
  const [strokes, learned] = [robotStrokes(model, own ? "model" : "robot"), model.get("counts").length > 0];
  const line = own || learned ? strokes : [];
  const isDone = learned && !model.get("unfinished");
  const dots = own ? (isDone && line.length ? laidOn(model) : []) : strokesOf(model, "ink");
  put(parts.robotCaption, dots.length ? (own ? "with your dots on it" : "learned from your dots") : "");
  parts.robotHint.textContent = line.length ? "" : own ? "Choose a letter, and the robot shows it" : "The robot learns from what you write";
  const name = own ? `The robot’s own ${model.get("character")}` : "What the robot learned from you";
  parts.robotPaper.draw({ box, lines, dots, line, numbered: line, title: line.length ? `${name}, ${line.length} stroke${line.length > 1 ? "s" : ""}.` : "The robot’s sheet is empty." });
  change(parts.show, { "aria-disabled": model.get("character") ? null : "true" });
}

/** The child's ink, laid on the robot's own letter as the number compares them. */
function laidOn(model) {
  const [right, up] = model.get("shift");
  return strokesOf(model, "ink").map((points) => points.map(([x, y]) => [x + right, y + up]));
}

/** The robot is the teacher: its letter grows at its own tempo; people who ask for less movement get stills. */
function showIt(model, parts) {
  if (!model.get("character")) return;
  const [strokes, times] = [robotStrokes(model, "model"), model.get("model_times")];
  const still = parts.playing?.still ?? -1;
  parts.robotView("model");
  const [box, lines] = [model.get("sheet"), model.get("lines")];
  const draw = (moment) => parts.robotPaper.draw({ box, lines, dots: [], title: `The robot writes its ${model.get("character")}.`, ...momentOf(strokes, times, moment) });
  if (matchMedia(CALM).matches) return showStill(parts, draw, stillsOf(times), still + 1);
  draw(0);
  parts.playing = { stop: playLetter(times, draw, () => (endShow(parts), drawPad(model, parts))) };
  parts.root.setAttribute("data-dt-showing", "true");
  parts.robotCaption.textContent = "watch where it starts";
}

/** One picture a press: the letter so far. */
function showStill(parts, draw, stills, number) {
  const at = number % stills.length;
  draw(stills[at]);
  parts.playing = { stop: () => {}, still: at };
  parts.show.querySelector("span").textContent = "Next picture";
  parts.robotCaption.textContent = `picture ${at + 1} of ${stills.length}`;
}

function endShow(parts) {
  parts.playing?.stop();
  parts.playing = null;
  parts.show.querySelector("span").textContent = "Show it";
  parts.root?.removeAttribute("data-dt-showing");
}

/** Three rows: what, four circles, a word, a reason. */
function drawRows(model, parts) {
  const rows = model.get("parts");
  const circles = (level) => make("svg", { viewBox: "0 0 96 24", "aria-hidden": "true" }, ...[0, 1, 2, 3].map((i) => make("circle", { class: i <= level ? "dt-full" : "dt-open", cx: 12 + 24 * i, cy: 12, r: 9 })));
  const item = ({ name, level, word, reason }) => make("li", {}, make("span", {}, name), circles(level), make("b", {}, word), make("span", { class: "dt-reason" }, reason));
  const waits = !rows.length && model.get("tries").length > 0; // between two tries their place stays: nothing jumps
  parts.rows.style.minHeight = waits ? `${parts.rows.offsetHeight}px` : "";
  parts.rows.hidden = !rows.length && !waits;
  parts.rows.replaceChildren(...rows.map(item));
}

function drawTries(model, parts) {
  const [tries, box, lines] = [model.get("tries"), model.get("sheet"), model.get("lines")];
  parts.strip.hidden = !tries.length;
  const strokes = strokesOf(model, "tried", tries.flatMap((each) => each.counts));
  const own = robotStrokes(model, "model");
  let at = 0;
  const items = tries.map(({ number, mm, word, counts }) => {
    const sheet = writingSheet({ small: true });
    const dots = strokes.slice(at, (at += counts.length));
    sheet.draw({ box, lines, dots, line: own, title: `Try ${number}, ${mm} mm from the robot’s letter.` });
    return make("li", {}, make("div", { class: "dt-caption" }, make("b", {}, `Try ${number}`), make("span", {}, `${mm.replace("under ", "< ")} mm`)), sheet.node, make("span", {}, word));
  });
  parts.strip.replaceChildren(...items);
}

function drawKept(model, parts) {
  parts.keptWords.textContent = model.get("kept") || "Nothing is kept until you press Save. The score is ours, not a school test.";
}

/** The robot's table is there as soon as somebody has asked for it. */
function showTable(model, parts) {
  if (model.get("scene") || model.get("work").state !== "idle") parts.table.hidden = false;
}

export default { render };

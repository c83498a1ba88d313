// The view: the picture, what is written so far, and the controls under it. Needs scene_3d.js before it.

const CAMERA_NAMES = { "whole robot": "Whole robot", "over the shoulder": "Over the shoulder", "page from above": "Page from above" };
const SEEN_NAMES = { "as planned": "as planned", "as it happened": "as it happened" };
const SPEEDS = { 1: "1×", 0.5: "½×", 0.25: "¼×" };
const PLAY = "M8 5.5v13l11-6.5z";
const PAUSE = "M8 5.5h3v13H8zM14 5.5h3v13h-3z";
const NEXT = "M6 5.5v13l8-6.5zM16 5.5h2.5v13H16z";

let sceneCount = 0;

/** An element with attributes and children. */
function el(tag, attributes = {}, ...children) {
  const svg = ["svg", "path", "circle", "rect", "g", "text", "clipPath"].includes(tag);
  const node = svg ? document.createElementNS("http://www.w3.org/2000/svg", tag) : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

/** Radio buttons that look like one bar. */
function choice(legend, names, onChange) {
  const group = `dts-${(sceneCount += 1)}`;
  const inputs = Object.keys(names).map((value) => el("input", { type: "radio", name: group, value }));
  const labels = inputs.map((input) => el("label", {}, input, el("span", {}, names[input.value])));
  inputs.forEach((input) => input.addEventListener("change", () => onChange(input.value)));
  const node = el("fieldset", { class: "dts-choice" }, el("legend", {}, legend), ...labels);
  return { node, show: (value) => inputs.forEach((input) => (input.checked = input.value === String(value))) };
}

/** The same as a list, where there is little room. */
function list(label, names, onChange) {
  const options = Object.entries(names).map(([value, name]) => el("option", { value }, name));
  const node = el("select", { class: "dts-list", "aria-label": label }, ...options);
  node.addEventListener("change", () => onChange(node.value));
  return { node, show: (value) => (node.value = value) };
}

/** The small page with the ink so far. */
function inset() {
  const plan = el("path", { class: "dts-plan" });
  const ink = el("path", { class: "dts-ink" });
  const pen = el("circle", { class: "dts-pen" });
  const shades = shadedInk();
  const svg = el("svg", { "aria-hidden": "true" }, plan, ink, shades.node, pen);
  const share = el("span", {}, "0 %");
  const node = el("div", { class: "dts-inset" }, el("div", {}, el("b", {}, "Ink so far"), share), svg);
  let [dots, whole, curve] = [[], 1, null];
  const step = ([, x, y, first]) => `${first ? "M" : "L"}${x} ${-y}`;
  const load = (facts) => {
    dots = facts.ink;
    whole = 100 * (facts.force?.inked ?? 1); // of the letter has ink in the end
    curve = facts.force?.curve;
    const all = [...facts.plan, ...dots];
    const [xs, ys] = [all.map((dot) => dot[1]), all.map((dot) => -dot[2])];
    node.hidden = !all.length;
    if (!all.length) return;
    const [left, top] = [Math.min(...xs), Math.min(...ys)];
    const [wide, high] = [Math.max(...xs) - left, Math.max(...ys) - top];
    const side = 1.25 * Math.max(wide, high, 20);
    svg.setAttribute("viewBox", `${left + (wide - side) / 2} ${top + (high - side) / 2} ${side} ${side}`);
    svg.style.setProperty("--one", side / 100);
    pen.setAttribute("r", side / 36);
    plan.setAttribute("d", facts.plan.map(step).join(""));
  };
  const show = (time) => {
    let count = 0;
    while (count < dots.length && dots[count][0] <= time + 1e-6) count += 1;
    ink.setAttribute("d", shades.show(dots, count) ? "" : dots.slice(0, count).map(step).join(""));
    const [x, y] = curve ? feltAt(curve, time).slice(2) : (dots[Math.max(0, count - 1)] ?? [0, 0, 0]).slice(1);
    pen.setAttribute("cx", x);
    pen.setAttribute("cy", -y);
    share.textContent = `${dots.length ? Math.round((whole * count) / dots.length) : 0} %`;
  };
  return { node, load, show };
}

/** Play, the time slider and the time in words. */
function bar({ onPlay, onTime, onDone }) {
  const id = `dts-time-${(sceneCount += 1)}`;
  const shape = el("path", { fill: "currentColor" });
  const button = el("button", { type: "button", class: "dts-play" }, el("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, shape));
  const slider = el("input", { id, type: "range", min: 0, max: 1, step: 0.001, value: 0 });
  const words = el("output", { for: id, "aria-hidden": "true" });
  const label = el("label", { for: id, class: "dts-hidden" }, "Time");
  const node = el("div", { class: "dts-bar" }, button, label, slider, words);
  button.addEventListener("click", onPlay);
  slider.addEventListener("input", () => onTime(Number(slider.value)));
  slider.addEventListener("change", onDone);
  slider.addEventListener("keydown", (event) => {
    const way = { ArrowRight: 0.1, ArrowUp: 0.1, ArrowLeft: -0.1, ArrowDown: -0.1, PageUp: 1, PageDown: -1 }[event.key];
    if (!way) return;
    event.preventDefault();
    onTime(Math.round((Number(slider.value) + way) * 10) / 10);
    onDone();
  });
  const show = (time, duration) => {
    slider.max = duration || 1;
    slider.value = time;
    slider.style.setProperty("--part", `${duration ? (100 * time) / duration : 0}%`);
    slider.setAttribute("aria-valuetext", `${time.toFixed(1)} of ${duration.toFixed(1)} seconds`);
    words.textContent = `${time.toFixed(1)} s of ${duration.toFixed(1)} s`;
  };
  const face = (path, name) => {
    shape.setAttribute("d", path);
    button.setAttribute("aria-label", name);
    button.title = name;
  };
  const enable = (on) => (button.disabled = slider.disabled = !on);
  return { node, slider, show, face, enable };
}

function render({ model, el: host }) {
  const still = window.matchMedia("(prefers-reduced-motion: reduce)");
  const plan = () => model.get("seen") === "as planned" && Boolean(model.get("planned_facts").duration);
  const facts = () => model.get(plan() ? "planned_facts" : "facts");
  const run = () => model.get(plan() ? "planned_run" : "run");
  let time = Math.min(model.get("time"), facts().duration);
  let playing = false;
  let before = null;
  let frame = null;

  const set = (values, save = true) => {
    Object.entries(values).forEach(([name, value]) => model.set(name, value));
    if (save) model.save_changes();
  };
  const chooseCamera = (name) => set({ camera: name });
  const cameraBar = choice("Camera", CAMERA_NAMES, chooseCamera);
  const cameraList = list("Camera", CAMERA_NAMES, chooseCamera);
  const chooseSeen = (name) => set({ seen: name });
  const seenBar = choice("What is shown", SEEN_NAMES, chooseSeen);
  const seenList = list("What is shown", SEEN_NAMES, chooseSeen);
  const speeds = choice("Speed", SPEEDS, (value) => set({ speed: Number(value) }));
  const page = inset();
  const box = el("div", { class: "dts-box" });
  const says = el("p", { class: "dts-says", hidden: "" });
  const stage = el("div", { class: "dts-picture", role: "img" }, box, page.node, says);
  const controls = bar({ onPlay: () => press(), onTime: (t) => (stop(), show(t)), onDone: () => set({ time }) });
  const strip = forceStrip(controls.slider);
  const notes = el("p", { class: "dts-notes" });
  const head = el("div", { class: "dts-head" }, cameraBar.node, seenBar.node);
  const foot = el("div", { class: "dts-foot" }, notes, speeds.node);
  const under = el("div", { class: "dts-under" }, controls.node, cameraList.node, seenList.node);
  const root = el("div", { class: "dt-scene", "data-lm-suppress-shortcuts": "true" }, head, stage, under, strip.node, foot);
  // JupyterLab would take arrows and letters for its own commands.
  root.addEventListener("keydown", (event) => event.stopPropagation());
  host.append(root);

  const picture = new Picture(box);
  letHandsTurn(box, picture);
  const theme = () => (document.body.dataset.jpThemeLight === "false" ? "dark" : "light");

  const show = (t) => {
    time = Math.min(Math.max(t, 0), facts().duration);
    picture.seek(time);
    controls.show(time, facts().duration);
    page.show(time);
    strip.show(time);
    root.dataset.dtTime = time.toFixed(3);
    tell();
  };
  const tell = () => {
    root.dataset.dtState = !facts().duration ? "empty" : playing ? "playing" : "ready";
    root.dataset.dtAwake = String(Boolean(picture.viewer));
    root.dataset.dtInk = picture.inkTriangles();
  };
  const face = () => {
    if (still.matches) controls.face(NEXT, "Next picture");
    else controls.face(playing ? PAUSE : PLAY, playing ? "Pause" : "Play");
  };
  const tick = (now) => {
    frame = requestAnimationFrame(tick);
    const passed = before === null ? 0 : Math.min(0.1, (now - before) / 1000);
    before = now;
    show(time + passed * model.get("speed"));
    set({ time }, false);
    if (time >= facts().duration) finish();
  };
  const start = () => {
    if (playing || !facts().duration || still.matches) return still.matches && rest();
    playing = true;
    before = null;
    if (time >= facts().duration - 1e-6) time = 0;
    frame = requestAnimationFrame(tick);
    face();
    tell();
  };
  const rest = () => (show(facts().duration), set({ playing: false, time }));
  const stop = () => {
    if (playing || model.get("playing")) finish();
  };
  // A picture that nobody sees waits, and goes on when it is seen again.
  const pause = () => {
    cancelAnimationFrame(frame);
    playing = false;
    face();
    tell();
  };
  const finish = () => {
    pause();
    set({ playing: false, time });
  };
  const press = () => {
    if (still.matches) {
      const third = facts().duration / 3;
      show(time >= facts().duration - 1e-6 ? third : third * (Math.floor(time / third + 1e-6) + 1));
      set({ time });
    } else if (playing) finish();
    else start(), set({ playing: true });
  };

  const load = () => {
    page.load(facts());
    strip.load(facts());
    stage.setAttribute("aria-label", facts().label);
    notes.textContent = facts().notes;
    controls.enable(facts().duration > 0);
    root.classList.toggle("dts-empty", !facts().duration);
    for (const { node, show } of [seenBar, seenList]) {
      node.hidden = !model.get("planned_facts").duration;
      show(model.get("seen"));
    }
  };
  const aim = () => {
    const name = model.get("camera");
    cameraBar.show(name);
    cameraList.show(name);
    picture.place(facts().cameras[name]);
    page.node.classList.toggle("dts-away", name === "page from above");
  };
  const wake = async () => {
    if (picture.viewer || picture.gone) return;
    try {
      await picture.wake(model.get("viewer"), model.get("robot"), run(), theme());
      show(time);
    } catch (error) {
      console.warn(error);
      says.textContent = "This browser cannot draw in three dimensions here. The small page shows the letter; .png(path) makes a picture.";
      says.hidden = false;
      root.classList.add("dts-flat");
      root.dataset.dtState = "flat";
    }
  };
  const fresh = async () => {
    load();
    await picture.change(run());
    if (!picture.isTurned()) aim(); // each letter from where its own arm hides it least, but a hand's choice stays
    show(model.get("playing") ? 0 : model.get("time"));
    if (model.get("playing") && picture.seen) start();
  };
  // The same moment of the same letter: camera and time stay.
  const swap = async () => {
    load();
    show(time);
    await picture.change(run());
    show(time);
  };
  const shape = () => root.classList.toggle("dts-compact", model.get("compact"));

  model.on("change:motion_id", fresh);
  model.on("change:camera", aim);
  model.on("change:seen", swap);
  model.on("change:compact", shape);
  model.on("change:speed", () => speeds.show(model.get("speed")));
  model.on("change:time", () => !playing && Math.abs(model.get("time") - time) > 1e-6 && show(model.get("time")));
  model.on("change:playing", () => model.get("playing") !== playing && (playing ? finish() : start()));

  load();
  aim();
  shape();
  speeds.show(model.get("speed"));
  face();
  show(time);
  const seen = new IntersectionObserver(([entry]) => {
    picture.seen = entry.isIntersecting;
    if (entry.isIntersecting) wake().then(() => model.get("playing") && start());
    else if (playing) pause();
  });
  const size = new ResizeObserver(() => (picture.resize(), strip.draw()));
  const light = new MutationObserver(() => picture.sky(theme()));
  seen.observe(stage);
  size.observe(box);
  light.observe(document.body, { attributes: true, attributeFilter: ["data-jp-theme-light"] });
  still.addEventListener("change", face);

  return () => {
    cancelAnimationFrame(frame);
    [seen, size, light].forEach((observer) => observer.disconnect());
    still.removeEventListener("change", face);
    picture.leave();
    root.remove();
  };
}

export default { render };

// How hard the pen presses, on the slider's own clock. Uses el() of scene.js, which comes after it.

const FORCE_TOP = 1.6; // [N] the scale is always the same; what is higher is written beside an arrow
const FORCE_Y = { top: 24, zero: 104, bar: 125, height: 140 };
const SHADES = 6;
const FEELS = [
  [0.03, "The pen is in the air."], // unless it is meant to write
  [0.2, "As heavy as a pencil", "hardly touching"],
  [0.35, "As heavy as a strawberry", "good pressing"],
  [0.8, "As heavy as an egg", "good pressing"],
  [1.2, "As heavy as an apple", "good pressing"],
  [4, "As heavy as a mug", "too hard"],
  [12, "As heavy as a bottle of water", "too hard"],
  [Infinity, "As heavy as a bucket of water", "much too hard"],
];

/** The ink so far on the small page, a path for each shade of force. */
function shadedInk() {
  const paths = Array.from({ length: SHADES }, (_, n) => el("path", { class: `dts-shade dts-shade-${n}` }));
  const show = (dots, count) => {
    const shaded = dots.length > 0 && dots[0].length > 4;
    const d = paths.map(() => "");
    for (let n = 0; shaded && n < count; n += 1) {
      const [, x, y, first, shade] = dots[n];
      const from = first ? dots[n] : dots[n - 1];
      d[shade] += `M${from[1]} ${-from[2]}L${x} ${-y}`;
    }
    paths.forEach((path, n) => path.setAttribute("d", d[n]));
    return shaded;
  };
  return { node: el("g", {}, ...paths), show };
}

/** Time, force and place of the nib at a time, even from point to point of the curve. */
function feltAt(curve, t) {
  const next = curve.findIndex(([when]) => when >= t);
  if (next <= 0) return next === 0 ? curve[0] : curve[curve.length - 1];
  const part = (t - curve[next - 1][0]) / (curve[next][0] - curve[next - 1][0]);
  return curve[next].map((value, n) => curve[next - 1][n] + part * (value - curve[next - 1][n]));
}

/** The strip under the slider: force, good pressing, when the pen was meant to be down, and the moment itself. */
function forceStrip(slider) {
  const id = `dts-force-${(sceneCount += 1)}`;
  const shape = (name, tag = "path", more = {}) => el(tag, { class: `dts-f-${name}`, ...more });
  const text = (name, words) => el("text", { class: `dts-f-${name}` }, words);
  const band = shape("band", "rect");
  const [edges, zero, rest, done] = [shape("edges"), shape("zero"), shape("rest"), shape("done", "path", { "clip-path": `url(#${id})` })];
  const [bars, barsDone] = [shape("bars"), shape("bars-done", "path", { "clip-path": `url(#${id})` })];
  const [head, dot, clip] = [shape("head"), shape("dot", "circle", { r: 7 }), el("rect", { y: 0, x: 0, height: 200 })];
  const labels = { high: text("label"), low: text("label"), down: text("label", "pen down"), good: text("good", "good pressing") };
  const [peak, now] = [text("peak"), text("now")];
  const marks = [band, edges, zero, ...Object.values(labels), rest, bars, done, barsDone, peak, head, dot, now];
  const svg = el("svg", { class: "dts-strip", role: "img" }, el("clipPath", { id }, clip), ...marks);
  const newtons = el("b", { class: "dts-newtons" });
  const says = el("span", {});
  const findings = el("ul", { class: "dts-findings" });
  const title = el("p", { class: "dts-force-title" }, el("b", {}, "How hard the pen presses"));
  const sentence = el("p", { class: "dts-feels" }, newtons, says);
  const node = el("section", { class: "dts-force", hidden: "" }, title, svg, sentence, findings);
  let [facts, duration, time, left, right] = [null, 0, 0, 0, 1];

  const x = (t) => left + (duration ? (t / duration) * (right - left) : 0);
  const y = (force) => FORCE_Y.zero - (Math.min(force, FORCE_TOP) / FORCE_TOP) * (FORCE_Y.zero - FORCE_Y.top);
  const at = (node, px, py, anchor) => {
    node.setAttribute("x", px);
    node.setAttribute("y", py);
    node.setAttribute("text-anchor", anchor);
  };
  /** Lay it out again: the playhead must stand under the slider's thumb. */
  const draw = () => {
    const [box, bar] = [svg.getBoundingClientRect(), slider.getBoundingClientRect()];
    if (!facts || !box.width || !bar.width) return;
    const thumb = 14;
    [left, right] = [bar.left + thumb - box.left, bar.right - thumb - box.left];
    const [low, high] = facts.band;
    svg.setAttribute("viewBox", `0 0 ${box.width} ${FORCE_Y.height}`);
    Object.entries({ x: left, y: y(high), width: right - left, height: y(low) - y(high) }).forEach(([k, v]) => band.setAttribute(k, v));
    edges.setAttribute("d", [low, high].map((force) => `M${left} ${y(force)}H${right}`).join(""));
    zero.setAttribute("d", `M${left} ${y(0)}H${right}`);
    labels.high.textContent = `${high} N`;
    labels.low.textContent = `${low} N`;
    at(labels.high, left - 10, y(high) + 5, "end");
    at(labels.low, left - 10, y(low) + 5, "end");
    at(labels.down, left - 10, FORCE_Y.bar + 5, "end");
    const beside = box.width - right > 96;
    at(labels.good, beside ? right + 10 : right - 6, beside ? (y(low) + y(high)) / 2 + 5 : y(high) + 16, beside ? "start" : "end");
    const line = facts.curve.map(([t, force], n) => `${n ? "L" : "M"}${x(t).toFixed(1)} ${y(force).toFixed(1)}`).join("");
    const down = facts.down.map(([from, to]) => `M${x(from)} ${FORCE_Y.bar}H${x(to)}`).join("");
    [rest, done].forEach((path) => path.setAttribute("d", line));
    [bars, barsDone].forEach((path) => path.setAttribute("d", down));
    const worst = facts.curve.reduce((most, point) => (point[1] > most[1] ? point : most));
    peak.textContent = worst[1] > FORCE_TOP ? `↑ ${facts.most} N` : "";
    const near = x(worst[0]) > right - 80;
    at(peak, x(worst[0]) + (near ? -8 : 8), FORCE_Y.top - 8, near ? "end" : "start");
    show(time);
  };

  const load = (all) => {
    facts = all.force ?? null;
    duration = all.duration;
    node.hidden = !facts;
    if (!facts) return;
    svg.setAttribute("aria-label", `How hard the pen presses. ${facts.verdict}`);
    findings.replaceChildren(...facts.findings.map((words) => el("li", {}, words)));
    findings.hidden = !facts.findings.length;
    draw();
  };

  const show = (t) => {
    time = t;
    if (!facts) return;
    const [, force] = feltAt(facts.curve, t);
    const [, feel, verdict] = FEELS.find(([most]) => force < most);
    const digits = force < 10 ? 1 : 0;
    clip.setAttribute("width", Math.max(0, x(t)));
    head.setAttribute("d", `M${x(t)} 2V${FORCE_Y.height - 4}`);
    dot.setAttribute("cx", x(t));
    dot.setAttribute("cy", y(force));
    now.textContent = `${force.toFixed(digits)} N`;
    const near = x(t) > right - 64;
    at(now, x(t) + (near ? -14 : 14), Math.max(y(force) - 10, FORCE_Y.top + 16), near ? "end" : "start");
    newtons.replaceChildren(force.toFixed(digits), el("small", {}, " N"));
    const lacks = !verdict && facts.down.some(([from, to]) => from <= t && t <= to);
    const felt = verdict ? [`${feel}: `, el("b", {}, verdict), ". "] : [`${lacks ? "The pen does not reach the paper." : feel} `];
    says.replaceChildren(...felt, facts.verdict);
  };
  return { node, load, draw, show };
}


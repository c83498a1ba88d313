// Ink from a hand: pointer events on a canvas become strokes, drawn at once; or arrow keys do.
// A stroke is rows of t [s], x, y [m] and pressure; where a point is, is asked of the sheet below the canvas.

const DRIES = 150;
const PEN_NEAR = 3000;
const INK_WIDTH = 3.6;
const KEY_STEP = 0.002;
const KEY_LEAP = 0.01;
const KEY_SPEED = 0.05;
const EDGE = 2; // px that a pen may be over the edge before it has left the sheet
const KEY_WAYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/**
 * `view()` is the sheet's, `onStroke(points, kind, outside)` is called at each lift (`outside` counts what lay beyond
 * the edge), `onKeys(pen, words)` while keys write, `onLost(words)` where a stroke was interrupted, `home()` gives where
 * the key Home leads. Gives {node, drop(words)}: a stroke that is being written is taken away.
 */
function inkCanvas({ view, onStroke, onKeys, onLost, onBegin, home }) {
  const node = make("canvas", { class: "dt-ink", tabindex: 0, role: "application", "aria-roledescription": "writing pad" });
  const wet = wetInk(node, view);
  const hand = { stroke: null, penSeen: -Infinity };

  /** Where an event is on the sheet; beyond its edge the ink follows the edge, and that is counted. */
  const rowOf = (event, pressure) => {
    const [box, now] = [node.getBoundingClientRect(), view()];
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const [inX, inY] = [Math.min(Math.max(x, 0), box.width), Math.min(Math.max(y, 0), box.height)];
    if (Math.max(Math.abs(x - inX), Math.abs(y - inY)) > EDGE) hand.stroke.outside += 1;
    return [event.timeStamp / 1000, ...now.metres([(inX / box.width) * now.w, (inY / box.height) * now.h]), pressure];
  };
  const begin = (id, kind) => ((hand.stroke = { id, kind, rows: [], outside: 0 }), wet.add(hand.stroke), onBegin());
  const add = (row) => (hand.stroke.rows.push(row), wet.lengthen(hand.stroke));
  const lift = () => {
    const stroke = hand.stroke;
    hand.stroke = null;
    setTimeout(() => wet.remove(stroke), DRIES);
    onStroke(stroke.rows, stroke.kind, stroke.outside);
  };
  const drop = (words) => {
    if (!hand.stroke) return;
    wet.remove(hand.stroke);
    hand.stroke = null;
    onLost(words);
  };
  /** A hand that rests on the sheet while a pen writes, or a second finger, leaves no ink. */
  const isPalm = (event) => event.pointerType === "touch" && event.timeStamp - hand.penSeen < PEN_NEAR;
  const sees = (event) => event.pointerType === "pen" && (hand.penSeen = event.timeStamp);

  const down = (event) => {
    sees(event);
    if (event.button !== 0 || isPalm(event)) return;
    if (hand.stroke?.kind === "touch" && event.pointerType === "pen") drop("");
    if (hand.stroke?.kind === "keys") lift();
    if (hand.stroke) return;
    event.preventDefault();
    node.focus({ preventScroll: true, focusVisible: false });
    begin(event.pointerId, event.pointerType);
    add(rowOf(event, event.pressure));
    node.setPointerCapture(event.pointerId);
  };
  const mine = (event) => hand.stroke?.id === event.pointerId;
  const move = (event) => {
    sees(event);
    if (!mine(event)) return;
    if (!event.buttons) return lift();
    const events = event.getCoalescedEvents?.() ?? [];
    for (const each of events.length ? events : [event]) add(rowOf(each, each.pressure));
  };
  const up = (event) => {
    sees(event);
    if (!mine(event)) return;
    add(rowOf(event, hand.stroke.rows.at(-1)[3]));
    lift();
  };
  change(node, {
    pointerdown: down, pointermove: move, pointerup: up, contextmenu: (event) => event.preventDefault(),
    pointercancel: (event) => mine(event) && drop("The stroke was interrupted. Write it again."),
    lostpointercapture: (event) => mine(event) && lift(),
  });
  node.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
  keyInk({ node, hand, view, begin, add, lift, drop, onKeys, home });
  return { node, drop };
}

/** Wet ink, a solid line: what is being written, and what was written in the last moment. */
function wetInk(node, view) {
  const strokes = new Set();
  const pen = node.getContext("2d");
  const line = (stroke, from) => {
    const now = view();
    const scale = node.width / now.w;
    pen.strokeStyle = pen.fillStyle = getComputedStyle(node).getPropertyValue("--dt-child").trim();
    pen.lineCap = pen.lineJoin = "round";
    for (let i = Math.max(from, 1); i < stroke.rows.length; i += 1) {
      const [[, x0, y0], [, x1, y1, pressure]] = [stroke.rows[i - 1], stroke.rows[i]];
      pen.lineWidth = scale * INK_WIDTH * (stroke.kind === "pen" ? 0.5 + pressure : 1);
      pen.beginPath();
      pen.moveTo(...now.px([x0, y0]).map((v) => v * scale));
      pen.lineTo(...now.px([x1, y1]).map((v) => v * scale));
      pen.stroke();
    }
    if (from > 0) return;
    const [x, y] = now.px(stroke.rows[0].slice(1, 3)).map((v) => v * scale);
    pen.beginPath();
    pen.arc(x, y, (scale * INK_WIDTH) / 2, 0, 7);
    pen.fill();
  };
  const redraw = () => {
    const [w, h] = [node.clientWidth, node.clientHeight].map((v) => Math.round(v * devicePixelRatio));
    if (node.width !== w || node.height !== h) [node.width, node.height] = [w, h];
    pen.clearRect(0, 0, node.width, node.height);
    for (const stroke of strokes) if (stroke.rows.length) line(stroke, 0);
  };
  new ResizeObserver(redraw).observe(node);
  return {
    add: (stroke) => (strokes.add(stroke), redraw()),
    remove: (stroke) => (strokes.delete(stroke), redraw()),
    lengthen: (stroke) => line(stroke, stroke.rows.length - 1),
  };
}

/** Writing by keys: Space puts the pen down and lifts it, arrows move it 2 mm (Shift 1 cm), two arrows at once slantwise. */
function keyInk({ node, hand, view, begin, add, lift, drop, onKeys, home }) {
  const held = new Set();
  let at = null;
  const isDown = () => hand.stroke?.kind === "keys";
  const tell = () => {
    const [x, y] = at.map((v) => `${Math.abs(100 * v).toFixed(1)}`);
    onKeys({ at, down: isDown() }, `${isDown() ? "Pen down" : "Pen up"}, ${x} centimetres ${at[0] < 0 ? "left" : "right"}, ${y} ${at[1] < 0 ? "below" : "above"} the line.`);
  };
  const inside = (place) => {
    const now = view();
    const px = now.px(place);
    return now.metres([Math.min(Math.max(px[0], 0), now.w), Math.min(Math.max(px[1], 0), now.h)]);
  };
  const go = (step) => {
    const [dx, dy] = [...held].map((key) => KEY_WAYS[key]).reduce((sum, way) => [sum[0] + way[0], sum[1] + way[1]], [0, 0]);
    const [from, wanted] = [at, [at[0] + step * dx, at[1] + step * dy]];
    const to = inside(wanted);
    const far = Math.hypot(to[0] - from[0], to[1] - from[1]);
    at = to;
    if (!isDown()) return;
    if (Math.hypot(wanted[0] - to[0], wanted[1] - to[1]) > 1e-6) hand.stroke.outside += 1;
    if (!far) return;
    const [begun, pieces] = [hand.stroke.rows.at(-1)[0], Math.ceil(far / 0.001)];
    for (let i = 1; i <= pieces; i += 1) add([begun + (i * far) / pieces / KEY_SPEED, ...from.map((v, axis) => v + (i / pieces) * (to[axis] - v)), 0.5]);
  };
  const toggle = (event) => {
    if (isDown()) return lift();
    begin("keys", "keys");
    add([event.timeStamp / 1000, ...at, 0.5]);
  };
  const keydown = (event) => {
    if (event.key in KEY_WAYS) held.add(event.key);
    else if (!["Home", "Escape", " "].includes(event.key)) return;
    if (hand.stroke && !isDown()) return;
    event.preventDefault();
    at ??= inside(home());
    if (event.key in KEY_WAYS) go(event.shiftKey ? KEY_LEAP : KEY_STEP);
    else if (event.key === " ") event.repeat || toggle(event);
    else if (isDown()) event.key === "Escape" && drop("The stroke is gone.");
    else if (event.key === "Home") at = inside(home());
    tell();
  };
  change(node, { keydown, keyup: (event) => held.delete(event.key), blur: () => (held.clear(), isDown() && lift(), onKeys(null, "")) });
}

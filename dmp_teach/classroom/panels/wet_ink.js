// Ink that is not dry yet: it is drawn at once, before Python has heard of it.

/** @typedef {import("./layout.js").View} View */
/** @typedef {number[]} Row of a stroke: t [s], x, y [m] and pressure */
/** @typedef {{ id: number | string, kind: string, rows: Row[], outside: number }} Stroke */

// [px]
const INK_WIDTH = 3.6;

/**
 * Wet ink, a solid line: what is being written, and what was written in the last moment.
 * @param {HTMLCanvasElement} node
 * @param {() => View} view
 */
export function wetInk(node, view) {
  /** @type {Set<Stroke>} */
  const strokes = new Set();
  const pen = node.getContext("2d");
  /** Draw a stroke from one of its points on. */
  const line = (/** @type {Stroke} */ { rows, kind }, /** @type {number} */ from) => {
    const now = view();
    const scale = node.width / now.w;
    const pixel = (/** @type {Row} */ [, x, y]) => {
      const [right, down] = now.px([x, y]);
      return /** @type {const} */ ([right * scale, down * scale]);
    };
    const colour = getComputedStyle(node).getPropertyValue("--dt-child").trim();
    Object.assign(pen, { strokeStyle: colour, fillStyle: colour });
    Object.assign(pen, { lineCap: "round", lineJoin: "round" });
    for (let i = Math.max(from, 1); i < rows.length; i += 1) {
      pen.lineWidth = scale * INK_WIDTH * (kind === "pen" ? 0.5 + rows[i][3] : 1);
      pen.beginPath();
      pen.moveTo(...pixel(rows[i - 1]));
      pen.lineTo(...pixel(rows[i]));
      pen.stroke();
    }
    if (from > 0) return;
    pen.beginPath();
    pen.arc(...pixel(rows[0]), (scale * INK_WIDTH) / 2, 0, 7);
    pen.fill();
  };
  const redraw = () => {
    const [w, h] = [node.clientWidth, node.clientHeight].map((v) =>
      Math.round(v * devicePixelRatio),
    );
    if (node.width !== w || node.height !== h) Object.assign(node, { width: w, height: h });
    pen.clearRect(0, 0, node.width, node.height);
    for (const stroke of strokes) if (stroke.rows.length) line(stroke, 0);
  };
  new ResizeObserver(redraw).observe(node);
  return {
    add(/** @type {Stroke} */ stroke) {
      strokes.add(stroke);
      redraw();
    },
    remove(/** @type {Stroke} */ stroke) {
      strokes.delete(stroke);
      redraw();
    },
    lengthen(/** @type {Stroke} */ stroke) {
      line(stroke, stroke.rows.length - 1);
    },
  };
}

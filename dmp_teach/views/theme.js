// The light or dark of the page around a view, whatever program shows it.

/** @type {CanvasRenderingContext2D} */
let brush;

/**
 * Mark an element as dark for as long as its letters are light, as `tokens.css` reads it.
 * @param {HTMLElement} el
 * @param {AbortSignal} [signal]
 */
export function followTheme(el, signal) {
  const follow = () => el.toggleAttribute("data-dt-dark", isLight(getComputedStyle(el).color));
  const page = new MutationObserver(follow);
  for (const node of [document.documentElement, document.body])
    page.observe(node, { attributes: true });
  // Some programs put the element into the page later.
  const place = new ResizeObserver(follow);
  place.observe(el);
  signal?.addEventListener("abort", () => {
    page.disconnect();
    place.disconnect();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", follow, { signal });
}

/** @returns {"light" | "dark"} */
export const themeOf = (/** @type {HTMLElement} */ el) =>
  el.closest("[data-dt-dark]") ? "dark" : "light";

/** Whether a colour is light, in any notation that the browser knows. */
function isLight(/** @type {string} */ color) {
  brush ??= Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext(
    "2d",
    { willReadFrequently: true },
  );
  brush.clearRect(0, 0, 1, 1);
  brush.fillStyle = color;
  brush.fillRect(0, 0, 1, 1);
  const [red, green, blue] = brush.getImageData(0, 0, 1, 1).data;
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue > 127;
}

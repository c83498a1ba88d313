// Turning and zooming the picture by hand.

/** @typedef {import("./scene_3d.js").Picture} Picture */

/**
 * Turn the picture with a finger or the mouse; the wheel alone scrolls the notebook, with Ctrl it
 * comes nearer.
 * @param {HTMLElement} box
 * @param {Picture} picture
 */
export function letHandsTurn(box, picture) {
  /** @type {number | null} */
  let held = null;
  box.addEventListener("pointerdown", (event) => {
    held = event.pointerId;
    box.setPointerCapture(held);
  });
  box.addEventListener("pointermove", (event) => {
    if (event.pointerId !== held) return;
    picture.turn.yaw -= event.movementX * 0.006;
    picture.turn.pitch += event.movementY * 0.006;
    picture.look();
  });
  const release = () => {
    held = null;
  };
  box.addEventListener("pointerup", release);
  box.addEventListener("pointercancel", release);
  box.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      const zoom = picture.turn.zoom * Math.exp(event.deltaY * 0.002);
      picture.turn.zoom = Math.min(3, Math.max(0.3, zoom));
      picture.look();
    },
    { passive: false },
  );
}

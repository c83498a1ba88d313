// The picture in three dimensions: meshcat's viewer without its server, its clock and its panel.

import { gunzip } from "../gunzip.js";
import { t } from "../texts.js";
import { commandsOf, loadMeshcat } from "./meshcat.js";

/**
 * @typedef {{
 *   target: number[], eye: number[], up: number[], high: number, wide: number,
 *   pen_only?: boolean,
 * }} Camera
 */
/** @typedef {import("./meshcat.js").Bytes} Bytes */

/** @type {any} what all copies of this module on a page share */
const PAGE = globalThis;
PAGE.__dtScenesAwake ??= new Set();
/** @type {Set<Picture>} */
const AWAKE = PAGE.__dtScenesAwake;
// Browsers allow about 16 WebGL contexts on a page.
const MOST_AWAKE = 8;
const SKY = {
  light: { top: [0.965, 0.975, 0.992], bottom: [0.868, 0.896, 0.938] },
  dark: { top: [0.165, 0.196, 0.227], bottom: [0.078, 0.098, 0.118] },
};

/** z up, as the robot counts, to y up, as three.js does. */
const yUp = (/** @type {number[]} */ [x, y, z]) => [x, z, -y];

/** What is said where a browser cannot show a picture. */
export const noPicture = () =>
  t(
    "This browser cannot draw in three dimensions here. " +
      "The small page shows the letter; .png(path) makes a picture.",
  );

export class Picture {
  /** @param {HTMLElement} box its parent gets meshcat's panel for a moment */
  constructor(box) {
    this.box = box;
    this.time = 0;
    /** @type {Camera | null} */
    this.camera = null;
    this.turn = { yaw: 0, pitch: 0, zoom: 1 };
    /** @type {[string, any, any][]} */
    this.listeners = [];
    /** @type {any} meshcat's viewer, while it is awake */
    this.viewer = null;
    /** @type {number | null} the next frame, if it is to be drawn */
    this.waiting = null;
    this.drawn = false;
    this.seen = false;
    this.gone = false;
  }

  /**
   * Build the viewer, if it sleeps; another one that nobody sees goes to sleep for it.
   * @param {Bytes} code
   * @param {Bytes} robot
   * @param {Bytes} run
   * @param {"light" | "dark"} theme
   */
  async wake(code, robot, run, theme) {
    const loading = [loadMeshcat(code), gunzip(robot), gunzip(run)];
    const [MeshCat, ...bundles] = await Promise.all(loading);
    if (this.gone || this.viewer) return;
    const sleepy = [...AWAKE].find((other) => !other.seen);
    if (AWAKE.size >= MOST_AWAKE && sleepy) sleepy.sleep();
    this.THREE = MeshCat.THREE;
    const onload = window.onload;
    this.viewer = this.tracked(() => new MeshCat.Viewer(this.box, false));
    window.onload = onload;
    this.tame();
    AWAKE.add(this);
    this.sky(theme);
    for (const bundle of bundles) this.apply(bundle);
    this.resize();
    this.dress();
    this.look();
    this.seek(this.time);
    this.spare();
  }

  /**
   * Where a processor draws instead of a graphics card, shadows would halve the pictures a second.
   */
  spare() {
    const gl = this.viewer.renderer.getContext();
    const info = gl.getExtension("WEBGL_debug_renderer_info");
    const name = String(info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : "");
    const slow = /swiftshader|llvmpipe|software|basic render/i.test(name);
    const lamp = this.viewer.scene_tree.find(["Lights", "SpotLight", "<object>"]).object;
    lamp.castShadow = PAGE.dtShadows ?? !slow;
    lamp.shadow.normalBias = 0.01;
  }

  /**
   * Meshcat and its panel listen to the window for ever; note what they add, to take it away at the
   * end.
   */
  tracked(/** @type {() => any} */ build) {
    const add = window.addEventListener;
    const noted = (/** @type {[string, any, any]} */ ...args) => {
      this.listeners.push(args);
      add.apply(window, args);
    };
    window.addEventListener = noted;
    try {
      return build();
    } finally {
      window.addEventListener = add;
    }
  }

  tame() {
    const { viewer } = this;
    viewer.gui.domElement.remove();
    viewer.controls.dispose();
    viewer.controls = { update() {} };
    viewer.set_3d_pane_size = () => this.resize();
    viewer.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.box.style.touchAction = "pan-y";
    const canvas = viewer.renderer.domElement;
    canvas.setAttribute("aria-hidden", "true");
    canvas.addEventListener("webglcontextlost", (/** @type {Event} */ event) => {
      event.preventDefault();
      this.sleep();
    });
  }

  /**
   * Commands of a bundle, in their order; the last one is the animation, for which the ink must be
   * ready.
   */
  apply(/** @type {Uint8Array} */ bytes) {
    const commands = commandsOf(bytes);
    // This puts every joint back where it was before the last motion; now, not later.
    this.viewer.animator.clear();
    commands.forEach((command, i) => {
      if (i === commands.length - 1) this.readyInk();
      this.tracked(() => this.viewer.handle_command_bytearray(command));
    });
    const { animator } = this.viewer;
    for (const action of animator.actions) action.play();
    animator.playing = false;
  }

  /**
   * three.js animates no `geometry.drawRange`; under this second name, on the object itself, it
   * does.
   */
  readyInk() {
    const ink = this.ink();
    if (ink?.geometry) ink.drawRange = ink.geometry.drawRange;
  }

  ink() {
    return this.viewer?.scene_tree.find(["meshcat", "ink", "<object>"]).object;
  }

  /** Another motion in the same scene; what the camera sees stays. */
  async change(/** @type {Bytes} */ run) {
    const bytes = await gunzip(run);
    if (this.viewer) this.apply(bytes);
  }

  sky(/** @type {"light" | "dark"} */ theme) {
    const { top, bottom } = SKY[theme];
    this.viewer?.set_property(["Background"], "top_color", top);
    this.viewer?.set_property(["Background"], "bottom_color", bottom);
    this.draw();
  }

  seek(/** @type {number} */ time) {
    this.time = time;
    this.viewer?.animator.seek(time);
    this.draw();
  }

  /** How many triangles of ink are drawn. */
  inkTriangles() {
    const range = this.ink()?.geometry?.drawRange;
    const all = this.ink()?.geometry?.index?.count ?? 0;
    return range ? Math.floor(Math.min(range.count, all) / 3) : 0;
  }

  place(/** @type {Camera} */ camera) {
    this.camera = camera;
    this.turn = { yaw: 0, pitch: 0, zoom: 1 };
    this.dress();
    this.look();
  }

  /** Straight from above the arm would hide the letter: there the pen is seen alone. */
  dress() {
    const alone = Boolean(this.camera?.pen_only);
    const show = (/** @type {any} */ node, /** @type {boolean} */ isPen) => {
      if (node.isMesh) node.visible = isPen || !alone;
      for (const child of node.children) show(child, isPen || child.name.startsWith("pen_"));
    };
    const robot = this.viewer?.scene_tree.find(["meshcat", "robot"]).object;
    if (robot) show(robot, false);
  }

  /** Whether a hand has turned the picture since. */
  isTurned() {
    return this.turn.yaw !== 0 || this.turn.pitch !== 0 || this.turn.zoom !== 1;
  }

  /**
   * Put the camera where it belongs: turned by hand about the middle of the picture, never under
   * the floor.
   */
  look() {
    if (!this.viewer || !this.camera) return;
    const { THREE, camera, turn } = this;
    const vector = (/** @type {number[]} */ list) => new THREE.Vector3(...yUp(list));
    const target = vector(camera.target);
    const top = vector([0, 0, 1]);
    const back = vector(camera.eye).sub(target);
    const right = vector(camera.up).cross(back).normalize();
    const rise = Math.PI / 2 - back.angleTo(top);
    const pitch = Math.min(Math.max(rise + turn.pitch, 0.03), 1.54) - rise;
    turn.pitch = turn.pitch === 0 ? 0 : pitch;
    const up = vector(camera.up);
    for (const arm of [back, up])
      arm.applyAxisAngle(right, -turn.pitch).applyAxisAngle(top, turn.yaw);
    const eye = this.viewer.camera;
    eye.position.copy(target).addScaledVector(back, turn.zoom);
    eye.up.copy(up);
    eye.near = 0.03;
    eye.far = 30;
    const slope = Math.max(camera.high, camera.wide / eye.aspect);
    eye.fov = (Math.atan(slope) * 360) / Math.PI;
    eye.lookAt(target);
    eye.updateProjectionMatrix();
    this.draw();
  }

  resize() {
    if (!this.viewer) return;
    const { clientWidth: width, clientHeight: height } = this.box;
    if (!width || !height) return;
    this.viewer.camera.aspect = width / height;
    this.viewer.renderer.setSize(width, height);
    this.look();
  }

  draw() {
    if (!this.viewer || this.waiting) return;
    this.waiting = requestAnimationFrame(() => {
      this.waiting = null;
      this.viewer?.render();
      this.drawn = true;
    });
  }

  /** Whether the first picture is there, if there is to be one. */
  hasDrawn() {
    return this.drawn || !this.viewer;
  }

  /** Give the WebGL context back; `wake` builds the same picture again. */
  sleep() {
    AWAKE.delete(this);
    if (!this.viewer) return;
    const { viewer } = this;
    this.viewer = null;
    this.drawn = false;
    cancelAnimationFrame(this.waiting);
    this.waiting = null;
    for (const [type, listener, options] of this.listeners) {
      window.removeEventListener(type, listener, options);
    }
    this.listeners = [];
    viewer.animator.mixer.stopAllAction();
    viewer.scene_tree.dispose_recursive();
    viewer.renderer.dispose();
    viewer.renderer.forceContextLoss();
    viewer.renderer.domElement.remove();
  }

  leave() {
    this.gone = true;
    this.sleep();
  }
}

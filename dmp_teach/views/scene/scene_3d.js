// The picture in three dimensions: meshcat's viewer without its server, its clock and its panel.

const AWAKE = (globalThis.__dtScenesAwake ??= new Set());
const MOST_AWAKE = 8; // browsers allow about 16 WebGL contexts on a page
const SKY = {
  light: { top: [0.965, 0.975, 0.992], bottom: [0.868, 0.896, 0.938] },
  dark: { top: [0.165, 0.196, 0.227], bottom: [0.078, 0.098, 0.118] },
};

const bytesOf = (value) => new Uint8Array(value.buffer ?? value, value.byteOffset ?? 0, value.byteLength);

async function gunzip(value) {
  const stream = new Blob([bytesOf(value)]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Meshcat's viewer script, run once per page; neither its names nor a loader of the page's can meet. */
function loadMeshcat(value) {
  globalThis.__dtMeshcat ??= gunzip(value).then(
    (code) =>
      new Promise((resolve, reject) => {
        globalThis.__dtMeshcatExports = {};
        const parts = ["(function (exports, module, define) {", code, "\n})(globalThis.__dtMeshcatExports);"];
        const url = URL.createObjectURL(new Blob(parts, { type: "text/javascript" }));
        const done = (then) => () => (URL.revokeObjectURL(url), script.remove(), then());
        const script = Object.assign(document.createElement("script"), { src: url });
        script.onload = done(() => resolve(globalThis.__dtMeshcatExports.MeshCat));
        script.onerror = done(() => reject(new Error("meshcat's viewer script could not be run")));
        document.head.append(script);
      }),
  );
  return globalThis.__dtMeshcat;
}

/** The commands of a bundle: before each its length in 4 bytes. */
function commandsOf(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const commands = [];
  for (let at = 0; at < bytes.length; ) {
    const length = view.getUint32(at, true);
    commands.push(bytes.subarray(at + 4, at + 4 + length));
    at += 4 + length;
  }
  return commands;
}

/** z up, as the robot counts, to y up, as three.js does. */
const yUp = ([x, y, z]) => [x, z, -y];

class Picture {
  constructor(box) {
    this.box = box; // its parent gets meshcat's panel for a moment
    this.time = 0;
    this.camera = null;
    this.turn = { yaw: 0, pitch: 0, zoom: 1 };
    this.listeners = [];
    this.viewer = null;
  }

  /** Build the viewer, if it sleeps; another one that nobody sees goes to sleep for it. */
  async wake(code, robot, run, theme) {
    const [MeshCat, ...bundles] = await Promise.all([loadMeshcat(code), gunzip(robot), gunzip(run)]);
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
    bundles.forEach((bundle) => this.apply(bundle));
    this.resize();
    this.ghost();
    this.look();
    this.seek(this.time);
    this.spare();
  }

  /** Where a processor draws instead of a graphics card, shadows would halve the pictures a second. */
  spare() {
    const gl = this.viewer.renderer.getContext();
    const info = gl.getExtension("WEBGL_debug_renderer_info");
    const name = String(info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : "");
    const slow = /swiftshader|llvmpipe|software|basic render/i.test(name);
    const lamp = this.viewer.scene_tree.find(["Lights", "SpotLight", "<object>"]).object;
    lamp.castShadow = globalThis.dtShadows ?? !slow;
    lamp.shadow.normalBias = 0.01;
  }

  /** Meshcat and its panel listen to the window for ever; note what they add, to take it away at the end. */
  tracked(build) {
    const add = window.addEventListener;
    window.addEventListener = (...args) => (this.listeners.push(args), add.apply(window, args));
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
    canvas.addEventListener("webglcontextlost", (event) => (event.preventDefault(), this.sleep()));
  }

  /** Commands of a bundle, in their order; the last one is the animation, for which the ink must be ready. */
  apply(bytes) {
    const commands = commandsOf(bytes);
    this.viewer.animator.clear(); // puts every joint back where it was before the last motion; now, not later
    commands.forEach((command, i) => {
      if (i === commands.length - 1) this.readyInk();
      this.tracked(() => this.viewer.handle_command_bytearray(command));
    });
    const { animator } = this.viewer;
    animator.actions.forEach((action) => action.play());
    animator.playing = false;
  }

  /** three.js animates no `geometry.drawRange`; under this second name, on the object itself, it does. */
  readyInk() {
    const ink = this.ink();
    if (ink?.geometry) ink.drawRange = ink.geometry.drawRange;
  }

  ink() {
    return this.viewer?.scene_tree.find(["meshcat", "ink", "<object>"]).object;
  }

  /** Another motion in the same scene; what the camera sees stays. */
  async change(run) {
    const bytes = await gunzip(run);
    if (this.viewer) this.apply(bytes);
  }

  sky(theme) {
    const { top, bottom } = SKY[theme];
    this.viewer?.set_property(["Background"], "top_color", top);
    this.viewer?.set_property(["Background"], "bottom_color", bottom);
    this.draw();
  }

  seek(time) {
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

  place(camera) {
    this.camera = camera;
    this.turn = { yaw: 0, pitch: 0, zoom: 1 };
    this.ghost();
    this.look();
  }

  /** See through the arm, but not through the pen: straight above the page it would hide the letter. */
  ghost() {
    const through = (node, clear) => {
      const see = clear && !node.name.startsWith("pen_");
      const { material } = node;
      if (material && material.transparent !== see) {
        Object.assign(material, { transparent: see, opacity: see ? 0.12 : 1, depthWrite: !see, needsUpdate: true });
        node.castShadow = !see;
      }
      node.children.forEach((child) => through(child, see));
    };
    if (this.viewer) through(this.viewer.scene_tree.find(["meshcat", "robot"]).object, Boolean(this.camera?.see_through));
  }

  /** Whether a hand has turned the picture since. */
  isTurned() {
    return this.turn.yaw !== 0 || this.turn.pitch !== 0 || this.turn.zoom !== 1;
  }

  /** Put the camera where it belongs: turned by hand about the middle of the picture, never under the floor. */
  look() {
    if (!this.viewer || !this.camera) return;
    const { THREE, camera, turn } = this;
    const vector = (list) => new THREE.Vector3(...yUp(list));
    const target = vector(camera.target);
    const top = vector([0, 0, 1]);
    const back = vector(camera.eye).sub(target);
    const right = vector(camera.up).cross(back).normalize();
    const rise = Math.PI / 2 - back.angleTo(top);
    const pitch = Math.min(Math.max(rise + turn.pitch, 0.03), 1.54) - rise;
    turn.pitch = turn.pitch === 0 ? 0 : pitch;
    const up = vector(camera.up);
    for (const arm of [back, up]) arm.applyAxisAngle(right, -turn.pitch).applyAxisAngle(top, turn.yaw);
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
    });
  }

  /** Give the WebGL context back; `wake` builds the same picture again. */
  sleep() {
    AWAKE.delete(this);
    if (!this.viewer) return;
    const { viewer } = this;
    this.viewer = null;
    cancelAnimationFrame(this.waiting);
    this.waiting = null;
    this.listeners.forEach(([type, listener, options]) => window.removeEventListener(type, listener, options));
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

/** Turn the picture with a finger or the mouse; the wheel alone scrolls the notebook, with Ctrl it comes nearer. */
function letHandsTurn(box, picture) {
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
  const release = () => (held = null);
  box.addEventListener("pointerup", release);
  box.addEventListener("pointercancel", release);
  box.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      picture.turn.zoom = Math.min(3, Math.max(0.3, picture.turn.zoom * Math.exp(event.deltaY * 0.002)));
      picture.look();
    },
    { passive: false },
  );
}

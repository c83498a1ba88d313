// The view: the picture, what is written so far, and the controls under it.

import { hear, keepKeys, make, save } from "../dom.js";
import { useTexts } from "../texts.js";
import { themeOf } from "../theme.js";
import { told } from "../told.js";
import { choices } from "./choices.js";
import { ForceStrip } from "./force.js";
import { noPicture, Picture } from "./scene_3d.js";
import { SmallPage } from "./small_page.js";
import { TimeBar } from "./time_bar.js";
import { letHandsTurn } from "./turning.js";

/** @typedef {import("../dom.js").Model} Model */

const EPSILON = 1e-6;
class View {
  constructor(/** @type {Model} */ model, /** @type {HTMLElement} */ host) {
    this.model = model;
    this.host = host;
    this.still = window.matchMedia("(prefers-reduced-motion: reduce)");
    this.time = Math.min(model.get("time"), this.facts.duration);
    this.playing = false;
    /** @type {number | null} when the last frame was [ms] */
    this.before = null;
    this.frame = 0;
    this.root = this.build();
    host.append(this.root);
    this.picture = new Picture(this.box);
    letHandsTurn(this.box, this.picture);
    this.listen();
    this.load();
    this.aim();
    this.shape();
    this.speeds.show(model.get("speed"));
    this.face();
    this.show(this.time);
    this.observe();
  }

  build() {
    const { model } = this;
    const { cameras, sights, speeds } = choices(model);
    this.cameras = cameras;
    this.sights = sights;
    this.speeds = speeds;
    this.page = new SmallPage();
    this.box = make("div", { class: "dts-box" });
    this.says = make("p", { class: "dts-says", hidden: true });
    const inside = [this.box, this.page.node, this.says];
    this.stage = make("div", { class: "dts-picture", role: "img" }, ...inside);
    this.bar = new TimeBar({
      onPlay: () => this.press(),
      onTime: (time) => {
        this.stop();
        this.show(time);
      },
      onDone: () => save(model, { time: this.time }),
    });
    this.strip = new ForceStrip(this.bar.slider);
    this.notes = make("p", { class: "dts-notes" });
    const [[cameraBar, cameraList], [seenBar, seenList]] = [this.cameras, this.sights];
    const under = [this.bar.node, cameraList.node, seenList.node];
    return keepKeys(
      make(
        "div",
        { class: "dt-scene" },
        make("div", { class: "dts-head" }, cameraBar.node, seenBar.node),
        this.stage,
        make("div", { class: "dts-under" }, ...under),
        this.strip.node,
        make("div", { class: "dts-foot" }, this.notes, this.speeds.node),
      ),
    );
  }

  listen() {
    const { model } = this;
    hear(model, {
      motion_id: () => this.fresh(),
      camera: () => this.aim(),
      seen: () => this.swap(),
      compact: () => this.shape(),
      speed: () => this.speeds.show(model.get("speed")),
      time: () => {
        const isElsewhere = Math.abs(model.get("time") - this.time) > EPSILON;
        if (!this.playing && isElsewhere) this.show(model.get("time"));
      },
      playing: () => {
        if (model.get("playing") === this.playing) return;
        if (this.playing) this.finish();
        else this.start();
      },
    });
  }

  /**
   * Watch whether anybody sees the picture, its size, the theme, and who asks for less movement.
   */
  observe() {
    const { picture } = this;
    const seen = new IntersectionObserver(([entry]) => {
      picture.seen = entry.isIntersecting;
      if (picture.seen) this.wakeAndPlay();
      else if (this.playing) this.pause();
    });
    const size = new ResizeObserver(() => {
      picture.resize();
      this.strip.draw();
    });
    const light = new MutationObserver(() => picture.sky(themeOf(this.host)));
    seen.observe(this.stage);
    size.observe(this.box);
    light.observe(this.host, { attributes: true, attributeFilter: ["data-dt-dark"] });
    const face = () => this.face();
    this.still.addEventListener("change", face);
    this.unwatch = () => {
      for (const observer of [seen, size, light]) observer.disconnect();
      this.still.removeEventListener("change", face);
    };
  }

  leave() {
    cancelAnimationFrame(this.frame);
    this.unwatch();
    this.picture.leave();
    this.root.remove();
  }

  get isPlan() {
    return this.model.get("seen") === "as planned" && this.model.get("planned_facts").duration > 0;
  }

  /** @returns {import("./force.js").Facts} */
  get facts() {
    return this.model.get(this.isPlan ? "planned_facts" : "facts");
  }

  get run() {
    return this.model.get(this.isPlan ? "planned_run" : "run");
  }

  get isAtEnd() {
    return this.time >= this.facts.duration - EPSILON;
  }

  show(/** @type {number} */ wanted) {
    const { duration } = this.facts;
    this.time = Math.min(Math.max(wanted, 0), duration);
    this.picture.seek(this.time);
    this.bar.show(this.time, duration);
    this.page.show(this.time);
    this.strip.show(this.time);
    this.root.dataset.dtTime = this.time.toFixed(3);
    this.tell();
  }

  tell() {
    const state = this.playing ? "playing" : "ready";
    this.root.dataset.dtState = this.facts.duration ? state : "empty";
    this.root.dataset.dtAwake = String(Boolean(this.picture.viewer));
    this.root.dataset.dtInk = String(this.picture.inkTriangles());
  }

  face() {
    if (this.still.matches) this.bar.face("next");
    else this.bar.face(this.playing ? "pause" : "play");
  }

  load() {
    const { facts, model } = this;
    this.page.load(facts);
    this.strip.load(facts);
    this.stage.setAttribute("aria-label", facts.label);
    this.notes.textContent = facts.notes;
    this.bar.enable(facts.duration > 0);
    this.root.classList.toggle("dts-empty", !facts.duration);
    for (const { node, show } of this.sights) {
      node.hidden = !model.get("planned_facts").duration;
      show(model.get("seen"));
    }
  }

  aim() {
    const name = this.model.get("camera");
    for (const { show } of this.cameras) show(name);
    this.picture.place(this.facts.cameras[name]);
    this.page.node.classList.toggle("dts-away", name === "page from above");
  }

  shape() {
    this.root.classList.toggle("dts-compact", this.model.get("compact"));
  }

  async wake() {
    const { model, picture } = this;
    if (picture.viewer || picture.gone) return;
    try {
      await picture.wake(model.get("viewer"), model.get("robot"), this.run, themeOf(this.host));
      this.show(this.time);
    } catch (error) {
      console.warn(error);
      this.says.textContent = noPicture();
      this.says.hidden = false;
      this.root.classList.add("dts-flat");
      this.root.dataset.dtState = "flat";
    }
  }

  async wakeAndPlay() {
    await this.wake();
    if (this.model.get("playing")) this.start();
  }

  /** Show another motion. */
  async fresh() {
    const { model, picture } = this;
    this.load();
    await picture.change(this.run);
    // Each letter from where its own arm hides it least, but a hand's choice stays.
    if (!picture.isTurned()) this.aim();
    this.show(model.get("playing") ? 0 : model.get("time"));
    if (model.get("playing") && picture.seen) this.start();
  }

  /** Show the same moment of the same letter: camera and time stay. */
  async swap() {
    this.load();
    this.show(this.time);
    await this.picture.change(this.run);
    this.show(this.time);
  }

  start() {
    if (this.still.matches) {
      this.show(this.facts.duration);
      save(this.model, { playing: false, time: this.time });
    } else if (!this.playing && this.facts.duration) {
      this.playing = true;
      this.before = null;
      if (this.isAtEnd) this.time = 0;
      this.frame = requestAnimationFrame((now) => this.tick(now));
      this.face();
      this.tell();
    }
  }

  tick(/** @type {number} */ now) {
    this.frame = requestAnimationFrame((next) => this.tick(next));
    const passed = this.before === null ? 0 : (now - this.before) / 1000;
    // The first picture takes long, and a hidden page draws none: neither counts.
    this.before = this.picture.hasDrawn() && !document.hidden ? now : null;
    this.show(this.time + passed * this.model.get("speed"));
    this.model.set("time", this.time);
    if (this.time >= this.facts.duration) this.finish();
  }

  /** A picture that nobody sees waits, and goes on when it is seen again. */
  pause() {
    cancelAnimationFrame(this.frame);
    this.playing = false;
    this.face();
    this.tell();
  }

  finish() {
    this.pause();
    save(this.model, { playing: false, time: this.time });
  }

  stop() {
    if (this.playing || this.model.get("playing")) this.finish();
  }

  press() {
    if (this.still.matches) {
      this.show(this.nextStill());
      save(this.model, { time: this.time });
    } else if (this.playing) this.finish();
    else {
      this.start();
      save(this.model, { playing: true });
    }
  }

  /** The end of the next third, for people who ask for less movement. */
  nextStill() {
    const third = this.facts.duration / 3;
    return this.isAtEnd ? third : third * (Math.floor(this.time / third + EPSILON) + 1);
  }
}

/** @param {import("../dom.js").Widget} widget */
export function renderScene({ model, el }) {
  useTexts(model.get("texts"));
  const view = new View(model, el);
  return () => view.leave();
}

export default told(renderScene);

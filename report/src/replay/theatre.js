// The picture: one canvas with a scene or two in step, seen by one camera that turns around each product.

import { PerspectiveCamera, Vector3, WebGLRenderer } from "three";
import { h } from "../dom.js";
import { colours, isDark, onTheme } from "../theme.js";
import { Orbit } from "./orbit.js";
import { Stage } from "./stage.js";

const FIELD_OF_VIEW = 28;
/** So many extents of the product fit into the height of a scene. */
const SHOWN_EXTENTS = 3.2;
/** Of the product's rise the camera follows so much: what is lifted is seen to rise. */
const FOLLOW_UP = 0.62;
const SLOW_FRAME_MS = 30;

export function hasWebGL() {
  try {
    return document.createElement("canvas").getContext("webgl2") !== null;
  } catch {
    return false;
  }
}

export class Theatre {
  constructor(clock, look) {
    this.clock = clock;
    this.look = look;
    this.stages = [];
    this.canvas = h("canvas", { class: "scene", tabindex: "0", role: "img" });
    this.names = h("div", { class: "scene-names", "aria-hidden": "true" });
    this.element = h("div", { class: "theatre" }, this.canvas, this.names);
    this.orbit = new Orbit(this.canvas, () => this.ask());
    this.camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 10);
    this.camera.up.set(0, 0, 1);
    this.seen = true;
    this.ratio = Math.min(2, window.devicePixelRatio || 1);
    this.drawTimes = [];
    clock.on(() => this.ask());
    onTheme(() => this.rebuild());
    new ResizeObserver(() => this.ask()).observe(this.element);
    new IntersectionObserver(([entry]) => { this.seen = entry.isIntersecting; this.ask(); }).observe(this.element);
    window.addEventListener("beforeprint", () => this.draw());
  }

  show(models) {
    this.models = models;
    this.names.replaceChildren(...models.map((model) => h("span", {}, h("i", { class: "swatch", style: `background:var(--${model.outcome.replaceAll("_", "-")})` }), model.title)));
    this.element.classList.toggle("two", models.length > 1);
    this.rebuild();
  }

  rebuild() {
    if (!this.models) return;
    for (const stage of this.stages) stage.dispose();
    const theme = { ...colours(), dark: isDark() };
    this.stages = this.models.map((model) => new Stage(model, theme));
    this.strongest = Math.max(...this.stages.map((stage) => stage.strongest));
    this.ask();
  }

  /** Draws before the next picture of the browser, once. */
  ask() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      if (this.seen) this.draw();
    });
  }

  start() {
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: true, preserveDrawingBuffer: true, powerPreference: "low-power" });
    this.renderer.autoClear = false;
  }

  draw() {
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    if (!this.stages.length || !width) return;
    if (!this.renderer) this.start();
    const begin = performance.now();
    const { renderer } = this;
    renderer.setPixelRatio(this.ratio);
    renderer.setSize(width, height, false);
    renderer.setScissorTest(true);
    const upright = height > width;
    const count = this.stages.length;
    this.stages.forEach((stage, i) => {
      stage.update(Math.min(this.clock.time, stage.model.end), { ...this.look, strongest: this.strongest });
      const [w, t] = upright ? [width, Math.floor(height / count)] : [Math.floor(width / count), height];
      const [x, y] = upright ? [0, height - (i + 1) * t] : [i * w, 0];
      renderer.setViewport(x, y, w, t);
      renderer.setScissor(x, y, w, t);
      this.point(stage, w / t);
      renderer.clear();
      renderer.render(stage.scene, this.camera);
    });
    this.measure(performance.now() - begin);
    this.canvas.dataset.frames = String(Number(this.canvas.dataset.frames ?? 0) + 1);
  }

  point(stage, aspect) {
    const { model, centre } = stage;
    const { camera } = this;
    const start = model.product_m[2];
    const target = new Vector3(centre.x, centre.y, start + FOLLOW_UP * (centre.z - start) + 0.3 * model.extent * (model.pads.length ? 1 : 0));
    const half = Math.tan((FIELD_OF_VIEW / 360) * Math.PI);
    const distance = (0.5 * SHOWN_EXTENTS * model.extent) / (half * Math.min(1, aspect * 1.05));
    camera.aspect = aspect;
    camera.near = 0.02 * model.extent;
    camera.far = 60 * model.extent;
    camera.position.copy(target).add(new Vector3(...this.orbit.offset(distance)));
    camera.lookAt(target);
    camera.updateProjectionMatrix();
  }

  /** A machine that draws slowly gets fewer points. */
  measure(milliseconds) {
    this.drawTimes.push(milliseconds);
    if (this.drawTimes.length < 12) return;
    const middle = [...this.drawTimes].sort((a, b) => a - b)[6];
    this.drawTimes = [];
    this.milliseconds = middle;
    if (middle > SLOW_FRAME_MS && this.ratio > 0.6) this.ratio = Math.max(0.6, 0.75 * this.ratio);
  }

  describe(text) {
    this.canvas.setAttribute("aria-label", text);
  }
}

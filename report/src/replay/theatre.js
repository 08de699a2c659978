// The picture: one canvas with a scene or two in step, seen by one camera that turns around each product.

import { PerspectiveCamera, Vector3, WebGLRenderer } from "three";
import { h } from "../dom.js";
import { colours, isDark, onTheme } from "../theme.js";
import { outcomeLabel } from "../words.js";
import { Orbit } from "./orbit.js";
import { Stage } from "./stage.js";

const FIELD_OF_VIEW = 28;
/** So many extents of the product fit into the height of a scene. */
const SHOWN_EXTENTS = 3.2;
/** Of the product's rise the camera follows so much: what is lifted is seen to rise. */
const FOLLOW_UP = 0.62;
/** Pictures further apart than this are coarser while they move; the still one is sharp again. */
const SLOW_FRAME_MS = 34;
const [COARSEST, COARSER] = [0.6, 0.8];
const REST_MS = 220;

/** "yes", "by the processor" (slowly), or null. */
function webGL() {
  try {
    const context = document.createElement("canvas").getContext("webgl2");
    if (!context) return null;
    const names = context.getExtension("WEBGL_debug_renderer_info");
    const name = names ? context.getParameter(names.UNMASKED_RENDERER_WEBGL) : "";
    context.getExtension("WEBGL_lose_context")?.loseContext();
    return /swiftshader|llvmpipe|software|basic render/i.test(name) ? "by the processor" : "yes";
  } catch {
    return null;
  }
}

const drawing = webGL();

export function hasWebGL() {
  return drawing !== null;
}

/** The phases of the cycle, as one sees them. */
const SEEN = { approach: "the gripper comes", grip: "gripped", lift: "lifted", hold: "held up", transfer: "carried", lower: "put down", release: "let go", recover: "placed", stop: "stopped", turn: "turned" };

/** What happens in a scene now, in a word or two. */
function statusOf(model, time) {
  const decided = model.events.find(({ kind }) => kind === "decided");
  if (decided && time >= decided.time_s) return `▲ ${outcomeLabel(model.outcome)}`;
  const phase = model.phases.find(({ from, to }) => time >= from && time <= to)?.name ?? "";
  return SEEN[phase] ?? phase;
}

export class Theatre {
  /** @param kind "scene", or "preview": smaller, and not to be turned @param withArm is there an arm in any scene? */
  constructor(clock, look, kind = "scene", withArm = false) {
    this.clock = clock;
    this.look = look;
    this.stages = [];
    this.canvas = h("canvas", { class: kind, tabindex: kind === "scene" ? "0" : null, role: "img" });
    this.names = h("div", { class: "scene-names", "aria-hidden": "true" });
    this.element = h("div", { class: "theatre" }, this.canvas, this.names);
    this.orbit = new Orbit(kind === "scene" ? this.canvas : null, () => this.ask(), withArm);
    this.camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 10);
    this.camera.up.set(0, 0, 1);
    this.seen = true;
    // A processor that draws smooths no edges; its still pictures have twice the points instead.
    this.coarsest = kind === "scene" ? COARSEST : COARSER;
    this.sharp = drawing === "yes" ? Math.min(2, window.devicePixelRatio || 1) : 2;
    this.ratio = Math.min(this.sharp, drawing === "yes" ? 2 : 1);
    this.intervals = [];
    clock.on(() => this.ask());
    clock.onSeldom(() => this.tellStatus());
    onTheme(() => this.rebuild());
    new ResizeObserver(() => this.ask()).observe(this.element);
    new IntersectionObserver(([entry]) => { this.seen = entry.isIntersecting; this.ask(); }).observe(this.element);
    window.addEventListener("beforeprint", () => this.draw(this.sharp));
  }

  show(models) {
    this.models = models;
    this.names.replaceChildren(...models.map((model) => h("span", { style: `--told:var(--${model.outcome.replaceAll("_", "-")})` }, h("b", {}, h("i", { class: "swatch", style: "background:var(--told)" }), model.title), model.caption ? h("small", {}, model.caption) : null, h("em", {}))));
    this.tellStatus();
    this.element.classList.toggle("two", models.length > 1);
    this.rebuild();
  }

  /** At the foot of each scene what happens in it; what is lost or damaged has a frame from then on. */
  tellStatus() {
    (this.models ?? []).forEach((model, i) => {
      const name = this.names.children[i];
      const text = statusOf(model, this.clock.time);
      if (name.lastChild.textContent === text) return;
      name.lastChild.textContent = text;
      name.classList.toggle("lost", text.startsWith("▲"));
    });
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

  /** Some time after the last movement one sharp picture. */
  restSoon() {
    clearTimeout(this.resting);
    if (this.ratio >= this.sharp) this.canvas.dataset.rest = "yes";
    else {
      delete this.canvas.dataset.rest;
      if (this.clock.playing) return;
      this.resting = setTimeout(() => {
        this.draw(this.sharp);
        this.canvas.dataset.rest = "yes";
      }, REST_MS);
    }
  }

  start() {
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: drawing === "yes", preserveDrawingBuffer: true, powerPreference: "low-power" });
    this.renderer.autoClear = false;
  }

  /** A drawing buffer is made anew only for another size: that costs more than the picture. */
  fit(width, height, ratio) {
    const { renderer } = this;
    if (this.size?.width === width && this.size.height === height && this.size.ratio === ratio) return;
    this.size = { width, height, ratio };
    renderer.setPixelRatio(ratio);
    renderer.setSize(width, height, false);
    renderer.setScissorTest(true);
  }

  draw(ratio = this.ratio) {
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    if (!this.stages.length || !width) return;
    if (!this.renderer) this.start();
    const { renderer } = this;
    this.fit(width, height, ratio);
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
    if (ratio === this.ratio) {
      this.measure(performance.now());
      this.restSoon();
    }
    this.canvas.dataset.frames = String(Number(this.canvas.dataset.frames ?? 0) + 1);
  }

  point(stage, aspect) {
    const { model, centre } = stage;
    const { camera } = this;
    const start = model.product_m[2];
    const room = this.orbit.wide ? model.armRoom : null;
    const extent = room ? (2.2 * room.radius) / SHOWN_EXTENTS : model.extent;
    const target = room ? new Vector3(...room.middle) : new Vector3(centre.x, centre.y, start + FOLLOW_UP * (centre.z - start) + 0.3 * model.extent * (model.pads.length ? 1 : 0));
    const half = Math.tan((FIELD_OF_VIEW / 360) * Math.PI);
    const distance = (0.5 * SHOWN_EXTENTS * extent) / (half * Math.min(1, aspect * 1.05));
    camera.aspect = aspect;
    camera.near = 0.02 * extent;
    camera.far = 60 * Math.max(extent, model.extent);
    camera.position.copy(target).add(new Vector3(...this.orbit.offset(distance)));
    camera.lookAt(target);
    camera.updateProjectionMatrix();
  }

  /** A machine that draws slowly gets fewer points while it plays. */
  measure(now) {
    const passed = now - (this.drawnAt ?? now);
    this.drawnAt = now;
    if (!this.clock.playing || passed > 1000) return;
    this.intervals.push(passed);
    if (this.intervals.length < 8) return;
    const middle = [...this.intervals].sort((a, b) => a - b)[4];
    this.intervals = [];
    if (middle > SLOW_FRAME_MS) this.ratio = Math.max(this.coarsest, COARSER * this.ratio);
  }

  describe(text) {
    this.canvas.setAttribute("aria-label", text);
  }
}

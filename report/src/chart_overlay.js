// What lies over a chart without it being drawn anew: the scenario that is lit, and the range that is being brushed.

import { svg } from "./dom.js";

/** Nearer than this a press is a click, not a brush. */
const BRUSH_LEAST_PX = 6;

function ring([x, y], kind) {
  return svg("circle", { cx: x, cy: y, r: kind === "lit" ? 8 : 6.5, class: kind });
}

function path(points, kind) {
  return svg("polyline", { points: points.map((point) => point.join(",")).join(" "), class: kind });
}

/** A layer over `canvas`, which ECharts has already filled. */
export function overlay(canvas) {
  const layer = svg("svg", { class: "over", "aria-hidden": "true" });
  canvas.append(layer);
  return layer;
}

/** Rings and lines of the scenarios that are lit or marked. @param litAt (row) => [{ at: [x, y] } or { path: [[x, y], ...] }] */
export function showLit(layer, selection, litAt) {
  const of = (row, kind) => litAt(row).filter((shape) => (shape.at ?? shape.path.flat()).every(Number.isFinite)).map((shape) => (shape.at ? ring(shape.at, kind) : path(shape.path, kind)));
  const marked = [...selection.marked].flatMap((row) => of(row, "marked"));
  const lit = selection.lit === null ? [] : of(selection.lit, "lit");
  layer.querySelectorAll(".lit, .marked").forEach((each) => each.remove());
  layer.append(...marked, ...lit);
}

/**
 * A drag over the chart.
 * @param inside (x, y) => does a brush begin here?
 * @param shape (from, to) => the rectangle { x, y, width, height } to show
 * @param done (from, to) => called at the end; of a press that was no drag, with to = null
 * @param touch may a finger brush too? The style sheet then has to leave the drags to the page
 */
export function brushing(canvas, layer, { inside, shape, done, touch = false }) {
  let from = null;
  const at = (event) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const frame = svg("rect", { class: "brush", visibility: "hidden" });
  layer.append(frame);
  const far = (to) => Math.hypot(to[0] - from[0], to[1] - from[1]) > BRUSH_LEAST_PX;
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || event.shiftKey || event.ctrlKey || (event.pointerType === "touch" && !touch) || !inside(...at(event))) return;
    from = at(event);
  });
  window.addEventListener("pointermove", (event) => {
    if (!from) return;
    const to = at(event);
    if (!far(to)) return;
    for (const [name, value] of Object.entries(shape(from, to))) frame.setAttribute(name, String(value));
    frame.setAttribute("visibility", "visible");
  });
  const end = (event) => {
    if (!from) return;
    const to = at(event);
    frame.setAttribute("visibility", "hidden");
    const brushed = event.type === "pointerup";
    const start = from;
    const drag = far(to);
    from = null;
    if (brushed) done(start, drag ? to : null);
  };
  window.addEventListener("pointerup", end);
  window.addEventListener("pointercancel", end);
}

/** A rectangle between two corners. */
export function rectangle([x0, y0], [x1, y1]) {
  return { x: Math.min(x0, x1), y: Math.min(y0, y1), width: Math.abs(x1 - x0), height: Math.abs(y1 - y0) };
}

// The picture of a metric over two inputs that grids and searches share: lines of equal value, edges of constraints, axes, the best.

import { h } from "./dom.js";
import { colourAt, gradient } from "./replay/colour_map.js";
import { roundValues } from "./scale.js";
import { label, number, percent } from "./words.js";

const LINES = 6;
const MARGIN = { left: 62, right: 16, top: 30, bottom: 46 };
export const HEIGHT = 380;

export function rgb(part) {
  return `rgb(${colourAt(part).map((each) => Math.round(255 * each)).join(",")})`;
}

/** From parts of the axes to points of the picture. */
export function layoutOf(width) {
  const [w, t] = [width - MARGIN.left - MARGIN.right, HEIGHT - MARGIN.top - MARGIN.bottom];
  return { x: (part) => MARGIN.left + part * w, y: (part) => MARGIN.top + (1 - part) * t };
}

function lineChildren(pieces, layout, style) {
  return pieces.map(([[x1, y1], [x2, y2]]) => ({ type: "line", shape: { x1: layout.x(x1), y1: layout.y(y1), x2: layout.x(x2), y2: layout.y(y2) }, style }));
}

/** Lines of equal value, each with its number once. */
function isolines(theme, { range, text, pieces }, layout) {
  return roundValues(range[0], range[1], LINES).flatMap((level) => {
    const found = pieces(level);
    if (!found.length) return [];
    const [[x, y]] = found[Math.floor(found.length / 2)];
    const said = { type: "text", style: { text: text(level), x: layout.x(x), y: layout.y(y), align: "center", verticalAlign: "middle", fill: "#20242a", stroke: "#ffffff", lineWidth: 3, font: `11px ${theme.font}` } };
    return [...lineChildren(found, layout, { stroke: "#ffffff", lineWidth: 2.2, opacity: 0.7 }), ...lineChildren(found, layout, { stroke: "#20242a", lineWidth: 0.8 }), said];
  });
}

function edgeChildren(pieces, layout) {
  return [...lineChildren(pieces, layout, { stroke: "#ffffff", lineWidth: 6 }), ...lineChildren(pieces, layout, { stroke: "#b3401a", lineWidth: 3, lineDash: [7, 3] })];
}

function tickTexts(theme, scale, place) {
  let last = -Infinity;
  return scale.ticks.flatMap(([part, text]) => {
    const style = { text, fill: theme.soft, font: `12px ${theme.font}`, ...place(part) };
    const at = style.align === "right" ? -style.y : style.x;
    if (at - last < (style.align === "right" ? 16 : 8 * text.length + 8)) return [];
    last = at;
    return [{ type: "text", style }];
  });
}

function ring([x, y], layout) {
  const circle = (style) => ({ type: "circle", shape: { cx: layout.x(x), cy: layout.y(y), r: 7 }, style: { fill: "none", ...style } });
  return [circle({ stroke: "#ffffff", lineWidth: 5 }), circle({ stroke: "#20242a", lineWidth: 2.4 })];
}

/**
 * Everything above the surface.
 * @param state { xScale, yScale, range, text (value), pieces (level) => of its line, edges: pieces of the constraints' edges }
 * @param best its place in parts of the axes, or null
 */
export function frame(theme, state, layout, best) {
  const { xScale, yScale } = state;
  const titleOf = (scale) => `${label(scale.column.name)}${scale.unit ? ` (${scale.unit})` : ""}`;
  const title = (text, style) => ({ type: "text", style: { text, fill: theme.ink, font: `13px ${theme.font}`, ...style } });
  return {
    type: "custom", coordinateSystem: "none", silent: true, z: 5, data: [[0]],
    renderItem: () => ({
      type: "group",
      children: [
        { type: "rect", shape: { x: layout.x(0), y: layout.y(1), width: layout.x(1) - layout.x(0), height: layout.y(0) - layout.y(1) }, style: { fill: "none", stroke: theme.line, lineWidth: 1 } },
        ...isolines(theme, state, layout), ...edgeChildren(state.edges, layout), ...(best ? ring(best, layout) : []),
        ...tickTexts(theme, xScale, (part) => ({ x: layout.x(part), y: layout.y(0) + 7, align: "center", verticalAlign: "top" })),
        ...tickTexts(theme, yScale, (part) => ({ x: layout.x(0) - 7, y: layout.y(part), align: "right", verticalAlign: "middle" })),
        title(titleOf(xScale), { x: layout.x(0.5), y: layout.y(0) + 26, align: "center", verticalAlign: "top" }),
        title(titleOf(yScale), { x: 0, y: 4, align: "left", verticalAlign: "top" }),
      ],
    }),
  };
}

/** The number of a level as it stands in the picture. */
export function levelText(metric, { factor }) {
  return metric.isShare ? percent : (value) => number(value / factor, 3);
}

/** @param edge what the dashed line means; null: there is none. @param beyond the largest values are no longer told apart */
export function surfaceLegend(metric, { range, scale, text }, edge, beyond = false) {
  const end = (value) => `${text(value)}${scale.unit && !metric.isShare ? ` ${scale.unit}` : ""}`;
  const stroke = edge ? h("span", { class: "edge-entry" }, h("i", { class: "stroke dashed", style: "color:var(--bad)" }), edge) : null;
  return h("div", { class: "field-legend" }, h("span", {}, metric.label), h("span", { class: "legend-end" }, end(range[0])), h("i", { class: "gradient", style: `background:${gradient()}` }), h("span", { class: "legend-end" }, `${end(range[1])}${beyond ? " and more" : ""}`), stroke);
}

/** What the edges of a metric's own constraints are called. */
export function boundWords(bounds, { scale, text }) {
  return `edge of a constraint: ${bounds.map(({ bound, least }) => `${least ? "at least" : "at most"} ${text(bound)}${scale.unit ? ` ${scale.unit}` : ""}`).join(", ")}`;
}

// A metric over two inputs of a grid, through the best scenario: cells from pale to dark, lines of equal value, the edge of each constraint.

import { figure } from "./chart.js";
import { contour } from "./contour.js";
import { h, select } from "./dom.js";
import { colourAt, gradient } from "./replay/colour_map.js";
import { boundsOf, roundValues, scaleOf } from "./scale.js";
import { scenarioTip, tipLine } from "./scenario.js";
import { extent } from "./statistics.js";
import { label, number, quantity, scaleFor } from "./words.js";

const LINES = 6;
const MARGIN = { left: 62, right: 16, top: 30, bottom: 46 };

function rgb(part) {
  return `rgb(${colourAt(part).map((each) => Math.round(255 * each)).join(",")})`;
}

/** The grid of a metric over x and y, the other inputs as in the best: { rows, values } by [j][i]. */
function gridOf(study, { inputs, best }, metric, x, y) {
  const others = inputs.filter((each) => each !== x && each !== y);
  const [xIndex, yIndex] = [x, y].map((column) => new Map(column.distinct.map((value, i) => [value, i])));
  const rows = y.distinct.map(() => new Array(x.distinct.length).fill(null));
  for (let row = 0; row < study.scenarios.rows; row += 1) {
    if (others.every((each) => each.at(row) === each.at(best))) rows[yIndex.get(y.at(row))][xIndex.get(x.at(row))] = row;
  }
  return { rows, values: rows.map((line) => line.map((row) => (row === null ? null : metric.column.at(row)))) };
}

function layoutOf(width, height) {
  const [w, t] = [width - MARGIN.left - MARGIN.right, height - MARGIN.top - MARGIN.bottom];
  return { x: (part) => MARGIN.left + part * w, y: (part) => MARGIN.top + (1 - part) * t };
}

/** Half way to the neighbours, or to the end of the axis. */
function borders(parts) {
  return parts.map((part, i) => [i ? (parts[i - 1] + part) / 2 : Math.max(0, part - (parts[1] - part) / 2), i + 1 < parts.length ? (part + parts[i + 1]) / 2 : Math.min(1, part + (part - parts[i - 1]) / 2)]);
}

function cellSeries(study, { xs, ys, grid, range }, layout) {
  const data = grid.rows.flatMap((line, j) => line.map((row, i) => [i, j, row])).filter(([i, j]) => grid.values[j][i] !== null);
  const [xBorders, yBorders] = [borders(xs), borders(ys)];
  return {
    type: "custom", coordinateSystem: "none", progressive: 0, data,
    renderItem: (params, api) => {
      const [i, j] = [api.value(0), api.value(1)];
      const [x0, x1] = xBorders[i].map(layout.x);
      const [y1, y0] = yBorders[j].map(layout.y);
      const part = (grid.values[j][i] - range[0]) / (range[1] - range[0] || 1);
      return { type: "rect", shape: { x: x0, y: y0, width: x1 - x0 + 0.5, height: y1 - y0 + 0.5 }, style: { fill: rgb(part), opacity: study.selection.has(api.value(2)) ? 1 : 0.15 } };
    },
  };
}

function lineChildren(pieces, layout, style) {
  return pieces.map(([[x1, y1], [x2, y2]]) => ({ type: "line", shape: { x1: layout.x(x1), y1: layout.y(y1), x2: layout.x(x2), y2: layout.y(y2) }, style }));
}

/** Lines of equal value, each with its number once. */
function isolines(theme, { xs, ys, grid, range, scale }, layout) {
  return roundValues(range[0], range[1], LINES).flatMap((level) => {
    const pieces = contour(xs, ys, grid.values, level);
    if (!pieces.length) return [];
    const [[x, y]] = pieces[Math.floor(pieces.length / 2)];
    const text = { type: "text", style: { text: number(level / scale.factor, 3), x: layout.x(x), y: layout.y(y), align: "center", verticalAlign: "middle", fill: "#20242a", stroke: "#ffffff", lineWidth: 3, font: `11px ${theme.font}` } };
    return [...lineChildren(pieces, layout, { stroke: "#ffffff", lineWidth: 2.2, opacity: 0.7 }), ...lineChildren(pieces, layout, { stroke: "#20242a", lineWidth: 0.8 }), text];
  });
}

function edges(theme, { xs, ys, grid, bounds }, layout) {
  return bounds.flatMap(({ bound }) => {
    const pieces = contour(xs, ys, grid.values, bound);
    return [...lineChildren(pieces, layout, { stroke: "#ffffff", lineWidth: 6 }), ...lineChildren(pieces, layout, { stroke: "#b3401a", lineWidth: 3, lineDash: [7, 3] })];
  });
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

function frame(theme, state, layout, best) {
  const { xScale, yScale } = state;
  const titleOf = (scale) => `${label(scale.column.name)}${scale.unit ? ` (${scale.unit})` : ""}`;
  const title = (text, style) => ({ type: "text", style: { text, fill: theme.ink, font: `13px ${theme.font}`, ...style } });
  return {
    type: "custom", coordinateSystem: "none", silent: true, z: 5, data: [[0]],
    renderItem: () => ({
      type: "group",
      children: [
        ...isolines(theme, state, layout), ...edges(theme, state, layout),
        ...(best ? [{ type: "circle", shape: { cx: layout.x(best[0]), cy: layout.y(best[1]), r: 7 }, style: { fill: "none", stroke: "#ffffff", lineWidth: 5 } }, { type: "circle", shape: { cx: layout.x(best[0]), cy: layout.y(best[1]), r: 7 }, style: { fill: "none", stroke: "#20242a", lineWidth: 2.4 } }] : []),
        ...tickTexts(theme, xScale, (part) => ({ x: layout.x(part), y: layout.y(0) + 7, align: "center", verticalAlign: "top" })),
        ...tickTexts(theme, yScale, (part) => ({ x: layout.x(0) - 7, y: layout.y(part), align: "right", verticalAlign: "middle" })),
        title(titleOf(xScale), { x: layout.x(0.5), y: layout.y(0) + 26, align: "center", verticalAlign: "top" }),
        title(titleOf(yScale), { x: 0, y: 4, align: "left", verticalAlign: "top" }),
      ],
    }),
  };
}

/** Everything one picture is made of. */
function stateOf(study, source, metric, x, y) {
  const [xScale, yScale] = [scaleOf(x, { ticks: 6 }), scaleOf(y, { ticks: 5 })];
  const grid = gridOf(study, source, metric, x, y);
  const values = grid.values.flat().filter((value) => value !== null);
  const range = extent(values) ?? [0, 1];
  return { xScale, yScale, xs: x.distinct.map(xScale.at), ys: y.distinct.map(yScale.at), grid, range, bounds: boundsOf(study, metric.column), scale: scaleFor(metric.units, Math.max(...range.map(Math.abs))) };
}

function legendOf({ range, scale, bounds }, metric) {
  const text = (value) => `${number(value / scale.factor, 3)}${scale.unit ? ` ${scale.unit}` : ""}`;
  const edge = bounds.length ? h("span", { class: "edge-entry" }, h("i", { class: "stroke dashed", style: "color:var(--bad)" }), `edge of a constraint: ${bounds.map(({ bound, least }) => `${least ? "at least" : "at most"} ${text(bound)}`).join(", ")}`) : null;
  return h("div", { class: "field-legend" }, h("span", {}, metric.label), h("span", { class: "legend-end" }, text(range[0])), h("i", { class: "gradient", style: `background:${gradient()}` }), h("span", { class: "legend-end" }, text(range[1])), edge);
}

export function contourMap(study, source) {
  const axes = source.inputs.filter((column) => !column.isText && column.distinct.length > 2);
  const metrics = source.metrics.filter((each) => each.column);
  if (axes.length < 2 || metrics.length === 0) return null;
  let [x, y, metric] = [axes[0], axes[1], metrics.find(({ bounds }) => bounds?.length) ?? metrics[0]];
  let state = stateOf(study, source, metric, x, y);
  const change = () => { state = stateOf(study, source, metric, x, y); chart.redraw(); };
  const options = axes.map((column) => ({ value: column.name, label: label(column.name) }));
  const named = (name) => axes.find((column) => column.name === name);
  const best = () => (source.hasBest ? [state.xScale.at(x.at(source.best)), state.yScale.at(y.at(source.best))] : null);
  const controls = [select("Metric", metrics.map((each) => ({ value: each.name, label: each.label })), metric.name, (name) => { metric = metrics.find((each) => each.name === name); change(); })];
  if (axes.length > 2) {
    controls.push(select("Across", options, x.name, (name) => { x = named(name); if (x === y) y = axes.find((column) => column !== x); change(); }));
    controls.push(select("Upwards", options, y.name, (name) => { y = named(name); if (x === y) x = axes.find((column) => column !== y); change(); }));
  }
  const chart = figure({
    height: 380,
    controls,
    name: `${study.name} contours`,
    selection: study.selection,
    rowOf: ({ data }) => data?.[2] ?? null,
    litAt: (row, shown) => (state.grid.rows.flat().includes(row) ? [{ at: [layoutOf(shown.getWidth(), 380).x(state.xScale.at(x.at(row))), layoutOf(shown.getWidth(), 380).y(state.yScale.at(y.at(row)))] }] : []),
    csv: () => [[x.name, y.name, metric.name], ...state.grid.rows.flat().filter((row) => row !== null).map((row) => [x.at(row), y.at(row), metric.column.at(row)])],
    legend: () => legendOf(state, metric),
    option: (theme, width) => ({
      tooltip: { trigger: "item", formatter: ({ data }) => scenarioTip(study, data[2], [tipLine(metric.label, quantity(metric.column.at(data[2]), metric.units))]) },
      series: [cellSeries(study, state, layoutOf(width, 380)), frame(theme, state, layoutOf(width, 380), best())],
    }),
    describe: () => `${metric.label} over ${label(x.name)} and ${label(y.name)}, from ${quantity(state.range[0], metric.units)} to ${quantity(state.range[1], metric.units)}. The table of scenarios holds the same values.`,
    note: source.hasBest ? "Ring: the best. The other inputs are as in it." : "The other inputs are those in the middle of the study.",
  });
  return h("div", {}, h("h3", {}, "Over two inputs"), chart.element);
}

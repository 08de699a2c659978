// A metric over two inputs of a grid, through the best scenario: cells from pale to dark, lines of equal value, the edge of each constraint.

import { figure } from "./chart.js";
import { contour } from "./contour.js";
import { boundWords, frame, HEIGHT, layoutOf, levelText, rgb, surfaceLegend } from "./contour_picture.js";
import { h, select } from "./dom.js";
import { boundsOf, scaleOf } from "./scale.js";
import { scenarioTip, tipLine } from "./scenario.js";
import { extent } from "./statistics.js";
import { label, quantity, scaleFor } from "./words.js";

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

/** Everything one picture is made of. */
function stateOf(study, source, metric, x, y) {
  const [xScale, yScale] = [scaleOf(x, { ticks: 6 }), scaleOf(y, { ticks: 5 })];
  const grid = gridOf(study, source, metric, x, y);
  const range = extent(grid.values.flat().filter((value) => value !== null)) ?? [0, 1];
  const bounds = boundsOf(study, metric.column);
  const scale = scaleFor(metric.units, Math.max(...range.map(Math.abs)));
  const [xs, ys] = [x.distinct.map(xScale.at), y.distinct.map(yScale.at)];
  const pieces = (level) => contour(xs, ys, grid.values, level);
  return { xScale, yScale, xs, ys, grid, range, bounds, scale, text: levelText(metric, scale), pieces, edges: bounds.flatMap(({ bound }) => pieces(bound)) };
}

export function contourMap(study, source) {
  const axes = source.inputs.filter((column) => !column.isText && column.distinct.length > 2);
  const metrics = source.metrics.filter((each) => each.column);
  if (axes.length < 2 || metrics.length === 0) return null;
  let [x, y, metric] = [axes[0], axes[1], metrics.find(({ bounds }) => bounds?.length) ?? metrics[0]];
  let state = stateOf(study, source, metric, x, y);
  const change = (chosen) => {
    [x, y, metric] = [chosen.x, chosen.y, chosen.metric];
    state = stateOf(study, source, metric, x, y);
    chart.redraw();
  };
  const best = () => (source.hasBest ? [state.xScale.at(x.at(source.best)), state.yScale.at(y.at(source.best))] : null);
  const at = (row, layout) => [layout.x(state.xScale.at(x.at(row))), layout.y(state.yScale.at(y.at(row)))];
  const chart = figure({
    height: HEIGHT,
    controls: surfaceControls({ axes, metrics }, { x, y, metric }, change),
    name: `${study.name} contours`,
    selection: study.selection,
    rowOf: ({ data }) => data?.[2] ?? null,
    litAt: (row, shown) => (state.grid.rows.flat().includes(row) ? [{ at: at(row, layoutOf(shown.getWidth())) }] : []),
    csv: () => [[x.name, y.name, metric.name], ...state.grid.rows.flat().filter((row) => row !== null).map((row) => [x.at(row), y.at(row), metric.column.at(row)])],
    legend: () => surfaceLegend(metric, state, state.bounds.length ? boundWords(state.bounds, state) : null),
    option: (theme, width) => ({
      tooltip: { trigger: "item", formatter: ({ data }) => scenarioTip(study, data[2], [tipLine(metric.label, quantity(metric.column.at(data[2]), metric.units))]) },
      series: [cellSeries(study, state, layoutOf(width)), frame(theme, state, layoutOf(width), best())],
    }),
    describe: () => `${metric.label} over ${label(x.name)} and ${label(y.name)}, from ${quantity(state.range[0], metric.units)} to ${quantity(state.range[1], metric.units)}. The table of scenarios holds the same values.`,
    note: source.hasBest ? "Ring: the best. The other inputs are as in it." : "The other inputs are those in the middle of the study.",
  });
  return h("div", {}, h("h3", {}, "Over two inputs"), chart.element);
}

/** Which metric, and over which two inputs where there are more. @param changed ({ x, y, metric }) */
export function surfaceControls({ axes, metrics }, chosen, changed) {
  const now = { ...chosen };
  const choose = (more) => { Object.assign(now, more); changed(now); };
  const named = (name) => axes.find((column) => column.name === name);
  const other = (column, taken) => (column === taken ? axes.find((each) => each !== taken) : column);
  const controls = [select("Metric", metrics.map((each) => ({ value: each.name, label: each.label })), now.metric.name, (name) => choose({ metric: metrics.find((each) => each.name === name) }))];
  if (axes.length < 3) return controls;
  const options = axes.map((column) => ({ value: column.name, label: label(column.name) }));
  const [across, upwards] = [
    select("Across", options, now.x.name, (name) => { choose({ x: named(name), y: other(now.y, named(name)) }); show(); }),
    select("Upwards", options, now.y.name, (name) => { choose({ y: named(name), x: other(now.x, named(name)) }); show(); }),
  ];
  const show = () => { across.querySelector("select").value = now.x.name; upwards.querySelector("select").value = now.y.name; };
  return [...controls, across, upwards];
}

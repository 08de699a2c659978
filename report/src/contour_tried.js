// A metric over two variables of a search, through what it tried near the best: every evaluation is shown, and between neighbours the value
// is taken to change evenly. Where nobody looked there is nothing.

import { figure } from "./chart.js";
import { boundWords, frame, HEIGHT, layoutOf, levelText, rgb, surfaceLegend } from "./contour_picture.js";
import { surfaceControls } from "./contour_map.js";
import { evaluationsOf, evaluationTip, scenarioRow } from "./convergence.js";
import { h } from "./dom.js";
import { scaleOf } from "./scale.js";
import { distanceToBest, NEAR, triedValue } from "./slice_curves.js";
import { extent, quantile } from "./statistics.js";
import { rowsOf } from "./tables.js";
import { bands, levelPieces, triangles } from "./triangles.js";
import { label, listed, percent, plural, quantity, scaleFor } from "./words.js";

/** Of an axis: evaluations further apart than this say nothing about what is between them. */
const GAP = 0.3;
const BANDS = 14;
const LEAST_POINTS = 6;
const PAD = 0.04;

/** A scale that spans what lies near the best, a little more at both ends; of what is further off nothing is shown. */
function nearScale(column, near, ticks) {
  const [least, most] = extent(near.map((row) => column.at(row)));
  const pad = PAD * (most - least);
  const shown = column.distinct.filter((value) => value >= least && value <= most);
  const ends = [Math.max(least - pad, least > 0 ? 0.9 * least : -Infinity), most + pad];
  return scaleOf({ name: column.name, units: column.units, isText: false, most: column.most, distinct: [ends[0], ...shown, ends[1]] }, { ticks });
}

/** Every evaluation: { row, x, y (parts of the axes), value, violation, feasible, far (how far from the best otherwise) }. */
function pointsOf(study, source, metric, [x, y], [xScale, yScale], far) {
  const { table } = source;
  return rowsOf(table)
    .filter((row) => x.at(row) !== null && y.at(row) !== null)
    .map((row) => ({ row, x: xScale.at(x.at(row)), y: yScale.at(y.at(row)), value: triedValue(study, source, metric, row), violation: table.at("violation", row), feasible: table.at("feasible", row) === 1, far: far(row) }))
    .filter((point) => point.x >= 0 && point.x <= 1 && point.y >= 0 && point.y <= 1);
}

/** Values far above the others would flatten everything. */
function rangeOf(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const [least, most] = extent(sorted) ?? [0, 1];
  const usual = quantile(sorted, 0.95) ?? most;
  return most - least > 3 * (usual - least) && usual > least ? { range: [least, usual], beyond: true } : { range: [least, most], beyond: false };
}

function stateOf(study, source, metric, x, y) {
  const far = distanceToBest(source, [x, y]);
  const rows = rowsOf(source.table).filter((row) => far(row) <= NEAR);
  const shown = rows.length < LEAST_POINTS ? rowsOf(source.table) : rows;
  const [xScale, yScale] = [nearScale(x, shown, 6), nearScale(y, shown, 5)];
  const points = pointsOf(study, source, metric, [x, y], [xScale, yScale], far);
  const near = points.filter(({ far, value }) => far <= NEAR && value !== null).sort((a, b) => a.far - b.far);
  const found = near.length < LEAST_POINTS ? [] : triangles(near, GAP);
  const { range, beyond } = rangeOf(near.map(({ value }) => value));
  const scale = scaleFor(metric.units, Math.max(...range.map(Math.abs)));
  const pieces = (level) => levelPieces(found, level, ({ value }) => value);
  const ownEdges = metric.bounds.flatMap(({ bound }) => pieces(bound));
  const feasibleEdge = levelPieces(found, 0, ({ violation }) => violation);
  return { xScale, yScale, x, y, points, near: new Set(near), found, range, beyond, scale, text: levelText(metric, scale), pieces, hasOwn: ownEdges.length > 0, hasFeasible: feasibleEdge.length > 0, edges: [...ownEdges, ...feasibleEdge] };
}

function surfaceSeries({ found, range }, layout) {
  const levels = Array.from({ length: BANDS + 1 }, (_, i) => range[0] + (i / BANDS) * (range[1] - range[0]));
  const polygons = range[1] > range[0] ? bands(found, levels, ({ value }) => value) : [];
  const children = polygons.map(({ band, points }) => ({ type: "polygon", shape: { points: points.map(([x, y]) => [layout.x(x), layout.y(y)]) }, style: { fill: rgb((band + 0.5) / BANDS), stroke: rgb((band + 0.5) / BANDS), lineWidth: 0.6 } }));
  return { type: "custom", coordinateSystem: "none", silent: true, z: 1, data: [[0]], renderItem: () => ({ type: "group", children }) };
}

/** A dot per evaluation: filled where every constraint is met, small where it is far from the best in the other variables. */
function dotSeries(study, theme, { points, near }, table, layout) {
  return {
    type: "custom", coordinateSystem: "none", z: 4, progressive: 0, data: points.map((_, i) => [i]),
    renderItem: (params, api) => {
      const point = points[api.value(0)];
      const scenario = scenarioRow(study, table, point.row);
      const [used, chosen] = [near.has(point), scenario === null ? !study.selection.active : study.selection.has(scenario)];
      return { type: "circle", shape: { cx: layout.x(point.x), cy: layout.y(point.y), r: used ? 3.6 : 2.2 }, style: { fill: point.feasible ? theme.accent : theme.paper, stroke: point.feasible ? theme.paper : theme.soft, lineWidth: point.feasible ? 0.8 : 1.3, opacity: (used ? 1 : 0.55) * (chosen ? 1 : 0.12) } };
    },
  };
}

function edgeWords(metric, state) {
  const own = state.hasOwn ? boundWords(metric.bounds, state) : "";
  return [own, state.hasFeasible ? "where the first constraint is broken" : ""].filter(Boolean).join("; ") || null;
}

function noteOf(source, { x, y, near, points, found }) {
  const others = source.keys.filter((each) => each !== x && each !== y).map((each) => label(each.name));
  const few = others.length ? `${plural(near.size, "evaluation")} of ${source.table.rows} ${near.size === 1 ? "lies" : "lie"} within ${percent(NEAR)} of what was tried from the best in ${listed(others)}; the small dots do not, and count for nothing here. ` : "";
  const said = found.length ? `Between three neighbours, none further apart than ${percent(GAP)} of an axis, the value is taken to change evenly; where nobody looked there is nothing. ` : "Too few lie near each other for a surface. ";
  return `Ring: the best. Dots: what was tried, filled where every constraint is met. ${few}${said}`.trim();
}

export function triedMap(study, source) {
  const axes = source.keys.filter((column) => column.distinct.length > 2);
  if (axes.length < 2 || source.table.rows < LEAST_POINTS) return null;
  const { table, metrics } = source;
  let metric = metrics[0];
  let state = stateOf(study, source, metric, axes[0], axes[1]);
  const change = (chosen) => {
    metric = chosen.metric;
    state = stateOf(study, source, metric, chosen.x, chosen.y);
    chart.redraw();
  };
  const value = (each) => (metric.isShare ? percent(each) : quantity(each, metric.units));
  const best = () => [state.xScale, state.yScale].map((scale) => scale.at(source.best.at(scale.column.name, 0)));
  const rowOf = ({ data }) => (Array.isArray(data) && state.points[data[0]] ? scenarioRow(study, table, state.points[data[0]].row) : null);
  const chart = figure({
    height: HEIGHT,
    controls: surfaceControls({ axes, metrics }, { x: axes[0], y: axes[1], metric }, change),
    name: `${study.name} contours`,
    selection: study.selection,
    rowOf,
    litAt: (scenario, shown) => {
      const layout = layoutOf(shown.getWidth());
      const rows = new Set(evaluationsOf(study, table, scenario));
      return state.points.filter(({ row }) => rows.has(row)).map(({ x, y }) => ({ at: [layout.x(x), layout.y(y)] }));
    },
    csv: () => [["evaluation", state.x.name, state.y.name, metric.name, "feasible", "violation", "counts"], ...state.points.map((point) => [point.row, state.x.at(point.row), state.y.at(point.row), point.value, point.feasible ? 1 : 0, point.violation, state.near.has(point) ? 1 : 0])],
    legend: () => surfaceLegend(metric, state, edgeWords(metric, state), state.beyond),
    option: (theme, width) => ({
      tooltip: { trigger: "item", formatter: ({ data }) => evaluationTip(study, table, state.points[data[0]].row, [{ name: metric.label, column: { at: () => state.points[data[0]].value }, units: metric.units }]) },
      series: [surfaceSeries(state, layoutOf(width)), dotSeries(study, theme, state, table, layoutOf(width)), frame(theme, state, layoutOf(width), best())],
    }),
    describe: () => `${metric.label} over ${label(state.x.name)} and ${label(state.y.name)}: ${plural(state.points.length, "evaluation")}, ${state.near.size} of them near the best otherwise${state.found.length ? `, from ${value(state.range[0])} to ${value(state.range[1])}` : ""}.`,
    note: () => noteOf(source, state),
  });
  return h("div", {}, h("h3", {}, "Over two variables"), chart.element);
}

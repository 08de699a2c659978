// How a metric moves with one input at a time: through the best scenario of a grid, near the best strategy of a search, or over
// random products. One small chart per input; of a grid or a search also contours over two.

import { figure } from "./chart.js";
import { contourMap } from "./contour_map.js";
import { triedMap } from "./contour_tried.js";
import { h, select } from "./dom.js";
import { legend, outcomeList } from "./legend.js";
import { boundsOf, logValues } from "./scale.js";
import { scenarioTip, tip, tipLine } from "./scenario.js";
import { curvesOf, sourceOf } from "./slice_curves.js";
import { outcomeColour } from "./theme.js";
import { label, listed, number, OUTCOMES, percent, plural, quantity, scaleFor, shortText } from "./words.js";

const HEIGHT = 214;
const LEADS = {
  grid: "How a metric moves when one input is changed and the others stay those of the best.",
  search: "What the search tried, over each variable: the fainter, the further from the best in the others.",
  random: "What an input does over random products, the others as they came.",
};

export function slicesTitle(study) {
  return sourceOf(study).kind === "random" ? "Over each input" : "Through the best";
}

export function slicesLead(study) {
  return LEADS[sourceOf(study).kind] ?? "";
}

function columnsOf(width, count) {
  return Math.min(count, width > 860 ? 3 : width > 520 ? 2 : 1);
}

/** Where each small chart stands. */
function placesOf(width, count) {
  const across = columnsOf(width, count);
  const each = width / across;
  return Array.from({ length: count }, (_, i) => ({ left: (i % across) * each + 52, top: Math.floor(i / across) * HEIGHT + 30, width: each - 66, height: HEIGHT - 84 }));
}

function isLog(column) {
  const { distinct } = column;
  return !column.isText && distinct.length > 3 && distinct[0] > 0 && distinct[distinct.length - 1] / distinct[0] > 8;
}

function inputAxis(theme, column, i) {
  const scale = scaleFor(column.units, column.most);
  const name = label(column.name) + (scale.unit ? ` (${scale.unit})` : "");
  const { distinct } = column;
  const base = { gridIndex: i, name, nameLocation: "middle", nameGap: 26, nameTextStyle: { color: theme.ink, fontSize: 13 }, axisTick: { show: false }, axisLine: { lineStyle: { color: theme.line } }, splitLine: { show: false } };
  if (column.isText) return { ...base, type: "category", data: distinct.map(shortText), axisLabel: { color: theme.soft, fontSize: 12, hideOverlap: true } };
  const text = { color: theme.soft, fontSize: 12, hideOverlap: true, formatter: (value) => number(value / scale.factor, 3) };
  const [least, most] = [distinct[0], distinct[distinct.length - 1]];
  const pad = 0.03 * (most - least);
  if (isLog(column)) return { ...base, type: "log", min: least / 1.1, max: most * 1.1, axisLabel: { ...text, customValues: logValues(least, most) } };
  return { ...base, type: "value", min: least - pad, max: most + pad, axisLabel: { ...text, showMinLabel: false, showMaxLabel: false }, splitNumber: 4 };
}

function metricAxis(theme, metric, i, range) {
  const scale = scaleFor(metric.units, Math.max(...range.map(Math.abs)));
  const text = metric.isShare ? percent : (value) => number(value / scale.factor, 3);
  return {
    type: "value", gridIndex: i, min: range[0], max: range[1], splitNumber: 3, name: i === 0 ? `${metric.label}${scale.unit ? ` (${scale.unit})` : ""}` : "", nameTextStyle: { color: theme.soft, fontSize: 13, align: "left", padding: [0, 0, 0, -44] }, nameGap: 14,
    axisTick: { show: false }, axisLine: { show: false }, splitLine: { lineStyle: { color: theme.line, opacity: 0.7 } }, axisLabel: { color: theme.soft, fontSize: 12, showMinLabel: false, showMaxLabel: false, formatter: text },
  };
}

/** All small charts share the range of the metric, with its bounds where they are near. */
function rangeOf(metric, curves) {
  if (metric.isShare) return [0, 1];
  const values = curves.flatMap(({ points }) => points.flatMap(({ y, low, high }) => [y, low, high])).filter((value) => typeof value === "number" && Number.isFinite(value));
  if (!values.length) return [0, 1];
  const sorted = [...values].sort((a, b) => a - b);
  // What is far off would flatten everything.
  const [least, most] = [sorted[0], sorted[Math.min(sorted.length - 1, Math.ceil(0.98 * sorted.length))]];
  const span = most - least || Math.abs(most) || 1;
  const bounds = metric.bounds.map(({ bound }) => bound).filter((bound) => bound > least - span && bound < most + span);
  const [low, high] = [Math.min(least, ...bounds), Math.max(most, ...bounds)];
  return [low >= 0 && low < 0.3 * (high - low) ? 0 : low - 0.06 * (high - low), high + 0.06 * (high - low)];
}

function edgeSeries(theme, metric, range, i) {
  return metric.bounds.filter(({ bound }) => bound >= range[0] && bound <= range[1]).map(({ bound, least }) => ({
    type: "line", xAxisIndex: i, yAxisIndex: i, data: [], silent: true,
    markLine: { silent: true, symbol: "none", precision: 15, lineStyle: { color: theme.bad, width: 1.5, type: "dashed" }, label: { show: i === 0, formatter: `${least ? "at least" : "limit"} ${quantity(bound, metric.units, 3)}`, position: "insideEndTop", color: theme.bad, fontSize: 12, fontWeight: 600 }, data: [{ yAxis: bound }] },
    markArea: { silent: true, itemStyle: { color: theme.bad, opacity: 0.06 }, data: [[{ yAxis: least ? range[0] : bound }, { yAxis: least ? bound : range[1] }]] },
  }));
}

function bestSeries(theme, { best, column }, i) {
  if (best === null) return [];
  return [{ type: "line", xAxisIndex: i, yAxisIndex: i, data: [], silent: true, markLine: { silent: true, symbol: "none", precision: 15, label: { show: false }, lineStyle: { color: theme.ink, width: 1, type: "solid", opacity: 0.6 }, data: [{ xAxis: column.isText ? shortText(best) : best }] } }];
}

/** Interval of a point, as a line with ends. */
function whiskers(theme, { points, column }, i) {
  const data = points.filter(({ low, high }) => low !== undefined && low !== null && high !== null).map(({ x, low, high }) => [x, low, high]);
  if (!data.length) return [];
  return [{ type: "custom", xAxisIndex: i, yAxisIndex: i, silent: true, data, encode: { x: 0, y: [1, 2] }, renderItem: (params, api) => {
    const [[x, from], [, to]] = [api.coord([api.value(0), api.value(1)]), api.coord([api.value(0), api.value(2)])];
    const line = (x1, x2, y1, y2) => ({ type: "line", shape: { x1, x2, y1, y2 }, style: { stroke: theme.soft, lineWidth: 1.5 } });
    return { type: "group", children: [line(x, x, from, to), line(x - 4, x + 4, from, from), line(x - 4, x + 4, to, to)] };
  }, name: label(column.name) }];
}

function pointStyle(study, theme, { row, weight = 1, colour }) {
  const chosen = row === null || row === undefined || study.selection.has(row);
  return { color: colour ?? (row === null || row === undefined ? theme.accent : outcomeColour(study.scenarios.at("outcome", row))), opacity: (chosen ? 1 : 0.12) * weight, borderColor: theme.paper, borderWidth: 0.8 };
}

function pointSeries(study, theme, curve, range, i) {
  const shown = curve.points.filter(({ y }) => y !== null && y <= range[1] && y >= range[0]);
  const joined = curve.joined ? [{ type: "line", xAxisIndex: i, yAxisIndex: i, silent: true, symbol: "none", lineStyle: { color: theme.soft, width: 1.4 }, data: curve.points.map(({ x, y }) => [x, y]), connectNulls: false }] : [];
  return [...joined, { type: "scatter", xAxisIndex: i, yAxisIndex: i, symbolSize: curve.joined ? 8 : 6.5, z: 4, data: shown.map((point) => ({ value: [point.x, point.y, point.row ?? null], point, itemStyle: pointStyle(study, theme, point) })) }];
}

function pointTip(study, metric, column, { point }) {
  const value = (each) => (metric.isShare ? percent(each) : quantity(each, metric.units));
  const lines = [tipLine(metric.label, value(point.y)), point.low === undefined || point.low === null ? null : tipLine(point.spread ?? "interval", `${value(point.low)} to ${value(point.high)}`)];
  if (point.row !== null && point.row !== undefined) return scenarioTip(study, point.row, lines);
  return tip(h("div", { class: "tip-head" }, h("b", {}, `${label(column.name)} ${point.words ?? quantity(point.x, column.units)}`)), lines, point.count ? tipLine("scenarios", number(point.count)) : null);
}

function optionOf(study, theme, metric, curves, width) {
  const range = rangeOf(metric, curves);
  return {
    grid: placesOf(width, curves.length).map((place) => ({ ...place, containLabel: false })),
    xAxis: curves.map(({ column }, i) => inputAxis(theme, column, i)),
    yAxis: curves.map((_, i) => metricAxis(theme, metric, i, range)),
    tooltip: { trigger: "item", formatter: ({ data, seriesIndex }) => pointTip(study, metric, curves[seriesOwner(study, theme, metric, curves, range, seriesIndex)].column, data) },
    series: curves.flatMap((curve, i) => seriesOf(study, theme, metric, curve, range, i)),
  };
}

function seriesOf(study, theme, metric, curve, range, i) {
  return [...edgeSeries(theme, metric, range, i), ...bestSeries(theme, curve, i), ...whiskers(theme, curve, i), ...pointSeries(study, theme, curve, range, i)];
}

/** The small chart that a series belongs to. */
function seriesOwner(study, theme, metric, curves, range, index) {
  let passed = 0;
  return curves.findIndex((curve, i) => { passed += seriesOf(study, theme, metric, curve, range, i).length; return index < passed; });
}

function noteOf(source, metric, curves) {
  const said = { grid: "Vertical line: the best; the others of its inputs are held. ", search: "Vertical line: the best strategy. ", random: "Groups of equally many scenarios. " }[source.kind];
  return `${said}${metric.bounds.length ? "Dashed: the edge of a constraint; what is shaded breaks it. " : ""}${curves.some((curve) => curve.points.some(({ low }) => low !== undefined && low !== null)) ? metric.isShare ? "Lines: 95 % intervals." : "Lines: from 5 % to 95 % of the scenarios." : ""}`.trim();
}

export function slices(study) {
  const source = sourceOf(study);
  if (source.metrics.length === 0) return null;
  for (const each of source.metrics) each.bounds = each.column ? boundsOf(study, each.column) : each.bounds ?? [];
  // Of a grid the first to look at is one that has an edge.
  let metric = (source.kind === "grid" && source.metrics.find(({ column, bounds }) => column && bounds.length)) || source.metrics[0];
  let curves = curvesOf(study, source, metric);
  if (curves.length === 0) return null;
  const choose = (name) => { metric = source.metrics.find((each) => each.name === name); curves = curvesOf(study, source, metric); chart.redraw(); };
  const outcomes = outcomeList(OUTCOMES.filter((word) => study.scenarios.counts[word]), null, study.selection);
  const chart = figure({
    height: (width) => Math.ceil(curves.length / columnsOf(width, curves.length)) * HEIGHT,
    controls: [select("Metric", source.metrics.map((each) => ({ value: each.name, label: each.label })), metric.name, choose)],
    name: `${study.name} slices`,
    selection: study.selection,
    rowOf: ({ data }) => data?.point?.row ?? null,
    litAt: (row, shown) => curves.flatMap(({ points }, i) => points.filter((point) => point.row === row && point.y !== null).map(({ x, y }) => ({ at: shown.convertToPixel({ xAxisIndex: i, yAxisIndex: i }, [x, y]) }))),
    csv: () => [["input", "value", metric.name, "low", "high", "scenario"], ...curves.flatMap(({ column, points }) => points.map(({ x, y, low, high, row }) => [column.name, column.isText ? column.distinct[x] : x, y, low, high, row === null || row === undefined ? null : study.scenarios.at("id", row)]))],
    legend: (theme) => (source.kind === "random" ? legend([[theme.accent, metric.isShare ? "share of the scenarios" : "median of the scenarios"]]) : metric.name === "margin" ? legend([[theme.accent, "force that damages over force that holds, less one"]]) : outcomes),
    option: (theme, width) => optionOf(study, theme, metric, curves, width),
    describe: () => `${metric.label} over ${listed(curves.map(({ column }) => label(column.name)))}, ${plural(curves.length, "small chart")}.`,
    note: () => noteOf(source, metric, curves),
  });
  return h("div", { class: "parts" }, chart.element, source.kind === "grid" ? contourMap(study, source) : source.kind === "search" ? triedMap(study, source) : null);
}

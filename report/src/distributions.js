// How a metric is spread over the scenarios: a histogram by outcome, or boxes by group.

import { axis, figure } from "./chart.js";
import { rectangle } from "./chart_overlay.js";
import { boundOf } from "./claims.js";
import { h, select } from "./dom.js";
import { legend, outcomeList } from "./legend.js";
import { tip, tipLine } from "./scenario.js";
import { binEdges, extent, quantile } from "./statistics.js";
import { label, number, OUTCOMES, outcomeLabel, plural, quantity, scaleFor, thousands } from "./words.js";
import { outcomeColour } from "./theme.js";

const PREFERRED = ["permanent_set_max_m", "contact_yield_ratio_max", "friction_margin_min", "peak_finger_force_N", "cycle_time_s"];

/** Ascending, without those that do not exist. */
function numbersOf(column, rows) {
  const values = [];
  for (const row of rows) if (column.at(row) !== null) values.push(column.at(row));
  return values.sort((a, b) => a - b);
}

/** A robust study is spread over strategies too: only the best one's products tell how it varies. */
function rowsOf(study) {
  const { scenarios } = study;
  const all = Array.from({ length: scenarios.rows }, (_, row) => row);
  const best = study.tables.get("best");
  if (study.kind !== "robust" || !best || best.rows === 0) return all;
  const keys = best.columns.filter((column) => scenarios.inputs.some((input) => input.name === column.name));
  const checks = scenarios.inputs.filter((column) => column.varies && column.isNearlyConstant && !keys.some((key) => key.name === column.name));
  const rows = all.filter((row) => keys.every((key) => scenarios.at(key.name, row) === key.at(0)) && checks.every((column) => column.at(row) === column.usual));
  return rows.length >= 8 ? rows : all;
}

/** Values by outcome, of the scenarios selected; the far tail of a skewed metric is folded into the last bin. */
function histogram(study, column, rows) {
  const values = numbersOf(column, rows);
  const [least, most] = extent(values);
  const edge = quantile(values, 0.995);
  const folded = most > least + 3 * (edge - least) && edge > least;
  const edges = binEdges(least, folded ? edge : most, Math.max(8, Math.min(36, Math.round(Math.sqrt(values.length) * 1.4))));
  const step = edges[1] - edges[0];
  const bins = edges.length - 1;
  const counts = Object.fromEntries(OUTCOMES.map((word) => [word, new Array(bins).fill(0)]));
  const all = new Array(bins).fill(0);
  for (const row of rows) {
    const value = column.at(row);
    if (value === null) continue;
    const bin = Math.max(0, Math.min(bins - 1, Math.floor((value - edges[0]) / step + 1e-9)));
    all[bin] += 1;
    if (study.selection.has(row)) counts[study.scenarios.at("outcome", row)][bin] += 1;
  }
  return { edges, step, counts, all, folded, values };
}

function binTip(column, bins, index) {
  const { edges, counts, folded } = bins;
  const last = index === edges.length - 2 && folded;
  return tip(
    h("div", { class: "tip-head" }, h("b", {}, last ? `${quantity(edges[index], column.units)} and more` : `${quantity(edges[index], column.units)} to ${quantity(edges[index + 1], column.units)}`)),
    OUTCOMES.filter((word) => counts[word][index]).map((word) => tipLine(outcomeLabel(word), plural(counts[word][index], "scenario"))),
  );
}

/** One outcome's part of every bar, standing on the parts of those before it. */
function barSeries(theme, { edges, step, counts }, word) {
  return {
    type: "custom",
    name: outcomeLabel(word),
    data: counts[word].map((count, i) => [edges[i] + step / 2, count, i, OUTCOMES.slice(0, OUTCOMES.indexOf(word)).reduce((sum, other) => sum + counts[other][i], 0)]).filter((each) => each[1] > 0),
    encode: { x: 0, y: 1 },
    renderItem: (params, api) => {
      const below = api.value(3);
      const [left, top] = api.coord([api.value(0) - step / 2, below + api.value(1)]);
      const [right, bottom] = api.coord([api.value(0) + step / 2, below]);
      return { type: "rect", shape: { x: left + 0.5, y: top, width: Math.max(1, right - left - 1), height: bottom - top }, style: { fill: outcomeColour(word) }, emphasis: { style: { stroke: theme.ink, lineWidth: 1.5 } } };
    },
  };
}

/** Behind what is selected: all there is. */
function behind(theme, { edges, step, all }) {
  return {
    type: "custom", name: "all", silent: true, data: all.map((count, i) => [edges[i] + step / 2, count]).filter((each) => each[1] > 0), encode: { x: 0, y: 1 },
    renderItem: (params, api) => {
      const [left, top] = api.coord([api.value(0) - step / 2, api.value(1)]);
      const [right, bottom] = api.coord([api.value(0) + step / 2, 0]);
      return { type: "rect", shape: { x: left + 0.5, y: top, width: Math.max(1, right - left - 1), height: bottom - top }, style: { fill: theme.soft, opacity: 0.16 } };
    },
  };
}

function histogramOption(study, theme, column, rows) {
  const bins = histogram(study, column, rows);
  const { edges, step, counts, all } = bins;
  const limit = boundOf(study, column.name);
  const series = OUTCOMES.filter((word) => counts[word].some((count) => count > 0)).map((word) => barSeries(theme, bins, word));
  if (study.selection.active) series.unshift(behind(theme, bins));
  const most = Math.max(...all);
  const shown = limit !== null && limit >= edges[0] - 2 * step && limit <= edges[edges.length - 1] + 6 * step;
  if (shown && series.length) series[0].markLine = limitLine(theme, column, limit);
  return {
    grid: { left: 8, right: 20, top: 40, bottom: 44, containLabel: true },
    xAxis: axis(theme, { name: label(column.name), units: column.units, most: Math.max(...edges.map(Math.abs)), lines: false, min: Math.min(edges[0], shown ? limit : Infinity), max: Math.max(edges[edges.length - 1], shown ? limit * 1.02 : -Infinity) }),
    yAxis: axis(theme, { name: "scenarios", vertical: true, min: 0, max: Math.ceil(most * 1.06), minInterval: 1, axisLabel: { color: theme.soft, fontSize: 12, showMaxLabel: false, formatter: (value) => thousands(value) } }),
    tooltip: { trigger: "item", formatter: ({ value }) => binTip(column, bins, value[2]) },
    series,
  };
}

function limitLine(theme, column, limit, { upsideDown = false } = {}) {
  return {
    silent: true,
    symbol: "none",
    precision: 15, // the default rounds to hundredths of a metre
    lineStyle: { color: theme.ink, width: 1.5, type: "dashed" },
    label: { formatter: `limit ${quantity(limit, column.units)}`, color: theme.ink, fontSize: 12, position: upsideDown ? "start" : "end" },
    data: [{ xAxis: limit }],
  };
}

function groupsOf(study, column, group, rows) {
  return group.distinct.map((value) => {
    const values = [];
    for (const row of rows) if (group.at(row) === value && column.at(row) !== null && study.selection.has(row)) values.push(column.at(row));
    return { value, values: values.sort((a, b) => a - b) };
  });
}

const LEVELS = [0.05, 0.25, 0.5, 0.75, 0.95];

function boxOption(study, theme, column, group, rows) {
  const groups = groupsOf(study, column, group, rows).filter((each) => each.values.length);
  const limit = boundOf(study, column.name);
  const scale = Math.max(...column.numbers().map(Math.abs));
  return {
    grid: { left: 8, right: 20, top: 30, bottom: 44, containLabel: true },
    xAxis: axis(theme, { name: label(column.name), units: column.units, most: scale, scale: true }),
    yAxis: { type: "category", inverse: true, data: groups.map((each) => String(each.value)), axisTick: { show: false }, axisLine: { show: false }, axisLabel: { color: theme.ink, fontSize: 13, width: 140, overflow: "truncate" } },
    tooltip: {
      trigger: "item",
      formatter: ({ dataIndex }) => tip(h("div", { class: "tip-head" }, h("b", {}, String(groups[dataIndex].value))), LEVELS.map((level) => tipLine(`${number(level * 100)} % below`, quantity(quantile(groups[dataIndex].values, level), column.units))), tipLine("scenarios", thousands(groups[dataIndex].values.length))),
    },
    series: [
      {
        type: "boxplot",
        boxWidth: [10, 26],
        itemStyle: { color: theme.faint, borderColor: theme.accent, borderWidth: 1.6 },
        data: groups.map((each) => LEVELS.map((level) => quantile(each.values, level))),
        markLine: limit === null ? undefined : limitLine(theme, column, limit, { upsideDown: true }),
      },
    ],
  };
}

function quantileText(column, rows) {
  const values = numbersOf(column, rows);
  const missing = rows.length - values.length;
  if (values.length === 0) return "No scenario has this metric.";
  const scale = scaleFor(column.units, Math.max(...[0.05, 0.5, 0.95].map((level) => Math.abs(quantile(values, level)))));
  const at = (level) => number(quantile(values, level) / scale.factor, 3);
  const unit = scale.unit ? ` ${scale.unit}` : "";
  return `Median ${at(0.5)}${unit}, nine in ten between ${at(0.05)} and ${at(0.95)}${unit}.${missing ? ` ${plural(missing, "scenario")} ${missing === 1 ? "does" : "do"} not have this metric.` : ""}`;
}

export function distributions(study) {
  // What a search tried is no sample of anything.
  if (study.scenarios.rows < 8 || ["optimize", "pareto", "window"].includes(study.kind)) return null;
  const rows = rowsOf(study);
  const metrics = study.scenarios.metrics.filter((column) => column.varies && rows.some((row) => column.at(row) !== null));
  if (metrics.length === 0) return null;
  let column = PREFERRED.map((name) => metrics.find((each) => each.name === name)).find(Boolean) ?? metrics[0];
  const groups = study.scenarios.inputs.filter((each) => each.varies && each.distinct.length <= 12 && (each.isText || each.distinct.length <= 8));
  let group = groups.find((each) => each.name === "candidate") ?? null;
  const controls = [select("Metric", metrics.map((each) => ({ value: each.name, label: label(each.name) })), column.name, (name) => { column = study.scenarios.column(name); chart.redraw(); })];
  if (groups.length) {
    controls.push(select("By", [{ value: "", label: "outcome" }, ...groups.map((each) => ({ value: each.name, label: label(each.name) }))], group?.name ?? "", (name) => { group = groups.find((each) => each.name === name) ?? null; chart.redraw(); }));
  }
  const byOutcome = outcomeList(OUTCOMES.filter((word) => rows.some((row) => study.scenarios.at("outcome", row) === word)), null, study.selection);
  const selected = () => rows.filter((row) => study.selection.has(row));
  const chart = figure({
    height: () => (group ? 90 + 44 * group.distinct.length : 340),
    controls,
    name: `${study.name} spread`,
    selection: study.selection,
    litAt: (row, shown) => valueLine(column, row, shown),
    brush: (shown) => valueBrush(study, () => column, shown),
    csv: () => [["id", "outcome", ...(group ? [group.name] : []), column.name], ...selected().map((row) => [study.scenarios.at("id", row), study.scenarios.at("outcome", row), ...(group ? [group.at(row)] : []), column.at(row)])],
    legend: (theme) => (group ? legend([[theme.accent, "box: the middle half; whiskers: from 5 % to 95 %", "line"]]) : byOutcome),
    option: (theme) => (group ? boxOption(study, theme, column, group, rows) : histogramOption(study, theme, column, rows)),
    describe: () => `Distribution of ${label(column.name)}. ${quantileText(column, selected())}`,
    note: () => `${rows.length < study.scenarios.rows ? `The best strategy on its ${plural(rows.length, "product")}. ` : ""}${study.selection.active ? `Of the ${plural(selected().length, "scenario")} selected: ` : ""}${quantileText(column, selected())}`,
  });
  return chart.element;
}

/** A scenario's value as a line from top to bottom. */
function valueLine(column, row, chart) {
  const value = column.at(row);
  if (value === null) return [];
  const [x] = chart.convertToPixel({ gridIndex: 0 }, [value, 0]);
  return [{ path: [[x, 34], [x, chart.getHeight() - 44]] }];
}

/** A drag along the axis selects a range of the metric. */
function valueBrush(study, column, chart) {
  const grid = { gridIndex: 0 };
  return {
    inside: (px, py) => chart.containPixel(grid, [px, py]),
    shape: ([x0], [x1]) => rectangle([x0, 30], [x1, chart.getHeight() - 44]),
    done: (from, to) => to && study.selection.setRanges([[column(), [from, to].map((at) => chart.convertFromPixel(grid, at)[0])]]),
  };
}

// Parallel coordinates: an axis for each input and metric, a line for each scenario. A drag along an axis selects.

import { figure } from "./chart.js";
import { rectangle } from "./chart_overlay.js";
import { h } from "./dom.js";
import { outcomeList } from "./legend.js";
import { boundsOf, scaleOf } from "./scale.js";
import { copyReplay, scenarioTip } from "./scenario.js";
import { outcomeColour } from "./theme.js";
import { label, listed, OUTCOMES, plural, quantity, thousands } from "./words.js";

const INPUTS_MOST = 6;
const METRICS = ["friction_margin_min", "contact_yield_ratio_max", "permanent_set_max_m", "peak_finger_force_N", "cycle_time_s"];
const LINES_MOST = 1500;
const PALE_MOST = 600;
/** Below this width, or nearer to each other than their titles allow, axes lie on their sides, under each other. */
const NARROW_PX = 640;
const APART_PX = 84;
const ROW_PX = 78;
const NEAR_AXIS_PX = 18;
const SIDE_PX = 64;

function candidates({ scenarios }) {
  return [...scenarios.inputs.filter((column) => column.varies), ...scenarios.metrics.filter((column) => !column.isText && column.varies && column.name !== "step_count")];
}

function firstChoice({ scenarios }) {
  const inputs = scenarios.inputs.filter((column) => column.varies && !column.isNearlyConstant).slice(0, INPUTS_MOST);
  return [...inputs, ...METRICS.map((name) => scenarios.column(name)).filter((column) => column?.varies)];
}

/** Where axes and values stand in a chart of this width. */
function layoutOf(width, axes) {
  const apart = (width - 2 * SIDE_PX) / Math.max(1, axes.length - 1);
  const flat = width < NARROW_PX || apart < APART_PX;
  const height = flat ? 16 + ROW_PX * axes.length : 400;
  const [from, to] = flat ? [14, width - 14] : [height - 34, 78];
  const across = flat ? (i) => 44 + ROW_PX * i : (i) => SIDE_PX + apart * i;
  const along = (part) => from + part * (to - from);
  return {
    flat, height, across, along, room: flat ? width - 28 : apart,
    point: (i, part) => (flat ? [along(part), across(i)] : [across(i), along(part)]),
    part: ([x, y]) => Math.min(1, Math.max(0, ((flat ? x : y) - from) / (to - from))),
    axis: ([x, y]) => {
      const distances = axes.map((_, i) => Math.abs((flat ? y : x) - across(i)));
      const nearest = distances.indexOf(Math.min(...distances));
      return distances[nearest] <= NEAR_AXIS_PX ? nearest : null;
    },
  };
}

/** The pieces of a scenario's line; it breaks where a value does not exist. */
function pieces(axes, layout, row) {
  const found = [];
  let piece = [];
  axes.forEach((axis, i) => {
    const value = axis.column.at(row);
    const part = value === null ? null : axis.at(value);
    if (part === null) {
      if (piece.length > 1) found.push(piece);
      piece = [];
    } else piece.push(layout.point(i, part));
  });
  return piece.length > 1 ? [...found, piece] : found;
}

/** Evenly picked, so that what is drawn is like what there is. */
function evenly(rows, most) {
  return rows.length <= most ? rows : Array.from({ length: most }, (_, i) => rows[Math.floor((i * rows.length) / most)]);
}

function rowsDrawn(study) {
  const all = Array.from({ length: study.scenarios.rows }, (_, row) => row);
  const selected = all.filter((row) => study.selection.has(row));
  const others = study.selection.active ? all.filter((row) => !study.selection.has(row)) : [];
  return { selected, shown: evenly(selected, LINES_MOST), pale: evenly(others, PALE_MOST) };
}

function lineSeries(axes, layout, rows, style, silent) {
  return {
    type: "custom", coordinateSystem: "none", silent, progressive: 0, data: rows.map((row) => [row]),
    renderItem: (params, api) => {
      const row = api.value(0);
      return { type: "group", children: pieces(axes, layout, row).map((points) => ({ type: "polyline", shape: { points }, style: { ...style(row), fill: "none" } })) };
    },
  };
}

function axisTitle(theme, axis, layout, i) {
  const text = `${label(axis.column.name)}${axis.unit ? ` (${axis.unit})` : ""}${axis.log ? ", log" : ""}`;
  const style = { text, fill: theme.ink, font: `600 12px ${theme.font}`, width: Math.max(60, layout.room - 2), overflow: "break", lineHeight: 14, stroke: theme.paper, lineWidth: 4 };
  if (layout.flat) return { type: "text", style: { ...style, x: 14, y: layout.across(i) - 30, align: "left", verticalAlign: "top" } };
  return { type: "text", style: { ...style, x: layout.across(i), y: layout.along(1) - 12, align: "center", verticalAlign: "bottom" } };
}

function tickMarks(theme, axis, layout, i) {
  let last = -Infinity;
  return axis.ticks.flatMap(([part, text]) => {
    const [x, y] = layout.point(i, part);
    const place = layout.flat ? x : -y;
    if (place - last < (layout.flat ? 9 * text.length + 6 : 15)) return [];
    last = place;
    const halo = { text, fill: theme.soft, font: `11px ${theme.font}`, stroke: theme.paper, lineWidth: 4 };
    return [{ type: "text", style: { ...halo, x: layout.flat ? x : x - 6, y: layout.flat ? y + 7 : y, align: layout.flat ? (part < 0.04 ? "left" : part > 0.96 ? "right" : "center") : "right", verticalAlign: layout.flat ? "top" : "middle" } }];
  });
}

/** What a bound forbids: that part of the axis, thick, and the word. */
function boundMarks(theme, axis, layout, i) {
  return axis.bounds.flatMap(({ bound, least }) => {
    const part = axis.at(bound);
    if (part === null || part < -0.001 || part > 1.001) return [];
    const [from, to] = [layout.point(i, part), layout.point(i, least ? 0 : 1)];
    const word = { text: "limit", fill: theme.bad, font: `600 11px ${theme.font}`, stroke: theme.paper, lineWidth: 3, align: "left", verticalAlign: layout.flat ? "bottom" : "middle", x: from[0] + (layout.flat ? 2 : 7), y: from[1] - (layout.flat ? 6 : 0) };
    const edge = layout.flat ? { x1: from[0], x2: from[0], y1: from[1] - 7, y2: from[1] + 7 } : { x1: from[0] - 6, x2: from[0] + 6, y1: from[1], y2: from[1] };
    return [
      { type: "line", shape: { x1: from[0], y1: from[1], x2: to[0], y2: to[1] }, style: { stroke: theme.bad, lineWidth: 5, opacity: 0.55 } },
      { type: "line", shape: edge, style: { stroke: theme.bad, lineWidth: 2 } },
      { type: "text", style: word },
    ];
  });
}

function rangeMark(study, theme, axis, layout, i) {
  const range = study.selection.ranges.get(axis.column.name);
  if (!range) return [];
  const parts = range.map((value) => (axis.column.isText ? value / Math.max(1, axis.column.distinct.length - 1) : axis.at(value))).map((part) => Math.min(1, Math.max(0, part ?? 0)));
  const [from, to] = parts.map((part) => layout.point(i, part));
  const half = 6;
  const shape = layout.flat ? { x: from[0] - 1, y: from[1] - half, width: to[0] - from[0] + 2, height: 2 * half } : { x: from[0] - half, y: to[1] - 1, width: 2 * half, height: from[1] - to[1] + 2 };
  return [{ type: "rect", shape, style: { fill: theme.accent, opacity: 0.3, stroke: theme.accent, lineWidth: 1 } }];
}

function axisSeries(study, theme, axes, layout) {
  return {
    type: "custom", coordinateSystem: "none", silent: true, z: 5, data: axes.map((_, i) => [i]),
    renderItem: (params, api) => {
      const i = api.value(0);
      const axis = axes[i];
      const [[x1, y1], [x2, y2]] = [layout.point(i, 0), layout.point(i, 1)];
      const line = { type: "line", shape: { x1, y1, x2, y2 }, style: { stroke: theme.soft, lineWidth: 1.2 } };
      return { type: "group", children: [line, ...boundMarks(theme, axis, layout, i), ...rangeMark(study, theme, axis, layout, i), ...tickMarks(theme, axis, layout, i), axisTitle(theme, axis, layout, i)] };
    },
  };
}

function axesOf(study, columns) {
  return columns.map((column) => ({ ...scaleOf(column), bounds: study.scenarios.inputs.includes(column) ? [] : boundsOf(study, column) }));
}

function optionOf(study, theme, axes, layout) {
  const { shown, pale } = rowsDrawn(study);
  const opacity = shown.length < 80 ? 0.8 : shown.length < 400 ? 0.45 : 0.24;
  const colour = (row) => outcomeColour(study.scenarios.at("outcome", row));
  return {
    tooltip: { trigger: "item", formatter: ({ data }) => scenarioTip(study, data[0]) },
    series: [
      ...(pale.length ? [lineSeries(axes, layout, pale, () => ({ stroke: theme.soft, lineWidth: 1, opacity: 0.09 }), true)] : []),
      lineSeries(axes, layout, shown, (row) => ({ stroke: colour(row), lineWidth: 1.3, opacity }), false),
      axisSeries(study, theme, axes, layout),
    ],
  };
}

function brushOf(study, current, canvas) {
  let chosen = null;
  const layout = () => layoutOf(canvas.getWidth(), current());
  return {
    touch: true,
    inside: (x, y) => { chosen = layout().axis([x, y]); return chosen !== null; },
    shape: (from, to) => {
      const { flat, across } = layout();
      const at = across(chosen);
      return flat ? rectangle([from[0], at - 9], [to[0], at + 9]) : rectangle([at - 9, from[1]], [at + 9, to[1]]);
    },
    done: (from, to) => {
      const axis = current()[chosen];
      if (!axis) return;
      const range = to ? [from, to].map((each) => axis.value(layout().part(each))) : null;
      if (range || study.selection.ranges.has(axis.column.name)) study.selection.setRanges([[axis.column, range]]);
    },
  };
}

function chooser(study, chosen, change) {
  return h("details", { class: "chooser" }, h("summary", {}, "Axes"), h("div", {}, candidates(study).map((column) => {
    const box = h("input", { type: "checkbox", onchange: () => change(column, box.checked) });
    box.checked = chosen.includes(column);
    return h("label", { title: column.longName || null }, box, label(column.name));
  })));
}

function noteOf(study) {
  const { selected, shown } = rowsDrawn(study);
  const drawn = shown.length < selected.length ? ` ${thousands(shown.length)} of ${plural(selected.length, "line")} are drawn, evenly picked.` : "";
  return `A drag along an axis selects a range of it, a click on the axis lets it go. Thick red: what a limit or a constraint forbids.${drawn}`;
}

/** What a range of each axis says, for who does not see the lines. */
function describe(study, axes) {
  const ranges = axes.map(({ column }) => (column.isText ? `${label(column.name)}: ${plural(column.distinct.length, "value")}` : `${label(column.name)} from ${quantity(column.distinct[0], column.units)} to ${quantity(column.distinct[column.distinct.length - 1], column.units)}`));
  return `${plural(study.scenarios.rows, "scenario")} as lines through ${listed(ranges)}. The table of scenarios holds the same values.`;
}

export function parallel(study) {
  let columns = firstChoice(study);
  if (study.scenarios.rows < 4 || columns.length < 3) return null;
  let axes = axesOf(study, columns);
  const all = candidates(study);
  const change = (column, on) => {
    columns = all.filter((each) => (each === column ? on : columns.includes(each)));
    axes = axesOf(study, columns);
    chart.redraw();
  };
  const chart = figure({
    height: (width) => layoutOf(width, axes).height,
    name: `${study.name} all axes`,
    selection: study.selection,
    rowOf: ({ data }) => data?.[0] ?? null,
    litAt: (row, shown) => pieces(axes, layoutOf(shown.getWidth(), axes), row).map((points) => ({ path: points })),
    brush: Object.assign((shown) => brushOf(study, () => axes, shown), { touch: true }),
    pick: ({ data }) => Array.isArray(data) && copyReplay(study, study.scenarios.at("id", data[0])),
    csv: () => [["id", "outcome", ...columns.map((column) => column.name)], ...rowsDrawn(study).selected.map((row) => [study.scenarios.at("id", row), study.scenarios.at("outcome", row), ...columns.map((column) => column.at(row))])],
    legend: outcomeList(OUTCOMES.filter((word) => study.scenarios.counts[word]), null, study.selection),
    option: (theme, width) => optionOf(study, theme, axes, layoutOf(width, axes)),
    describe: () => describe(study, axes),
    note: () => noteOf(study),
    below: chooser(study, columns, change),
  });
  return chart.element;
}

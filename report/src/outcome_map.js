// Outcomes over two quantities: cells where the study is a grid, marks where it is not.

import { axis, figure, logAxis, wantsLog } from "./chart.js";
import { rectangle } from "./chart_overlay.js";
import { h, select } from "./dom.js";
import { heldWords, judgesDamage } from "./claims.js";
import { outcomeList } from "./legend.js";
import { copyReplay, scenarioTip } from "./scenario.js";
import { label, OUTCOMES, outcomeLabel, plural, SERIOUSNESS, shortText, valueText } from "./words.js";
import { extent } from "./statistics.js";
import { OUTCOME_SYMBOLS, outcomeColour } from "./theme.js";

const GRIP = "strategy.grip_force_N";
const SPEED = "strategy.approach_speed_m_s";
const RANDOM_KINDS = new Set(["sample", "compare", "sensitivity", "robust"]);
const TELLING = ["friction_margin_min", "contact_yield_ratio_max", "permanent_set_max_m", "cycle_time_s"];
const GRID_MOST = 260;
const SLICE_MOST = 60;
/** How much is left of what is not selected. */
const FADED = 0.13;

/** Inputs and metrics that vary and are numbers. */
function choices(study) {
  const { scenarios } = study;
  const inputs = scenarios.inputs.filter((column) => column.varies);
  const metrics = scenarios.metrics.filter((column) => !column.isText && column.varies && !column.name.endsWith("iterations") && column.name !== "step_count");
  return { inputs, metrics };
}

/** A random study is read as metric over the input with most values, a chosen one over its strategy. */
function defaults(study, { inputs: all, metrics }) {
  const inputs = all.filter((column) => !column.isNearlyConstant);
  const named = (name) => inputs.find((column) => column.name === name);
  const numeric = inputs.filter((column) => !column.isText);
  if (RANDOM_KINDS.has(study.kind) && numeric.length) {
    const y = TELLING.map((name) => metrics.find((column) => column.name === name)).find(Boolean);
    const x = [...numeric].sort((a, b) => b.distinct.length - a.distinct.length)[0];
    if (y) return { x: study.kind === "robust" ? named(GRIP) ?? numeric[0] : x, y };
  }
  const x = named(GRIP) ?? numeric[0] ?? inputs[0] ?? metrics[0];
  const y = (x?.name !== SPEED ? named(SPEED) : null) ?? inputs.find((column) => column !== x) ?? metrics.find((column) => column.name === "cycle_time_s" && column !== x) ?? metrics.find((column) => column !== x);
  return { x, y };
}

/** Is the study a grid over these two, so that cells can be told apart? */
function isGrid(study, x, y, slices) {
  const { scenarios } = study;
  if (study.kind !== "sweep" || !scenarios.inputs.includes(x) || !scenarios.inputs.includes(y)) return false;
  const cells = x.distinct.length * y.distinct.length * slices.reduce((product, column) => product * column.distinct.length, 1);
  return x.distinct.length <= GRID_MOST && y.distinct.length <= GRID_MOST && cells <= 2 * scenarios.rows;
}

/** Rows of the chosen slice. */
function chosenRows(study, slices, slice) {
  const rows = [];
  for (let row = 0; row < study.scenarios.rows; row += 1) {
    if (slices.every((column) => slice.get(column.name) === undefined || column.at(row) === slice.get(column.name))) rows.push(row);
  }
  return rows;
}

/** Per cell the most serious outcome and how many scenarios share it; of those selected where there are some. */
function cellsOf(study, x, y, rows) {
  const { selection } = study;
  const xIndex = new Map(x.distinct.map((value, i) => [value, i]));
  const yIndex = new Map(y.distinct.map((value, i) => [value, i]));
  const cells = new Map();
  for (const row of rows) {
    const i = xIndex.get(x.at(row));
    const j = yIndex.get(y.at(row));
    if (i === undefined || j === undefined) continue;
    const key = i * 4096 + j;
    const cell = cells.get(key);
    const outcome = study.scenarios.at("outcome", row);
    const faded = !selection.has(row);
    if (!cell || (cell.faded && !faded)) cells.set(key, { i, j, row, outcome, faded, count: 1 });
    else if (faded === cell.faded) {
      cell.count += 1;
      if (SERIOUSNESS.indexOf(outcome) < SERIOUSNESS.indexOf(cell.outcome)) Object.assign(cell, { row, outcome });
    }
  }
  return [...cells.values()];
}

function indexAxis(theme, column, vertical) {
  const texts = column.distinct.map((value) => (typeof value === "number" ? String(value) : shortText(value)));
  const base = axis(theme, { name: label(column.name), units: column.units, most: column.isText ? 0 : Math.max(...column.distinct.map(Math.abs)), type: "category", vertical });
  const format = base.axisLabel.formatter;
  return { ...base, data: texts, axisLabel: { ...base.axisLabel, formatter: (text) => format(column.isText ? text : Number(text)) }, axisLine: { show: false }, boundaryGap: true };
}

/** The border of a window runs between two neighbouring grid values. */
function borderSeries(study, theme, x, y, slices, slice, name, dashed) {
  const { window } = study;
  if (!window || x.name !== GRIP || !window.inputs.some((column) => column.name === y.name)) return null;
  const data = [];
  for (let row = 0; row < window.rows; row += 1) {
    const fits = window.inputs.every((column) => column.name === y.name || column.at(row) === slice.get(column.name));
    if (!fits) continue;
    const low = window.at(`${name}_bracket_low_N`, row);
    const high = window.at(`${name}_bracket_high_N`, row);
    if (low === null && high === null) continue;
    const at = high === null ? x.distinct.length - 0.5 : low === null ? -0.5 : (x.distinct.indexOf(low) + x.distinct.indexOf(high)) / 2;
    data.push([at, y.distinct.indexOf(window.at(y.name, row))]);
  }
  if (slices.some((column) => slice.get(column.name) === undefined)) return null;
  data.sort((a, b) => a[1] - b[1]);
  return {
    type: "custom",
    silent: true,
    z: 5,
    data: [data.flat()],
    renderItem: (params, api) => {
      const points = [];
      for (const [at, j] of data) {
        const [left, width] = [api.coord([0, j])[0], api.size([1, 1])[0]];
        const [, middle] = api.coord([0, j]);
        const half = api.size([1, 1])[1] / 2;
        const px = left + at * width;
        points.push([px, middle + half], [px, middle - half]);
      }
      const shape = { points };
      return {
        type: "group",
        children: [
          { type: "polyline", shape, style: { stroke: theme.paper, lineWidth: 5, fill: "none" } },
          { type: "polyline", shape, style: { stroke: theme.ink, lineWidth: 2.2, fill: "none", lineDash: dashed ? [7, 3] : null } },
        ],
      };
    },
  };
}

function gridOption(study, theme, state) {
  const { x, y, slices, slice } = state;
  const cells = cellsOf(study, x, y, chosenRows(study, slices, slice));
  const dense = cells.length > 4000;
  return {
    grid: { left: 8, right: 12, top: 34, bottom: 44, containLabel: true },
    xAxis: indexAxis(theme, x, false),
    yAxis: indexAxis(theme, y, true),
    tooltip: {
      trigger: "item",
      formatter: ({ data }) => {
        const cell = cells[data[2]];
        return scenarioTip(study, cell.row, cell.count > 1 ? [h("p", {}, `the most serious of ${plural(cell.count, "scenario")} here`)] : []);
      },
    },
    series: [
      {
        type: "custom",
        progressive: 0,
        data: cells.map((cell, index) => [cell.i, cell.j, index]),
        encode: { x: 0, y: 1 },
        renderItem: (params, api) => {
          const cell = cells[api.value(2)];
          const [px, py] = api.coord([cell.i, cell.j]);
          const [width, height] = api.size([1, 1]);
          const gap = dense ? 0 : 1;
          const best = cell.row === study.bestRow && study.kind === "sweep";
          const rect = {
            type: "rect",
            shape: { x: px - width / 2 + gap / 2, y: py - height / 2 + gap / 2, width: width - gap, height: height - gap, r: dense ? 0 : 1.5 },
            style: { fill: outcomeColour(cell.outcome), opacity: cell.faded ? FADED : 1, stroke: cell.outcome === "not_run" ? theme.line : undefined },
            emphasis: { style: { stroke: theme.ink, lineWidth: 2 } },
          };
          if (!best) return rect;
          const ring = { type: "circle", shape: { cx: px, cy: py, r: Math.min(width, height, 16) / 3 }, style: { fill: "none", stroke: "#ffffff", lineWidth: 2.4 }, silent: true };
          return { type: "group", children: [rect, ring] };
        },
      },
      borderSeries(study, theme, x, y, slices, slice, "hold", false),
      judgesDamage(study) ? borderSeries(study, theme, x, y, slices, slice, "damage", true) : null,
    ].filter(Boolean),
    cells,
  };
}

export function valueAxis(theme, column, name, vertical, values = null) {
  const [least, most] = extent(values ?? column.numbers()) ?? [0, 1];
  const log = wantsLog(column.distinct.length > 3 ? column.distinct : []);
  const span = most - least;
  return axis(theme, {
    name,
    units: column.units,
    most: Math.max(Math.abs(least), Math.abs(most)),
    vertical,
    scale: true,
    ...(log ? logAxis(least, most) : { min: (range) => (range.min >= 0 && range.min < 0.25 * span ? 0 : undefined) }),
  });
}

/** Few values of an input are places side by side, not points of a scale. */
const PLACES_MOST = 12;

function isPlaced(study, column) {
  return column.isText || (study.scenarios.inputs.includes(column) && column.distinct.length <= PLACES_MOST);
}

/** Where a scenario stands along an axis: its value, or the number of its place. */
function placeOn(column, placed) {
  if (!placed) return (row) => column.at(row);
  const index = new Map(column.distinct.map((value, i) => [value, i]));
  return (row) => index.get(column.at(row)) ?? null;
}

/** A drag selects what lies in it: a range of each axis, of places those it covers. */
function mapBrush(study, current, chart) {
  const grid = { gridIndex: 0 };
  const range = (column, placed, [from, to]) => {
    if (!placed) return [from, to];
    const last = column.distinct.length - 1;
    const ends = [from, to].map((at) => Math.min(last, Math.max(0, Math.round(at))));
    return column.isText ? ends : ends.map((at) => column.distinct[at]);
  };
  return {
    inside: (px, py) => chart.containPixel(grid, [px, py]),
    shape: rectangle,
    done: (from, to) => {
      if (!to) return;
      const { x, y, grid: isGridMap } = current();
      const [a, b] = [from, to].map((at) => chart.convertFromPixel(grid, at));
      study.selection.setRanges([[x, range(x, isGridMap || isPlaced(study, x), [a[0], b[0]])], [y, range(y, isGridMap || isPlaced(study, y), [a[1], b[1]])]]);
    },
  };
}

/** Where a scenario stands on the map, if it is shown. */
function mapPlace(study, { x, y, grid, slices, slice }, row, chart) {
  if (slices.some((column) => slice.get(column.name) !== undefined && column.at(row) !== slice.get(column.name))) return [];
  const values = [x, y].map((column) => placeOn(column, grid || isPlaced(study, column))(row));
  return values.includes(null) ? [] : [{ at: chart.convertToPixel({ gridIndex: 0 }, values) }];
}

function mapCsv(study, { x, y, slices, slice }) {
  const { scenarios } = study;
  const names = [scenarios.column("id"), scenarios.column("outcome"), x, y];
  return [names.map((column) => column.name), ...chosenRows(study, slices, slice).filter((row) => study.selection.has(row)).map((row) => names.map((column) => column.at(row)))];
}

function marksOption(study, theme, state) {
  const { x, y, slices, slice } = state;
  const place = (column) => placeOn(column, isPlaced(study, column));
  const [xOf, yOf] = [place(x), place(y)];
  const rows = chosenRows(study, slices, slice);
  const { selection } = study;
  const pointsWhere = (test) => rows.filter(test).map((row) => [xOf(row), yOf(row), row]).filter(([a, b]) => a !== null && b !== null);
  const others = selection.active ? pointsWhere((row) => !selection.has(row)) : [];
  const series = OUTCOMES.map((word) => {
    const data = pointsWhere((row) => study.scenarios.at("outcome", row) === word && selection.has(row));
    const many = rows.length > 3000;
    return {
      type: "scatter",
      name: outcomeLabel(word),
      symbol: many ? "circle" : OUTCOME_SYMBOLS[word],
      symbolSize: many ? 3.5 : rows.length > 400 ? 7 : 10,
      large: data.length > 4000,
      largeThreshold: 4000,
      itemStyle: { color: outcomeColour(word), opacity: many ? 0.75 : 0.92, borderColor: word === "not_run" ? theme.soft : theme.paper, borderWidth: many ? 0 : 0.8 },
      emphasis: { scale: 1.5 },
      data,
    };
  }).filter((each) => each.data.length);
  const typed = (column, vertical) => (isPlaced(study, column) ? indexAxis(theme, column, vertical) : valueAxis(theme, column, label(column.name), vertical));
  return {
    grid: { left: 8, right: 20, top: 34, bottom: 44, containLabel: true },
    xAxis: typed(x, false),
    yAxis: typed(y, true),
    tooltip: { trigger: "item", formatter: ({ data }) => scenarioTip(study, data[2], metricLines(study, state, data[2])) },
    series: others.length ? [{ type: "scatter", name: "not selected", silent: true, symbolSize: rows.length > 400 ? 3.5 : 6, large: others.length > 4000, itemStyle: { color: theme.soft, opacity: 0.22 }, data: others }, ...series] : series,
  };
}

function metricLines(study, { x, y }, row) {
  return [x, y]
    .filter((column) => !study.scenarios.inputs.includes(column))
    .map((column) => h("div", { class: "tip-line" }, h("span", {}, label(column.name)), h("b", {}, valueText(column, column.at(row)))));
}

/** The value of a remaining key that is shown first: that of the best scenario, else the middle one. */
function firstSlice(study, column) {
  if (study.bestRow !== null) return column.at(study.bestRow);
  return column.distinct[Math.floor((column.distinct.length - 1) / 2)];
}

function prepare(study, x, y) {
  const others = study.scenarios.inputs.filter((column) => column.varies && column !== x && column !== y);
  const grid = isGrid(study, x, y, others);
  const slices = grid ? others.filter((column) => column.distinct.length <= SLICE_MOST) : [];
  return { x, y, slices, grid, slice: new Map(slices.map((column) => [column.name, firstSlice(study, column)])) };
}

function sliceControls(state, redraw) {
  return state.slices.map((column) =>
    select(
      label(column.name),
      [{ value: "all", label: "all: the most serious" }, ...column.distinct.map((value, i) => ({ value: String(i), label: column.isText ? shortText(value) : valueText(column, value) }))],
      String(column.distinct.indexOf(state.slice.get(column.name))),
      (chosen) => {
        state.slice.set(column.name, chosen === "all" ? undefined : column.distinct[Number(chosen)]);
        redraw();
      },
    ),
  );
}

export function outcomeMap(study) {
  const available = choices(study);
  let { x, y } = defaults(study, available);
  if (!x || !y || study.scenarios.rows < 2) return null;
  let state = prepare(study, x, y);
  let cells = [];
  const options = [...available.inputs.map((column) => ({ value: column.name, label: label(column.name), group: "inputs" })), ...available.metrics.map((column) => ({ value: column.name, label: label(column.name), group: "metrics" }))];
  const named = (name) => study.scenarios.column(name);
  const sliceBox = h("span", { class: "controls inner" });
  const change = () => {
    state = prepare(study, x, y);
    sliceBox.replaceChildren(...sliceControls(state, () => chart.redraw()));
    chart.redraw();
  };
  const chart = figure({
    height: (width) => Math.max(300, Math.min(520, width * (state.grid ? 0.52 : 0.58))),
    controls: [
      select("Across", options, x.name, (name) => { x = named(name); change(); }),
      select("Upwards", options, y.name, (name) => { y = named(name); change(); }),
      sliceBox,
    ],
    legend: outcomeList(OUTCOMES.filter((word) => study.scenarios.counts[word]), null, study.selection),
    name: `${study.name} outcomes`,
    selection: study.selection,
    rowOf: ({ data }) => (Array.isArray(data) ? (state.grid ? cells[data[2]]?.row ?? null : data[2] ?? null) : null),
    litAt: (row, shown) => mapPlace(study, state, row, shown),
    brush: (shown) => mapBrush(study, () => state, shown),
    csv: () => mapCsv(study, state),
    option: (theme) => {
      const option = state.grid ? gridOption(study, theme, state) : marksOption(study, theme, state);
      cells = option.cells ?? [];
      delete option.cells;
      return option;
    },
    describe: () => `Outcomes of ${plural(study.scenarios.rows, "scenario")} over ${label(state.x.name)} and ${label(state.y.name)}. The table of scenarios holds the same values.`,
    note: () => mapNote(study, state),
    pick: ({ data }) => {
      if (!Array.isArray(data)) return;
      copyReplay(study, study.scenarios.at("id", state.grid ? cells[data[2]].row : data[2]));
    },
  });
  sliceBox.append(...sliceControls(state, () => chart.redraw()));
  return chart.element;
}

function mapNote(study, { grid, x, y }) {
  if (!grid) return "";
  const parts = [];
  if (study.window && x.name === GRIP && study.window.inputs.some((column) => column.name === y.name)) parts.push(`Solid line: holding begins.${judgesDamage(study) ? " Dashed line: damage begins." : ""}`);
  if (study.bestRow !== null) parts.push(`Ring: the fastest cycle ${heldWords(study)}.`);
  return parts.join(" ");
}

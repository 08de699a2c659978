// The window of every combination: a bar from the force that holds to the force that damages.

import { axis, figure } from "./chart.js";
import { bracketText } from "./answer/window.js";
import { heldWords, judgesDamage } from "./claims.js";
import { legend } from "./legend.js";
import { inWords } from "./tables.js";
import { genericTable } from "./table.js";
import { tip, tipLine } from "./scenario.js";
import { h, select } from "./dom.js";
import { label, number, plural, scaleFor, shortText, valueText } from "./words.js";
import { outcomeColour } from "./theme.js";

function windowTip(study, window, row) {
  const at = (name) => window.at(name, row);
  return tip(
    h("div", { class: "tip-head" }, h("b", {}, at("exists") === 1 ? "grip window" : "no window")),
    window.inputs.map((column) => tipLine(label(column.name), column.isText ? shortText(column.at(row)) : valueText(column, column.at(row)))),
    h("hr"),
    tipLine("holding begins", bracketText(at("hold_bracket_low_N"), at("hold_bracket_high_N"))),
    judgesDamage(study) ? tipLine("damage begins", bracketText(at("damage_bracket_low_N"), at("damage_bracket_high_N"))) : null,
    at("set_point_exists") === 1 ? tipLine("set", `${number(at("set_point_N"))} N ± ${number(at("set_point_tolerance_N"))} N`) : null,
    at("margin") === null ? null : tipLine("damage over hold", `${number(at("margin") + 1, 3)} times`),
    at("note") ? h("p", {}, inWords(at("note"))) : null,
  );
}

function rowsOf(window, x, others, slice) {
  const rows = [];
  for (let row = 0; row < window.rows; row += 1) {
    if (others.every((column) => column.at(row) === slice.get(column.name))) rows.push(row);
  }
  return rows.sort((a, b) => (x.isText ? 0 : x.at(a) - x.at(b)));
}

function forces(window) {
  return ["hold_force_N", "damage_force_N", "hold_bracket_high_N", "damage_bracket_low_N", "hold_bracket_low_N", "damage_bracket_high_N"].flatMap((name) => window.column(name).numbers());
}

const sameInputs = new WeakMap();

/** The scenarios of each combination of the window's inputs. */
function scenariosOf(study, row) {
  const { window, scenarios } = study;
  if (!sameInputs.has(window)) {
    const columns = window.inputs.map((column) => [column, scenarios.column(column.name)]);
    const keyOf = (at) => JSON.stringify(columns.map(at));
    const found = new Map();
    if (columns.every(([, own]) => own)) {
      for (let each = 0; each < scenarios.rows; each += 1) {
        const key = keyOf(([, own]) => own.at(each));
        if (found.has(key)) found.get(key).push(each);
        else found.set(key, [each]);
      }
    }
    sameInputs.set(window, (one) => found.get(keyOf(([column]) => column.at(one))) ?? []);
  }
  return sameInputs.get(window)(row);
}

/** A bar none of whose scenarios is selected is faded. */
function isFaded(study, row) {
  return study.selection.active && !scenariosOf(study, row).some((each) => study.selection.has(each));
}

function barItem(study, theme, row, index, api, top) {
  const { window } = study;
  const judged = judgesDamage(study);
  const at = (name) => window.at(name, row);
  const width = Math.min(64, api.size([1, 0])[0] * 0.56);
  const px = api.coord([index, 0])[0] - width / 2;
  const y = (force) => api.coord([index, force])[1];
  const rect = (from, to, style) => ({ type: "rect", shape: { x: px, width, y: y(to), height: Math.max(1, y(from) - y(to)), r: 2 }, style });
  const rule = (force, colour) => ({ type: "rect", shape: { x: px - 4, width: width + 8, y: y(force) - 1.25, height: 2.5 }, style: { fill: colour } });
  const hold = at("hold_bracket_high_N") ?? at("hold_force_N");
  const damage = judged ? at("damage_bracket_low_N") ?? at("damage_force_N") : null;
  const children = [];
  if (at("exists") === 1) {
    children.push(rect(hold ?? 0, damage ?? top, { fill: outcomeColour("held"), opacity: 0.88 }));
    const low = at("hold_bracket_low_N");
    const high = at("damage_bracket_high_N");
    if (low !== null) children.push(rect(low, hold, { fill: outcomeColour("held"), opacity: 0.28 }));
    if (high !== null && judged) children.push(rect(damage, high, { fill: outcomeColour("held"), opacity: 0.28 }));
  } else {
    children.push({ type: "text", style: { x: px + width / 2, y: y(top * 0.5), text: width > 46 ? "no\nwindow" : "no window", rotation: width > 46 ? 0 : Math.PI / 2, align: "center", verticalAlign: "middle", fill: theme.soft, fontSize: 12, fontFamily: theme.font, lineHeight: 16 } });
    children.push({ type: "rect", shape: { x: px, width, y: y(top), height: y(0) - y(top), r: 2 }, style: { fill: theme.soft, opacity: 0.06 } });
  }
  if (at("hold_force_N") !== null) children.push(rule(at("hold_force_N"), outcomeColour("dropped")));
  if (at("damage_force_N") !== null && judged) children.push(rule(at("damage_force_N"), outcomeColour("damaged")));
  if (at("set_point_exists") === 1 && judged) children.push({ type: "polygon", shape: { points: [[0, -6], [6, 0], [0, 6], [-6, 0]].map(([right, down]) => [px + width / 2 + right, y(at("set_point_N")) + down]) }, style: { fill: theme.ink, stroke: theme.paper, lineWidth: 1.5 } });
  if (isFaded(study, row)) for (const child of children) child.style.opacity = 0.15 * (child.style.opacity ?? 1);
  return { type: "group", children };
}

const WINDOW_COLUMNS = ["exists", "hold_force_N", "damage_force_N", "hold_bracket_low_N", "hold_bracket_high_N", "damage_bracket_low_N", "damage_bracket_high_N", "set_point_N", "set_point_tolerance_N"];

/** What a chart of windows has for every one of them: how it is saved, and which bars hold a scenario. */
function windowParts(study, rowsShown) {
  const { window } = study;
  const columns = [...window.inputs, ...WINDOW_COLUMNS.map((name) => window.column(name)).filter(Boolean)];
  const hasRow = (row, scenario) => scenariosOf(study, row).includes(scenario);
  return {
    name: `${study.name} windows`,
    selection: study.selection,
    csv: () => [columns.map((column) => column.name), ...rowsShown().map((row) => columns.map((column) => column.at(row)))],
    litAt: (scenario, shown) => {
      const index = rowsShown().findIndex((row) => hasRow(row, scenario));
      const force = study.scenarios.at("strategy.grip_force_N", scenario);
      return index < 0 || force === null ? [] : [{ at: shown.convertToPixel({ gridIndex: 0 }, [index, force]) }];
    },
  };
}

/** Does every combination of the inputs' values occur? Inputs that vary together do not. */
function isProduct(window, inputs) {
  return window.rows === inputs.reduce((product, column) => product * column.distinct.length, 1);
}

function windowAxis(theme, top) {
  return axis(theme, { name: "grip force", units: "N", most: top, vertical: true, min: 0, max: top, axisLabel: { color: theme.soft, fontSize: 12, showMaxLabel: false, formatter: (value) => number(value, 3) } });
}

/** The numbers of one column share its unit, or an axis would mix two; the unit stands in the note below. */
function shortValue(column, row) {
  return column.isText ? shortText(column.at(row)) : number(column.at(row) / scaleFor(column.units, column.most).factor, 3);
}

/** "finger mass (kg)" */
function nameWithUnit(column) {
  const { unit } = scaleFor(column.isText ? "" : column.units, column.most);
  return unit ? `${label(column.name)} (${unit})` : label(column.name);
}

/** Few combinations, side by side, each with all its values. */
function allAtOnce(study, window, inputs) {
  const top = 1.04 * Math.max(...forces(window), 1e-9);
  const shown = Array.from({ length: Math.min(window.rows, 40) }, (_, row) => row);
  return figure({
    height: 380,
    ...windowParts(study, () => shown),
    option: (theme) => ({
      grid: { left: 8, right: 12, top: 34, bottom: 12, containLabel: true },
      xAxis: { ...axis(theme, { name: "", type: "category" }), data: shown.map((row) => inputs.map((column) => shortValue(column, row)).join("\n")), axisLabel: { color: theme.soft, fontSize: 12, lineHeight: 17, interval: 0 } },
      yAxis: windowAxis(theme, top),
      tooltip: { trigger: "item", formatter: ({ data }) => windowTip(study, window, data[2]) },
      series: [{ type: "custom", data: shown.map((row, index) => [index, top, row]), encode: { x: 0, y: 1 }, renderItem: (params, api) => barItem(study, theme, api.value(2), api.value(0), api, top) }],
    }),
    legend: (theme) => windowLegend(study, theme),
    describe: () => `Grip windows of ${plural(window.rows, "combination")}. The table below holds the same values.`,
    note: `Below each: ${inputs.map(nameWithUnit).join(", ")}.${shown.length < window.rows ? ` The first ${shown.length} of ${window.rows}.` : ""}`,
  }).element;
}

function windowLegend(study, theme) {
  return legend([
    [outcomeColour("held"), heldWords(study)],
    [outcomeColour("held"), "the border lies somewhere here", "pale"],
    [outcomeColour("dropped"), "holding begins", "line"],
    ...(judgesDamage(study) ? [[outcomeColour("damaged"), "damage begins", "line"]] : []),
    ...(study.window.column("set_point_exists")?.numbers().includes(1) && judgesDamage(study) ? [[theme.ink, "set here"]] : []),
  ]);
}

export function windows(study) {
  const { window } = study;
  if (!window || window.rows === 0) return null;
  const inputs = window.inputs.filter((column) => column.varies);
  const table = h("details", {}, h("summary", {}, "As a table"), genericTable(study, window, { name: "window", hide: ["exists"] }));
  if (inputs.length > 1 && (window.rows <= 12 || !isProduct(window, inputs))) return h("div", {}, allAtOnce(study, window, inputs), table);
  if (inputs.length === 0) return h("div", {}, genericTable(study, window, { name: "window", hide: ["exists"] }));
  let x = inputs.find((column) => !column.isText) ?? inputs[0];
  let others = [];
  const slice = new Map();
  const top = 1.04 * Math.max(...forces(window), 1e-9);
  const sliceBox = h("span", { class: "controls inner" });
  const prepare = () => {
    others = inputs.filter((column) => column !== x);
    for (const column of others) if (!slice.has(column.name)) slice.set(column.name, column.distinct[0]);
    sliceBox.replaceChildren(
      ...others.map((column) =>
        select(label(column.name), column.distinct.map((value, i) => ({ value: String(i), label: column.isText ? shortText(value) : valueText(column, value) })), String(column.distinct.indexOf(slice.get(column.name))), (chosen) => {
          slice.set(column.name, column.distinct[Number(chosen)]);
          chart.redraw();
        }),
      ),
    );
  };
  const chart = figure({
    height: 360,
    ...windowParts(study, () => rowsOf(window, x, others, slice)),
    controls: inputs.length > 1 ? [select("Across", inputs.map((column) => ({ value: column.name, label: label(column.name) })), x.name, (name) => { x = window.column(name); prepare(); chart.redraw(); }), sliceBox] : [],
    option: (theme) => {
      const rows = rowsOf(window, x, others, slice);
      const base = axis(theme, { name: label(x.name), units: x.units, most: x.isText ? 0 : Math.max(...x.numbers().map(Math.abs)), type: "category" });
      const format = base.axisLabel.formatter;
      return {
        grid: { left: 8, right: 12, top: 34, bottom: 44, containLabel: true },
        xAxis: { ...base, data: rows.map((row) => String(x.at(row))), axisLabel: { ...base.axisLabel, formatter: (text) => (x.isText ? shortText(text) : format(Number(text))) } },
        yAxis: windowAxis(theme, top),
        tooltip: { trigger: "item", formatter: ({ data }) => windowTip(study, window, data[2]) },
        series: [{ type: "custom", data: rows.map((row, index) => [index, top, row]), encode: { x: 0, y: 1 }, renderItem: (params, api) => barItem(study, theme, api.value(2), api.value(0), api, top) }],
      };
    },
    describe: () => `Grip windows of ${plural(window.rows, "combination")} over ${label(x.name)}. The table below holds the same values.`,
    legend: (theme) => windowLegend(study, theme),
  });
  prepare();
  return h("div", {}, chart.element, table);
}

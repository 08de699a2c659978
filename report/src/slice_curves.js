// Which points a slice shows: those of a grid through its best scenario, those a search tried, or groups of random scenarios.

import { heldWords } from "./claims.js";
import { scenarioRow } from "./convergence.js";
import { readGoal } from "./goals.js";
import { boundsOf } from "./scale.js";
import { quantile, wilson } from "./statistics.js";
import { keyColumns, objectiveColumns, objectiveLabel, objectiveUnits, rowsOf, inWords, unitsOfGoal } from "./tables.js";
import { label, quantity, shortText } from "./words.js";

const TELLING = ["friction_margin_min", "contact_yield_ratio_max", "permanent_set_max_m", "peak_finger_force_N", "slip_max_m", "cycle_time_s"];
const GROUPS = 8;
const CURVES_MOST = 6;
/** Of a variable's range: so far from the best a tried strategy is faint. */
export const NEAR = 0.3;

function metricOf(column) {
  return { name: column.name, label: label(column.name), units: column.units, column };
}

function metricsOf({ scenarios }) {
  const varying = scenarios.metrics.filter((column) => !column.isText && column.varies && column.name !== "step_count");
  const telling = TELLING.map((name) => varying.find((column) => column.name === name)).filter(Boolean);
  return [...telling, ...varying.filter((column) => !telling.includes(column))].map(metricOf);
}

function isGrid(study, inputs) {
  return study.kind === "sweep" && inputs.length > 0 && inputs.reduce((product, column) => product * column.distinct.length, 1) <= 2 * study.scenarios.rows;
}

const known = new WeakMap();

/** Where the points of a study's slices come from: { kind: "grid" | "search" | "random" | "none", metrics, ... } */
export function sourceOf(study) {
  if (!known.has(study)) known.set(study, readSource(study));
  return known.get(study);
}

function readSource(study) {
  const { scenarios } = study;
  const inputs = scenarios.inputs.filter((column) => column.varies && !column.isNearlyConstant);
  const evaluations = study.tables.get("evaluations");
  if (evaluations?.rows && study.tables.get("best")?.rows) return searchSource(study, evaluations);
  if (isGrid(study, inputs)) {
    const best = study.bestRow ?? Math.floor(scenarios.rows / 2);
    return { kind: "grid", inputs, best, hasBest: study.bestRow !== null, metrics: [...metricsOf(study), ...marginMetric(study)] };
  }
  const random = inputs.filter((column) => !column.isText && column.distinct.length > 2 * GROUPS);
  if (["sample", "sensitivity", "compare"].includes(study.kind) && random.length && scenarios.rows >= 5 * GROUPS) {
    return { kind: "random", inputs: random.slice(0, CURVES_MOST), metrics: [{ name: "held", label: `P(${heldWords(study)})`, units: "", isShare: true, bounds: [] }, ...metricsOf(study)] };
  }
  if (study.window && study.window.rows > 1 && marginMetric(study).length) return { kind: "grid", inputs: [], best: null, hasBest: false, metrics: marginMetric(study) };
  return { kind: "none", metrics: [] };
}

/** The margin of the windows, where it varies with another input than the grip force. */
function marginMetric({ window }) {
  const column = window?.column("margin");
  if (!column || column.numbers().length < 2 || !window.inputs.some((each) => each.varies)) return [];
  return [{ name: "margin", label: "margin of the window", units: "", ofWindow: true, bounds: [{ bound: 0, least: true }] }];
}

/** What is asked of the probability that the evaluations tell: [{ bound, least }]. */
function chanceBounds(study, event) {
  const constraints = study.tables.get("constraints");
  return rowsOf(constraints).map((row) => readGoal(study, constraints.at("text", row))).filter((goal) => goal && goal.chance === event && goal.bound !== null).map(({ bound, sign }) => ({ bound, least: sign.startsWith(">") }));
}

function searchSource(study, table) {
  const best = study.tables.get("best");
  const keys = keyColumns(table).filter((column) => !column.isText && column.varies).slice(0, CURVES_MOST);
  const objective = table.column("objective");
  const text = best.attributes?.objective ?? objective?.longName ?? "";
  const objectiveBounds = study.scenarios.column(text) && study.kind !== "robust" ? boundsOf(study, study.scenarios.column(text)) : [];
  const objectives = objective ? [{ name: "objective", label: inWords(text || "objective"), units: objective.units || unitsOfGoal(study, text), from: objective, bounds: objectiveBounds }] : objectiveColumns(table).map((column) => ({ name: column.name, label: objectiveLabel(column), units: objectiveUnits(study, column), from: column, bounds: [] }));
  const probability = table.column("probability");
  const event = /P\((.*)\)/.exec(probability?.longName ?? "")?.[1] ?? "held";
  const chance = probability && probability.numbers().length ? [{ name: "probability", label: `P(${event})`, units: "", isShare: true, from: probability, bounds: chanceBounds(study, event) }] : [];
  // Of a robust study an evaluation is many products, so no metric of one of them speaks for it.
  const metrics = study.kind === "robust" ? [] : metricsOf(study);
  return { kind: "search", table, keys, best, metrics: [...objectives, ...chance, ...metrics] };
}

/** How far a tried strategy is from the best in all variables but `shown`, in parts of what was tried of each. */
export function distanceToBest({ keys, best }, shown) {
  const others = keys.filter((each) => !shown.includes(each));
  const span = (each) => each.distinct[each.distinct.length - 1] - each.distinct[0] || 1;
  return (row) => Math.hypot(...others.map((each) => (each.at(row) - best.at(each.name, 0)) / span(each)));
}

/** What an evaluation gave of a metric; null where it has none. */
export function triedValue(study, { table }, metric, row) {
  if (metric.from) return metric.from.at(row);
  const scenario = scenarioRow(study, table, row);
  return scenario === null ? null : metric.column.at(scenario);
}

/** @returns curves [{ column, points: [{ x, y, row, weight, low, high, count, words }], best, joined }] */
export function curvesOf(study, source, metric) {
  if (source.kind === "search") return source.keys.map((column) => triedNear(study, source, metric, column));
  if (source.kind === "random") return source.inputs.map((column) => grouped(study, metric, column));
  const curves = metric.ofWindow ? marginCurves(study, source) : source.inputs.map((column) => throughBest(study, source, metric, column));
  return curves.filter((curve) => curve.points.length > 1).slice(0, CURVES_MOST);
}

/** The scenarios that share all other inputs with the best. */
function throughBest(study, { inputs, best, hasBest }, metric, column) {
  const others = inputs.filter((each) => each !== column);
  const rows = rowsOf(study.scenarios).filter((row) => others.every((each) => each.at(row) === each.at(best)));
  const place = (row) => (column.isText ? column.distinct.indexOf(column.at(row)) : column.at(row));
  const points = rows.map((row) => ({ x: place(row), y: metric.column.at(row), row })).sort((a, b) => a.x - b.x);
  return { column, points, best: hasBest ? column.at(best) : null, joined: !column.isText };
}

/** The margin over each input of the windows, through the row of the best, else the middle one. */
function marginCurves({ window, scenarios }, { best }) {
  const inputs = window.inputs.filter((column) => column.varies);
  const at = (column) => (best === null ? null : scenarios.at(column.name, best));
  const fits = (row) => inputs.every((column) => at(column) === null || column.at(row) === at(column));
  const middle = rowsOf(window).find(fits) ?? Math.floor(window.rows / 2);
  return inputs.map((column) => {
    const others = inputs.filter((each) => each !== column);
    const rows = rowsOf(window).filter((row) => others.every((each) => each.at(row) === each.at(middle)));
    const points = rows.map((row) => ({ x: column.isText ? column.distinct.indexOf(column.at(row)) : column.at(row), y: window.at("margin", row), row: null, words: column.isText ? shortText(column.at(row)) : undefined }));
    return { column, points: points.sort((a, b) => a.x - b.x), best: column.at(middle), joined: !column.isText };
  });
}

/** What was tried, the fainter the further it is from the best in the other variables. */
function triedNear(study, source, metric, column) {
  const { table, best } = source;
  const distance = distanceToBest(source, [column]);
  const points = rowsOf(table)
    .map((row) => ({ x: column.at(row), y: triedValue(study, source, metric, row), row: scenarioRow(study, table, row), weight: Math.max(0.08, Math.exp(-((distance(row) / NEAR) ** 2))) }))
    .filter(({ x, y }) => x !== null && y !== null);
  return { column, points: points.sort((a, b) => a.weight - b.weight), best: best.at(column.name, 0), joined: false };
}

/** Groups of equally many scenarios along an input; of those selected where something is selected. */
function grouped(study, metric, column) {
  const { scenarios, selection } = study;
  const rows = rowsOf(scenarios).filter((row) => column.at(row) !== null && selection.has(row)).sort((a, b) => column.at(a) - column.at(b));
  const count = Math.min(GROUPS, Math.floor(rows.length / 5));
  const groups = Array.from({ length: count }, (_, i) => rows.slice(Math.floor((i * rows.length) / count), Math.floor(((i + 1) * rows.length) / count)));
  const points = groups.map((group) => {
    const x = quantile(group.map((row) => column.at(row)), 0.5);
    const words = `${quantity(column.at(group[0]), column.units, 3)} to ${quantity(column.at(group[group.length - 1]), column.units, 3)}`;
    return { x, words, count: group.length, row: null, ...(metric.isShare ? share(scenarios, group) : spread(metric.column, group)) };
  });
  return { column, points: points.filter(({ y }) => y !== null), best: null, joined: true };
}

function share(scenarios, group) {
  const run = group.filter((row) => scenarios.at("outcome", row) !== "not_run");
  const held = run.filter((row) => scenarios.at("outcome", row) === "held").length;
  return run.length ? { y: held / run.length, ...wilson(held, run.length), spread: "95 % interval" } : { y: null };
}

function spread(column, group) {
  const values = group.map((row) => column.at(row)).filter((value) => value !== null).sort((a, b) => a - b);
  return { y: quantile(values, 0.5), low: quantile(values, 0.05), high: quantile(values, 0.95), spread: "5 % to 95 %" };
}

// How the program's tables are read: what their columns mean beside their names.

import { label, number } from "./words.js";

/** The variables of `best`, `pareto` or `evaluations`: columns that are dotted keys. */
export function keyColumns(table) {
  return table.columns.filter((column) => column.name.includes("."));
}

export function rowsOf(table) {
  return Array.from({ length: table?.rows ?? 0 }, (_, row) => row);
}

export function objectiveColumns(table) {
  return table.columns.filter((column) => /^objective_\d+$/.test(column.name));
}

function objectiveName(column) {
  return column.longName || column.name;
}

export function objectiveLabel(column) {
  return inWords(objectiveName(column));
}

/** "mean(cycle_time_s)" has the units of its metric. */
export function unitsOfGoal(study, text) {
  const metric = String(text).match(/[A-Za-z]\w*/g)?.find((word) => study.scenarios.column(word));
  return metric ? study.scenarios.column(metric).units : "";
}

export function objectiveUnits(study, column) {
  return column.units || unitsOfGoal(study, objectiveName(column));
}

/** "mean(cycle_time_s)" -> "mean cycle time"; what one is told to write into the study stays as it is written. */
export function inWords(text) {
  return String(text)
    .replace(/^(mean|median|min|max|least|greatest)\((\w+)\)$/, "$1 $2")
    .replace(/[A-Za-z]\w*(?:\.\w+)*_\w+/g, (name) => (name.startsWith("sampling.") ? name : label(name)));
}

/** "held" -> "being held", "not damaged" -> "not being damaged". */
export function eventWords(event) {
  return /^(not )?\w+$/.test(event) ? inWords(event).replace(/^(not )?/, "$1being ") : inWords(event);
}

/** Rows of `verification` that look at the strategy again; row 0 may be the strategy as found. */
export function isBroken(checks, row) {
  return checks.column("feasible") ? checks.at("feasible", row) === 0 : (checks.at("violation", row) ?? 0) > 0;
}

export function kneeRow(front) {
  return rowsOf(front).find((row) => front.at("knee", row) === 1) ?? null;
}

export function confidenceText(table) {
  const level = table?.attributes?.confidence;
  return typeof level === "number" ? `${number(level * 100)} % interval` : "confidence interval";
}

export function textAttribute(table, name, otherwise = "") {
  const text = table?.attributes?.[name];
  return typeof text === "string" && text ? text : otherwise;
}

/** Why a metric of a sensitivity study has no effects to tell, behind its name; empty where it has. */
export function effectNote(table, metric) {
  const row = rowsOf(table).find((each) => table.at("metric", each) === metric);
  return row === undefined ? "" : table.at("note", row) ?? "";
}

/** The metric a sensitivity study shows first: one that has effects, if there is one. */
export function firstMetric(table) {
  const metrics = table?.column("metric")?.distinct ?? [];
  return metrics.find((metric) => effects(table, metric).length > 0) ?? metrics[0];
}

/** Rows of one metric of a sensitivity study, most effective first, with the interval of the effect. */
export function effects(table, metric) {
  if (effectNote(table, metric)) return [];
  const name = table.column("mean_absolute") === null ? "total" : "mean_absolute";
  return rowsOf(table)
    .filter((row) => table.at("metric", row) === metric && table.at(name, row) !== null)
    .map((row) => ({ row, key: table.at("key", row), value: table.at(name, row), low: table.at(`${name}_low`, row), high: table.at(`${name}_high`, row) }))
    .sort((a, b) => b.value - a.value);
}

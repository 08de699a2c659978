// One axis of one quantity, from 0 to 1: linear, logarithmic, or places side by side. For charts that draw their own axes.

import { wantsLog } from "./chart.js";
import { boundOf } from "./claims.js";
import { readGoal } from "./goals.js";
import { rowsOf } from "./tables.js";
import { number, scaleFor, shortText } from "./words.js";

const NICE = [1, 2, 2.5, 5, 10];

/** Round values from `least` to `most`, about `count` of them. */
export function roundValues(least, most, count) {
  const raw = (most - least) / Math.max(1, count);
  if (!(raw > 0)) return [least];
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = NICE.map((each) => each * power).find((each) => each >= raw * 0.999);
  const values = [];
  for (let i = Math.ceil(least / step - 1e-9); i * step <= most + 1e-9 * step; i += 1) values.push(Number((i * step).toPrecision(12)));
  return values;
}

/** 1, 2, 5, 10 and so on, from `least` to `most`; of a long range powers of ten. */
export function logValues(least, most) {
  const values = [];
  for (let power = Math.floor(Math.log10(least)); power <= Math.ceil(Math.log10(most)); power += 1) for (const each of [1, 2, 5]) values.push(Number((each * 10 ** power).toPrecision(3)));
  const inside = values.filter((value) => value >= least * 0.999 && value <= most * 1.001);
  return inside.length > 6 ? inside.filter((value) => /^1(e|0*$)|^0\.0*1$/.test(String(value))) : inside;
}

/** @returns { column, log, at (value) => 0 to 1, value (part) => value, ticks: [[part, text]], unit, text (value) } */
export function scaleOf(column, { ticks = 4 } = {}) {
  if (column.isText) return placeScale(column);
  const { distinct } = column;
  const [least, most] = [distinct[0], distinct[distinct.length - 1]];
  const { factor, unit } = scaleFor(column.units, column.most);
  const text = (value) => number(value / factor, 3);
  if (wantsLog(distinct.length > 3 ? distinct : [])) {
    const [low, high] = [Math.log(least), Math.log(most)];
    const at = (value) => (value > 0 ? (Math.log(value) - low) / (high - low) : null);
    return { column, log: true, at, value: (part) => Math.exp(low + part * (high - low)), ticks: logValues(least, most).map((value) => [at(value), text(value)]), unit, text };
  }
  const span = most - least || Math.abs(most) || 1;
  const from = most > least ? least : least - span / 2;
  const at = (value) => (value - from) / span;
  return { column, log: false, at, value: (part) => from + part * span, ticks: roundValues(from, from + span, ticks).map((value) => [at(value), text(value)]), unit, text };
}

function placeScale(column) {
  const index = new Map(column.distinct.map((value, i) => [value, i]));
  const last = Math.max(1, column.distinct.length - 1);
  return { column, log: false, at: (value) => (index.has(value) ? index.get(value) / last : null), value: (part) => part * last, ticks: column.distinct.map((value, i) => [i / last, shortText(value)]), unit: "", text: shortText };
}

/** What a metric has to keep: [{ bound, least }], least: it must not be less. From limits that judge and constraints of a search. */
export function boundsOf(study, column) {
  const found = [];
  const limit = boundOf(study, column.name);
  if (limit !== null) found.push({ bound: limit, least: false });
  const constraints = study.tables.get("constraints");
  for (const row of rowsOf(constraints)) {
    const goal = readGoal(study, constraints.at("text", row));
    if (goal && goal.metric === column.name && goal.bound !== null) found.push({ bound: goal.bound, least: goal.sign.startsWith(">") });
  }
  return found.filter((each, i) => found.findIndex((other) => other.bound === each.bound && other.least === each.least) === i);
}

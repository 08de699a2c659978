// Constraints as the config writes them, in words, with what a strategy reached.

import { eventWords, inWords, unitsOfGoal } from "./tables.js";
import { label, percent, quantity } from "./words.js";

const SIGNS = { "<=": "at most", ">=": "at least", "<": "below", ">": "above" };
const RELATION = /^(?:(\w+): )?(.+?) (<=|>=|<|>) (\S+)$/;

/** { metric or event, sign, bound, units }; null where the text is no relation. */
export function readGoal(study, text) {
  const found = RELATION.exec(String(text ?? "").trim());
  if (!found) return null;
  const [, event, left, sign, right] = found;
  const chance = /^P\((.+)\)$/.exec(left);
  const limit = /^limits\.(\w+)$/.exec(right);
  const bound = limit ? study.limits[limit[1]] ?? null : Number(right);
  return { event, left, sign, chance: chance ? chance[1] : null, bound: Number.isFinite(bound) ? bound : null, units: chance ? "" : unitsOfGoal(study, left), metric: study.scenarios.column(left) ? left : null };
}

function boundText(goal) {
  if (goal.bound === null) return "its limit";
  return goal.chance === null ? quantity(goal.bound, goal.units) : percent(goal.bound);
}

function leftText(goal) {
  return goal.chance === null ? inWords(goal.left) : `probability of ${eventWords(goal.chance)}`;
}

/** "held: contact_yield_ratio_max <= limits.contact_yield_ratio" -> "contact yield ratio at most 1" */
export function goalWords(study, text) {
  const goal = readGoal(study, text);
  return goal ? `${leftText(goal)} ${SIGNS[goal.sign]} ${boundText(goal)}` : inWords(text ?? "");
}

/** By how much a strategy misses a goal: "contact yield ratio is 1.27; at most 1 is allowed". null where it is not known. */
export function missWords(study, text, reached) {
  const goal = readGoal(study, text);
  if (!goal || reached === null || reached === undefined || goal.bound === null) return null;
  const value = goal.chance === null ? quantity(reached, goal.units) : percent(reached);
  const allowed = goal.sign.startsWith("<") ? "is allowed" : "is asked for";
  const off = goal.bound !== 0 && goal.chance === null ? ` (off by ${percent(Math.abs(reached - goal.bound) / Math.abs(goal.bound))})` : "";
  return `${leftText(goal)} is ${value}; ${SIGNS[goal.sign]} ${boundText(goal)} ${allowed}${off}`;
}

/**
 * A probability that is asked for: is it met by the estimate, is it shown by the interval?
 * @param table, row of `constraints`
 * @returns null where the row is none of this, or nothing is known of its event
 */
export function chanceStanding(study, table, row) {
  const goal = readGoal(study, table?.at("text", row));
  if (!goal || goal.chance === null || goal.bound === null) return null;
  const best = study.tables.get("best");
  const own = table.at("estimate", row) !== null;
  if (!own && (best?.attributes.event ?? goal.chance) !== goal.chance) return null;
  const [estimate, low] = own ? [table.at("estimate", row), table.at("low", row)] : [best?.at("probability", 0) ?? null, best?.at("probability_low", 0) ?? null];
  if (estimate === null) return null;
  const shown = own ? table.at("shown", row) === 1 : low !== null && low >= goal.bound;
  return { goal, estimate, low, shown, met: estimate >= goal.bound, says: table.at("says", row) ?? "" };
}

/** The limit that an outcome's cause speaks of: { metric, value, bound, units }, or null. */
export function crossedLimit(study, row) {
  const found = /^(\w+) > limits\.(\w+)$/.exec(study.scenarios.at("cause", row) ?? "");
  if (!found || study.limits[found[2]] === undefined) return null;
  const column = study.scenarios.column(found[1]);
  const value = column?.at(row) ?? null;
  return value === null ? null : { metric: found[1], value, bound: study.limits[found[2]], units: column.units };
}

/** "contact yield ratio 1.27 against 1 allowed", else the program's own words. */
export function causeWords(study, row) {
  const limit = crossedLimit(study, row);
  if (limit) return `${label(limit.metric)} ${quantity(limit.value, limit.units, 3, limit.bound)} against ${quantity(limit.bound, limit.units)} allowed`;
  return inWords(study.scenarios.at("cause", row) ?? "");
}


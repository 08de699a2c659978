// The grip window: first the force to set, then from where to where the product is safe.

import { heldWords, judgesDamage } from "../claims.js";
import { h } from "../dom.js";
import { inWords, keyColumns, rowsOf, textAttribute } from "../tables.js";
import { innerNumber, label, listed, number, plural, quantity, thousands, valuesText } from "../words.js";
import { windowRuler } from "../window_ruler.js";
import { capital, fact, sentenceCase, verdict } from "./parts.js";

/** "1.27 – 4.72", with the sign that says an end lies beyond what was tried. */
function rangeText(low, lowIsBound, high, highIsBound) {
  return `${lowIsBound ? "≤ " : ""}${innerNumber(low, "low")} – ${highIsBound ? "≥ " : ""}${innerNumber(high, "high")}`;
}

export function bracketText(low, high) {
  if (low === null && high === null) return "–";
  if (low === null) return `at or below ${number(high)} N`;
  return high === null ? `at or above ${number(low)} N` : `between ${number(low)} and ${number(high)} N`;
}

function inputsOf(window, row) {
  return row === null || row === undefined || !window.inputs.length ? "" : valuesText(window.inputs, row);
}

function exceptions(study, window) {
  const rows = rowsOf(window).filter((row) => window.at("exists", row) !== 1);
  if (rows.length === 0 || window.rows === 1) return null;
  const shown = rows.slice(0, 4).map((row) => h("li", {}, h("b", {}, inputsOf(window, row)), " ", inWords(window.at("note", row) || "no window")));
  if (rows.length > shown.length) shown.push(h("li", {}, `and ${rows.length - shown.length} more, in the section on windows`));
  return h("details", { class: "exceptions" }, h("summary", {}, `${plural(rows.length, "combination")} without a window`), h("ul", {}, shown));
}

/** The ends of a window, from the table of set-points where there is one, else of all combinations. */
function endsOf(study, chosen) {
  const { window } = study;
  if (chosen === null) return { ...window.common, combinations: window.common.over };
  const table = study.tables.get("set_points");
  const at = (name) => table.at(name, chosen);
  return {
    exists: at("exists") === 1, hold_force_N: at("hold_force_N"), damage_force_N: at("damage_force_N"),
    hold_is_bound: at("hold_is_bound") === 1, damage_is_bound: at("damage_is_bound") === 1,
    hold_row: at("hold_row"), damage_row: at("damage_row"), combinations: at("combinations") ?? 1,
  };
}

/** { force_N, tolerance_N, note } of a strategy, or of the one combination of an older file. */
function setPointOf(study, chosen) {
  const [table, row] = chosen === null ? [study.window.rows === 1 ? study.window : null, 0] : [study.tables.get("set_points"), chosen];
  if (!table?.column("set_point_exists")) return null;
  const note = table.at("set_point_note", row) ?? (table === study.window ? "" : table.at("note", row)) ?? "";
  return { exists: table.at("set_point_exists", row) === 1, force_N: table.at("set_point_N", row), tolerance_N: table.at("set_point_tolerance_N", row), note };
}

/** The strategy the answer speaks of, as the program chose it; of results of older versions the best. */
function chosenStrategy(study) {
  const table = study.tables.get("set_points");
  return table?.rows ? table.attributes.told ?? rowsOf(table).find((row) => table.at("best", row) === 1) ?? 0 : null;
}

/** "approach speed 0.1 m/s; over all 12 combinations of friction and mass" */
function conditions(study, chosen, ends) {
  const { window } = study;
  if (chosen === null) {
    if (window.rows === 1) return "";
    const keys = listed(window.inputs.map((column) => label(column.name)));
    return `over ${window.common.over === window.common.of ? "all" : `${thousands(window.common.over)} of`} ${thousands(window.common.of)} combinations of ${keys}`;
  }
  const table = study.tables.get("set_points");
  const own = keyColumns(table);
  const over = textAttribute(table, "over").split(/,\s*/).filter(Boolean).map((key) => label(key));
  return [own.length ? `at ${valuesText(own, chosen)}` : "", over.length ? `over ${ends.combinations === 1 ? "the" : `all ${thousands(ends.combinations)}`} ${ends.combinations === 1 ? "value" : "combinations"} of ${listed(over)}` : ""].filter(Boolean).join(", ");
}

function windowFacts(study, ends) {
  const { window } = study;
  const { hold_force_N: low, damage_force_N: high, hold_row: holdRow, damage_row: damageRow } = ends;
  const bound = ends.hold_is_bound || ends.damage_is_bound;
  const bracket = (name, row) => (row === null || row === undefined ? "–" : bracketText(window.at(`${name}_bracket_low_N`, row), window.at(`${name}_bracket_high_N`, row)));
  const setBy = (row) => (window.rows === 1 ? null : `set by ${inputsOf(window, row)}`);
  return [
    judgesDamage(study) && low > 0 ? fact("Margin", `${bound ? "≥ " : ""}${number(high / low, 3)} times`, "the force that marks over the force that holds") : null,
    fact("Holding begins", bracket("hold", holdRow), setBy(holdRow)),
    judgesDamage(study) ? fact("Damage begins", bracket("damage", damageRow), setBy(damageRow)) : null,
  ];
}

/** " (1.91 N at half the time step)" where that narrows the end. */
function halfStepRemark(study, row, name, found_N) {
  const half_N = row === null || row === undefined ? null : study.window.at(`${name}_force_half_step_N`, row);
  const narrows = half_N !== null && half_N !== undefined && (name === "hold" ? half_N > found_N : half_N < found_N);
  return narrows ? ` (${innerNumber(half_N, name === "hold" ? "low" : "high")} N at half the time step)` : "";
}

function windowSentence(study, ends) {
  const from = `From ${innerNumber(ends.hold_force_N, "low")} N the product is held${ends.hold_is_bound ? " (the least force tried already holds it)" : halfStepRemark(study, ends.hold_row, "hold", ends.hold_force_N)}`;
  return `${from}; up to ${innerNumber(ends.damage_force_N, "high")} N it is left unmarked${ends.damage_is_bound ? " (the greatest force tried does not mark it)" : halfStepRemark(study, ends.damage_row, "damage", ends.damage_force_N)}.`;
}

function noWindow(study, set) {
  const { window } = study;
  const keys = listed(window.inputs.map((column) => label(column.name)));
  const note = window.rows === 1 ? window.at("note", 0).replace(/^no window: /, "") : "";
  return {
    kicker: "Grip window",
    headline: "No window",
    verdict: verdict("bad", window.rows === 1 ? judgesDamage(study) ? "No grip force both holds the product and leaves it unmarked" : "No grip force that was tried holds the product" : `None of the ${window.rows} combinations of ${keys} has one`),
    sentence: sentenceCase(inWords(note || set?.note || `No grip force that was tried left the product ${heldWords(study)}`)),
    extra: [exceptions(study, window)],
  };
}

function noCommonWindow(study, ends, where) {
  const { window } = study;
  const untried = ends.hold_is_bound || ends.damage_is_bound;
  const known = ends.hold_force_N !== null && ends.damage_force_N !== null && ends.hold_row !== null && ends.damage_row !== null;
  return {
    kicker: `Grip window ${where}`.trim(),
    headline: "No common window",
    verdict: verdict("bad", "No single grip force suits all of them"),
    sentence: !known ? "" : untried ? `No force was tried that could suit all: forces from ${number(ends.hold_force_N)} N on at ${inputsOf(window, ends.hold_row)}, up to ${number(ends.damage_force_N)} N at ${inputsOf(window, ends.damage_row)}.` : `Holding needs ${number(ends.hold_force_N)} N at ${inputsOf(window, ends.hold_row)}, but damage begins above ${number(ends.damage_force_N)} N at ${inputsOf(window, ends.damage_row)}.`,
    extra: [exceptions(study, window)],
  };
}

/** Why this strategy: of all that can be set its cycle is the shortest. */
function cycleFact(study, chosen) {
  const table = study.tables.get("set_points");
  const time = chosen === null ? null : table.at("cycle_time_s", chosen);
  if (time === null || table.rows < 2) return null;
  const usable = rowsOf(table).filter((row) => table.at("set_point_exists", row) === 1).length;
  return fact("Cycle time", quantity(time, "s"), usable > 1 ? `the shortest of ${plural(usable, "strategy", "strategies")} with a set-point` : "the one strategy with a set-point");
}

function setPointAnswer(study, ends, set, where, chosen) {
  return {
    kicker: capital(`grip force to set ${where}`.trim()),
    headline: `Set ${number(set.force_N)}`,
    unit: "N",
    verdict: verdict("good", `May be off by ${quantity(set.tolerance_N, "N")} either way`),
    sentence: windowSentence(study, ends),
    facts: [fact("Grip window", h("span", {}, rangeText(ends.hold_force_N, ends.hold_is_bound, ends.damage_force_N, ends.damage_is_bound), " N")), ...windowFacts(study, ends), cycleFact(study, chosen)],
  };
}

/** The note of a set-point that the gripper rules out begins with the headline: "not for this gripper: it ...". */
function withoutSetPoint(study, ends, set, where) {
  const [, blame, why] = /^((?:not|too narrow) for this gripper): (.*)$/.exec(set.note) ?? [null, "no set-point", set.note];
  return {
    kicker: `Grip window ${where}`.trim(),
    headline: capital(blame),
    verdict: verdict("bad", sentenceCase(inWords(why))),
    sentence: windowSentence(study, ends),
    facts: windowFacts(study, ends),
  };
}

/** Without a judgement of damage there is a force that holds, and no upper end. */
function heldOnly(study, ends, where) {
  return {
    kicker: capital(`held, ${where}`.replace(/, $/, "")),
    headline: `From ${innerNumber(ends.hold_force_N, "low")}`,
    unit: "N",
    verdict: verdict("good", "From this force on the product is held"),
    sentence: "How hard it may be gripped is not known.",
    facts: windowFacts(study, ends),
  };
}

function plainWindow(study, ends, where) {
  const { common, rows } = study.window;
  const one = rows === 1;
  const all = common.over === common.of;
  return {
    kicker: `Grip window ${where}`.trim(),
    headline: rangeText(ends.hold_force_N, ends.hold_is_bound, ends.damage_force_N, ends.damage_is_bound),
    unit: "N",
    verdict: all ? verdict("good", one ? "There is a window" : "One grip force suits every combination") : verdict("warn", `At ${common.of - common.over} of ${common.of} combinations there is no window`),
    sentence: windowSentence(study, ends),
    facts: windowFacts(study, ends),
  };
}

export function windowAnswer(study) {
  const { window } = study;
  const chosen = chosenStrategy(study);
  const set = setPointOf(study, chosen);
  const ends = endsOf(study, chosen);
  const where = conditions(study, chosen, ends);
  if (window.common.over === 0) return noWindow(study, set);
  if (!ends.exists) return noCommonWindow(study, ends, where);
  const answer = !judgesDamage(study) ? heldOnly(study, ends, where) : set === null ? plainWindow(study, ends, where) : set.exists ? setPointAnswer(study, ends, set, where, chosen) : withoutSetPoint(study, ends, set, where);
  answer.extra = [windowRuler(study, ends, set?.exists && judgesDamage(study) ? set : null), exceptions(study, window)];
  return answer;
}

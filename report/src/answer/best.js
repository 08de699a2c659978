// The best strategy of a search, or how far the closest one is from being one.

import { h } from "../dom.js";
import { chanceStanding, goalWords, missWords, readGoal } from "../goals.js";
import { confidenceText, eventWords, inWords, isBroken, objectiveColumns, objectiveLabel, objectiveUnits, rowsOf, textAttribute, unitsOfGoal } from "../tables.js";
import { listed, percent, plural, quantity } from "../words.js";
import { capital, fact, probabilityFact, sentenceCase, strategyList, verdict } from "./parts.js";

function objectiveFacts(study, best) {
  // A Pareto study without a feasible strategy has several objectives.
  const several = objectiveColumns(best);
  if (several.length) return several.map((column) => fact(objectiveLabel(column), quantity(column.at(0), objectiveUnits(study, column))));
  const objective = textAttribute(best, "objective", "objective");
  return [fact(inWords(objective), quantity(best.at("objective", 0), best.column("objective")?.units || unitsOfGoal(study, objective)), "what was searched for: the least of it")];
}

/** What a goal came to at the best strategy, as far as the file says it. */
function reached(study, best, text) {
  const goal = readGoal(study, text);
  if (!goal) return null;
  if (goal.chance !== null) {
    const table = study.tables.get("constraints");
    const asked = rowsOf(table).find((each) => table.at("text", each) === text);
    return asked === undefined ? null : chanceStanding(study, table, asked)?.estimate ?? null;
  }
  const row = study.scenarios.rowOf.get(best.at("scenario", 0));
  return goal.metric && row !== undefined && study.kind !== "robust" ? study.scenarios.at(goal.metric, row) : null;
}

/** The constraint that stands in the way, and by how much it is missed. */
function missed(study, best) {
  const reason = textAttribute(best, "reason");
  if (reason) return sentenceCase(inWords(reason));
  const binding = best.at("binding", 0);
  const violation = best.at("violation", 0);
  if (!binding) return violation === null ? "" : `It misses its worst constraint by ${percent(violation)} of the bound.`;
  const words = missWords(study, binding, reached(study, best, binding));
  if (words) return `At the closest one the ${words}.`;
  return `The closest one misses “${goalWords(study, binding)}”${violation === null ? "" : ` by ${percent(violation)} of the bound`}.`;
}

function noneFeasible(study, best, facts) {
  const binding = best.at("binding", 0);
  return {
    kicker: study.kind === "robust" ? "Robust strategy" : "Best strategy",
    headline: "None feasible",
    verdict: verdict("bad", binding && !textAttribute(best, "reason") ? `No strategy that was tried meets: ${goalWords(study, binding)}` : "No strategy that was tried meets every constraint"),
    sentence: missed(study, best),
    facts,
    extra: [h("h3", {}, "The closest one"), strategyList(best, 0)],
  };
}

/** Probabilities asked for that the estimate meets and the interval does not show. */
function unshown(study) {
  const table = study.tables.get("constraints");
  return rowsOf(table)
    .map((row) => chanceStanding(study, table, row))
    .filter((each) => each && each.met && !each.shown);
}

function bestVerdict(study) {
  const checks = study.tables.get("verification");
  const broken = rowsOf(checks).filter((row) => isBroken(checks, row));
  if (broken.length) return verdict("warn", `Meets every constraint as searched, but not when checked with ${listed(broken.map((row) => checks.at("check", row)))}`);
  const [chance] = unshown(study);
  if (chance) return verdict("warn", `${percent(chance.goal.bound)} is met by the estimate, not shown by the interval${chance.low === null ? "" : `, which begins at ${percent(chance.low)}`}`);
  return verdict("good", "Meets every constraint");
}

/** Was the strategy looked at again, and did it keep its constraints? */
export function checkedAgain(study) {
  const checks = study.tables.get("verification");
  const rows = rowsOf(checks).filter((row) => checks.at("check", row) !== "as found");
  if (rows.length === 0) return null;
  const broken = rows.filter((row) => isBroken(checks, row));
  if (broken.length) return fact("Checked again", `${broken.length} of ${plural(rows.length, "check")} broken`, `${listed(broken.map((row) => checks.at("check", row)))}: ${goalWords(study, checks.at("binding", broken[0]) || "a constraint")}`);
  const changes = rows.map((row) => checks.at("objective_change", row)).filter((change) => change !== null);
  return fact("Checked again", "Every constraint kept", changes.length ? `the objective moves by at most ${percent(Math.max(...changes.map(Math.abs)))}` : null);
}

/** The probability on products the search never saw is the one to believe. */
function onOtherProducts(study, best) {
  const checks = study.tables.get("verification");
  const row = rowsOf(checks).find((each) => /products/.test(checks.at("check", each) ?? "") && checks.at("probability", each) !== null);
  if (row === undefined) return null;
  return probabilityFact("On products it never saw", checks.at("probability", row), checks.at("probability_low", row), checks.at("probability_high", row), confidenceText(best));
}

export function bestAnswer(study) {
  const best = study.tables.get("best");
  const known = (name) => best.at(name, 0) ?? best.attributes[name] ?? null;
  const facts = [
    ...objectiveFacts(study, best),
    probabilityFact(`Probability of ${eventWords(textAttribute(best, "event", "held"))}`, known("probability"), known("probability_low"), known("probability_high"), confidenceText(best)),
    typeof best.attributes.products === "number" ? fact("Judged on", plural(best.attributes.products, "product"), "the same ones for every strategy") : null,
    onOtherProducts(study, best),
    checkedAgain(study),
  ];
  if (best.at("feasible", 0) !== 1) return noneFeasible(study, best, facts);
  const ends = textAttribute(best, "at_bounds");
  return {
    kicker: study.kind === "robust" ? "Best strategy over the products of this study" : "Best strategy",
    headline: strategyList(best, 0),
    verdict: bestVerdict(study),
    sentence: capital(inWords(textAttribute(best, "sentence"))),
    extra: [ends ? h("p", { class: "soft" }, `At the end of its range: ${inWords(ends)}. A wider range may do better.`) : null],
    facts,
  };
}

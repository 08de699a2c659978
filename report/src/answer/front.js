// The trade-off of a Pareto study: its knee first, for that is the point to begin with.

import { h } from "../dom.js";
import { inWords, kneeRow, objectiveColumns, objectiveLabel, objectiveUnits, rowsOf, textAttribute } from "../tables.js";
import { listed, number, quantity, thousands } from "../words.js";
import { checkedAgain } from "./best.js";
import { capital, fact, strategyList, verdict } from "./parts.js";

function emptyFront(names) {
  return {
    kicker: "Trade-off",
    headline: "None feasible",
    verdict: verdict("bad", "No strategy that was tried meets every constraint"),
    sentence: `So there is no trade-off between ${names} to show.`,
  };
}

/** "0.822, measured from 2.6 s and 1.1": a hypervolume means something beside its reference only. */
function hypervolumeFact(study, front, objectives) {
  const volume = front.attributes.hypervolume;
  if (typeof volume !== "number") return null;
  const reference = objectives.map((column, i) => [front.attributes[`reference_${i + 1}`], objectiveUnits(study, column)]).filter(([value]) => typeof value === "number");
  const from = reference.length === objectives.length ? `measured from ${listed(reference.map(([value, units]) => quantity(value, units)))}; ` : "";
  return fact("Hypervolume", number(volume), `${from}larger is better, for comparing searches`);
}

function kneeFacts(study, front, objectives, knee) {
  return objectives.map((column) => {
    const values = column.numbers();
    const units = objectiveUnits(study, column);
    const most = Math.max(...values);
    const along = `${quantity(Math.min(...values), units, 3, most)} to ${quantity(most, units, 3, most)} along the front`;
    return knee === null ? fact(objectiveLabel(column), along) : fact(objectiveLabel(column), quantity(column.at(knee), units, 4, most), `at the knee; ${along}`);
  });
}

export function frontAnswer(study) {
  const front = study.tables.get("pareto");
  const objectives = objectiveColumns(front);
  const names = listed(objectives.map(objectiveLabel));
  if (rowsOf(front).length === 0) return emptyFront(names);
  const knee = kneeRow(front);
  const one = front.rows === 1;
  return {
    kicker: `Trade-off between ${names}`,
    headline: one ? "One strategy" : `${thousands(front.rows)} strategies`,
    size: "medium",
    verdict: verdict("good", one ? "One is best in everything" : "None of them is beaten in everything by another"),
    sentence: capital(inWords(textAttribute(front, "sentence", one ? "No other strategy that was tried is better in any objective." : "To be better in one objective, each would have to give up something in another."))),
    extra: knee === null || one ? (one ? [strategyList(front, 0, "strategy small")] : []) : [h("h3", {}, "Knee of the front: where more of one begins to cost much of the other"), strategyList(front, knee, "strategy small")],
    facts: [...kneeFacts(study, front, objectives, knee), hypervolumeFact(study, front, objectives), checkedAgain(study)],
  };
}

// One scenario: how it ended, and the quantity that decided it beside its limit.

import { damageRemark, judgesDamage, judgingLimits } from "../claims.js";
import { causeWords, crossedLimit } from "../goals.js";
import { label, outcomeLabel, percent, quantity } from "../words.js";
import { capital, fact, sentenceCase, verdict } from "./parts.js";

const SHOWN = ["cycle_time_s", "friction_margin_min", "peak_finger_force_N", "permanent_set_max_m"];

/** Every limit that judged this scenario, nearest first: { metric, value, bound, units, share }. */
export function limitsOf(study, row) {
  const { scenarios } = study;
  return judgingLimits(study)
    .map(({ metric, key }) => ({ metric, bound: study.limits[key] ?? null, value: scenarios.at(metric, row), units: scenarios.column(metric)?.units ?? "" }))
    .filter((each) => each.bound > 0 && each.value !== null)
    .map((each) => ({ ...each, share: each.value / each.bound }))
    .sort((a, b) => b.share - a.share);
}

function limitFact(limit) {
  const text = quantity(limit.value, limit.units);
  const bound = quantity(limit.bound, limit.units);
  return fact(label(limit.metric), text, limit.share > 1 ? `limit ${bound}: exceeded by ${percent(limit.share - 1)}` : `limit ${bound}: ${percent(limit.share)} of it`);
}

function verdictOf(study, outcome) {
  if (outcome === "not_run") return verdict("none", "Not run yet");
  if (outcome === "held") return verdict("good", judgesDamage(study) ? "Held and unmarked" : "Held");
  return verdict("bad", capital(causeWords(study, 0)) || "Not held");
}

export function singleAnswer(study) {
  const { scenarios } = study;
  const outcome = scenarios.at("outcome", 0);
  const time = scenarios.at("outcome_time_s", 0);
  const crossed = crossedLimit(study, 0);
  const limits = limitsOf(study, 0);
  const first = crossed ? limits.filter((each) => each.metric === crossed.metric) : [];
  const others = limits.filter((each) => !first.includes(each)).slice(0, 3 - first.length);
  const told = new Set([...first, ...others].map((each) => each.metric));
  const remark = damageRemark(study);
  return {
    kicker: "One scenario",
    headline: capital(outcomeLabel(outcome)),
    verdict: verdictOf(study, outcome),
    sentence: [time === null ? "" : `Decided at ${quantity(time, "s")}.`, remark && outcome !== "held" ? sentenceCase(remark) : ""].filter(Boolean).join(" "),
    facts: [
      ...[...first, ...others].map(limitFact),
      ...SHOWN.filter((name) => !told.has(name) && scenarios.at(name, 0) !== null && (name !== "permanent_set_max_m" || scenarios.at(name, 0) > 0)).map((name) => fact(label(name), quantity(scenarios.at(name, 0), scenarios.column(name).units))),
    ],
  };
}

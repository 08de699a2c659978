// What the page may claim: whether damage was judged, and whether anything takes the green from an answer.

import { h } from "./dom.js";
import { plural } from "./words.js";

export function judgesDamage(study) {
  return study.damage === "judged";
}

/** The limits that judge a run: [{ metric, key }], the key one of study.limits. */
export function judgingLimits(study) {
  return [...study.slipLimits, ...(judgesDamage(study) ? study.damageLimits : [])];
}

/** The bound that judges a metric in all scenarios; null where none does. */
export function boundOf(study, metric) {
  const key = judgingLimits(study).find((limit) => limit.metric === metric)?.key;
  const isVaried = study.scenarios.inputs.some((column) => column.name === `limits.${key}`);
  return key === undefined || isVaried ? null : study.limits[key] ?? null;
}

/** Said where something is selected, by what is worked out from the whole study. */
export function wholeStudy(study) {
  return study.scenarios.rows > 1 ? h("p", { class: "note whole" }, "Worked out from all scenarios, whatever is selected.") : null;
}

/** null where damage was judged, else the words that say it was not. */
export function damageRemark(study) {
  if (judgesDamage(study)) return null;
  return study.damage === "not considered" ? "damage was not considered" : "damage was not looked at";
}

/** "held without damage", or what is left of it where nobody looked. */
export function heldWords(study) {
  return judgesDamage(study) ? "held without damage" : "held";
}

/** A good verdict stays good only where nothing stands against it. */
export function soberly(study, { tone, text }) {
  if (tone !== "good") return { tone, text };
  const doubts = [
    damageRemark(study),
    study.warnings.length ? `${plural(study.warnings.length, "warning")} above ${study.warnings.length === 1 ? "belongs" : "belong"} to it` : null,
    study.complete ? null : "the study is not complete",
  ].filter(Boolean);
  return doubts.length ? { tone: "warn", text: `${text}, but ${doubts.join(", and ")}` } : { tone, text };
}

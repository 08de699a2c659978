// The input that matters most, and whether it is clearly ahead.

import { effectNote, effects, firstMetric, inWords, textAttribute } from "../tables.js";
import { label, percent, quantity } from "../words.js";
import { capital, fact, verdict } from "./parts.js";

export function sensitivityAnswer(study) {
  const table = study.tables.get("sensitivity");
  const metric = firstMetric(table);
  const found = metric === undefined ? [] : effects(table, metric);
  const name = label(metric ?? "");
  const note = metric === undefined ? "" : effectNote(table, metric);
  if (note) return { kicker: `What ${name} depends on`, headline: "No effect to tell", verdict: verdict("none", "Nothing to compare"), sentence: `${capital(name)} ${note}.` };
  if (found.length > 0 && found.every((each) => each.low === null)) {
    return { kicker: `What ${name} depends on`, headline: "No effect shown", verdict: verdict("none", "Too few samples for an interval"), sentence: "More samples would tell more." };
  }
  if (found.length === 0 || found.every((each) => each.low === null || each.low <= 0)) {
    return { kicker: `What ${name} depends on`, headline: "No effect shown", verdict: verdict("none", "Every interval reaches zero"), sentence: capital(inWords(textAttribute(table, "sentence", "More samples would tell more."))) };
  }
  const morris = table.column("mean_absolute") !== null;
  const [first, second] = found;
  const apart = !second || second.high === null || first.low === null || first.low > second.high;
  const units = study.scenarios.column(metric)?.units ?? "";
  const most = Math.max(...found.map((each) => each.high ?? each.value));
  const text = (value) => (morris ? quantity(value, units, 3, most) : percent(value));
  return {
    kicker: `What ${name} depends on most`,
    headline: capital(label(first.key)),
    verdict: apart ? verdict("good", "Clearly ahead of the others") : verdict("warn", `Not clearly ahead of ${label(second.key)}`),
    sentence: capital(inWords(textAttribute(table, "sentence", morris
      ? `Over its range, ${label(first.key)} moves ${name} by ${text(first.value)} on average.`
      : `With all it interacts with, ${label(first.key)} accounts for ${text(first.value)} of the variance of ${name}.`))),
    facts: found.slice(0, 3).map((each) => fact(label(each.key), text(each.value), each.low === null ? null : `interval ${text(each.low)} to ${text(each.high)}`)),
  };
}

// How many were held: of random products a probability, of a grid a count.

import { heldWords } from "../claims.js";
import { wilson } from "../statistics.js";
import { number, percent, plural, quantity, thousands, valuesText } from "../words.js";
import { capital, fact, verdict } from "./parts.js";

/** What the program worked out, where it is there. */
function intervalOfSample(study) {
  const { probability_low: low, probability_high: high, confidence } = study.tables.get("statistics")?.attributes ?? {};
  return typeof low === "number" && typeof high === "number" ? { low, high, confidence } : null;
}

export function fastestFact(study) {
  if (study.bestRow === null) return null;
  const { scenarios } = study;
  const id = scenarios.at("id", study.bestRow);
  return fact("Fastest cycle that held", quantity(scenarios.at("cycle_time_s", study.bestRow), "s"), `scenario ${id}${scenarios.inputs.length ? `: ${valuesText(scenarios.inputs, study.bestRow)}` : ""}`);
}

function verdictOf(study, run, held, noun) {
  if (run === 0) return verdict("none", "There is nothing to say yet");
  if (held === 0) return verdict("bad", `None feasible: no ${noun} was ${heldWords(study)}`);
  return verdict(held === run || study.kind !== "sample" ? "good" : "warn", `${plural(held, noun)} ${heldWords(study)}${study.complete ? "" : " so far"}`);
}

export function shareAnswer(study) {
  const { counts, rows } = study.scenarios;
  const sample = study.kind === "sample";
  const run = rows - (counts.not_run ?? 0);
  const held = counts.held ?? 0;
  const interval = sample ? intervalOfSample(study) ?? wilson(held, run) : null;
  return {
    kicker: sample ? `Probability of being ${heldWords(study)}` : capital(heldWords(study)),
    headline: run === 0 ? "Nothing has run" : sample ? percent(held / run) : `${thousands(held)} of ${thousands(run)}`,
    verdict: verdictOf(study, run, held, sample ? "product" : "scenario"),
    sentence: interval ? `${thousands(held)} of ${thousands(run)} products; the ${number((interval.confidence ?? 0.95) * 100)} % interval reaches from ${percent(interval.low)} to ${percent(interval.high)}.` : "",
    facts: [sample ? null : fastestFact(study)],
  };
}

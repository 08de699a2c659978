// Which candidate to take: holding without damage decides, then the metric.

import { heldWords } from "../claims.js";
import { h } from "../dom.js";
import { confidenceText, inWords, rowsOf, textAttribute } from "../tables.js";
import { label, OUTCOMES, outcomeLabel, percent, plural, thousands } from "../words.js";
import { fact, sentenceCase, verdict } from "./parts.js";

/** The candidate that is held more often than any other where the intervals do not meet. */
function heldMost(candidates) {
  const [best, second] = rowsOf(candidates).sort((a, b) => (candidates.at("probability", b) ?? -1) - (candidates.at("probability", a) ?? -1));
  const name = String(candidates.at("name", best));
  if (second === undefined) return name;
  return (candidates.at("probability_low", best) ?? 0) > (candidates.at("probability_high", second) ?? 1) ? name : null;
}

/** What the program says, else what the intervals show; null: nobody wins. */
function winnerOf(candidates, comparison) {
  const said = comparison?.attributes?.winner;
  if (typeof said === "string") return said || null;
  const text = textAttribute(comparison, "verdict");
  const names = rowsOf(candidates).map((row) => String(candidates.at("name", row)));
  return heldMost(candidates) ?? (candidates.rows === 2 ? names.find((name) => text.startsWith(`${name} is held more often`)) ?? null : null);
}

/** "damaged 3, dropped 1 of 16": what happened to the products that were not held. */
function lossesText(candidates, row) {
  const words = OUTCOMES.filter((word) => candidates.column(word) && (candidates.at(word, row) ?? 0) > 0);
  const total = words.reduce((sum, word) => sum + candidates.at(word, row), 0);
  const lost = words.filter((word) => word !== "held").map((word) => `${outcomeLabel(word)} ${thousands(candidates.at(word, row))}`);
  return total === 0 ? "" : lost.length ? `${lost.join(", ")} of ${thousands(total)}` : `all ${thousands(total)}`;
}

function candidateFact(study, candidates, row) {
  const [value, low, high] = ["probability", "probability_low", "probability_high"].map((name) => candidates.at(name, row));
  if (value === null) return null;
  const interval = low === null ? "" : `${confidenceText(candidates)} ${percent(low)} to ${percent(high)}`;
  return fact(h("span", {}, String(candidates.at("name", row))), `${percent(value)} ${heldWords(study)}`, [interval, lossesText(candidates, row)].filter(Boolean).join("; "));
}

/** The first metric with an interval that leaves zero out. */
function shownMetric(comparison) {
  const row = rowsOf(comparison).find((each) => comparison.at("low", each) > 0 || comparison.at("high", each) < 0);
  return row === undefined ? null : comparison.at("metric", row);
}

/** Why the winner wins, as the program says it behind its name. */
function reasonOf(comparison, winner) {
  const said = textAttribute(comparison, "headline");
  const begin = `winner: ${winner}, `;
  return said.startsWith(begin) ? sentenceCase(inWords(said.slice(begin.length))) : `${winner} is the one to take`;
}

export function compareAnswer(study) {
  const candidates = study.tables.get("candidates");
  const comparison = study.tables.get("comparison");
  const winner = winnerOf(candidates, comparison);
  const metric = shownMetric(comparison);
  const count = plural(candidates.rows, "candidate");
  const without = comparison ? "The intervals do not tell the candidates apart in holding" : "This study holds no paired differences";
  return {
    kicker: `${count} on the same products`,
    headline: winner === null ? "No winner shown" : `Take “${winner}”`,
    verdict: winner === null ? verdict("none", metric ? `${without}; they differ in ${label(metric)}` : without) : verdict("good", reasonOf(comparison, winner)),
    sentence: sentenceCase(inWords(textAttribute(comparison, "verdict"))),
    facts: rowsOf(candidates).slice(0, 4).map((row) => candidateFact(study, candidates, row)),
  };
}

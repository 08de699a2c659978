// The answer, before anything else: what stands against it, one large line, one sentence, a few facts.

import { bestAnswer } from "./answer/best.js";
import { calibrateAnswer } from "./answer/calibrate.js";
import { compareAnswer } from "./answer/compare.js";
import { frontAnswer } from "./answer/front.js";
import { verdictElement } from "./answer/parts.js";
import { sensitivityAnswer } from "./answer/sensitivity.js";
import { fastestFact, shareAnswer } from "./answer/share.js";
import { singleAnswer } from "./answer/single.js";
import { windowAnswer } from "./answer/window.js";
import { soberly } from "./claims.js";
import { command, h } from "./dom.js";
import { outcomeList } from "./legend.js";
import { OUTCOMES, outcomeLabel, outcomeVariable, plural, thousands } from "./words.js";

function chooseAnswer(study) {
  const filled = (name) => (study.tables.get(name)?.rows ?? 0) > 0;
  if (filled("candidates")) return compareAnswer(study);
  if (filled("pareto")) return frontAnswer(study);
  if (filled("calibration")) return calibrateAnswer(study);
  if (study.tables.has("sensitivity")) return sensitivityAnswer(study);
  if (study.window && study.window.rows > 0) {
    const answer = windowAnswer(study);
    if (study.kind === "sweep" && !study.tables.has("set_points")) answer.facts = [...(answer.facts ?? []), fastestFact(study)];
    return answer;
  }
  // Of a sweep without windows, /best only repeats what /strategies says.
  if (filled("best") && study.tables.get("best").column("feasible")) return bestAnswer(study);
  if (study.tables.has("pareto")) return frontAnswer(study);
  return study.scenarios.rows === 1 ? singleAnswer(study) : shareAnswer(study);
}

/** One bar over all outcomes. */
function outcomeBar(study) {
  const { counts, rows } = study.scenarios;
  const words = OUTCOMES.filter((word) => counts[word]);
  if (rows < 2) return null;
  const text = words.map((word) => `${outcomeLabel(word)} ${thousands(counts[word])}`).join(", ");
  return h(
    "div",
    { class: "outcomes" },
    h("div", { class: "outcome-bar", role: "img", "aria-label": `Outcomes: ${text}` }, words.map((word) => h("span", { style: `flex:${counts[word]} 0 0;background:${outcomeVariable(word)}` }))),
    outcomeList(words, counts, study.selection),
  );
}

function incomplete(study) {
  const { counts, rows } = study.scenarios;
  if (study.complete) return null;
  const run = rows - (counts.not_run ?? 0);
  const of = study.kind === "window" ? "" : ` of ${thousands(study.wanted ?? rows)}`;
  const again = study.replay_command.replace(/ --scenario$/, "");
  return h(
    "div",
    { class: "banner", role: "note" },
    h("p", {}, h("b", {}, "This study is not complete. "), `${thousands(run)}${of} scenarios have run; what stands here is what is known so far.`),
    again ? h("p", { class: "soft" }, "The same command continues it:") : null,
    again ? command(again) : null,
  );
}

const WARNINGS_AT_ONCE = 4;

/** Warnings belong to the answer, so they come before it. */
function warnings(study) {
  const all = study.warnings;
  if (all.length === 0) return null;
  const items = all.map((text) => h("li", {}, text));
  const rest = items.slice(WARNINGS_AT_ONCE);
  return h(
    "div",
    { class: "banner warnings", role: "note", "aria-label": "Warnings" },
    h("p", {}, h("b", {}, all.length === 1 ? "Read this before the answer:" : `Read these ${plural(all.length, "warning")} before the answer:`)),
    h("ul", {}, items.slice(0, WARNINGS_AT_ONCE)),
    rest.length ? h("details", {}, h("summary", {}, `${rest.length} more`), h("ul", {}, rest)) : null,
  );
}

/** Scenarios whose numbers cannot be believed. */
function lost(study) {
  const { counts } = study.scenarios;
  const words = [["diverged", "diverged: a number stopped being finite or a solve did not converge"], ["out_of_range", "left the range of strains and rotations in which the model holds"]]
    .filter(([word]) => counts[word])
    .map(([word, text]) => `${plural(counts[word], "scenario")} ${text}`);
  return words.length ? h("p", { class: "remark" }, `${words.join("; ")}. Such scenarios count neither as held nor as safe.`) : null;
}

function headlineElements({ kicker, headline, unit, size }) {
  if (typeof headline !== "string") return [h("h1", { id: "answer-title", class: "hidden" }, kicker), headline];
  const kind = size ?? (headline.length > 16 ? "long" : null);
  return [h("h1", { id: "answer-title", class: kind }, headline, unit ? h("small", {}, ` ${unit}`) : null)];
}

/** The answer's first words, and what they speak of beside them where there is something to see. */
function beside(study, words) {
  return study.preview ? h("div", { class: "answer-top" }, h("div", {}, words), study.preview) : words;
}

export function answer(study) {
  const found = chooseAnswer(study);
  const facts = (found.facts ?? []).filter(Boolean);
  return h(
    "section",
    { class: "answer", id: "answer", "aria-labelledby": "answer-title" },
    incomplete(study),
    warnings(study),
    beside(study, [
      h("p", { class: "kicker" }, found.kicker),
      headlineElements(found),
      verdictElement(soberly(study, found.verdict)),
      found.sentence ? h("p", { class: "sentence" }, found.sentence) : null,
    ]),
    found.extra ?? [],
    facts.length ? h("dl", { class: "facts" }, facts) : null,
    outcomeBar(study),
    lost(study),
  );
}

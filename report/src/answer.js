// The answer, before anything else: one large line, one sentence, a few facts.

import { command, h } from "./dom.js";
import { wilson } from "./statistics.js";
import { label, listed, number, outcomeLabel, OUTCOMES, percent, plural, quantity, thousands, valuesText } from "./words.js";
import { windowRuler } from "./window_ruler.js";

const MARKS = { good: "✓", warn: "!", bad: "×", none: "–" };

function verdict(tone, text) {
  return h("p", { class: `verdict ${tone}` }, h("span", { "aria-hidden": "true" }, MARKS[tone]), text);
}

function fact(name, value, remark = null) {
  const title = typeof name === "string" ? name.replace(/^./, (letter) => letter.toUpperCase()) : name;
  return h("div", {}, h("dt", {}, title), h("dd", {}, value, remark ? h("small", {}, remark) : null));
}

/** "1.27 – 4.72", with the sign that says an end lies beyond what was tried. */
export function rangeText(low, lowIsBound, high, highIsBound) {
  return `${lowIsBound ? "≤ " : ""}${number(low)} – ${highIsBound ? "≥ " : ""}${number(high)}`;
}

function inputsOf(window, row) {
  return window.inputs.length ? valuesText(window.inputs, row) : "";
}

function holdText(window, row) {
  const low = window.at("hold_bracket_low_N", row);
  const high = window.at("hold_bracket_high_N", row);
  if (high === null) return null;
  return low === null ? `at or below ${number(high)} N` : `between ${number(low)} and ${number(high)} N`;
}

function damageText(window, row) {
  const low = window.at("damage_bracket_low_N", row);
  const high = window.at("damage_bracket_high_N", row);
  if (low === null) return null;
  return high === null ? `at or above ${number(low)} N` : `between ${number(low)} and ${number(high)} N`;
}

function withoutWindow(window) {
  const rows = [];
  for (let row = 0; row < window.rows; row += 1) if (window.at("exists", row) !== 1) rows.push(row);
  return rows;
}

function exceptions(window) {
  const rows = withoutWindow(window);
  if (rows.length === 0 || window.rows === 1) return null;
  const shown = rows.slice(0, 4).map((row) => h("li", {}, h("b", {}, inputsOf(window, row)), " ", window.at("note", row) || "no window"));
  if (rows.length > shown.length) shown.push(h("li", {}, `and ${rows.length - shown.length} more, in the section on windows`));
  return h("details", { class: "exceptions" }, h("summary", {}, `${plural(rows.length, "combination")} without a window`), h("ul", {}, shown));
}

function windowAnswer(study) {
  const { window } = study;
  const { common } = window;
  const keys = listed(window.inputs.map((column) => label(column.name)));
  if (common.over === 0) {
    const note = window.rows === 1 ? window.at("note", 0).replace(/^no window: /, "") : "";
    return {
      kicker: "Grip window",
      headline: "No window",
      verdict: verdict("bad", window.rows === 1 ? "No grip force both holds the product and leaves it unmarked" : `None of the ${window.rows} combinations of ${keys} has one`),
      sentence: note ? `${note[0].toUpperCase()}${note.slice(1)}.` : "No grip force that was tried both holds the product and leaves it unmarked.",
      extra: [exceptions(window)],
    };
  }
  const all = common.over === common.of;
  if (!common.exists) {
    return {
      kicker: `Grip window over ${all ? "all" : "the other"} ${thousands(common.over)} combinations of ${keys}`,
      headline: "No common window",
      verdict: verdict("bad", "No single grip force suits all of them"),
      sentence: `Holding needs ${number(common.hold_force_N)} N at ${inputsOf(window, common.hold_row)}, but damage begins above ${number(common.damage_force_N)} N at ${inputsOf(window, common.damage_row)}.`,
      extra: [exceptions(window)],
    };
  }
  const one = window.rows === 1;
  const low = common.hold_force_N;
  const high = common.damage_force_N;
  const bound = common.hold_is_bound || common.damage_is_bound;
  const margin = low > 0 ? high / low - 1 : null;
  return {
    kicker: one ? "Grip window" : `Grip window over ${all ? "all" : `${thousands(common.over)} of`} ${thousands(common.of)} combinations of ${keys}`,
    headline: rangeText(low, common.hold_is_bound, high, common.damage_is_bound),
    unit: "N",
    verdict: all
      ? verdict("good", one ? "There is a window" : "One grip force suits every combination")
      : verdict("warn", `At ${common.of - common.over} of ${common.of} combinations there is no window`),
    sentence: `From ${number(low)} N the product is held${common.hold_is_bound ? " (the least force tried already holds it)" : ""}; up to ${number(high)} N it is left unmarked${common.damage_is_bound ? " (the greatest force tried does not mark it)" : ""}.`,
    facts: [
      fact("Margin", margin === null ? "–" : `${bound ? "≥ " : ""}${percent(margin)}`, "damage force over hold force, less one"),
      fact("Holding begins", holdText(window, common.hold_row), one ? null : `set by ${inputsOf(window, common.hold_row)}`),
      fact("Damage begins", damageText(window, common.damage_row), one ? null : `set by ${inputsOf(window, common.damage_row)}`),
    ],
    extra: [windowRuler(study, window, common), exceptions(window)],
  };
}

function bestScenario(study) {
  if (study.bestRow === null) return null;
  const { scenarios } = study;
  const id = scenarios.at("id", study.bestRow);
  const cycle = scenarios.column("cycle_time_s");
  return fact("Fastest cycle that held", quantity(cycle.at(study.bestRow), "s"), `scenario ${id}${scenarios.inputs.length ? `: ${valuesText(scenarios.inputs, study.bestRow)}` : ""}`);
}

/** The variables of `best`, `pareto` or `evaluations`: columns that are dotted keys. */
export function keyColumns(table) {
  return table.columns.filter((column) => column.name.includes("."));
}

function strategyList(table, row) {
  return h(
    "dl",
    { class: "strategy" },
    keyColumns(table).map((column) => {
      const text = quantity(column.at(row), column.units);
      const space = text.lastIndexOf(" ");
      const [value, unit] = typeof column.at(row) === "number" && space > 0 ? [text.slice(0, space), text.slice(space + 1)] : [text, ""];
      return h("div", {}, h("dt", {}, label(column.name)), h("dd", {}, value, unit ? h("small", {}, unit) : null));
    }),
  );
}

function probabilityFact(name, value, low, high, remark) {
  if (value === null) return null;
  return fact(name, percent(value), low === null ? null : `${remark} ${percent(low)} to ${percent(high)}`);
}

export function confidenceText(table) {
  const level = table?.attributes?.confidence;
  return typeof level === "number" ? `${number(level * 100)} % interval` : "confidence interval";
}

function sentenceOf(table, otherwise) {
  const text = table.attributes?.sentence;
  return typeof text === "string" && text ? text : otherwise;
}

function bestAnswer(study) {
  const best = study.tables.get("best");
  const feasible = best.at("feasible", 0) === 1;
  const objective = typeof best.attributes.objective === "string" ? best.attributes.objective : "objective";
  const value = best.at("objective", 0);
  const units = study.scenarios.column(objective)?.units ?? best.column("objective")?.units ?? "";
  const known = (name) => best.at(name, 0) ?? best.attributes[name] ?? null;
  const event = typeof best.attributes.event === "string" ? best.attributes.event : "held";
  // A Pareto study without a feasible strategy has several objectives.
  const several = objectiveColumns(best).map((column) => fact(objectiveLabel(study, column), quantity(column.at(0), objectiveUnits(study, column))));
  const facts = [
    ...several,
    several.length ? null : fact(study.scenarios.column(objective) ? label(objective) : "Objective", quantity(value, units), study.scenarios.column(objective) ? "the objective, to be least" : objective),
    probabilityFact(`Probability of ${event}`, known("probability"), known("probability_low"), known("probability_high"), confidenceText(best)),
    typeof best.attributes.products === "number" ? fact("Judged on", plural(best.attributes.products, "product"), "the same ones for every strategy") : null,
    onOtherProducts(study),
    bestVerified(study),
  ];
  const wide = typeof best.attributes.at_bounds === "string" && best.attributes.at_bounds ? h("p", { class: "soft" }, `At the end of its range: ${best.attributes.at_bounds}. A wider range may do better.`) : null;
  if (!feasible) {
    return {
      kicker: study.kind === "robust" ? "Robust strategy" : "Best strategy",
      headline: "None feasible",
      verdict: verdict("bad", "No strategy that was tried meets every constraint"),
      sentence: sentenceOf(best, "What follows is the strategy that comes closest."),
      facts,
      extra: [h("h3", {}, "The closest one"), strategyList(best, 0), closest(best)],
    };
  }
  return {
    kicker: study.kind === "robust" ? "Best strategy over the products of this study" : "Best strategy",
    headline: strategyList(best, 0),
    verdict: bestVerdict(study),
    sentence: sentenceOf(best, ""),
    extra: [wide],
    facts,
  };
}

function bestVerdict(study) {
  const checks = study.tables.get("verification");
  const broken = Array.from({ length: checks?.rows ?? 0 }, (_, row) => row).filter((row) => isBroken(checks, row));
  return broken.length ? verdict("warn", `Meets every constraint as searched, but not when checked with ${listed(broken.map((row) => checks.at("check", row)))}`) : verdict("good", "Meets every constraint");
}

function closest(best) {
  const violation = best.at("violation", 0);
  return violation === null ? null : h("p", { class: "soft" }, `It breaks its worst constraint by ${percent(violation)} of the bound.`);
}

/** Rows of `verification` that look at the strategy again; row 0 may be the strategy as found. */
export function isBroken(checks, row) {
  return checks.column("feasible") ? checks.at("feasible", row) === 0 : (checks.at("violation", row) ?? 0) > 0;
}

function bestVerified(study) {
  const checks = study.tables.get("verification");
  if (!checks) return null;
  const rows = Array.from({ length: checks.rows }, (_, row) => row).filter((row) => checks.at("check", row) !== "as found");
  if (rows.length === 0) return null;
  const broken = rows.filter((row) => isBroken(checks, row));
  const changes = rows.map((row) => checks.at("objective_change", row)).filter((change) => change !== null);
  const remark = changes.length ? `the objective moves by at most ${percent(Math.max(...changes.map(Math.abs)))}` : null;
  return fact("Checked again", broken.length === 0 ? "Every constraint kept" : `${broken.length} of ${plural(rows.length, "check")} broken`, broken.length ? `${listed(broken.map((row) => checks.at("check", row)))}: ${checks.at("binding", broken[0]) ?? "a constraint"}` : remark);
}

/** The probability on products the search never saw is the one to believe. */
function onOtherProducts(study) {
  const checks = study.tables.get("verification");
  for (let row = 0; row < (checks?.rows ?? 0); row += 1) {
    if (/products/.test(checks.at("check", row) ?? "") && checks.at("probability", row) !== null) {
      return probabilityFact("On products it never saw", checks.at("probability", row), checks.at("probability_low", row), checks.at("probability_high", row), confidenceText(study.tables.get("best")));
    }
  }
  return null;
}

function kneeRow(front) {
  for (let row = 0; row < front.rows; row += 1) if (front.at("knee", row) === 1) return row;
  return null;
}

export function objectiveColumns(table) {
  return table.columns.filter((column) => /^objective_\d+$/.test(column.name));
}

export function objectiveName(column) {
  return column.longName || column.name.replaceAll("_", " ");
}

function paretoAnswer(study) {
  const front = study.tables.get("pareto");
  const objectives = objectiveColumns(front);
  const names = listed(objectives.map((column) => objectiveLabel(study, column)));
  if (front.rows === 0) {
    return {
      kicker: "Trade-off",
      headline: "None feasible",
      verdict: verdict("bad", "No strategy that was tried meets every constraint"),
      sentence: `So there is no trade-off between ${names} to show.`,
    };
  }
  const knee = kneeRow(front);
  const hypervolume = front.attributes.hypervolume;
  return {
    kicker: `Trade-off between ${names}`,
    headline: front.rows === 1 ? "One strategy" : `${thousands(front.rows)} strategies`,
    verdict: verdict("good", front.rows === 1 ? "One is best in everything" : "None of them is beaten in everything by another"),
    sentence: sentenceOf(front, front.rows === 1 ? "No other strategy that was tried is better in any objective." : "To be better in one objective, each would have to give up something in another."),
    facts: [
      ...objectives.map((column) => {
        const values = column.numbers();
        const units = objectiveUnits(study, column);
        return fact(objectiveLabel(study, column), `${quantity(Math.min(...values), units, 3)} to ${quantity(Math.max(...values), units, 3)}`, "along the front");
      }),
      knee === null ? null : fact("Knee of the front", `scenario ${number(front.at("scenario", knee), 9)}`, valuesText(keyColumns(front), knee)),
      bestVerified(study),
      typeof hypervolume === "number" ? fact("Hypervolume", number(hypervolume), "larger is better, for comparing searches") : null,
    ],
  };
}

export function objectiveLabel(study, column) {
  const name = objectiveName(column);
  return study.scenarios.column(name) ? label(name) : name;
}

export function objectiveUnits(study, column) {
  return column.units || (study.scenarios.column(objectiveName(column))?.units ?? "");
}

/** The candidate that is held more often than any other, where that is shown: by intervals that do not meet, or said by the paired verdict. */
function heldMost(candidates, text) {
  const rows = Array.from({ length: candidates.rows }, (_, row) => row).sort((a, b) => (candidates.at("probability", b) ?? -1) - (candidates.at("probability", a) ?? -1));
  const [best, second] = rows;
  const name = String(candidates.at("name", best));
  if (second === undefined) return name;
  const apart = (candidates.at("probability_low", best) ?? 0) > (candidates.at("probability_high", second) ?? 1);
  return apart || (candidates.rows === 2 && text.startsWith(`${name} is held more often`)) ? name : null;
}

function compareAnswer(study) {
  const candidates = study.tables.get("candidates");
  const comparison = study.tables.get("comparison");
  const text = typeof comparison?.attributes?.verdict === "string" ? comparison.attributes.verdict : "";
  const most = heldMost(candidates, text);
  const metric = comparison ? shownMetric(comparison) : null;
  const count = plural(candidates.rows, "candidate");
  return {
    kicker: most === null ? `${count} on the same products` : `Held most often of ${count} on the same products`,
    headline: most ?? (metric ? `A difference in ${label(metric)}` : "No difference shown"),
    verdict: most !== null || metric ? verdict("good", "A difference is shown") : verdict("none", comparison ? "The intervals do not tell the candidates apart" : "This study holds no paired differences"),
    sentence: text ? `${text.replace(/\.$/, "")}.` : "",
    facts: Array.from({ length: Math.min(candidates.rows, 4) }, (_, row) =>
      probabilityFact(h("span", {}, String(candidates.at("name", row))), candidates.at("probability", row), candidates.at("probability_low", row), candidates.at("probability_high", row), `held; ${confidenceText(candidates)}`),
    ),
  };
}

/** The first metric with an interval that leaves zero out. */
function shownMetric(comparison) {
  for (let row = 0; row < comparison.rows; row += 1) {
    const low = comparison.at("low", row);
    const high = comparison.at("high", row);
    if (low !== null && high !== null && (low > 0 || high < 0)) return comparison.at("metric", row);
  }
  return null;
}

/** Rows of the first metric, most effective first, with the interval of the effect. */
export function effects(table, metric) {
  const morris = table.column("mean_absolute") !== null;
  const name = morris ? "mean_absolute" : "total";
  const rows = [];
  for (let row = 0; row < table.rows; row += 1) {
    if (table.at("metric", row) !== metric || table.at(name, row) === null) continue;
    rows.push({ row, key: table.at("key", row), value: table.at(name, row), low: table.at(`${name}_low`, row), high: table.at(`${name}_high`, row) });
  }
  return rows.sort((a, b) => b.value - a.value);
}

function sensitivityAnswer(study) {
  const table = study.tables.get("sensitivity");
  const metrics = table.column("metric")?.distinct ?? [];
  const metric = metrics[0];
  const found = metric === undefined ? [] : effects(table, metric);
  const morris = table.column("mean_absolute") !== null;
  const name = label(metric ?? "");
  if (found.length === 0 || found.every((each) => each.low === null || each.low <= 0)) {
    return { kicker: `What ${name} depends on`, headline: "No effect shown", verdict: verdict("none", "Every interval reaches zero"), sentence: sentenceOf(table, "More samples would tell more.") };
  }
  const [first, second] = found;
  const apart = !second || second.high === null || first.low === null || first.low > second.high;
  const units = study.scenarios.column(metric)?.units ?? "";
  return {
    kicker: `What ${name} depends on most`,
    headline: label(first.key),
    verdict: apart ? verdict("good", "Clearly ahead of the others") : verdict("warn", `Not clearly ahead of ${label(second.key)}`),
    sentence: sentenceOf(
      table,
      morris
        ? `Over its range, ${label(first.key)} moves ${name} by ${quantity(first.value, units)} on average.`
        : `With all it interacts with, ${label(first.key)} accounts for ${percent(first.value)} of the variance of ${name}.`,
    ),
    facts: found.slice(0, 3).map((each) => {
      const text = (value) => (morris ? quantity(value, units, 3) : percent(value));
      return fact(label(each.key), text(each.value), each.low === null ? null : `interval ${text(each.low)} to ${text(each.high)}`);
    }),
  };
}

function simulateAnswer(study) {
  const { scenarios } = study;
  const outcome = scenarios.at("outcome", 0);
  const cause = scenarios.at("cause", 0);
  const time = scenarios.at("outcome_time_s", 0);
  const tone = outcome === "held" ? "good" : outcome === "not_run" ? "none" : "bad";
  const words = { held: "Held and unmarked", not_run: "Not run yet" };
  const names = ["cycle_time_s", "friction_margin_min", "permanent_set_max_m", "peak_finger_force_N"];
  return {
    kicker: "One scenario",
    headline: outcomeLabel(outcome).replace(/^./, (letter) => letter.toUpperCase()),
    verdict: verdict(tone, words[outcome] ?? (cause || "Not held")),
    sentence: time === null ? "" : `Decided at ${quantity(time, "s")}${cause ? `: ${cause}` : ""}.`,
    facts: names.filter((name) => scenarios.at(name, 0) !== null).map((name) => fact(label(name), quantity(scenarios.at(name, 0), scenarios.column(name).units))),
  };
}

/** What the program worked out, where it is there. */
function intervalOfSample(study) {
  const { probability_low: low, probability_high: high, confidence } = study.tables.get("statistics")?.attributes ?? {};
  return typeof low === "number" && typeof high === "number" ? { low, high, confidence } : null;
}

function shareAnswer(study) {
  const { scenarios } = study;
  const run = scenarios.rows - (scenarios.counts.not_run ?? 0);
  const held = scenarios.counts.held ?? 0;
  const interval = study.kind === "sample" ? intervalOfSample(study) ?? wilson(held, run) : null;
  const none = held === 0;
  return {
    kicker: study.kind === "sample" ? "Probability of being held without damage" : "Held without damage",
    headline: run === 0 ? "Nothing has run" : study.kind === "sample" ? percent(held / run) : `${thousands(held)} of ${thousands(run)}`,
    verdict: run === 0 ? verdict("none", "There is nothing to say yet") : none ? verdict("bad", "None feasible: no scenario was held without damage") : verdict("good", `${plural(held, study.kind === "sample" ? "product" : "scenario")} held without damage${study.complete ? "" : " so far"}`),
    sentence: interval ? `${thousands(held)} of ${thousands(run)} products; the ${number((interval.confidence ?? 0.95) * 100)} % interval reaches from ${percent(interval.low)} to ${percent(interval.high)}.` : "",
    facts: [study.kind === "sample" ? null : bestScenario(study)],
  };
}

function chooseAnswer(study) {
  // Of kinds that do not search, `best` only repeats the answer of another table.
  if (study.tables.get("best")?.attributes?.objective && study.tables.get("best").rows > 0) return bestAnswer(study);
  if (study.tables.has("pareto")) return paretoAnswer(study);
  if (study.tables.has("candidates") && study.tables.get("candidates").rows > 0) return compareAnswer(study);
  if (study.tables.has("sensitivity")) return sensitivityAnswer(study);
  if (study.window && study.window.rows > 0) {
    const answer = windowAnswer(study);
    answer.facts = [...(answer.facts ?? []), study.kind === "sweep" ? bestScenario(study) : null];
    return answer;
  }
  if (study.scenarios.rows === 1) return simulateAnswer(study);
  return shareAnswer(study);
}

/** One bar over all outcomes; it is the legend of every chart below it. */
function outcomeBar(study) {
  const { counts, rows } = study.scenarios;
  const words = OUTCOMES.filter((word) => counts[word]);
  if (rows < 2) return null;
  const text = words.map((word) => `${outcomeLabel(word)} ${thousands(counts[word])}`).join(", ");
  return h(
    "div",
    { class: "outcomes" },
    h(
      "div",
      { class: "outcome-bar", role: "img", "aria-label": `Outcomes: ${text}` },
      words.map((word) => h("span", { style: `flex:${counts[word]} 0 0;background:var(--${word.replaceAll("_", "-")})` })),
    ),
    h(
      "ul",
      {},
      words.map((word) => h("li", {}, h("i", { class: "swatch", style: `background:var(--${word.replaceAll("_", "-")})` }), `${outcomeLabel(word)} `, h("b", {}, thousands(counts[word])))),
    ),
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

/** Scenarios whose numbers cannot be believed. */
function lost(study) {
  const { counts } = study.scenarios;
  const words = [["diverged", "diverged: a number stopped being finite or a solve did not converge"], ["out_of_range", "left the range of strains and rotations in which the model holds"]]
    .filter(([word]) => counts[word])
    .map(([word, text]) => `${plural(counts[word], "scenario")} ${text}`);
  return words.length ? h("p", { class: "remark" }, `${words.join("; ")}. Such scenarios count neither as held nor as safe.`) : null;
}

export function answer(study) {
  const { kicker, headline, unit, verdict: tone, sentence, facts = [], extra = [] } = chooseAnswer(study);
  const long = typeof headline === "string" && headline.length > 16;
  const known = facts.filter(Boolean);
  return h(
    "section",
    { class: "answer", id: "answer", "aria-labelledby": "answer-title" },
    incomplete(study),
    h("p", { class: "kicker" }, kicker),
    typeof headline === "string"
      ? h("h1", { id: "answer-title", class: long ? "long" : null }, headline, unit ? h("small", {}, ` ${unit}`) : null)
      : [h("h1", { id: "answer-title", class: "hidden" }, kicker), headline],
    tone,
    sentence ? h("p", { class: "sentence" }, sentence) : null,
    extra,
    known.length ? h("dl", { class: "facts" }, known) : null,
    outcomeBar(study),
    lost(study),
  );
}

// What belongs to the best strategy: its constraints and the checks it went through.

import { h, scrollBox } from "./dom.js";
import { chanceStanding, goalWords } from "./goals.js";
import { inWords, isBroken, objectiveLabel, objectiveUnits, rowsOf, textAttribute, unitsOfGoal } from "./tables.js";
import { genericTable } from "./table.js";
import { number, percent, quantity } from "./words.js";

function cell(value, units = "", most = value) {
  return h("td", { class: "number" }, quantity(value, units, 4, most));
}

function mark(word, kind) {
  return h("span", { class: `state ${kind}` }, word);
}

function plainTable(name, heads, rows) {
  const head = h("thead", {}, h("tr", {}, heads.map(([text, kind]) => h("th", { scope: "col", class: kind }, text))));
  return scrollBox(name, h("table", { class: "plain" }, head, h("tbody", {}, rows)));
}

/** Met by the estimate and shown by the interval are two things. */
function chanceMarks({ estimate, low, met, shown, says }) {
  return [
    mark(met ? "met by the estimate" : "missed by the estimate", met ? "met" : "broken"),
    h("small", {}, percent(estimate)),
    mark(shown ? "shown by the interval" : "not shown by the interval", shown ? "met" : met ? "decides" : "broken"),
    says && !shown ? h("small", {}, inWords(says)) : low === null ? null : h("small", {}, `which begins at ${percent(low)}`),
  ];
}

function constraintMarks(study, table, row) {
  const chance = chanceStanding(study, table, row);
  if (chance) return chanceMarks(chance);
  const slack = table.at("slack", row);
  if (slack !== null && slack < 0) return mark("broken", "broken");
  return table.at("active", row) === 1 ? mark("decides", "decides") : mark("met", "met");
}

function slackText(slack, bounds) {
  if (bounds) return number(slack, 3);
  return slack !== null && Math.abs(slack) < 1e-4 ? "< 0.01 %" : percent(slack);
}

function constraints(study, table) {
  const bounds = table.column("value") && table.column("bound");
  const row = (i) => {
    const text = table.at("text", i) ?? "";
    const words = goalWords(study, text);
    return h("tr", {}, h("th", { scope: "row" }, words, words === text ? null : h("small", {}, h("code", {}, text))), bounds ? [cell(table.at("value", i)), cell(table.at("bound", i))] : null, h("td", { class: "number" }, slackText(table.at("slack", i), bounds)), h("td", {}, constraintMarks(study, table, i)));
  };
  const heads = [["constraint"], ...(bounds ? [["value", "number"], ["bound", "number"]] : []), ["slack", "number"], [""]];
  return h("div", {}, h("h3", {}, "Constraints at the best strategy"), plainTable("Constraints", heads, rowsOf(table).map(row)), h("p", { class: "note" }, "Slack: distance to the bound, in parts of it. “Decides”: at the border; relaxing it may improve the objective."));
}

/** The objectives of the checks, each with its name and units. */
function checkedObjectives(study, table) {
  const columns = table.columns.filter((column) => /^objective(_\d+)?$/.test(column.name));
  const objective = textAttribute(study.tables.get("best"), "objective", "objective");
  return columns.map((column) => (columns.length > 1 ? { column, name: objectiveLabel(column), units: objectiveUnits(study, column) } : { column, name: inWords(objective), units: column.units || unitsOfGoal(study, objective) }));
}

function checks(study, table) {
  const objectives = checkedObjectives(study, table);
  const probability = table.column("probability");
  const row = (i) => {
    const change = table.at("objective_change", i);
    const what = table.at("change", i);
    const says = table.column("says") ? table.at("says", i) : null;
    const broken = isBroken(table, i);
    const outcome = table.at("outcome", i);
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, table.at("check", i) ?? "", what ? h("small", {}, inWords(what)) : null, says ? h("small", {}, inWords(says)) : null),
      objectives.map(({ column, units }) => cell(column.at(i), units, column.most)),
      h("td", { class: "number" }, change === null || table.at("check", i) === "as found" ? "–" : percent(change)),
      probability ? h("td", { class: "number" }, percent(probability.at(i)), table.at("probability_low", i) === null ? null : h("small", {}, `${percent(table.at("probability_low", i))} to ${percent(table.at("probability_high", i))}`)) : null,
      h("td", { class: "number" }, number(table.at("violation", i), 3)),
      h("td", {}, mark(broken ? "broken" : "met", broken ? "broken" : "met"), broken && table.at("binding", i) ? h("small", {}, goalWords(study, table.at("binding", i))) : outcome ? h("small", {}, inWords(String(outcome))) : null),
    );
  };
  const heads = [["check"], ...objectives.map(({ name }) => [name, "number"]), ["change", "number"], ...(probability ? [["probability", "number"]] : []), ["violation", "number"], ["constraints"]];
  return h("div", {}, h("h3", {}, study.tables.has("pareto") ? "The knee, checked again" : "The best strategy, checked again"), plainTable("Checks", heads, rowsOf(table).map(row)));
}

export function findings(study) {
  const parts = [];
  const constraint = study.tables.get("constraints");
  const verification = study.tables.get("verification");
  if (constraint && constraint.rows) parts.push(constraints(study, constraint));
  if (verification && verification.rows) parts.push(checks(study, verification));
  return parts.length ? h("div", {}, parts) : null;
}

const KNOWN = ["searches", "evaluations", "constraints", "best", "verification", "pareto", "candidates", "comparison", "sensitivity", "sizing", "calibration", "calibration_curve", "population", "population_correlation"];

/** Tables this page has no picture for. */
export function otherTables(study) {
  const rest = [...study.tables.values()].filter((table) => !KNOWN.includes(table.name) && table.columns.length && table.rows);
  const evaluations = study.tables.get("evaluations");
  if (evaluations && evaluations.rows) rest.push(evaluations);
  if (rest.length === 0) return null;
  return h(
    "div",
    {},
    rest.map((table) =>
      h(
        "details",
        { open: table.name !== "evaluations" && table.rows <= 24 },
        h("summary", {}, table.name.replaceAll("_", " "), h("span", { class: "soft" }, ` ${table.rows} rows`)),
        attributesOf(table),
        genericTable(study, table, { name: table.name }),
      ),
    ),
  );
}

function attributesOf(table) {
  const entries = Object.entries(table.attributes ?? {}).filter(([name, value]) => value !== null && value !== "" && name !== "strategy_toml");
  return entries.length ? h("p", { class: "note" }, entries.map(([name, value]) => `${name.replaceAll("_", " ")}: ${typeof value === "number" ? number(value) : value}`).join("; ")) : null;
}

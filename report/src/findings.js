// What belongs to the best strategy: its constraints and the checks it went through.

import { h } from "./dom.js";
import { isBroken, objectiveLabel } from "./answer.js";
import { genericTable } from "./table.js";
import { number, percent } from "./words.js";

function cell(value, digits) {
  return h("td", { class: "number" }, number(value, digits));
}

function state(word) {
  return h("td", {}, h("span", { class: `state ${word}` }, word));
}

function rowsOf(table, make) {
  return Array.from({ length: table.rows }, (_, row) => make(row));
}

function headings(names) {
  return h("thead", {}, h("tr", {}, names.map(([name, kind]) => h("th", { scope: "col", class: kind }, name))));
}

function plainTable(name, heads, rows) {
  return h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": name }, h("table", { class: "plain" }, headings(heads), h("tbody", {}, rows)));
}

function constraints(table) {
  const bounds = table.column("value") && table.column("bound");
  const row = (i) => {
    const slack = table.at("slack", i);
    const word = slack !== null && slack < 0 ? "broken" : table.at("active", i) === 1 ? "decides" : "met";
    return h("tr", {}, h("th", { scope: "row" }, h("code", {}, table.at("text", i) ?? "")), bounds ? [cell(table.at("value", i)), cell(table.at("bound", i))] : null, h("td", { class: "number" }, bounds ? number(slack, 3) : slack !== null && Math.abs(slack) < 1e-4 ? "< 0.01 %" : percent(slack)), state(word));
  };
  const heads = [["constraint"], ...(bounds ? [["value", "number"], ["bound", "number"]] : []), ["slack", "number"], [""]];
  return h("div", {}, h("h3", {}, "Constraints at the best strategy"), plainTable("Constraints", heads, rowsOf(table, row)), h("p", { class: "note" }, "Slack: distance to the bound, in parts of it. “Decides”: at the border; relaxing it may improve the objective."));
}

function checks(study, table) {
  const objectives = table.columns.filter((column) => /^objective(_\d+)?$/.test(column.name));
  const probability = table.column("probability");
  const row = (i) => {
    const change = table.at("objective_change", i);
    const found = table.at("check", i) === "as found";
    const what = table.at("change", i);
    const broken = isBroken(table, i);
    const outcome = table.at("outcome", i);
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, table.at("check", i) ?? "", what ? h("small", {}, what) : null),
      objectives.map((column) => cell(column.at(i))),
      h("td", { class: "number" }, change === null || found ? "–" : percent(change)),
      probability ? h("td", { class: "number" }, percent(probability.at(i)), table.at("probability_low", i) === null ? null : h("small", {}, `${percent(table.at("probability_low", i))} to ${percent(table.at("probability_high", i))}`)) : null,
      cell(table.at("violation", i), 3),
      h("td", {}, h("span", { class: `state ${broken ? "broken" : "met"}` }, broken ? "broken" : "met"), broken && table.at("binding", i) ? h("small", {}, table.at("binding", i)) : outcome ? h("small", {}, String(outcome)) : null),
    );
  };
  const heads = [["check"], ...objectives.map((column) => [objectives.length > 1 ? objectiveLabel(study, column) : "objective", "number"]), ["change", "number"], ...(probability ? [["probability", "number"]] : []), ["violation", "number"], ["constraints"]];
  return h("div", {}, h("h3", {}, study.tables.has("pareto") ? "The knee, checked again" : "The best strategy, checked again"), plainTable("Checks", heads, rowsOf(table, row)));
}

export function findings(study) {
  const parts = [];
  const constraint = study.tables.get("constraints");
  const verification = study.tables.get("verification");
  if (constraint && constraint.rows) parts.push(constraints(constraint));
  if (verification && verification.rows) parts.push(checks(study, verification));
  return parts.length ? h("div", {}, parts) : null;
}

const KNOWN = ["searches", "evaluations", "constraints", "best", "verification", "pareto", "candidates", "comparison", "sensitivity"];

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
  const entries = Object.entries(table.attributes ?? {}).filter(([, value]) => value !== null && value !== "");
  return entries.length ? h("p", { class: "note" }, entries.map(([name, value]) => `${name.replaceAll("_", " ")}: ${typeof value === "number" ? number(value) : value}`).join("; ")) : null;
}

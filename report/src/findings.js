// What belongs to the best strategy: its constraints and the checks it went through.

import { h } from "./dom.js";
import { genericTable } from "./table.js";
import { number, percent } from "./words.js";

function constraintRow(table, row) {
  const text = table.at("text", row) ?? "";
  const slack = table.at("slack", row);
  const broken = slack !== null && slack < 0;
  const active = table.at("active", row) === 1;
  const state = broken ? "broken" : active ? "decides" : "met";
  return h("tr", {}, h("th", { scope: "row" }, h("code", {}, text)), h("td", { class: "number" }, number(table.at("value", row))), h("td", { class: "number" }, number(table.at("bound", row))), h("td", { class: "number" }, number(slack, 3)), h("td", {}, h("span", { class: `state ${state}` }, state)));
}

function headings(...names) {
  return h("thead", {}, h("tr", {}, names.map(([name, kind]) => h("th", { scope: "col", class: kind }, name))));
}

function constraints(table) {
  return h(
    "div",
    {},
    h("h3", {}, "Constraints at the best strategy"),
    h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Constraints" }, h("table", { class: "plain" }, headings(["constraint"], ["value", "number"], ["bound", "number"], ["slack", "number"], [""]), h("tbody", {}, Array.from({ length: table.rows }, (_, row) => constraintRow(table, row))))),
    h("p", { class: "note" }, "“Decides”: at the border; relaxing it would improve the objective."),
  );
}

function checks(table) {
  const cell = (value, digits) => h("td", { class: "number" }, number(value, digits));
  return h(
    "div",
    {},
    h("h3", {}, "The best strategy, checked again"),
    h(
      "div",
      { class: "scroll", tabindex: "0", role: "region", "aria-label": "Checks" },
      h(
        "table",
        { class: "plain" },
        headings(["check"], ["objective", "number"], ["change", "number"], ["violation", "number"], ["outcome"]),
        h(
          "tbody",
          {},
          Array.from({ length: table.rows }, (_, row) => {
            const change = table.at("objective_change", row);
            const violation = table.at("violation", row);
            const broken = (violation ?? 0) > 0;
            return h("tr", {}, h("th", { scope: "row" }, table.at("check", row) ?? ""), cell(table.at("objective", row)), h("td", { class: "number" }, change === null ? "–" : percent(change)), cell(violation, 3), h("td", {}, h("span", { class: `state ${broken ? "broken" : "met"}` }, String(table.at("outcome", row) ?? (broken ? "broken" : "met")))));
          }),
        ),
      ),
    ),
  );
}

export function findings(study) {
  const parts = [];
  const constraint = study.tables.get("constraints");
  const verification = study.tables.get("verification");
  if (constraint && constraint.rows) parts.push(constraints(constraint));
  if (verification && verification.rows) parts.push(checks(verification));
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

// Where the numbers come from: inputs, config, versions.

import { copy, download, h, scrollBox } from "./dom.js";
import { date, label, plural, shortText, thousands, valueText } from "./words.js";

function entry(name, ...value) {
  return h("div", {}, h("dt", {}, name), h("dd", {}, value));
}

function rangeOf(column) {
  const values = column.distinct;
  if (values.length === 0) return "no values";
  if (column.isText) return values.length <= 6 ? values.map(shortText).join(", ") : plural(values.length, "text");
  const ends = `${valueText(column, values[0])} to ${valueText(column, values[values.length - 1])}`;
  return values.length === 1 ? valueText(column, values[0]) : `${ends}, ${plural(values.length, "value")}`;
}

function inputs(study) {
  const { inputs: columns } = study.scenarios;
  if (columns.length === 0) return h("p", { class: "soft" }, "Nothing was varied.");
  return scrollBox(
    "Inputs",
    h("table", { class: "plain" }, h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "input"), h("th", { scope: "col" }, "key"), h("th", { scope: "col" }, "values"))), h("tbody", {}, columns.map((column) => h("tr", {}, h("th", { scope: "row" }, label(column.name)), h("td", {}, h("code", {}, column.name)), h("td", {}, rangeOf(column)))))),
  );
}

function config(study) {
  return h(
    "details",
    { class: "config" },
    h("summary", {}, "The resolved config"),
    h("div", { class: "tools" }, h("button", { type: "button", class: "quiet", onclick: () => copy(study.config, "Copied the config") }, "Copy"), h("button", { type: "button", class: "quiet", onclick: () => download("config.toml", "application/toml", study.config) }, "Download config.toml")),
    h("pre", { tabindex: "0" }, study.config),
  );
}

export function provenance(study) {
  const version = [study.unbruised_version, study.compiler, study.instruction_set].filter(Boolean).join(", ");
  return h(
    "div",
    {},
    h("h3", {}, "Inputs"),
    inputs(study),
    h("h3", {}, "Origin"),
    h(
      "dl",
      { class: "origin" },
      entry("Study", `${study.name}, ${study.kind}`),
      entry("Scenarios", thousands(study.scenarios.rows)),
      date(study.created_utc) ? entry("Written", date(study.created_utc)) : null,
      version ? entry("Program", `unbruised ${version}`) : null,
      entry("Read from", h("code", {}, study.source)),
      study.digest ? entry("Digest", h("code", {}, study.digest)) : null,
      study.config_sha256 ? entry("Config SHA-256", h("code", {}, study.config_sha256)) : null,
    ),
    study.summary.length ? h("details", {}, h("summary", {}, "The same in the words of the program"), h("pre", { tabindex: "0" }, study.summary.join("\n"))) : null,
    config(study),
  );
}

export function notices(document) {
  const text = document.getElementById("notices")?.textContent ?? "";
  return h("details", {}, h("summary", {}, "Licences of what this page contains"), h("pre", { tabindex: "0" }, text.trim()));
}

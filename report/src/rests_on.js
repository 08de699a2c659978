// What the answer rests on: every value of product, gripper and limits with its source, the assumed ones first.

import { h, scrollBox } from "./dom.js";
import { inWords } from "./tables.js";
import { label, plural, quantity, unitsOfKey } from "./words.js";

const STANDINGS = { assumed: "assumed", cited: "from a source", unsourced: "no source given" };
const ORDER = ["assumed", "unsourced", "cited"];

function valueText({ key, value }) {
  if (Array.isArray(value)) return value.map((each) => quantity(each, unitsOfKey(key), 4, Math.max(...value.map((one) => Math.abs(Number(one) || 0))))).join(key.endsWith("size_m") ? " × " : ", ");
  return typeof value === "number" ? quantity(value, unitsOfKey(key)) : String(value);
}

/** What the source adds to its standing. */
function remarkOf({ source }) {
  const more = source.replace(/^assumed:?\s*/, "");
  return more ? h("small", {}, inWords(more)) : null;
}

function row(source) {
  return h(
    "tr",
    {},
    h("th", { scope: "row", title: source.key }, label(source.key), h("small", {}, source.key.split(".")[0])),
    h("td", { class: "number" }, valueText(source)),
    h("td", {}, h("span", { class: `state ${source.standing === "cited" ? "met" : "decides"}` }, STANDINGS[source.standing]), remarkOf(source)),
  );
}

export function restsOn(study) {
  const { sources } = study;
  if (sources.length === 0) return null;
  const count = (standing) => sources.filter((each) => each.standing === standing).length;
  const rows = [...sources].sort((a, b) => ORDER.indexOf(a.standing) - ORDER.indexOf(b.standing)).map(row);
  const head = h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "value of"), h("th", { scope: "col", class: "number" }, "used"), h("th", { scope: "col" }, "where it comes from")));
  const sentence = `Of ${plural(sources.length, "value")} of product, gripper and limits ${count("assumed")} ${count("assumed") === 1 ? "is" : "are"} assumed, ${count("unsourced")} ${count("unsourced") === 1 ? "stands" : "stand"} in the study without a source, ${count("cited")} ${count("cited") === 1 ? "has" : "have"} one.`;
  return h("div", {}, h("p", {}, sentence, " What is assumed can be measured; a sensitivity study says which of them are worth it."), scrollBox("Sources", h("table", { class: "plain sources" }, head, h("tbody", {}, rows))));
}

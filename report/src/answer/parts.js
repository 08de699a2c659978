// What every answer is made of: a verdict, facts, a strategy in large letters.

import { h } from "../dom.js";
import { keyColumns } from "../tables.js";
import { label, percent, quantity } from "../words.js";

const MARKS = { good: "✓", warn: "!", bad: "×", none: "–" };

/** A verdict before it is drawn: answer.js looks at it soberly first. */
export function verdict(tone, text) {
  return { tone, text };
}

export function verdictElement({ tone, text }) {
  return h("p", { class: `verdict ${tone}` }, h("span", { "aria-hidden": "true" }, MARKS[tone]), text);
}

export function capital(text) {
  return text.replace(/^./, (letter) => letter.toUpperCase());
}

export function fact(name, value, remark = null) {
  return h("div", {}, h("dt", {}, typeof name === "string" ? capital(name) : name), h("dd", {}, value, remark ? h("small", {}, remark) : null));
}

export function probabilityFact(name, value, low, high, remark) {
  if (value === null) return null;
  return fact(name, percent(value), low === null ? null : `${remark} ${percent(low)} to ${percent(high)}`);
}

/** The searched keys with their values, in large letters. */
export function strategyList(table, row, kind = "strategy") {
  return h(
    "dl",
    { class: kind },
    keyColumns(table).map((column) => {
      const text = quantity(column.at(row), column.units);
      const space = text.lastIndexOf(" ");
      const [value, unit] = typeof column.at(row) === "number" && space > 0 ? [text.slice(0, space), text.slice(space + 1)] : [text, ""];
      return h("div", {}, h("dt", {}, label(column.name)), h("dd", {}, value, unit ? h("small", {}, unit) : null));
    }),
  );
}

/** A sentence of the program, with its keys in words. */
export function sentenceCase(text) {
  const plain = text.trim().replace(/\.$/, "");
  return plain ? `${capital(plain)}.` : "";
}

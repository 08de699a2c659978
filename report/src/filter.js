// What is typed into a filter: conditions on columns, and words.

import { leaf } from "./words.js";

function findColumn(columns, word) {
  const name = word.toLowerCase();
  return columns.find((column) => column.name.toLowerCase() === name) ?? columns.find((column) => leaf(column.name).toLowerCase() === name) ?? null;
}

const COMPARE = {
  "<": (a, b) => a < b,
  "<=": (a, b) => a <= b,
  ">": (a, b) => a > b,
  ">=": (a, b) => a >= b,
  "=": (a, b) => a === b,
  "!=": (a, b) => a !== b,
};

function condition(column, sign, text) {
  if (!column.isText) {
    const wanted = Number(text);
    if (Number.isNaN(wanted)) return null;
    // Numbers are compared as they are shown: 0.1 finds 0.1 though the column holds its nearest double.
    const same = (value) => Math.abs(value - wanted) <= 1e-9 * Math.max(Math.abs(value), Math.abs(wanted));
    if (sign === "=") return (row) => column.at(row) !== null && same(column.at(row));
    if (sign === "!=") return (row) => column.at(row) !== null && !same(column.at(row));
    return (row) => column.at(row) !== null && COMPARE[sign](column.at(row), wanted);
  }
  const wanted = text.replaceAll('"', "").toLowerCase();
  return (row) => COMPARE[sign](String(column.at(row) ?? "").toLowerCase(), wanted);
}

/** "cycle_time_s < 1.5, dropped": conditions on columns, other words anywhere in the texts. */
export function parseFilter(text, columns) {
  const tests = [];
  const rest = text.replace(/([\w.[\]]+)\s*(<=|>=|!=|=|<|>)\s*("[^"]*"|[^\s,]+)/g, (whole, name, sign, value) => {
    const column = findColumn(columns, name);
    if (!column) throw new Error(`no column named ${name}`);
    const test = condition(column, sign, value);
    if (!test) throw new Error(`${value} is no number`);
    tests.push(test);
    return " ";
  });
  const texts = columns.filter((column) => column.isText);
  for (const word of rest.split(/[\s,]+/).filter((each) => each && each.toLowerCase() !== "and")) {
    const wanted = word.toLowerCase();
    tests.push((row) => texts.some((column) => {
      const value = String(column.at(row) ?? "").toLowerCase();
      return value.includes(wanted) || value.replaceAll("_", " ").includes(wanted);
    }));
  }
  return (row) => tests.every((test) => test(row));
}

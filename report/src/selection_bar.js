// What is selected, in words, at the edge of the window; and the address that says the same.

import { copy, h } from "./dom.js";
import { label, number, outcomeLabel, plural, scaleFor, shortText, thousands } from "./words.js";

/** "grip force 1 to 2 N" */
function rangeWords(column, [low, high]) {
  if (column.isText) {
    const values = column.distinct.slice(low, high + 1).map(shortText);
    return `${label(column.name)} ${values.length > 3 ? `${values[0]} … ${values[values.length - 1]}` : values.join(", ") || "none"}`;
  }
  const { factor, unit } = scaleFor(column.units, column.most);
  return `${label(column.name)} ${number(low / factor)} to ${number(high / factor)}${unit ? ` ${unit}` : ""}`;
}

/** Each condition: [words, what takes it away]. */
function conditions(selection) {
  const { scenarios } = selection;
  const drop = (act) => () => { act(); selection.changed(); selection.relit(); };
  return [
    ...[...selection.outcomes].map((word) => [outcomeLabel(word), drop(() => selection.outcomes.delete(word))]),
    ...[...selection.ranges].map(([name, range]) => [rangeWords(scenarios.column(name), range), drop(() => selection.ranges.delete(name))]),
    ...(selection.filter ? [[selection.text.trim(), () => selection.setText("")]] : []),
    ...(selection.marked.size ? [[`${plural(selection.marked.size, "scenario")} marked`, drop(() => selection.marked.clear())]] : []),
  ];
}

/** The part of the page that the address names, without what is selected. */
function sectionOf(hash) {
  return hash.replace(/^#/, "").split("?")[0];
}

function writeAddress(selection) {
  const section = sectionOf(location.hash);
  const words = selection.address;
  const hash = words ? `#${section}?${words}` : section ? `#${section}` : "";
  if (hash === location.hash) return;
  history.replaceState(null, "", hash || location.pathname + location.search);
}

function followAddress(selection) {
  const read = () => {
    const at = location.hash.indexOf("?");
    if (at < 0) return writeAddress(selection); // a link inside the page
    selection.read(location.hash.slice(at + 1));
    document.getElementById(sectionOf(location.hash))?.scrollIntoView();
  };
  window.addEventListener("hashchange", read);
  if (location.hash.includes("?")) read();
}

export function selectionBar(study) {
  const { selection } = study;
  if (selection.scenarios.rows < 2) return null;
  const count = h("b", {});
  const list = h("ul", { class: "conditions" });
  const element = h(
    "aside",
    { class: "selection", "aria-label": "Selection", hidden: true },
    h("p", { role: "status", "aria-live": "polite" }, count),
    list,
    h("button", { type: "button", class: "quiet small", onclick: () => copy(location.href, "Copied the address of this selection") }, "Copy link"),
    h("button", { type: "button", class: "quiet small clear", onclick: () => selection.clear() }, "Clear"),
  );
  const show = () => {
    const found = conditions(selection);
    element.hidden = found.length === 0;
    document.documentElement.classList.toggle("selecting", selection.active);
    count.textContent = selection.active ? `${thousands(selection.count)} of ${plural(selection.scenarios.rows, "scenario")}` : "";
    list.replaceChildren(...found.map(([words, drop]) => h("li", {}, h("button", { type: "button", class: "condition", "aria-label": `Without ${words}`, onclick: drop }, h("span", {}, words), h("span", { "aria-hidden": "true" }, "×")))));
    writeAddress(selection);
  };
  selection.on(show);
  let told = 0;
  selection.onLight(() => { if (selection.marked.size !== told) show(); told = selection.marked.size; });
  followAddress(selection);
  return element;
}

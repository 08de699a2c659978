// What the colours and lines of a chart mean, as text beside it: it wraps, prints, and is there on a phone.

import { h } from "./dom.js";
import { outcomeLabel, outcomeVariable, thousands } from "./words.js";

export function swatch(background) {
  return h("i", { class: "swatch", style: `background:${background}` });
}

/** The outcomes that occur; with `counts`, how often; with a selection, a press selects those of this outcome. */
export function outcomeList(words, counts = null, selection = null) {
  const inside = (word) => [swatch(outcomeVariable(word)), h("span", {}, outcomeLabel(word), counts ? [" ", h("b", {}, thousands(counts[word]))] : null)];
  if (!selection || words.length < 2) return h("ul", { class: "legend" }, words.map((word) => h("li", {}, inside(word))));
  return h("ul", { class: "legend", "aria-label": "Outcomes; press one to select its scenarios" }, words.map((word) => h("li", {}, outcomeButton(word, inside(word), selection))));
}

function outcomeButton(word, inside, selection) {
  const button = h("button", { type: "button", class: "entry", "aria-pressed": "false", onclick: () => selection.toggleOutcome(word) }, inside);
  selection.on(() => button.setAttribute("aria-pressed", String(selection.outcomes.has(word))));
  return button;
}

/** Entries [colour, text] or [colour, text, "line" | "dashed" | "pale"]. */
export function legend(entries) {
  return h("ul", { class: "legend" }, entries.map(([colour, text, kind = "area"]) => h("li", {}, h("i", { class: kind === "line" || kind === "dashed" ? `stroke ${kind}` : "swatch", style: kind === "line" || kind === "dashed" ? `color:${colour}` : `background:${colour}${kind === "pale" ? ";opacity:.35" : ""}` }), text)));
}

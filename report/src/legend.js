// What the colours and lines of a chart mean, as text beside it: it wraps, prints, and is there on a phone.

import { h } from "./dom.js";
import { outcomeLabel, outcomeVariable, thousands } from "./words.js";

export function swatch(background) {
  return h("i", { class: "swatch", style: `background:${background}` });
}

/** The outcomes that occur; with `counts`, how often. */
export function outcomeList(words, counts = null) {
  return h("ul", { class: "legend" }, words.map((word) => h("li", {}, swatch(outcomeVariable(word)), outcomeLabel(word), counts ? [" ", h("b", {}, thousands(counts[word]))] : null)));
}

/** Entries [colour, text] or [colour, text, "line" | "dashed" | "pale"]. */
export function legend(entries) {
  return h("ul", { class: "legend" }, entries.map(([colour, text, kind = "area"]) => h("li", {}, h("i", { class: kind === "line" || kind === "dashed" ? `stroke ${kind}` : "swatch", style: kind === "line" || kind === "dashed" ? `color:${colour}` : `background:${colour}${kind === "pale" ? ";opacity:.35" : ""}` }), text)));
}

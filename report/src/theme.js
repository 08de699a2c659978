// Light and dark, and the colours charts are drawn with.

import { h } from "./dom.js";

/** By the outcomes' words, from the program's own table (studies/results/outcome_colours.hpp). */
let outcomeColours = new Map();

/** Where the paper is dark, near-black and near-white change places. */
const DARK_OUTCOMES = { not_grasped: "#6d747d", diverged: "#f2efe9", not_run: "#1b1f23", slipped: "#8cc3e6", dropped: "#4f86b9" };

/** Shapes tell the outcomes apart without colour. */
export const OUTCOME_SYMBOLS = {
  held: "circle",
  slipped: "triangle",
  dropped: "path://M0 0L10 0L5 9Z",
  damaged: "rect",
  not_grasped: "emptyCircle",
  diverged: "path://M1 0L5 4L9 0L10 1L6 5L10 9L9 10L5 6L1 10L0 9L4 5L0 1Z",
  out_of_range: "diamond",
  misplaced: "roundRect",
  not_run: "emptyRect",
};

const listeners = new Set();
const system = window.matchMedia("(prefers-color-scheme: dark)");
let printing = false;

function stored() {
  try {
    return localStorage.getItem("unbruised-theme");
  } catch {
    return null;
  }
}

export function isDark() {
  if (printing) return false;
  const chosen = document.documentElement.dataset.theme;
  return chosen ? chosen === "dark" : system.matches;
}

/** What charts need of the style sheet. */
export function colours() {
  const style = getComputedStyle(document.documentElement);
  const of = (name) => style.getPropertyValue(name).trim();
  return {
    ink: of("--ink"),
    soft: of("--soft"),
    line: of("--line"),
    paper: of("--paper"),
    raised: of("--raised"),
    accent: of("--accent"),
    bad: of("--bad"),
    faint: of("--faint"),
    font: of("--sans").replaceAll('"', "'"), // a drawing keeps it inside double quotes
    series: [of("--accent"), "#4a7fb0", "#e0702d", "#c583b0", of("--soft"), "#9fd0ee"],
  };
}

export function outcomeColour(word) {
  return (isDark() && DARK_OUTCOMES[word]) || outcomeColours.get(word) || "#888888";
}

/** Calls back after every change of the theme. */
export function onTheme(listener) {
  listeners.add(listener);
}

function changed() {
  const root = document.documentElement;
  for (const word of outcomeColours.keys()) root.style.setProperty(`--${word.replaceAll("_", "-")}`, outcomeColour(word));
  for (const listener of listeners) listener();
}

export function themeButton() {
  const name = h("span", { class: "theme-name" });
  const button = h("button", { type: "button", class: "quiet theme", onclick: toggle }, h("span", { class: "theme-mark", "aria-hidden": "true" }), name);
  const show = () => {
    name.textContent = isDark() ? "Light" : "Dark";
    button.setAttribute("aria-label", isDark() ? "Switch to light" : "Switch to dark");
  };
  function toggle() {
    const next = isDark() ? "light" : "dark";
    document.documentElement.dataset.theme = next;
    try {
      localStorage.setItem("unbruised-theme", next);
    } catch {
      // A page without storage forgets.
    }
    changed();
  }
  onTheme(show);
  show();
  return button;
}

/** @param known the outcomes' words and colours */
export function startTheme(known) {
  outcomeColours = known;
  const chosen = stored();
  if (chosen === "dark" || chosen === "light") document.documentElement.dataset.theme = chosen;
  system.addEventListener("change", changed);
  const print = (is) => () => {
    printing = is;
    document.documentElement.classList.toggle("printing", is);
    changed();
  };
  window.addEventListener("beforeprint", print(true));
  window.addEventListener("afterprint", print(false));
  changed();
}

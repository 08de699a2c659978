// The sizing sheet: what makers' rules ask for beside what was simulated, and what else the gripper has to bear.
// Every number and sentence comes from the table `sizing`; here they are only drawn, on one page of paper.

import { judgesDamage } from "./claims.js";
import { h, scrollBox, select } from "./dom.js";
import { keyColumns, rowsOf, textAttribute } from "./tables.js";
import { number, quantity, valuesText } from "./words.js";

const NAMES = {
  mass: "Mass", friction: "Friction", acceleration: "Largest acceleration", fingers: "Fingers", safety_factor: "Safety factor",
  just_holds: "Friction alone", maker_rule: "Makers' rule", pneumatic_rule: "Pneumatic rule of thumb", hold: "Holding begins", set_point: "To set", damage: "Damage begins",
  margin: "Margin", emergency_stop: "Emergency stop", largest_force: "Force of the drive", payload: "Payload", jaw_moment: "Moment on a jaw",
};
const LOAD = ["mass", "friction", "acceleration", "fingers", "safety_factor"];
const FORCES = ["just_holds", "maker_rule", "pneumatic_rule", "hold", "set_point", "damage", "emergency_stop"];
const LIMITS = ["margin", "largest_force", "payload", "jaw_moment"];
/** Which verdict is good, which asks for a look, which is bad. */
const TONES = { inside: "met", holds: "met", held: "met", within: "met", "too weak": "broken", "too strong": "broken", slips: "broken", beyond: "broken" };

/** What is not told where nobody looked at damage. */
const OF_DAMAGE = ["damage", "margin"];

/** The items of one strategy, by name. */
function itemsOf(study, table, strategy) {
  const told = (row) => judgesDamage(study) || !OF_DAMAGE.includes(table.at("item", row));
  const rows = rowsOf(table).filter((row) => table.at("strategy", row) === strategy && told(row));
  const item = (row) => Object.fromEntries(["value", "units", "together", "limit", "verdict", "says"].map((name) => [name, table.at(name, row)]));
  return new Map(rows.map((row) => [table.at("item", row), item(row)]));
}

function verdictCell({ verdict }) {
  return h("td", {}, verdict ? h("span", { class: `state ${TONES[verdict] ?? "decides"}` }, verdict) : null);
}

function forceRow(items, name) {
  const item = items.get(name);
  return h("tr", {}, h("th", { scope: "row" }, NAMES[name], h("small", {}, item.says)), h("td", { class: "number" }, quantity(item.value, "N", 3)), h("td", { class: "number" }, quantity(item.together, "N", 3)), verdictCell(item));
}

function limitRow(items, name) {
  const item = items.get(name);
  return h("tr", {}, h("th", { scope: "row" }, NAMES[name], h("small", {}, item.says)), h("td", { class: "number" }, quantity(item.value, item.units, 3)), h("td", { class: "number" }, quantity(item.limit, item.units, 3)), verdictCell(item));
}

function table(name, heads, rows) {
  return scrollBox(name, h("table", { class: "plain sheet" }, h("thead", {}, h("tr", {}, heads.map(([text, kind]) => h("th", { scope: "col", class: kind ?? null }, text)))), h("tbody", {}, rows)));
}

/** The window and where each rule points, on one line of force. */
function line(items) {
  const value = (name) => items.get(name)?.value ?? null;
  const marks = ["set_point", "just_holds", "maker_rule", "pneumatic_rule"].filter((name) => value(name) > 0);
  const [hold, damage] = [value("hold"), value("damage")];
  const all = [...marks.map(value), hold, damage].filter((force) => force > 0 && Number.isFinite(force));
  if (all.length < 2) return null;
  const [least, most] = [Math.min(...all) / 1.25, Math.max(...all) * 1.25];
  const at = (force) => (100 * Math.log(force / least)) / Math.log(most / least);
  const zone = (from, to, kind, text) => (to > from ? h("span", { class: `zone ${kind}`, style: `left:${at(from)}%;width:${at(to) - at(from)}%` }, h("em", {}, text)) : null);
  const opens = hold > 0 && (damage === null || damage > hold);
  return h(
    "div",
    { class: "ruler" },
    h(
      "div",
      { class: "track", role: "img", "aria-label": `Force of one finger: ${marks.map((name) => `${NAMES[name]} ${number(value(name), 3)} N`).join(", ")}.` },
      hold > 0 ? zone(least, Math.min(hold, damage ?? hold), "falls", "not held") : null,
      opens ? zone(hold, damage ?? most, "safe", "window") : null,
      damage > 0 ? zone(Math.max(damage, hold ?? damage), most, "marks", "marked") : null,
      marks.map((name) => h("span", { class: "pin", style: `left:${at(value(name))}%` })),
    ),
    marks.map((name) => h("div", { class: `tick-line ${name === "set_point" ? "set" : ""}` }, h("span", { style: `margin-left:${at(value(name))}%;transform:translateX(-${at(value(name))}%)` }, `${NAMES[name]} ${number(value(name), 3)} N`))),
    h("p", { class: "soft" }, "Force of one finger, logarithmic."),
  );
}

function sheet(study, items, note) {
  const facts = LOAD.map((name) => h("div", {}, h("dt", {}, NAMES[name]), h("dd", {}, quantity(items.get(name).value, items.get(name).units, 3), h("small", {}, items.get(name).says))));
  return [
    h("dl", { class: "facts" }, facts),
    line(items),
    table("Forces", [["force"], ["one finger", "number"], ["together", "number"], ["verdict"]], FORCES.filter((name) => items.has(name)).map((name) => forceRow(items, name))),
    table("Limits", [["limit"], ["here", "number"], ["allowed", "number"], ["verdict"]], LIMITS.filter((name) => items.has(name)).map((name) => limitRow(items, name))),
    note ? h("p", { class: "note" }, `${note[0].toUpperCase()}${note.slice(1)}.`) : null,
    h("p", { class: "note" }, `${study.name}, ${study.unbruised_version ?? ""}. The rules know weight, friction and a safety factor; the window is simulated, with the product's own limits.`),
  ];
}

/** Prints this section alone. */
function printAlone() {
  const root = document.documentElement;
  root.classList.add("sheet-only");
  window.addEventListener("afterprint", () => root.classList.remove("sheet-only"), { once: true });
  window.print();
}

function strategyName(strategies, row) {
  const own = keyColumns(strategies);
  return own.length ? valuesText(own, row) : `strategy ${row + 1}`;
}

export function sizing(study) {
  const found = study.tables.get("sizing");
  const strategies = study.tables.get("set_points");
  if (!found || !found.rows || !strategies) return null;
  const known = rowsOf(strategies);
  const best = known.find((row) => strategies.at("best", row) === 1) ?? known.find((row) => strategies.at("exists", row) === 1) ?? 0;
  const body = h("div", {});
  const show = (row) => body.replaceChildren(...sheet(study, itemsOf(study, found, row), textAttribute(found, "note")).filter(Boolean));
  const title = h("p", { class: "sheet-title" });
  const choose = (row) => {
    title.textContent = known.length > 1 ? `At ${strategyName(strategies, row)}` : "";
    show(row);
  };
  choose(best);
  const options = known.map((row) => ({ value: String(row), label: strategyName(strategies, row) }));
  return h(
    "div",
    {},
    h("div", { class: "controls" }, known.length > 1 ? select("For", options, String(best), (row) => choose(Number(row))) : null, h("button", { type: "button", class: "quiet", onclick: printAlone }, "Print this sheet")),
    title,
    body,
  );
}

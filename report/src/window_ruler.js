// The window as a ruler of grip forces: where the product falls, where it is safe, where it is marked, how well the
// borders are known, and where to set.

import { judgesDamage } from "./claims.js";
import { h } from "./dom.js";
import { legend } from "./legend.js";
import { number, plural, shortText } from "./words.js";

function tried(study) {
  const force = study.scenarios.column("strategy.grip_force_N");
  const values = force ? force.distinct : [];
  return values.length > 1 ? [values[0], values[values.length - 1]] : null;
}

/** Places along the ruler in per cent; logarithmic where the range is long. */
function scaleOf([least, most]) {
  const log = least > 0 && most / least > 4;
  const share = (force) => (log ? Math.log(force / least) / Math.log(most / least) : (force - least) / (most - least));
  return { log, at: (force) => 100 * Math.min(1, Math.max(0, share(force))) };
}

function borders(window, ends, judged, [least, most]) {
  const end = (name, row, side) => (row === null || row === undefined ? null : window.at(`${name}_bracket_${side}_N`, row));
  return {
    hold: { low: end("hold", ends.hold_row, "low") ?? least, high: ends.hold_force_N },
    damage: { low: judged ? ends.damage_force_N ?? most : most, high: end("damage", ends.damage_row, "high") ?? most },
  };
}

/** A line of its own for each label, pushed inside the ruler at its ends, so that none can cover another. */
function tick(at, kind, text) {
  return h("div", { class: `tick-line ${kind}` }, h("span", { style: `margin-left:${at}%;transform:translateX(-${at}%)` }, text));
}

function bracket(words, { low, high }) {
  return low === high ? `${words} at ${number(high)} N` : `${words} between ${number(low)} and ${number(high)} N`;
}

/** The forces that the gripper of the study can hold, where they are not all that were tried; null: nothing to draw. */
function settableForces(study, [least, most]) {
  const sourceOf = (key) => (study.scenarios.column(key)?.distinct.length > 1 ? undefined : study.sources.find((each) => each.key === key)?.value);
  const low = sourceOf("gripper.min_force_N") ?? 0;
  const high = sourceOf("gripper.max_force_N") ?? Infinity;
  if (low <= least && high >= most) return null;
  const words = high >= most ? `from ${number(low)} N on` : low <= least ? `up to ${number(high)} N` : `${number(low)} to ${number(high)} N`;
  return { low: Math.min(Math.max(low, least), most), high: Math.max(Math.min(high, most), least), words: `this gripper holds ${words}` };
}

/** A thin bar below the ruler, its words where the bar is. */
function reach(at, { low, high, words }) {
  return h("div", { class: "reach" }, h("span", { class: "reach-bar", style: `left:${at(low)}%;width:${at(high) - at(low)}%` }), tick((at(low) + at(high)) / 2, "gripper", words));
}

/** Forces at which specimens broke: a stroke each below the ruler, and in words how many of them the window's upper end spares. */
function rug({ measured }, at, [least, most], damage_N) {
  if (!measured) return null;
  const values = [...measured.rupture_N].sort((a, b) => a - b);
  const shown = values.filter((force) => force >= least && force <= most);
  const weaker = damage_N === null ? null : values.filter((force) => force < damage_N).length;
  const beyond = values.length - shown.length;
  const words = `${plural(values.length, "specimen")} broke between ${number(values[0], 3)} and ${number(values[values.length - 1], 3)} N (${shortText(measured.file.replace(/\.csv$/i, ""))})${beyond ? `, ${beyond} of them outside this range` : ""}${weaker === null ? "" : `; ${weaker || "none"} below the window's upper end`}`;
  return h("div", { class: "rug" }, h("div", { class: "strokes", "aria-hidden": "true" }, shown.map((force) => h("i", { style: `left:${at(force)}%` }))), h("p", {}, words));
}

export function windowRuler(study, ends, set = null) {
  const range = tried(study);
  if (!range) return null;
  const [least, most] = range;
  const { log, at } = scaleOf(range);
  const judged = judgesDamage(study);
  const { hold, damage } = borders(study.window, ends, judged, range);
  const gripper = settableForces(study, range);
  const safe = judged ? "held, unmarked" : "held";
  const zone = (from, to, kind, text) => {
    const width = at(to) - at(from);
    return width < 0.1 ? null : h("span", { class: `zone ${kind}`, style: `left:${at(from)}%;width:${width}%` }, text ? h("em", {}, text) : null);
  };
  const holdLine = ends.hold_is_bound ? null : tick(at(hold.high), "hold", bracket("holding begins", hold));
  const damageLine = ends.damage_is_bound || !judged ? null : tick(at(damage.low), "damage", bracket("damage begins", damage));
  return h(
    "div",
    { class: "ruler" },
    set ? tick(at(set.force_N), "set", `set ${number(set.force_N)} N`) : null,
    h(
      "div",
      { class: "track", role: "img", "aria-label": `Grip forces from ${number(least)} to ${number(most)} N: not held below ${number(hold.low)} N, ${safe} from ${number(hold.high)} to ${number(damage.low)} N${judged ? ", marked above" : ""}.${set ? ` To set: ${number(set.force_N)} N.` : ""}` },
      ends.hold_is_bound ? null : zone(least, hold.low, "falls", "not held"),
      ends.hold_is_bound ? null : zone(hold.low, hold.high, "unsure", ""),
      zone(hold.high, damage.low, "safe", set ? "" : safe),
      ends.damage_is_bound || !judged ? null : zone(damage.low, damage.high, "unsure", ""),
      ends.damage_is_bound || !judged ? null : zone(damage.high, most, "marks", "marked"),
      set ? h("span", { class: "spread", style: `left:${at(set.force_N - set.tolerance_N)}%;width:${at(set.force_N + set.tolerance_N) - at(set.force_N - set.tolerance_N)}%` }) : null,
      set ? h("span", { class: "pin", style: `left:${at(set.force_N)}%` }) : null,
    ),
    gripper ? reach(at, gripper) : null,
    rug(study, at, range, judged ? ends.damage_force_N ?? null : null),
    h("div", { class: "tick-ends" }, h("span", {}, `${number(least)} N`), h("span", {}, `${number(most)} N`)),
    holdLine,
    damageLine,
    legend([["color-mix(in srgb, var(--dropped) 26%, var(--paper))", "not held"], ["var(--safe)", safe], ...(judged ? [["color-mix(in srgb, var(--damaged) 30%, var(--paper))", "marked"]] : [])]),
    h("p", { class: "soft" }, `Grip forces tried, ${log ? "logarithmic" : "linear"}. Hatched: the border lies somewhere here.${set ? " Thin bar: how far the setting may be off." : ""}`),
  );
}

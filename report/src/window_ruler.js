// The window as a ruler of grip forces: where the product falls, where it is safe, where it is marked, and how well the borders
// are known.

import { h } from "./dom.js";
import { number } from "./words.js";

const WIDTH = 1000;

function tried(study) {
  const force = study.scenarios.column("strategy.grip_force_N");
  const values = force ? force.distinct : [];
  return values.length > 1 ? [values[0], values[values.length - 1]] : null;
}

export function windowRuler(study, window, common) {
  const range = tried(study);
  if (!range) return null;
  const [least, most] = range;
  const log = least > 0 && most / least > 4;
  const at = (force) => WIDTH * (log ? Math.log(force / least) / Math.log(most / least) : (force - least) / (most - least));
  const hold = { low: window.at("hold_bracket_low_N", common.hold_row) ?? least, high: common.hold_force_N };
  const damage = { low: common.damage_force_N, high: window.at("damage_bracket_high_N", common.damage_row) ?? most };
  const zone = (from, to, kind, text) => {
    const width = Math.max(0, at(to) - at(from));
    if (width < 1) return null;
    return h("span", { class: `zone ${kind}`, style: `left:${at(from) / 10}%;width:${width / 10}%` }, width > 90 ? h("em", {}, text) : null);
  };
  const tick = (force, side) =>
    h("span", { class: `tick ${side}`, style: `left:${Math.min(100, Math.max(0, at(force) / 10))}%` }, `${number(force)} N`);
  return h(
    "div",
    {
      class: "ruler",
      role: "img",
      "aria-label": `Grip forces from ${number(least)} to ${number(most)} N: not held below ${number(common.hold_force_N)} N, held and unmarked up to ${number(common.damage_force_N)} N, marked above.`,
    },
    h(
      "div",
      { class: "track" },
      common.hold_is_bound ? null : zone(least, hold.low, "falls", "not held"),
      common.hold_is_bound ? null : zone(hold.low, hold.high, "unsure", ""),
      zone(common.hold_force_N, common.damage_force_N, "safe", "held, unmarked"),
      common.damage_is_bound ? null : zone(damage.low, damage.high, "unsure", ""),
      common.damage_is_bound ? null : zone(damage.high, most, "marks", "marked"),
    ),
    h("div", { class: "ticks" }, tick(least, "end"), common.hold_is_bound ? null : tick(common.hold_force_N, "edge"), common.damage_is_bound ? null : tick(common.damage_force_N, "edge"), tick(most, "end last")),
    h("p", { class: "soft" }, `Grip forces tried, ${log ? "logarithmic" : "linear"}. Hatched: the border lies somewhere here.`),
  );
}


// What happened when: ticks on the time line, and their words.

import { h } from "../dom.js";
import { listed, number, outcomeLabel } from "../words.js";

const MARKS = { touch: "●", part: "○", slip: "≈", stop: "■", decided: "▲" };
const VERBS = { touch: ["touches", "touch"], part: ["lets go", "let go"], slip: ["slips", "slip"] };

/** "left pad"; of a listed finger or surface its number, as people count. */
export function surfaceWords(name) {
  const found = /^(?:gripper\.finger|cell\.surface)\.(\d+)$/.exec(name);
  if (!found) return name;
  return `${name.startsWith("gripper") ? "finger" : "surface"} ${Number(found[1]) + 1}`;
}

export function eventWords({ kind, where }) {
  if (kind === "stop") return "emergency stop";
  if (kind === "decided") return outcomeLabel(where[0]);
  const [one, many] = VERBS[kind];
  return `${listed(where.map(surfaceWords))} ${where.length > 1 ? many : one}`;
}

/** Events of one kind that stand nearer than a hundredth of the time line are one, of its surfaces in their order. */
function mergedEvents({ events, surfaces }, end) {
  const merged = [];
  for (const event of events) {
    const near = merged.find((each) => each.kind === event.kind && event.time_s - each.time_s < 0.01 * end);
    if (near) {
      if (!near.where.includes(event.where)) near.where.push(event.where);
    } else merged.push({ ...event, where: [event.where] });
  }
  const order = surfaces.map(({ name }) => name);
  for (const event of merged) event.where.sort((a, b) => order.indexOf(a) - order.indexOf(b));
  return merged;
}

/** @param pick (time) => called for a click */
export function eventTicks(model, end, pick) {
  return mergedEvents(model, end).map((event) => {
    const text = `${eventWords(event)} at ${number(event.time_s, 4)} s`;
    return h("button", { type: "button", class: `tick ${event.kind}`, style: `left:${(100 * event.time_s) / end}%`, title: text, "aria-label": text, onclick: () => pick(event.time_s) }, h("span", { "aria-hidden": "true" }, MARKS[event.kind]));
  });
}

// What the page says about one scenario wherever the pointer meets it.

import { commandText, copy, h } from "./dom.js";
import { causeWords } from "./goals.js";
import { label, outcomeLabel, quantity, shortText, valueText } from "./words.js";

const SHOWN = ["cycle_time_s", "friction_margin_min", "permanent_set_max_m", "contact_yield_ratio_max", "peak_finger_force_N", "slip_max_m"];

export function replayCommand(study, id) {
  return study.replay_command ? `${study.replay_command} ${id}` : null;
}

/** A click on a mark copies the command that replays its scenario. */
export function copyReplay(study, id) {
  const text = replayCommand(study, id);
  if (text) copy(text, `Copied the command that replays scenario ${id}`);
}

function line(name, value) {
  return h("div", { class: "tip-line" }, h("span", {}, name), h("b", {}, value));
}

export function tip(...children) {
  return h("div", { class: "tip" }, children);
}

export { line as tipLine };

export function scenarioTip(study, row, extra = []) {
  const { scenarios } = study;
  const id = scenarios.at("id", row);
  const outcome = scenarios.at("outcome", row);
  const cause = scenarios.at("cause", row);
  const replay = replayCommand(study, id);
  const metrics = SHOWN.filter((name) => scenarios.at(name, row) !== null).slice(0, 4);
  return tip(
    h("div", { class: "tip-head" }, h("i", { class: "swatch", style: `background:var(--${outcome.replaceAll("_", "-")})` }), h("b", {}, outcomeLabel(outcome)), h("span", {}, `scenario ${id}`)),
    cause ? h("p", {}, causeWords(study, row)) : null,
    extra,
    scenarios.inputs.filter((column) => !column.isNearlyConstant || scenarios.rows < 3 || column.at(row) !== column.usual).slice(0, 8).map((column) => line(label(column.name), column.isText ? shortText(column.at(row)) : valueText(column, column.at(row)))),
    metrics.length ? h("hr") : null,
    metrics.map((name) => line(label(name), quantity(scenarios.at(name, row), scenarios.column(name).units))),
    replay ? commandText(replay, { class: "replay" }) : null,
    replay ? h("p", { class: "hint" }, "Click copies the command.") : null,
  );
}

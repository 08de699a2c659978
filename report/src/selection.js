// What is selected of the scenarios, once for the whole page: by words, by outcomes, by ranges brushed in charts. Which scenario the
// pointer is at, and which are marked for good. All of it but the pointer stands in the address, so that it can be sent to somebody.

import { parseFilter } from "./filter.js";
import { OUTCOMES } from "./words.js";

const MARKED_MOST = 60;

/** Where a value stands along a column: the number itself; of texts their order of appearance. */
export function placeIn(column) {
  if (!column.isText) return column.at;
  const index = new Map(column.distinct.map((value, i) => [value, i]));
  return (row) => index.get(column.at(row)) ?? null;
}

/** An end of a brushed range, to a thousandth of what the column spans: what is shown is what is applied. */
function rounded(value, span) {
  if (value === 0 || !(span > 0)) return value;
  const step = 10 ** Math.min(Math.floor(Math.log10(span)) - 3, Math.floor(Math.log10(Math.abs(value))) - 2);
  return Number((Math.round(value / step) * step).toPrecision(12));
}

function spanOf(column) {
  const { distinct } = column;
  return column.isText ? distinct.length : distinct[distinct.length - 1] - distinct[0];
}

export class Selection {
  constructor(scenarios) {
    this.scenarios = scenarios;
    this.text = "";
    this.problem = "";
    this.filter = null;
    this.outcomes = new Set();
    this.ranges = new Map();
    this.marked = new Set();
    this.lit = null;
    this.listeners = new Set();
    this.watchers = new Set();
    this.passing = null;
  }

  /** Calls back after every change of what is selected. */
  on(listener) {
    this.listeners.add(listener);
  }

  /** Calls back when another scenario is lit or marked. */
  onLight(watcher) {
    this.watchers.add(watcher);
  }

  changed() {
    this.passing = null;
    for (const listener of this.listeners) listener(this);
  }

  relit() {
    for (const watcher of this.watchers) watcher(this);
  }

  get active() {
    return this.filter !== null || this.outcomes.size > 0 || this.ranges.size > 0;
  }

  test() {
    const tests = [];
    if (this.outcomes.size) tests.push((row) => this.outcomes.has(this.scenarios.at("outcome", row)));
    for (const [name, [low, high]] of this.ranges) {
      const place = placeIn(this.scenarios.column(name));
      tests.push((row) => { const value = place(row); return value !== null && value >= low && value <= high; });
    }
    if (this.filter) tests.push(this.filter);
    return (row) => tests.every((each) => each(row));
  }

  /** 1 per scenario that is selected. */
  get mask() {
    if (!this.passing) {
      const passes = this.test();
      this.passing = Uint8Array.from({ length: this.scenarios.rows }, (_, row) => (passes(row) ? 1 : 0));
    }
    return this.passing;
  }

  has(row) {
    return !this.active || this.mask[row] === 1;
  }

  get count() {
    return this.active ? this.mask.reduce((sum, each) => sum + each, 0) : this.scenarios.rows;
  }

  /** @returns false where the text is no filter; then nothing is filtered by it */
  setText(text) {
    this.text = text;
    this.problem = "";
    this.filter = null;
    if (text.trim()) {
      try {
        this.filter = parseFilter(text, this.scenarios.columns);
      } catch (error) {
        this.problem = error.message;
      }
    }
    this.changed();
    return this.problem === "";
  }

  toggleOutcome(word) {
    if (!this.outcomes.delete(word)) this.outcomes.add(word);
    this.changed();
  }

  /** @param ranges [[column, [low, high] or null], ...]; places where the column is a text */
  setRanges(ranges) {
    for (const [column, range] of ranges) {
      if (!range) {
        this.ranges.delete(column.name);
        continue;
      }
      const span = spanOf(column);
      const [low, high] = [Math.min(...range), Math.max(...range)];
      this.ranges.set(column.name, column.isText ? [Math.ceil(low - 1e-9), Math.floor(high + 1e-9)] : [rounded(low, span), rounded(high, span)]);
    }
    this.changed();
  }

  clear() {
    this.text = "";
    this.problem = "";
    this.filter = null;
    this.outcomes.clear();
    this.ranges.clear();
    this.marked.clear();
    this.changed();
    this.relit();
  }

  /** The pointer is at this row, or at none (null). */
  light(row) {
    if (this.lit === row) return;
    this.lit = row;
    this.relit();
  }

  toggleMark(row) {
    if (!this.marked.delete(row) && this.marked.size < MARKED_MOST) this.marked.add(row);
    this.relit();
  }

  /** "outcome=held&in=strategy.grip_force_N:1:2"; empty where nothing is selected. */
  get address() {
    const words = new URLSearchParams();
    if (this.text.trim()) words.append("filter", this.text.trim());
    if (this.outcomes.size) words.append("outcome", [...this.outcomes].join(","));
    for (const [name, range] of this.ranges) words.append("in", [name, ...range].join(":"));
    if (this.marked.size) words.append("marked", [...this.marked].map((row) => this.scenarios.at("id", row)).join(","));
    return words.toString();
  }

  /** What an address says, as far as this study has it. */
  read(address) {
    const words = new URLSearchParams(address);
    this.outcomes = new Set((words.get("outcome") ?? "").split(",").filter((word) => OUTCOMES.includes(word)));
    this.ranges = new Map(words.getAll("in").map((text) => this.readRange(text)).filter(Boolean));
    this.marked = new Set((words.get("marked") ?? "").split(",").map((id) => this.scenarios.rowOf.get(Number(id))).filter((row) => row !== undefined).slice(0, MARKED_MOST));
    this.setText(words.get("filter") ?? "");
    this.relit();
  }

  readRange(text) {
    const found = /^(.+):([^:]+):([^:]+)$/.exec(text);
    const column = found && [...this.scenarios.inputs, ...this.scenarios.metrics].find((each) => each.name === found[1]);
    const range = found && [Number(found[2]), Number(found[3])];
    return column && range.every(Number.isFinite) ? [column.name, range] : null;
  }
}

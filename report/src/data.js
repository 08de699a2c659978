// The study as the program wrote it into the page: one JSON document, and the bytes of its long columns.

import { blockOf, numbersOf, plainValue } from "./config.js";
import { learnWords } from "./words.js";

const TYPES = { u8: Uint8Array, u16: Uint16Array, f32: Float32Array, f64: Float64Array };

function decodeBase64(text) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i += 1) bytes[i] = letters.charCodeAt(i);
  return bytes.buffer;
}

/** Values of a column by row; numbers that do not exist are null. */
function reader(values, buffer) {
  if (Array.isArray(values)) return { rows: values.length, at: (i) => values[i] ?? null };
  if ("constant" in values) return { rows: values.rows, at: () => values.constant };
  const cells = new TYPES[values.type](buffer, values.at, values.rows);
  if (values.words) return { rows: values.rows, at: (i) => values.words[cells[i]] ?? null };
  return { rows: values.rows, at: (i) => (Number.isNaN(cells[i]) ? null : cells[i]), single: values.type === "f32" };
}

export class Column {
  constructor({ name, units = "", long_name = "", values }, buffer) {
    this.name = name;
    this.units = units;
    this.longName = long_name;
    const { rows, at, single = false } = reader(values, buffer);
    this.rows = rows;
    this.at = at;
    this.single = single;
  }

  /** Without those that do not exist. */
  numbers() {
    const found = [];
    for (let i = 0; i < this.rows; i += 1) {
      const value = this.at(i);
      if (typeof value === "number") found.push(value);
    }
    return found;
  }

  get isText() {
    if (this.text === undefined) {
      this.text = false;
      for (let i = 0; i < this.rows && !this.text; i += 1) {
        const value = this.at(i);
        if (value !== null) {
          this.text = typeof value === "string";
          break;
        }
      }
    }
    return this.text;
  }

  /** Different values: numbers ascending, texts in order of appearance. */
  get distinct() {
    if (!this.different) {
      const seen = new Set();
      for (let i = 0; i < this.rows; i += 1) {
        const value = this.at(i);
        if (value !== null) seen.add(value);
      }
      this.different = [...seen];
      if (!this.isText) this.different.sort((a, b) => a - b);
    }
    return this.different;
  }

  /** Does nearly every row have the same value? So it is with what only the checks of a search or a window change. */
  get isNearlyConstant() {
    if (this.nearlyConstant === undefined) {
      const counts = new Map();
      if (this.distinct.length < 20) for (let i = 0; i < this.rows; i += 1) counts.set(this.at(i), (counts.get(this.at(i)) ?? 0) + 1);
      const [value, count] = [...counts].sort((a, b) => b[1] - a[1])[0] ?? [null, 0];
      this.usual = value;
      const checked = this.name === "simulation.time_step_s" && this.distinct.length === 2 && this.distinct[1] === 2 * this.distinct[0] && value === this.distinct[1];
      this.nearlyConstant = count > 0.95 * this.rows || checked;
    }
    return this.nearlyConstant;
  }

  /** The greatest size of its numbers: what one unit for all of them has to suit. */
  get most() {
    if (this.greatest === undefined) this.greatest = this.numbers().reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    return this.greatest;
  }

  get varies() {
    return this.distinct.length > 1;
  }
}

export class Table {
  constructor(columns, rows, extra = {}) {
    this.columns = columns;
    this.rows = rows;
    Object.assign(this, extra);
    this.byName = new Map(columns.map((column) => [column.name, column]));
  }

  column(name) {
    return this.byName.get(name) ?? null;
  }

  /** A cell, or null where the column or the value does not exist. */
  at(name, row) {
    return this.byName.get(name)?.at(row) ?? null;
  }
}

function plainColumn(name, units, longName, values, buffer) {
  return new Column({ name, units, long_name: longName, values }, buffer);
}

function readScenarios(data, buffer, words) {
  const code = plainColumn("outcome", "", "outcome", data.outcome, buffer);
  const outcome = {
    name: "outcome",
    units: "",
    longName: "how the scenario ended",
    rows: data.rows,
    isText: true,
    at: (row) => (code.at(row) < 0 ? "not_run" : words[code.at(row)]),
  };
  const inputs = data.inputs.map((each) => new Column(each, buffer));
  const metrics = data.metrics.map((each) => new Column(each, buffer));
  const id = plainColumn("id", "", "number of the scenario", data.id, buffer);
  const cause = plainColumn("cause", "", "what decided the outcome", data.cause, buffer);
  const time = plainColumn("outcome_time_s", "s", "when the outcome was decided", data.outcome_time_s, buffer);
  const table = new Table([id, outcome, ...inputs, ...metrics, time, cause], data.rows, { inputs, metrics, sevenDigits: data.seven_digits });
  table.rowOf = new Map();
  for (let row = 0; row < data.rows; row += 1) table.rowOf.set(id.at(row), row);
  table.counts = {};
  for (let row = 0; row < data.rows; row += 1) table.counts[outcome.at(row)] = (table.counts[outcome.at(row)] ?? 0) + 1;
  return table;
}

function readWindow(data, buffer) {
  const inputs = data.inputs.map((each) => new Column(each, buffer));
  const rest = data.columns.map((each) => new Column(each, buffer));
  return new Table([...inputs, ...rest], data.rows, { inputs, common: data.common });
}

/** What the answer may claim and what it rests on; older results say nothing of it. */
function readClaims(page) {
  const block = blockOf(page.study.config, "[limits]");
  const limits = numbersOf(block);
  const damageLimits = page.damage_limits ?? [];
  const isJudged = damageLimits.some(({ key }) => limits[key] !== undefined);
  return {
    limits,
    slipLimits: page.slip_limits,
    damageLimits,
    damage: page.study.damage ?? (plainValue(block.damage) === "not considered" ? "not considered" : isJudged ? "judged" : "not looked at"),
    warnings: [...new Set([page.study.damage ? page.study.damage_note : "", ...(page.warnings ?? [])].filter(Boolean))],
    sources: page.sources ?? [],
  };
}

export function readStudy(document) {
  const page = JSON.parse(document.getElementById("study").textContent);
  const buffer = decodeBase64(document.getElementById("columns").textContent);
  learnWords(page.words);
  const tables = new Map();
  for (const each of page.tables) {
    const columns = each.columns.map((column) => new Column(column, buffer));
    tables.set(each.name, new Table(columns, each.rows, { name: each.name, row: each.row, attributes: each.attributes }));
  }
  return {
    ...page.study,
    outcomeColours: new Map([...page.outcome_words.map((word, i) => [word, page.outcome_colours[i]]), ["not_run", page.not_run_colour]]),
    scenarios: readScenarios(page.scenarios, buffer, page.outcome_words),
    window: page.window ? readWindow(page.window, buffer) : null,
    bestRow: page.best_row ?? null,
    tables,
    trace: page.trace ? readTrace(page.trace, buffer) : null,
    replays: (page.replays ?? []).map((each) => ({ ...each, trace: readTrace(each.trace, buffer) })),
    sound: page.sound ?? null,
    measured: page.measured ?? null,
    buffer,
    column: (values) => reader(values, buffer),
    ...readClaims(page),
  };
}

function readTrace(data, buffer) {
  const signals = data.signals.map((signal) => ({
    ...signal,
    curves: signal.curves.map((curve) => plainColumn(curve.name, signal.units, "", curve.values, buffer)),
  }));
  const { contacts } = data;
  const events = contacts && new Table(["time_s", "surface", "kind"].map((name) => plainColumn(name, name === "time_s" ? "s" : "", "", contacts[name], buffer)), contacts.rows);
  return { ...data, time: plainColumn("time_s", "s", "time", data.time_s, buffer), signals, contacts: events ?? null };
}

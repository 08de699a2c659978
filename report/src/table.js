// A table that sorts, filters, pages and leaves as CSV.

import { csvOf, fileName } from "./csv.js";
import { copy, download, freshId, h, scrollBox } from "./dom.js";
import { parseFilter } from "./filter.js";
import { replayCommand } from "./scenario.js";
import { inWords } from "./tables.js";
import { label, number, OUTCOMES, outcomeLabel, plural, scaleFor, thousands } from "./words.js";

const PAGE = 25;
/** Columns whose texts speak of keys. */
const IN_KEYS = new Set(["start", "key", "note", "binding", "termination"]);

/** Ascending or descending; what does not exist comes last either way. */
function sortRows(rows, column, descending) {
  const sign = descending ? -1 : 1;
  const keys = new Map(rows.map((row) => [row, column.at(row)]));
  const compare = column.isText ? (a, b) => (a < b ? -1 : a > b ? 1 : 0) : (a, b) => a - b;
  return [...rows].sort((one, other) => {
    const [a, b] = [keys.get(one), keys.get(other)];
    if (a === null || b === null) return (a === null) - (b === null) || one - other;
    return sign * compare(a, b) || one - other;
  });
}

/** How a column shows its numbers: all in one unit. */
function formatOf(column) {
  if (column.isText) return { unit: "", text: (value) => (column.name === "outcome" ? outcomeLabel(value) : IN_KEYS.has(column.name) ? inWords(value) : value ?? "–") };
  let most = 0;
  for (let row = 0; row < column.rows; row += 1) most = Math.max(most, Math.abs(column.at(row) ?? 0));
  const { factor, unit } = scaleFor(column.units, most);
  const whole = column.name === "id" || column.name === "scenario";
  return { unit, text: (value) => (value === null ? "–" : whole ? String(value) : number(value / factor)) };
}

class DataTable {
  constructor({ columns, rows, name, titles = {}, chips = null, replay = null, all = columns, filterable = true, selection = null }) {
    Object.assign(this, { columns, rows, name, titles, chips, replay, all, filterable, selection });
    this.order = Array.from({ length: rows }, (_, row) => row);
    this.sort = null;
    this.page = 0;
    this.filter = () => true;
    this.formats = new Map();
    this.build();
    this.refresh();
    if (selection) this.followSelection();
  }

  /** The table of scenarios shows what the page has selected, and selects for all of it. */
  followSelection() {
    const { selection } = this;
    selection.on(() => {
      if (selection.text.trim() !== this.input.value.trim()) this.input.value = selection.text;
      this.tell(selection.problem);
      this.refresh();
    });
    selection.onLight(() => this.light());
    this.body.addEventListener("pointerover", (event) => selection.light(this.rowAt(event.target)));
    this.body.addEventListener("pointerleave", () => selection.light(null));
    this.body.addEventListener("focusin", (event) => selection.light(this.rowAt(event.target)));
    this.body.addEventListener("focusout", () => selection.light(null));
  }

  rowAt(element) {
    const row = element.closest("tr")?.dataset.row;
    return row === undefined ? null : Number(row);
  }

  light() {
    for (const element of this.body.children) {
      const row = this.rowAt(element);
      element.classList.toggle("lit", row !== null && row === this.selection.lit);
      element.classList.toggle("marked", this.selection.marked.has(row));
    }
  }

  formatOf(column) {
    if (!this.formats.has(column)) this.formats.set(column, formatOf(column));
    return this.formats.get(column);
  }

  build() {
    const id = freshId("filter");
    this.message = h("p", { class: "message", role: "status", "aria-live": "polite" });
    this.input = h("input", { id, type: "search", placeholder: this.columns.some((column) => column.name === "cycle_time_s") ? "cycle_time_s < 1.5, dropped" : "column < value, or words", spellcheck: "false", autocomplete: "off", oninput: () => this.read() });
    this.chipBox = this.chips ? h("div", { class: "chips", role: "group", "aria-label": "Outcomes shown" }, this.chips.map((word) => this.chip(word))) : null;
    this.head = h("thead");
    this.body = h("tbody");
    this.pager = h("nav", { class: "pager", "aria-label": `Pages of ${this.name}` });
    const table = h("table", { class: "data" }, this.head, this.body);
    const tools = h(
      "div",
      { class: "tools" },
      this.filterable ? h("span", { class: "choice wide" }, h("label", { for: id }, "Filter"), this.input) : null,
      this.chipBox,
      h("button", { type: "button", class: "quiet csv", onclick: () => this.save() }, "Download CSV"),
    );
    this.element = h("div", { class: "table-box" }, tools, this.message, scrollBox(`Table: ${this.name}`, table), this.pager, this.chooser());
  }

  chip(word) {
    const { selection } = this;
    const button = h("button", { type: "button", class: "chip", "aria-pressed": "false", onclick: () => selection.toggleOutcome(word) }, h("i", { class: "swatch", style: `background:var(--${word.replaceAll("_", "-")})` }), outcomeLabel(word));
    selection.on(() => button.setAttribute("aria-pressed", String(selection.outcomes.has(word))));
    return button;
  }

  chooser() {
    if (this.all.length <= this.columns.length) return null;
    return h(
      "details",
      { class: "chooser" },
      h("summary", {}, "Columns"),
      h("div", {}, this.all.map((column) => {
        const box = h("input", { type: "checkbox", onchange: () => {
          this.columns = this.all.filter((each) => (each === column ? box.checked : this.columns.includes(each)));
          this.refresh();
        } });
        box.checked = this.columns.includes(column);
        return h("label", { title: column.longName || null }, box, this.titleOf(column));
      })),
    );
  }

  titleOf(column) {
    return this.titles[column.name] ?? (column.name === "id" ? "scenario" : label(column.name));
  }

  read() {
    if (this.selection) {
      this.selection.setText(this.input.value);
      return;
    }
    let problem = "";
    try {
      this.filter = parseFilter(this.input.value, this.all);
    } catch (error) {
      problem = error.message;
    }
    this.tell(problem);
    this.refresh();
  }

  tell(problem) {
    this.problem = problem;
    if (problem) this.input.setAttribute("aria-invalid", "true");
    else this.input.removeAttribute("aria-invalid");
  }

  refresh() {
    const passes = this.selection ? (row) => this.selection.has(row) : this.filter;
    let rows = [];
    for (let row = 0; row < this.rows; row += 1) if (passes(row)) rows.push(row);
    if (this.sort) rows = sortRows(rows, this.sort.column, this.sort.descending);
    this.order = rows;
    this.page = 0;
    this.message.textContent = this.problem || (rows.length < this.rows ? `${thousands(rows.length)} of ${plural(this.rows, "row")}` : "");
    this.message.hidden = this.message.textContent === "";
    this.drawHead();
    this.draw();
  }

  drawHead() {
    this.head.replaceChildren(
      h(
        "tr",
        {},
        this.columns.map((column) => {
          const sorted = this.sort?.column === column ? (this.sort.descending ? "descending" : "ascending") : null;
          const { unit } = this.formatOf(column);
          return h(
            "th",
            { scope: "col", class: column.isText ? null : "number", "aria-sort": sorted },
            h("button", { type: "button", title: column.longName || column.name, "data-column": column.name, onclick: () => this.sortBy(column) }, this.titleOf(column), unit ? h("small", {}, ` ${unit}`) : null, h("span", { class: "arrow", "aria-hidden": "true" }, sorted ? (sorted === "ascending" ? " ↑" : " ↓") : "")),
          );
        }),
      ),
    );
  }

  sortBy(column) {
    const again = this.sort?.column === column;
    this.sort = again && this.sort.descending ? null : { column, descending: again };
    this.refresh();
    this.head.querySelector(`[data-column="${CSS.escape(column.name)}"]`)?.focus();
  }

  draw() {
    const from = this.page * PAGE;
    this.body.replaceChildren(...this.order.slice(from, from + PAGE).map((row) => this.rowElement(row)));
    if (this.selection) this.light();
    if (this.order.length === 0) this.body.append(h("tr", {}, h("td", { colspan: this.columns.length, class: "empty" }, "No row fits the filter.")));
    this.drawPager();
  }

  rowElement(row) {
    return h(
      "tr",
      this.selection ? { "data-row": String(row) } : {},
      this.columns.map((column) => {
        const value = column.at(row);
        const text = this.formatOf(column).text(value);
        const swatch = column.name === "outcome" ? h("i", { class: "swatch", style: `background:var(--${String(value).replaceAll("_", "-")})` }) : null;
        if (this.selection && this.rows > 1 && column.name === "id") return h("td", { class: "number" }, this.markBox(row, text), this.replay ? this.replayButton(row, text) : text);
        if (this.replay && value !== null && ["id", "scenario"].includes(column.name)) return h("td", { class: "number" }, this.replayButton(row, text));
        return h("td", { class: column.isText ? (column.name === "cause" ? "text" : null) : "number" }, swatch, text);
      }),
    );
  }

  /** Marks a scenario in every chart, for good. */
  markBox(row, text) {
    const box = h("input", { type: "checkbox", class: "mark", "aria-label": `mark scenario ${text}`, title: "mark this scenario in every chart", onchange: () => this.selection.toggleMark(row) });
    box.checked = this.selection.marked.has(row);
    return box;
  }

  /** The number of a scenario is a button that copies its command. */
  replayButton(row, text) {
    return h("button", { type: "button", class: "link", title: "copy the command that replays this scenario", "aria-label": `${text}, copy the command that replays this scenario`, onclick: () => this.replay(row) }, text);
  }

  drawPager() {
    const pages = Math.ceil(this.order.length / PAGE);
    if (pages < 2) return this.pager.replaceChildren();
    const go = (text, to, name) => h("button", { type: "button", class: "quiet small", disabled: to < 0 || to >= pages || to === this.page, "aria-label": name, onclick: () => { this.page = to; this.draw(); } }, text);
    return this.pager.replaceChildren(
      go("«", 0, "First page"), go("‹", this.page - 1, "Previous page"),
      h("span", {}, `${thousands(this.page * PAGE + 1)}–${thousands(Math.min(this.order.length, (this.page + 1) * PAGE))} of ${thousands(this.order.length)}`),
      go("›", this.page + 1, "Next page"), go("»", pages - 1, "Last page"),
    );
  }

  save() {
    download(`${this.name}.csv`, "text/csv;charset=utf-8", csvOf(this.all, this.order));
  }
}

/** Any table of the study. */
export function genericTable(study, table, { name, hide = [], titles = {} }) {
  const isEmpty = (column) => table.rows > 0 && column.isText && column.distinct.every((text) => text === "");
  const columns = table.columns.filter((column) => !hide.includes(column.name) && !isEmpty(column));
  const scenario = table.column("scenario");
  const replay = scenario && study.replay_command ? (row) => scenario.at(row) !== null && copy(replayCommand(study, scenario.at(row))) : null;
  return new DataTable({ columns, all: table.columns.length > columns.length ? table.columns : columns, rows: table.rows, name, titles, replay, filterable: table.rows > 12 }).element;
}

const SHOWN = ["cycle_time_s", "friction_margin_min", "permanent_set_max_m", "contact_yield_ratio_max", "peak_finger_force_N", "slip_max_m"];

export function scenarioTable(study) {
  const { scenarios } = study;
  const exists = (column) => column.isText || column.varies || column.distinct.length > 0;
  const metrics = scenarios.metrics.filter(exists);
  const rest = [scenarios.column("outcome_time_s"), scenarios.column("cause")];
  const all = [scenarios.column("id"), scenarios.column("outcome"), ...scenarios.inputs, ...metrics, ...rest];
  const shownInputs = scenarios.inputs.filter((column) => !column.isNearlyConstant || scenarios.rows < 3).slice(0, 6);
  const shownMetrics = SHOWN.map((name) => scenarios.column(name)).filter((column) => column && metrics.includes(column));
  const hasCause = scenarios.column("cause").distinct.some((text) => text !== "");
  const columns = all.filter((column) => ["id", "outcome"].includes(column.name) || shownInputs.includes(column) || shownMetrics.slice(0, 4).includes(column) || (column.name === "cause" && hasCause));
  const chips = OUTCOMES.filter((word) => scenarios.counts[word]);
  const replay = study.replay_command ? (row) => copy(replayCommand(study, scenarios.at("id", row))) : null;
  const table = new DataTable({ columns, all, rows: scenarios.rows, name: `${fileName(study.name)}_scenarios`, chips: chips.length > 1 ? chips : null, replay, filterable: scenarios.rows > 1, selection: study.selection });
  return h("div", {}, table.element, replay ? h("p", { class: "note" }, "The number of a scenario copies the command that replays it.") : null, scenarios.sevenDigits ? h("p", { class: "note" }, "This page keeps seven digits of each metric; results.h5 has all of them.") : null);
}

// Scenarios in motion: the scene, the instruments beside it, and the signals below it, at one time.

import { contactEvents } from "./contact_events.js";
import { h, select } from "./dom.js";
import { Clock } from "./replay/clock.js";
import { gradient } from "./replay/colour_map.js";
import { check, keyboard, KEYS_TEXT, playControls, playWhenSeen, timeLine, viewControls } from "./replay/controls.js";
import { FIELDS, ReplayModel } from "./replay/model.js";
import { panel } from "./replay/panel.js";
import { soundButton } from "./replay/sound.js";
import { hasWebGL, Theatre } from "./replay/theatre.js";
import { differenceOfForces, timeCharts } from "./trace.js";
import { phasesOf } from "./trace_strips.js";
import { number, outcomeLabel, quantity, valuesText } from "./words.js";

const MOST_TOLD = 2;

function modelsOf(study) {
  return study.replays.map((data) => {
    const model = new ReplayModel(data, study.buffer, study.column);
    model.trace = data.trace;
    model.title = study.scenarios.rows > 1 ? `${outcomeLabel(model.outcome)}, scenario ${model.id}` : outcomeLabel(model.outcome);
    model.phases = phasesOf({ ...study, trace: data.trace });
    model.caption = "";
    return model;
  });
}

/** What two scenarios were given differently, where that is little. */
function tellApart({ scenarios }, models) {
  const rows = models.map(({ row }) => row);
  const known = models.length === 2 && rows.every((row) => row !== null && row !== undefined);
  const differing = known ? scenarios.inputs.filter((column) => column.at(rows[0]) !== column.at(rows[1])) : [];
  for (const model of models) model.caption = differing.length > 0 && differing.length <= MOST_TOLD ? valuesText(differing, model.row) : "";
}

/** What is shown at the beginning: what held best, and beside it what was damaged, or else what was lost. */
function firstChoice(models) {
  const second = models.find((model, i) => i > 0 && model.outcome === "damaged") ?? models[1] ?? null;
  return [0, second ? models.indexOf(second) : null];
}

function legendOf(look, field, models) {
  const most = Math.max(...models.map((model) => model.most(field.name)));
  look.field = field.name;
  look.most = most;
  const text = most > 0 ? quantity(most, field.units, 3) : "0";
  return [h("span", {}, field.label), h("span", { class: "legend-end" }, "0"), h("i", { class: "gradient", style: `background:${gradient()}` }), h("span", { class: "legend-end" }, text), most > 0 ? null : h("span", { class: "soft" }, "none at any time")];
}

/** What it began with and what it ends with, in words, below the scene. */
function remarks(models, look) {
  const error = Math.max(...models.map((model) => model.placeError));
  const set = models.map((model) => `${models.length > 1 ? `${model.title}: ` : ""}${model.permanent_set_m > 0 ? `a permanent set of ${quantity(model.permanent_set_m, "m", 3)}` : "no permanent set"}`).join("; ");
  return `Left behind: ${set}. Deformation is drawn ${look.scale > 1 ? `${look.scale} times as large as it is` : "as large as it is"}, to ${quantity(error, "m", 2)}; fields to 0.2 % of their largest value. Stress and strain of cells are means around a place; below a contact the plastic strain is that of its patch.`;
}

function chooseField(models) {
  return FIELDS.find((field) => field.name === "plastic_strain" && models.some((model) => model.most(field.name) > 0)) ?? FIELDS[1];
}

/** Everything that shows a time, and what it shows now. */
class Replay {
  constructor(study) {
    this.study = study;
    this.models = modelsOf(study);
    [this.first, this.second] = firstChoice(this.models);
    this.clock = new Clock(Math.max(...this.models.map((model) => model.end)));
    // A page of one scenario has its charts in a section of their own, which follows the same clock.
    if (study.trace && this.models.length === 1) study.clock = this.clock;
    this.look = { scale: Math.min(...this.models.map((model) => model.niceScale)), field: "", most: 0, arrows: true, ghost: false };
    this.field = chooseField(this.models);
    this.theatre = hasWebGL() ? new Theatre(this.clock, this.look, "scene", this.models.some((model) => model.armPlaces > 0)) : null;
    this.small = this.theatre ? new Theatre(this.clock, this.look, "preview") : null;
    this.line = timeLine(this.clock);
    this.legend = h("div", { class: "field-legend" });
    this.note = h("p", { class: "note" });
    this.beside = h("div", { class: "panel-box" });
    this.charts = h("div", { class: "replay-charts" });
    this.readout = h("output", { class: "time-now" });
    this.shown = () => [this.first, this.second].filter((i) => i !== null).map((i) => this.models[i]);
  }

  /** Another colour, factor or sign: the same scenarios. */
  refresh() {
    const { theatre, look, field } = this;
    const now = this.shown();
    this.legend.replaceChildren(...legendOf(look, field, now).filter(Boolean));
    this.note.textContent = remarks(now, look);
    this.small?.ask();
    theatre?.ask();
    theatre?.describe(`${now.map((model) => `${model.title}: ${model.why}`).join(", beside ")}, in motion over ${number(this.clock.end, 3)} s, coloured by ${field.label}. ${KEYS_TEXT}`);
  }

  /** Other scenarios. */
  rebuild() {
    const { study, clock } = this;
    const now = this.shown();
    tellApart(study, now);
    this.theatre?.show(now);
    this.small?.show(now);
    this.line.show(now, study);
    this.instruments = panel(study, now);
    this.beside.replaceChildren(this.instruments.element);
    this.instruments.set(clock.time);
    clock.restart();
    if (!study.clock) {
      const charts = timeCharts({ ...study, trace: now[0].trace, row: now[0].row, stripsMost: 4 }, clock);
      this.charts.replaceChildren(...[now.length > 1 ? differenceOfForces(now, clock) : null, charts, contactEvents({ trace: now[0].trace, name: now[0].title }, clock)].filter(Boolean));
    }
    this.refresh();
  }

  followClock() {
    const { clock, line } = this;
    clock.on(() => { this.readout.textContent = `${clock.time.toFixed(3)} s  ${line.phaseNow(clock.time)}`; });
    clock.onSeldom(() => this.instruments.set(clock.time));
  }

  choice() {
    if (this.models.length < 2) return null;
    const choices = this.models.map((model, i) => ({ value: String(i), label: `${model.why}: ${model.title}` }));
    return h("div", { class: "controls" },
      select("Shown", choices, String(this.first), (value) => { this.first = Number(value); this.rebuild(); }),
      select("Beside it", [{ value: "", label: "nothing" }, ...choices], this.second === null ? "" : String(this.second), (value) => { this.second = value === "" ? null : Number(value); this.rebuild(); }));
  }

  lookControls() {
    const { look } = this;
    const scales = [...new Set([1, 2, 3, 5, 10, 20, 50, look.scale])].sort((a, b) => a - b);
    return h("div", { class: "controls inner" },
      select("Colour", FIELDS.map((each) => ({ value: each.name, label: each.label })), this.field.name, (value) => { this.field = FIELDS.find((each) => each.name === value); this.refresh(); }),
      select("Deformation", scales.map((each) => ({ value: String(each), label: `${each}×` })), String(look.scale), (value) => { look.scale = Number(value); this.refresh(); }),
      check("forces", look.arrows, (on) => { look.arrows = on; this.refresh(); }), check("undeformed shape", look.ghost, (on) => { look.ghost = on; this.refresh(); }), soundButton(this.study, this.clock, this.shown));
  }

  /** The same, small: it stands beside the answer, so that nobody has to look for it. */
  preview() {
    const { small, clock } = this;
    if (!small) return null;
    small.describe("What is shown in motion below, small.");
    playWhenSeen(small.element, clock);
    return h("a", { class: "preview-link", href: "#replay", "aria-label": "In motion: to the scenes with their instruments" }, small.element);
  }

  element() {
    const { theatre, clock } = this;
    const screen = theatre ? theatre.element : h("p", { class: "banner" }, "This browser shows no WebGL, so the scene in three dimensions is missing here; instruments, time line and signals are all there.");
    this.rebuild();
    this.followClock();
    if (theatre) {
      keyboard(theatre, clock, theatre.canvas);
      playWhenSeen(screen, clock);
    }
    const left = h("div", { class: "replay-left" }, screen, this.legend, h("div", { class: "play-row" }, playControls(clock, this.readout), theatre ? viewControls(theatre) : null), this.line.element, this.lookControls(), this.note);
    return h("div", { class: "replay" }, this.choice(), h("div", { class: "replay-top" }, left, this.beside), this.charts);
  }
}

/** Leaves its preview with the study, for the answer. */
export function replay(study) {
  if (!study.replays.length) return null;
  const made = new Replay(study);
  const element = made.element();
  study.preview = made.preview();
  return element;
}

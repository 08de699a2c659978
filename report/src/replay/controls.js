// What plays a scene and turns it: the time line, buttons, keys.

import { freshId, h, select } from "../dom.js";
import { phasesOf } from "../trace_strips.js";
import { number } from "../words.js";
import { SPEEDS } from "./clock.js";
import { eventTicks } from "./events.js";

const still = window.matchMedia("(prefers-reduced-motion: reduce)");
const FRAMES = 130;

export const KEYS_TEXT = "Space plays and pauses; arrow keys turn; plus and minus come nearer; comma and full stop go a frame back and on; figures from 1 on choose a view, 0 resets it.";

/** The time line: a slider with the phases below it and the events on it. */
export function timeLine(clock) {
  const id = freshId("time");
  const slider = h("input", { id, type: "range", min: "0", max: "1000", step: "1", "aria-label": "Time", oninput: () => { const wanted = (clock.end * slider.value) / 1000; clock.pause(); clock.jump(wanted); } });
  const ticks = h("div", { class: "ticks" });
  const phases = h("div", { class: "phase-line", "aria-hidden": "true" });
  const element = h("div", { class: "time-line" }, ticks, slider, phases);
  let phaseNow = () => "";
  const show = (models, study) => {
    const [model] = models;
    ticks.classList.toggle("two", models.length > 1);
    ticks.replaceChildren(...models.flatMap((each, i) => eventTicks(each, clock.end, (time) => { clock.pause(); clock.jump(time); }).map((tick) => { tick.classList.toggle("second", i > 0); return tick; })));
    const found = phasesOf({ ...study, trace: model.trace });
    phases.replaceChildren(...found.map((phase) => h("span", { style: `left:${(100 * phase.from) / clock.end}%;width:${(100 * (phase.to - phase.from)) / clock.end}%` }, h("em", {}, phase.name))));
    phaseNow = (time) => found.find((phase) => time >= phase.from && time <= phase.to)?.name ?? "";
  };
  clock.on(() => { slider.value = String(Math.round((1000 * clock.time) / clock.end)); });
  clock.onSeldom(() => slider.setAttribute("aria-valuetext", `${number(clock.time, 3)} s, ${phaseNow(clock.time)}`));
  return { element, show, phaseNow: (time) => phaseNow(time) };
}

function button(text, name, act, more = {}) {
  return h("button", { type: "button", class: "quiet", "aria-label": name, title: name, onclick: act, ...more }, text);
}

export function playControls(clock, readout) {
  const play = button("", "Play", () => clock.toggle(), { class: "quiet play" });
  let shown = null;
  clock.on(() => {
    if (shown === clock.playing) return;
    shown = clock.playing;
    play.textContent = shown ? "❚❚" : "▶";
    play.setAttribute("aria-label", shown ? "Pause" : "Play");
    play.title = shown ? "Pause" : "Play";
  });
  const speed = select("Speed", SPEEDS.map((each) => ({ value: String(each), label: `${number(each)}×` })), String(clock.speed), (value) => clock.setSpeed(Number(value)));
  return h("div", { class: "play-controls" }, play, readout, speed);
}

export function keyboard(theatre, clock, canvas) {
  const { views } = theatre.orbit;
  const acts = {
    " ": () => clock.toggle(), ArrowLeft: () => theatre.orbit.turn(-0.12, 0), ArrowRight: () => theatre.orbit.turn(0.12, 0), ArrowUp: () => theatre.orbit.turn(0, 0.1), ArrowDown: () => theatre.orbit.turn(0, -0.1),
    "+": () => theatre.orbit.zoom(0.85), "=": () => theatre.orbit.zoom(0.85), "-": () => theatre.orbit.zoom(1.18), 0: () => theatre.orbit.reset(),
    ",": () => clock.jump(clock.time - clock.end / FRAMES), ".": () => clock.jump(clock.time + clock.end / FRAMES),
  };
  canvas.addEventListener("keydown", (event) => {
    const view = views[Number(event.key) - 1];
    const act = view ? () => theatre.orbit.view(view) : acts[event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act();
  });
}

/** Plays by itself when it is first seen, unless the reader's system asks for stillness. */
export function playWhenSeen(element, clock) {
  if (still.matches) return;
  const observer = new IntersectionObserver(([entry]) => {
    if (!entry.isIntersecting) return;
    observer.disconnect();
    clock.play();
  }, { threshold: 0.35 });
  observer.observe(element);
}

export function viewControls(theatre) {
  const views = theatre.orbit.views.map((name) => button(name, `View: ${name}`, () => theatre.orbit.view(name)));
  return h("div", { class: "views", role: "group", "aria-label": "View" }, views, button("+", "Nearer", () => theatre.orbit.zoom(0.85)), button("−", "Further", () => theatre.orbit.zoom(1.18)), button("reset", "Reset the view", () => theatre.orbit.reset()));
}

export function check(text, on, act) {
  const box = h("input", { type: "checkbox", onchange: () => act(box.checked) });
  box.checked = on;
  return h("label", { class: "check" }, box, text);
}

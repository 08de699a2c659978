// The force as a tone, contact and slip as sounds of their own, damage as an alarm; silent until asked for.

import { h } from "../dom.js";
import { fingerForces } from "./panel.js";

const VOLUME = 0.22;

/** Pitch of a force: as studies/report/sound.hpp has it. */
export function pitchOf(map, force) {
  return map.base_Hz + (map.span_Hz * force) / map.force_N;
}

export function loudnessOf(map, force) {
  return Math.min(1, Math.sqrt(Math.max(0, force) / map.force_N));
}

class Speaker {
  constructor(clock, shown, map) {
    this.clock = clock;
    this.shown = shown;
    this.map = map;
    this.context = new AudioContext();
    this.out = this.context.createGain();
    this.out.gain.value = VOLUME;
    this.out.connect(this.context.destination);
    this.tone = this.context.createOscillator();
    this.tone.type = "triangle";
    this.level = this.context.createGain();
    this.level.gain.value = 0;
    this.tone.connect(this.level).connect(this.out);
    this.tone.start();
  }

  follow(from) {
    const [model] = this.shown();
    if (this.model !== model) {
      this.model = model;
      this.forces = fingerForces(model).at;
    }
    const { time, playing, end } = this.clock;
    const force = Math.max(0, ...this.forces.map((at) => at(time)));
    const now = this.context.currentTime;
    const audible = playing && time < end;
    this.tone.frequency.setTargetAtTime(pitchOf(this.map, force), now, 0.01);
    this.level.gain.setTargetAtTime(audible ? loudnessOf(this.map, force) : 0, now, 0.02);
    if (from === null || !audible) return;
    for (const event of model.events) if (event.time_s > from && event.time_s <= time) this.strike(event);
  }

  strike({ kind, where }) {
    const now = this.context.currentTime;
    if (kind === "decided" && where === "damaged") for (let i = 0; i < 4; i += 1) this.beep(now + 0.12 * i, i % 2 ? 1050 : 1400, 0.11, "square", 0.4);
    else if (kind === "touch") this.beep(now, 1200, 0.05, "sine", 0.9);
    else if (kind === "part") this.beep(now, 700, 0.05, "sine", 0.6);
    else if (kind === "slip") this.beep(now, 95, 0.16, "sawtooth", 0.8);
  }

  beep(at, pitch, length, type, level) {
    const tone = this.context.createOscillator();
    const gain = this.context.createGain();
    tone.type = type;
    tone.frequency.value = pitch;
    gain.gain.setValueAtTime(level, at);
    gain.gain.exponentialRampToValueAtTime(0.001, at + length);
    tone.connect(gain).connect(this.out);
    tone.start(at);
    tone.stop(at + length);
  }

  set on(value) {
    if (value) this.context.resume();
    else this.context.suspend();
  }
}

export function soundButton(study, clock, shown) {
  if (typeof AudioContext === "undefined" || !study.sound) return null;
  let speaker = null;
  let on = false;
  const button = h("button", { type: "button", class: "quiet sound", "aria-pressed": "false", onclick: () => {
    on = !on;
    if (on && !speaker) {
      speaker = new Speaker(clock, shown, study.sound);
      clock.on((_, from) => { if (on) speaker.follow(from); });
    }
    if (speaker) speaker.on = on;
    button.setAttribute("aria-pressed", String(on));
    button.textContent = on ? "Sound on" : "Sound off";
  } }, "Sound off");
  return button;
}

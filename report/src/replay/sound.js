// The force as a tone, contact and slip as sounds of their own, damage as an alarm; silent until asked for. A replay is set down in the
// sound's own time as a whole when it begins to play, and the scene then takes its time from the sound: the two cannot part.

import { h } from "../dom.js";
import { wallPace } from "./clock.js";
import { pressingForces } from "./panel.js";

const VOLUME = 0.22;
/** From a press of "Play" to the first sound, and for it to come and go without a click, in s. */
const LEAD_S = 0.03;
const FADE_S = 0.005;

/** Pitch of a force: as studies/report/sound.hpp has it. */
export function pitchOf(map, force) {
  return map.base_Hz + (map.span_Hz * force) / map.force_N;
}

export function loudnessOf(map, force) {
  return Math.min(1, Math.sqrt(Math.max(0, force) / map.force_N));
}

/** [pitch in Hz, its wave, its level, how long after the event, how long] of what is heard of an event. */
function beepsOf({ kind, where }) {
  if (kind === "decided" && where === "damaged") return [0, 1, 2, 3].map((i) => [i % 2 ? 1050 : 1400, "square", 0.4, 0.12 * i, 0.11]);
  return { touch: [[1200, "sine", 0.9, 0, 0.05]], part: [[700, "sine", 0.6, 0, 0.05]], slip: [[95, "sawtooth", 0.8, 0, 0.16]] }[kind] ?? [];
}

/** A replay from a time on, as it is heard. */
class Voice {
  /** @param when(time) in s of the context */
  constructor(context, out, from, when) {
    Object.assign(this, { context, when });
    this.level = context.createGain();
    this.level.gain.setValueAtTime(0, when(from));
    this.level.gain.linearRampToValueAtTime(1, when(from) + FADE_S);
    this.level.connect(out);
  }

  /** Between two rows of the trace pitch and loudness go straight, as the force does. */
  tone({ times, forces }, map, from) {
    const { context, when } = this;
    const [tone, loudness] = [context.createOscillator(), context.createGain()];
    tone.type = "triangle";
    tone.connect(loudness).connect(this.level);
    const next = times.findIndex((time) => time > from);
    if (next < 0) return;
    const part = next > 0 ? (from - times[next - 1]) / (times[next] - times[next - 1]) : 1;
    const force = next > 0 ? forces[next - 1] + part * (forces[next] - forces[next - 1]) : forces[0];
    tone.frequency.setValueAtTime(pitchOf(map, force), when(from));
    loudness.gain.setValueAtTime(loudnessOf(map, force), when(from));
    for (let i = next; i < times.length; i += 1) {
      tone.frequency.linearRampToValueAtTime(pitchOf(map, forces[i]), when(times[i]));
      loudness.gain.linearRampToValueAtTime(loudnessOf(map, forces[i]), when(times[i]));
    }
    const end = when(times[times.length - 1]);
    loudness.gain.linearRampToValueAtTime(0, end + 4 * FADE_S);
    tone.start(when(from));
    tone.stop(end + 4 * FADE_S);
  }

  beep(at, [pitch, type, level, , length]) {
    const { context } = this;
    const [tone, gain] = [context.createOscillator(), context.createGain()];
    tone.type = type;
    tone.frequency.value = pitch;
    gain.gain.setValueAtTime(level, at);
    gain.gain.exponentialRampToValueAtTime(0.001, at + length);
    tone.connect(gain).connect(this.level);
    tone.start(at);
    tone.stop(at + length);
  }

  hush() {
    const { context, level } = this;
    level.gain.cancelScheduledValues(context.currentTime);
    level.gain.setTargetAtTime(0, context.currentTime, FADE_S);
    setTimeout(() => level.disconnect(), 100);
  }
}

/** The pace of the clock while there is sound. */
class Speaker {
  constructor(shown, map) {
    this.shown = shown;
    this.map = map;
    this.most = Infinity;
    this.context = new AudioContext();
    this.out = this.context.createGain();
    this.out.gain.value = VOLUME;
    this.out.connect(this.context.destination);
  }

  begin({ time, speed }) {
    this.end();
    const [model] = this.shown();
    if (this.model !== model) Object.assign(this, { model, score: pressingForces(model) });
    const at = this.context.currentTime + LEAD_S;
    const voice = new Voice(this.context, this.out, time, (each) => at + (each - time) / speed);
    voice.tone(this.score, this.map, time);
    for (const event of model.events) {
      if (event.time_s < time) continue;
      for (const beep of beepsOf(event)) voice.beep(voice.when(event.time_s) + beep[3], beep);
    }
    this.voice = voice;
    return at;
  }

  /** What is heard now left the context a little earlier. */
  now() {
    return this.context.currentTime - (this.context.outputLatency || this.context.baseLatency || 0);
  }

  end() {
    this.voice?.hush();
    this.voice = null;
  }
}

export function soundButton(study, clock, shown) {
  if (typeof AudioContext === "undefined" || !study.sound) return null;
  let speaker = null;
  let on = false;
  // A context that does not run, such as one without a loudspeaker, must not hold up the scene.
  const follow = () => clock.setPace(on && speaker.context.state === "running" ? speaker : wallPace);
  const button = h("button", { type: "button", class: "quiet sound", "aria-pressed": "false", onclick: () => {
    on = !on;
    if (!speaker) {
      speaker = new Speaker(shown, study.sound);
      speaker.context.onstatechange = follow;
    }
    follow();
    if (on) speaker.context.resume();
    else speaker.context.suspend();
    button.setAttribute("aria-pressed", String(on));
    button.textContent = on ? "Sound on" : "Sound off";
  } }, "Sound off");
  return button;
}

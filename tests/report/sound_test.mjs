// usage: node sound_test.mjs PAGES PACKAGES
// What the page lets be heard (browser.mjs): the samples it makes, rendered without a loudspeaker, and its step with the scene.

import assert from "node:assert/strict";
import test from "node:test";
import { open } from "./browser.mjs";

const RATE_HZ = 44100;
const INSTANTS = 40;

/** Instead of the loudspeaker a recorder: what is scheduled from 0 on is rendered when the test asks for it. */
function record({ rate, seconds }) {
  window.AudioContext = class extends OfflineAudioContext {
    constructor() {
      super(1, rate * seconds, rate);
      window.recorder = this;
    }
    get state() { return "running"; }
    async resume() {}
    async suspend() {}
  };
  // When the first of all tones begins, the replay does.
  const { start } = OscillatorNode.prototype;
  OscillatorNode.prototype.start = function (when) {
    window.began ??= when;
    return start.call(this, when);
  };
}

const openHeard = (prepare, argument) => open("in_motion", { before: (page) => page.addInitScript(prepare, argument) });

const goTo = (page, part) => page.locator("#replay .time-line input").evaluate((slider, value) => { slider.value = value; slider.dispatchEvent(new Event("input")); }, String(Math.round(1000 * part)));
const timeOf = async (page) => Number((await page.locator("#replay .time-now").innerText()).split(" ")[0]);
const pressing = async (page) => Math.max(...(await page.locator("#replay .panel tr", { hasText: "presses" }).evaluateAll((rows) => rows.map((row) => Number(row.querySelector(".digits").textContent)))));
const playAt = (page, speed) => page.locator("#replay").getByLabel("Speed").selectOption(speed).then(() => page.getByRole("button", { name: "Play", exact: true }).click());

/** Pitch of samples around an instant [Hz]: the time that whole turns take, between crossings of zero upwards. */
function pitchAround(samples, at_s, half_s) {
  const crossings = [];
  for (let i = Math.round((at_s - half_s) * RATE_HZ); i < (at_s + half_s) * RATE_HZ; i += 1) {
    if (samples[i] < 0 && samples[i + 1] >= 0) crossings.push(i - samples[i] / (samples[i + 1] - samples[i]));
  }
  return crossings.length < 3 ? null : ((crossings.length - 1) * RATE_HZ) / (crossings[crossings.length - 1] - crossings[0]);
}

/** What the instruments say the force is: [{ time, force }] over the replay. */
async function toldForces(page) {
  const told = [];
  for (let i = 1; i < INSTANTS; i += 1) {
    await goTo(page, i / INSTANTS);
    told.push({ time: await timeOf(page), force: await pressing(page) });
  }
  return told;
}

/** The samples of a replay played from its beginning, and when in them it begins [s]. */
async function rendered(page, speed) {
  await goTo(page, 0);
  await page.locator("#replay .sound").click();
  await playAt(page, speed);
  await page.waitForFunction(() => window.began !== undefined);
  const began = await page.evaluate(() => window.began);
  const samples = Float32Array.from(await page.evaluate(async () => [...(await window.recorder.startRendering()).getChannelData(0)]));
  return { began, samples };
}

test("the pitch follows the force within 2 %, at any speed", async () => {
  let told = null;
  for (const speed of [1, 0.5]) {
    const { page, close } = await openHeard(record, { rate: RATE_HZ, seconds: 8 });
    await page.locator("#replay").scrollIntoViewIfNeeded();
    told ??= await toldForces(page);
    const { sound, events } = await page.evaluate(() => {
      const { sound: map, replays } = JSON.parse(document.getElementById("study").textContent);
      return { sound: map, events: replays[0].events.map((event) => event.time_s) };
    });
    const { began, samples } = await rendered(page, String(speed));
    // An alarm lasts half a second; a tone without loudness has no pitch.
    const isDisturbed = (time) => events.some((event) => time / speed > event / speed - 0.03 && time / speed < event / speed + 0.55);
    const compared = told.filter(({ time, force }) => force > 0.05 * sound.force_N && !isDisturbed(time));
    for (const { time, force } of compared) {
      const pitch = pitchAround(samples, began + time / speed, 0.02);
      const wanted = sound.base_Hz + (sound.span_Hz * force) / sound.force_N;
      assert.ok(pitch !== null && Math.abs(pitch - wanted) < 0.02 * wanted, `${pitch} Hz at ${time} s, where ${force} N ask for ${wanted} Hz`);
    }
    console.log(`${compared.length} instants compared at speed ${speed}`);
    assert.ok(compared.length >= 6, `${compared.length} instants`);
    await close();
  }
});

/** Keeps the page's own context where the test finds it, when its first tone begins, and what time was last asked of it. */
function remember() {
  const { start } = OscillatorNode.prototype;
  OscillatorNode.prototype.start = function (when) {
    window.began ??= when;
    return start.call(this, when);
  };
  const Own = window.AudioContext;
  window.AudioContext = class extends Own {
    constructor() {
      super();
      window.own = this;
    }
    get currentTime() {
      const now = super.currentTime;
      window.heard = now - (this.outputLatency || this.baseLatency || 0);
      return now;
    }
  };
}

test("the scene goes by the time of the sound, also after a jump and at another speed", async () => {
  const { page, close } = await openHeard(remember);
  await page.locator("#replay").scrollIntoViewIfNeeded();
  await goTo(page, 0);
  await page.locator("#replay .sound").click();
  await page.waitForFunction(() => window.own?.state === "running");
  for (const [part, speed] of [[0, "0.25"], [0.3, "0.5"], [0.2, "0.1"]]) {
    await goTo(page, part);
    const from = await timeOf(page);
    await page.evaluate(() => { window.began = undefined; });
    await playAt(page, speed);
    let heard = 0;
    for (let look = 0; look < 3; look += 1) {
      // However late a busy machine begins.
      await page.waitForFunction((least) => window.heard - window.began > least, heard + 0.1);
      const seen = await page.evaluate(() => ({ sound: window.heard - window.began, time: parseFloat(document.querySelector("#replay .time-now").textContent) }));
      const wanted = from + Math.max(0, seen.sound) * Number(speed);
      // Both readouts have milliseconds.
      assert.ok(Math.abs(seen.time - wanted) < 0.0011, `${seen.time} s shown, ${wanted} s heard at speed ${speed}`);
      heard = seen.sound;
    }
    await page.getByRole("button", { name: "Pause" }).click();
  }
  await close();
});

test("what is turned off is silent, and the scene goes on by itself", async () => {
  const { page, close } = await openHeard(remember);
  await page.locator("#replay").scrollIntoViewIfNeeded();
  const sound = page.locator("#replay .sound");
  assert.equal(await sound.getAttribute("aria-pressed"), "false");
  await goTo(page, 0);
  await playAt(page, "0.1");
  await page.waitForTimeout(200);
  assert.equal(await page.evaluate(() => window.own === undefined), true, "no sound is made before it is asked for");
  await sound.click();
  await page.waitForFunction(() => window.own?.state === "running");
  await sound.click();
  await page.waitForFunction(() => window.own.state === "suspended");
  const time = await timeOf(page);
  await page.waitForFunction((before) => parseFloat(document.querySelector("#replay .time-now").textContent) > before + 0.01, time);
  await close();
});

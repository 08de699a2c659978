// usage: node tests/report/picture.mjs PAGE.html PICTURE.png [PART | story]
// The first screens of a report as a picture, for docs/images/report.png; with PART, from 0 to 1, what it shows in motion at that part of
// the time; with "story" its two scenes gripped, carried and placed, for docs/images/replay.png. Needs what `report/build --tests` installs.

import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const [page, picture] = process.argv.slice(2, 4).map((path) => resolve(path));
const what = process.argv[4];
const packages = join(dirname(fileURLToPath(import.meta.url)), "../../build/report-tests/package.json");
const { chromium } = createRequire(packages)("playwright-core");

/** The phases that tell the story, and how far into each of them. */
const STORY = [["gripped", 0.9], ["carried", 0.5], ["placed", 0.95]];

const browser = await chromium.launch({ executablePath: process.env.UNBRUISED_CHROMIUM ?? "/usr/bin/chromium", args: ["--headless", "--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"] });
// In a narrow window the two scenes stand one above the other.
const isStory = what === "story";
const tab = await browser.newPage({ viewport: isStory ? { width: 470, height: 900 } : { width: 1280, height: 1420 }, deviceScaleFactor: isStory ? 2 : 1, colorScheme: "light", reducedMotion: "reduce" });
tab.setDefaultTimeout(120_000);

/** Moves the time to a step of the slider, and waits for the sharp picture. */
async function goTo(step) {
  await tab.locator("#replay .time-line input").evaluate((slider, value) => { slider.value = value; slider.dispatchEvent(new Event("input")); }, String(step));
}

const rest = async () => {
  await tab.waitForFunction(() => document.querySelector("canvas.scene").dataset.rest === "yes");
  await tab.waitForTimeout(400);
};

/** The steps of the slider at which the first scene says a word, from the first to the last. */
async function stepsOf(word) {
  const said = await tab.evaluate(() => {
    const slider = document.querySelector("#replay .time-line input");
    return Array.from({ length: 1001 }, (_, step) => {
      slider.value = String(step);
      slider.dispatchEvent(new Event("input"));
      return document.querySelector("#replay .scene-names em").textContent;
    });
  });
  const steps = said.flatMap((each, step) => (each === word ? [step] : []));
  if (!steps.length) throw new Error(`nothing is ${word} in ${page}`);
  return [steps[0], steps[steps.length - 1]];
}

async function story() {
  await tab.locator("#replay .theatre").scrollIntoViewIfNeeded();
  await tab.waitForFunction(() => Number(document.querySelector("canvas.scene").dataset.frames) > 0);
  const shots = [];
  for (const [word, part] of STORY) {
    const [first, last] = await stepsOf(word);
    await goTo(Math.round(first + part * (last - first)));
    await rest();
    shots.push((await tab.locator("#replay .theatre").screenshot()).toString("base64"));
  }
  const sheet = await browser.newPage({ viewport: { width: 1280, height: 600 }, deviceScaleFactor: 1.25 });
  await sheet.setContent(`<body style="margin:0;background:#fff"><div id="sheet" style="display:grid;grid-template-columns:repeat(${shots.length},1fr);gap:10px;width:1280px">${shots.map((shot) => `<img style="width:100%;display:block" src="data:image/png;base64,${shot}">`).join("")}</div></body>`);
  await sheet.waitForFunction(() => [...document.images].every((image) => image.complete));
  await sheet.locator("#sheet").screenshot({ path: picture });
}

await tab.goto(`file://${page}`, { waitUntil: "commit" });
await tab.waitForFunction(() => document.documentElement.dataset.drawn === "yes");
if (what === undefined) {
  if (await tab.locator("#replay .time-line input").count()) await goTo(500);
  await tab.waitForTimeout(1500);
  await tab.screenshot({ path: picture });
} else if (isStory) {
  await story();
} else {
  await tab.locator("#replay .replay-top").scrollIntoViewIfNeeded();
  await goTo(Math.round(1000 * Number(what)));
  await tab.waitForFunction(() => Number(document.querySelector("canvas.scene").dataset.frames) > 0);
  await rest();
  await tab.locator("#replay .replay-top").screenshot({ path: picture });
}
await browser.close();

// usage: node tests/report/picture.mjs PAGE.html PICTURE.png [PART]
// The first screens of a report as a picture, for docs/images/report.png; with PART, from 0 to 1, what it shows in motion at that part of
// the time, for docs/images/replay.png. Needs what `report/build --tests` installs.

import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const [page, picture] = process.argv.slice(2, 4).map((path) => resolve(path));
const part = process.argv[4];
const packages = join(dirname(fileURLToPath(import.meta.url)), "../../build/report-tests/package.json");
const { chromium } = createRequire(packages)("playwright-core");

const drawing = part === undefined ? ["--disable-gpu"] : ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
const browser = await chromium.launch({ executablePath: process.env.UNBRUISED_CHROMIUM ?? "/usr/bin/chromium", args: ["--headless", "--no-sandbox", ...drawing] });
const tab = await browser.newPage({ viewport: { width: 1280, height: 1420 }, colorScheme: "light", reducedMotion: "reduce" });
tab.setDefaultTimeout(120_000);
await tab.goto(`file://${page}`, { waitUntil: "commit" });
await tab.waitForFunction(() => document.documentElement.dataset.drawn === "yes");
if (part === undefined) {
  await tab.screenshot({ path: picture });
} else {
  await tab.locator("#replay .time-line input").evaluate((slider, value) => { slider.value = value; slider.dispatchEvent(new Event("input")); }, String(Math.round(1000 * Number(part))));
  await tab.locator("#replay .replay-top").scrollIntoViewIfNeeded();
  await tab.waitForFunction(() => Number(document.querySelector("canvas.scene").dataset.frames) > 0);
  await tab.waitForTimeout(1500);
  await tab.locator("#replay .replay-top").screenshot({ path: picture });
}
await browser.close();

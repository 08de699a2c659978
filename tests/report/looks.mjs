// usage: node tests/report/looks.mjs PAGES PACKAGES FOLDER [NAME ...]
// Pictures of every page of PAGES, as a person looks at them: light on a laptop, dark on a laptop, on a phone of 390 pixels, and printed.
// Left in FOLDER as NAME_light_0.png and on, strip by strip, NAME_dark_0.png, NAME_phone_0.png, NAME.pdf.

import { mkdirSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const [pages, packages, folder] = process.argv.slice(2, 5).map((path) => resolve(path));
const wanted = process.argv.slice(5);
const { chromium } = createRequire(join(packages, "package.json"))("playwright-core");
const VIEWS = [["light", 1440, 1900, "light"], ["dark", 1440, 1900, "dark"], ["phone", 390, 2400, "light"]];

mkdirSync(folder, { recursive: true });
const browser = await chromium.launch({ executablePath: process.env.UNBRUISED_CHROMIUM ?? "/usr/bin/chromium", args: ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"] });

async function open(name, [, width, height, colorScheme]) {
  const tab = await browser.newPage({ viewport: { width, height }, colorScheme, reducedMotion: "reduce" });
  tab.setDefaultTimeout(120_000);
  await tab.goto(`file://${join(pages, name)}`, { waitUntil: "commit" });
  await tab.waitForFunction(() => document.readyState === "complete" && (document.documentElement.dataset.drawn === "yes" || !document.querySelector(".chart")));
  // The middle of the time tells most of a scene.
  await tab.evaluate(() => { const slider = document.querySelector("#replay .time-line input"); if (slider) { slider.value = "500"; slider.dispatchEvent(new Event("input")); } });
  await tab.waitForTimeout(400);
  return tab;
}

/** A window after the other: a picture of a whole page may be larger than a browser can draw. */
async function strips(tab, [kind, , step], stem) {
  await tab.evaluate(() => { document.querySelector("header").style.position = "static"; });
  const height = await tab.evaluate(() => document.documentElement.scrollHeight);
  for (let i = 0; i * step < height; i += 1) {
    await tab.evaluate((y) => window.scrollTo({ top: y, behavior: "instant" }), i * step);
    await tab.waitForTimeout(600);
    await tab.screenshot({ path: join(folder, `${stem}_${kind}_${i}.png`) });
  }
}

for (const name of readdirSync(pages).filter((each) => each.endsWith(".html") && each !== "large.html").sort()) {
  const stem = name.replace(/\.html$/, "");
  if (wanted.length && !wanted.includes(stem)) continue;
  for (const view of VIEWS) {
    const tab = await open(name, view);
    await strips(tab, view, stem);
    if (view[0] === "light") await tab.pdf({ path: join(folder, `${stem}.pdf`), preferCSSPageSize: true });
    await tab.close();
  }
  console.log(stem);
}
await browser.close();

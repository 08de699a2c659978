// usage: node tests/report/looks.mjs PAGES PACKAGES FOLDER [NAME ...]
// Pictures of every page of PAGES, as a person looks at them: light on a laptop, dark on a laptop, on a phone of 390 pixels, and printed.
// Left in FOLDER as NAME_light.png, NAME_dark.png, NAME_phone.png, NAME.pdf.

import { mkdirSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const [pages, packages, folder] = process.argv.slice(2, 5).map((path) => resolve(path));
const wanted = process.argv.slice(5);
const { chromium } = createRequire(join(packages, "package.json"))("playwright-core");
const VIEWS = [["light", 1440, 900, "light"], ["dark", 1440, 900, "dark"], ["phone", 390, 844, "light"]];

mkdirSync(folder, { recursive: true });
const browser = await chromium.launch({ executablePath: process.env.UNBRUISED_CHROMIUM ?? "/usr/bin/chromium", args: ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"] });

async function open(name, [, width, height, colorScheme]) {
  const tab = await browser.newPage({ viewport: { width, height }, colorScheme, reducedMotion: "reduce" });
  tab.setDefaultTimeout(120_000);
  await tab.goto(`file://${join(pages, name)}`, { waitUntil: "commit" });
  await tab.waitForFunction(() => document.readyState === "complete" && (document.documentElement.dataset.drawn === "yes" || !document.querySelector(".chart")));
  // The middle of the time tells most of a scene.
  await tab.evaluate(() => { const slider = document.querySelector("#replay .time-line input"); if (slider) { slider.value = "500"; slider.dispatchEvent(new Event("input")); slider.scrollIntoView(); } });
  await tab.waitForTimeout(400);
  return tab;
}

for (const name of readdirSync(pages).filter((each) => each.endsWith(".html") && each !== "large.html").sort()) {
  const stem = name.replace(/\.html$/, "");
  if (wanted.length && !wanted.includes(stem)) continue;
  for (const view of VIEWS) {
    const tab = await open(name, view);
    await tab.screenshot({ path: join(folder, `${stem}_${view[0]}.png`), fullPage: true });
    if (view[0] === "light") await tab.pdf({ path: join(folder, `${stem}.pdf`), preferCSSPageSize: true });
    await tab.close();
  }
  console.log(stem);
}
await browser.close();

// What the tests of the page share: the browser, a page opened as a reader does, what it saves.
// The first word of the command line is PAGES (tests/studies/report writes them), the second PACKAGES, which holds what
// tests/report/package-lock.json pins (report/build --tests). Exit status 77: no browser here.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { after, before } from "node:test";

export const [pages, packages] = process.argv.slice(2).map((path) => resolve(path));
const chromiumPath = process.env.UNBRUISED_CHROMIUM ?? "/usr/bin/chromium";
if (!existsSync(chromiumPath) || !existsSync(join(packages, "node_modules/playwright-core"))) {
  console.log("skipped: chromium or playwright-core is missing; `scripts/setup --tests` and `report/build --tests` install them");
  process.exit(77);
}
const { chromium } = createRequire(join(packages, "package.json"))("playwright-core");

export const LAPTOP = { width: 1440, height: 900 };
export const PHONE = { width: 390, height: 844 };

export let browser;
before(async () => {
  browser = await chromium.launch({
    executablePath: chromiumPath,
    args: ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync", "--host-resolver-rules=MAP * ~NOTFOUND"],
  });
});
after(() => browser?.close());

/**
 * Opens a page; whatever it says on the console, throws or asks the network for fails the test.
 * @param before (page) => what has to be done before the page's own script runs
 */
export async function open(name, { viewport = LAPTOP, colorScheme = "light", hash = "", before = null } = {}) {
  const context = await browser.newContext({ viewport, colorScheme, offline: true, acceptDownloads: true });
  const page = await context.newPage();
  await before?.(page);
  const complaints = [];
  page.setDefaultTimeout(120_000); // busy machines take their time
  page.on("console", (message) => {
    // A picture taken of a canvas makes the driver of the processor say how slow that is.
    if (!message.text().includes("GL Driver Message (OpenGL, Performance")) complaints.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => complaints.push(`error: ${error.message}`));
  page.on("dialog", (dialog) => { complaints.push(`dialog: ${dialog.message()}`); dialog.dismiss(); });
  page.on("request", (request) => { if (!/^(file|data|blob):/.test(request.url())) complaints.push(`request: ${request.url()}`); });
  await page.goto(`file://${join(pages, `${name}.html`)}${hash}`);
  await page.waitForFunction(() => document.documentElement.dataset.drawn === "yes" || !document.querySelector(".chart"));
  const close = async () => {
    await context.close();
    assert.deepEqual(complaints, []);
  };
  return { page, close };
}

/** Number of different colours a chart is drawn with, once it has been scrolled to. */
export async function coloursOf(page, section) {
  await page.locator(`#${section} .chart`).first().scrollIntoViewIfNeeded();
  return page.locator(`#${section} .chart canvas`).first().evaluate((canvas) => {
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [400, 300];
    const context = copy.getContext("2d", { willReadFrequently: true });
    context.drawImage(canvas, 0, 0, copy.width, copy.height);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    const seen = new Set();
    for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 200) seen.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
    return seen.size;
  });
}

/** What a button of a section saves. Chromium drops the eleventh download of a second, which no hand asks for. */
export async function saved(page, button) {
  await page.waitForTimeout(110);
  const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
  return { name: download.suggestedFilename(), text: readFileSync(await download.path(), "utf8") };
}

export async function csvOf(page, section) {
  const { name, text } = await saved(page, page.locator(`#${section} .csv`).first());
  return { name, lines: text.split("\r\n") };
}

/** Waits until all charts are drawn and stand still. */
export const settled = (page) => page.waitForFunction(() => document.documentElement.dataset.drawn === "yes").then(() => page.waitForTimeout(250));

// usage: node motion_test.mjs PAGES PACKAGES
// Scenarios in motion as a reader sees them: opens PAGES/in_motion.html in Debian's chromium, with WebGL drawn by the processor and
// without any. PACKAGES as in report_test.mjs. Exit status 77: no browser here.

import assert from "node:assert/strict";
import { existsSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import test, { after, before } from "node:test";

const [pages, packages] = process.argv.slice(2).map((path) => resolve(path));
const chromiumPath = process.env.UNBRUISED_CHROMIUM ?? "/usr/bin/chromium";
if (!existsSync(chromiumPath) || !existsSync(join(packages, "node_modules/playwright-core"))) {
  console.log("skipped: chromium or playwright-core is missing; `scripts/setup --tests` and `report/build --tests` install them");
  process.exit(77);
}
const { chromium } = createRequire(join(packages, "package.json"))("playwright-core");
const PAGE = join(pages, "in_motion.html");
const COMMON = ["--headless", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync", "--host-resolver-rules=MAP * ~NOTFOUND"];

const browsers = {};
before(async () => {
  browsers.drawn = await chromium.launch({ executablePath: chromiumPath, args: [...COMMON, "--disable-gpu", "--enable-unsafe-swiftshader"] });
  browsers.bare = await chromium.launch({ executablePath: chromiumPath, args: [...COMMON, "--disable-gpu", "--disable-3d-apis"] });
});
after(() => Promise.all(Object.values(browsers).map((browser) => browser.close())));

/** What the graphics driver says of its own speed is no complaint of the page. */
const isDriver = (text) => /GL Driver Message|GroupMarker/.test(text);

async function open({ browser = "drawn", width = 1440, height = 900, colorScheme = "light", reducedMotion = "reduce" } = {}) {
  const context = await browsers[browser].newContext({ viewport: { width, height }, colorScheme, reducedMotion, offline: true });
  const page = await context.newPage();
  page.setDefaultTimeout(90_000);
  const complaints = [];
  page.on("console", (message) => { if (!isDriver(message.text())) complaints.push(`console: ${message.text()}`); });
  page.on("pageerror", (error) => complaints.push(`error: ${error.message}`));
  page.on("request", (request) => { if (!/^(file|data|blob):/.test(request.url())) complaints.push(`request: ${request.url()}`); });
  await page.goto(`file://${PAGE}`);
  await page.waitForFunction(() => document.documentElement.dataset.drawn === "yes");
  await page.locator("#replay").scrollIntoViewIfNeeded();
  const close = async () => {
    await context.close();
    assert.deepEqual(complaints, []);
  };
  return { page, close };
}

const goTo = (page, part) => page.locator("#replay .time-line input").evaluate((slider, value) => { slider.value = value; slider.dispatchEvent(new Event("input")); }, String(Math.round(1000 * part)));
const timeOf = async (page) => Number((await page.locator("#replay .time-now").innerText()).split(" ")[0]);
const framesOf = (page) => page.evaluate(() => Number(document.querySelector("canvas.scene").dataset.frames ?? 0));
/** Waits for `more` pictures after the first `from` of them. */
const drawn = async (page, more, from) => {
  const wanted = (from ?? (await framesOf(page))) + more;
  await page.waitForFunction((count) => Number(document.querySelector("canvas.scene").dataset.frames ?? 0) >= count, wanted);
};
/** The scene as it stands, sharp. */
const picture = async (page) => {
  await page.waitForFunction(() => document.querySelector("canvas.scene").dataset.rest === "yes");
  return page.locator("canvas.scene").evaluate((canvas) => canvas.toDataURL());
};
const digitsOf = (page, row) => page.locator("#replay .panel tr", { hasText: row }).first().locator(".digits").allInnerTexts();

/** Does an act change what is drawn? */
async function changes(page, act) {
  await drawn(page, 1, 0);
  const [before, from] = [await picture(page), await framesOf(page)];
  await act();
  await drawn(page, 1, from);
  return before !== await picture(page);
}

test("the page has the held scenario and the damaged one in step, and stays small", async () => {
  const { page, close } = await open();
  const names = await page.locator("#replay .scene-names span").allInnerTexts();
  assert.equal(names.length, 2);
  assert.match(names[0], /held/);
  assert.match(names[1], /damaged/);
  const choices = await page.locator("#replay").getByLabel("Shown").locator("option").allInnerTexts();
  assert.deepEqual(choices.map((each) => each.split(":")[0]), ["best held", "nearest dropped", "nearest damaged"]);
  const megabytes = statSync(PAGE).size / 1e6;
  console.log(`a page with three scenarios in motion: ${megabytes.toFixed(1)} MB`);
  assert.ok(megabytes < 6, `${megabytes} MB`);
  await close();
});

test("slider, scene, digits and charts show one time", async () => {
  const { page, close } = await open();
  await drawn(page, 0);
  const end = await page.evaluate(() => Number(/([\d.]+) s/.exec(document.querySelector("canvas.scene").getAttribute("aria-label").split("over ")[1])[1]));
  assert.ok(await changes(page, () => goTo(page, 0.5)), "the scene stands still");
  assert.ok(Math.abs((await timeOf(page)) - 0.5 * end) < 0.01 * end);
  const [held, damaged] = (await digitsOf(page, "left pad presses")).map(Number);
  assert.ok(held > 1.3 && held < 1.7, `a grip of 1.5 N presses with ${held} N`);
  assert.ok(damaged > 8 && damaged < 10, `a grip of 9 N presses with ${damaged} N`);
  // The line through the charts stands in their middle.
  await page.locator("#replay .replay-charts .chart").last().scrollIntoViewIfNeeded();
  const cursor = await page.locator("#replay .time-cursor").last().boundingBox();
  const chart = await page.locator("#replay .replay-charts .chart").last().boundingBox();
  assert.ok(Math.abs((cursor.x - chart.x - 52) / (chart.width - 62) - 0.5) < 0.02);
  // A click in a chart goes there.
  await page.mouse.click(chart.x + 52 + 0.25 * (chart.width - 62), chart.y + 90);
  assert.ok(Math.abs((await timeOf(page)) - 0.25 * end) < 0.02 * end);
  await close();
});

test("it plays, pauses, and begins by itself where nobody asks for stillness", async () => {
  const { page, close } = await open();
  assert.equal(await timeOf(page), 0, "a still system begins still");
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.waitForFunction(() => parseFloat(document.querySelector("#replay .time-now").textContent) > 0.1);
  await page.getByRole("button", { name: "Pause" }).click();
  const time = await timeOf(page);
  await page.waitForTimeout(300);
  assert.equal(await timeOf(page), time);
  await close();
  const moving = await open({ reducedMotion: "no-preference" });
  await moving.page.locator("canvas.scene").scrollIntoViewIfNeeded();
  await moving.page.waitForFunction(() => parseFloat(document.querySelector("#replay .time-now").textContent) > 0.05);
  await moving.close();
});

test("an event is a button that goes to its time", async () => {
  const { page, close } = await open();
  const touch = page.getByRole("button", { name: /left pad and right pad touch at/ }).first();
  const wanted = Number(/at ([\d.]+) s/.exec(await touch.getAttribute("aria-label"))[1]);
  await touch.click();
  assert.ok(Math.abs((await timeOf(page)) - wanted) < 0.001);
  assert.ok((await page.getByRole("button", { name: /^damaged at/ }).count()) === 1);
  await close();
});

test("views, drags, keys, colours and factors change the scene", async () => {
  const { page, close } = await open();
  await goTo(page, 0.5);
  await drawn(page, 0);
  for (const name of ["View: top", "View: side", "View: arm", "Nearer", "Reset the view"]) {
    assert.ok(await changes(page, () => page.getByRole("button", { name }).click()), name);
  }
  const canvas = page.locator("canvas.scene");
  await canvas.focus();
  for (const key of ["ArrowLeft", "+", "2", "0", "."]) assert.ok(await changes(page, () => page.keyboard.press(key)), key);
  const box = await canvas.boundingBox();
  assert.ok(await changes(page, async () => {
    await page.mouse.move(box.x + 200, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 260, box.y + 190);
    await page.mouse.up();
  }), "a drag");
  assert.ok(await changes(page, () => page.locator("#replay").getByLabel("Colour", { exact: true }).selectOption("pressure_Pa")), "colour");
  assert.match(await page.locator("#replay .field-legend").innerText(), /contact pressure[\s\S]*kPa/);
  assert.ok(await changes(page, () => page.locator("#replay").getByLabel("Deformation", { exact: true }).selectOption("20")), "factor");
  assert.match(await page.locator("#replay .replay-left .note").innerText(), /20 times as large as it is, to [\d.]+ µm/);
  assert.ok(await changes(page, () => page.locator("#replay").getByLabel("forces", { exact: true }).uncheck()), "arrows");
  assert.ok(await changes(page, () => page.locator("#replay").getByLabel("Beside it").selectOption("")), "one scene");
  await close();
});

test("sound is off until it is asked for", async () => {
  const { page, close } = await open();
  const sound = page.locator("#replay .sound");
  assert.equal(await sound.getAttribute("aria-pressed"), "false");
  await sound.click();
  assert.equal(await sound.getAttribute("aria-pressed"), "true");
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.waitForTimeout(400);
  await sound.click();
  assert.equal(await sound.innerText(), "Sound off");
  await close();
});

test("a scene is drawn often enough to move", async () => {
  const { page, close } = await open({ reducedMotion: "no-preference" });
  await page.locator("#replay").getByLabel("Beside it").selectOption("");
  await page.locator("canvas.scene").scrollIntoViewIfNeeded();
  await drawn(page, 20);
  const seconds = await page.evaluate(() => performance.now() / 1000);
  await drawn(page, 60);
  const rate = 60 / ((await page.evaluate(() => performance.now() / 1000)) - seconds);
  console.log(`${rate.toFixed(0)} frames a second, drawn by the processor`);
  assert.ok(rate > 5, `${rate} frames a second`); // a loaded machine is slower than a reader's
  await close();
});

test("light and dark, a phone and paper", async () => {
  const { page, close } = await open();
  assert.ok(await changes(page, () => page.getByRole("button", { name: "Switch to dark" }).click()), "dark");
  await close();
  const phone = await open({ width: 390, height: 844 });
  assert.equal(await phone.page.evaluate(() => document.documentElement.scrollWidth), 390);
  const low = await phone.page.locator("#replay button:visible, #replay select:visible").evaluateAll((all) => all.filter((each) => each.getBoundingClientRect().height < 43.5).map((each) => each.outerHTML.slice(0, 80)));
  assert.deepEqual(low, [], "too small for a finger");
  await phone.close();
});

test("without WebGL the page says so and shows everything else", async () => {
  const { page, close } = await open({ browser: "bare" });
  assert.match(await page.locator("#replay .banner").innerText(), /no WebGL/);
  assert.equal(await page.locator("canvas.scene").count(), 0);
  await goTo(page, 0.5);
  assert.ok(Number((await digitsOf(page, "left pad presses"))[0]) > 1);
  assert.ok((await page.locator("#replay .replay-charts canvas").count()) > 0);
  assert.ok((await page.locator("#replay .tick").count()) > 3);
  await close();
});

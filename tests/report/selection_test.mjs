// usage: node selection_test.mjs PAGES PACKAGES
// One selection for the whole page: words, outcomes, brushes, marks, the pointer, the address (browser.mjs).

import assert from "node:assert/strict";
import test from "node:test";
import { coloursOf, csvOf, open, PHONE, settled } from "./browser.mjs";

const bar = (page) => page.locator("aside.selection");
const countOf = async (page) => Number(/^([\d,]+) of/.exec(await bar(page).locator("p").innerText())[1].replaceAll(",", ""));
const rowsOf = async (page) => (await csvOf(page, "scenarios")).lines.slice(1, -1).map((line) => line.split(","));
/** A chart as it is when it has come into sight. */
async function picture(page, section) {
  const canvas = page.locator(`#${section} .chart canvas`).first();
  await canvas.scrollIntoViewIfNeeded();
  await settled(page);
  return canvas.evaluate((each) => each.toDataURL());
}

/** A drag from one part of a chart to another, in parts of its box. */
async function drag(page, section, from, to) {
  const chart = page.locator(`#${section} .chart`).first();
  await chart.scrollIntoViewIfNeeded();
  const box = await chart.boundingBox();
  const at = ([x, y]) => [box.x + x * box.width, box.y + y * box.height];
  await page.mouse.move(...at(from));
  await page.mouse.down();
  await page.mouse.move(...at([(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]));
  await page.mouse.move(...at(to));
  await page.mouse.up();
  await settled(page);
}

test("nothing is selected at first, and nothing says so", async () => {
  const { page, close } = await open("kiwi_sweep");
  assert.equal(await bar(page).isVisible(), false);
  assert.equal(new URL(page.url()).hash, "");
  await close();
});

test("an outcome pressed in a legend selects in every legend, chart and table", async () => {
  const { page, close } = await open("kiwi_sweep");
  const before = {};
  for (const section of ["map", "distributions", "parallel", "slices", "windows"]) before[section] = await picture(page, section);
  await page.locator("#map .legend").getByRole("button", { name: "held" }).click();
  await settled(page);
  const pressed = await page.locator('.legend button[aria-pressed="true"], .chip[aria-pressed="true"]').allInnerTexts();
  assert.ok(pressed.length >= 4 && pressed.every((text) => text.startsWith("held")), pressed.join());
  const rows = await rowsOf(page);
  assert.ok(rows.length > 10 && rows.every((cells) => cells[1] === "held"));
  assert.equal(await countOf(page), rows.length);
  for (const [section, old] of Object.entries(before)) assert.notEqual(await picture(page, section), old, `${section} shows what it showed before`);
  await bar(page).getByRole("button", { name: "Clear" }).click();
  await settled(page);
  assert.equal(await bar(page).isVisible(), false);
  assert.equal((await rowsOf(page)).length, 512);
  for (const [section, old] of Object.entries(before)) assert.equal(await picture(page, section), old, `${section} does not come back`);
  await close();
});

test("a drag over the map selects what lies in it", async () => {
  const { page, close } = await open("kiwi_sweep");
  await drag(page, "map", [0.3, 0.2], [0.55, 0.75]);
  const conditions = await bar(page).locator(".condition span:first-child").allInnerTexts();
  assert.match(conditions.join("; "), /grip force [\d.]+ to [\d.]+ N; approach speed [\d.]+ to [\d.]+ m\/s/);
  const [, low, high] = /grip force ([\d.]+) to ([\d.]+) N/.exec(conditions.join("; ")).map(Number);
  const rows = await rowsOf(page);
  assert.ok(rows.length > 4 && rows.length < 300, `${rows.length} rows`);
  assert.ok(rows.every((cells) => Number(cells[2]) >= low && Number(cells[2]) <= high));
  // A condition goes away alone.
  await bar(page).locator(".condition").first().click();
  await settled(page);
  assert.doesNotMatch((await bar(page).locator(".condition span:first-child").allInnerTexts()).join(), /grip force/);
  assert.ok((await rowsOf(page)).length > rows.length);
  await close();
});

test("a drag over a histogram and along an axis of all axes selects a range", async () => {
  const { page, close } = await open("kiwi_sample");
  await drag(page, "distributions", [0.3, 0.5], [0.5, 0.5]);
  const one = await countOf(page);
  assert.ok(one > 0 && one < 200, `${one}`);
  await bar(page).getByRole("button", { name: "Clear" }).click();
  // The first axis stands 64 px from the left; values go upwards.
  const width = (await page.locator("#parallel .chart").boundingBox()).width;
  await drag(page, "parallel", [64 / width, 0.85], [64 / width, 0.5]);
  const first = await bar(page).locator(".condition span:first-child").allInnerTexts();
  assert.match(first.join(), /friction 0\.\d+ to 0\.\d+/);
  const [, low, high] = /friction ([\d.]+) to ([\d.]+)/.exec(first.join()).map(Number);
  const rows = await rowsOf(page);
  assert.ok(rows.length > 3 && rows.every((cells) => Number(cells[2]) >= low && Number(cells[2]) <= high));
  // A click on the axis lets it go.
  await page.locator("#parallel .chart").scrollIntoViewIfNeeded();
  const box = await page.locator("#parallel .chart").boundingBox();
  await page.mouse.click(box.x + 64, box.y + 200);
  await settled(page);
  assert.equal(await bar(page).isVisible(), false);
  await close();
});

test("the pointer lights the same scenario in the table and in every chart", async () => {
  const { page, close } = await open("kiwi_sweep");
  const row = page.locator("#scenarios tbody tr").nth(3);
  await row.scrollIntoViewIfNeeded();
  await row.hover();
  assert.match(await row.getAttribute("class"), /lit/);
  const litIn = () => page.evaluate(() => [...document.querySelectorAll("section")].filter((section) => section.querySelector(".over .lit")).map((section) => section.id));
  for (const section of ["map", "parallel"]) assert.ok((await litIn()).includes(section), `${section} does not light up: ${await litIn()}`);
  // And from a chart to the table: the same scenario, found by its mark.
  await row.hover();
  const mark = await page.locator("#map .over .lit").first().evaluate((circle) => [Number(circle.getAttribute("cx")), Number(circle.getAttribute("cy"))]);
  await page.locator("#map .chart").scrollIntoViewIfNeeded();
  const box = await page.locator("#map .chart").boundingBox();
  await page.mouse.move(box.x + mark[0], box.y + mark[1]);
  assert.equal(await page.locator("#scenarios tbody tr.lit").count(), 1);
  await close();
});

test("a mark stays, and stands in the address", async () => {
  const { page, close } = await open("kiwi_optimize");
  const box = page.locator("#scenarios").getByLabel("mark scenario 3", { exact: true });
  await box.check();
  assert.equal(await page.locator("#convergence .over .marked").count() > 0, true);
  assert.match(page.url(), /marked=3/);
  await page.reload();
  await settled(page);
  assert.equal(await box.isChecked(), true);
  assert.equal(await page.locator("#map .over .marked").count(), 1);
  await close();
});

test("the selection is in the address, and an address selects", async () => {
  const { page, close } = await open("kiwi_sweep");
  await page.locator("#scenarios input[type=search]").fill("cycle_time_s < 2");
  await page.locator("#scenarios .chip", { hasText: "held" }).click();
  await settled(page);
  const count = await countOf(page);
  const { hash } = new URL(page.url());
  assert.match(hash, /^#\?/);
  await close();

  const other = await open("kiwi_sweep", { hash: hash.replace("#", "#scenarios") });
  await settled(other.page);
  assert.equal(await countOf(other.page), count);
  assert.equal(await other.page.locator("#scenarios input[type=search]").inputValue(), "cycle_time_s < 2");
  assert.equal(await other.page.locator('#scenarios .chip[aria-pressed="true"]').innerText(), "held");
  // A link inside the page keeps it.
  await other.page.locator("header nav").getByText("Windows").click();
  assert.match(other.page.url(), /#windows\?filter=/);
  assert.equal(await countOf(other.page), count);
  await other.close();
});

test("an address of another study, or of none, harms nothing", async () => {
  for (const hash of ["#map?outcome=held,nonsense&in=no.such.key:1:2&in=strategy.grip_force_N:x:2&marked=99999", "#?filter=%3Cimg%20src%3Dx%20onerror%3Dalert(1)%3E", "#??&&=:::"]) {
    const { page, close } = await open("kiwi_sweep", { hash });
    await settled(page);
    assert.equal(await page.locator("aside img").count(), 0);
    await close();
  }
});

test("what is worked out from all scenarios says so while something is selected", async () => {
  for (const [name, section] of [["kiwi_compare", "comparison"], ["kiwi_sobol", "sensitivity"]]) {
    const { page, close } = await open(name);
    assert.equal(await page.locator(`#${section} .whole`).isVisible(), false);
    await page.locator("#scenarios .chip").first().click();
    assert.equal(await page.locator(`#${section} .whole`).isVisible(), true);
    await close();
  }
});

test("a finger along an axis selects a range of it on a phone", async () => {
  const { page, close } = await open("kiwi_sample", { viewport: PHONE });
  const chart = page.locator("#parallel .chart");
  await chart.scrollIntoViewIfNeeded();
  await page.evaluate(() => document.querySelector("#parallel .chart").scrollIntoView({ block: "start", behavior: "instant" }));
  await page.evaluate(() => window.scrollBy(0, -150));
  await settled(page);
  const box = await chart.boundingBox();
  const device = await page.context().newCDPSession(page);
  await device.send("Emulation.setTouchEmulationEnabled", { enabled: true });
  // The first axis lies 44 px below the top; values go to the right.
  const at = (part) => [{ x: box.x + part * box.width, y: box.y + 44 }];
  await device.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: at(0.3) });
  for (const part of [0.4, 0.5, 0.6]) await device.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: at(part) });
  await device.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await settled(page);
  assert.match((await bar(page).locator(".condition span:first-child").allInnerTexts()).join(), /friction 0\.\d+ to 0\.\d+/);
  await close();
});

test("it selects on a phone too, and the bar fits", async () => {
  const { page, close } = await open("kiwi_sample", { viewport: PHONE });
  await page.locator("#map .legend").getByRole("button", { name: "held" }).click();
  await settled(page);
  const inside = await bar(page).evaluate((element) => { const box = element.getBoundingClientRect(); return box.left >= 0 && box.right <= innerWidth && box.bottom <= innerHeight; });
  assert.ok(inside, "the bar is cut off");
  const low = await bar(page).locator("button").evaluateAll((all) => all.filter((each) => each.getBoundingClientRect().height < 43.5).length);
  assert.equal(low, 0, "too small for a finger");
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  assert.ok((await coloursOf(page, "parallel")) > 8);
  await close();
});

// usage: node table_test.mjs PAGES PACKAGES
// What a reader does with the pages of PAGES: points, clicks, sorts, filters, saves, chooses (browser.mjs).

import assert from "node:assert/strict";
import test from "node:test";
import { csvOf, open } from "./browser.mjs";

test("the pointer shows a scenario and the command that replays it, a click copies it", async () => {
  const { page, close } = await open("kiwi_sweep");
  await page.evaluate(() => { navigator.clipboard.writeText = (text) => { window.copied = text; return Promise.resolve(); }; });
  const canvas = page.locator("#map canvas").first();
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  await page.mouse.move(box.x + box.width * 0.5, box.y + box.height * 0.5);
  const replay = page.locator("#map .tip .replay");
  await replay.waitFor();
  const command = await replay.innerText();
  assert.match(command.replaceAll(/\s+/g, " "), /^unbruised run results\/kiwi_sweep\/config\.toml --output results\/kiwi_sweep --scenario \d+$/);
  await page.mouse.click(box.x + box.width * 0.5, box.y + box.height * 0.5);
  assert.equal(await page.evaluate(() => window.copied), command.replaceAll(/\s+/g, " "));
  assert.match(await page.locator(".toast").innerText(), /Copied the command that replays scenario \d+/);
  await close();
});

/** Where a chart shows a mark of the theme's accent, from its corner: the first spot of that colour that no line is wide enough for. */
const markOf = (page, section) =>
  page.locator(`#${section} .chart canvas`).first().evaluate((canvas) => {
    const context = canvas.getContext("2d");
    context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--accent");
    const accent = [1, 3, 5].map((at) => parseInt(context.fillStyle.slice(at, at + 2), 16));
    const { data, width, height } = context.getImageData(0, 0, canvas.width, canvas.height);
    const isAccent = (x, y) => accent.every((value, i) => Math.abs(data[4 * (y * width + x) + i] - value) < 8);
    const half = 4;
    const isMark = (x, y) => {
      for (let dy = -half; dy <= half; dy += 1) for (let dx = -half; dx <= half; dx += 1) if (!isAccent(x + dx, y + dy)) return false;
      return true;
    };
    for (let y = half; y < height - half; y += 1) {
      for (let x = half; x < width - half; x += 1) if (isMark(x, y)) return { x: x * canvas.clientWidth / width, y: y * canvas.clientHeight / height };
    }
    return null;
  });

test("a click on a mark of a search and on the front copies too", async () => {
  const { page, close } = await open("kiwi_pareto");
  await page.evaluate(() => { navigator.clipboard.writeText = (text) => { window.copied = text; return Promise.resolve(); }; });
  const canvas = page.locator("#pareto canvas").first();
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const mark = await markOf(page, "pareto");
  assert.ok(mark, "no mark of the front is drawn");
  await page.mouse.move(box.x + mark.x, box.y + mark.y);
  await page.locator("#pareto .tip .replay").waitFor();
  await page.mouse.click(box.x + mark.x, box.y + mark.y);
  assert.match(await page.evaluate(() => window.copied), /--scenario \d+$/);
  await close();
});

const firstColumn = (page) => page.locator("#scenarios tbody tr td:first-child").allInnerTexts();

test("the table sorts, filters and pages", async () => {
  const { page, close } = await open("kiwi_sweep");
  const table = page.locator("#scenarios");
  const header = table.locator('th button[data-column="cycle_time_s"]');
  const cells = async () => (await table.locator("tbody tr").evaluateAll((rows, at) => rows.map((row) => row.children[at].textContent), await header.evaluate((button) => button.closest("th").cellIndex))).map(Number);
  assert.equal((await firstColumn(page)).length, 25);

  await header.click();
  const up = await cells();
  assert.deepEqual(up, [...up].sort((a, b) => a - b));
  assert.equal(await table.locator('th[aria-sort="ascending"]').count(), 1);
  await header.click();
  const down = await cells();
  assert.deepEqual(down, [...down].sort((a, b) => b - a));
  assert.ok(down[0] > up[0]);

  await table.locator("input[type=search]").fill("grip_force_N < 1, dropped");
  const words = await table.locator("tbody tr td:nth-child(2)").allInnerTexts();
  assert.ok(words.length > 0 && words.every((word) => word.trim() === "dropped"), words.join());
  assert.match(await table.locator(".message").innerText(), /of 512 rows/);

  await table.locator("input[type=search]").fill("grip_froce_N < 1");
  assert.match(await table.locator(".message").innerText(), /no column named grip_froce_N/);
  await table.locator("input[type=search]").fill("cycle_time_s < 0");
  assert.match(await table.locator("tbody").innerText(), /No row fits/);

  await table.locator("input[type=search]").fill("");
  await table.locator(".chip", { hasText: "damaged" }).click();
  assert.ok((await table.locator("tbody tr td:nth-child(2)").allInnerTexts()).every((word) => word.trim() === "damaged"));
  await table.locator(".chip", { hasText: "damaged" }).click();

  await header.click();
  await page.getByRole("button", { name: "Next page" }).first().click();
  assert.deepEqual((await firstColumn(page)).slice(0, 2), ["25", "26"]);
  await close();
});

test("the CSV has every column and row, with all digits, in the order shown", async () => {
  const { page, close } = await open("kiwi_sweep");
  const { name, lines } = await csvOf(page, "scenarios");
  assert.equal(name, "kiwi_sweep_scenarios.csv");
  const head = lines[0].split(",");
  assert.deepEqual(head.slice(0, 5), ["id", "outcome", "strategy.grip_force_N", "strategy.approach_speed_m_s", "strategy.lift_acceleration_m_s2"]);
  assert.equal(lines.length, 512 + 2);
  const first = lines[1].split(",");
  assert.deepEqual(first.slice(0, 5), ["0", "dropped", "0.6", "0.02", "1"]);
  // The same law as the fixture's, to the last digit: 0.095 (g + 1) / 1.2 is what holding needs.
  assert.equal(Number(first[head.indexOf("friction_margin_min")]), 0.6 / ((0.095 * (9.80665 + 1)) / (2 * 0.6)) - 1);
  assert.equal(first[head.indexOf("cycle_time_s")], "");

  await page.locator("#scenarios input[type=search]").fill("held");
  await page.locator('#scenarios th button[data-column="cycle_time_s"]').click();
  const filtered = (await csvOf(page, "scenarios")).lines.slice(1, -1);
  assert.ok(filtered.length < 512 && filtered.every((line) => line.split(",")[1] === "held"));
  const cycles = filtered.map((line) => Number(line.split(",")[head.indexOf("cycle_time_s")]));
  assert.deepEqual(cycles, [...cycles].sort((a, b) => a - b));
  await close();
});

test("no cell of the CSV is a formula", async () => {
  const { page, close } = await open("hostile");
  const { lines } = await csvOf(page, "scenarios");
  assert.ok(lines.some((line) => line.includes("'=HYPERLINK")));
  assert.ok(lines.every((line) => !/(^|,)"?[=+@]/.test(line)));
  await close();
});

test("light and dark switch, charts and all, and the choice is kept", async () => {
  const { page, close } = await open("kiwi_window");
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const picture = () => page.locator("#map canvas").first().evaluate((canvas) => canvas.toDataURL());
  const [light, chart] = [await paper(), await picture()];
  await page.getByRole("button", { name: "Switch to dark" }).click();
  assert.notEqual(await paper(), light);
  await page.waitForTimeout(200);
  assert.notEqual(await picture(), chart);
  await page.reload();
  assert.notEqual(await paper(), light);
  await page.getByRole("button", { name: "Switch to light" }).click();
  assert.equal(await paper(), light);
  await close();
});

test("axes, slices and metrics can be chosen with the keyboard", async () => {
  const { page, close } = await open("kiwi_sweep");
  const picture = () => page.locator("#map canvas").first().evaluate((canvas) => canvas.toDataURL());
  const first = await picture();
  await page.locator("#map").getByLabel("lift acceleration").focus();
  await page.keyboard.press("ArrowUp");
  await page.waitForTimeout(200);
  assert.notEqual(await picture(), first);
  await page.locator("#map").getByLabel("Upwards").selectOption("permanent_set_max_m");
  await page.waitForTimeout(200);
  assert.match(await page.locator("#map .chart").getAttribute("aria-label"), /permanent set/);
  await page.locator("#distributions").getByLabel("Metric").selectOption("cycle_time_s");
  await page.waitForTimeout(200);
  assert.match(await page.locator("#distributions .note").innerText(), /do not have this metric/);
  await close();
});

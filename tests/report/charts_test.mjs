// usage: node charts_test.mjs PAGES PACKAGES
// Charts that show a study from other sides, and what is saved of every chart (browser.mjs).

import assert from "node:assert/strict";
import test from "node:test";
import { coloursOf, open, PHONE, saved, settled } from "./browser.mjs";

const WITH_CHARTS = ["kiwi_sweep", "kiwi_window", "kiwi_optimize", "kiwi_robust", "kiwi_pareto", "kiwi_compare", "kiwi_sobol", "kiwi_morris", "kiwi_sample", "hold", "in_motion"];

for (const name of WITH_CHARTS) {
  test(`every chart of ${name} is saved as SVG and as CSV`, async () => {
    const { page, close } = await open(name);
    const charts = await page.locator("figure:has(.chart)").count();
    const [pictures, tables] = ["SVG", "CSV"].map((kind) => page.locator(".savers").getByRole("button", { name: new RegExp(`^${kind} of`) }));
    assert.equal(await pictures.count(), charts);
    assert.equal(await tables.count(), charts);
    const names = await page.locator(".savers button").evaluateAll((all) => all.map((each) => each.getAttribute("aria-label")));
    for (let i = 0; i < charts; i += 1) {
      const svg = await saved(page, pictures.nth(i));
      assert.match(svg.name, /\.svg$/);
      const seen = await page.evaluate((text) => {
        const drawing = new DOMParser().parseFromString(text, "image/svg+xml");
        return { broken: drawing.querySelector("parsererror") !== null, title: drawing.querySelector("title")?.textContent ?? "", marks: drawing.querySelectorAll("path, rect, circle, line, polyline, text").length, scripts: drawing.querySelectorAll("script, image, foreignObject").length };
      }, svg.text);
      assert.ok(!seen.broken && seen.title.length > 10 && seen.marks > 5 && seen.scripts === 0, `${names[2 * i]}: ${JSON.stringify(seen)}`);
      const csv = await saved(page, tables.nth(i));
      assert.match(csv.name, /\.csv$/);
      const lines = csv.text.trimEnd().split("\r\n").map((line) => line.split(",").length);
      assert.ok(lines.length > 1, `${csv.name} is empty`);
      if (!csv.text.includes('"')) assert.ok(lines.every((count) => count === lines[0]), `${csv.name} has lines of different length`);
    }
    await close();
  });
}

test("all axes has an axis for each input and telling metric, and takes others", async () => {
  const { page, close } = await open("kiwi_sweep");
  const words = () => page.locator("#parallel .chart").getAttribute("aria-label");
  for (const name of ["grip force", "approach speed", "lift acceleration", "friction margin", "contact yield ratio", "cycle time"]) assert.ok((await words()).includes(name), name);
  const before = await page.locator("#parallel .chart canvas").evaluate((canvas) => canvas.toDataURL());
  await page.locator("#parallel summary").click();
  await page.locator("#parallel").getByRole("checkbox", { name: "cycle time" }).uncheck();
  await settled(page);
  assert.ok(!(await words()).includes("cycle time"));
  assert.notEqual(await page.locator("#parallel .chart canvas").evaluate((canvas) => canvas.toDataURL()), before);
  await close();
});

test("a limit is drawn on its axis, and the edge of a constraint in slices and contours", async () => {
  const { page, close } = await open("kiwi_sweep");
  const svgOf = async (section, nth = 0) => (await saved(page, page.locator(`#${section} .savers`).getByRole("button", { name: /^SVG/ }).nth(nth))).text;
  assert.match(await svgOf("parallel"), />limit</);
  await page.locator("#slices").getByLabel("Metric").first().selectOption("contact_yield_ratio_max");
  await settled(page);
  assert.match(await svgOf("slices"), />limit 1</);
  await page.locator("#slices").getByLabel("Metric").nth(1).selectOption("contact_yield_ratio_max");
  await settled(page);
  assert.match(await page.locator("#slices .field-legend").innerText(), /edge of a constraint: at most 1/);
  // The colour of the edge, dashed.
  assert.match(await svgOf("slices", 1), /stroke="#b3401a"[^>]*stroke-dasharray|stroke-dasharray[^>]*stroke="#b3401a"/);
  await close();
});

test("a slice through the best holds the scenarios that share its other inputs", async () => {
  const { page, close } = await open("kiwi_sweep");
  const slices = await saved(page, page.locator("#slices .savers").getByRole("button", { name: /^CSV/ }).first());
  const all = await saved(page, page.locator("#scenarios .csv"));
  const read = ({ text }) => { const [head, ...lines] = text.trimEnd().split("\r\n").map((line) => line.split(",")); return lines.map((line) => Object.fromEntries(line.map((cell, i) => [head[i], cell]))); };
  const scenarios = new Map(read(all).map((row) => [row.id, row]));
  const inputs = ["strategy.grip_force_N", "strategy.approach_speed_m_s", "strategy.lift_acceleration_m_s2"];
  for (const input of inputs) {
    const rows = read(slices).filter((row) => row.input === input);
    assert.ok(rows.length > 2, input);
    for (const other of inputs.filter((each) => each !== input)) assert.equal(new Set(rows.map((row) => scenarios.get(row.scenario)[other])).size, 1, `${other} moves along ${input}`);
    for (const row of rows) assert.equal(Number(row.value), Number(scenarios.get(row.scenario)[input]));
  }
  await close();
});

test("contours of a search go through what it tried near the best, and show all of it", async () => {
  const { page, close } = await open("kiwi_optimize");
  const save = async (kind, section, nth) => (await saved(page, page.locator(`#${section} .savers`).getByRole("button", { name: new RegExp(`^${kind}`) }).nth(nth))).text;
  const read = (text) => text.trimEnd().split("\r\n").slice(1).map((line) => line.split(",").map((cell) => (cell === "" ? null : Number(cell))));
  const tried = read(await save("CSV", "convergence", 1));
  const shown = read(await save("CSV", "slices", 1));
  // Evaluation, feasible, grip force, approach speed, lift acceleration; the last of them is not shown, so it decides who is near.
  const lift = tried.map((row) => row[4]);
  assert.ok(shown.length > 100 && shown.length <= tried.length);
  const span = Math.max(...lift) - Math.min(...lift);
  const bestLift = Number(/lift acceleration\s*([\d.]+)/.exec(await page.locator("#answer").innerText())[1]);
  for (const [row, force, speed, value, feasible, , counts] of shown) {
    assert.deepEqual([force, speed, feasible], [tried[row][2], tried[row][3], tried[row][1]]);
    const far = Math.abs(tried[row][4] - bestLift) / span;
    if (Math.abs(far - 0.3) > 0.01) assert.equal(counts, far < 0.3 && value !== null ? 1 : 0, `evaluation ${row} is ${far} of the range off`);
  }
  const svg = await save("SVG", "slices", 1);
  const seen = await page.evaluate((text) => {
    const drawing = new DOMParser().parseFromString(text, "image/svg+xml");
    return [...drawing.querySelectorAll("path")].filter((each) => each.getAttribute("stroke") === "#b3401a" && each.getAttribute("stroke-dasharray")).length;
  }, svg);
  assert.ok(seen > 0, "no edge of a constraint");
  assert.match(await page.locator("#slices .field-legend").innerText(), /where the first constraint is broken/);
  // Another pair of variables, never one over itself.
  await page.locator("#slices").getByLabel("Across").selectOption("strategy.approach_speed_m_s");
  assert.equal(await page.locator("#slices").getByLabel("Upwards").inputValue(), "strategy.grip_force_N");
  await settled(page);
  assert.match(await page.locator("#slices .chart").nth(1).getAttribute("aria-label"), /over approach speed and grip force: \d+ evaluations/);
  await close();
});

test("the probability of being held over an input has an interval, and that of a search is there", async () => {
  const { page, close } = await open("kiwi_sample");
  const { text } = await saved(page, page.locator("#slices .savers").getByRole("button", { name: /^CSV/ }).first());
  const rows = text.trimEnd().split("\r\n").slice(1).map((line) => line.split(",").map((cell, i) => (i ? Number(cell) : cell)));
  assert.equal(rows.length, 3 * 8, "three inputs, eight groups");
  for (const [, , share, low, high] of rows) assert.ok(low <= share && share <= high && low >= 0 && high <= 1);
  await close();
  const robust = await open("kiwi_robust");
  assert.ok((await robust.page.locator("#slices").getByLabel("Metric").locator("option").allInnerTexts()).some((each) => each.startsWith("P(")));
  await robust.close();
});

test("contact events stand over time, one strip for each surface and kind", async () => {
  const { page, close } = await open("in_motion");
  const words = await page.locator('[aria-label^="Contact events over time"]').first().getAttribute("aria-label");
  for (const name of ["left pad: touching", "right pad: touching", "support: letting go"]) assert.ok(words.includes(name), `${name} is not in ${words}`);
  await close();
});

test("measured rupture forces stand below the ruler of the window", async () => {
  const { page, close } = await open("kiwi_window");
  assert.match(await page.locator("#answer .rug p").innerText(), /^5 specimens broke between 1\.92 and 12\.4 N \(kiwi rupture\), 1 of them outside this range; \d below the window's upper end$/);
  const lefts = await page.locator("#answer .rug i").evaluateAll((all) => all.map((each) => parseFloat(each.style.left)));
  assert.equal(lefts.length, 4);
  assert.deepEqual(lefts, [...lefts].sort((a, b) => a - b));
  await close();
});

test("the new charts stand on a phone in the dark", async () => {
  const { page, close } = await open("kiwi_sweep", { viewport: PHONE, colorScheme: "dark" });
  for (const section of ["parallel", "slices"]) assert.ok((await coloursOf(page, section)) > 8, section);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  await close();
});

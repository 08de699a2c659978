// usage: node tests/report/frames.mjs PAGE.html PACKAGES [SECONDS]
// How many pictures a second the scene in motion is drawn with where the processor draws (SwiftShader), one scene and two, what processor
// time each picture takes, in all of the browser's processes, and how busy the machine was. Quiet machines tell frames a second; busy ones
// tell the processor time alone.

import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { loadavg } from "node:os";
import { join, resolve } from "node:path";

const [page, packages] = process.argv.slice(2, 4).map((path) => resolve(path));
const seconds = Number(process.argv[4] ?? 6);
const { chromium } = createRequire(join(packages, "package.json"))("playwright-core");
const TICKS_S = 100;

/** Parent and processor time of every process [s]. */
function processes() {
  const all = new Map();
  for (const pid of readdirSync("/proc").filter((name) => /^\d+$/.test(name))) {
    try {
      const words = readFileSync(`/proc/${pid}/stat`, "utf8").replace(/^.*\) /, "").split(" ");
      all.set(Number(pid), { parent: Number(words[1]), time: (Number(words[11]) + Number(words[12])) / TICKS_S });
    } catch {
      // It has ended meanwhile.
    }
  }
  return all;
}

/** Processor time of a process and all below it [s]. */
function timeBelow(root) {
  const all = processes();
  const isBelow = (pid) => pid === root || (all.has(pid) && all.get(pid).parent > 0 && isBelow(all.get(pid).parent));
  return [...all].filter(([pid]) => isBelow(pid)).reduce((sum, [, { time }]) => sum + time, 0);
}

const server = await chromium.launchServer({ executablePath: process.env.UNBRUISED_CHROMIUM ?? "/usr/bin/chromium", args: ["--headless", "--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"] });
const browser = await chromium.connect(server.wsEndpoint());
try {
  const tab = await browser.newPage({ viewport: { width: 1440, height: 900 }, reducedMotion: "reduce" });
  tab.setDefaultTimeout(120_000);
  await tab.goto(`file://${page}`, { waitUntil: "commit" });
  await tab.waitForFunction(() => document.documentElement.dataset.drawn === "yes");
  await tab.locator("#replay").scrollIntoViewIfNeeded();
  const look = () => tab.evaluate(() => ({ frames: Number(document.querySelector("canvas.scene").dataset.frames ?? 0), now: performance.now() / 1000 }));
  for (const scenes of [2, 1]) {
    if (scenes === 1) await tab.locator("#replay").getByLabel("Beside it").selectOption("");
    await tab.locator("canvas.scene").evaluate((canvas) => canvas.scrollIntoView({ block: "center" }));
    await tab.getByRole("button", { name: "Play", exact: true }).click();
    // The scene has to find out how coarse it may be.
    await tab.waitForTimeout(2500);
    const [before, spent] = [await look(), timeBelow(server.process().pid)];
    await tab.waitForTimeout(1000 * seconds);
    const [after, spentThen] = [await look(), timeBelow(server.process().pid)];
    await tab.getByRole("button", { name: "Pause" }).click();
    const [frames, passed] = [after.frames - before.frames, after.now - before.now];
    const size = await tab.locator("canvas.scene").evaluate((canvas) => `${canvas.clientWidth} x ${canvas.clientHeight}`);
    console.log(`${scenes === 1 ? "one scene" : "two scenes"}, ${size}: ${(frames / passed).toFixed(1)} pictures a second, ${((1000 * (spentThen - spent)) / frames).toFixed(1)} ms of processor time each, ${((spentThen - spent) / passed).toFixed(2)} processors, load ${loadavg()[0].toFixed(1)}`);
  }
} finally {
  await browser.close();
  await server.close();
}

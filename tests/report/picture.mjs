// usage: node tests/report/picture.mjs PAGE.html PICTURE.png
// The first screens of a report as a picture, for docs/images/report.png. Needs what `report/build --tests` installs.

import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const [page, picture] = process.argv.slice(2).map((path) => resolve(path));
const packages = join(dirname(fileURLToPath(import.meta.url)), "../../build/report-tests/package.json");
const { chromium } = createRequire(packages)("playwright-core");

const browser = await chromium.launch({ executablePath: process.env.UNBRUISED_CHROMIUM ?? "/usr/bin/chromium", args: ["--headless", "--no-sandbox", "--disable-gpu"] });
const tab = await browser.newPage({ viewport: { width: 1280, height: 1420 }, colorScheme: "light" });
await tab.goto(`file://${page}`);
await tab.waitForFunction(() => document.documentElement.dataset.drawn === "yes");
await tab.screenshot({ path: picture });
await browser.close();

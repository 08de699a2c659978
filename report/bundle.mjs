// node report/bundle.mjs FOLDER: bundles report/src with the packages in FOLDER/node_modules into FOLDER/bundle.
import { createRequire } from "node:module";
import { mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { dirname, join, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const folder = resolve(process.argv[2]);
const packages = join(folder, "node_modules");
const { buildSync } = createRequire(join(folder, "package.json"))("esbuild");

const options = { bundle: true, minify: true, write: false, logLevel: "warning", legalComments: "none", nodePaths: [packages], charset: "ascii" };
const script = buildSync({ ...options, entryPoints: [join(here, "src/main.js")], format: "iife", target: ["es2020"], metafile: true });
const style = buildSync({ ...options, entryPoints: [join(here, "style.css")] });

/** The licence texts of what is inside the script, for the page's footer. */
function notices() {
  const part = (title, path) => `${title}\n${"=".repeat(title.length)}\n\n${readFileSync(join(packages, path), "utf8").trim()}\n`;
  return [
    part("Apache ECharts: notice", "echarts/NOTICE"),
    part("Apache ECharts: Apache License 2.0", "echarts/LICENSE"),
    part("d3, parts of which are in ECharts: BSD 3-Clause", "echarts/licenses/LICENSE-d3"),
    part("zrender: BSD 3-Clause", "zrender/LICENSE"),
    part("tslib: 0BSD", "tslib/LICENSE.txt"),
    part("three.js: MIT", "three/LICENSE"),
    part("delaunator: ISC", "delaunator/LICENSE"),
    part("robust-predicates: Unlicense", "robust-predicates/LICENSE"),
  ].join("\n\n");
}

function put(name, text, forbidden) {
  if (text.toLowerCase().includes(forbidden)) throw new Error(`${name} holds ${forbidden}, which would end its element in the page`);
  const path = join(folder, "bundle", name);
  writeFileSync(path + ".tmp", text);
  renameSync(path + ".tmp", path);
}

mkdirSync(join(folder, "bundle"), { recursive: true });
const inputs = Object.keys(script.metafile.inputs).filter((path) => !path.includes("node_modules")).map((path) => resolve(path));
put("report.css", style.outputFiles[0].text, "</style");
put("notices.txt", notices(), "</script");
// What make and ninja read: the bundle depends on these.
put("report.d", `${join(folder, "bundle/report.js")}: ${inputs.map((path) => path.replaceAll(" ", "\\ ")).join(" ")}\n`, "\0");
put("report.js", script.outputFiles[0].text.replaceAll("\r", ""), "</script");
console.error(`report: ${relative(process.cwd(), folder)}/bundle/report.js, ${Math.round(script.outputFiles[0].text.length / 1024)} kB`);

// usage: node triangles_test.mjs BUILD
// The surface through scattered values (report/src/triangles.js) against closed forms. BUILD: build/report, which holds esbuild and what the
// page is bundled with.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import test, { after } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";

const packages = resolve(process.argv[2]);
const { buildSync } = createRequire(join(packages, "package.json"))("esbuild");
const folder = mkdtempSync(join(tmpdir(), "triangles-"));
after(() => rmSync(folder, { recursive: true }));
const source = join(dirname(fileURLToPath(import.meta.url)), "../../report/src/triangles.js");
buildSync({ entryPoints: [source], outfile: join(folder, "triangles.mjs"), bundle: true, format: "esm", nodePaths: [join(packages, "node_modules")], logLevel: "error" });
const { bands, levelPieces, triangles } = await import(pathToFileURL(join(folder, "triangles.mjs")));

/** Places that look random and are the same every time (the R2 sequence). */
const scattered = (count) => Array.from({ length: count }, (_, i) => ({ x: (0.7548776662 * (i + 1)) % 1, y: (0.5698402910 * (i + 1)) % 1 }));
const area = (corners) => Math.abs(corners.reduce((sum, [x, y], i) => { const [nextX, nextY] = corners[(i + 1) % corners.length]; return sum + x * nextY - nextX * y; }, 0)) / 2;
const areaOf = (found) => found.reduce((sum, three) => sum + area(three.map(({ x, y }) => [x, y])), 0);
const plane = ({ x, y }) => 2 * x - 3 * y + 0.25;

test("a plane through scattered places has straight level lines, at their level", () => {
  const found = triangles(scattered(60), 2);
  for (const level of [-1.5, -0.2, 0, 0.6, 1.1]) {
    const pieces = levelPieces(found, level, plane);
    assert.ok(pieces.length > 2, `nothing at ${level}`);
    for (const [x, y] of pieces.flat()) assert.ok(Math.abs(plane({ x, y }) - level) < 1e-12);
  }
});

test("bands fill the triangles, each between its levels", () => {
  const found = triangles(scattered(60), 2);
  const levels = [-1, -0.5, 0, 0.5, 1];
  const polygons = bands(found, levels, plane);
  const sum = polygons.reduce((all, { points }) => all + area(points), 0);
  assert.ok(Math.abs(sum - areaOf(found)) < 1e-12, `${sum} of ${areaOf(found)}`);
  for (const { band, points } of polygons) {
    for (const [x, y] of points) {
      const value = plane({ x, y });
      if (band > 0) assert.ok(value > levels[band] - 1e-12);
      if (band + 2 < levels.length) assert.ok(value < levels[band + 1] + 1e-12);
    }
  }
});

test("nothing is said where nobody looked: outside of the places, and across a gap", () => {
  const square = (x0) => [[0, 0], [0.2, 0], [0, 0.2], [0.2, 0.2]].map(([x, y]) => ({ x: x0 + x, y }));
  assert.ok(Math.abs(areaOf(triangles(square(0), 0.3)) - 0.04) < 1e-12, "the hull of the places, no more");
  assert.ok(Math.abs(areaOf(triangles([...square(0), ...square(0.8)], 0.3)) - 0.08) < 1e-12, "two squares, nothing between them");
  assert.equal(triangles(square(0), 0.19).length, 0);
  assert.equal(triangles(square(0).slice(0, 2), 1).length, 0);
});

test("of two at one place the first counts, and what has no value takes its triangles with it", () => {
  const points = [{ x: 0, y: 0, value: 1 }, { x: 1, y: 0, value: 2 }, { x: 0, y: 1, value: 3 }, { x: 0, y: 0, value: 9 }];
  const [three, ...more] = triangles(points, 2);
  assert.equal(more.length, 0);
  assert.deepEqual(three.map(({ value }) => value).sort(), [1, 2, 3]);
  assert.equal(levelPieces([three], 1.5, ({ value }) => value).length, 1);
  assert.equal(levelPieces([three], 1.5, ({ value }) => (value === 1 ? null : value)).length, 0);
});

// Values at scattered places, between which they change evenly over Delaunay's triangles: lines of equal value and bands of colour.

import Delaunator from "delaunator";

/**
 * @param points [{ x, y, ... }], places from 0 to 1; of several at one place the first counts
 * @param gap a triangle with a longer side says nothing: nobody looked in between
 * @returns triangles [[point, point, point]]
 */
export function triangles(points, gap) {
  const apart = [...new Map([...points].reverse().map((point) => [`${point.x.toFixed(4)} ${point.y.toFixed(4)}`, point])).values()];
  if (apart.length < 3) return [];
  const { triangles: corners } = Delaunator.from(apart, ({ x }) => x, ({ y }) => y);
  const found = [];
  for (let i = 0; i < corners.length; i += 3) {
    const three = [apart[corners[i]], apart[corners[i + 1]], apart[corners[i + 2]]];
    if (three.every((a, k) => Math.hypot(a.x - three[(k + 1) % 3].x, a.y - three[(k + 1) % 3].y) <= gap)) found.push(three);
  }
  return found;
}

/** Where from a to b a value is met. */
function between(a, b, level, value) {
  const part = (level - value(a)) / (value(b) - value(a));
  return { x: a.x + part * (b.x - a.x), y: a.y + part * (b.y - a.y), value: level };
}

/** The pieces [[x0, y0], [x1, y1]] of the line of `level` through the triangles. @param value (point) => number or null */
export function levelPieces(found, level, value) {
  return found.filter((three) => three.every((point) => value(point) !== null)).flatMap((three) => {
    const ends = three.flatMap((a, k) => {
      const b = three[(k + 1) % 3];
      return value(a) >= level === value(b) >= level ? [] : [between(a, b, level, value)];
    });
    return ends.length === 2 ? [ends.map(({ x, y }) => [x, y])] : [];
  });
}

/** What of a polygon lies on one side of a level. */
function cut(polygon, level, above) {
  const inside = ({ value }) => (above ? value >= level : value <= level);
  return polygon.flatMap((a, k) => {
    const b = polygon[(k + 1) % polygon.length];
    const here = inside(a) ? [a] : [];
    return inside(a) === inside(b) || a.value === b.value ? here : [...here, between(a, b, level, ({ value }) => value)];
  });
}

/** Polygons [{ band, points: [[x, y], ...] }] between neighbouring levels; what is beyond the ends belongs to the first or the last. */
export function bands(found, levels, value) {
  return found.flatMap((three) => {
    const corners = three.map((point) => ({ x: point.x, y: point.y, value: value(point) }));
    return levels.slice(1).flatMap((high, band) => {
      const low = levels[band];
      let polygon = corners;
      if (band > 0) polygon = cut(polygon, low, true);
      if (band + 2 < levels.length) polygon = cut(polygon, high, false);
      return polygon.length > 2 ? [{ band, points: polygon.map(({ x, y }) => [x, y]) }] : [];
    });
  });
}

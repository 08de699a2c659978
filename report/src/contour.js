// Lines of equal value through a grid of values, by marching squares.

/** Where between two corners a value lies, from 0 to 1. */
function crossing(a, b, level) {
  return (level - a) / (b - a);
}

/**
 * @param xs, ys places of the grid, ascending
 * @param values [j][i] at (xs[i], ys[j]); null: not known
 * @returns pieces [[x0, y0], [x1, y1]] of the line of `level`
 */
export function contour(xs, ys, values, level) {
  const pieces = [];
  for (let j = 0; j + 1 < ys.length; j += 1) {
    for (let i = 0; i + 1 < xs.length; i += 1) {
      const corners = [values[j][i], values[j][i + 1], values[j + 1][i + 1], values[j + 1][i]];
      if (corners.includes(null)) continue;
      pieces.push(...squarePieces([[xs[i], ys[j]], [xs[i + 1], ys[j]], [xs[i + 1], ys[j + 1]], [xs[i], ys[j + 1]]], corners, level));
    }
  }
  return pieces;
}

/** One square: its sides that the level crosses are joined in pairs; where all four are crossed the middle decides. */
function squarePieces(places, corners, level) {
  const found = [];
  for (let side = 0; side < 4; side += 1) {
    const next = (side + 1) % 4;
    if (corners[side] >= level === corners[next] >= level) continue;
    const part = crossing(corners[side], corners[next], level);
    found.push(places[side].map((from, axis) => from + part * (places[next][axis] - from)));
  }
  if (found.length === 2) return [found];
  if (found.length !== 4) return [];
  const middle = corners.reduce((sum, each) => sum + each, 0) / 4;
  return middle >= level === corners[0] >= level ? [[found[0], found[1]], [found[2], found[3]]] : [[found[3], found[0]], [found[1], found[2]]];
}

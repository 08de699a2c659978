// A scene as the program coded it: tables over frames, and what lies between two frames.

/** Numbers of a coded table (studies/report/delta_coder.hpp), frame by frame. */
export function decodeTable({ step, width, coded }, buffer, frames) {
  const bytes = new Uint8Array(buffer, coded.at, coded.rows);
  const values = new Float32Array(width * frames);
  const row = new Float64Array(width);
  let at = 0;
  let zeros = 0;
  const next = () => {
    let value = 0;
    let factor = 1;
    for (;;) {
      const byte = bytes[at++];
      value += (byte & 127) * factor;
      if (byte < 128) return value;
      factor *= 128;
    }
  };
  for (let i = 0; i < values.length; i += 1) {
    const column = i % width;
    if (zeros > 0) zeros -= 1;
    else {
      const value = next();
      if (value === 0) zeros = next();
      else row[column] += value % 2 === 0 ? value / 2 : -(value + 1) / 2;
    }
    values[i] = row[column] * step;
  }
  return values;
}

/** The frame before a time and how far the time is on the way to the next one. */
export function frameAt(times, time) {
  let low = 0;
  let high = times.length - 1;
  if (time <= times[0]) return { frame: 0, part: 0 };
  if (time >= times[high]) return { frame: high, part: 0 };
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  return { frame: low, part: (time - times[low]) / (times[high] - times[low]) };
}

/** Row `frame` of a table, `part` of the way to the next one. */
export function between(table, width, { frame, part }, out = new Float64Array(width)) {
  const here = frame * width;
  for (let i = 0; i < width; i += 1) {
    const value = table[here + i];
    out[i] = part > 0 ? value + part * (table[here + width + i] - value) : value;
  }
  return out;
}

/** The same of a unit quaternion w, x, y, z. */
export function rotationBetween(table, { frame, part }) {
  const a = table.slice(4 * frame, 4 * frame + 4);
  if (!(part > 0)) return a;
  const b = table.slice(4 * frame + 4, 4 * frame + 8);
  const sign = a.reduce((sum, value, i) => sum + value * b[i], 0) < 0 ? -1 : 1;
  const q = a.map((value, i) => (1 - part) * value + part * sign * b[i]);
  const length = Math.hypot(...q);
  return q.map((value) => value / length);
}

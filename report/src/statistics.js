// The few statistics the page computes itself.

/** Wilson's interval for a proportion at 95 %. */
export function wilson(successes, count) {
  if (count === 0) return null;
  const z = 1.959963984540054;
  const p = successes / count;
  const middle = (p + (z * z) / (2 * count)) / (1 + (z * z) / count);
  const half = (z / (1 + (z * z) / count)) * Math.sqrt((p * (1 - p)) / count + (z * z) / (4 * count * count));
  return { low: successes === 0 ? 0 : middle - half, high: successes === count ? 1 : middle + half };
}

/** Quantile of ascending values, linear between them. */
export function quantile(sorted, level) {
  if (sorted.length === 0) return null;
  const at = (sorted.length - 1) * level;
  const low = Math.floor(at);
  const high = Math.min(low + 1, sorted.length - 1);
  return sorted[low] + (at - low) * (sorted[high] - sorted[low]);
}

/** Edges of a histogram at round numbers. */
export function binEdges(least, most, wanted) {
  if (!(most > least)) {
    const half = Math.abs(least) * 0.05 || 0.5;
    return [least - half, least + half];
  }
  const raw = (most - least) / wanted;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((each) => each * power).find((each) => each >= raw * 0.999);
  const first = Math.floor(least / step + 1e-9);
  const last = Math.max(first + 1, Math.ceil(most / step - 1e-9));
  const edges = [];
  for (let i = first; i <= last; i += 1) edges.push(Number((i * step).toPrecision(12)));
  return edges;
}

/** Least and greatest of many. */
export function extent(values) {
  let least = Infinity;
  let most = -Infinity;
  for (const value of values) {
    if (value < least) least = value;
    if (value > most) most = value;
  }
  return least <= most ? [least, most] : null;
}

// From pale to dark, through the colour of damage: lightness alone tells the order, so it reads with any eyes and in grey.

const STOPS = [[0xee, 0xe6, 0xd6], [0xf6, 0xc9, 0x8a], [0xe8, 0x8a, 0x45], [0xc2, 0x4a, 0x24], [0x7c, 0x1f, 0x2b], [0x2e, 0x0b, 0x24]];

/** Red, green, blue from 0 to 1 at a part of the range from 0 to 1. */
export function colourAt(part, out = [0, 0, 0]) {
  const place = Math.min(1, Math.max(0, part)) * (STOPS.length - 1);
  const low = Math.min(STOPS.length - 2, Math.floor(place));
  const rest = place - low;
  for (let i = 0; i < 3; i += 1) out[i] = (STOPS[low][i] + rest * (STOPS[low + 1][i] - STOPS[low][i])) / 255;
  return out;
}

export function gradient() {
  return `linear-gradient(90deg, ${STOPS.map((stop) => `rgb(${stop.join(" ")})`).join(", ")})`;
}

export const COLOUR_STEPS = 256;
/** The same in steps, as bytes: red, green, blue. */
export const colourTable = Uint8Array.from({ length: 3 * COLOUR_STEPS }, (_, i) => Math.round(255 * colourAt(Math.floor(i / 3) / (COLOUR_STEPS - 1))[i % 3]));

// The resolved config, as far as the page reads it: the program writes one `key = value` a line.

/** The entries below a header, e.g. "[limits]": key -> text of the value. `nth` of several such blocks. */
export function blockOf(config, header, nth = 0) {
  const found = {};
  let seen = -1;
  let inside = false;
  for (const line of config.split("\n")) {
    if (line.startsWith("[")) {
      inside = line.trim() === header;
      if (inside) seen += 1;
      continue;
    }
    const entry = inside && seen === nth && /^([\w.]+) = (.*)$/.exec(line.trim());
    if (entry) found[entry[1]] = entry[2];
  }
  return found;
}

/** All blocks of a list of tables, e.g. "[[candidate]]". */
export function blocksOf(config, header) {
  const count = config.split("\n").filter((line) => line.trim() === header).length;
  return Array.from({ length: count }, (_, nth) => blockOf(config, header, nth));
}

/** Of the entries of a block those that are numbers. */
export function numbersOf(block) {
  return Object.fromEntries(Object.entries(block).filter(([, text]) => /^[-+]?[\d.]+(e[-+]?\d+)?$/i.test(text)).map(([key, text]) => [key, Number(text)]));
}

/** The value of an entry: a number, a text without its quotes, or the text as it stands. */
export function plainValue(text) {
  if (text === undefined) return null;
  if (/^[-+]?[\d.]+(e[-+]?\d+)?$/i.test(text)) return Number(text);
  return text.replace(/^"(.*)"$/, "$1");
}

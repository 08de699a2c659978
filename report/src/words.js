// Names and numbers for people.

export const OUTCOMES = ["held", "slipped", "dropped", "damaged", "not_grasped", "diverged", "out_of_range", "misplaced", "not_run"];
/** Most serious first: what a map shows where several scenarios share a cell. */
export const SERIOUSNESS = ["diverged", "out_of_range", "dropped", "not_grasped", "damaged", "slipped", "misplaced", "held", "not_run"];

/** The program's own words for its metrics and keys, and the endings of names with their units. */
let names = {};
let unitSuffixes = [];

export function learnWords({ names: known = {}, unit_suffixes: suffixes = [] } = {}) {
  names = known;
  unitSuffixes = suffixes;
}

export function leaf(key) {
  return key.endsWith(".use") ? key : key.slice(key.lastIndexOf(".") + 1);
}

function suffixOf(name) {
  return unitSuffixes.find(([each]) => name.endsWith(each) && name.length > each.length);
}

/** The units that the name of a key ends with. */
export function unitsOfKey(key) {
  return suffixOf(leaf(key))?.[1] ?? "";
}

/** "strategy.lift_acceleration_m_s2" -> "lift acceleration"; "mean_cycle_time_s" -> "mean cycle time". */
export function label(key) {
  const last = leaf(key);
  const known = names[key] ?? names[last];
  if (known) return known;
  const error = /^(.+)_(relative|absolute)_error$/.exec(last);
  if (error) return `${label(error[1])}, ${error[2]} error`;
  if (last.startsWith("mean_")) return `mean ${label(last.slice(5))}`;
  const suffix = suffixOf(last)?.[0];
  return (suffix ? last.slice(0, -suffix.length) : last).replaceAll("_", " ");
}

export function outcomeLabel(word) {
  return String(word).replaceAll("_", " ");
}

/** The style sheet's colour of an outcome. */
export function outcomeVariable(word) {
  return `var(--${String(word).replaceAll("_", "-")})`;
}

const PRETTY = { 1: "", "m s-1": "m/s", "m s-2": "m/s²", m3: "m³", "kg m-3": "kg/m³", "N s m-1": "N·s/m", "N m": "N·m", "N m-1": "N/m" };
/** Smaller and larger units of a unit: [factor, its name], ascending. */
const SCALES = {
  m: [[1e-6, "µm"], [1e-3, "mm"], [1, "m"]],
  "m s-1": [[1e-6, "µm/s"], [1e-3, "mm/s"], [1, "m/s"]],
  m3: [[1e-9, "mm³"], [1e-6, "cm³"], [1, "m³"]],
  Pa: [[1, "Pa"], [1e3, "kPa"], [1e6, "MPa"]],
  J: [[1e-6, "µJ"], [1e-3, "mJ"], [1, "J"]],
};

/** The factor and name in which values up to `most` read well. */
export function scaleFor(units, most) {
  const scales = SCALES[units];
  const size = Math.abs(most);
  if (!scales || !(size > 0)) return { factor: 1, unit: units in PRETTY ? PRETTY[units] : units };
  // Metres and metres per second stay what they are down to a twentieth.
  const fitting = scales.filter(([factor]) => size >= factor * (factor === 1 && units !== "Pa" ? 0.05 : 1));
  const [factor, unit] = fitting.length ? fitting[fitting.length - 1] : scales[0];
  return { factor, unit };
}

/** Four significant digits, a true minus sign. */
export function number(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  let text;
  if (size >= 1e6 || size < 1e-4) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    text = `${Number(mantissa)}e${Number(exponent)}`;
  } else {
    text = String(Number(value.toPrecision(digits)));
  }
  return text.replaceAll("-", "−");
}

const SAFE_DIGITS = 3;

/** Three digits a person types, rounded towards the inside of a window: up at its lower end, down at its upper. */
export function innerNumber(value, end) {
  if (!(value > 0) || !Number.isFinite(value)) return number(value);
  const step = 10 ** (Math.floor(Math.log10(value)) - SAFE_DIGITS + 1);
  const steps = value / step;
  return number((end === "low" ? Math.ceil(steps - 1e-9) : Math.floor(steps + 1e-9)) * step, SAFE_DIGITS);
}

/** 1,234,567 */
export function thousands(value) {
  return String(value).replace(/\B(?=(\d{3})+(?!\d))/g, ",");
}

/** "1.27 N", "0.12 mm"; in the unit that suits `most`, so that values side by side share it. */
export function quantity(value, units, digits = 4, most = value) {
  if (typeof value === "string") return value;
  if (value === null || value === undefined) return "–";
  const { factor, unit } = scaleFor(units, most);
  return number(value / factor, digits) + (unit ? ` ${unit}` : "");
}

export function percent(ratio, digits = 3) {
  if (ratio === null || ratio === undefined) return "–";
  // 99.96 % is not 100 %.
  return `${number(ratio * 100, ratio > 0.99 && ratio < 1 ? 4 : digits)} %`;
}

export function plural(count, one, many = `${one}s`) {
  return `${thousands(count)} ${count === 1 ? one : many}`;
}

/** "a, b and c" */
export function listed(words) {
  if (words.length < 2) return words.join("");
  return `${words.slice(0, -1).join(", ")} and ${words[words.length - 1]}`;
}

/** A value of a column, in the unit of the whole column. */
export function valueText(column, value, digits = 4) {
  return quantity(value, column.units, digits, column.isText ? undefined : column.most);
}

/** The file a `use` names, without its folders; any other value as it is. */
export function shortText(value) {
  return String(value).replace(/^.*\//, "").replace(/\.toml$/, "").replaceAll("_", " ");
}

/** "grip force 1.2 N, friction 0.5" of the given columns at a row. */
export function valuesText(columns, row, between = ", ") {
  return columns.map((column) => `${label(column.name)} ${column.isText ? shortText(column.at(row)) : valueText(column, column.at(row))}`).join(between);
}

export function date(utc) {
  const found = /^(\d{4}-\d{2}-\d{2})T(\d{2}:\d{2})/.exec(utc ?? "");
  return found ? `${found[1]} ${found[2]} UTC` : "";
}

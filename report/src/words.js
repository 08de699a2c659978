// Names and numbers for people.

export const OUTCOMES = ["held", "slipped", "dropped", "damaged", "not_grasped", "diverged", "out_of_range", "not_run"];
/** Most serious first: what a map shows where several scenarios share a cell. */
export const SERIOUSNESS = ["diverged", "out_of_range", "dropped", "not_grasped", "damaged", "slipped", "held", "not_run"];

const UNIT_SUFFIXES = ["_m_s2", "_m_s", "_kg_m3", "_N_s_m", "_N_m", "_m3", "_kg", "_Pa", "_Hz", "_rad", "_N", "_J", "_s", "_m"];
const LABELS = {
  permanent_set_max_m: "permanent set",
  permanent_set_rms_m: "permanent set, r.m.s.",
  plastic_strain_max: "plastic strain",
  contact_yield_ratio_max: "contact yield ratio",
  compression_max_m: "compression",
  slip_max_m: "slip",
  friction_margin_min: "friction margin",
  outcome_time_s: "time of outcome",
};

export function leaf(key) {
  return key.endsWith(".use") ? key : key.slice(key.lastIndexOf(".") + 1);
}

/** "strategy.lift_acceleration_m_s2" -> "lift acceleration" */
export function label(key) {
  const last = leaf(key);
  if (LABELS[last]) return LABELS[last];
  const suffix = UNIT_SUFFIXES.find((each) => last.endsWith(each) && last.length > each.length);
  return (suffix ? last.slice(0, -suffix.length) : last).replaceAll("_", " ");
}

export function outcomeLabel(word) {
  return String(word).replaceAll("_", " ");
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

/** 1,234,567 */
export function thousands(value) {
  return String(value).replace(/\B(?=(\d{3})+(?!\d))/g, ",");
}

/** "1.27 N", "0.12 mm" */
export function quantity(value, units, digits = 4) {
  if (typeof value === "string") return value;
  if (value === null || value === undefined) return "–";
  const { factor, unit } = scaleFor(units, value);
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

/** "grip force 1.2 N, friction 0.5" of the given columns at a row. */
export function valuesText(columns, row, between = ", ") {
  return columns.map((column) => `${label(column.name)} ${quantity(column.at(row), column.units)}`).join(between);
}

export function date(utc) {
  const found = /^(\d{4}-\d{2}-\d{2})T(\d{2}:\d{2})/.exec(utc ?? "");
  return found ? `${found[1]} ${found[2]} UTC` : "";
}

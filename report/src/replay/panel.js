// The instruments beside the scene: bars with their limits and digits, in a table that reads as one.

import { h } from "../dom.js";
import { boundOf } from "../claims.js";
import { surfaceWords } from "./events.js";
import { label, number, quantity, scaleFor } from "../words.js";

/** In N, N m, J, m: below it numbers are rounding. */
const LEAST_TOLD = 1e-9;
const WRENCH = ["Fx", "Fy", "Fz", "Mx", "My", "Mz"];
const ENERGIES = ["kinetic_energy_J", "elastic_energy_J", "contact_energy_J", "plastic_work_J", "dissipated_energy_J"];
const SHORT = { kinetic_energy_J: "motion", elastic_energy_J: "elastic", contact_energy_J: "contact layers", plastic_work_J: "plastic work", dissipated_energy_J: "lost so far" };

/** Value of a column of a trace at a time, between two rows. */
function reader(model, column) {
  const { time } = model.trace;
  return (t) => {
    let low = 0;
    let high = time.rows - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (time.at(middle) <= t) low = middle;
      else high = middle;
    }
    const [a, b] = [column.at(low), column.at(high)];
    if (a === null || b === null) return a ?? b;
    const [from, to] = [time.at(low), time.at(high)];
    return to > from ? a + ((b - a) * Math.min(1, Math.max(0, (t - from) / (to - from)))) : a;
  };
}

function signal(model, name) {
  return model.trace.signals.find((each) => each.name === name);
}

function mostOf(column) {
  let most = 0;
  for (let i = 0; i < column.rows; i += 1) most = Math.max(most, Math.abs(column.at(i) ?? 0));
  return most;
}

/** The force with which each finger presses: of each { row (row of the trace) => N, at (t) => N }, and their largest. */
export function fingerForces(model) {
  const force = signal(model, "finger_force_N");
  if (!force) return { each: [], at: [], most: 0 };
  const each = model.pads.flatMap((pad, f) => {
    const parts = force.curves.slice(3 * f, 3 * f + 3);
    if (parts.length < 3) return [];
    // How hard it presses: along the normal of its pad where the palm stands upright, else all of it.
    const normal = model.turns ? null : pad.axes[2];
    const pressing = (values) => (normal ? Math.abs(values.reduce((sum, value, i) => sum + normal[i] * (value ?? 0), 0)) : Math.hypot(...values.map((value) => value ?? 0)));
    const readers = parts.map((curve) => reader(model, curve));
    return [{ row: (row) => pressing(parts.map((curve) => curve.at(row))), at: (t) => pressing(readers.map((read) => read(t))) }];
  });
  let most = 0;
  for (const { row } of each) for (let i = 0; i < force.curves[0].rows; i += 1) most = Math.max(most, row(i));
  return { each, at: each.map(({ at }) => at), most };
}

/** The force of the finger that presses most, row by row of the trace: what is heard (studies/report/sound.hpp). */
export function pressingForces(model) {
  const { each } = fingerForces(model);
  const { time } = model.trace;
  const rows = each.length ? Array.from({ length: time.rows }, (_, row) => row) : [];
  return { times: rows.map((row) => time.at(row)), forces: rows.map((row) => Math.max(...each.map((finger) => finger.row(row)))) };
}

function wrenchOf(model) {
  const sensor = signal(model, "sensor_wrench");
  if (sensor?.curves.length === 6) return { ideal: false, read: sensor.curves.map((curve) => reader(model, curve)), most: sensor.curves.map(mostOf) };
  if (!model.pads.length) return null;
  const most = WRENCH.map((_, i) => Math.max(...model.time_s.map((_t, frame) => Math.abs(model.wrist_wrench[6 * frame + i]))));
  return { ideal: true, read: WRENCH.map((_, i) => (t) => model.rowAt(model.wrist_wrench, 6, model.at(t))[i]), most };
}

/** Rows of one model by their key: { label, units, at, most, signed, limit }. */
function rowsOf(study, model) {
  const rows = new Map();
  const put = (group, key, row) => rows.set(key, { group, signed: false, limit: null, ...row });
  const wrench = wrenchOf(model);
  if (wrench) {
    WRENCH.forEach((name, i) => {
      const most = Math.max(...wrench.most.slice(i < 3 ? 0 : 3, i < 3 ? 3 : 6));
      put(wrench.ideal ? "Wrist, without a sensor's own dynamics" : "Six-axis sensor", name, { label: name, units: i < 3 ? "N" : "N m", at: wrench.read[i], most, signed: true });
    });
  }
  const forces = fingerForces(model);
  forces.at.forEach((at, f) => put("Fingers", `force ${f}`, { label: `${surfaceWords(model.pads[f].name)} presses`, units: "N", at, most: forces.most, limit: boundOf(study, "peak_finger_force_N") }));
  const support = signal(model, "support_force_N");
  if (support) put("Fingers", "support", { label: "support carries", units: "N", at: reader(model, support.curves[2]), most: Math.max(forces.most, mostOf(support.curves[2])) });
  const perFinger = (name, group, row) => signal(model, name)?.curves.forEach((curve, f) => put(group, `${name} ${f}`, { label: `${row.label}${model.pads.length > 1 && model.pads[f] ? `, ${surfaceWords(model.pads[f].name)}` : ""}`, units: signal(model, name).units, at: reader(model, curve), most: mostOf(curve), ...row.more }));
  perFinger("range_m", "Ranges", { label: "range" });
  perFinger("friction_margin", "Holding", { label: "friction margin", more: { signed: true, most: 1, limit: 0, clip: true } });
  perFinger("slip_m", "Holding", { label: "slip", more: { limit: boundOf(study, "slip_max_m") } });
  perFinger("contact_yield_ratio", "Damage", { label: "yield ratio", more: { limit: boundOf(study, "contact_yield_ratio_max") ?? 1 } });
  const single = (name, metric) => {
    const found = signal(model, name);
    if (found) put("Damage", name, { label: label(name).replace(/ max$/, ""), units: found.units, at: reader(model, found.curves[0]), most: mostOf(found.curves[0]), limit: boundOf(study, metric) });
  };
  single("plastic_strain_max", "plastic_strain_max");
  single("patch_pressure_Pa", "peak_pressure_Pa");
  const energies = ENERGIES.map((name) => [name, signal(model, name)]).filter(([, found]) => found);
  const most = Math.max(...energies.map(([, found]) => mostOf(found.curves[0])), 0);
  for (const [name, found] of energies) put("Energies", name, { label: SHORT[name], units: "J", at: reader(model, found.curves[0]), most });
  return rows;
}

/** A bar from 0 or from its middle, with the limit as a line; the digits stand beside it. */
function makeBar(row, most, colour) {
  const reach = row.limit === null ? most : Math.max(most, 1.1 * Math.abs(row.limit));
  const fill = h("i", { class: "bar-fill", style: `background:${colour}` });
  const place = (value) => (row.signed ? 50 + (50 * value) / reach : (100 * value) / reach);
  const limit = row.limit !== null && reach > 0 && Math.abs(row.limit) <= reach ? h("i", { class: "bar-limit", style: `left:${place(row.limit)}%` }) : null;
  const element = h("div", { class: `meter${row.signed ? " signed" : ""}`, "aria-hidden": "true" }, fill, limit);
  let shown = null;
  const set = (value) => {
    const at = Math.min(100, Math.max(0, value === null || !(reach > 0) ? place(0) || 0 : place(value)));
    const zero = row.signed ? 50 : 0;
    element.classList.toggle("over", value !== null && row.limit !== null && (row.limit === 0 ? value < 0 : Math.abs(value) > row.limit));
    if (shown !== null && Math.abs(at - shown) < 0.4) return;
    shown = at;
    fill.style.left = `${Math.min(zero, at)}%`;
    fill.style.width = `${Math.abs(at - zero)}%`;
  };
  return { element, set };
}

/** What is a ten-thousandth of the largest, or less than any instrument tells apart, is 0. */
function digits(value, scale, most) {
  if (value === null || value === undefined) return "–";
  return number(Math.abs(value) < Math.max(1e-4 * most, LEAST_TOLD) ? 0 : value / scale.factor, 3);
}

/** @returns { element, set(time) } for one model or two beside each other */
export function panel(study, models) {
  const all = models.map((model) => rowsOf(study, model));
  const keys = [...new Set(all.flatMap((rows) => [...rows.keys()]))];
  const setters = [];
  let group = null;
  const body = [];
  for (const key of keys) {
    const found = all.map((rows) => rows.get(key) ?? null);
    const row = found.find(Boolean);
    const most = Math.max(...found.map((each) => each?.most ?? 0));
    const scale = scaleFor(row.units, most);
    if (row.group !== group) {
      group = row.group;
      body.push(h("tr", { class: "panel-group" }, h("th", { scope: "colgroup", colspan: String(1 + models.length) }, group)));
    }
    const cells = found.map((each, i) => {
      if (!each) return h("td", {}, "–");
      const bar = makeBar(each, most, `var(--${models.length > 1 ? models[i].outcome.replaceAll("_", "-") : "accent"})`);
      const text = h("span", { class: "digits" });
      setters.push((time) => {
        const value = each.at(Math.min(time, models[i].end));
        bar.set(value);
        const said = digits(value, scale, most);
        if (text.textContent !== said) text.textContent = said;
      });
      return h("td", {}, bar.element, text);
    });
    const limit = row.limit === null || row.limit === 0 ? null : h("small", {}, `limit ${quantity(row.limit, row.units, 3)}`);
    body.push(h("tr", {}, h("th", { scope: "row" }, row.label, scale.unit ? h("span", { class: "soft" }, ` ${scale.unit}`) : null, limit), cells));
  }
  const caption = h("caption", { class: "hidden" }, "Instruments at the time shown");
  const heads = models.length > 1 ? h("thead", {}, h("tr", {}, h("td", {}), models.map((model) => h("th", { scope: "col" }, model.title)))) : null;
  const element = h("table", { class: "panel" }, caption, heads, h("tbody", {}, body));
  return { element, set: (time) => setters.forEach((set) => set(time)) };
}

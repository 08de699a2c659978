// Which signals of a trace are worth a strip, in which order, and where their limits lie.

import { crossedLimit } from "./goals.js";
import { boundOf } from "./claims.js";
import { extent } from "./statistics.js";
import { label } from "./words.js";

const FINGERS = ["finger 1", "finger 2"];

/** Signals with the metric that their limit speaks about. */
const METRIC_OF = {
  contact_yield_ratio: "contact_yield_ratio_max", plastic_strain_max: "plastic_strain_max", patch_pressure_Pa: "peak_pressure_Pa",
  absorbed_energy_J: "absorbed_energy_J", slip_m: "slip_max_m", slip_rad: "slip_max_rad", finger_force_N: "peak_finger_force_N",
};
const TITLES = {
  finger_force_N: "force of each finger", contact_yield_ratio: "contact yield ratio", patch_pressure_Pa: "contact pressure", slip_m: "slip", slip_rad: "angle of slip",
  palm_position_m: "way of the palm", finger_way_m: "closing way of the fingers", support_force_N: "force of the support", contact_count: "closed contacts",
};
const ORDER = ["finger_force_N", "contact_yield_ratio", "slip_m", "slip_rad", "palm_position_m", "plastic_strain_max", "patch_pressure_Pa", "absorbed_energy_J", "support_force_N", "contact_count", "finger_way_m"];
const STRIPS_MOST = 8;
const AXIS_WORDS = { x: "along the grip", y: "across", z: "up" };

function curve(name, at, column = null) {
  return { name, at, column };
}

/** A force on the product in what a person asks for: how hard it presses, and how much friction it gives. */
function forceCurves(signal) {
  const [pressing, sideways] = [[], []];
  FINGERS.forEach((finger, f) => {
    const [x, y, z] = signal.curves.slice(3 * f, 3 * f + 3);
    if (!z) return;
    pressing.push(curve(`${finger} presses`, (row) => Math.abs(x.at(row) ?? 0)));
    sideways.push(curve(`${finger} friction`, (row) => Math.hypot(y.at(row) ?? 0, z.at(row) ?? 0)));
  });
  return [...pressing, ...sideways];
}

function curvesOf(signal) {
  if (signal.name === "finger_force_N" && signal.curves.length === 6) return forceCurves(signal);
  return signal.curves.filter((each) => each.varies).map((each) => curve(AXIS_WORDS[each.name] ?? each.name, each.at));
}

function limitOf(study, signal) {
  return boundOf(study, METRIC_OF[signal.name]);
}

/** Strips { name, title, units, curves, limit, range }, the one that decided first. */
export function strips(study) {
  const { trace } = study;
  const decided = (study.row === null ? null : crossedLimit(study, study.row ?? 0)?.metric) ?? null;
  const place = (strip) => (decided !== null && METRIC_OF[strip.name] === decided ? -1 : ORDER.includes(strip.name) ? ORDER.indexOf(strip.name) : ORDER.length);
  return trace.signals
    .filter((signal) => signal.name !== "phase")
    .map((signal) => ({ name: signal.name, title: TITLES[signal.name] ?? label(signal.name), units: signal.units, curves: curvesOf(signal), limit: limitOf(study, signal) }))
    .map((strip) => ({ ...strip, curves: tellingCurves(strip.curves, trace.time.rows) }))
    .filter((strip) => strip.curves.length > 0)
    .sort((a, b) => place(a) - place(b))
    .slice(0, study.stripsMost ?? STRIPS_MOST)
    .map((strip) => ({ ...strip, range: rangeOf(strip, trace.time.rows) }));
}

function valuesOf(curve, rows) {
  return Array.from({ length: rows }, (_, row) => curve.at(row) ?? 0);
}

/** Without curves that stay within a hundredth of what the largest does. */
function tellingCurves(curves, rows) {
  const reach = curves.map((each) => { const [least, most] = extent(valuesOf(each, rows)) ?? [0, 0]; return Math.max(Math.abs(least), Math.abs(most)); });
  return curves.filter((_, i) => reach[i] > 0.01 * Math.max(...reach));
}

/** The least and greatest of the curves, with the limit where it is near enough to be drawn. */
function rangeOf({ curves, limit }, rows) {
  const values = curves.flatMap((each) => valuesOf(each, rows));
  const [least, most] = extent(values) ?? [0, 1];
  const low = Math.min(0, least);
  return [low, limit !== null && limit < 4 * most ? Math.max(most, 1.08 * limit) : most];
}

/** Phases that take time: [{ name, from, to }] in seconds. */
export function phasesOf(study) {
  const { trace } = study;
  const signal = trace.signals.find((each) => each.name === "phase");
  if (!signal) return [];
  const words = new Map([...signal.long_name.matchAll(/(\d+) (\w+)/g)].map(([, code, word]) => [Number(code), word]));
  const code = signal.curves[0];
  const found = [];
  for (let row = 0; row < trace.time.rows; row += 1) {
    const name = words.get(Math.round(code.at(row))) ?? "";
    const time = trace.time.at(row);
    const last = found[found.length - 1];
    if (last?.name === name) continue;
    if (last) last.to = time;
    found.push({ name, from: time, to: trace.time.at(trace.time.rows - 1) });
  }
  return found.filter((phase) => phase.to > phase.from && phase.name);
}

// One replay with its tables decoded, and everything that is asked of it at a time.

import { between, decodeTable, frameAt, rotationBetween } from "./decode.js";

const TABLES = ["vertex_m", "triangle", "line", "permanent_m", "time_s", "product_m", "attitude", "palm_m", "palm_attitude", "finger_way_m", "support_m", "listed_m", "force_N", "force_place_m", "wrist_wrench", "arm_m"];

export const FIELDS = [
  { name: "plastic_strain", label: "plastic strain", units: "1" },
  { name: "von_mises_Pa", label: "von Mises stress", units: "Pa" },
  { name: "pressure_Pa", label: "contact pressure", units: "Pa" },
  { name: "displacement", label: "displacement", units: "m" },
  { name: "permanent", label: "permanent set", units: "m" },
];

const NICE = [1, 2, 3, 5, 10, 20, 30, 50, 100];
/** Of the product's smallest extent: what the largest deformation is drawn as, about. */
const SHOWN_PART = 0.08;

export class ReplayModel {
  /** @param column reads a packed column of the page */
  constructor(data, buffer, column) {
    Object.assign(this, data);
    for (const name of TABLES) {
      const values = column(data[name]);
      this[name] = Float64Array.from({ length: values.rows }, (_, i) => values.at(i) ?? 0);
    }
    this.buffer = buffer;
    this.pads = this.surfaces.filter((surface) => surface.kind === "pad");
    this.listed = this.surfaces.filter((surface) => surface.kind === "listed");
    this.end = this.time_s[this.frames - 1];
    this.armPlaces = this.frames ? this.arm_m.length / (3 * this.frames) : 0;
    const low = [0, 1, 2].map((axis) => Math.min(...this.every(axis)));
    const high = [0, 1, 2].map((axis) => Math.max(...this.every(axis)));
    this.extent = Math.max(...[0, 1, 2].map((axis) => high[axis] - low[axis])) || 0.05;
    this.lowest = low[2];
    this.armRoom = this.roomOfArm();
    this.deformation = decodeTable(this.deformation_m, buffer, this.frames);
    this.placeError = 0.5 * this.deformation_m.step;
    this.ranges = {};
    this.tables = {};
  }

  /** What holds the arm wherever it goes: { middle, radius }; null where there is none. */
  roomOfArm() {
    if (!this.armPlaces) return null;
    const low = [0, 0, 0].fill(Infinity);
    const high = [0, 0, 0].fill(-Infinity);
    for (let i = 0; i < this.arm_m.length; i += 1) {
      const axis = i % 3;
      const frame = Math.floor(i / (3 * this.armPlaces));
      const palm = this.grip_m[axis] + this.palm_m[3 * frame + axis];
      low[axis] = Math.min(low[axis], palm, palm + this.arm_m[i]);
      high[axis] = Math.max(high[axis], palm, palm + this.arm_m[i]);
    }
    return { middle: low.map((each, axis) => 0.5 * (each + high[axis])), radius: 0.5 * Math.hypot(...low.map((each, axis) => high[axis] - each)) };
  }

  every(axis) {
    return Array.from({ length: this.vertices }, (_, v) => this.vertex_m[3 * v + axis]);
  }

  table(name) {
    this.tables[name] ??= decodeTable(this.fields[name], this.buffer, this.frames);
    return this.tables[name];
  }

  at(time) {
    return frameAt(this.time_s, time);
  }

  rowAt(table, width, place) {
    return between(table, width, place);
  }

  rotation(table, place) {
    return rotationBetween(table, place);
  }

  deformed(place, out) {
    return between(this.deformation, 3 * this.vertices, place, out);
  }

  /** What colours each vertex at a time. @param deformed of the same time */
  field(name, place, deformed, out) {
    if (name === "displacement" || name === "permanent") {
      const from = name === "permanent" ? this.permanent_m : deformed;
      for (let v = 0; v < this.vertices; v += 1) out[v] = Math.hypot(from[3 * v], from[3 * v + 1], from[3 * v + 2]);
      return out;
    }
    return between(this.table(name), this.vertices, place, out);
  }

  /** The largest value of a field over the whole run. */
  most(name) {
    if (name in this.fields) return this.fields[name].most;
    if (!(name in this.ranges)) {
      const table = name === "permanent" ? this.permanent_m : this.deformation;
      let most = 0;
      for (let i = 0; i < table.length; i += 3) most = Math.max(most, Math.hypot(table[i], table[i + 1], table[i + 2]));
      this.ranges[name] = most;
    }
    return this.ranges[name];
  }

  /** By how much the deformation has to be drawn larger to be seen. */
  get niceScale() {
    const wanted = (SHOWN_PART * (this.smallest_extent_m || this.extent)) / (this.most("displacement") || 1);
    return NICE.filter((each) => each <= Math.max(1, wanted)).pop();
  }
}

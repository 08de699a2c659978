// What stands around the product: pads with their fingers, the palm, floor, belt, listed surfaces, arrows.

import { BoxGeometry, BufferAttribute, BufferGeometry, CircleGeometry, ConeGeometry, CylinderGeometry, EdgesGeometry, Group, LineSegments, Matrix4, Mesh, MeshBasicMaterial, PlaneGeometry, SphereGeometry, Vector3 } from "three";
import { flatMaterial } from "./materials.js";

const FACE_SIDE = 17;
const UP = new Vector3(0, 1, 0);

/** Are the axes of a surface those of a mirror? A turn cannot make them: their first is taken the other way. */
function isMirrored(axes) {
  const [a, b, n] = axes.map((row) => new Vector3(...row));
  return a.cross(b).dot(n) < 0;
}

/** The turn from the axes of a surface (its rows) to those it is given in. */
function standing(object, axes) {
  const [a, b, n] = axes.map((row) => new Vector3(...row));
  if (isMirrored(axes)) a.negate();
  object.quaternion.setFromRotationMatrix(new Matrix4().makeBasis(a, b, n));
  return object;
}

function box(size, material) {
  return new Mesh(new BoxGeometry(...size), material);
}

/** The edges of what is seen through, so that its shape stays clear. */
function edges(geometry, material) {
  return new LineSegments(new EdgesGeometry(geometry, 30), material);
}

/** The layer of a pad: its face at z = 0, or as high as its heights say, its back flat. */
function padGeometry({ size, thickness, heights, axes }) {
  const [width, height] = size;
  if (!heights.length) {
    const geometry = new BoxGeometry(width, height, thickness);
    geometry.translate(0, 0, -thickness / 2);
    return { geometry, back: thickness };
  }
  const back = thickness - Math.min(...heights);
  const geometry = new PlaneGeometry(width, height, FACE_SIDE - 1, FACE_SIDE - 1);
  const position = geometry.getAttribute("position");
  for (let row = 0; row < FACE_SIDE; row += 1) {
    // A plane's rows go from its upper edge down; heights go along the second extent first.
    for (let column = 0; column < FACE_SIDE; column += 1) {
      const along = isMirrored(axes) ? FACE_SIDE - 1 - column : column;
      position.setZ(row * FACE_SIDE + column, heights[along * FACE_SIDE + (FACE_SIDE - 1 - row)]);
    }
  }
  geometry.computeVertexNormals();
  return { geometry, back };
}

/** A pad on its finger, in the pad's own axes: the face looks along z. */
export function makePad(surface, extent, materials) {
  const group = new Group();
  const { geometry, back } = padGeometry(surface);
  const layer = new Mesh(geometry, surface.heights.length ? materials.face : materials.pad);
  if (!surface.heights.length) layer.add(edges(geometry, materials.line));
  group.add(layer);
  const [width, height] = surface.size;
  const plate = 0.1 * extent;
  const behind = box([width, height, plate], materials.plate);
  behind.add(edges(behind.geometry, materials.line));
  behind.position.z = -back - plate / 2;
  group.add(behind);
  if (surface.heights.length) {
    const rim = box([width, height, back * 0.9], materials.pad);
    rim.position.z = -back * 0.55;
    rim.visible = Math.min(...surface.heights) >= -1e-9;
    group.add(rim);
  }
  // A finger that closes sideways hangs from above; one that closes upwards or down has its rod behind it.
  const upright = Math.abs(surface.axes[2][2]) < 0.7;
  const arm = 0.85 * extent;
  const rod = upright ? box([Math.min(width, 0.42 * extent), arm, plate], materials.finger) : box([0.25 * extent, 0.25 * extent, arm], materials.finger);
  if (upright) rod.position.set(0, height / 2 + arm / 2 - 0.02 * extent, -back - plate / 2);
  else rod.position.z = -back - plate - arm / 2;
  group.add(rod);
  const holder = standing(new Group(), surface.axes);
  holder.add(group);
  return { holder, top: upright ? surface.origin[2] + height / 2 + arm : null, depth: back + plate };
}

/** The bar that the fingers run on, and the flange on top of it. */
export function makePalm(pads, tops, extent, materials) {
  const top = Math.max(...tops.filter((each) => each !== null));
  if (!Number.isFinite(top)) return null;
  const reach = Math.max(...pads.map((pad) => Math.hypot(pad.origin[0], pad.origin[1]))) + 0.45 * extent;
  const along = pads.every((pad) => Math.abs(pad.axes[2][0]) > 0.9);
  const palm = along ? box([2 * reach, 0.5 * extent, 0.25 * extent], materials.palm) : new Mesh(new CylinderGeometry(reach, reach, 0.25 * extent, 40).rotateX(Math.PI / 2), materials.palm);
  palm.position.z = top + 0.1 * extent;
  const flange = new Mesh(new CylinderGeometry(0.28 * extent, 0.28 * extent, 0.35 * extent, 32).rotateX(Math.PI / 2), materials.finger);
  flange.position.z = top + 0.35 * extent;
  const group = new Group();
  group.add(palm, flange);
  return { group, flangeTop: top + 0.5 * extent };
}

/** An arm as its links between base, joints, flange and gripper, thinner from link to link. */
export class ArmBody {
  /** @param places base, joints and flange @param radius of what holds the arm */
  constructor(places, radius, extent, materials) {
    this.group = new Group();
    const last = 0.22 * extent;
    const first = Math.max(last, 0.045 * radius);
    const thickness = (i) => first + ((last - first) * i) / Math.max(1, places - 1);
    this.foot = new Mesh(new CylinderGeometry(1.5 * first, 1.8 * first, first, 32).rotateX(Math.PI / 2), materials.palm);
    this.links = Array.from({ length: places }, (_, i) => new Mesh(new CylinderGeometry(thickness(i + 1), thickness(i), 1, 20).translate(0, 0.5, 0), materials.finger));
    this.joints = Array.from({ length: places }, (_, i) => new Mesh(new SphereGeometry(1.25 * thickness(i), 20, 14), materials.palm));
    this.group.add(this.foot, ...this.links, ...this.joints);
  }

  /** @param points as many as places, and where the gripper hangs on it */
  set(points) {
    this.foot.position.copy(points[0]);
    this.links.forEach((link, i) => {
      const way = points[i + 1].clone().sub(points[i]);
      const length = way.length();
      link.visible = length > 1e-6;
      if (!link.visible) return;
      link.position.copy(points[i]);
      link.quaternion.setFromUnitVectors(UP, way.divideScalar(length));
      link.scale.y = length;
    });
    this.joints.forEach((joint, i) => joint.position.copy(points[i]));
  }
}

function lines(points, material) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
  return new LineSegments(geometry, material);
}

/** A floor with lines on it, so that whoever is carried over it is seen to move. */
export function makeFloor(extent, half, materials) {
  const spacing = 0.75 * extent;
  const plane = new Mesh(new CircleGeometry(half, 64), materials.floor);
  const points = [];
  const count = Math.floor(half / spacing);
  for (let i = -count; i <= count; i += 1) {
    const reach = Math.sqrt(half * half - (i * spacing) ** 2) * 0.98;
    points.push(i * spacing, -reach, 0, i * spacing, reach, 0, -reach, i * spacing, 0, reach, i * spacing, 0);
  }
  const grid = lines(points, materials.grid);
  grid.position.z = 0.002 * extent;
  const group = new Group();
  group.add(plane, grid);
  return { group, grid, spacing };
}

/** What a product is put down on where that is not the floor it stood on. */
export function makeTarget(extent, height, materials) {
  const slab = box([3 * extent, 3 * extent, Math.max(0.04 * extent, Math.abs(height))], materials.listed);
  slab.position.z = -Math.max(0.04 * extent, Math.abs(height)) / 2;
  const group = new Group();
  group.add(slab);
  return group;
}

export function makeListed(surface, extent, materials) {
  const size = surface.size.map((each) => each || 8 * extent);
  const face = new Mesh(new PlaneGeometry(...size), materials.listed);
  const holder = standing(new Group(), surface.axes);
  holder.add(face);
  return holder;
}

export function makeShadow(extent) {
  return new Mesh(new CircleGeometry(0.5 * extent, 40), flatMaterial(0x000000, 0.25));
}

/** An arrow whose tip is set to a place; drawn over everything, since forces act inside of what is seen. */
export class Arrow {
  constructor(colour, extent) {
    this.extent = extent;
    this.material = new MeshBasicMaterial({ color: colour, depthTest: false, transparent: true });
    this.shaft = new Mesh(new CylinderGeometry(0.018 * extent, 0.018 * extent, 1, 10).translate(0, -0.5, 0), this.material);
    this.head = new Mesh(new ConeGeometry(0.055 * extent, 0.15 * extent, 16).translate(0, -0.075 * extent, 0), this.material);
    this.group = new Group();
    this.group.add(this.shaft, this.head);
    this.group.renderOrder = 5;
    this.shaft.renderOrder = 5;
    this.head.renderOrder = 5;
  }

  /** @param length of the arrow, in m; @param direction of unit length */
  set(tip, direction, length) {
    this.group.visible = length > 0.04 * this.extent;
    if (!this.group.visible) return;
    this.group.position.copy(tip);
    this.group.quaternion.setFromUnitVectors(UP, direction);
    this.shaft.position.y = -0.12 * this.extent;
    this.shaft.scale.y = Math.max(1e-6, length - 0.12 * this.extent);
  }
}

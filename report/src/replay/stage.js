// One scene: the product as it deforms, what touches it, the forces between them.

import { BufferAttribute, BufferGeometry, Color, Group, InstancedMesh, LineSegments, Matrix4, Mesh, Quaternion, Scene, SphereGeometry, Vector3 } from "three";
import { COLOUR_STEPS, colourTable } from "./colour_map.js";
import { litMaterial, makeMaterials } from "./materials.js";
import { ArmBody, Arrow, makeFloor, makeListed, makePad, makePalm, makeShadow, makeTarget } from "./parts.js";
import { addNormals } from "./normals.js";

/** So many extents of the product the floor reaches. */
const FLOOR_EXTENTS = 9;
/** Within so much of the product's extent a face goes with the scaled deformation. */
const NEAR_PART = 0.15;

function quaternion([w, x, y, z]) {
  return new Quaternion(x, y, z, w);
}

export class Stage {
  constructor(model, theme) {
    this.model = model;
    this.scene = new Scene();
    this.materials = makeMaterials(theme);
    this.scene.background = new Color(theme.paper);
    this.addProduct(theme);
    this.addSurroundings();
    this.arrows = model.surfaces.map((surface, s) => {
      const colour = surface.kind === "pad" ? theme.series[surface.finger % theme.series.length] : theme.ink;
      const arrow = new Arrow(new Color(colour), model.extent);
      this.scene.add(arrow.group);
      return { arrow, s };
    });
    // All of it is near what is looked at: asking whether each part is seen costs more than drawing it.
    this.scene.traverse((object) => { object.frustumCulled = false; });
    this.strongest = 0;
    for (let i = 0; i < model.force_N.length; i += 3) this.strongest = Math.max(this.strongest, Math.hypot(model.force_N[i], model.force_N[i + 1], model.force_N[i + 2]));
  }

  addProduct(theme) {
    const { model } = this;
    this.deformed = new Float64Array(3 * model.vertices);
    this.values = new Float64Array(model.vertices);
    this.product = new Group();
    this.scene.add(this.product);
    const colours = new BufferAttribute(new Uint8Array(3 * model.vertices), 3, true);
    const places = new BufferAttribute(new Float32Array(model.vertex_m), 3);
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute("position", places);
    if (model.triangle.length === 0) {
      this.beads = new InstancedMesh(new SphereGeometry(0.03 * model.extent, 14, 10), litMaterial(theme, 0xffffff), model.vertices);
      this.geometry.setIndex(Array.from(model.line));
      this.product.add(this.beads, new LineSegments(this.geometry, this.materials.line));
      return;
    }
    this.geometry.setAttribute("color", colours);
    this.geometry.setIndex(Array.from(model.triangle));
    this.geometry.setAttribute("normal", new BufferAttribute(new Float32Array(3 * model.vertices), 3));
    this.product.add(new Mesh(this.geometry, litMaterial(theme, 0xffffff, { vertexColors: true })));
    const rest = new BufferGeometry();
    rest.setAttribute("position", new BufferAttribute(new Float32Array(model.vertex_m), 3));
    rest.setIndex(Array.from(model.triangle));
    rest.computeVertexNormals();
    this.ghost = new Mesh(rest, this.materials.ghost);
    this.product.add(this.ghost);
  }

  addSurroundings() {
    const { model, materials, scene } = this;
    const { extent } = model;
    this.palm = new Group();
    scene.add(this.palm);
    this.pads = model.pads.map((surface) => ({ surface, ...makePad(surface, extent, materials) }));
    for (const pad of this.pads) this.palm.add(pad.holder);
    if (this.pads.length) {
      const palm = makePalm(model.pads, this.pads.map((pad) => pad.top), extent, materials);
      if (palm) this.palm.add(palm.group);
      this.flangeTop = palm?.flangeTop ?? 0.5 * extent;
    }
    const room = model.armRoom;
    if (room) {
      this.arm = new ArmBody(model.armPlaces, room.radius, extent, materials);
      scene.add(this.arm.group);
    }
    if (model.support) {
      this.floor = makeFloor(extent, Math.max(FLOOR_EXTENTS * extent, 1.6 * (room?.radius ?? 0)), materials);
      this.shadow = makeShadow(extent);
      scene.add(this.floor.group, this.shadow);
      const target = model.target_m;
      if (target && Math.abs(target[2]) > 1e-6) {
        this.target = makeTarget(extent, target[2], materials);
        this.target.position.set(...target);
        scene.add(this.target);
      }
    }
    this.listed = model.listed.map((surface) => ({ surface, face: makeListed(surface, extent, materials) }));
    for (const { face } of this.listed) scene.add(face);
  }

  /** @param look { scale, field, most, arrows, ghost } */
  update(time, look) {
    const { model } = this;
    const place = model.at(time);
    this.place = place;
    model.deformed(place, this.deformed);
    this.attitude = quaternion(model.rotation(model.attitude, place));
    this.centre = new Vector3(...model.rowAt(model.product_m, 3, place));
    this.product.position.copy(this.centre);
    this.product.quaternion.copy(this.attitude);
    const places = this.geometry.getAttribute("position");
    for (let i = 0; i < places.array.length; i += 1) places.array[i] = model.vertex_m[i] + look.scale * this.deformed[i];
    places.needsUpdate = true;
    this.colour(look);
    if (this.ghost) this.ghost.visible = look.ghost;
    this.movePads(look.scale);
    this.moveArm();
    this.moveFloor();
    this.moveListed();
    this.moveArrows(look);
  }

  colour(look) {
    const { model, geometry } = this;
    if (this.beads) {
      const matrix = new Matrix4();
      const at = geometry.getAttribute("position").array;
      for (let v = 0; v < model.vertices; v += 1) this.beads.setMatrixAt(v, matrix.makeTranslation(at[3 * v], at[3 * v + 1], at[3 * v + 2]));
      this.beads.instanceMatrix.needsUpdate = true;
      return;
    }
    const normals = geometry.getAttribute("normal");
    addNormals(geometry.getAttribute("position").array, model.triangle, normals.array);
    normals.needsUpdate = true;
    model.field(look.field, this.place, this.deformed, this.values);
    const colours = geometry.getAttribute("color");
    const factor = look.most > 0 ? COLOUR_STEPS / look.most : 0;
    for (let v = 0; v < model.vertices; v += 1) {
      const at = 3 * Math.min(COLOUR_STEPS - 1, Math.max(0, Math.floor(this.values[v] * factor)));
      for (let i = 0; i < 3; i += 1) colours.array[3 * v + i] = colourTable[at + i];
    }
    colours.needsUpdate = true;
  }

  /** How far a face that looks along `normal` at `place` has to move for it to touch the surface as it is drawn. */
  shiftAt(place, normal, scale) {
    if (scale === 1 || this.beads) return 0;
    const { model } = this;
    const n = normal.clone().applyQuaternion(this.attitude.clone().invert());
    let [nearest, drawn] = [Infinity, Infinity];
    for (let i = 0; i < 3 * model.vertices; i += 3) {
      const rest = n.x * model.vertex_m[i] + n.y * model.vertex_m[i + 1] + n.z * model.vertex_m[i + 2];
      const moved = n.x * this.deformed[i] + n.y * this.deformed[i + 1] + n.z * this.deformed[i + 2];
      nearest = Math.min(nearest, rest + moved);
      drawn = Math.min(drawn, rest + scale * moved);
    }
    const gap = this.centre.dot(normal) + nearest - place.dot(normal);
    const near = Math.max(0, 1 - Math.max(0, gap) / (NEAR_PART * model.extent));
    return near * (drawn - nearest);
  }

  movePads(scale) {
    const { model, place } = this;
    const palm = quaternion(model.rotation(model.palm_attitude, place));
    this.middle = new Vector3(...model.rowAt(model.palm_m, 3, place)).add(new Vector3(...model.grip_m));
    this.palm.position.copy(this.middle);
    this.palm.quaternion.copy(palm);
    const ways = model.rowAt(model.finger_way_m, this.pads.length, place);
    this.pads.forEach(({ surface, holder }, i) => {
      const normal = new Vector3(...surface.axes[2]);
      const at = new Vector3(...surface.origin).addScaledVector(normal, ways[i]);
      const inCell = at.clone().applyQuaternion(palm).add(this.middle);
      holder.position.copy(at).addScaledVector(normal, this.shiftAt(inCell, normal.clone().applyQuaternion(palm), scale));
    });
  }

  moveArm() {
    if (!this.arm) return;
    const { model, place, middle } = this;
    const from = model.rowAt(model.arm_m, 3 * model.armPlaces, place);
    const points = Array.from({ length: model.armPlaces }, (_, i) => new Vector3(from[3 * i], from[3 * i + 1], from[3 * i + 2]).add(middle));
    points.push(new Vector3(0, 0, this.flangeTop).applyQuaternion(this.palm.quaternion).add(middle));
    this.arm.set(points);
  }

  moveFloor() {
    if (!this.floor) return;
    const { model, place, centre } = this;
    const [x, y] = model.rowAt(model.support_m, 3, place);
    const height = this.standsOnTarget() ? model.target_m[2] : 0;
    // The floor goes with what is looked at; its lines stay where they are, or go with the belt.
    const { group, grid, spacing } = this.floor;
    group.position.set(centre.x, centre.y, -0.001 * model.extent);
    const along = (way, moved) => ((((moved - way) % spacing) + spacing) % spacing) - 0.5 * spacing;
    grid.position.x = along(centre.x, model.belt ? x : 0);
    grid.position.y = along(centre.y, model.belt ? y : 0);
    const above = Math.max(0, centre.z + model.lowest - height);
    this.shadow.position.set(centre.x, centre.y, height + 0.004 * model.extent);
    this.shadow.material.uniforms.opacity.value = 0.3 / (1 + (2.2 * above) / model.extent);
    this.shadow.scale.setScalar(0.9 + (0.5 * above) / model.extent);
  }

  standsOnTarget() {
    const { target_m: target, extent } = this.model;
    return this.target && Math.hypot(this.centre.x - target[0], this.centre.y - target[1]) < 1.5 * extent;
  }

  moveListed() {
    const { model, place } = this;
    const moved = model.rowAt(model.listed_m, 3 * this.listed.length, place);
    this.listed.forEach(({ surface, face }, i) => {
      // Listed places are measured from under the product's middle at the start.
      face.position.set(...surface.origin.map((each, axis) => each + moved[3 * i + axis]));
    });
  }

  moveArrows(look) {
    const { model, place } = this;
    const forces = model.rowAt(model.force_N, 3 * model.surfaces.length, place);
    const places = model.rowAt(model.force_place_m, 3 * model.surfaces.length, { frame: place.part > 0.5 ? place.frame + 1 : place.frame, part: 0 });
    for (const { arrow, s } of this.arrows) {
      const force = new Vector3(forces[3 * s], forces[3 * s + 1], forces[3 * s + 2]);
      const size = force.length();
      const length = look.arrows && look.strongest > 0 ? (1.1 * model.extent * size) / look.strongest : 0;
      arrow.set(new Vector3(places[3 * s], places[3 * s + 1], places[3 * s + 2]), force.divideScalar(size || 1), length);
    }
  }

  dispose() {
    this.scene.traverse((object) => {
      object.geometry?.dispose();
      object.material?.dispose();
    });
  }
}

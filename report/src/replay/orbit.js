// A camera that turns around what is looked at: by dragging, by wheel or two fingers, by keys.

const VIEWS = { angled: [-0.98, 0.27], front: [-Math.PI / 2, 0.02], side: [0, 0.02], top: [-Math.PI / 2, 1.55] };
/** Of the whole arm, where there is one. */
const ARM_VIEW = "arm";
const ARM_ANGLES = [-0.75, 0.35];
const MOST_UP = 1.55;
const TURN = 0.0075;

export class Orbit {
  /** @param element which is dragged; null: none is @param withArm is there an arm to be seen? */
  constructor(element, changed, withArm) {
    this.changed = changed;
    this.views = withArm ? [...Object.keys(VIEWS), ARM_VIEW] : Object.keys(VIEWS);
    this.reset();
    if (element) this.follow(element);
  }

  follow(element) {
    const pointers = new Map();
    let spread = 0;
    element.addEventListener("pointerdown", (event) => {
      if (event.button > 0) return;
      pointers.set(event.pointerId, [event.clientX, event.clientY]);
      element.setPointerCapture(event.pointerId);
      spread = 0;
    });
    element.addEventListener("pointermove", (event) => {
      const before = pointers.get(event.pointerId);
      if (!before) return;
      pointers.set(event.pointerId, [event.clientX, event.clientY]);
      if (pointers.size === 2) {
        const [a, b] = [...pointers.values()];
        const now = Math.hypot(a[0] - b[0], a[1] - b[1]);
        if (spread > 0) this.zoom(spread / now);
        spread = now;
      } else this.turn(-(event.clientX - before[0]) * TURN, (event.clientY - before[1]) * TURN);
    });
    for (const name of ["pointerup", "pointercancel"]) element.addEventListener(name, (event) => pointers.delete(event.pointerId));
    // The wheel scrolls the page; with Ctrl, as two fingers on a pad send it, it comes nearer.
    element.addEventListener("wheel", (event) => {
      if (!event.ctrlKey) return;
      event.preventDefault();
      this.zoom(Math.exp(0.004 * event.deltaY));
    }, { passive: false });
  }

  reset() {
    [this.azimuth, this.elevation] = VIEWS.angled;
    this.near = 1;
    this.wide = false;
    this.changed();
  }

  view(name) {
    // Coming from the other kind of view, what was nearer there is not meant here.
    if (this.wide !== (name === ARM_VIEW)) this.near = 1;
    this.wide = name === ARM_VIEW;
    [this.azimuth, this.elevation] = this.wide ? ARM_ANGLES : VIEWS[name];
    this.changed();
  }

  turn(azimuth, elevation) {
    this.azimuth += azimuth;
    this.elevation = Math.min(MOST_UP, Math.max(-0.3, this.elevation + elevation));
    this.changed();
  }

  zoom(factor) {
    this.near = Math.min(6, Math.max(0.15, this.near * factor));
    this.changed();
  }

  /** Where a camera stands from its target at this distance. */
  offset(distance) {
    const level = Math.cos(this.elevation) * distance * this.near;
    return [Math.cos(this.azimuth) * level, Math.sin(this.azimuth) * level, Math.sin(this.elevation) * distance * this.near];
  }
}

// The one time of the page: scenes, charts, panel and sound follow it.

export const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1, 2];
const REST_S = 1.2;

export class Clock {
  constructor(end, time = 0) {
    this.end = end;
    this.time = time;
    this.speed = 0.5;
    this.playing = false;
    this.listeners = new Set();
  }

  /** Calls back with (clock, from): `from` is the time before, null after a jump. */
  on(listener) {
    this.listeners.add(listener);
    listener(this, null);
  }

  tell(from) {
    for (const listener of this.listeners) listener(this, from);
  }

  jump(time) {
    this.time = Math.min(this.end, Math.max(0, time));
    this.rest = 0;
    this.tell(null);
  }

  setSpeed(speed) {
    this.speed = speed;
    this.tell(this.time);
  }

  play() {
    if (this.playing) return;
    this.playing = true;
    this.rest = 0;
    if (this.time >= this.end) this.jump(0);
    let last = performance.now();
    const tick = (now) => {
      if (!this.playing) return;
      const passed = Math.min(0.1, (now - last) / 1000);
      last = now;
      this.advance(passed);
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
    this.tell(this.time);
  }

  /** At the end it rests, then begins again. */
  advance(passed) {
    if (this.time >= this.end) {
      this.rest += passed;
      if (this.rest > REST_S) this.jump(0);
      return;
    }
    const from = this.time;
    this.time = Math.min(this.end, this.time + passed * this.speed);
    this.tell(from);
  }

  pause() {
    this.playing = false;
    this.tell(this.time);
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }
}

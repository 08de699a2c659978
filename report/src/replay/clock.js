// The one time of the page: scenes, charts, panel and sound follow it.

export const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1, 2];
const REST_S = 1.2;
const SELDOM_MS = 100;

/**
 * What the time of a replay is taken from, in s: here the browser's own clock. begin (clock): it plays from its time on, returns when
 * that is; now (): how far it has come; end (): it plays no longer; most: so much passes at once where pictures come late.
 */
export const wallPace = { begin: () => performance.now() / 1000, now: () => performance.now() / 1000, end: () => {}, most: 0.1 };

export class Clock {
  constructor(end, time = 0) {
    this.end = end;
    this.time = time;
    this.speed = 0.5;
    this.playing = false;
    this.rest = 0;
    this.pace = wallPace;
    this.listeners = new Set();
  }

  /** Calls back with (clock, from): `from` is the time before, null after a jump. */
  on(listener) {
    this.listeners.add(listener);
    listener(this, null);
  }

  /** The same, while it plays ten times a second: digits that change more often than anybody reads them cost time. */
  onSeldom(listener) {
    let told = 0;
    this.on((clock, from) => {
      const now = performance.now();
      if (from !== null && clock.playing && now - told < SELDOM_MS) return;
      told = now;
      listener(clock);
    });
  }

  tell(from) {
    for (const listener of this.listeners) listener(this, from);
  }

  /** What is heard or timed elsewhere begins anew from the time shown. */
  restart() {
    if (this.playing) this.reached = this.pace.begin(this);
  }

  jump(time) {
    this.time = Math.min(this.end, Math.max(0, time));
    this.rest = 0;
    this.restart();
    this.tell(null);
  }

  setSpeed(speed) {
    this.speed = speed;
    this.restart();
    this.tell(this.time);
  }

  setPace(pace) {
    if (pace === this.pace) return;
    this.pace.end();
    this.pace = pace;
    this.restart();
  }

  play() {
    if (this.playing) return;
    if (this.time >= this.end) this.jump(0);
    this.playing = true;
    this.rest = 0;
    this.restart();
    const tick = () => {
      const now = this.pace.now();
      const passed = Math.max(0, Math.min(this.pace.most, now - this.reached));
      this.reached = Math.max(this.reached, now);
      this.advance(passed);
      if (this.playing) this.frame = requestAnimationFrame(tick);
    };
    this.frame = requestAnimationFrame(tick);
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
    cancelAnimationFrame(this.frame);
    this.pace.end();
    this.tell(this.time);
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }
}

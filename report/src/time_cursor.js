// A line through a chart over time, at the time of the clock; a press in the chart sets it.

import { h } from "./dom.js";

/** @param chart as `figure` gives it */
export function followClock({ element, chart }, clock) {
  const canvas = element.querySelector(".chart");
  const cursor = h("div", { class: "time-cursor", "aria-hidden": "true" });
  element.classList.add("timed");
  element.append(cursor);
  let seen = false;
  const move = () => {
    if (!seen) return;
    const at = chart()?.convertToPixel({ xAxisIndex: 0 }, clock.time);
    cursor.hidden = !(at >= 0);
    if (!cursor.hidden) cursor.style.transform = `translateX(${at}px)`;
  };
  // Where the chart stands is asked when that changes: asked at every picture it would lay out the page each time.
  const fit = () => {
    cursor.style.top = `${canvas.offsetTop}px`;
    cursor.style.height = `${canvas.clientHeight}px`;
    move();
  };
  new ResizeObserver(fit).observe(element);
  new ResizeObserver(fit).observe(canvas);
  new IntersectionObserver(([entry]) => { seen = entry.isIntersecting; fit(); }).observe(canvas);
  clock.on(move);
  const set = (event) => {
    const box = canvas.getBoundingClientRect();
    const time = chart()?.convertFromPixel({ xAxisIndex: 0 }, event.clientX - box.left);
    if (!Number.isFinite(time)) return;
    clock.pause();
    clock.jump(time);
  };
  canvas.addEventListener("pointerdown", (event) => { if (event.pointerType === "mouse" && event.button === 0 && !event.shiftKey) set(event); });
  canvas.addEventListener("click", set);
  return element;
}

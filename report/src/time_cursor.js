// A line through a chart over time, at the time of the clock; a press in the chart sets it.

import { h } from "./dom.js";

/** @param chart as `figure` gives it */
export function followClock({ element, chart }, clock) {
  const canvas = element.querySelector(".chart");
  const cursor = h("div", { class: "time-cursor", "aria-hidden": "true" });
  element.classList.add("timed");
  element.append(cursor);
  clock.on(() => {
    const at = chart()?.convertToPixel({ xAxisIndex: 0 }, clock.time);
    cursor.hidden = !(at >= 0) || at > canvas.clientWidth;
    if (cursor.hidden) return;
    cursor.style.transform = `translateX(${at}px)`;
    cursor.style.top = `${canvas.offsetTop}px`;
    cursor.style.height = `${canvas.clientHeight}px`;
  });
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

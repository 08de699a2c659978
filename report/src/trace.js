// One scenario over time: a strip per signal, one time axis for all, the phases of the cycle behind them.

import { axis, figure } from "./chart.js";
import { h } from "./dom.js";
import { legend } from "./legend.js";
import { tip, tipLine } from "./scenario.js";
import { fingerForces } from "./replay/panel.js";
import { outcomeColour } from "./theme.js";
import { phasesOf, strips } from "./trace_strips.js";
import { number, plural, quantity, scaleFor, thousands } from "./words.js";

const STRIP = 138;
const TOP = 26;
const SHORT = 4;

function rowAt({ time }, wanted) {
  let low = 0;
  let high = time.rows - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (time.at(middle) < wanted) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Colours go by finger or by place in the strip; what is not the first kind of a finger's curves is dashed. */
function lineStyle(theme, curve, index) {
  const finger = /^finger (\d)/.exec(curve.name);
  const colour = theme.series[finger ? Number(finger[1]) - 1 : index % theme.series.length];
  return { width: 1.7, color: colour, type: curve.name.endsWith("friction") ? [5, 3] : "solid" };
}

/** Every second phase is shaded; the first strip carries the names, or their numbers where they do not fit. */
function phaseSeries(theme, phases, count) {
  const shade = (strip) => ({
    type: "line", xAxisIndex: strip, yAxisIndex: strip, data: [], silent: true,
    markArea: { silent: true, itemStyle: { color: theme.ink, opacity: 0.055 }, data: phases.filter((_, i) => i % 2 === 1).map((phase) => [{ xAxis: phase.from }, { xAxis: phase.to }]) },
  });
  const names = {
    type: "custom", xAxisIndex: 0, yAxisIndex: 0, silent: true, clip: false, data: phases.map((phase, i) => [phase.from, i]),
    renderItem: (params, api) => {
      const i = api.value(1);
      const [left, right] = [phases[i].from, phases[i].to].map((time) => api.coord([time, 0])[0]);
      const width = right - left;
      const fits = width > 6.6 * phases[i].name.length + SHORT;
      const text = fits ? phases[i].name : width > 10 ? String(i + 1) : "";
      return { type: "text", style: { x: (left + right) / 2, y: params.coordSys.y - 64, text, align: "center", verticalAlign: "middle", fill: theme.ink, font: `12px ${theme.font}` } };
    },
  };
  return phases.length ? [...Array.from({ length: count }, (_, strip) => shade(strip)), names] : [];
}

function limitLine(theme, strip, index) {
  if (!isLimitShown(strip)) return [];
  return [{
    type: "line", xAxisIndex: index, yAxisIndex: index, data: [], silent: true,
    markLine: { silent: true, symbol: "none", precision: 15, lineStyle: { color: theme.bad, width: 1.5, type: "dashed" }, label: { formatter: `limit ${quantity(strip.limit, strip.units)}`, position: "insideEndTop", color: theme.bad, fontSize: 12, fontWeight: 600 }, data: [{ yAxis: strip.limit }] },
  }];
}

function timeAxis(theme, trace, index, last) {
  return {
    type: "value", gridIndex: index, min: trace.time.at(0), max: trace.time.at(trace.time.rows - 1),
    axisLine: { lineStyle: { color: theme.line } }, axisTick: { show: false }, splitLine: { show: false },
    name: last ? "time (s)" : "", nameLocation: "middle", nameGap: 26, nameTextStyle: { color: theme.soft, fontSize: 13 },
    axisLabel: { show: last, color: theme.soft, fontSize: 12, hideOverlap: true, showMaxLabel: false, formatter: (value) => number(value, 4) },
  };
}

function valueAxis(theme, strip, index, left) {
  const scale = scaleFor(strip.units, Math.max(...strip.range.map(Math.abs)));
  return {
    type: "value", gridIndex: index, min: strip.range[0] < 0 ? undefined : 0, max: isLimitShown(strip) ? strip.range[1] : undefined,
    name: `${strip.title}${scale.unit ? ` (${scale.unit})` : ""}`,
    nameTextStyle: { color: theme.ink, align: "left", fontSize: 13, fontWeight: 600, padding: [0, 0, 0, 4 - left] }, nameGap: 28, splitNumber: 2,
    axisTick: { show: false }, axisLine: { show: false }, splitLine: { lineStyle: { color: theme.line, opacity: 0.7 } },
    axisLabel: { color: theme.soft, fontSize: 11, showMaxLabel: !isLimitShown(strip), formatter: (value) => number(value / scale.factor, 3) },
  };
}

function isLimitShown(strip) {
  return strip.limit !== null && strip.limit <= strip.range[1];
}

/** Each strip names its curves in its own line, so that nothing is left to guess on a phone. */
function stripLegend(theme, strip, index, left, narrow) {
  return {
    show: strip.curves.length > 1, left: narrow ? 2 : left, top: TOP + index * STRIP + 25, itemWidth: 14, itemHeight: 8, itemGap: 9, padding: 0, itemStyle: { opacity: 0 }, selectedMode: false,
    textStyle: { color: theme.soft, fontSize: 12 }, data: strip.curves.map((curve) => `${strip.name}: ${curve.name}`), formatter: (name) => name.slice(strip.name.length + 2).replace("finger ", narrow && strip.curves.length > 2 ? "" : "finger "),
  };
}

function option(study, shown, phases, theme, width) {
  const { trace } = study;
  const [left, right] = [52, 10];
  const times = Array.from({ length: trace.time.rows }, (_, row) => trace.time.at(row));
  const phaseAt = (time) => phases.find((phase) => time >= phase.from && time <= phase.to)?.name ?? "";
  return {
    grid: shown.map((_, i) => ({ left, right, top: TOP + 48 + i * STRIP, height: STRIP - 68 })),
    axisPointer: { link: [{ xAxisIndex: "all" }], lineStyle: { color: theme.soft }, label: { show: false } },
    dataZoom: [{ type: "inside", xAxisIndex: shown.map((_, i) => i), zoomOnMouseWheel: "ctrl", moveOnMouseWheel: false, moveOnMouseMove: "shift", preventDefaultMouseMove: false }],
    xAxis: shown.map((_, i) => timeAxis(theme, trace, i, i === shown.length - 1)),
    yAxis: shown.map((strip, i) => valueAxis(theme, strip, i, left)),
    legend: shown.map((strip, i) => stripLegend(theme, strip, i, left, width < 560)),
    tooltip: {
      trigger: "axis",
      formatter: (items) => {
        const row = rowAt(trace, items[0].value[0]);
        const lines = shown.flatMap((strip) => strip.curves.map((curve) => tipLine(`${strip.title}${curve.name ? `: ${curve.name}` : ""}`, quantity(curve.at(row), strip.units, 3, Math.max(...strip.range.map(Math.abs))))));
        return tip(h("div", { class: "tip-head" }, h("b", {}, quantity(trace.time.at(row), "s")), h("span", {}, phaseAt(trace.time.at(row)))), lines);
      },
    },
    series: [
      ...phaseSeries(theme, phases, shown.length),
      ...shown.flatMap((strip, i) => [
        ...strip.curves.map((curve, k) => {
          const style = lineStyle(theme, curve, k);
          return { type: "line", name: `${strip.name}: ${curve.name}`, xAxisIndex: i, yAxisIndex: i, symbol: "none", lineStyle: style, itemStyle: { color: style.color }, data: times.map((time, row) => [time, curve.at(row)]) };
        }),
        ...limitLine(theme, strip, i),
      ]),
    ],
  };
}

/** The phases as words, for whoever cannot see the shading, and where a name does not fit it. */
function phaseList(phases) {
  if (phases.length === 0) return null;
  return h("ol", { class: "phases", "aria-label": "Phases of the cycle" }, phases.map((phase) => h("li", {}, h("b", {}, phase.name), ` ${number(phase.from, 3)} to ${number(phase.to, 3)} s`)));
}

function outcomeEvent(study) {
  const time = study.row === null ? null : study.scenarios.at("outcome_time_s", study.row ?? 0);
  return time === null ? "" : `The outcome was decided at ${quantity(time, "s")}. `;
}

/** A line through all strips at the time of the clock; a press in the chart sets it. */
function followClock({ element, chart }, clock) {
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

export function timeCharts(study, clock = null) {
  const { trace } = study;
  if (!trace) return null;
  const shown = strips(study);
  if (shown.length === 0) return null;
  const phases = phasesOf(study);
  const limited = shown.some(isLimitShown);
  const chart = figure({
    height: TOP + 34 + STRIP * shown.length,
    legend: (theme) => (limited ? legend([[theme.bad, "limit", "dashed"]]) : null),
    option: (theme, width) => option(study, shown, phases, theme, width),
    describe: () => `${plural(shown.length, "signal")} over ${quantity(trace.time.at(trace.time.rows - 1), "s")}: ${shown.map((strip) => strip.title).join(", ")}. Phases: ${phases.map((phase) => `${phase.name} until ${number(phase.to, 3)} s`).join(", ")}.`,
    below: phaseList(phases),
    note: `${outcomeEvent(study)}${thousands(trace.rows)} time steps${trace.thinned ? ", drawn as the least and greatest value of neighbouring steps" : ""}${trace.events ? `, ${plural(trace.events, "contact event")}` : ""}. ${clock ? "A click sets the time of the scene. " : ""}Ctrl and the wheel zoom, Shift and a drag move.${clock ? "" : " The motion of every particle is in the results file."}`,
  });
  return clock ? followClock(chart, clock) : chart.element;
}

export function traceCurves(study) {
  return timeCharts(study, study.clock);
}

/** How hard the fingers press in two scenarios at the same time, and the difference. */
export function differenceOfForces(models, clock) {
  const forces = models.map(fingerForces);
  if (forces.some(({ at }) => at.length === 0)) return null;
  const count = 500;
  const times = Array.from({ length: count + 1 }, (_, i) => (clock.end * i) / count);
  const mean = ({ at }, t, end) => (t > end ? null : at.reduce((sum, read) => sum + read(t), 0) / at.length);
  const values = times.map((t) => models.map((model, i) => mean(forces[i], t, model.end)));
  const chart = figure({
    height: 230,
    legend: (theme) => legend([...models.map((model) => [outcomeColour(model.outcome), model.title, "line"]), [theme.ink, "difference, second less first", "dashed"]]),
    describe: () => `Mean force of the fingers of ${models.map((model) => model.title).join(" and ")} over ${quantity(clock.end, "s")}, and their difference.`,
    option: (theme) => ({
      grid: { left: 52, right: 10, top: 34, bottom: 40 },
      xAxis: axis(theme, { name: "time", units: "s", most: clock.end, min: 0, max: clock.end, lines: false }),
      yAxis: { ...axis(theme, { name: "mean force of a finger", units: "N", most: 1, vertical: true }) },
      tooltip: { trigger: "axis", formatter: (items) => tip(h("div", { class: "tip-head" }, h("b", {}, quantity(items[0].value[0], "s"))), items.map((item) => tipLine(item.seriesName, quantity(item.value[1], "N", 3)))) },
      series: [
        ...models.map((model, i) => ({ type: "line", name: model.title, symbol: "none", lineStyle: { width: 1.8, color: outcomeColour(model.outcome) }, itemStyle: { color: outcomeColour(model.outcome) }, data: times.map((t, k) => [t, values[k][i]]) })),
        { type: "line", name: "difference", symbol: "none", lineStyle: { width: 1.4, color: theme.ink, type: "dashed" }, itemStyle: { color: theme.ink }, data: times.map((t, k) => [t, values[k].some((each) => each === null) ? null : values[k][1] - values[k][0]]) },
      ],
    }),
  });
  return followClock(chart, clock);
}

// One scenario over time: a strip per signal, one time axis for all.

import { figure } from "./chart.js";
import { tip, tipLine } from "./scenario.js";
import { h } from "./dom.js";
import { extent } from "./statistics.js";
import { label, number, plural, quantity, scaleFor, thousands } from "./words.js";

const ORDER = ["finger_force_N", "support_force_N", "palm_position_m", "finger_way_m", "contact_count", "sliding_count", "plastic_strain_max", "stored_energy_J"];
const STRIP = 132;

/** Signals that move, the telling ones first; of a force only the components that are there. */
function strips(trace) {
  const found = trace.signals
    .map((signal) => ({ ...signal, curves: signal.curves.filter((curve) => curve.varies) }))
    .filter((signal) => signal.curves.length > 0);
  const place = (signal) => (ORDER.includes(signal.name) ? ORDER.indexOf(signal.name) : ORDER.length);
  return found.sort((a, b) => place(a) - place(b)).slice(0, 8);
}

function at(trace, time) {
  const { time: column } = trace;
  let low = 0;
  let high = column.rows - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (column.at(middle) < time) low = middle + 1;
    else high = middle;
  }
  return low;
}

function option(trace, shown, theme, width) {
  const narrow = width < 560;
  const [left, right] = [narrow ? 48 : 60, narrow ? 8 : 150];
  const times = Array.from({ length: trace.time.rows }, (_, row) => trace.time.at(row));
  // x, y and z keep their colours in every strip; the second finger is dashed.
  const colour = (curve, index) => theme.series[/\b[xyz]$/.test(curve.name) ? "xyz".indexOf(curve.name.slice(-1)) : index % theme.series.length];
  const dash = (curve) => (curve.name.startsWith("finger 2") ? [5, 3] : "solid");
  return {
    grid: shown.map((_, i) => ({ left, right, top: 26 + i * STRIP, height: STRIP - 44 })),
    axisPointer: { link: [{ xAxisIndex: "all" }], lineStyle: { color: theme.soft }, label: { show: false } },
    dataZoom: [{ type: "inside", xAxisIndex: shown.map((_, i) => i), zoomOnMouseWheel: "ctrl", moveOnMouseWheel: false, moveOnMouseMove: "shift", preventDefaultMouseMove: false }],
    xAxis: shown.map((_, i) => ({
      type: "value",
      gridIndex: i,
      min: times[0],
      max: times[times.length - 1],
      axisLine: { lineStyle: { color: theme.line } },
      axisTick: { show: false },
      splitLine: { show: false },
      name: i === shown.length - 1 ? "time (s)" : "",
      nameLocation: "middle",
      nameGap: 26,
      nameTextStyle: { color: theme.soft, fontSize: 13 },
      axisLabel: { show: i === shown.length - 1, color: theme.soft, fontSize: 12, hideOverlap: true, showMaxLabel: false, formatter: (value) => number(value, 4) },
    })),
    yAxis: shown.map((signal, i) => {
      const range = extent(signal.curves.flatMap((curve) => curve.numbers()));
      const scale = scaleFor(signal.units, Math.max(...range.map(Math.abs)));
      return {
        type: "value",
        gridIndex: i,
        name: `${label(signal.name)}${scale.unit ? ` (${scale.unit})` : ""}`,
        nameTextStyle: { color: theme.ink, align: "left", fontSize: 13, padding: [0, 0, 0, -left + 4] },
        nameGap: 9,
        splitNumber: 2,
        axisTick: { show: false },
        axisLabel: { color: theme.soft, fontSize: 11, formatter: (value) => number(value / scale.factor, 3) },
        splitLine: { lineStyle: { color: theme.line, opacity: 0.7 } },
        axisLine: { show: false },
      };
    }),
    legend: narrow
      ? []
      : shown.map((signal, i) => ({
          show: signal.curves.length > 1,
          orient: "vertical",
          left: width - right + 14,
          top: 22 + i * STRIP,
          itemWidth: 22,
          itemHeight: 8,
          itemGap: 3,
          selectedMode: false,
          textStyle: { color: theme.soft, fontSize: 12 },
          data: signal.curves.map((curve) => `${signal.name}: ${curve.name}`),
          formatter: (name) => name.slice(signal.name.length + 2),
        })),
    tooltip: {
      trigger: "axis",
      formatter: (items) => {
        const row = at(trace, items[0].value[0]);
        return tip(
          h("div", { class: "tip-head" }, h("b", {}, quantity(trace.time.at(row), "s"))),
          shown.flatMap((signal) => signal.curves.map((curve) => tipLine(`${label(signal.name)}${curve.name ? `, ${curve.name}` : ""}`, quantity(curve.at(row), signal.units, 3)))),
        );
      },
    },
    series: shown.flatMap((signal, i) =>
      signal.curves.map((curve, k) => ({
        type: "line",
        name: `${signal.name}: ${curve.name}`,
        xAxisIndex: i,
        yAxisIndex: i,
        symbol: "none",
        lineStyle: { width: 1.6, color: colour(curve, k), type: dash(curve) },
        itemStyle: { color: colour(curve, k) },
        data: times.map((time, row) => [time, curve.at(row)]),
      })),
    ),
  };
}

export function traceCurves(study) {
  const { trace } = study;
  if (!trace) return null;
  const shown = strips(trace);
  if (shown.length === 0) return null;
  return figure({
    height: 40 + STRIP * shown.length,
    option: (theme, width) => option(trace, shown, theme, width),
    describe: () => `${plural(shown.length, "signal")} over ${quantity(trace.time.at(trace.time.rows - 1), "s")}: ${shown.map((signal) => label(signal.name)).join(", ")}.`,
    note: `${thousands(trace.rows)} time steps${trace.thinned ? ", drawn as the least and greatest value of neighbouring steps" : ""}${trace.events ? `, ${plural(trace.events, "contact event")}` : ""}. Ctrl and the wheel zoom, Shift and a drag move. The motion of every particle is in the results file.`,
  }).element;
}

// What the contacts of one scenario did, and when: a strip for each surface and each kind of event.

import { figure } from "./chart.js";
import { h } from "./dom.js";
import { surfaceWords } from "./replay/events.js";
import { tip, tipLine } from "./scenario.js";
import { followClock } from "./time_cursor.js";
import { listed, number, plural, quantity, thousands } from "./words.js";

const KINDS = { make: "touching", break: "letting go", slip: "beginning to slide", stick: "sticking" };
const ROW = 36;
const [LEFT, RIGHT, TOP, BOTTOM] = [52, 10, 6, 40];

/** Rows of the chart: { surface, kind, name, times }. */
function stripsOf(contacts) {
  const found = new Map();
  for (let row = 0; row < contacts.rows; row += 1) {
    const [surface, kind] = [contacts.at("surface", row), contacts.at("kind", row)];
    const key = `${surface} ${kind}`;
    if (!found.has(key)) found.set(key, { surface, kind, name: `${surfaceWords(surface)}: ${KINDS[kind] ?? kind}`, times: [] });
    found.get(key).times.push(contacts.at("time_s", row));
  }
  const kinds = Object.keys(KINDS);
  const surfaces = contacts.column("surface").distinct;
  return [...found.values()].sort((a, b) => surfaces.indexOf(a.surface) - surfaces.indexOf(b.surface) || kinds.indexOf(a.kind) - kinds.indexOf(b.kind));
}

function optionOf(theme, trace, strips) {
  const colour = (surface) => theme.series[[...new Set(strips.map((strip) => strip.surface))].indexOf(surface) % theme.series.length];
  return {
    grid: { left: LEFT, right: RIGHT, top: TOP, bottom: BOTTOM },
    xAxis: { type: "value", min: trace.time.at(0), max: trace.time.at(trace.time.rows - 1), name: "time (s)", nameLocation: "middle", nameGap: 24, nameTextStyle: { color: theme.soft, fontSize: 13 }, axisLine: { lineStyle: { color: theme.line } }, axisTick: { show: false }, splitLine: { show: false }, axisLabel: { color: theme.soft, fontSize: 12, hideOverlap: true, showMaxLabel: false, formatter: (value) => number(value, 4) } },
    yAxis: { type: "value", min: 0, max: strips.length, inverse: true, interval: 1, axisLabel: { show: false }, axisTick: { show: false }, axisLine: { show: false }, splitLine: { lineStyle: { color: theme.line, opacity: 0.7 } } },
    tooltip: { trigger: "item", formatter: ({ value, seriesIndex }) => tip(h("div", { class: "tip-head" }, h("b", {}, strips[seriesIndex].name)), tipLine("at", quantity(value[0], "s"))) },
    series: strips.map((strip, i) => ({
      type: "scatter", name: strip.name, symbol: "rect", symbolSize: [1.6, 13], itemStyle: { color: colour(strip.surface), opacity: 0.75 }, data: strip.times.map((time) => [time, i + 0.7]),
    })).concat({
      type: "custom", silent: true, z: 6, data: strips.map((_, i) => [trace.time.at(0), i]),
      renderItem: (params, api) => {
        const [x, y] = api.coord([api.value(0), api.value(1)]);
        const strip = strips[api.value(1)];
        return { type: "text", style: { text: `${strip.name}, ${thousands(strip.times.length)}`, x: x + 2, y: y + 3, align: "left", verticalAlign: "top", fill: theme.soft, font: `12px ${theme.font}` } };
      },
    }),
  };
}

export function contactEvents({ trace, name }, clock = null) {
  const { contacts } = trace;
  if (!contacts || contacts.rows === 0) return null;
  const strips = stripsOf(contacts);
  const chart = figure({
    height: TOP + BOTTOM + ROW * strips.length,
    name: `${name} contact events`,
    csv: () => [["time_s", "surface", "kind"], ...Array.from({ length: contacts.rows }, (_, row) => ["time_s", "surface", "kind"].map((each) => contacts.at(each, row)))],
    option: (theme) => optionOf(theme, trace, strips),
    describe: () => `Contact events over time: ${listed(strips.map((strip) => `${strip.name} ${plural(strip.times.length, "time")}`))}.`,
    note: `A stroke for each place of the product that met a surface, parted from it, or changed between sticking and sliding.${contacts.rows < trace.events ? ` ${thousands(contacts.rows)} of ${thousands(trace.events)} events are drawn, evenly picked; all are in the results.` : ""}`,
  });
  return h("div", {}, h("h3", {}, "Contact events"), clock ? followClock(chart, clock) : chart.element);
}

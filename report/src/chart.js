// One figure: controls, a chart that follows theme and width, a note. Charts are drawn one after the other, so that the page
// answers at once.

import * as echarts from "echarts/core";
import { BarChart, BoxplotChart, CustomChart, LineChart, ScatterChart } from "echarts/charts";
import { AxisPointerComponent, DataZoomInsideComponent, GridComponent, LegendComponent, MarkAreaComponent, MarkLineComponent, TitleComponent, TooltipComponent } from "echarts/components";
import { CanvasRenderer } from "echarts/renderers";
import { h } from "./dom.js";
import { number, scaleFor } from "./words.js";
import { colours, onTheme } from "./theme.js";

echarts.use([
  BarChart, BoxplotChart, CustomChart, LineChart, ScatterChart,
  AxisPointerComponent, DataZoomInsideComponent, GridComponent, LegendComponent, MarkAreaComponent, MarkLineComponent, TitleComponent, TooltipComponent,
  CanvasRenderer,
]);

const waiting = [];
let drawing = false;

function drawNext() {
  const draw = waiting.shift();
  if (!draw) {
    drawing = false;
    document.documentElement.dataset.drawn = "yes";
    return;
  }
  draw();
  setTimeout(drawNext, 0);
}

function drawLater(draw) {
  waiting.push(draw);
  if (drawing) return;
  drawing = true;
  setTimeout(drawNext, 0);
}

const still = window.matchMedia("(prefers-reduced-motion: reduce)");

/** A long name of an axis takes two lines on a phone. */
function breakAxisName(option) {
  const { xAxis, grid } = option;
  if (!xAxis?.name || xAxis.name.length < 36) return;
  const middle = xAxis.name.indexOf(" ", xAxis.name.length / 2 - 4);
  if (middle < 0) return;
  xAxis.name = `${xAxis.name.slice(0, middle)}\n${xAxis.name.slice(middle + 1)}`;
  if (typeof grid?.bottom === "number") grid.bottom += 18;
}

/** What every chart has in common. */
function withDefaults(option, theme, width) {
  if (width < 520) breakAxisName(option);
  // On a phone three numbers along the axis are enough.
  if (width < 520 && option.xAxis?.type === "value" && option.xAxis.splitNumber === undefined) option.xAxis.splitNumber = 3;
  const tooltip = {
    confine: true,
    backgroundColor: theme.raised,
    borderColor: theme.line,
    borderWidth: 1,
    padding: 0,
    transitionDuration: 0,
    textStyle: { color: theme.ink, fontFamily: theme.font, fontSize: 13 },
    extraCssText: "box-shadow:0 6px 24px rgba(0,0,0,.14);border-radius:8px;white-space:normal;max-width:min(340px,86vw);",
    ...option.tooltip,
  };
  const upwards = option.yAxis?.pageTitle;
  return {
    animation: false,
    textStyle: { fontFamily: theme.font, color: theme.ink },
    title: upwards ? { text: upwards, left: 0, top: 2, padding: 0, textStyle: { color: theme.soft, fontSize: 13, fontWeight: 400, fontFamily: theme.font } } : undefined,
    ...option,
    tooltip,
  };
}

/** An axis in the page's style. `column`: { units } gives it a scale that reads well. */
export function axis(theme, { name, units = "", most = 0, type = "value", vertical = false, ...rest }) {
  const scale = scaleFor(units, most);
  const grid = type !== "category" && rest.lines !== false;
  delete rest.lines;
  // The ends of a logarithmic axis are no round numbers.
  const ends = rest.inner ? { showMinLabel: false, showMaxLabel: false } : {};
  delete rest.inner;
  const title = name + (scale.unit ? ` (${scale.unit})` : "");
  return {
    type,
    // The name of a vertical axis stands above the chart, where it can be read without turning the head.
    pageTitle: vertical ? title : undefined,
    name: vertical ? "" : title,
    nameLocation: "middle",
    nameGap: 32,
    nameTextStyle: { color: theme.soft, fontSize: 13, lineHeight: 17 },
    axisLine: { show: !vertical, lineStyle: { color: theme.line } },
    axisTick: { show: false },
    axisLabel: {
      color: theme.soft,
      fontSize: 12,
      hideOverlap: true,
      ...ends,
      formatter: (value) => (typeof value === "number" ? number(value / scale.factor, 3) : value),
    },
    splitLine: { show: grid, lineStyle: { color: theme.line, opacity: 0.7 } },
    ...rest,
  };
}

/** Small numbers of different size read better on a logarithmic axis. */
export function wantsLog(values) {
  if (values.length < 4) return false;
  const least = Math.min(...[values[0], values[values.length - 1]]);
  const most = Math.max(...[values[0], values[values.length - 1]]);
  return least > 0 && most / least > 8;
}

/** A round range on a log axis in powers of two, of ten where it is long. */
export function logAxis(least, most) {
  const base = most / least > 2000 ? 10 : 2;
  return { type: "log", logBase: base, min: least / 1.12, max: most * 1.12, inner: true };
}

/**
 * @param option (theme, width) => ECharts option
 * @param describe () => text read instead of the picture
 * @param legend (theme) => what the colours mean, as an element
 * @param pick (params) => called for a click on a mark
 * @returns { element, redraw }
 */
export function figure({ option, describe, height = 420, controls = [], legend = null, note = null, pick = null, below = null }) {
  const canvas = h("div", { class: "chart", role: "img", tabindex: "-1" });
  const noteElement = h("p", { class: "note" });
  const legendBox = h("div", { class: "legend-box" });
  let chart = null;
  let width = 0;

  const heightOf = () => (typeof height === "function" ? height(canvas.clientWidth) : height);
  function draw() {
    const theme = colours();
    canvas.style.height = `${heightOf()}px`;
    canvas.setAttribute("aria-label", describe());
    const text = typeof note === "function" ? note() : note;
    noteElement.textContent = text ?? "";
    noteElement.hidden = !text;
    legendBox.replaceChildren(...[typeof legend === "function" ? legend(theme) : legend].filter(Boolean));
    if (!chart) {
      chart = echarts.init(canvas, null, { renderer: "canvas", devicePixelRatio: Math.max(2, window.devicePixelRatio || 1) });
      if (pick) chart.on("click", pick);
      width = canvas.clientWidth;
      new ResizeObserver(() => {
        if (canvas.clientWidth === width || canvas.clientWidth === 0) return;
        width = canvas.clientWidth;
        draw();
      }).observe(canvas);
    }
    chart.resize({ height: heightOf(), silent: true });
    chart.setOption(withDefaults(option(theme, canvas.clientWidth), theme, canvas.clientWidth), { notMerge: true });
    canvas.dataset.drawn = "yes";
  }
  drawLater(draw);
  onTheme(() => chart && draw());
  if (still.matches) canvas.classList.add("still");
  const element = h("figure", {}, controls.length ? h("div", { class: "controls" }, controls) : null, legend ? legendBox : null, canvas, below, noteElement);
  return { element, redraw: () => chart && draw(), chart: () => chart };
}

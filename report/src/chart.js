// One figure: controls, a chart that follows theme and width, a note. Charts are drawn one after the other, so that the page
// answers at once.

import * as echarts from "echarts/core";
import { BarChart, BoxplotChart, CustomChart, LineChart, ScatterChart } from "echarts/charts";
import { AxisPointerComponent, DataZoomInsideComponent, GridComponent, LegendComponent, MarkAreaComponent, MarkLineComponent, TitleComponent, TooltipComponent } from "echarts/components";
import { CanvasRenderer, SVGRenderer } from "echarts/renderers";
import { brushing, overlay, showLit } from "./chart_overlay.js";
import { csvOfLines, fileName } from "./csv.js";
import { download, h } from "./dom.js";
import { number, scaleFor } from "./words.js";
import { colours, onTheme } from "./theme.js";

echarts.use([
  BarChart, BoxplotChart, CustomChart, LineChart, ScatterChart,
  AxisPointerComponent, DataZoomInsideComponent, GridComponent, LegendComponent, MarkAreaComponent, MarkLineComponent, TitleComponent, TooltipComponent,
  CanvasRenderer, SVGRenderer,
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

/** The same picture as a drawing of lines and letters. */
function svgOf(option, width, height, title) {
  const chart = echarts.init(null, null, { renderer: "svg", ssr: true, width, height });
  chart.setOption(option);
  const text = chart.renderToSVGString();
  chart.dispose();
  // The title is what a reader of the picture is told; it is data, so it becomes a text node.
  const drawing = new DOMParser().parseFromString(text, "image/svg+xml");
  const element = drawing.createElementNS("http://www.w3.org/2000/svg", "title");
  element.textContent = title;
  drawing.documentElement.prepend(element);
  return new XMLSerializer().serializeToString(drawing);
}

let figures = 0;

/** Buttons that save a chart: its picture, and the numbers it shows. */
function savers(name, picture, numbers) {
  const save = (kind, type, text) => h("button", { type: "button", class: "quiet small", "aria-label": `${kind} of ${name}`, onclick: () => download(`${fileName(name)}.${kind.toLowerCase()}`, type, text()) }, kind);
  return h("div", { class: "savers" }, save("SVG", "image/svg+xml", picture), numbers ? save("CSV", "text/csv;charset=utf-8", () => csvOfLines(numbers())) : null);
}

/** A chart on the page: drawn when its turn comes, and again with every other width, theme or selection. */
class Figure {
  constructor(parts) {
    Object.assign(this, { height: 420, controls: [], legend: null, note: null, pick: null, below: null, selection: null, rowOf: null, litAt: null, brush: null, csv: null }, parts);
    figures += 1;
    this.name = parts.name ?? `chart ${figures}`;
    this.canvas = h("div", { class: `chart${this.brush ? " brushed" : ""}${this.brush?.touch ? " swiped" : ""}`, role: "img", tabindex: "-1" });
    this.noteElement = h("p", { class: "note" });
    this.legendBox = h("div", { class: "legend-box" });
    this.queued = true;
    drawLater(() => this.draw());
    onTheme(() => this.drawn && this.draw());
    if (still.matches) this.canvas.classList.add("still");
    if (this.selection) this.followSelection();
    this.element = h("figure", {}, this.controls.length ? h("div", { class: "controls" }, this.controls) : null, this.legend ? this.legendBox : null, this.canvas, this.below, savers(this.name, () => this.picture(), this.csv), this.noteElement);
  }

  /** What is out of sight is drawn when it comes into sight, or is printed. */
  followSelection() {
    this.inSight = true;
    new IntersectionObserver(([entry]) => { this.inSight = entry.isIntersecting; this.refresh(); }, { rootMargin: "200px" }).observe(this.canvas);
    window.addEventListener("beforeprint", () => this.stale && this.draw());
    this.selection.on(() => { this.stale = true; this.refresh(); });
    if (this.litAt) this.selection.onLight(() => this.light());
  }

  refresh() {
    if (!this.stale || this.queued || !this.inSight) return;
    this.queued = true;
    drawLater(() => this.draw());
  }

  heightNow() {
    return typeof this.height === "function" ? this.height(this.canvas.clientWidth) : this.height;
  }

  optionNow() {
    const theme = colours();
    return withDefaults(this.option(theme, this.canvas.clientWidth), theme, this.canvas.clientWidth);
  }

  picture() {
    const option = { ...this.optionNow(), backgroundColor: colours().paper };
    return svgOf(option, this.canvas.clientWidth, this.heightNow(), this.describe());
  }

  start() {
    const { canvas, selection } = this;
    this.chart = echarts.init(canvas, null, { renderer: "canvas", devicePixelRatio: Math.max(2, window.devicePixelRatio || 1) });
    if (this.pick) this.chart.on("click", this.pick);
    if (selection && this.rowOf) {
      this.chart.on("mouseover", (params) => selection.light(this.rowOf(params)));
      this.chart.on("mouseout", () => selection.light(null));
      this.chart.on("globalout", () => selection.light(null));
    }
    if (this.litAt || this.brush) this.layer = overlay(canvas);
    if (this.brush) brushing(canvas, this.layer, this.brush(this.chart));
    this.width = canvas.clientWidth;
    new ResizeObserver(() => {
      if (canvas.clientWidth === this.width || canvas.clientWidth === 0) return;
      this.width = canvas.clientWidth;
      this.draw();
    }).observe(canvas);
  }

  draw() {
    const { canvas } = this;
    this.queued = false;
    this.stale = false;
    canvas.style.height = `${this.heightNow()}px`;
    canvas.setAttribute("aria-label", this.describe());
    this.say();
    if (!this.chart) this.start();
    this.chart.resize({ height: this.heightNow(), silent: true });
    this.chart.setOption(this.optionNow(), { notMerge: true });
    if (this.litAt) this.light();
    this.drawn = true;
    canvas.dataset.drawn = "yes";
  }

  /** The note below and the legend above; a legend that stays the same keeps the reader's place in it. */
  say() {
    const text = typeof this.note === "function" ? this.note() : this.note;
    this.noteElement.textContent = text ?? "";
    this.noteElement.hidden = !text;
    const found = typeof this.legend === "function" ? this.legend(colours()) : this.legend;
    if (found === null) this.legendBox.replaceChildren();
    else if (this.legendBox.firstChild !== found) this.legendBox.replaceChildren(found);
  }

  light() {
    if (this.drawn || this.chart) showLit(this.layer, this.selection, (row) => this.litAt(row, this.chart));
  }
}

/**
 * @param option (theme, width) => ECharts option
 * @param describe () => text read instead of the picture
 * @param name what the chart is called where it is saved
 * @param csv () => lines of the numbers it shows, the first of them their names
 * @param legend (theme) => what the colours mean, as an element
 * @param pick (params) => called for a click on a mark
 * @param selection of the study, where the chart shows its scenarios; with it
 *        rowOf (params) => the scenario under the pointer, litAt (row, chart) => where a scenario stands, in pixels,
 *        brush (chart) => what a drag over it means (chart_overlay.js)
 * @returns { element, redraw }
 */
export function figure(parts) {
  const made = new Figure(parts);
  return { element: made.element, redraw: () => made.drawn && made.draw(), chart: () => made.chart ?? null };
}

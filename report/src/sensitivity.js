// Which inputs matter: bars with their intervals.

import { axis, figure } from "./chart.js";
import { h, select } from "./dom.js";
import { capital } from "./answer/parts.js";
import { wholeStudy } from "./claims.js";
import { effectNote, effects, firstMetric } from "./tables.js";
import { tip, tipLine } from "./scenario.js";
import { genericTable } from "./table.js";
import { label, percent, plural, quantity, scaleFor } from "./words.js";

/** A bar from zero with a whisker. */
function bars(theme, columns, table, rows, { name, colour, offset, thickness, opacity = 1 }) {
  const column = columns[name];
  return {
    type: "custom",
    name,
    data: rows.map((each, i) => [column.at(each.row), i, table.at(`${name}_low`, each.row), table.at(`${name}_high`, each.row)]),
    encode: { x: [0, 2, 3], y: 1 },
    renderItem: (params, api) => {
      const i = api.value(1);
      const height = api.size([0, 1])[1];
      const y = api.coord([0, i])[1] + offset * height;
      const at = (value) => api.coord([value, i])[0];
      const [zero, end] = [at(0), at(api.value(0))];
      const children = [{ type: "rect", shape: { x: Math.min(zero, end), y: y - (thickness * height) / 2, width: Math.abs(end - zero), height: thickness * height, r: 2 }, style: { fill: colour, opacity } }];
      const [low, high] = [api.value(2), api.value(3)];
      if (Number.isFinite(low) && Number.isFinite(high)) {
        children.push({ type: "line", shape: { x1: at(low), x2: at(high), y1: y, y2: y }, style: { stroke: theme.ink, lineWidth: 1.5 } });
        for (const end of [low, high]) children.push({ type: "line", shape: { x1: at(end), x2: at(end), y1: y - 4, y2: y + 4 }, style: { stroke: theme.ink, lineWidth: 1.5 } });
      }
      return { type: "group", children };
    },
  };
}

export function sensitivity(study) {
  const table = study.tables.get("sensitivity");
  const metrics = table?.column("metric")?.distinct ?? [];
  if (!table || metrics.length === 0) return null;
  const morris = table.column("mean_absolute") !== null;
  let metric = firstMetric(table);
  const columns = Object.fromEntries(table.columns.map((column) => [column.name, column]));
  const unitsOf = () => (morris ? study.scenarios.column(metric)?.units ?? "" : "");
  const text = (value) => (morris ? quantity(value, unitsOf(), 3) : percent(value));
  const effectTip = (each) =>
    tip(
      h("div", { class: "tip-head" }, h("b", {}, label(each.key))),
      (morris ? ["mean_absolute", "mean", "standard_deviation"] : ["total", "first_order"]).map((name) => {
        const value = table.at(name, each.row);
        if (value === null) return null;
        const [low, high] = [table.at(`${name}_low`, each.row), table.at(`${name}_high`, each.row)];
        return tipLine(name.replaceAll("_", " "), `${text(value)}${low === null ? "" : ` (${text(low)} to ${text(high)})`}`);
      }),
    );
  const chart = figure({
    height: () => 84 + 46 * effects(table, metric).length,
    name: `${study.name} what matters`,
    csv: () => [table.columns.map((column) => column.name), ...effects(table, metric).map(({ row }) => table.columns.map((column) => column.at(row)))],
    controls: metrics.length > 1 ? [select("Metric", metrics.map((each) => ({ value: each, label: label(each) })), metric, (name) => { metric = name; chart.redraw(); })] : [],
    option: (theme) => {
      const rows = effects(table, metric);
      const most = Math.max(...rows.map((each) => each.high ?? each.value), 1e-300);
      const scale = morris ? scaleFor(unitsOf(), most) : { factor: 1, unit: "" };
      return {
        grid: { left: 8, right: 20, top: 8, bottom: 44, containLabel: true },
        xAxis: axis(theme, morris
          ? { name: `mean effect on ${label(metric)} over the whole range`, units: unitsOf(), most }
          : { name: `share of the variance of ${label(metric)}`, axisLabel: { color: theme.soft, fontSize: 12, formatter: (value) => percent(value) } }),
        yAxis: { type: "category", inverse: true, data: rows.map((each) => label(each.key)), axisTick: { show: false }, axisLine: { show: false }, axisLabel: { color: theme.ink, fontSize: 13, width: 150, overflow: "truncate" } },
        tooltip: { trigger: "item", formatter: ({ data }) => effectTip(rows[data[1]]) },
        series: morris
          ? [
              bars(theme, columns, table, rows, { name: "mean_absolute", colour: theme.accent, offset: 0, thickness: 0.5 }),
              { type: "scatter", symbol: "emptyDiamond", symbolSize: 11, itemStyle: { color: theme.ink }, data: rows.map((each, i) => [table.at("standard_deviation", each.row), i]).filter((each) => each[0] !== null), scale },
            ]
          : [
              bars(theme, columns, table, rows, { name: "total", colour: theme.accent, opacity: 0.35, offset: -0.18, thickness: 0.3 }),
              columns.first_order ? bars(theme, columns, table, rows, { name: "first_order", colour: theme.accent, offset: 0.18, thickness: 0.3 }) : null,
            ].filter(Boolean),
      };
    },
    describe: () => effectNote(table, metric) ? `${capital(label(metric))} ${effectNote(table, metric)}.` : `Effects on ${label(metric)}: ${effects(table, metric).map((each) => `${label(each.key)} ${text(each.value)}`).join(", ")}.`,
    note: () => effectNote(table, metric) ? `${capital(label(metric))} ${effectNote(table, metric)}.` : `${morris ? "Bars: how far the metric moves over the input's range, on average. Open diamonds: how much that depends on the other inputs." : "Pale: total effect, with everything the input interacts with. Full: on its own."} Lines: ${typeof table.attributes.confidence === "number" ? percent(table.attributes.confidence) : "confidence"} intervals; an interval that reaches zero shows no effect.${leftOut(table)}`,
  });
  return h("div", {}, wholeStudy(study), chart.element, h("details", {}, h("summary", {}, "As a table"), genericTable(study, table, { name: "sensitivity" })));
}

function leftOut(table) {
  const count = table.attributes.left_out;
  if (typeof count === "number" && count > 0) return ` ${plural(count, "scenario")} without the metric ${count === 1 ? "was" : "were"} left out.`;
  return typeof count === "string" && count ? ` Left out: ${count}.` : "";
}

// The trade-off between objectives: the front, its knee, and what else was tried.

import { evaluationsOf, evaluationTip, faded, rowOfMark, scenarioRow } from "./convergence.js";
import { axis, figure } from "./chart.js";
import { h, select } from "./dom.js";
import { legend } from "./legend.js";
import { copyReplay } from "./scenario.js";
import { extent } from "./statistics.js";
import { objectiveColumns, objectiveLabel, objectiveUnits } from "./tables.js";
import { genericTable } from "./table.js";
import { number, plural } from "./words.js";

function rangeAxis(study, theme, column, values, vertical) {
  const [least, most] = extent(values) ?? [0, 1];
  const pad = 0.08 * (most - least || Math.abs(most) || 1);
  return axis(theme, {
    name: objectiveLabel(column), units: objectiveUnits(study, column), most: Math.max(Math.abs(least), Math.abs(most)), vertical,
    scale: true, min: least - pad, max: most + pad,
    splitNumber: 5, inner: true,
  });
}

/** The others that were tried, near enough to the front to be worth the space. */
function background(study, names, limits) {
  const table = study.tables.get("evaluations");
  const columns = names.map((name) => table?.column(name));
  if (columns.some((column) => !column)) return [];
  const points = [];
  for (let row = 0; row < table.rows; row += 1) {
    const [a, b] = columns.map((column) => column.at(row));
    if (a === null || b === null || table.at("feasible", row) !== 1) continue;
    if (a <= limits[0] && b <= limits[1]) points.push([a, b, row]);
  }
  return points;
}

/** The staircase of a front of two objectives: what lies above it is beaten. */
function staircase(points) {
  const line = [];
  const sorted = [...points].sort((a, b) => a[0] - b[0]);
  sorted.forEach((point, i) => {
    if (i > 0) line.push([point[0], sorted[i - 1][1]]);
    line.push([point[0], point[1]]);
  });
  return line;
}

export function pareto(study) {
  const front = study.tables.get("pareto");
  if (!front || front.rows === 0) return null;
  const objectives = objectiveColumns(front);
  if (objectives.length < 2) return h("div", {}, genericTable(study, front, { name: "pareto" }));
  let [x, y] = objectives;
  const evaluations = study.tables.get("evaluations");
  const described = objectives.map((column) => ({ name: objectiveLabel(column), column, units: objectiveUnits(study, column) }));
  const options = objectives.map((column) => ({ value: column.name, label: objectiveLabel(column) }));
  const controls = objectives.length > 2
    ? [select("Across", options, x.name, (name) => { x = front.column(name); chart.redraw(); }), select("Upwards", options, y.name, (name) => { y = front.column(name); chart.redraw(); })]
    : [];
  const chart = figure({
    height: (width) => Math.max(320, Math.min(500, width * 0.6)),
    controls,
    option: (theme) => {
      const points = [];
      for (let row = 0; row < front.rows; row += 1) if (x.at(row) !== null && y.at(row) !== null) points.push([x.at(row), y.at(row), row]);
      const [xs, ys] = [points.map((point) => point[0]), points.map((point) => point[1])];
      const reach = (values) => { const [least, most] = extent(values) ?? [0, 1]; return most + 0.6 * (most - least || Math.abs(most)); };
      const others = background(study, [x.name, y.name], [reach(xs), reach(ys)]);
      const knees = points.filter((point) => front.at("knee", point[2]) === 1);
      return {
        grid: { left: 8, right: 20, top: 34, bottom: 44, containLabel: true },
        xAxis: rangeAxis(study, theme, x, [...xs, ...others.map((point) => point[0])], false),
        yAxis: rangeAxis(study, theme, y, [...ys, ...others.map((point) => point[1])], true),
        tooltip: {
          trigger: "item",
          formatter: (params) =>
            params.seriesName === "tried" ? evaluationTip(study, evaluations, rowOfMark(params), described.map((each) => ({ ...each, column: evaluations.column(each.column.name) }))) : frontTip(study, front, rowOfMark(params), described),
        },
        series: [
          { type: "scatter", name: "tried", symbolSize: 5, itemStyle: { color: theme.soft, opacity: 0.35 }, data: others.map((point) => faded(study, evaluations, point, 0.35)) },
          objectives.length === 2 ? { type: "line", name: "front", silent: true, symbol: "none", lineStyle: { color: theme.accent, width: 1.5, opacity: 0.55 }, data: staircase(points) } : null,
          { type: "scatter", name: "front", symbolSize: 11, itemStyle: { color: theme.accent, borderColor: theme.paper, borderWidth: 1.5 }, data: points.map((point) => faded(study, front, point, 1)), z: 4 },
          { type: "scatter", name: "knee", symbolSize: 20, symbol: "circle", itemStyle: { color: "transparent", borderColor: theme.ink, borderWidth: 2 }, data: knees, z: 5, label: { show: knees.length === 1, formatter: "knee", position: "right", color: theme.ink, fontSize: 13, fontWeight: 600, distance: 8, textBorderColor: theme.paper, textBorderWidth: 4 } },
        ].filter(Boolean),
      };
    },
    describe: () => `Front of ${plural(front.rows, "strategy", "strategies")} over ${described.map((each) => each.name).join(" and ")}. The table below holds the same values.`,
    legend: (theme) => legend([[theme.accent, "strategies that no other beats in everything"], [theme.soft, "other feasible ones"]]),
    note: `Less is better on both axes.${objectives.length > 2 ? " With three objectives, two are shown at a time, so a point may seem beaten here." : ""}`,
    pick: (params) => {
      const [table, row] = [params.seriesName === "tried" ? evaluations : front, rowOfMark(params)];
      if (row !== null && table.at("scenario", row) !== null) copyReplay(study, table.at("scenario", row));
    },
    name: `${study.name} trade-off`,
    selection: study.selection,
    rowOf: (params) => (rowOfMark(params) === null ? null : scenarioRow(study, params.seriesName === "tried" ? evaluations : front, rowOfMark(params))),
    litAt: (row, shown) => [front, evaluations].filter(Boolean).flatMap((table) => evaluationsOf(study, table, row).map((each) => [x, y].map((column) => table.at(column.name, each)))).filter((values) => !values.includes(null) && shown.containPixel({ gridIndex: 0 }, shown.convertToPixel({ gridIndex: 0 }, values))).slice(0, 1).map((values) => ({ at: shown.convertToPixel({ gridIndex: 0 }, values) })),
    csv: () => [[...objectives.map(objectiveLabel), "knee"], ...Array.from({ length: front.rows }, (_, row) => [...objectives.map((column) => column.at(row)), front.at("knee", row)])],
  });
  return h("div", {}, chart.element, h("details", { open: front.rows <= 12 }, h("summary", {}, "As a table"), genericTable(study, front, { name: "pareto", titles: Object.fromEntries(described.map((each) => [each.column.name, each.name])) })));
}

function frontTip(study, front, row, described) {
  const tipElement = evaluationTip(study, front, row, described);
  tipElement.querySelector(".tip-head").replaceChildren(h("b", {}, front.at("knee", row) === 1 ? "knee of the front" : "on the front"), h("span", {}, `point ${number(row, 9)}`));
  return tipElement;
}

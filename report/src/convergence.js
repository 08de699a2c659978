// How the search went: every evaluation, and the best feasible one so far.

import { axis, figure } from "./chart.js";
import { commandText, h } from "./dom.js";
import { goalWords } from "./goals.js";
import { legend } from "./legend.js";
import { copyReplay, replayCommand, tip, tipLine } from "./scenario.js";
import { extent } from "./statistics.js";
import { inWords, keyColumns, rowsOf, unitsOfGoal } from "./tables.js";
import { genericTable } from "./table.js";
import { label, number, percent, plural, quantity } from "./words.js";
import { outcomeColour } from "./theme.js";

export function evaluationTip(study, table, row, objectives) {
  const scenario = table.at("scenario", row);
  const replay = scenario === null ? null : replayCommand(study, scenario);
  const probability = table.at("probability", row);
  return tip(
    h("div", { class: "tip-head" }, h("b", {}, table.at("feasible", row) === 0 ? "not feasible" : "feasible"), h("span", {}, `evaluation ${row}`)),
    objectives.map(({ name, column, units }) => tipLine(name, quantity(column.at(row), units))),
    probability === null ? null : tipLine("probability", percent(probability)),
    table.at("feasible", row) === 0 && table.at("binding", row) ? tipLine("misses", goalWords(study, table.at("binding", row))) : null,
    h("hr"),
    keyColumns(table).map((column) => tipLine(label(column.name), quantity(column.at(row), column.units))),
    replay ? commandText(replay, { class: "replay" }) : null,
    replay ? h("p", { class: "hint" }, "Click copies the command.") : null,
  );
}

/** The scenario of an evaluation, as a row of the scenarios; null where it has none. */
export function scenarioRow(study, table, row) {
  const id = row >= 0 ? table.at("scenario", row) : null;
  return id === null ? null : study.scenarios.rowOf.get(id) ?? null;
}

/** Is the evaluation's scenario selected? */
export function isSelected(study, table, row) {
  const found = scenarioRow(study, table, row);
  return found === null ? !study.selection.active : study.selection.has(found);
}

/** Evaluations of a scenario. */
export function evaluationsOf(study, table, scenario) {
  const id = study.scenarios.at("id", scenario);
  return rowsOf(table).filter((row) => table.at("scenario", row) === id);
}

/** What is not selected is faded. */
export function faded(study, table, point, opacity) {
  return isSelected(study, table, point[2]) ? point : { value: point, itemStyle: { opacity: opacity * 0.14 } };
}

/** The row that a mark of a chart stands for. */
export function rowOfMark({ data }) {
  const value = Array.isArray(data) ? data : data?.value;
  return Array.isArray(value) ? value[2] ?? null : null;
}

/** Best feasible objective so far, as steps. */
function bestSoFar(table, objective, rows) {
  const points = [];
  let best = null;
  for (const row of rows) {
    const value = objective.at(row);
    if (table.at("feasible", row) === 1 && value !== null && (best === null || value < best)) best = value;
    if (best !== null) points.push([row, best]);
  }
  return points;
}

/** Objectives far above the interesting ones would flatten everything. */
function cappedRange(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const low = sorted[0];
  const high = sorted[Math.min(sorted.length - 1, Math.floor(0.97 * sorted.length))];
  const pad = 0.06 * (high - low || Math.abs(high) || 1);
  return [low - pad, high + pad];
}

export function convergence(study) {
  const table = study.tables.get("evaluations");
  const objective = table?.column("objective");
  if (!table || !objective || table.rows === 0) return null;
  const text = study.tables.get("best")?.attributes?.objective ?? (objective.longName || "objective");
  const units = objective.units || unitsOfGoal(study, text);
  const name = inWords(text);
  const all = Array.from({ length: table.rows }, (_, row) => row);
  const feasible = all.filter((row) => table.at("feasible", row) === 1);
  const values = objective.numbers();
  if (values.length === 0) return null;
  const [low, high] = cappedRange(values);
  const above = values.filter((value) => value > high).length;
  const chart = figure({
    height: 380,
    option: (theme) => {
      const points = (wanted) => all.filter((row) => (table.at("feasible", row) === 1) === wanted && objective.at(row) !== null).map((row) => faded(study, table, [row, Math.min(objective.at(row), high), row], 0.85));
      return {
        grid: { left: 8, right: 20, top: 34, bottom: 44, containLabel: true },
        xAxis: axis(theme, { name: "evaluation", lines: false, min: 0, max: Math.max(1, table.rows - 1) }),
        yAxis: axis(theme, { name, units, most: Math.max(Math.abs(low), Math.abs(high)), vertical: true, min: low, max: high, axisLabel: { color: theme.soft, fontSize: 12, showMinLabel: false, showMaxLabel: false, formatter: (value) => number(value, 3) } }),
        tooltip: { trigger: "item", formatter: (params) => evaluationTip(study, table, rowOfMark(params), [{ name, column: objective, units }]) },
        series: [
          { type: "scatter", name: "not feasible", symbol: "emptyCircle", symbolSize: 7, itemStyle: { color: theme.soft, opacity: 0.7 }, data: points(false) },
          { type: "scatter", name: "feasible", symbolSize: 7, itemStyle: { color: outcomeColour("held"), opacity: 0.85 }, data: points(true) },
          { type: "line", name: "best so far", silent: true, step: "end", symbol: "none", lineStyle: { color: theme.ink, width: 2 }, data: bestSoFar(table, objective, all), z: 4 },
        ],
      };
    },
    describe: () => `${plural(table.rows, "evaluation")}, ${feasible.length} of them feasible. ${feasible.length ? `Best ${name}: ${quantity(Math.min(...feasible.map((row) => objective.at(row)).filter((value) => value !== null)), units)}.` : "None is feasible."}`,
    legend: (theme) => legend([[outcomeColour("held"), "feasible"], [theme.soft, "not feasible"], [theme.ink, "the best feasible one so far", "line"]]),
    note: `${above ? ` ${plural(above, "evaluation")} above the frame ${above === 1 ? "is" : "are"} drawn at its edge.` : ""}`.trim(),
    pick: (params) => table.at("scenario", rowOfMark(params)) !== null && copyReplay(study, table.at("scenario", rowOfMark(params))),
    name: `${study.name} search`,
    selection: study.selection,
    rowOf: (params) => (rowOfMark(params) === null ? null : scenarioRow(study, table, rowOfMark(params))),
    litAt: (row, shown) => evaluationsOf(study, table, row).filter((each) => objective.at(each) !== null).map((each) => ({ at: shown.convertToPixel({ gridIndex: 0 }, [each, Math.min(objective.at(each), high)]) })),
    csv: () => [["evaluation", "feasible", "objective"], ...all.map((row) => [row, table.at("feasible", row), objective.at(row)])],
  });
  return h("div", { class: "parts" }, chart.element, strategies(study, table), searches(study));
}

function searches(study) {
  const table = study.tables.get("searches");
  return table && table.rows ? h("div", {}, h("h3", {}, "Searches"), genericTable(study, table, { name: "searches" })) : null;
}

/** Where in the box of each variable the search looked: one row of marks per variable. */
function strategies(study, table) {
  const columns = keyColumns(table).filter((column) => !column.isText && column.varies);
  if (columns.length === 0) return null;
  const best = study.tables.get("best");
  const ranges = columns.map((column) => extent(column.numbers()));
  const shareOf = (i, row) => (columns[i].at(row) - ranges[i][0]) / (ranges[i][1] - ranges[i][0]);
  const chart = figure({
    height: 60 + 54 * columns.length,
    option: (theme) => ({
      grid: { left: 8, right: 20, top: 8, bottom: 34, containLabel: true },
      xAxis: { type: "value", min: 0, max: 1, axisLabel: { color: theme.soft, fontSize: 12, formatter: (value) => (value === 0 ? "least tried" : value === 1 ? "greatest tried" : "") }, axisTick: { show: false }, axisLine: { show: false }, splitLine: { show: false } },
      yAxis: { type: "category", inverse: true, data: columns.map((column) => label(column.name)), axisTick: { show: false }, axisLine: { show: false }, axisLabel: { color: theme.ink, fontSize: 13, width: 130, overflow: "break" }, splitLine: { show: true, lineStyle: { color: theme.line } } },
      tooltip: { trigger: "item", formatter: ({ value: data }) => (data[2] < 0 ? tip(tipLine("best", quantity(best.at(columns[data[1]].name, 0), columns[data[1]].units))) : evaluationTip(study, table, data[2], [])) },
      series: [
        {
          type: "scatter",
          symbol: "rect",
          symbolSize: [2, 22],
          itemStyle: { opacity: 0.5 },
          data: columns.flatMap((column, i) => Array.from({ length: table.rows }, (_, row) => {
            const value = column.at(row);
            if (value === null) return null;
            const [least, most] = ranges[i];
            return { value: [(value - least) / (most - least), i, row], itemStyle: { color: table.at("feasible", row) === 1 ? outcomeColour("held") : theme.soft, opacity: isSelected(study, table, row) ? 0.5 : 0.07 } };
          }).filter(Boolean)),
        },
        best && best.rows
          ? {
              type: "scatter",
              symbol: "diamond",
              symbolSize: 17,
              z: 5,
              itemStyle: { color: theme.ink, borderColor: theme.paper, borderWidth: 2 },
              data: columns.map((column, i) => [(best.at(column.name, 0) - ranges[i][0]) / (ranges[i][1] - ranges[i][0]), i, -1]),
            }
          : null,
      ].filter(Boolean),
    }),
    describe: () => `Where the search looked in each of ${plural(columns.length, "variable")}.`,
    name: `${study.name} where it looked`,
    selection: study.selection,
    rowOf: (params) => (rowOfMark(params) === null ? null : scenarioRow(study, table, rowOfMark(params))),
    litAt: (row, shown) => evaluationsOf(study, table, row).flatMap((each) => columns.map((_, i) => ({ at: shown.convertToPixel({ gridIndex: 0 }, [shareOf(i, each), i]) }))),
    csv: () => [["evaluation", "feasible", ...columns.map((column) => column.name)], ...rowsOf(table).map((row) => [row, table.at("feasible", row), ...columns.map((column) => column.at(row))])],
    note: "One stroke per evaluation; the diamond is the best strategy. A diamond at an end says that the range is worth widening.",
    pick: ({ data }) => Array.isArray(data?.value) && table.at("scenario", data.value[2]) !== null && copyReplay(study, table.at("scenario", data.value[2])),
  });
  return h("div", {}, h("h3", {}, "Where it looked"), chart.element);
}


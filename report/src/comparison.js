// Candidates on the same products: how often each holds, and the paired differences with their intervals.

import { axis, figure } from "./chart.js";
import { h, scrollBox, select } from "./dom.js";
import { blocksOf, plainValue } from "./config.js";
import { heldWords, wholeStudy } from "./claims.js";
import { legend, outcomeList } from "./legend.js";
import { confidenceText, inWords } from "./tables.js";
import { tip, tipLine } from "./scenario.js";
import { genericTable } from "./table.js";
import { label, OUTCOMES, outcomeLabel, percent, quantity, thousands, unitsOfKey } from "./words.js";
import { outcomeColour } from "./theme.js";

function candidateOption(study, theme, table) {
  const names = Array.from({ length: table.rows }, (_, row) => String(table.at("name", row)));
  const words = OUTCOMES.filter((word) => table.column(word)?.numbers().some((value) => value > 0));
  const total = (row) => words.reduce((sum, word) => sum + (table.at(word, row) ?? 0), 0);
  return {
    grid: { left: 8, right: 24, top: 8, bottom: 44, containLabel: true },
    xAxis: axis(theme, { name: "share of the products", min: 0, max: 1, axisLabel: { color: theme.soft, fontSize: 12, formatter: (value) => percent(value) } }),
    yAxis: { type: "category", inverse: true, data: names, axisTick: { show: false }, axisLine: { show: false }, axisLabel: { color: theme.ink, fontSize: 13, width: 150, overflow: "truncate" } },
    tooltip: { trigger: "item", formatter: ({ dataIndex }) => candidateTip(study, table, dataIndex, words) },
    series: [
      ...words.map((word) => ({ type: "bar", stack: "outcomes", barWidth: 20, name: outcomeLabel(word), itemStyle: { color: outcomeColour(word) }, data: names.map((_, row) => (table.at(word, row) ?? 0) / Math.max(1, total(row))) })),
      {
        type: "custom",
        name: "interval",
        z: 5,
        silent: true,
        data: names.map((_, row) => [table.at("probability", row), row, table.at("probability_low", row), table.at("probability_high", row)]),
        encode: { x: 0, y: 1 },
        renderItem: (params, api) => {
          const [low, high] = [api.value(2), api.value(3)];
          if (!Number.isFinite(low) || !Number.isFinite(high)) return null;
          const y = api.coord([0, api.value(1)])[1] + 17;
          const at = (value) => api.coord([value, 0])[0];
          const line = (x1, x2, y1, y2) => ({ type: "line", shape: { x1, x2, y1, y2 }, style: { stroke: theme.ink, lineWidth: 1.6 } });
          return { type: "group", children: [line(at(low), at(high), y, y), line(at(low), at(low), y - 4, y + 4), line(at(high), at(high), y - 4, y + 4), { type: "circle", shape: { cx: at(api.value(0)), cy: y, r: 3.6 }, style: { fill: theme.ink } }] };
        },
      },
    ],
  };
}

function candidateTip(study, table, row, words) {
  return tip(
    h("div", { class: "tip-head" }, h("b", {}, String(table.at("name", row)))),
    tipLine(heldWords(study), `${percent(table.at("probability", row))} (${percent(table.at("probability_low", row))} to ${percent(table.at("probability_high", row))})`),
    words.map((word) => tipLine(outcomeLabel(word), thousands(table.at(word, row) ?? 0))),
    table.columns.filter((column) => column.name.startsWith("mean_")).slice(0, 6).map((column) => tipLine(label(column.name), quantity(column.at(row), column.units))),
  );
}

function differenceRows(table, metric) {
  const rows = [];
  for (let row = 0; row < table.rows; row += 1) if (table.at("metric", row) === metric && table.at("mean_difference", row) !== null) rows.push(row);
  return rows;
}

/** The column says which way the difference is taken. */
function differenceName(table, row) {
  const [a, b] = [table.at("a", row), table.at("b", row)];
  return table.column("mean_difference").longName.startsWith("a - b") ? `${a} − ${b}` : `${b} − ${a}`;
}

function isShown(table, row) {
  return table.at("low", row) > 0 || table.at("high", row) < 0;
}

function differenceOption(study, theme, table, metric, units, width) {
  const rows = differenceRows(table, metric);
  const name = (row) => differenceName(table, row);
  const most = Math.max(...rows.flatMap((row) => [Math.abs(table.at("low", row) ?? 0), Math.abs(table.at("high", row) ?? 0), Math.abs(table.at("mean_difference", row))]), 1e-300);
  const ratio = metric === "probability" || metric === "held";
  return {
    grid: { left: 8, right: 24, top: 8, bottom: 44, containLabel: true },
    xAxis: axis(theme, { name: `difference in ${label(metric)}, product by product`, units, most, min: -1.15 * most, max: 1.15 * most, inner: true, ...(ratio ? { axisLabel: { color: theme.soft, fontSize: 12, showMinLabel: false, showMaxLabel: false, formatter: (value) => percent(value) } } : {}) }),
    yAxis: { type: "category", inverse: true, data: rows.map(name), axisTick: { show: false }, axisLine: { show: false }, axisLabel: { color: theme.ink, fontSize: 13, width: width < 520 ? 96 : 190, overflow: "break" } },
    tooltip: { trigger: "item", formatter: ({ value }) => differenceTip(table, rows[value[1]], units) },
    series: [
      {
        type: "custom",
        data: rows.map((row, i) => [table.at("mean_difference", row), i, table.at("low", row), table.at("high", row)]),
        encode: { x: [0, 2, 3], y: 1 },
        markLine: { silent: true, symbol: "none", precision: 15, label: { show: false }, lineStyle: { color: theme.ink, type: "solid", width: 1 }, data: [{ xAxis: 0 }] },
        renderItem: (params, api) => {
          const row = rows[api.value(1)];
          const [x, y] = api.coord([api.value(0), api.value(1)]);
          const at = (value) => api.coord([value, 0])[0];
          const colour = isShown(table, row) ? theme.accent : theme.soft;
          const line = (x1, x2, y1, y2) => ({ type: "line", shape: { x1, x2, y1, y2 }, style: { stroke: colour, lineWidth: 2.4 } });
          const [low, high] = [at(api.value(2)), at(api.value(3))];
          return {
            type: "group",
            children: [
              { type: "rect", shape: { x: low, y: y - 14, width: high - low, height: 28 }, style: { fill: "rgba(0,0,0,0)" } },
              line(low, high, y, y), line(low, low, y - 6, y + 6), line(high, high, y - 6, y + 6),
              { type: "circle", shape: { cx: x, cy: y, r: 6 }, style: { fill: isShown(table, row) ? colour : theme.paper, stroke: colour, lineWidth: 2.4 } },
            ],
          };
        },
      },
    ],
  };
}

function differenceTip(table, row, units) {
  const at = (name) => table.at(name, row);
  return tip(
    h("div", { class: "tip-head" }, h("b", {}, differenceName(table, row))),
    tipLine("mean difference", quantity(at("mean_difference"), units)),
    tipLine("interval", `${quantity(at("low"), units)} to ${quantity(at("high"), units)}`),
    at("pairs") === null ? null : tipLine("pairs", thousands(at("pairs"))),
    at("wins") === null ? null : tipLine(`better: ${at("a")}, neither, ${at("b")}`, `${at("wins")}, ${at("ties")}, ${at("losses")}`),
    at("verdict") ? h("p", {}, inWords(at("verdict"))) : null,
  );
}

/** The strategies behind the names: what differs first, the rest folded away. */
function settings(study) {
  const blocks = blocksOf(study.config, "[[candidate]]");
  if (blocks.length === 0) return null;
  const keys = [...new Set(blocks.flatMap((block) => Object.keys(block)))].filter((key) => key !== "name" && key !== "use");
  const differs = (key) => new Set(blocks.map((block) => block[key])).size > 1;
  const text = (block, key) => { const value = plainValue(block[key]); return value === null ? "–" : quantity(value, unitsOfKey(key), 4, Math.max(...blocks.map((each) => Math.abs(Number(each[key]) || 0)))); };
  const row = (key) => h("tr", {}, h("th", { scope: "row", title: key }, label(key)), blocks.map((block) => h("td", { class: "number" }, text(block, key))));
  const table = (name, shown) => scrollBox(name, h("table", { class: "plain" }, h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "setting"), blocks.map((block) => h("th", { scope: "col", class: "number" }, String(plainValue(block.name)))))), h("tbody", {}, shown.map(row))));
  const [unlike, alike] = [keys.filter(differs), keys.filter((key) => !differs(key))];
  return h("div", {}, h("h3", {}, "What the candidates are"), unlike.length ? table("Settings that differ", unlike) : h("p", { class: "note" }, "Their settings are the same."), alike.length ? h("details", {}, h("summary", {}, `${alike.length} settings they share`), table("Settings they share", alike)) : null);
}

export function comparison(study) {
  const candidates = study.tables.get("candidates");
  const table = study.tables.get("comparison");
  if (!candidates && !table) return null;
  return h("div", {}, wholeStudy(study), settings(study), candidates && candidates.rows ? candidateFigure(study, candidates) : null, table && table.rows ? differenceFigure(study, table) : null);
}

function candidateFigure(study, candidates) {
  const words = OUTCOMES.filter((word) => candidates.column(word)?.numbers().some((value) => value > 0));
  const chart = figure({
    height: 84 + 58 * candidates.rows,
    name: `${study.name} candidates`,
    csv: () => [candidates.columns.map((column) => column.name), ...Array.from({ length: candidates.rows }, (_, row) => candidates.columns.map((column) => column.at(row)))],
    legend: outcomeList(words),
    option: (theme) => candidateOption(study, theme, candidates),
    describe: () => Array.from({ length: candidates.rows }, (_, row) => `${candidates.at("name", row)}: ${heldWords(study)} ${percent(candidates.at("probability", row))}`).join("; "),
    note: `Line with a dot: the probability of being ${heldWords(study)}, with its ${confidenceText(candidates)}.`,
  });
  return h("div", {}, h("h3", {}, "How often each holds"), chart.element, h("details", {}, h("summary", {}, "As a table"), genericTable(study, candidates, { name: "candidates" })));
}

function differenceFigure(study, table) {
  const metrics = table.column("metric")?.distinct ?? [];
  let metric = metrics[0];
  const units = () => table.column("mean_difference").units || (study.scenarios.column(metric)?.units ?? "");
  const chart = figure({
    height: () => 76 + 52 * differenceRows(table, metric).length,
    name: `${study.name} differences`,
    csv: () => [table.columns.map((column) => column.name), ...differenceRows(table, metric).map((row) => table.columns.map((column) => column.at(row)))],
    controls: metrics.length > 1 ? [select("Metric", metrics.map((each) => ({ value: each, label: label(each) })), metric, (name) => { metric = name; chart.redraw(); })] : [],
    legend: (theme) => legend([[theme.accent, "the interval leaves zero out: a difference is shown", "line"], [theme.soft, "it does not: no difference is shown", "line"]]),
    option: (theme, width) => differenceOption(study, theme, table, metric, units(), width),
    describe: () => differenceRows(table, metric).map((row) => `${differenceName(table, row)}: ${quantity(table.at("mean_difference", row), units())}, ${inWords(table.at("verdict", row) ?? "")}`).join("; "),
  });
  return h("div", {}, h("h3", {}, "Paired differences"), chart.element, differenceTables(study, table, metrics));
}

/** One table per metric: numbers of different units never share a column. */
function differenceTables(study, table, metrics) {
  const rowsFor = (metric) => differenceRows(table, metric);
  const relative = table.column("relative_difference");
  const one = (metric) => {
    const units = table.column("mean_difference").units || (study.scenarios.column(metric)?.units ?? "");
    const most = Math.max(...rowsFor(metric).flatMap((row) => ["mean_difference", "low", "high"].map((name) => Math.abs(table.at(name, row) ?? 0))));
    const cell = (row, name) => h("td", { class: "number" }, quantity(table.at(name, row), units, 4, most));
    const row = (each) => h("tr", {}, h("th", { scope: "row" }, differenceName(table, each)), cell(each, "mean_difference"), cell(each, "low"), cell(each, "high"), h("td", { class: "number" }, thousands(table.at("pairs", each) ?? "–")), relative ? h("td", { class: "number" }, percent(table.at("relative_difference", each))) : null);
    const heads = [[label(metric)], ["mean difference", "number"], ["from", "number"], ["to", "number"], ["pairs", "number"], ...(relative ? [["in per cent", "number"]] : [])];
    return scrollBox(`Differences in ${label(metric)}`, h("table", { class: "plain" }, h("thead", {}, h("tr", {}, heads.map(([name, kind]) => h("th", { scope: "col", class: kind }, name)))), h("tbody", {}, rowsFor(metric).map(row))));
  };
  return h("details", {}, h("summary", {}, "As tables"), metrics.map(one));
}

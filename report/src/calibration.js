// Measured curves over simulated ones, and what the fitted keys predict of each specimen.

import { axis, figure } from "./chart.js";
import { h, select } from "./dom.js";
import { legend } from "./legend.js";
import { tip, tipLine } from "./scenario.js";
import { confidenceText, keyColumns, rowsOf, textAttribute } from "./tables.js";
import { genericTable } from "./table.js";
import { label, percent, plural, quantity } from "./words.js";

const ALL = "";

/** [{ name, rows }] in the order of the file. */
function specimensOf(curve) {
  const specimens = new Map();
  for (const row of rowsOf(curve)) {
    const name = curve.at("specimen", row);
    if (!specimens.has(name)) specimens.set(name, []);
    specimens.get(name).push(row);
  }
  return [...specimens].map(([name, rows]) => ({ name, rows }));
}

/** A specimen's line and points; those that are not chosen stay behind, pale. */
function seriesOf({ name, rows }, columns, theme, { chosen, index }) {
  const one = chosen === name;
  const pale = chosen !== ALL && !one;
  const colour = pale ? theme.soft : theme.series[chosen === ALL ? index % theme.series.length : 0];
  const points = (column) => rows.map((row) => [columns.over.at(row), column.at(row), row]);
  const opacity = pale ? 0.25 : 1;
  return [
    { type: "line", name, symbol: "none", silent: true, lineStyle: { color: colour, width: one ? 2.5 : 1.4, opacity }, data: points(columns.simulated), z: one ? 4 : 2 },
    { type: "scatter", name, symbolSize: one ? 8 : 6, itemStyle: { color: colour, opacity: pale ? 0.25 : 0.9, borderColor: theme.paper, borderWidth: 0.6 }, data: points(columns.measured), z: one ? 5 : 3 },
  ];
}

function curves(study, fits, curve) {
  const columns = { over: curve.column("closure_m") ?? curve.column("time_s"), measured: curve.column("measured"), simulated: curve.column("simulated") };
  const specimens = specimensOf(curve);
  const measured = label(textAttribute(fits, "measured", "measured"));
  const over = label(columns.over.name);
  let chosen = ALL;
  const options = [{ value: ALL, label: "all" }, ...specimens.map(({ name }) => ({ value: name, label: name }))];
  const chart = figure({
    height: (width) => Math.max(300, Math.min(480, width * 0.55)),
    controls: specimens.length > 1 ? [select("Specimen", options, chosen, (name) => { chosen = name; chart.redraw(); })] : [],
    option: (theme) => ({
      grid: { left: 8, right: 20, top: 34, bottom: 44, containLabel: true },
      xAxis: axis(theme, { name: over, units: columns.over.units, most: columns.over.most }),
      yAxis: axis(theme, { name: measured, units: columns.measured.units, most: columns.measured.most, vertical: true }),
      tooltip: {
        trigger: "item",
        formatter: ({ seriesName, value: [, , row] }) => tip(
          h("div", { class: "tip-head" }, h("b", {}, seriesName)),
          tipLine(over, quantity(columns.over.at(row), columns.over.units)),
          tipLine("measured", quantity(columns.measured.at(row), columns.measured.units)),
          tipLine("simulated", quantity(columns.simulated.at(row), columns.simulated.units)),
        ),
      },
      series: specimens.flatMap((specimen, index) => seriesOf(specimen, columns, theme, { chosen, index })),
    }),
    describe: () => `${measured} over ${over} of ${plural(specimens.length, "specimen")}, measured and simulated.`,
    legend: (theme) => legend([[theme.ink, "measured (dots)"], [theme.ink, "simulated with the fitted keys", "line"]]),
  });
  return chart.element;
}

/** Predictions with their intervals over what was measured; on the diagonal they are right. */
function predictions(fits) {
  const outcome = fits.column("outcome");
  const rows = rowsOf(fits).filter((row) => outcome?.at(row) !== null && fits.at("predicted", row) !== null);
  if (!outcome || rows.length === 0) return null;
  const name = label(textAttribute(fits, "outcome", "outcome"));
  const at = (column, row) => fits.at(column, row);
  const most = 1.05 * Math.max(...rows.map((row) => Math.max(outcome.at(row), at("predicted", row))));
  const highest = Math.min(3 * most, Math.max(most, 1.02 * Math.max(...rows.map((row) => at("predicted_high", row)))));
  const { predicted, predicted_covered: covered, mean_error_relative: error } = fits.attributes;
  const chart = figure({
    height: (width) => Math.max(300, Math.min(460, width * 0.55)),
    option: (theme) => ({
      grid: { left: 8, right: 20, top: 34, bottom: 44, containLabel: true },
      xAxis: axis(theme, { name: `${name}, measured`, units: outcome.units, most, min: 0, max: most, inner: true }),
      yAxis: axis(theme, { name: `${name}, predicted by the other specimens`, units: outcome.units, most, min: 0, max: highest, inner: true, vertical: true }),
      tooltip: {
        trigger: "item",
        formatter: ({ value: [, , row] }) => tip(
          h("div", { class: "tip-head" }, h("b", {}, at("specimen", row))),
          tipLine("measured", quantity(outcome.at(row), outcome.units)),
          tipLine("predicted", quantity(at("predicted", row), outcome.units)),
          tipLine(confidenceText(fits), `${quantity(at("predicted_low", row), outcome.units)} to ${quantity(at("predicted_high", row), outcome.units)}`),
        ),
      },
      series: [
        { type: "line", silent: true, symbol: "none", lineStyle: { color: theme.soft, width: 1, type: "dashed" }, data: [[0, 0], [most, most]] },
        ...rows.map((row) => ({ type: "line", silent: true, symbol: "none", lineStyle: { color: theme.accent, width: 1.2, opacity: 0.45 }, data: [[outcome.at(row), at("predicted_low", row)], [outcome.at(row), Math.min(highest, at("predicted_high", row))]] })),
        { type: "scatter", symbolSize: 8, itemStyle: { color: theme.accent }, data: rows.map((row) => [outcome.at(row), at("predicted", row), row]), z: 4 },
      ],
    }),
    describe: () => `${name} of ${plural(rows.length, "specimen")}, predicted over measured.`,
    note: `Each specimen by a regression on all others. Mean error ${percent(error)}; ${covered} of ${predicted} inside their ${confidenceText(fits)}. Dashed: predicted as measured.`,
  });
  return h("div", {}, h("h3", {}, `${name[0].toUpperCase()}${name.slice(1)} from the fitted keys`), chart.element);
}

const RARELY_READ = ["points", "condition", "weakest", "weakest_error", "scenarios"];

export function calibration(study) {
  const fits = study.tables.get("calibration");
  const curve = study.tables.get("calibration_curve");
  if (!fits || fits.rows === 0) return null;
  const ends = keyColumns(fits).map((column) => column.name);
  const titles = Object.fromEntries(ends.filter((name) => /_(low|high)$/.test(name)).map((name) => [name, `${label(name.replace(/_(low|high)$/, ""))}, ${name.endsWith("_low") ? "from" : "to"}`]));
  return h(
    "div",
    {},
    curve && curve.rows ? curves(study, fits, curve) : null,
    predictions(fits),
    h("h3", {}, "Specimens"),
    genericTable(study, fits, { name: "calibration", hide: RARELY_READ, titles }),
    ["population", "population_correlation"].map((name) => study.tables.get(name)).filter((table) => table && table.rows).map((table) => h("div", {}, h("h3", {}, table.name === "population" ? "Population" : "What goes together"), genericTable(study, table, { name: table.name }))),
  );
}

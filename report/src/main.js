// The report of one study: the answer first, then what it rests on.

import { answer } from "./answer.js";
import { calibration } from "./calibration.js";
import { comparison } from "./comparison.js";
import { convergence } from "./convergence.js";
import { readStudy } from "./data.js";
import { distributions } from "./distributions.js";
import { damageRemark, judgesDamage } from "./claims.js";
import { h, showsItsOverflow } from "./dom.js";
import { findings, otherTables } from "./findings.js";
import { outcomeMap } from "./outcome_map.js";
import { parallel } from "./parallel.js";
import { pareto } from "./pareto.js";
import { notices, provenance } from "./provenance.js";
import { sensitivity } from "./sensitivity.js";
import { replay } from "./replay.js";
import { restsOn } from "./rests_on.js";
import { sizing } from "./sizing.js";
import { Selection } from "./selection.js";
import { selectionBar } from "./selection_bar.js";
import { slices, slicesLead, slicesTitle } from "./slices.js";
import { scenarioTable } from "./table.js";
import { startTheme, themeButton } from "./theme.js";
import { traceCurves } from "./trace.js";
import { windows } from "./windows.js";
import { date } from "./words.js";

/** Sections in reading order: [id, title, lead, content, name in the navigation where it is another]. One without content is left out. */
const SECTIONS = [
  ["replay", "In motion", (study) => (study.replays.length > 1 ? "What held best, and what went wrong nearest to it, run again and in step." : "The scenario as it ran."), replay],
  ["trace", "Over time", "What the gripper did to the product, step by step.", traceCurves],
  ["pareto", "Trade-off", "More of one costs some of the other.", pareto],
  ["calibration", "Measured and simulated", "Each specimen's curve, and the same with the values that were fitted to it.", calibration, "Curves"],
  ["comparison", "Comparison", "Every candidate met the same products, so differences are taken product by product.", comparison],
  ["sensitivity", "What matters", "How strongly each input moves the result.", sensitivity],
  ["windows", "Windows", (study) => `From the least force that holds${judgesDamage(study) ? " to the greatest that leaves no mark" : `; ${damageRemark(study)}`}.`, (study) => (study.kind === "sweep" && study.window?.rows > 400 ? null : windows(study))],
  ["sizing", "Sizing sheet", "What the rules of gripper makers ask for, beside what was simulated; on one page of paper.", sizing, "Sizing"],
  ["convergence", "The search", "Every strategy that was tried, in order.", convergence],
  ["findings", "Constraints and checks", "What the best strategy has to meet, and whether it still does when looked at more closely.", findings, "Checks"],
  ["map", "Outcomes", "Each mark is a scenario. The pointer shows its numbers, a click copies the command that replays it, a drag selects.", outcomeMap],
  ["slices", slicesTitle, slicesLead, slices, "Slices"],
  ["parallel", "Everything at once", "A line per scenario through all its inputs and metrics. Drag along an axis to select.", parallel, "All axes"],
  ["distributions", "Spread", "How a metric is distributed over the scenarios.", distributions],
  ["rests_on", "What this answer rests on", "Every value of product, gripper and limits, and who says so.", restsOn, "Sources"],
  ["scenarios", "Scenarios", "Every scenario of the study. Sort by a column, filter by conditions, take them along as CSV.", (study) => (study.scenarios.rows ? scenarioTable(study) : null)],
  ["tables", "More tables", "What else the study left behind.", otherTables],
  ["origin", "Inputs and origin", "What went in, and what it was computed with.", provenance, "Origin"],
];

/** Tables, scenes and many axes take the whole width. */
const WIDE = new Set(["replay", "parallel", "scenarios", "tables"]);

function sectionOf(study, [id, title, lead, content]) {
  let body;
  try {
    body = content(study);
  } catch (error) {
    console.error(error);
    body = h("p", { class: "banner" }, `This part of the page could not be drawn: ${error.message}`);
  }
  if (!body) return null;
  const said = (text) => (typeof text === "function" ? text(study) : text);
  return h("section", { id, class: WIDE.has(id) ? "wide" : null, "aria-labelledby": `${id}-title` }, h("div", { class: "margin" }, h("h2", { id: `${id}-title` }, said(title)), h("p", { class: "lead" }, said(lead))), h("div", { class: "content" }, body));
}

function header(study, sections) {
  return h(
    "header",
    {},
    h("a", { class: "skip", href: "#answer" }, "To the answer"),
    h("div", { class: "bar" }, h("p", { class: "name" }, h("b", {}, study.name), h("span", { class: "soft" }, [study.kind, date(study.created_utc)].filter(Boolean).join(" · "))), showsItsOverflow(h("nav", { "aria-label": "Sections" }, h("ul", {}, sections.map(([id, title]) => h("li", {}, h("a", { href: `#${id}` }, title)))))), themeButton()),
  );
}

function footer() {
  return h("footer", {}, h("p", { class: "soft" }, "Made by Unbruised. This page is one file; it loads nothing and sends nothing."), notices(document));
}

function start() {
  const study = readStudy(document);
  startTheme(study.outcomeColours);
  study.selection = new Selection(study.scenarios);
  const built = SECTIONS.map((each) => [each[0], each[4] ?? each[1], sectionOf(study, each)]).filter((each) => each[2]);
  const page = document.getElementById("page");
  page.append(header(study, built), h("main", {}, answer(study), built.map((each) => each[2])), footer(), ...[selectionBar(study)].filter(Boolean));
}

start();

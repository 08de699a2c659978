// What the curves say of the fitted keys, over all specimens.

import { keyColumns, rowsOf, textAttribute } from "../tables.js";
import { label, percent, plural, quantity, thousands } from "../words.js";
import { fact, verdict } from "./parts.js";

function keyFact(fits, population, row) {
  const key = population.at("key", row);
  const units = fits.column(key)?.units ?? "";
  const [mean, deviation] = [population.at("mean", row), population.at("standard_deviation", row)];
  const several = (population.attributes.specimens ?? 0) > 1;
  return fact(label(key), quantity(mean, units), several ? `the specimens differ by ${percent(deviation / Math.abs(mean))} (standard deviation)` : null);
}

function predictionFact(fits) {
  const { predicted, predicted_covered: covered, mean_error_relative: error, outcome } = fits.attributes;
  if (!(predicted > 0)) return null;
  return fact(`${label(outcome)} of each by the others`, `${percent(error)} off on average`, `${thousands(covered)} of ${thousands(predicted)} inside their intervals`);
}

export function calibrateAnswer(study) {
  const fits = study.tables.get("calibration");
  const population = study.tables.get("population");
  const told = fits.attributes.told ?? 0;
  const doubted = rowsOf(fits).filter((row) => fits.at("note", row)).length;
  const keys = keyColumns(fits).filter((column) => !/_(low|high)$/.test(column.name)).length;
  return {
    kicker: `${plural(keys, "key")} fitted to ${plural(fits.rows, "measured curve")}`,
    headline: `${thousands(told)} of ${plural(fits.rows, "specimen")}`,
    size: "medium",
    verdict: told === 0 ? verdict("bad", "No curve tells the keys") : doubted > 0 ? verdict("warn", `${plural(doubted, "fit")} to be doubted: the notes say why`) : verdict("good", "The curves tell every key"),
    sentence: `Fitted to ${label(textAttribute(fits, "measured"))} over ${label(textAttribute(fits, "over"))}. Whether the model is right is for the picture to say, not for the intervals.`,
    facts: [...rowsOf(population).slice(0, 4).map((row) => keyFact(fits, population, row)), predictionFact(fits)],
  };
}

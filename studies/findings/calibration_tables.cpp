#include "studies/findings/calibration_tables.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "studies/config/measured_data.hpp"
#include "studies/findings/population.hpp"
#include "studies/findings/summary.hpp"
#include "studies/statistics/least_squares.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// A value closer to an end of its range, on the scale of the fit, may lie beyond it.
constexpr double kAtEnd = 1e-3;

std::string units_of(std::string_view column) { return std::string(column.substr(column.rfind('_') + 1)); }

/// "0.71 youngs_modulus_Pa - 0.7 yield_stress_Pa"
std::string direction_text(const Study& study, const std::vector<double>& direction) {
  std::string text;
  for (std::size_t k = 0; k < direction.size(); ++k) {
    const double part = std::round(100.0 * direction[k]) / 100.0;
    if (part == 0.0) continue;
    const std::string sign = part < 0.0 ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ");
    text += joined({sign, short_number(std::abs(part)), " ", key_leaf(study.variables()[k].key)});
  }
  return text;
}

/// What a key's value or interval has to be doubted for; empty: nothing.
std::string doubt_of(const SpecimenFit& fit, std::size_t k) {
  if (fit.unit[k] <= kAtEnd || fit.unit[k] >= 1.0 - kAtEnd) return "is at the end of its range";
  const auto has = [&](EndKind kind) {
    return fit.intervals[k].low.kind == kind || fit.intervals[k].high.kind == kind;
  };
  if (has(EndKind::unsettled)) return "has an interval that did not settle";
  return has(EndKind::range) ? "has an interval up to the end of its range, and may lie beyond" : "";
}

std::string note_of(const Study& study, const SpecimenFit& fit) {
  if (!fit.is_fitted) return "no scenario gave a curve";
  std::string note;
  for (std::size_t k = 0; k < fit.unit.size(); ++k) {
    const std::string doubt = doubt_of(fit, k);
    if (!doubt.empty()) add_part(note, "; ", joined({key_leaf(study.variables()[k].key), " ", doubt}));
  }
  if (!(fit.weakest_error < kToldError)) {
    add_part(note, "; ", joined({"does not tell ", direction_text(study, fit.weakest)}));
  }
  return note;
}

/// Outcomes of specimens against what the others' keys predict.
struct Predicted {
  std::vector<Prediction> of_fit;  ///< NaN where there is none
  std::size_t count = 0;
  std::size_t covered = 0;
  double absolute_error = 0.0;  ///< means over those predicted
  double relative_error = 0.0;
  double outcome_mean = 0.0;
};

class Tables {
 public:
  Tables(const Study& study, const std::vector<SpecimenFit>& fits)
      : study_(study),
        settings_(study.calibrate()),
        fits_(fits),
        population_(population_of(study, fits)),
        predicted_(predictions()) {}

  Calibration run() {
    Calibration out;
    out.tables = {calibration(), curves()};
    if (!population_.keys.empty()) out.tables.push_back(population());
    if (population_.ranks && population_.keys.size() > 1) out.tables.push_back(correlations());
    out.warnings = warnings();
    out.product_toml = population_toml(study_, population_);
    return out;
  }

 private:
  using Numbers = std::vector<double>;

  template <class Value>
  Numbers of_fits(Value value) const {
    Numbers numbers;
    for (std::size_t i = 0; i < fits_.size(); ++i) numbers.push_back(value(i));
    return numbers;
  }

  [[nodiscard]] std::string measured_units() const { return units_of(column_measured(settings_.test)); }

  ResultTable calibration() const {
    std::vector<std::string> specimens, weakest, notes;
    for (const SpecimenFit& fit : fits_) {
      specimens.push_back(fit.specimen);
      weakest.push_back(direction_text(study_, fit.weakest));
      notes.push_back(note_of(study_, fit));
    }
    ResultTable table{.name = "calibration", .row = "specimen_number", .columns = {}, .attributes = {}};
    table.columns.push_back({"specimen", "", "specimen", std::move(specimens)});
    add_keys(table);
    table.columns.push_back({"points", "1", "points of the measured curve", of_fits([&](std::size_t i) {
                               return static_cast<double>(settings_.curves[i].x.size());
                             })});
    table.columns.push_back({"rms_residual", measured_units(), "root mean square of simulated less measured",
                             of_fits([&](std::size_t i) { return fits_[i].rms_residual; })});
    table.columns.push_back({"condition", "1", "largest over least singular value of the curve's derivatives",
                             of_fits([&](std::size_t i) { return condition(fits_[i]); })});
    table.columns.push_back(
        {"weakest", "", "the combination of keys that the curve tells least about", std::move(weakest)});
    table.columns.push_back(
        {"weakest_error", "1", "its standard error; 1: the whole range",
         of_fits([&](std::size_t i) { return fits_[i].is_fitted ? fits_[i].weakest_error : kAbsent; })});
    table.columns.push_back({"scenarios", "1", "that the fit asked for",
                             of_fits([&](std::size_t i) { return static_cast<double>(fits_[i].scenarios); })});
    if (!settings_.outcome.empty()) add_predictions(table);
    table.columns.push_back({"note", "", "what to doubt", std::move(notes)});
    table.attributes.emplace_back("measured", std::string(column_measured(settings_.test)));
    table.attributes.emplace_back("over", std::string(column_over(settings_.test)));
    table.attributes.emplace_back("confidence", settings_.confidence);
    table.attributes.emplace_back("told", static_cast<double>(population_.specimens.size()));
    return table;
  }

  void add_keys(ResultTable& table) const {
    for (std::size_t k = 0; k < study_.variables().size(); ++k) {
      const SearchVariable& key = study_.variables()[k];
      const auto column = [&](std::vector<double> SpecimenFit::*values) {
        return of_fits([&](std::size_t i) { return fits_[i].is_fitted ? (fits_[i].*values)[k] : kAbsent; });
      };
      table.columns.push_back({key.key, key.units, "fitted value", column(&SpecimenFit::values)});
      table.columns.push_back(
          {key.key + "_low", key.units, "lower end of its interval", column(&SpecimenFit::low)});
      table.columns.push_back(
          {key.key + "_high", key.units, "upper end of its interval", column(&SpecimenFit::high)});
    }
  }

  static double condition(const SpecimenFit& fit) {
    if (fit.singular_values.empty()) return kAbsent;
    return fit.singular_values.front() / fit.singular_values.back();
  }

  void add_predictions(ResultTable& table) const {
    const std::string units = units_of(settings_.outcome);
    const auto add = [&](const std::string& name, const std::string& what, auto value) {
      table.columns.push_back({name, units, what, of_fits(value)});
    };
    add("outcome", settings_.outcome + ", measured",
        [&](std::size_t i) { return settings_.curves[i].outcome.value_or(kAbsent); });
    add("predicted", "from its keys, by the other specimens",
        [&](std::size_t i) { return predicted_.of_fit[i].value; });
    add("predicted_low", "lower end of its interval", [&](std::size_t i) { return predicted_.of_fit[i].low; });
    add("predicted_high", "upper end of its interval", [&](std::size_t i) { return predicted_.of_fit[i].high; });
    table.attributes.emplace_back("outcome", settings_.outcome);
    table.attributes.emplace_back("predicted", static_cast<double>(predicted_.count));
    table.attributes.emplace_back("predicted_covered", static_cast<double>(predicted_.covered));
    table.attributes.emplace_back("mean_error", predicted_.absolute_error);
    table.attributes.emplace_back("mean_error_relative", predicted_.relative_error);
    table.attributes.emplace_back("mean_absolute_deviation", predicted_.outcome_mean);
  }

  ResultTable curves() const {
    std::vector<std::string> specimens;
    Numbers over, measured, simulated;
    for (std::size_t i = 0; i < fits_.size(); ++i) {
      const MeasuredCurve& curve = settings_.curves[i];
      for (std::size_t p = 0; p < curve.x.size(); ++p) {
        specimens.push_back(curve.specimen);
        over.push_back(curve.x[p]);
        measured.push_back(curve.y[p]);
        simulated.push_back(fits_[i].is_fitted ? fits_[i].simulated[p] : kAbsent);
      }
    }
    const std::string x(column_over(settings_.test));
    return {.name = "calibration_curve",
            .row = "curve_point",
            .columns = {{"specimen", "", "specimen", std::move(specimens)},
                        {x, units_of(x), "since the first contact", std::move(over)},
                        {"measured", measured_units(), "as given", std::move(measured)},
                        {"simulated", measured_units(), "with the fitted keys", std::move(simulated)}},
            .attributes = {}};
  }

  ResultTable population() const {
    std::vector<std::string> keys;
    Numbers mean, deviation, scatter, error;
    for (const FittedKey& key : population_.keys) {
      keys.push_back(key.key);
      mean.push_back(key.mean);
      deviation.push_back(key.deviation);
      scatter.push_back(key.scatter);
      error.push_back(key.error);
    }
    return {.name = "population",
            .row = "fitted_key",
            .columns = {{"key", "", "fitted key", std::move(keys)},
                        {"mean", "", "over the specimens, in the key's unit", std::move(mean)},
                        {"standard_deviation", "", "between specimens, in the key's unit", std::move(deviation)},
                        {"scatter", "1", "of the fitted values, as part of the range", std::move(scatter)},
                        {"error", "1", "of a fitted value, as part of the range", std::move(error)}},
            .attributes = {{"specimens", static_cast<double>(population_.specimens.size())}}};
  }

  ResultTable correlations() const {
    std::vector<std::string> first, second;
    Numbers rank;
    for (std::size_t i = 0; i < population_.keys.size(); ++i) {
      for (std::size_t j = i + 1; j < population_.keys.size(); ++j) {
        first.push_back(population_.keys[i].key);
        second.push_back(population_.keys[j].key);
        rank.push_back(population_.ranks->at(i, j));
      }
    }
    return {.name = "population_correlation",
            .row = "fitted_pair",
            .columns = {{"first", "", "fitted key", std::move(first)},
                        {"second", "", "fitted key", std::move(second)},
                        {"rank_correlation", "1", "Spearman's, over the specimens", std::move(rank)}},
            .attributes = {}};
  }

  /// By a linear regression of the outcome on the keys, both in logarithms where they are positive, on all
  /// specimens but the one that is predicted.
  [[nodiscard]] Predicted predictions() const {
    Predicted out;
    out.of_fit.assign(fits_.size(), {kAbsent, kAbsent, kAbsent});
    std::vector<std::size_t> used;
    for (const std::size_t i : population_.specimens) {
      if (settings_.curves[i].outcome) used.push_back(i);
    }
    if (used.empty()) return out;
    const bool is_log =
        std::all_of(used.begin(), used.end(), [&](std::size_t i) { return *settings_.curves[i].outcome > 0.0; });
    std::vector<std::vector<double>> x;
    Numbers y;
    for (const std::size_t i : used) {
      x.push_back(fits_[i].unit);  // of the logarithm for keys fitted on a log scale
      y.push_back(is_log ? std::log(*settings_.curves[i].outcome) : *settings_.curves[i].outcome);
    }
    const std::vector<Prediction> found = leave_one_out(x, y, settings_.confidence);
    for (std::size_t r = 0; r < used.size(); ++r) {
      Prediction prediction = found[r];
      if (std::isnan(prediction.value)) continue;
      if (is_log) prediction = {std::exp(prediction.value), std::exp(prediction.low), std::exp(prediction.high)};
      const double outcome = *settings_.curves[used[r]].outcome;
      out.of_fit[used[r]] = prediction;
      ++out.count;
      out.covered += prediction.low <= outcome && outcome <= prediction.high ? 1U : 0U;
      out.absolute_error += std::abs(prediction.value - outcome);
      out.relative_error += std::abs(prediction.value - outcome) / std::abs(outcome);
      out.outcome_mean += std::abs(outcome - mean_without(used, used[r]));
    }
    if (out.count == 0) return out;
    for (double* sum : {&out.absolute_error, &out.relative_error, &out.outcome_mean}) {
      *sum /= static_cast<double>(out.count);
    }
    return out;
  }

  /// The mean outcome of the other specimens: what is predicted without looking at a curve.
  [[nodiscard]] double mean_without(const std::vector<std::size_t>& used, std::size_t left_out) const {
    double sum = 0.0;
    for (const std::size_t i : used) sum += i == left_out ? 0.0 : *settings_.curves[i].outcome;
    return sum / static_cast<double>(used.size() - 1);
  }

  [[nodiscard]] std::vector<std::string> warnings() const {
    std::vector<std::string> all;
    std::size_t failed = 0, untold = 0, at_end = 0;
    std::string direction;
    for (const SpecimenFit& fit : fits_) {
      failed += fit.is_fitted ? 0U : 1U;
      if (!fit.is_fitted) continue;
      if (!(fit.weakest_error < kToldError)) {
        ++untold;
        direction = direction_text(study_, fit.weakest);
      }
      at_end +=
          std::any_of(fit.unit.begin(), fit.unit.end(), [](double u) { return u < kAtEnd || u > 1.0 - kAtEnd; })
              ? 1U
              : 0U;
    }
    const std::string of = " of " + std::to_string(fits_.size()) + " curves";
    if (failed > 0)
      all.push_back(std::to_string(failed) + of +
                    ": no scenario gave a curve (no contact, or all diverged or out of range)");
    if (untold > 0) {
      all.push_back(
          joined({std::to_string(untold), of, " do not tell the keys apart: ", direction,
                  " may change by half of its range and more, and the fit stays as good; fix one of them, or "
                  "measure something else too"}));
    }
    if (at_end > 0) all.push_back(std::to_string(at_end) + of + " are best fitted at an end of a range: widen it");
    return all;
  }

  const Study& study_;
  const CalibrateSettings& settings_;
  const std::vector<SpecimenFit>& fits_;
  const Population population_;
  const Predicted predicted_;
};

}  // namespace

Calibration calibration_of(const Study& study, const std::vector<SpecimenFit>& fits) {
  return Tables(study, fits).run();
}

}  // namespace unbruised::studies

#include "core/scenario/plausible.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

std::string with_article(std::string_view noun) {
  const bool vowel = std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + std::string(noun);
}

/// Where the decades of a row have their middle; low ends of 0 count as far below the high one.
double middle_decade(const PlausibleRow& row) {
  constexpr double kBelow = 1e-6;
  const double high = std::isinf(row.high) ? 1.0 : row.high;
  const double low = row.low > 0.0 ? row.low : kBelow * high;
  return 0.5 * (std::log10(low) + std::log10(high));
}

/// Has a field that the derived quantity follows from been blamed already?
bool is_told(const std::vector<Implausible>& found, const PlausibleRow& derived) {
  return std::any_of(found.begin(), found.end(), [&](const Implausible& other) {
    const std::string_view key = other.measured.key;
    const auto& fields = derived.fields;
    return std::find(fields.begin(), fields.end(), key.substr(0, key.find('['))) != fields.end();
  });
}

}  // namespace

std::string PlausibleRow::range_text() const {
  if (std::isinf(high)) return "at least " + for_people(low);
  return for_people(low) + " to " + for_people(high);
}

const UnitSlip* likely_slip(const PlausibleRow& row, double value) {
  const UnitSlip* best = nullptr;
  double nearest = HUGE_VAL;
  for (const UnitSlip& slip : row.slips) {
    const double meant = value / slip.factor;
    if (!row.contains(meant)) continue;
    const double distance = meant > 0.0 ? std::abs(std::log10(meant) - middle_decade(row)) : 0.0;
    if (distance < nearest) {
      nearest = distance;
      best = &slip;
    }
  }
  return best;
}

std::string Implausible::sentence() const {
  const auto with_unit = [&](const std::string& number) {
    return row->unit.empty() ? number : number + " " + std::string(row->unit);
  };
  std::string text = measured.key + " = " + spelled(measured.written) +
                     (row->is_derived() ? " gives " : " means ") + with_article(row->quantity) + " of " +
                     with_unit(for_people(measured.value)) + " (plausible: " + row->range_text() + ")";
  if (const UnitSlip* slip = likely_slip(*row, measured.value)) {
    text += ": " + std::string(slip->words);
    if (slip->of_key) text += " (" + for_people(measured.written / slip->factor) + ")";
    return text + "?";
  }
  return row->remark.empty() ? text : text + ": " + std::string(row->remark);
}

std::vector<Implausible> implausible_values(const Scenario& scenario) {
  std::vector<Implausible> found;
  if (!std::holds_alternative<LatticeParameters>(scenario.product)) return found;
  for (const bool derived : {false, true}) {
    for (const PlausibleRow& row : plausible_rows()) {
      if (row.is_derived() != derived || (derived && is_told(found, row))) continue;
      std::optional<Measured> worst;
      row.measure(scenario, [&](const Measured& measured) {
        if (!worst && !row.contains(measured.value)) worst = measured;
      });
      if (worst) found.push_back({&row, std::move(*worst)});
    }
  }
  return found;
}

}  // namespace unbruised

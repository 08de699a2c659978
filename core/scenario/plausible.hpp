#pragma once

/// @file
/// The one list of plausible values: not rules, but what delicate products, light grippers and pick-and-place
/// cycles have. A value outside is said aloud, with the slip of a unit that would explain it. Networks, whose
/// scale can be any, are not looked at.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scenario/scenario.hpp"

namespace unbruised {

/// A mistake that multiplies the quantity by `factor`: "grams taken for kilograms", 1000.
struct UnitSlip {
  double factor;
  std::string_view words;
  bool of_key = true;  ///< the written value is off by the same factor
};

/// A quantity as a scenario gives it, and the key whose value is to blame.
struct Measured {
  std::string key;
  double written = 0.0;
  double value = 0.0;
};
using MeasureVisit = std::function<void(const Measured&)>;

struct PlausibleRow {
  std::string_view quantity;             ///< a noun: "friction coefficient"
  std::string_view unit;                 ///< "kg/m3"; empty: none
  double low;                            ///< plausible, both included
  double high;                           ///< may be infinite
  std::vector<std::string_view> fields;  ///< what it follows from; one field: that field itself
  std::vector<UnitSlip> slips;
  std::string_view remark;  ///< said where no slip explains the value
  std::string_view source;  ///< of the ends
  /// Calls `visit` for each number or once for a derived quantity; not at all where the scenario has none.
  std::function<void(const Scenario&, const MeasureVisit& visit)> measure;

  [[nodiscard]] bool is_derived() const { return fields.size() > 1; }
  [[nodiscard]] bool contains(double value) const { return value >= low && value <= high; }
  /// "0.05 to 2", "at least 0"
  [[nodiscard]] std::string range_text() const;
};

/// All rows, in the order of the parameters.
const std::vector<PlausibleRow>& plausible_rows();

/// The slip that brings an implausible value nearest to the middle of the row; nullptr when none explains it.
const UnitSlip* likely_slip(const PlausibleRow& row, double value);

/// What is not plausible, with the row it breaks.
struct Implausible {
  const PlausibleRow* row;
  Measured measured;
  /// "product.mass_kg = 95.0 gives a density of 1,022,000 kg/m3 (plausible: 100 to 3,000): grams taken for
  /// kilograms (0.095)?"
  [[nodiscard]] std::string sentence() const;
};
/// At most one of each row, in their order. A derived quantity is left out where a field it follows from has been
/// blamed.
std::vector<Implausible> implausible_values(const Scenario& scenario);

}  // namespace unbruised

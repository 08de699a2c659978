#pragma once

/// @file
/// Every number of a scenario: where it stands, and the range it must lie in. The config reader, `validate`, the
/// rules between fields and the list of plausible values all look numbers up here.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/scenario/range.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised {

using NumberSlot = std::variant<double*, std::optional<double>*, int*>;

/// Which number of a field: its place in a list of particles, springs or loads, and in the field's own arrays.
struct NumberPlace {
  int index = -1;
  int element = -1;
  int component = -1;
};

using NumberVisit = std::function<void(const NumberPlace&, NumberSlot)>;

/// The numbers of one field of the table in fields.hpp.
struct NumberField {
  std::string path;         ///< dotted; [] stands for a place in a list: "product.particle[].mass_kg"
  std::size_t prefix_size;  ///< of the path of its parameters: "product.particle[]."
  Range range;
  /// Calls `visit` for each number of the field; for none where the scenario has no such field.
  void each(Scenario& scenario, const NumberVisit& visit) const;
};

/// All of them, in the order of the parameters.
const std::vector<NumberField>& number_fields();
/// The field of that path; nullptr when it is no number of a scenario.
const NumberField* find_number_field(std::string_view path);

/// "product.particle[3].position_m[0]"
std::string path_of(std::string_view pattern, const NumberPlace& place);

/// Calls `visit` with the value of each number of the field that is there.
void for_each_number(const NumberField& field, const Scenario& scenario,
                     const std::function<void(const NumberPlace&, double)>& visit);
/// The first number of a field; none where the scenario has no such field, or an optional one is absent.
std::optional<double> number_of(const NumberField& field, const Scenario& scenario);

}  // namespace unbruised

#pragma once

/// @file
/// The parts of the table of rules; inside core/scenario.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scenario/rules.hpp"

namespace unbruised {

std::vector<Rule> lattice_rules();
std::vector<Rule> shape_rules();
std::vector<Rule> layer_rules();
std::vector<Rule> relaxation_rules();
std::vector<Rule> lattice_pad_rules();
std::vector<Rule> network_rules();
std::vector<Rule> gripper_rules();
std::vector<Rule> pad_rules();
std::vector<Rule> finger_rules();
std::vector<Rule> motion_rules();
std::vector<Rule> sensor_rules();
std::vector<Rule> surface_rules();
std::vector<Rule> turn_rules();
std::vector<Rule> guard_rules();
std::vector<Rule> holding_rules();
std::vector<Rule> robot_rules();

/// Of what takes a product along the grip axis, or turns it.
inline constexpr std::string_view kNeedsCentric =
    "needs gripper.coupling = \"centric\": fingers that are driven alone by a force cannot carry the product "
    "along "
    "the grip axis";

/// lower <= upper, or < with `Strictness::below`, wherever both are there.
enum class Strictness { at_most, below };
/// @param sentence "<= gripper.max_force_N"
Rule bounded(std::string_view lower, std::string_view sentence, std::string_view upper,
             Strictness strictness = Strictness::at_most);

/// Appends what is wrong where only one of two optional numbers of a table is there: "missing; `with` needs it",
/// or "not used without `with`". @param path of the table, "product."
void add_unpaired(Violations& out, const std::string& path, const char* field, const std::optional<double>& value,
                  const char* with, const std::optional<double>& other);

/// Appends "must be <= other = bound".
void add_bound(Violations& out, std::string_view field, double value, std::string_view other, double bound,
               Strictness strictness = Strictness::at_most);

}  // namespace unbruised

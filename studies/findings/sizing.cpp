#include "studies/findings/sizing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scenario/lattice_cells.hpp"
#include "core/scenario/product.hpp"
#include "core/scenario/vectors.hpp"
#include "studies/findings/table_text.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// Where a gripper's file names none: makers of electric grippers write 2, of smooth fingertips 2.4, of pneumatic
/// grippers 4.
constexpr double kUsualSafetyFactor = 2.0;
/// Of both fingers, over the weight of the part: a rule of thumb for pneumatic grippers (Fabco FKHS series, p. 5).
constexpr double kPneumaticFactor = 13.0;

/// What the product and the path ask of a gripper.
struct Load {
  double mass_kg = 0.0, friction = 0.0, gravity_m_s2 = 0.0;
  double acceleration_m_s2 = 0.0;  ///< the largest of the path
  double stop_m_s2 = 0.0;
  double fingers = 2.0;
  bool turns = false;
  ParallelJawParameters gripper;

  /// Of each finger, that friction just carries the product under this acceleration beside gravity.
  [[nodiscard]] double just_holds_N(double acceleration) const {
    return mass_kg * (gravity_m_s2 + acceleration) / (fingers * friction);
  }
  [[nodiscard]] double safety() const { return gripper.safety_factor.value_or(kUsualSafetyFactor); }
};

double largest_acceleration_m_s2(const Scenario& s) {
  const StrategyParameters& strategy = s.strategy;
  const double lift = strategy.lift_acceleration_m_s2;
  double largest = 0.0;
  if (s.cell.lift_height_m > 0.0) largest = std::max(lift, strategy.lower_acceleration_m_s2.value_or(lift));
  if (std::hypot(s.cell.transfer_m[0], s.cell.transfer_m[1]) > 0.0) {
    largest = std::max(largest, strategy.transfer_acceleration_m_s2.value_or(lift));
  }
  return largest;
}

Load load_of(const Scenario& s) {
  Load load;
  if (const auto* lattice = std::get_if<LatticeParameters>(&s.product)) load.mass_kg = lattice_mass_kg(*lattice);
  load.friction = product_friction(s.product);
  load.gravity_m_s2 = length(s.cell.gravity_m_s2);
  load.acceleration_m_s2 = largest_acceleration_m_s2(s);
  load.stop_m_s2 = s.cell.stop_deceleration_m_s2;
  load.gripper = jaw_of(s);
  if (!load.gripper.finger.empty()) load.fingers = static_cast<double>(load.gripper.finger.size());
  load.turns = length(s.strategy.tilt_rad) > 0.0 || !s.strategy.waypoint.empty();
  return load;
}

/// A line of the sheet. Numbers that it does not have are NaN.
struct Item {
  std::string item;
  double value = kAbsent;
  std::string units{};
  double together = kAbsent;  ///< forces: of all fingers
  double limit = kAbsent;
  std::string verdict{};
  std::string says{};
};

std::string newtons(double force_N) { return joined({three_digits(force_N), " N"}); }

/// Where a force lies against the window of a strategy.
class Window {
 public:
  explicit Window(const StrategyWindow& strategy) : strategy_(strategy) {}

  [[nodiscard]] std::string verdict(double force_N) const {
    const StrategyWindow& s = strategy_;
    if (force_N < s.hold_force_N) return s.hold_is_bound ? "not tried" : "too weak";
    if (force_N > s.damage_force_N) return s.damage_is_bound ? "not tried" : "too strong";
    if (!s.exists) return "no window";
    return std::isnan(s.damage_force_N) ? "holds" : "inside";
  }
  [[nodiscard]] static std::string remark(const std::string& verdict) {
    if (verdict == "too weak") return "below the window: it does not hold the product";
    if (verdict == "too strong") return "above the window: it marks the product";
    if (verdict == "inside") return "inside the window";
    if (verdict == "holds") return "which holds the product; whether it marks it was not judged";
    if (verdict == "not tried") return "outside the forces that were tried";
    return "there is no window";
  }

 private:
  const StrategyWindow& strategy_;
};

/// The sheet of one strategy.
class Sheet {
 public:
  Sheet(const StrategyWindow& strategy, Load load)
      : strategy_(strategy), window_(strategy), load_(std::move(load)) {}

  std::vector<Item> items() {
    add_load();
    add_rules();
    add_simulated();
    add_stop();
    add_limits();
    return std::move(items_);
  }

 private:
  void add(Item item) { items_.push_back(std::move(item)); }

  void add_load() {
    add({.item = "mass", .value = load_.mass_kg, .units = "kg", .says = "of the product"});
    add({.item = "friction", .value = load_.friction, .units = "1", .says = "between product and pads"});
    add({.item = "acceleration",
         .value = load_.acceleration_m_s2,
         .units = "m s-2",
         .says = "the largest of lift, transfer and lowering"});
    add({.item = "fingers", .value = load_.fingers, .units = "1", .says = "that press on the product"});
    add({.item = "safety_factor",
         .value = load_.safety(),
         .units = "1",
         .says = load_.gripper.safety_factor ? "the maker's" : "assumed; makers write 2 to 4"});
  }

  /// @param asks "the maker's rule ... asks for"
  void add_rule(const std::string& item, double force_N, const std::string& asks) {
    const std::string verdict = window_.verdict(force_N);
    add({.item = item,
         .value = force_N,
         .units = "N",
         .together = load_.fingers * force_N,
         .verdict = verdict,
         .says = joined({asks, " ", newtons(force_N), " on each of ", three_digits(load_.fingers), " fingers, ",
                         newtons(load_.fingers * force_N), " together, ", Window::remark(verdict)})});
  }

  void add_rules() {
    const double least_N = load_.just_holds_N(load_.acceleration_m_s2);
    add_rule("just_holds", least_N, "friction alone, m (g + a) / mu, asks for");
    add_rule("maker_rule", load_.safety() * least_N,
             joined({"the makers' rule, m (g + a) S / mu with S = ", three_digits(load_.safety()),
                     load_.gripper.safety_factor ? "" : " (assumed)", ", asks for"}));
    add_rule("pneumatic_rule", kPneumaticFactor * load_.mass_kg * load_.gravity_m_s2 / load_.fingers,
             "the rule of thumb for pneumatic grippers, 13 m g, asks for");
  }

  void add_force(const std::string& item, double force_N, std::string says) {
    add({.item = item,
         .value = force_N,
         .units = "N",
         .together = load_.fingers * force_N,
         .says = std::move(says)});
  }

  void add_simulated() {
    add_force("hold", strategy_.hold_force_N,
              strategy_.hold_is_bound ? "simulated: the least force tried holds already"
                                      : "simulated: holds from there on");
    add_force("set_point", strategy_.set_point.force_N, strategy_.set_point.sentence);
    if (std::isnan(strategy_.damage_force_N)) return;  // nobody judged it
    add_force("damage", strategy_.damage_force_N,
              strategy_.damage_is_bound ? "simulated: the greatest force tried does not mark it"
                                        : "simulated: marks beyond it");
    const double margin = strategy_.damage_force_N / strategy_.hold_force_N;
    add({.item = "margin",
         .value = margin,
         .units = "1",
         .says = "the force that marks over the force that holds"});
  }

  /// The force the sheet reckons with: what is to be set, else what just holds.
  [[nodiscard]] double used_N() const {
    return strategy_.set_point.exists ? strategy_.set_point.force_N : strategy_.hold_force_N;
  }

  void add_stop() {
    const double needs_N = load_.just_holds_N(load_.stop_m_s2);
    const std::string verdict = std::isnan(used_N()) ? "not known" : used_N() >= needs_N ? "held" : "slips";
    add({.item = "emergency_stop",
         .value = needs_N,
         .units = "N",
         .together = load_.fingers * needs_N,
         .limit = used_N(),
         .verdict = verdict,
         .says = joined({"an emergency stop with ", three_digits(load_.stop_m_s2),
                         " m/s2 while the product is lowered needs m (g + a) / mu, ", newtons(needs_N),
                         " on each finger; ", newtons(used_N()), stop_remark(verdict)})});
  }
  [[nodiscard]] std::string stop_remark(const std::string& verdict) const {
    if (verdict == "held") return " hold it";
    const double holds_m_s2 = used_N() * load_.fingers * load_.friction / load_.mass_kg - load_.gravity_m_s2;
    return verdict == "slips" ? joined({" hold ", three_digits(std::max(0.0, holds_m_s2)), " m/s2"}) : "";
  }

  /// @param key what the gripper's file has to give
  void add_limit(const std::string& item, double value, const std::string& units,
                 const std::optional<double>& limit, const std::string& what, const std::string& key) {
    const std::string verdict = !limit              ? "not given"
                                : std::isnan(value) ? "not known"
                                : value <= *limit   ? "within"
                                                    : "beyond";
    const std::string unit = units == "kg" ? " kg" : units == "N" ? " N" : " N m";
    std::string says = joined({what, ", ", three_digits(value), unit});
    says += limit ? joined({verdict == "beyond" ? ", is more than" : " of", " the ", three_digits(*limit), unit,
                            " that the gripper's file allows"})
                  : joined({"; gripper.", key, " is not given"});
    add({.item = item,
         .value = value,
         .units = units,
         .limit = limit.value_or(kAbsent),
         .verdict = verdict,
         .says = std::move(says)});
  }

  void add_limits() {
    const ParallelJawParameters& g = load_.gripper;
    add_limit("largest_force", used_N(), "N", g.max_force_N, "the force of a finger", "max_force_N");
    add_limit("payload", load_.mass_kg, "kg", g.payload_kg, "the mass carried by friction", "payload_kg");
    const double lever_m = g.finger_length_m.value_or(kAbsent);
    add_limit("jaw_moment", lever_m * used_N(), "N m", g.jaw_moment_N_m,
              "the moment on a jaw, finger_length_m times the force",
              g.finger_length_m ? "jaw_moment_N_m" : "finger_length_m");
  }

  const StrategyWindow& strategy_;
  Window window_;
  Load load_;
  std::vector<Item> items_;
};

/// That of the rows that asks for most.
Load largest_load(const StrategyWindow& strategy, const ScenarioOfRow& scenario) {
  Load largest;
  double most_N = -1.0;
  for (const std::size_t row : strategy.rows) {
    Load load = load_of(scenario(row));
    const double least_N = load.just_holds_N(load.acceleration_m_s2);
    if (!(least_N > most_N)) continue;
    most_N = least_N;
    largest = std::move(load);
  }
  return largest;
}

}  // namespace

ResultTable sizing_table(const WindowAnswer& answer, const ScenarioOfRow& scenario) {
  std::vector<double> strategy, value, together, limit;
  std::vector<std::string> item, units, verdict, says;
  bool turns = false;
  for (std::size_t i = 0; i < answer.strategies.size(); ++i) {
    Load load = largest_load(answer.strategies[i], scenario);
    turns = turns || load.turns;
    for (Item& each : Sheet(answer.strategies[i], std::move(load)).items()) {
      strategy.push_back(static_cast<double>(i));
      value.push_back(each.value);
      together.push_back(each.together);
      limit.push_back(each.limit);
      item.push_back(std::move(each.item));
      units.push_back(std::move(each.units));
      verdict.push_back(std::move(each.verdict));
      says.push_back(std::move(each.says));
    }
  }
  ResultTable table{.name = kSizingTable, .row = "sizing_item", .columns = {}, .attributes = {}};
  table.columns = {{"strategy", "1", "row of /set_points", std::move(strategy)},
                   {"item", "", "what the line is about", std::move(item)},
                   {"value", "", "its number; a force is that of one finger", std::move(value)},
                   {"units", "", "of value and limit", std::move(units)},
                   {"together", "N", "a force of all fingers together", std::move(together)},
                   {"limit", "", "what the value is held against", std::move(limit)},
                   {"verdict", "", "how it stands", std::move(verdict)},
                   {"says", "", "the line in words", std::move(says)}};
  if (turns) table.attributes.emplace_back("note", "the rules are those of an upright grip; this one turns");
  return table;
}

std::vector<std::string> sizing_lines(const std::vector<ResultTable>& tables) {
  std::vector<std::string> lines;
  const ResultTable *table = find_table(tables, kSizingTable), *answer = find_table(tables, "set_points");
  if (table == nullptr || answer == nullptr || row_count(*answer) == 0) return lines;
  double shown = 0.0;
  for (std::size_t i = row_count(*answer); i-- > 0;) {
    if (number_in(*answer, "best", i) == 1.0) shown = static_cast<double>(i);
  }
  for (std::size_t i = 0; i < row_count(*table); ++i) {
    const std::string item = text_in(*table, "item", i), verdict = text_in(*table, "verdict", i);
    const bool told =
        item == "maker_rule" || item == "pneumatic_rule" || verdict == "slips" || verdict == "beyond";
    if (told && number_in(*table, "strategy", i) == shown)
      lines.push_back(joined({"sizing: ", text_in(*table, "says", i)}));
  }
  if (const std::string note = text_attribute(*table, "note"); !note.empty())
    lines.push_back(joined({"sizing: ", note}));
  return lines;
}

}  // namespace unbruised::studies

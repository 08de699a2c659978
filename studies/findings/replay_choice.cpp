#include "studies/findings/replay_choice.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <optional>
#include <utility>

#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

using Rows = std::vector<ScenarioRow>;

/// Range of each input over the rows; 0 where it is a text or has one value.
std::vector<double> ranges_of(const Rows& rows) {
  std::vector<double> low, high;
  for (const ScenarioRow& row : rows) {
    low.resize(std::max(low.size(), row.inputs.size()), std::numeric_limits<double>::infinity());
    high.resize(low.size(), -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < row.inputs.size(); ++i) {
      const auto* number = std::get_if<double>(&row.inputs[i]);
      if (number == nullptr || !std::isfinite(*number)) continue;
      low[i] = std::min(low[i], *number);
      high[i] = std::max(high[i], *number);
    }
  }
  std::vector<double> ranges;
  for (std::size_t i = 0; i < low.size(); ++i) ranges.push_back(high[i] > low[i] ? high[i] - low[i] : 0.0);
  return ranges;
}

/// How far a row is from another: inputs that differ beside the grip force, and by how much all of them do.
struct Distance {
  int others = 0;
  double sum = 0.0;
  friend auto operator<=>(const Distance&, const Distance&) = default;
};

class Inputs {
 public:
  Inputs(const std::vector<ColumnInfo>& columns, const Rows& rows) : ranges_(ranges_of(rows)) {
    const auto force = std::find_if(columns.begin(), columns.end(),
                                    [](const ColumnInfo& each) { return each.key == "strategy.grip_force_N"; });
    force_ = static_cast<std::size_t>(force - columns.begin());
  }

  [[nodiscard]] Distance distance(const ScenarioRow& a, const ScenarioRow& b) const {
    Distance found;
    for (std::size_t i = 0; i < std::min(a.inputs.size(), b.inputs.size()); ++i) {
      if (a.inputs[i] == b.inputs[i]) continue;
      if (i != force_) ++found.others;
      const auto* x = std::get_if<double>(&a.inputs[i]);
      const auto* y = std::get_if<double>(&b.inputs[i]);
      const bool measured = x != nullptr && y != nullptr && ranges_[i] > 0.0;
      found.sum += measured ? std::abs(*x - *y) / ranges_[i] : 1.0;
    }
    return found;
  }

  /// Nothing where the force is no input.
  [[nodiscard]] std::optional<double> force_N(const ScenarioRow& row) const {
    const auto* force = force_ < row.inputs.size() ? std::get_if<double>(&row.inputs[force_]) : nullptr;
    return force == nullptr || !(*force > 0.0) ? std::nullopt : std::optional(*force);
  }

 private:
  std::vector<double> ranges_;
  std::size_t force_ = 0;
};

/// The row that comes first of those that are wanted; nullptr: none.
template <class Wanted, class Measure>
const ScenarioRow* least(const Rows& rows, const Wanted& wanted, const Measure& measure) {
  const ScenarioRow* found = nullptr;
  for (const ScenarioRow& row : rows) {
    if (wanted(row) && (found == nullptr || measure(row) < measure(*found))) found = &row;
  }
  return found;
}

bool is_damaged(const ScenarioRow& row) { return row.result.outcome == Outcome::damaged; }

bool is_lost(const ScenarioRow& row) {
  return row.result.outcome == Outcome::dropped || row.result.outcome == Outcome::slipped ||
         row.result.outcome == Outcome::not_grasped;
}

/// Of the held rows that differ from the fastest one in the grip force alone, the one in the middle; nullptr:
/// none.
const ScenarioRow* best_held(const Inputs& inputs, const Rows& rows) {
  const ScenarioRow* fastest = least(
      rows,
      [](const ScenarioRow& row) {
        return row.result.outcome == Outcome::held && !std::isnan(row.result.metrics[Metric::cycle_time_s]);
      },
      [](const ScenarioRow& row) { return std::pair(row.result.metrics[Metric::cycle_time_s], row.id); });
  if (fastest == nullptr || !inputs.force_N(*fastest)) return fastest;
  const auto beside = [&](const ScenarioRow& row) {
    return row.result.outcome == Outcome::held && inputs.force_N(row) &&
           inputs.distance(*fastest, row).others == 0;
  };
  const auto force_N = [&](const ScenarioRow& row) { return *inputs.force_N(row); };
  double low_N = force_N(*fastest), high_N = low_N;
  for (const ScenarioRow& row : rows) {
    if (!beside(row)) continue;
    low_N = std::min(low_N, force_N(row));
    high_N = std::max(high_N, force_N(row));
  }
  const double middle_N = std::sqrt(low_N * high_N);
  return least(rows, beside, [&](const ScenarioRow& row) { return std::abs(std::log(force_N(row) / middle_N)); });
}

}  // namespace

std::vector<ChosenReplay> chosen_replays(const std::vector<ColumnInfo>& inputs, const Rows& rows,
                                         const std::vector<std::uint64_t>& asked) {
  std::vector<ChosenReplay> chosen;
  const auto add = [&chosen](std::uint64_t id, const std::string& why) {
    const auto same = [id](const ChosenReplay& each) { return each.id == id; };
    if (std::none_of(chosen.begin(), chosen.end(), same)) chosen.push_back({id, why});
  };
  for (const std::uint64_t id : asked) add(id, "asked for");
  const Inputs columns(inputs, rows);
  const ScenarioRow* anchor = best_held(columns, rows);
  if (anchor != nullptr) add(anchor->id, rows.size() == 1 ? "the scenario" : "best held");
  if (anchor == nullptr) {
    anchor = least(rows, is_damaged,
                   [](const ScenarioRow& row) { return row.result.metrics[Metric::plastic_strain_max]; });
    if (anchor != nullptr) add(anchor->id, "least damaged");
  }
  if (anchor == nullptr) {
    anchor = least(
        rows, [](const ScenarioRow& row) { return row.result.outcome != Outcome::not_run; },
        [](const ScenarioRow&) { return 0.0; });
    if (anchor == nullptr) return chosen;
    add(anchor->id, joined({"first ", outcome_word(anchor->result.outcome)}));
  }
  const auto from_anchor = [&](const ScenarioRow& row) { return columns.distance(*anchor, row); };
  for (const auto& wanted : {is_lost, is_damaged}) {
    const ScenarioRow* near = least(rows, wanted, from_anchor);
    if (near != nullptr) add(near->id, joined({"nearest ", outcome_word(near->result.outcome)}));
  }
  return chosen;
}

}  // namespace unbruised::studies

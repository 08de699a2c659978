#include "studies/config/doubts.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "core/outcome/damage_limits.hpp"
#include "core/scenario/plausible.hpp"
#include "studies/config/execution_error.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/key_names.hpp"

namespace unbruised::studies {
namespace {

/// Quantiles that count as the ends of what is drawn: what one product in a hundred has is plausible or not.
constexpr double kLowQuantile = 0.01;
constexpr double kHighQuantile = 0.99;

/// A key and an end of its values.
struct End {
  std::string name;  ///< the key, or the name of an error around its value
  double value;
  std::string key;
  std::string written_as;  ///< the key that the end was written with
};

std::vector<End> ends_of(const StudyData& data) {
  std::vector<End> ends;
  const auto add = [&](const std::string& key, double low, double high) {
    for (const double end : {low, high}) ends.push_back({key, end, key_behind(key), key_behind(key)});
  };
  for (const InputColumn& input : data.inputs) {
    if (input.is_text || input.numbers.empty()) continue;
    const auto [low, high] = std::minmax_element(input.numbers.begin(), input.numbers.end());
    add(input.key, *low, *high);
  }
  for (const SearchVariable& v : data.variables) add(v.key, v.from, v.to);
  for (const RandomVariable& r : data.randoms) {
    add(r.key, quantile(r.distribution, kLowQuantile), quantile(r.distribution, kHighQuantile));
  }
  if (searches_force(data.settings.kind)) {
    const std::string key = kGripForceKey;
    ends.push_back({key, data.settings.window.from_N, key, "window.from_N"});
    ends.push_back({key, data.settings.window.to_N, key, "window.to_N"});
  }
  return ends;
}

bool follows_from(const PlausibleRow& row, std::string_view key) {
  return std::find(row.fields.begin(), row.fields.end(), key.substr(0, key.find('['))) != row.fields.end();
}

/// Collects one sentence for each row of the list.
class Collector {
 public:
  explicit Collector(std::vector<End> ends) : ends_(std::move(ends)) {}

  /// What is said of the first scenario moved to an end, by rows that follow from the key of that end.
  void look_at_ends(const Scenario& first) {
    for (const End& end : ends_) {
      const Scenario scenario = Study::with_values(first, {&end.name, 1}, {&end.value, 1});
      for (Implausible& found : implausible_values(scenario)) {
        if (!follows_from(*found.row, end.key)) continue;
        const std::string where = place(found, scenario, end);
        if (found.measured.key == end.key) found.measured.key = end.written_as;
        say(found, where);
      }
    }
  }

  void look_at(const Scenario& scenario) {
    for (const Implausible& found : implausible_values(scenario)) say(found, "");
  }

  [[nodiscard]] std::vector<std::string> take() { return std::move(sentences_); }

 private:
  void say(const Implausible& found, const std::string& where) {
    if (rows_.insert(found.row).second) sentences_.push_back(found.sentence() + where);
  }

  /// " (at product.size_m[1] = 0.012)": the values of the other keys that vary and that the row follows from.
  [[nodiscard]] std::string place(const Implausible& found, Scenario scenario, const End& here) const {
    std::vector<std::string> where;
    std::set<std::string> told = {found.measured.key};
    for (const End& end : ends_) {
      if (!follows_from(*found.row, end.key) || !told.insert(end.key).second) continue;
      const KeyAddress address = find_key(end.key);
      const auto value = number_at(address.spec->field(scenario, address.index), address.elements);
      if (!value) continue;
      const std::string& name = end.key == here.key ? here.written_as : end.key;
      where.push_back(name + " = " + rounded(*value));
    }
    return where.empty() ? std::string() : " (at " + comma_list(where) + ")";
  }

  std::vector<End> ends_;
  std::set<const PlausibleRow*> rows_;
  std::vector<std::string> sentences_;
};

std::vector<std::string> implausible(const StudyData& data) {
  Collector collector(ends_of(data));
  const Scenario first = data.scenario(0);
  collector.look_at_ends(first);
  collector.look_at(first);
  for (const Scenario& base : data.bases) collector.look_at(base);
  for (const StrategyCandidate& candidate : data.candidates) collector.look_at(candidate.scenario);
  return collector.take();
}

/// Limits that nothing can ever exceed, and a product that nothing can hold.
std::vector<std::string> without_effect(const Scenario& scenario) {
  std::vector<std::string> out;
  const std::string never = idle_limits(scenario);
  if (!never.empty()) {
    out.push_back(never + (can_yield(scenario) ? ": never exceeded without a gripper"
                                               : ": never exceeded, the product has no yield stress"));
  }
  const auto* p = std::get_if<LatticeParameters>(&scenario.product);
  if (has_gripper(scenario) && p != nullptr && p->friction == 0.0) {
    out.emplace_back("product.friction is 0: no grip force can hold the product");
  }
  return out;
}

}  // namespace

std::string idle_limits(const Scenario& scenario) {
  std::vector<std::string> never;
  for (const DamageLimit& limit : kDamageLimits) {
    if (bound_of(limit, scenario.limits) && !can_act(limit, scenario)) never.emplace_back(limit.key);
  }
  return comma_list(never);
}

std::vector<std::string> doubts(const StudyData& data) {
  std::vector<std::string> all = without_effect(data.scenario(0));
  const bool is_together =
      !data.correlations.empty() || std::any_of(data.randoms.begin(), data.randoms.end(),
                                                [](const RandomVariable& random) { return !random.zip.empty(); });
  if (is_together && row_of(data.settings.kind).scenarios == ScenarioSource::design) {
    all.emplace_back(
        "Morris' method moves one key at a time: which keys vary together ([[correlation]], rows of data) plays "
        "no part in "
        "it");
  }
  for (std::string& sentence : implausible(data)) all.push_back(std::move(sentence));
  return all;
}

}  // namespace unbruised::studies

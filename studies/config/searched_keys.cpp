#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "core/simulation/simulation.hpp"
#include "studies/config/execution_error.hpp"
#include "studies/config/search_parts.hpp"
#include "studies/statistics/distribution.hpp"
#include "studies/text/key_names.hpp"

namespace unbruised::studies {
namespace {

/// Can the key take any number of a range? Else why not.
std::optional<std::string> why_not_numeric(const std::string& key) {
  const KeyAddress address = find_key(key);
  if (address.spec == nullptr) return unknown_key_rule(key);
  const KeySpec& spec = *address.spec;
  const bool plain = spec.type == KeyType::number || spec.type == KeyType::optional_number;
  const bool array = is_number_array(spec.type);
  if (spec.field == nullptr || (!plain && !array)) return "must be a key with a number";
  if (array && address.elements.empty()) return "name one element: \"" + key + "[0]\"";
  return std::nullopt;
}

std::string units_of(const std::string& key) {
  const Unit* unit = unit_of(key);
  return unit == nullptr ? "1" : std::string(unit->udunits);
}

FieldRef field_of(Scenario& scenario, const KeyAddress& address) {
  return address.spec->field(scenario, address.index);
}

/// The variables and random keys of a study, from their blocks.
class SearchedKeys {
 public:
  explicit SearchedKeys(const SearchInput& input)
      : data_(input.data), read_(input.read), base_(input.base), problems_(input.problems) {}

  /// @param list "variable", or "parameter": keys that are fitted
  void add_variables(const std::string& list, const std::vector<VariableBlock>& blocks) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const VariableBlock& block = blocks[i];
      if (!check_key(list, i, block.key, block.origin) || !block.from || !block.to) continue;
      const std::string name = list + "[" + std::to_string(i) + "].";
      const auto complain = [&](const char* leaf, double value, const std::string& rule) {
        problems_.add(block.origin, name + leaf, spelled(value), rule);
        return false;
      };
      const KeySpec& spec = *find_key(block.key).spec;
      bool sound = true;
      if (!(*block.from < *block.to))
        sound = complain("from", *block.from, "must be < to = " + spelled(*block.to));
      if (block.scale == VaryScale::log && *block.from <= 0.0) {
        sound = complain("from", *block.from, "\"log\" needs from > 0");
      }
      for (const auto& [leaf, value] : {std::pair{"from", *block.from}, std::pair{"to", *block.to}}) {
        if (!spec.range.contains(value)) {
          sound = complain(leaf, value, block.key + " must be " + spec.range.text());
        }
      }
      if (block.start && sound && (*block.start < *block.from || *block.start > *block.to)) {
        sound = complain("start", *block.start, "must lie between from and to");
      }
      if (!sound) continue;
      data_.variables.push_back(
          {.key = block.key,
           .units = units_of(block.key),
           .from = *block.from,
           .to = *block.to,
           .scale = block.scale == VaryScale::log ? optimizer::Scale::log : optimizer::Scale::linear,
           .start = block.start});
      give_base(block.key, block.start.value_or(middle(data_.variables.back())), *block.to);
    }
  }

  void add_randoms() {
    for (std::size_t i = 0; i < read_.blocks.random.size(); ++i) {
      const RandomBlock& block = read_.blocks.random[i];
      if (error_kind(block)) {
        add_error(block, i);
        continue;
      }
      if (!check_key("random", i, block.key, block.origin)) continue;
      if (!read_.random_sound[i] || !check_candidates_agree(block.key, i)) continue;
      const auto distribution = distribution_of(block, i, read_.random_keys[i], problems_);
      if (!distribution || !check_support(block, i, *distribution)) continue;
      give_base(block.key, quantile(*distribution, 0.5), quantile(*distribution, kRareHigh));
      add_random({block.key, units_of(block.key), *distribution, false});
      if (distribution->kind == DistributionKind::data) add_rows(block, i);
    }
    leave_lone_rows();
  }

 private:
  [[nodiscard]] bool is_taken(const std::string& key) const {
    return std::any_of(data_.variables.begin(), data_.variables.end(),
                       [&](const SearchVariable& v) { return v.key == key; }) ||
           std::any_of(data_.randoms.begin(), data_.randoms.end(),
                       [&](const RandomVariable& r) { return key_behind(r.key) == key; });
  }

  /// Reports what is wrong with the key of a block.
  bool check_key(const std::string& list, std::size_t i, const std::string& key, const Origin& origin) {
    if (key.empty()) return false;  // reported as missing
    const std::string path = list + "[" + std::to_string(i) + "].key";
    if (const auto rule = why_not_numeric(key)) {
      problems_.add(origin, path, toml_string(key), *rule);
      return false;
    }
    if (is_taken(key)) {
      problems_.add(origin, path, toml_string(key), "is searched or drawn twice");
      return false;
    }
    // A field that is not there has been reported with the scenario.
    const KeyAddress address = find_key(key);
    Scenario& base = data_.bases.front();
    return has_field(*address.spec, base, address.index) && has_element(field_of(base, address), address.elements);
  }

  static double middle(const SearchVariable& variable) {
    const bool log = variable.scale == optimizer::Scale::log;
    return log ? std::sqrt(variable.from * variable.to) : 0.5 * (variable.from + variable.to);
  }

  /// A key that is not written gets a value inside its range, so that the base is one of the scenarios that are
  /// asked for. `contact_force_N` is lowered to the grip force when a scenario is made; the base keeps as much of
  /// it as any needs.
  void give_base(const std::string& key, double value, double highest) {
    const KeyAddress address = find_key(key);
    const bool is_written = base_.given.contains(key) || base_.given.contains(key.substr(0, key.rfind('[')));
    const auto give = [&](Scenario& scenario) {
      const FieldRef field = field_of(scenario, address);
      if (is_written && number_at(field, address.elements)) return;
      StrategyParameters& strategy = scenario.strategy;
      const bool is_grip = key == kGripForceKey;
      const double given = is_grip ? std::min(highest, std::max(value, strategy.contact_force_N)) : value;
      assign_number(field, given, address.elements);
      strategy.contact_force_N = std::min(strategy.contact_force_N, strategy.grip_force_N);
    };
    for (Scenario& base : data_.bases) give(base);
    for (StrategyCandidate& candidate : data_.candidates) give(candidate.scenario);
  }

  void add_random(RandomVariable random) {
    const auto factor_at = [&](double u) {
      const std::array<double, 1> value = {quantile(random.distribution, u)};
      return factor_key(Study::with_values(data_.bases.front(), {&random.key, 1}, value));
    };
    // The quartiles of data may be one value.
    const bool is_data = random.distribution.kind == DistributionKind::data;
    random.changes_factor = factor_at(is_data ? kRareLow : 0.25) != factor_at(is_data ? kRareHigh : 0.75);
    data_.randoms.push_back(std::move(random));
  }

  /// Blocks with one word, or of one file, take the same row.
  void add_rows(const RandomBlock& block, std::size_t i) {
    RandomVariable& random = data_.randoms.back();
    random.zip = block.zip.empty() ? block.file : block.zip;
    if (random.zip.empty()) return;
    random.rows = block.data;
    const auto other = std::find_if(data_.randoms.begin(), data_.randoms.end(),
                                    [&](const RandomVariable& r) { return r.zip == random.zip; });
    if (other->rows.size() == random.rows.size()) return;
    problems_.add(block.origin, "random[" + std::to_string(i) + "].zip", toml_string(random.zip),
                  "blocks that are zipped need equal numbers of values, here " +
                      std::to_string(random.rows.size()) + " and " + std::to_string(other->rows.size()));
  }

  /// A key that shares its rows with no other is drawn by its values alone.
  void leave_lone_rows() {
    for (RandomVariable& random : data_.randoms) {
      const auto sharing = std::count_if(data_.randoms.begin(), data_.randoms.end(),
                                         [&](const RandomVariable& r) { return r.zip == random.zip; });
      if (sharing > 1) continue;
      random.zip.clear();
      random.rows.clear();
    }
  }

  /// An error around the values that a key has in this study.
  void add_error(const RandomBlock& block, std::size_t i) {
    if (!read_.random_sound[i] || block.key.empty()) return;
    const ErrorKind kind = *error_kind(block);
    if (const auto rule = why_no_error(block, i)) {
      problems_.add(block.origin, "random[" + std::to_string(i) + "].key", toml_string(block.key), *rule);
      return;
    }
    const std::string name = error_name({block.key, kind});
    add_random({name, kind == ErrorKind::relative ? "1" : units_of(block.key), error_distribution(block), false});
  }

  std::optional<std::string> why_no_error(const RandomBlock& block, std::size_t i) {
    if (const auto rule = why_not_numeric(block.key)) return rule;
    if (!block.key.starts_with("strategy.") && !block.key.starts_with("cell.")) {
      return "relative and absolute are errors of keys of [strategy] and [cell]; give a distribution of its "
             "values";
    }
    for (const std::string& leaf : read_.random_keys[i]) {
      if (leaf != "key" && leaf != "distribution" && leaf != (block.relative ? "relative" : "absolute")) {
        return leaf + " does not go with an error; give relative or absolute, and distribution";
      }
    }
    if (block.distribution == DistributionKind::lognormal || block.distribution == DistributionKind::data) {
      return "an error is uniform, normal or triangular";
    }
    const bool taken = std::any_of(data_.randoms.begin(), data_.randoms.end(), [&](const RandomVariable& random) {
      return key_behind(random.key) == block.key;
    });
    if (taken) return "is drawn twice";
    return why_error_leaves_range(block);
  }

  /// The error moves what is searched, what the candidates have, or what is written.
  std::optional<std::string> why_error_leaves_range(const RandomBlock& block) {
    const KeySpec& spec = *find_key(block.key).spec;
    const std::string name = error_name({block.key, *error_kind(block)});
    const double most = error_distribution(block).kind == DistributionKind::normal
                            ? error_distribution(block).at_most
                            : error_distribution(block).to;
    for (Scenario scenario : scenarios_with_ends(block.key)) {
      if (!number_in(scenario, block.key)) return "has no value for an error to act on";
      for (const double error : {-most, most}) {
        Scenario moved = scenario;
        apply_named(moved, name, error);
        const double value = *number_in(moved, block.key);
        if (!spec.range.contains(value)) {
          return "values outside '" + spec.range.text() + "' are possible (" + rounded(value) + ")";
        }
      }
    }
    return std::nullopt;
  }

  static std::optional<double> number_in(Scenario& scenario, const std::string& key) {
    const KeyAddress address = find_key(key);
    if (!has_field(*address.spec, scenario, address.index)) return std::nullopt;
    return number_at(field_of(scenario, address), address.elements);
  }

  /// The base, or with the key at both ends where it is searched, and the candidates.
  std::vector<Scenario> scenarios_with_ends(const std::string& key) {
    std::vector<Scenario> scenarios = {data_.bases.front()};
    for (const SearchVariable& v : data_.variables) {
      if (v.key != key) continue;
      for (const double end : {v.from, v.to}) {
        scenarios.push_back(data_.bases.front());
        apply_named(scenarios.back(), key, end);
      }
    }
    for (const StrategyCandidate& candidate : data_.candidates) scenarios.push_back(candidate.scenario);
    return scenarios;
  }

  /// A drawn key is the same for all candidates, so none of them may have its own.
  bool check_candidates_agree(const std::string& key, std::size_t i) {
    const KeyAddress address = find_key(key);
    const auto value_of = [&](StrategyCandidate& candidate) {
      return number_at(field_of(candidate.scenario, address), address.elements);
    };
    const bool agree = std::all_of(
        data_.candidates.begin(), data_.candidates.end(),
        [&](StrategyCandidate& candidate) { return value_of(candidate) == value_of(data_.candidates.front()); });
    if (agree) return true;
    problems_.add(read_.blocks.random[i].origin, "random[" + std::to_string(i) + "].key", toml_string(key),
                  "the candidates have values of their own, so it cannot be drawn");
    return false;
  }

  bool check_support(const RandomBlock& block, std::size_t i, const Distribution& distribution) {
    const Range& range = find_key(block.key).spec->range;
    for (const double u : {kRareLow, kRareHigh}) {
      const double value = quantile(distribution, u);
      if (range.contains(value)) continue;
      problems_.add(block.origin, "random[" + std::to_string(i) + "].key", toml_string(block.key),
                    distribution.kind == DistributionKind::data
                        ? "its data has values outside '" + range.text() + "' (" + rounded(value) + ")"
                        : "values outside '" + range.text() + "' are possible (" + rounded(value) +
                              "); truncate with at_least or at_most");
      return false;
    }
    return true;
  }

  StudyData& data_;
  const ReadBlocks& read_;
  const Assembly& base_;
  Problems& problems_;
};

}  // namespace

void add_searched_keys(const SearchInput& input) {
  SearchedKeys keys(input);
  keys.add_variables("variable", input.read.blocks.variable);
  keys.add_variables("parameter", input.read.blocks.parameter);
  keys.add_randoms();
}

}  // namespace unbruised::studies

#include "studies/config/searching.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/simulation/simulation.hpp"
#include "studies/config/execution_error.hpp"
#include "studies/config/rules.hpp"
#include "studies/statistics/distribution.hpp"

namespace unbruised::studies {
namespace {

/// Quantiles that count as the ends of an unbounded distribution.
constexpr double kRareLow = 1e-6;
constexpr double kRareHigh = 1.0 - 1e-6;
/// A rule that sees more keys than this is checked at two corners only.
constexpr std::size_t kCornerKeysMost = 10;
/// Room for the products of one question (the index of a search's place has 16 bits).
constexpr std::size_t kProductsPerQuestionMost = 65536;
/// Pairs of strategies are compared, and read.
constexpr std::size_t kCandidatesMost = 20;
/// Searches share the budget; by default each has this much.
constexpr std::uint64_t kEvaluationsPerSearch = 40;

// -- Blocks. -----------------------------------------------------------------------------------------------

struct BlockPlace {
  std::string list;  ///< "variable"
  std::size_t index = 0;
  std::string leaf;  ///< "key"; empty for the table itself
};

std::optional<BlockPlace> block_place(const std::string& path) {
  const std::size_t open = path.find('[');
  const std::size_t close = path.find(']');
  if (open == std::string::npos || close == std::string::npos) return std::nullopt;
  BlockPlace place{path.substr(0, open), 0, {}};
  for (std::size_t i = open + 1; i < close; ++i) {
    place.index = 10 * place.index + static_cast<std::size_t>(path[i] - '0');
  }
  if (path.size() > close + 2) place.leaf = path.substr(close + 2);
  return place;
}

class BlockReader {
 public:
  explicit BlockReader(Problems& problems) : problems_(problems) {}

  void open_table(const Entry& table) {
    const auto place = block_place(table.path);
    if (!place || !place->leaf.empty()) return;
    if (place->list == "variable") {
      out_.blocks.variable.emplace_back().origin = table.origin;
    } else if (place->list == "random") {
      out_.blocks.random.emplace_back().origin = table.origin;
      out_.random_keys.emplace_back();
    } else {
      out_.blocks.candidate.emplace_back().origin = table.origin;
      out_.candidate_entries.emplace_back();
    }
    given_[place->list].emplace_back();
  }

  void read(const Entry& entry) {
    const auto place = block_place(entry.path);
    const std::size_t count = place ? given_[place->list].size() : 0;
    if (!place || place->index >= count) {
      problems_.add(
          entry.origin, entry.path, spelled(entry.value),
          "there are " + std::to_string(count) + " [[" + (place ? place->list : "") + "]] blocks, counted from 0");
      return;
    }
    const KeyAddress address = find_key(entry.path);
    if (address.spec == nullptr) return read_foreign(entry, *place);
    std::set<std::string>& given = given_[place->list][place->index];
    if (const auto rule = check_value(*address.spec, entry.value, address.elements.size())) {
      problems_.add(entry.origin, entry.path, spelled(entry.value), *rule);
      given.insert(place->leaf);  // given, though wrong
      wrong_.emplace(place->list, place->index);
      return;
    }
    assign(*address.spec, address.spec->block_field(out_.blocks, static_cast<int>(place->index)), entry.value,
           address.elements);
    const bool taken_away = address.spec->type == KeyType::optional_number && !entry.value.is_number();
    if (taken_away) {
      given.erase(place->leaf);
    } else {
      given.insert(place->leaf);
    }
  }

  ReadBlocks finish() {
    report_missing("variable", out_.blocks.variable);
    report_missing("random", out_.blocks.random);
    report_missing("candidate", out_.blocks.candidate);
    for (std::size_t i = 0; i < out_.random_keys.size(); ++i) {
      out_.random_keys[i].assign(given_["random"][i].begin(), given_["random"][i].end());
      out_.random_sound.push_back(!wrong_.contains({"random", i}));
    }
    return std::move(out_);
  }

 private:
  /// Beside its own keys a candidate has those of [strategy].
  void read_foreign(const Entry& entry, const BlockPlace& place) {
    const std::string strategy = "strategy." + place.leaf;
    if (place.list == "candidate" && find_key(strategy).spec != nullptr) {
      out_.candidate_entries[place.index].push_back({strategy, entry.value, entry.origin});
      return;
    }
    std::vector<std::string> known;
    for (const std::string& pattern : key_patterns()) {
      if (pattern.starts_with(place.list + "[].")) known.push_back(pattern);
      if (place.list == "candidate" && pattern.starts_with("strategy.")) {
        known.push_back("candidate[]." + pattern.substr(std::string_view("strategy.").size()));
      }
    }
    const std::string near = nearest(entry.path, known);
    problems_.add(entry.origin, entry.path, spelled(entry.value),
                  near.empty() ? "unknown key" : "unknown key; did you mean '" + near + "'?");
  }

  template <class Blocks>
  void report_missing(const std::string& list, const Blocks& blocks) {
    for (const KeySpec& spec : key_table()) {
      if (!spec.required || !spec.path.starts_with(list + "[].")) continue;
      const std::string leaf(spec.path.substr(list.size() + 3));
      for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (given_[list][i].contains(leaf)) continue;
        problems_.add(blocks[i].origin, list + "[" + std::to_string(i) + "]." + leaf, "missing");
        wrong_.emplace(list, i);
      }
    }
  }

  Problems& problems_;
  ReadBlocks out_;
  std::map<std::string, std::vector<std::set<std::string>>> given_;
  std::set<std::pair<std::string, std::size_t>> wrong_;
};

// -- Keys. -------------------------------------------------------------------------------------------------

/// Can the key take any number of a range? Else why not.
std::optional<std::string> why_not_numeric(const std::string& key) {
  const KeyAddress address = find_key(key);
  if (address.spec == nullptr) return unknown_key_rule(key);
  const KeySpec& spec = *address.spec;
  const bool plain = spec.type == KeyType::number || spec.type == KeyType::optional_number;
  const bool array =
      spec.type == KeyType::numbers || spec.type == KeyType::series || spec.type == KeyType::vector_series;
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

std::string rounded(double value) {
  std::array<char, 32> text{};
  constexpr int kDigits = 6;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, kDigits);
  return {text.data(), end.ptr};
}

/// Completes a study from its blocks; the steps of `run` are its parts.
class Completion {
 public:
  Completion(StudyData& data, const ReadBlocks& read, const Assembly& base, Problems& problems)
      : data_(data), read_(read), base_(base), problems_(problems) {}

  void run() {
    refuse_foreign_blocks();
    check_counts();
    add_variables();
    add_randoms();
    if (is_search(kind())) add_search();
    if (kind() == StudyKind::compare) add_compare();
    if (kind() == StudyKind::sensitivity) add_sensitivity();
    data_.sampling = data_.settings.sampling;
    check_products_fit();
  }

 private:
  [[nodiscard]] StudyKind kind() const { return data_.settings.kind; }
  [[nodiscard]] std::string kind_word() const { return toml_string(study_kind_word(kind())); }

  template <class Blocks>
  void refuse_blocks(const Blocks& blocks, const std::string& list, Use use) {
    if (blocks.empty() || kind_uses(use, kind())) return;
    problems_.add(blocks.front().origin, "[[" + list + "]]", why_unused(use, data_.bases.front()));
  }

  void refuse_foreign_blocks() {
    refuse_blocks(read_.blocks.variable, "variable", Use::search);
    refuse_blocks(read_.blocks.random, "random", Use::random);
    refuse_blocks(read_.blocks.candidate, "candidate", Use::compare);
  }

  void check_counts() {
    const Origin origin = base_.origin_of("study.kind");
    const auto needs = [&](const char* what) {
      problems_.add(origin, "study.kind", kind_word(), std::string("needs ") + what);
    };
    if ((kind() == StudyKind::optimize || kind() == StudyKind::pareto) && read_.blocks.variable.empty()) {
      needs("[[variable]] blocks: what may be changed, and how far");
    }
    if (is_random(kind()) && read_.blocks.random.empty())
      needs("[[random]] blocks: what varies from product to product");
    const std::size_t candidates = read_.blocks.candidate.size();
    if (kind() == StudyKind::compare && (candidates < 2 || candidates > kCandidatesMost)) {
      needs("two or more [[candidate]] blocks, at most 20");
    }
  }

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

  void add_variables() {
    for (std::size_t i = 0; i < read_.blocks.variable.size(); ++i) {
      const VariableBlock& block = read_.blocks.variable[i];
      if (!check_key("variable", i, block.key, block.origin) || !block.from || !block.to) continue;
      const std::string name = "variable[" + std::to_string(i) + "].";
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
      const bool is_grip = key == "strategy.grip_force_N";
      const double given = is_grip ? std::min(highest, std::max(value, strategy.contact_force_N)) : value;
      assign_number(field, given, address.elements);
      strategy.contact_force_N = std::min(strategy.contact_force_N, strategy.grip_force_N);
    };
    for (Scenario& base : data_.bases) give(base);
    for (StrategyCandidate& candidate : data_.candidates) give(candidate.scenario);
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
      const auto distribution = distribution_of(block, i);
      if (!distribution || !check_support(block, i, *distribution)) continue;
      give_base(block.key, quantile(*distribution, 0.5), quantile(*distribution, kRareHigh));
      add_random({block.key, units_of(block.key), *distribution, false});
    }
  }

  void add_random(RandomVariable random) {
    const auto factor_at = [&](double u) {
      const std::array<double, 1> value = {quantile(random.distribution, u)};
      return factor_key(Study::with_values(data_.bases.front(), {&random.key, 1}, value));
    };
    random.changes_factor = factor_at(0.25) != factor_at(0.75);
    data_.randoms.push_back(std::move(random));
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
    if (block.distribution == DistributionKind::lognormal) return "an error is uniform, normal or triangular";
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

  /// Which keys a distribution takes, which it needs.
  std::optional<Distribution> distribution_of(const RandomBlock& block, std::size_t i) {
    const std::string name = "random[" + std::to_string(i) + "]";
    const bool by_moments =
        block.distribution == DistributionKind::normal || block.distribution == DistributionKind::lognormal;
    const bool is_triangular = block.distribution == DistributionKind::triangular;
    bool sound = true;
    const auto complain = [&](const std::string& leaf, const std::string& rule) {
      problems_.add(block.origin, name + leaf, rule);
      sound = false;
    };
    const auto given = [&](const char* leaf) {
      const std::vector<std::string>& keys = read_.random_keys[i];
      return std::find(keys.begin(), keys.end(), leaf) != keys.end();
    };
    for (const char* leaf : {"mean", "standard_deviation", "relative_deviation", "data"}) {
      if (given(leaf) && !by_moments) complain(std::string(".") + leaf, "goes with normal and lognormal only");
    }
    for (const char* leaf : {"from", "to"}) {
      if (given(leaf) && by_moments)
        complain(std::string(".") + leaf,
                 "goes with uniform and triangular only; truncate with at_least and at_most");
      if (!given(leaf) && !by_moments) complain(std::string(".") + leaf, "missing");
    }
    if (given("mode") != is_triangular) complain(".mode", is_triangular ? "missing" : "goes with triangular only");
    if (!given("distribution")) {
      complain(".distribution", "missing");
      return std::nullopt;
    }
    Distribution out{.kind = block.distribution};
    if (by_moments) {
      const int deviations = (given("standard_deviation") ? 1 : 0) + (given("relative_deviation") ? 1 : 0);
      if (given("data")) {
        if (given("mean") || deviations > 0) complain(".data", "excludes mean and deviations");
        if (block.data.size() < 3) complain(".data", "needs at least 3 values");
        const bool positive = std::all_of(block.data.begin(), block.data.end(), [](double x) { return x > 0.0; });
        if (block.distribution == DistributionKind::lognormal && !positive) {
          complain(".data", "values of a lognormal must be > 0");
        }
      } else {
        if (!given("mean")) complain(".mean", "missing; give mean and a deviation, or data");
        if (deviations != 1)
          complain(".standard_deviation", "give exactly one of standard_deviation and relative_deviation");
      }
      if (!sound) return std::nullopt;
      if (given("data")) {
        const MeanAndSpread measured = mean_and_spread(block.data);
        out.mean = measured.mean;
        out.standard_deviation = measured.standard_deviation;
      } else {
        out.mean = block.mean.value_or(0.0);
        out.standard_deviation =
            block.standard_deviation.value_or(block.relative_deviation.value_or(0.0) * std::abs(out.mean));
      }
    }
    if (!sound) return std::nullopt;
    out.from = block.from.value_or(out.from);
    out.to = block.to.value_or(out.to);
    out.mode = block.mode.value_or(out.mode);
    out.at_least = block.at_least.value_or(out.at_least);
    out.at_most = block.at_most.value_or(out.at_most);
    if (const auto rule = broken_rule(out)) {
      complain("", *rule);
      return std::nullopt;
    }
    return out;
  }

  bool check_support(const RandomBlock& block, std::size_t i, const Distribution& distribution) {
    const Range& range = find_key(block.key).spec->range;
    for (const double u : {kRareLow, kRareHigh}) {
      const double value = quantile(distribution, u);
      if (range.contains(value)) continue;
      problems_.add(block.origin, "random[" + std::to_string(i) + "].key", toml_string(block.key),
                    "values outside '" + range.text() + "' are possible (" + rounded(value) +
                        "); truncate with at_least or at_most");
      return false;
    }
    return true;
  }

  // -- Goals. ------------------------------------------------------------------------------------------------

  template <class Goal>
  std::optional<Goal> parsed(const std::string& path, const std::string& text, Parsed<Goal> goal) {
    if (auto* message = std::get_if<std::string>(&goal)) {
      // The place of an element is that of its array.
      const std::string key = path.substr(0, path.find('['));
      problems_.add(base_.origin_of(key), path, toml_string(text), *message);
      return std::nullopt;
    }
    return std::get<Goal>(std::move(goal));
  }

  static std::string element(const std::string& path, std::size_t i) {
    return path + "[" + std::to_string(i) + "]";
  }

  /// An empty value beside other mistakes may be one of them: it could not be read.
  template <class Text>
  [[nodiscard]] bool is_left_out(const Text& value) const {
    return value.empty() && !problems_.empty();
  }

  void add_search() {
    SearchTable& table = data_.settings.search;
    SearchSettings& search = data_.search;
    const bool robust = kind() == StudyKind::robust;
    const GoalContext context = robust ? GoalContext::sampled : GoalContext::single;
    set_defaults_by_kind(table);
    if (kind() == StudyKind::pareto) {
      add_objectives(table, search, context);
    } else if (!is_left_out(table.objective)) {
      auto goal = parsed("search.objective", table.objective, parse_objective(table.objective, context));
      if (goal) search.objective = std::move(*goal);
    }
    for (std::size_t i = 0; i < table.constraints.size(); ++i) {
      const std::string& text = table.constraints[i];
      auto goal = parsed(element("search.constraints", i), text, parse_constraint(text, context));
      if (goal) search.constraints.push_back(std::move(*goal));
    }
    // A list that says nothing about outcomes adds to `held`: nobody wants the fastest way to drop a product.
    const bool has_outcome = std::any_of(search.constraints.begin(), search.constraints.end(),
                                         [](const Constraint& c) { return c.kind != Constraint::Kind::metric; });
    if (!has_outcome && !table.constraints.empty()) {
      table.constraints.insert(table.constraints.begin(), held_rule(robust));
      search.constraints.insert(search.constraints.begin(),
                                std::get<Constraint>(parse_constraint(held_rule(robust), context)));
    }
    search.algorithm = table.algorithm;
    search.starts = table.starts;
    search.budget = table.budget;
    search.tolerance = table.tolerance;
    search.initial_step = table.initial_step;
    search.method = table.method;
    search.points = table.points;
    check_algorithm(table);
    check_budget(table);
  }

  void set_defaults_by_kind(SearchTable& table) const {
    const bool robust = kind() == StudyKind::robust;
    const auto given = [&](const char* key) { return base_.given.contains(key); };
    if (!given("search.objective")) table.objective = robust ? "mean(cycle_time_s)" : "cycle_time_s";
    if (!given("search.constraints")) table.constraints = {held_rule(robust)};
    if (robust && !given("search.starts")) table.starts = 4;
    if (robust && !given("search.budget")) table.budget = std::max<std::uint64_t>(100, table.starts);
    if (kind() == StudyKind::optimize && !given("search.budget"))
      table.budget = kEvaluationsPerSearch * table.starts;
    if (kind() != StudyKind::pareto) return;
    if (!given("search.starts")) table.starts = 2;
    if (!given("search.budget")) table.budget = kEvaluationsPerSearch * pareto_searches(table);
  }

  static std::string held_rule(bool robust) { return robust ? "P(held) >= 0.99" : "held"; }

  static std::uint64_t pareto_searches(const SearchTable& table) {
    return pareto_search_count(table.objectives.size(), table.points, table.starts);
  }

  void add_objectives(const SearchTable& table, SearchSettings& search, GoalContext context) {
    if (table.objectives.size() < 2 || table.objectives.size() > 3) {
      if (base_.given.contains("search.objectives") && !is_left_out(table.objectives)) {
        problems_.add(base_.origin_of("search.objectives"), "search.objectives", "must be two or three");
      }
      return;
    }
    for (std::size_t i = 0; i < table.objectives.size(); ++i) {
      const std::string& text = table.objectives[i];
      auto goal = parsed(element("search.objectives", i), text, parse_objective(text, context));
      if (goal) search.objectives.push_back(std::move(*goal));
    }
  }

  void check_algorithm(const SearchTable& table) {
    SearchSettings& search = data_.search;
    if (!table.local_algorithm.empty()) {
      search.local = optimizer::algorithm_named(table.local_algorithm);
      if (!search.local) {
        const KeySpec& words = *find_key("search.algorithm").spec;
        problems_.add(base_.origin_of("search.local_algorithm"), "search.local_algorithm",
                      toml_string(table.local_algorithm),
                      *check_value(words, text_value(table.local_algorithm), 0));
        return;
      }
    }
    if (data_.variables.empty() || data_.variables.size() != read_.blocks.variable.size()) return;
    std::size_t constraints = kind() == StudyKind::pareto ? 1 : 0;  // those of the method
    for (const Constraint& constraint : search.constraints) {
      constraints +=
          kind() == StudyKind::robust ? 1 : violation_names(constraint, data_.bases.front().limits).size();
    }
    const std::string why =
        optimizer::why_unsuitable(search.algorithm, search.local, data_.variables.size(), constraints);
    if (why.empty()) return;
    const bool is_local =
        search.local && (constraints == 0 || optimizer::info_of(search.algorithm).takes_constraints);
    const std::string key = is_local ? "search.local_algorithm" : "search.algorithm";
    problems_.add(base_.origin_of(key), key,
                  toml_string(optimizer::info_of(is_local ? *search.local : search.algorithm).name), why);
  }

  void check_budget(const SearchTable& table) {
    const std::uint64_t searches = kind() == StudyKind::pareto ? pareto_searches(table) : table.starts;
    if (table.budget >= searches) return;
    problems_.add(base_.origin_of("search.budget"), "search.budget", std::to_string(table.budget),
                  "must be >= the number of searches, " + std::to_string(searches));
  }

  void add_compare() {
    const CompareTable& table = data_.settings.compare;
    data_.compare.tie = table.tie;
    if (auto metric = parsed("compare.metric", table.metric, parse_metric(table.metric))) {
      data_.compare.metric = *metric;
    }
    data_.compare.metrics = {data_.compare.metric};
    for (const Metric metric : metrics_of("compare.metrics", table.metrics)) {
      if (metric != data_.compare.metric) data_.compare.metrics.push_back(metric);
    }
  }

  void add_sensitivity() {
    const SensitivityTable& table = data_.settings.sensitivity;
    data_.sensitivity = {.method = table.method,
                         .metrics = metrics_of("sensitivity.metrics", table.metrics),
                         .samples = table.samples,
                         .levels = table.levels,
                         .bootstrap = table.bootstrap,
                         .confidence = table.confidence};
    if (table.metrics.empty() && base_.given.contains("sensitivity.metrics") && !is_left_out(table.metrics)) {
      problems_.add(base_.origin_of("sensitivity.metrics"), "sensitivity.metrics", "must name a metric");
    }
    if (table.levels % 2 != 0) {
      problems_.add(base_.origin_of("sensitivity.levels"), "sensitivity.levels", std::to_string(table.levels),
                    "must be even");
    }
    const double runs = static_cast<double>(table.samples) * static_cast<double>(data_.randoms.size() + 2);
    if (runs > static_cast<double>(kMaxScenarios)) {
      problems_.add(base_.origin_of("sensitivity.samples"), "sensitivity.samples", std::to_string(table.samples),
                    "more than 10,000,000 scenarios");
    }
  }

  std::vector<Metric> metrics_of(const std::string& path, const std::vector<std::string>& names) {
    std::vector<Metric> metrics;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (const auto metric = parsed(element(path, i), names[i], parse_metric(names[i])))
        metrics.push_back(*metric);
    }
    return metrics;
  }

  void check_products_fit() {
    const std::uint64_t count = data_.sampling.count;
    const auto complain = [&](const std::string& rule) {
      problems_.add(base_.origin_of("sampling.count"), "sampling.count", std::to_string(count), rule);
    };
    if (kind() == StudyKind::robust) {
      const bool gradient = optimizer::info_of(data_.search.algorithm).uses_gradient ||
                            (data_.search.local && optimizer::info_of(*data_.search.local).uses_gradient);
      const std::size_t points = gradient ? 2 * data_.variables.size() + 1 : 1;
      if (count * points > kProductsPerQuestionMost) {
        complain("must be <= " + std::to_string(kProductsPerQuestionMost / points) + " for this search");
      }
    }
    if (kind() == StudyKind::compare &&
        count * std::max<std::size_t>(1, read_.blocks.candidate.size()) > kMaxScenarios) {
      complain("more than 10,000,000 scenarios");
    }
  }

  StudyData& data_;
  const ReadBlocks& read_;
  const Assembly& base_;
  Problems& problems_;
};

/// A key of the box with its two ends.
struct BoxSide {
  std::string key;
  double low;
  double high;
  Origin origin;
};

std::vector<BoxSide> box_sides(const StudyData& data, const ReadBlocks& read) {
  std::vector<BoxSide> sides;
  const auto keys = read.keys();
  const auto origin_of = [&](const std::string& key) {
    const std::string behind = key_behind(key);
    return std::find_if(keys.begin(), keys.end(), [&](const auto& item) { return item.first == behind; })->second;
  };
  for (const SearchVariable& v : data.variables) sides.push_back({v.key, v.from, v.to, origin_of(v.key)});
  for (const RandomVariable& r : data.randoms) {
    sides.push_back(
        {r.key, quantile(r.distribution, kRareLow), quantile(r.distribution, kRareHigh), origin_of(r.key)});
  }
  return sides;
}

void report(const Broken& broken, const Origin& origin, const std::string& where, Problems& problems) {
  if (broken.value.empty()) {
    problems.add(origin, broken.key, broken.rule + where);
  } else {
    problems.add(origin, broken.key, broken.value, broken.rule + where);
  }
}

/// Reports the first broken rule between the values of a network with each key at either end.
void check_network_ends(const std::vector<BoxSide>& sides, const Scenario& base, Problems& problems) {
  if (!std::holds_alternative<NetworkParameters>(base.product)) return;
  for (const BoxSide& side : sides) {
    const std::array<std::string, 1> key = {side.key};
    for (const double end : {side.low, side.high}) {
      const std::array<double, 1> value = {end};
      const Scenario scenario = Study::with_values(base, key, value);
      const auto broken = broken_network_rules(std::get<NetworkParameters>(scenario.product));
      if (broken.empty()) continue;
      report(broken.front(), side.origin, " (reached at " + side.key + " = " + rounded(end) + ")", problems);
      break;
    }
  }
}

/// Reports the candidates that break a rule.
void check_candidates(const CrossRule& rule, const StudyData& data, const ReadBlocks& read, Problems& problems) {
  for (std::size_t i = 0; i < data.candidates.size(); ++i) {
    const auto broken = rule.broken(data.candidates[i].scenario, data.settings);
    if (!broken) continue;
    report(*broken, read.blocks.candidate[i].origin, " (candidate " + toml_string(data.candidates[i].name) + ")",
           problems);
  }
}

/// Reports the rule at the first corner of the sides where it is broken.
void check_corners(const CrossRule& rule, const std::vector<BoxSide>& sides, const Scenario& base,
                   const StudySettings& settings, Problems& problems) {
  const bool all = sides.size() <= kCornerKeysMost;
  const std::size_t corners = all ? std::size_t{1} << sides.size() : 2;
  std::vector<std::string> keys;
  for (const BoxSide& side : sides) keys.push_back(side.key);
  for (std::size_t corner = 0; corner < corners; ++corner) {
    std::vector<double> values;
    std::string where;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const bool high = all ? ((corner >> k) & 1U) != 0 : corner != 0;
      values.push_back(high ? sides[k].high : sides[k].low);
      where += (where.empty() ? "" : ", ") + keys[k] + " = " + rounded(values.back());
    }
    const auto broken = rule.broken(Study::with_values(base, keys, values), settings);
    if (!broken) continue;
    report(*broken, sides.front().origin, " (reached at " + where + ")", problems);
    return;
  }
}

}  // namespace

std::vector<std::pair<std::string, Origin>> ReadBlocks::keys() const {
  std::vector<std::pair<std::string, Origin>> all;
  for (const VariableBlock& block : blocks.variable) all.emplace_back(block.key, block.origin);
  for (const RandomBlock& block : blocks.random) all.emplace_back(block.key, block.origin);
  return all;
}

ReadBlocks read_blocks(const std::vector<Entry>& entries, const std::vector<Entry>& tables, Problems& problems) {
  BlockReader reader(problems);
  for (const Entry& table : tables) reader.open_table(table);
  for (const Entry& entry : entries) reader.read(entry);
  return reader.finish();
}

void complete_search(StudyData& data, const ReadBlocks& read, const Assembly& base, Problems& problems) {
  Completion(data, read, base, problems).run();
}

void check_box_rules(const StudyData& data, const ReadBlocks& read, Problems& problems) {
  const std::vector<BoxSide> all = box_sides(data, read);
  check_network_ends(all, data.bases.front(), problems);
  for (const CrossRule& rule : cross_rules()) {
    check_candidates(rule, data, read, problems);
    std::vector<BoxSide> seen;
    std::copy_if(all.begin(), all.end(), std::back_inserter(seen), [&](const BoxSide& side) {
      const std::string_view path = find_key(key_behind(side.key)).spec->path;
      return std::find(rule.keys.begin(), rule.keys.end(), path) != rule.keys.end();
    });
    if (seen.empty()) continue;
    check_corners(rule, seen, data.bases.front(), data.settings, problems);
    for (const StrategyCandidate& candidate : data.candidates) {
      check_corners(rule, seen, candidate.scenario, data.settings, problems);
    }
  }
}

}  // namespace unbruised::studies

#include <algorithm>
#include <array>
#include <iterator>

#include "core/simulation/simulation.hpp"
#include "studies/config/execution_error.hpp"
#include "studies/config/rules.hpp"
#include "studies/config/search_parts.hpp"
#include "studies/config/searching.hpp"
#include "studies/statistics/distribution.hpp"

namespace unbruised::studies {
namespace {

/// A rule that sees more keys than this is checked at two corners only.
constexpr std::size_t kCornerKeysMost = 10;

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

#include "studies/config/box_rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "studies/config/execution_error.hpp"
#include "studies/config/rules.hpp"
#include "studies/config/search_parts.hpp"
#include "studies/statistics/distribution.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

/// A rule that sees more keys than this is checked at two corners only.
constexpr std::size_t kCornerKeysMost = 10;
/// Places inside the box where each rule is looked at beside its corners.
constexpr std::size_t kPlacesInside = 256;

void report(const Violations& all, const Origin& origin, const std::string& where, Problems& problems) {
  for (const Violation& broken : all) {
    if (broken.value.empty()) {
      problems.add(origin, broken.field, broken.rule + where);
    } else {
      problems.add(origin, broken.field, broken.value, broken.rule + where);
    }
  }
}

/// Reports the candidates that break a rule.
void check_candidates(const StudyRule& rule, const StudyData& data, const ReadBlocks& read, Problems& problems) {
  for (std::size_t i = 0; i < data.candidates.size(); ++i) {
    Violations broken;
    rule.check(data.candidates[i].scenario, data.settings, broken);
    report(broken, read.blocks.candidate[i].origin, " (candidate " + toml_string(data.candidates[i].name) + ")",
           problems);
  }
}

/// Places in the box of the sides, as parts of each from its low to its high end.
using BoxPlaces = std::vector<std::vector<double>>;

BoxPlaces corners_of(std::size_t sides) {
  const bool all = sides <= kCornerKeysMost;
  const std::size_t count = all ? std::size_t{1} << sides : 2;
  BoxPlaces places(count, std::vector<double>(sides, 0.0));
  for (std::size_t corner = 0; corner < count; ++corner) {
    for (std::size_t k = 0; k < sides; ++k)
      places[corner][k] = (all ? (corner >> k) & 1U : corner) != 0 ? 1.0 : 0.0;
  }
  return places;
}

/// Places inside, spread evenly: the additive recurrence of the square roots of primes (Weyl).
BoxPlaces inside_of(std::size_t sides) {
  constexpr std::array<double, 10> kPrimes = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29};
  BoxPlaces places(kPlacesInside, std::vector<double>(sides, 0.5));
  for (std::size_t i = 0; i < kPlacesInside; ++i) {
    for (std::size_t k = 0; k < sides; ++k) {
      const double walked = static_cast<double>(i + 1) * std::sqrt(kPrimes[k % kPrimes.size()]);
      places[i][k] = walked - std::floor(walked);
    }
  }
  return places;
}

/// Every row of the longest data, the other sides somewhere between their ends.
BoxPlaces rows_of(const std::vector<BoxSide>& sides) {
  std::size_t rows = 0;
  for (const BoxSide& side : sides) rows = std::max(rows, side.rows.size());
  BoxPlaces places;
  for (std::size_t row = 0; row < rows; ++row) {
    places.emplace_back(sides.size(), (static_cast<double>(row) + 0.5) / static_cast<double>(rows));
  }
  return places;
}

/// The values at a place: between the ends of each side, or in the row of the first side that shares its rows.
std::vector<double> values_at(const std::vector<double>& place, const std::vector<BoxSide>& sides) {
  std::vector<double> values;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const BoxSide& side = sides[k];
    if (side.rows.empty()) {
      values.push_back(place[k] == 1.0 ? side.high : side.low + place[k] * (side.high - side.low));
      continue;
    }
    const auto first =
        std::find_if(sides.begin(), sides.end(), [&](const BoxSide& other) { return other.zip == side.zip; });
    values.push_back(
        side.rows[row_of_number(place[static_cast<std::size_t>(first - sides.begin())], side.rows.size())]);
  }
  return values;
}

/// Reports the rule at the first of the places where it is broken.
void check_places(const StudyRule& rule, const BoxPlaces& places, const std::vector<BoxSide>& sides,
                  const Scenario& base, const StudySettings& settings, Problems& problems) {
  std::vector<std::string> keys;
  for (const BoxSide& side : sides) keys.push_back(side.key);
  for (const std::vector<double>& place : places) {
    const std::vector<double> values = values_at(place, sides);
    Violations broken;
    rule.check(Study::with_values(base, keys, values), settings, broken);
    if (broken.empty()) continue;
    std::vector<std::string> where;
    for (std::size_t k = 0; k < sides.size(); ++k) where.push_back(keys[k] + " = " + rounded(values[k]));
    report(broken, sides.front().origin, " (reached at " + comma_list(where) + ")", problems);
    return;
  }
}

/// Reports the rule at a corner of the sides, else inside: the cells of a lattice can be good at both ends of a
/// size and bad between them.
void check_sides(const StudyRule& rule, const std::vector<BoxSide>& sides, const Scenario& base,
                 const StudySettings& settings, Problems& problems) {
  const std::size_t before = problems.count();
  check_places(rule, corners_of(sides.size()), sides, base, settings, problems);
  if (problems.count() == before) check_places(rule, rows_of(sides), sides, base, settings, problems);
  if (problems.count() > before || !std::holds_alternative<LatticeParameters>(base.product)) return;
  check_places(rule, inside_of(sides.size()), sides, base, settings, problems);
}

}  // namespace

std::vector<BoxSide> box_sides(const StudyData& data, const ReadBlocks& read) {
  std::vector<BoxSide> sides;
  const auto keys = read.keys();
  const auto origin_of = [&](const std::string& key) {
    const std::string behind = key_behind(key);
    return std::find_if(keys.begin(), keys.end(), [&](const auto& item) { return item.first == behind; })->second;
  };
  for (const SearchVariable& v : data.variables) sides.push_back({v.key, v.from, v.to, origin_of(v.key)});
  for (const RandomVariable& r : data.randoms) {
    sides.push_back({r.key, quantile(r.distribution, kRareLow), quantile(r.distribution, kRareHigh),
                     origin_of(r.key), r.zip, r.rows});
  }
  return sides;
}

void check_box_rules(const StudyData& data, const ReadBlocks& read, Problems& problems) {
  const std::vector<BoxSide> all = box_sides(data, read);
  for (const StudyRule& rule : study_rules()) {
    check_candidates(rule, data, read, problems);
    std::vector<BoxSide> seen;
    std::copy_if(all.begin(), all.end(), std::back_inserter(seen), [&](const BoxSide& side) {
      const std::string_view path = find_key(key_behind(side.key)).spec->path;
      return std::find(rule.fields.begin(), rule.fields.end(), path) != rule.fields.end();
    });
    if (seen.empty()) continue;
    check_sides(rule, seen, data.bases.front(), data.settings, problems);
    for (const StrategyCandidate& candidate : data.candidates) {
      check_sides(rule, seen, candidate.scenario, data.settings, problems);
    }
  }
}

}  // namespace unbruised::studies

#include "studies/text/key_names.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace unbruised::studies {
namespace {

constexpr std::array<Unit, 22> kUnits = {{
    {"_N_m_rad", "N m/rad", "N m rad-1"},
    {"_rad_s3", "rad/s3", "rad s-3"},
    {"_rad_s2", "rad/s2", "rad s-2"},
    {"_N_s_m", "N s/m", "N s m-1"},
    {"_m_s3", "m/s3", "m s-3"},
    {"_m_s2", "m/s2", "m s-2"},
    {"_kg_m3", "kg/m3", "kg m-3"},
    {"_kg_m2", "kg m2", "kg m2"},
    {"_N_m", "N/m", "N m-1", "stiffness"},
    {"_N_m", "N/m", "N m-1", "recovery"},  // the spring k2 of a Burgers model
    {"_N_m", "N m", "N m"},
    {"_rad_s", "rad/s", "rad s-1"},
    {"_m_s", "m/s", "m s-1"},
    {"_rad", "rad", "rad"},
    {"_kg", "kg", "kg"},
    {"_Pa", "Pa", "Pa"},
    {"_Hz", "Hz", "Hz"},
    {"_m3", "m3", "m3"},
    {"_N", "N", "N"},
    {"_J", "J", "J"},
    {"_s", "s", "s"},
    {"_m", "m", "m"},  // last: others end in it
}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kOddWords = {{
    {"youngs_modulus_Pa", "Young's modulus"},
    {"poisson_ratio", "Poisson's ratio"},
    {"permanent_set_m", "permanent set"},
    {"outcome_time_s", "time of outcome"},
}};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view leaf_of(std::string_view path) { return path.substr(path.rfind('.') + 1); }

std::string_view without_unit(std::string_view leaf) {
  const Unit* unit = unit_of(leaf);
  return unit == nullptr ? leaf : leaf.substr(0, leaf.size() - unit->suffix.size());
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t n = b.size();
  std::vector<int> before(n + 1), above(n + 1), row(n + 1);
  std::iota(above.begin(), above.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= n; ++j) {
      const int change = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({change, above[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(above);
    above.swap(row);
  }
  return above[n];
}

std::span<const Unit> all_units() { return kUnits; }

const Unit* unit_of(std::string_view path) {
  while (path.ends_with("]") && path.find('[') != std::string_view::npos) path = path.substr(0, path.rfind('['));
  for (const Unit& unit : kUnits) {
    if (!path.ends_with(unit.suffix)) continue;
    if (path.substr(0, path.size() - unit.suffix.size()).ends_with(unit.after)) return &unit;
  }
  return nullptr;
}

std::span<const std::pair<std::string_view, std::string_view>> odd_key_words() { return kOddWords; }

std::string key_words(std::string_view path) {
  // "product.use" and "gripper.use" differ in what stands before.
  const std::string_view leaf = path.ends_with(".use") ? path : leaf_of(path);
  for (const auto& [name, words] : kOddWords) {
    if (name == leaf) return std::string(words);
  }
  const std::size_t index = std::min(leaf.find('['), leaf.size());
  std::string words(without_unit(leaf.substr(0, index)));
  std::replace(words.begin(), words.end(), '_', ' ');
  return words.append(leaf.substr(index));
}

std::string pattern_of(std::string_view path) {
  std::string pattern;
  for (std::size_t i = 0; i < path.size(); ++i) {
    pattern += path[i];
    if (path[i] != '[') continue;
    std::size_t end = i + 1;
    while (end < path.size() && is_digit(path[end])) ++end;
    if (end < path.size() && path[end] == ']') i = end - 1;
  }
  return pattern;
}

std::string nearest(const std::string& path, const std::vector<std::string>& candidates) {
  const std::string wanted = pattern_of(path);
  const std::string_view leaf = leaf_of(wanted);
  const std::string_view stem = without_unit(leaf);
  std::string best;
  constexpr double kFar = 1e9;
  double best_distance = kFar;
  for (const std::string& candidate : candidates) {
    const std::string_view other = leaf_of(candidate);
    const double allowed = std::max(2.0, static_cast<double>(std::min(leaf.size(), other.size())) / 3.0);
    // Texts whose lengths differ by more than what is near enough need no look at their letters.
    const auto distance_within = [near_enough = std::min(allowed, best_distance)](
                                     std::string_view a, std::string_view b, double more) {
      const double least = std::abs(static_cast<double>(a.size()) - static_cast<double>(b.size()));
      return least + more > near_enough ? kFar : edit_distance(a, b) + more;
    };
    double distance = distance_within(wanted, candidate, 0.0);
    // The right name in the wrong table, or with another unit, is near however long the table's name or the unit
    // is.
    distance = std::min(distance, distance_within(leaf, other, 1.5));
    if (!stem.empty() && stem == without_unit(other)) distance = std::min(distance, 1.5);
    if (distance <= allowed && distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  // Put the indices back where the pattern has as many.
  std::vector<std::string> indices;
  for (std::size_t i = path.find('['); i != std::string::npos; i = path.find('[', i + 1)) {
    indices.push_back(path.substr(i, path.find(']', i) - i + 1));
  }
  std::size_t from = 0;
  for (const std::string& index : indices) {
    const std::size_t at = best.find("[]", from);
    if (at == std::string::npos) break;
    best.replace(at, 2, index);
    from = at + index.size();
  }
  return best;
}

}  // namespace unbruised::studies

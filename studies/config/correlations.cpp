#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "studies/config/execution_error.hpp"
#include "studies/config/search_parts.hpp"
#include "studies/statistics/correlation.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

/// The correlations of a study, from their blocks.
class Correlations {
 public:
  explicit Correlations(const SearchInput& input)
      : data_(input.data), read_(input.read), problems_(input.problems) {}

  void add() {
    if (!kind_uses(Use::random, data_.settings.kind)) return;  // they are refused as a whole
    const std::size_t before = problems_.count();
    for (std::size_t i = 0; i < read_.blocks.correlation.size(); ++i) add_block(i);
    if (problems_.count() == before) check_together();
  }

 private:
  void add_block(std::size_t i) {
    const CorrelationBlock& block = read_.blocks.correlation[i];
    if (!read_.correlation_sound[i]) return;
    const auto complain = [&](const std::string& rule) {
      problems_.add(block.origin, "correlation[" + std::to_string(i) + "].between", spelled_keys(block), rule);
    };
    if (block.between.size() != 2 || block.between[0] == block.between[1]) {
      complain("must be two different keys");
      return;
    }
    std::array<std::size_t, 2> places{};
    for (std::size_t side = 0; side < 2; ++side) {
      const std::string& key = block.between[side];
      const auto found = std::find_if(data_.randoms.begin(), data_.randoms.end(),
                                      [&](const RandomVariable& r) { return key_behind(r.key) == key; });
      if (found == data_.randoms.end()) {
        if (!has_block(key)) complain(key + " is not drawn: no [[random]] block has this key");
        return;
      }
      if (!found->zip.empty()) {
        complain(key + " is drawn row by row from " + found->zip +
                 ", which keeps its correlation with the other keys");
        return;
      }
      places[side] = static_cast<std::size_t>(found - data_.randoms.begin());
    }
    if (!pairs_.insert({std::min(places[0], places[1]), std::max(places[0], places[1])}).second) {
      complain("is the pair of two blocks");
      return;
    }
    data_.correlations.push_back({places[0], places[1], *block.value});
  }

  /// A key whose block is wrong was reported there.
  [[nodiscard]] bool has_block(const std::string& key) const {
    return std::any_of(read_.blocks.random.begin(), read_.blocks.random.end(),
                       [&](const RandomBlock& block) { return block.key == key; });
  }

  static std::string spelled_keys(const CorrelationBlock& block) {
    std::vector<std::string> keys;
    for (const std::string& key : block.between) keys.push_back(toml_string(key));
    return "[" + comma_list(keys) + "]";
  }

  /// Can products have all of them at once?
  void check_together() {
    if (data_.correlations.empty()) return;
    std::set<std::size_t> keys;
    for (const RankCorrelation& c : data_.correlations) keys.insert({c.first, c.second});
    const std::vector<std::size_t> order(keys.begin(), keys.end());
    const auto place = [&](std::size_t key) {
      return static_cast<std::size_t>(std::find(order.begin(), order.end(), key) - order.begin());
    };
    CorrelationMatrix ranks(order.size());
    for (const RankCorrelation& c : data_.correlations) ranks.set(place(c.first), place(c.second), c.value);
    const double least = least_eigenvalue(normal_correlations(ranks));
    if (least > kLeastEigenvalue) return;
    const CorrelationMatrix nearest = nearest_ranks(ranks);
    std::vector<std::string> pairs;
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        if (nearest.at(i, j) == 0.0) continue;
        pairs.push_back(key_behind(data_.randoms[order[i]].key) + " and " +
                        key_behind(data_.randoms[order[j]].key) + " " + rounded(nearest.at(i, j)));
      }
    }
    problems_.add(read_.blocks.correlation.front().origin, "[[correlation]]",
                  "no products have these correlations together: their matrix is not positive definite (least "
                  "eigenvalue " +
                      rounded(least) + "); the nearest that is has " + comma_list(pairs));
  }

  StudyData& data_;
  const ReadBlocks& read_;
  Problems& problems_;
  std::set<std::pair<std::size_t, std::size_t>> pairs_;
};

}  // namespace

void add_correlations(const SearchInput& input) { Correlations(input).add(); }

}  // namespace unbruised::studies

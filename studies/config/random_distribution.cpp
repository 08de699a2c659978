#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/config/search_parts.hpp"

namespace unbruised::studies {
namespace {

/// Which keys a distribution takes, which it needs.
class DistributionReader {
 public:
  DistributionReader(const RandomBlock& block, std::string name, const std::vector<std::string>& given_keys,
                     Problems& problems)
      : block_(block), name_(std::move(name)), given_keys_(given_keys), problems_(problems) {}

  std::optional<Distribution> read() {
    check_keys();
    if (!given("distribution")) return std::nullopt;
    Distribution out{.kind = block_.distribution};
    if (by_data()) {
      check_values();
      out.values = block_.data;
      std::sort(out.values.begin(), out.values.end());
    } else if (by_moments()) {
      given("data") ? check_data() : check_moments();
      if (sound_) set_moments(out);
    }
    if (!sound_) return std::nullopt;
    out.from = block_.from.value_or(out.from);
    out.to = block_.to.value_or(out.to);
    out.mode = block_.mode.value_or(out.mode);
    out.at_least = block_.at_least.value_or(out.at_least);
    out.at_most = block_.at_most.value_or(out.at_most);
    if (const auto rule = broken_rule(out)) {
      complain("", *rule);
      return std::nullopt;
    }
    return out;
  }

 private:
  [[nodiscard]] bool by_moments() const {
    return block_.distribution == DistributionKind::normal || block_.distribution == DistributionKind::lognormal;
  }

  [[nodiscard]] bool by_data() const { return block_.distribution == DistributionKind::data; }
  [[nodiscard]] bool by_range() const { return !by_moments() && !by_data(); }

  [[nodiscard]] bool given(const char* leaf) const {
    return std::find(given_keys_.begin(), given_keys_.end(), leaf) != given_keys_.end();
  }

  [[nodiscard]] int deviations() const {
    return (given("standard_deviation") ? 1 : 0) + (given("relative_deviation") ? 1 : 0);
  }

  void complain(const std::string& leaf, const std::string& rule) {
    problems_.add(block_.origin, name_ + leaf, rule);
    sound_ = false;
  }

  void check_keys() {
    const bool is_triangular = block_.distribution == DistributionKind::triangular;
    for (const char* leaf : {"mean", "standard_deviation", "relative_deviation"}) {
      if (given(leaf) && !by_moments()) {
        complain(std::string(".") + leaf, "goes with normal and lognormal only");
      }
    }
    if (given("data") && by_range()) complain(".data", "goes with normal, lognormal and data only");
    for (const char* leaf : {"from", "to"}) {
      if (given(leaf) && !by_range()) {
        complain(std::string(".") + leaf,
                 by_data() ? "goes with uniform and triangular only"
                           : "goes with uniform and triangular only; truncate with at_least and at_most");
      }
      if (!given(leaf) && by_range()) complain(std::string(".") + leaf, "missing");
    }
    for (const char* leaf : {"file", "column", "zip"}) {
      if (given(leaf) && !by_data()) complain(std::string(".") + leaf, "goes with distribution = \"data\" only");
    }
    if (given("mode") != is_triangular) complain(".mode", is_triangular ? "missing" : "goes with triangular only");
    if (!given("distribution")) complain(".distribution", "missing");
  }

  /// Of distribution = "data". A file that cannot be read was reported.
  void check_values() {
    for (const char* leaf : {"at_least", "at_most"}) {
      if (given(leaf)) complain(std::string(".") + leaf, "does not go with data; leave values out of it instead");
    }
    if (given("file") != given("column")) {
      complain(given("file") ? ".column" : ".file", "missing; file and column go together");
    } else if (given("file") == given("data")) {
      complain(given("file") ? ".data" : "",
               given("file") ? "excludes file and column" : "needs file and column, or data");
    } else if (block_.data.size() < 3) {
      if (given("file")) sound_ = false;
      if (!given("file")) complain(".data", "needs at least 3 values");
    }
  }

  void check_data() {
    if (given("mean") || deviations() > 0) complain(".data", "excludes mean and deviations");
    if (block_.data.size() < 3) complain(".data", "needs at least 3 values");
    const bool positive = std::all_of(block_.data.begin(), block_.data.end(), [](double x) { return x > 0.0; });
    if (block_.distribution == DistributionKind::lognormal && !positive) {
      complain(".data", "values of a lognormal must be > 0");
    }
  }

  void check_moments() {
    if (!given("mean")) complain(".mean", "missing; give mean and a deviation, or data");
    if (deviations() != 1) {
      complain(".standard_deviation", "give exactly one of standard_deviation and relative_deviation");
    }
  }

  void set_moments(Distribution& out) const {
    if (given("data")) {
      const MeanAndSpread measured = mean_and_spread(block_.data);
      out.mean = measured.mean;
      out.standard_deviation = measured.standard_deviation;
      return;
    }
    out.mean = block_.mean.value_or(0.0);
    out.standard_deviation =
        block_.standard_deviation.value_or(block_.relative_deviation.value_or(0.0) * std::abs(out.mean));
  }

  const RandomBlock& block_;
  const std::string name_;
  const std::vector<std::string>& given_keys_;
  Problems& problems_;
  bool sound_ = true;
};

}  // namespace

std::optional<Distribution> distribution_of(const RandomBlock& block, std::size_t i,
                                            const std::vector<std::string>& given_keys, Problems& problems) {
  return DistributionReader(block, "random[" + std::to_string(i) + "]", given_keys, problems).read();
}

}  // namespace unbruised::studies

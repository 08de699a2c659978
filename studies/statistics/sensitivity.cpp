#include "studies/statistics/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "studies/statistics/distribution.hpp"

namespace unbruised::studies {
namespace {

/// Uses of a seed.
enum Purpose : std::uint64_t { kBase = 11, kOrder = 12, kBootstrap = 13 };

constexpr std::size_t kMorrisReplicates = 1000;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Block = std::span<const double>;

/// The answers in blocks of `length`, without those in which a number is not finite; their first points beside
/// them.
struct Blocks {
  std::vector<Block> answers;
  std::vector<std::size_t> first_point;
};
Blocks finite_blocks(const UnitDesign& design, std::span<const double> answers, std::size_t length) {
  if (answers.size() != design.size())
    throw std::invalid_argument("sensitivity: one answer per point of the design");
  Blocks blocks;
  for (std::size_t first = 0; first + length <= answers.size(); first += length) {
    const Block block = answers.subspan(first, length);
    if (!std::all_of(block.begin(), block.end(), [](double f) { return std::isfinite(f); })) continue;
    blocks.answers.push_back(block);
    blocks.first_point.push_back(first);
  }
  return blocks;
}

// -- Morris. -----------------------------------------------------------------------------------------------

/// One elementary effect per dimension, of the trajectory that begins at `first`.
std::vector<double> elementary_effects(const UnitDesign& design, std::size_t first, Block f) {
  std::vector<double> effects(design.dimensions);
  for (std::size_t step = 0; step < design.dimensions; ++step) {
    for (std::size_t k = 0; k < design.dimensions; ++k) {
      const double moved = design.at(first + step + 1, k) - design.at(first + step, k);
      if (moved != 0.0) effects[k] = (f[step + 1] - f[step]) / moved;
    }
  }
  return effects;
}

double mean_absolute(const std::vector<double>& effects, std::span<const std::size_t> rows) {
  double sum = 0.0;
  for (const std::size_t row : rows) sum += std::abs(effects[row]);
  return sum / static_cast<double>(rows.size());
}

MorrisEffect effect_of(const std::vector<double>& effects, double confidence, std::uint64_t seed) {
  if (effects.empty()) return {kNaN, kNaN, kNaN, {kNaN, kNaN}};
  const MeanAndSpread spread = mean_and_spread(effects);
  std::vector<std::size_t> all(effects.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  MorrisEffect out{spread.mean, mean_absolute(effects, all), spread.standard_deviation, {0.0, kInfinity}};
  if (effects.size() < 2) return out;
  out.mean_absolute_interval =
      bootstrap_interval(effects.size(), kMorrisReplicates, seed, confidence,
                         [&](std::span<const std::size_t> rows) { return mean_absolute(effects, rows); });
  return out;
}

// -- Sobol' indices. ---------------------------------------------------------------------------------------

struct Estimate {
  double variance = 0.0;
  std::vector<double> first;
  std::vector<double> total;
};

/// The estimators over some of the blocks f(A), f(B), f(AB_1) ... f(AB_k), each less `center`.
Estimate estimate_of(const std::vector<Block>& blocks, std::span<const std::size_t> rows, double center,
                     std::size_t dimensions) {
  const auto n = static_cast<double>(rows.size());
  double sum = 0.0;
  double squares = 0.0;
  Estimate out{0.0, std::vector<double>(dimensions), std::vector<double>(dimensions)};
  for (const std::size_t row : rows) {
    const Block f = blocks[row];
    const double f_A = f[0] - center;
    const double f_B = f[1] - center;
    sum += f_A + f_B;
    squares += f_A * f_A + f_B * f_B;
    for (std::size_t i = 0; i < dimensions; ++i) {
      const double f_AB = f[2 + i] - center;
      out.first[i] += f_B * (f_AB - f_A);
      out.total[i] += (f_A - f_AB) * (f_A - f_AB);
    }
  }
  const double mean = sum / (2.0 * n);
  out.variance = std::max(0.0, squares / (2.0 * n) - mean * mean);
  for (std::size_t i = 0; i < dimensions; ++i) {
    out.first[i] = out.variance > 0.0 ? out.first[i] / n / out.variance : 0.0;
    out.total[i] = out.variance > 0.0 ? out.total[i] / (2.0 * n) / out.variance : 0.0;
  }
  return out;
}

double mean_of_base(const std::vector<Block>& blocks) {
  double sum = 0.0;
  for (const Block f : blocks) sum += 0.5 * f[0] + 0.5 * f[1];
  return sum / static_cast<double>(blocks.size());
}

}  // namespace

UnitDesign morris_design(std::size_t trajectories, std::size_t dimensions, std::size_t levels,
                         std::uint64_t seed) {
  if (levels < 4 || levels % 2 != 0) throw std::invalid_argument("morris_design: levels must be even and >= 4");
  UnitDesign design{dimensions, {}};
  design.values.reserve(trajectories * (dimensions + 1) * dimensions);
  const std::size_t jump = levels / 2;
  std::vector<std::size_t> level(dimensions);
  const auto put = [&] {
    for (const std::size_t l : level) {
      design.values.push_back((static_cast<double>(l) + 0.5) / static_cast<double>(levels));
    }
  };
  for (std::size_t t = 0; t < trajectories; ++t) {
    for (std::size_t k = 0; k < dimensions; ++k) level[k] = random_index(derived_seed(seed, kBase), t, k, levels);
    put();
    for (const std::size_t k : random_order(dimensions, derived_seed(seed, kOrder), t)) {
      // Up from the lower half, down from the upper half: the jump stays on the grid.
      level[k] = level[k] < jump ? level[k] + jump : level[k] - jump;
      put();
    }
  }
  return design;
}

MorrisResult morris_effects(const UnitDesign& design, std::span<const double> answers, double confidence,
                            std::uint64_t seed) {
  const Blocks blocks = finite_blocks(design, answers, design.dimensions + 1);
  std::vector<std::vector<double>> effects(design.dimensions);
  for (std::size_t t = 0; t < blocks.answers.size(); ++t) {
    const std::vector<double> of_all = elementary_effects(design, blocks.first_point[t], blocks.answers[t]);
    for (std::size_t k = 0; k < design.dimensions; ++k) effects[k].push_back(of_all[k]);
  }
  MorrisResult out;
  out.used = blocks.answers.size();
  for (const std::vector<double>& own : effects) {
    out.effects.push_back(effect_of(own, confidence, derived_seed(seed, kBootstrap)));
  }
  return out;
}

UnitDesign sobol_index_design(std::size_t base_samples, std::size_t dimensions, DesignKind kind,
                              std::uint64_t seed) {
  // A and B are the two halves of the columns of one design.
  const UnitDesign base = unit_design(kind, base_samples, 2 * dimensions, derived_seed(seed, kBase));
  UnitDesign design{dimensions, {}};
  design.values.reserve(base_samples * (dimensions + 2) * dimensions);
  for (std::size_t sample = 0; sample < base_samples; ++sample) {
    const auto put = [&](auto is_from_B) {
      for (std::size_t k = 0; k < dimensions; ++k) {
        design.values.push_back(base.at(sample, is_from_B(k) ? dimensions + k : k));
      }
    };
    put([](std::size_t) { return false; });
    put([](std::size_t) { return true; });
    for (std::size_t i = 0; i < dimensions; ++i) put([i](std::size_t k) { return k == i; });
  }
  return design;
}

SobolResult sobol_indices(const UnitDesign& design, std::span<const double> answers, std::size_t replicates,
                          double confidence, std::uint64_t seed) {
  const std::size_t dimensions = design.dimensions;
  const std::vector<Block> blocks = finite_blocks(design, answers, dimensions + 2).answers;
  SobolResult out;
  out.used = blocks.size();
  if (blocks.empty()) {
    out.indices.assign(dimensions, {kNaN, kNaN, {kNaN, kNaN}, {kNaN, kNaN}});
    out.variance = kNaN;
    return out;
  }
  // f(B) (f(AB) - f(A)) loses its digits to a large mean.
  const double center = mean_of_base(blocks);
  std::vector<std::size_t> all(blocks.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const Estimate found = estimate_of(blocks, all, center, dimensions);
  std::vector<Estimate> drawn;
  if (blocks.size() > 1) {
    for (std::size_t b = 0; b < replicates; ++b) {
      const std::vector<std::size_t> rows = bootstrap_rows(blocks.size(), derived_seed(seed, kBootstrap), b);
      drawn.push_back(estimate_of(blocks, rows, center, dimensions));
    }
  }
  const auto interval_of = [&](std::vector<double> Estimate::*index, std::size_t i) -> Interval {
    if (drawn.empty()) return {-kInfinity, kInfinity};
    std::vector<double> values;
    for (const Estimate& estimate : drawn) values.push_back((estimate.*index)[i]);
    return percentile_interval(std::move(values), confidence);
  };
  out.variance = found.variance;
  for (std::size_t i = 0; i < dimensions; ++i) {
    out.indices.push_back(
        {found.first[i], found.total[i], interval_of(&Estimate::first, i), interval_of(&Estimate::total, i)});
  }
  return out;
}

}  // namespace unbruised::studies

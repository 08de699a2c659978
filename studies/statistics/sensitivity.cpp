#include "studies/statistics/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "studies/statistics/distribution.hpp"
#include "studies/statistics/replicates.hpp"
#include "studies/statistics/scores.hpp"

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

std::vector<std::size_t> all_rows(std::size_t count) {
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

/// Do two answers differ?
bool varies(const std::vector<Block>& blocks) {
  for (const Block block : blocks) {
    for (const double f : block) {
      if (f != blocks.front().front()) return true;
    }
  }
  return false;
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
  MorrisEffect out{
      spread.mean, mean_absolute(effects, all_rows(effects.size())), spread.standard_deviation, {0.0, kInfinity}};
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

/// The estimates of base samples drawn with replacement; none of one sample.
std::vector<Estimate> bootstrapped(const std::vector<Block>& blocks, double center, std::size_t dimensions,
                                   std::size_t times, std::uint64_t seed) {
  std::vector<Estimate> drawn;
  for (std::size_t b = 0; b < times && blocks.size() > 1; ++b) {
    const std::vector<std::size_t> rows = bootstrap_rows(blocks.size(), derived_seed(seed, kBootstrap), b);
    drawn.push_back(estimate_of(blocks, rows, center, dimensions));
  }
  return drawn;
}

/// The estimates without each replicate of the design in turn; none where only one has answers.
std::vector<Estimate> without_each_replicate(const UnitDesign& design, const Blocks& blocks, double center) {
  const std::size_t length = design.dimensions + 2;
  std::vector<Estimate> others;
  for (std::size_t r = 0; r < design.replicates; ++r) {
    std::vector<std::size_t> rows;
    for (std::size_t b = 0; b < blocks.answers.size(); ++b) {
      if (blocks.first_point[b] / length % design.replicates != r) rows.push_back(b);
    }
    const bool has_own = rows.size() < blocks.answers.size();
    if (has_own && !rows.empty()) others.push_back(estimate_of(blocks.answers, rows, center, design.dimensions));
  }
  return others;
}

/// Student's interval with Tukey's jackknife: error^2 = (R - 1) / R sum (without_r - mean of these)^2.
Interval jackknife_interval(double found, const std::vector<double>& without, double confidence) {
  const auto R = static_cast<double>(without.size());
  const MeanAndSpread spread = mean_and_spread(without);  // of R - 1 degrees of freedom
  const double error = spread.standard_deviation * (R - 1.0) / std::sqrt(R);
  const double half = student_score(R - 1.0, confidence) * error;
  return {found - half, found + half};
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
  out.varies = varies(blocks.answers);
  for (const std::vector<double>& own : effects) {
    out.effects.push_back(effect_of(own, confidence, derived_seed(seed, kBootstrap)));
  }
  return out;
}

UnitDesign sobol_index_design(std::size_t base_samples, std::size_t dimensions, DesignKind kind,
                              std::uint64_t seed) {
  // A and B are the two halves of the columns of one design.
  const UnitDesign base = replicated_design(
      {kind, base_samples, 2 * dimensions, replicate_count(kind, base_samples)}, derived_seed(seed, kBase));
  UnitDesign design{dimensions, {}, base.replicates};
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

SobolResult sobol_indices(const UnitDesign& design, std::span<const double> answers, std::size_t bootstrap,
                          double confidence, std::uint64_t seed) {
  const std::size_t dimensions = design.dimensions;
  const Blocks finite = finite_blocks(design, answers, dimensions + 2);
  const std::vector<Block>& blocks = finite.answers;
  SobolResult out;
  out.used = blocks.size();
  out.varies = varies(blocks);
  if (blocks.empty()) {
    out.indices.assign(dimensions, {kNaN, kNaN, {kNaN, kNaN}, {kNaN, kNaN}});
    out.variance = kNaN;
    return out;
  }
  // f(B) (f(AB) - f(A)) loses its digits to a large mean.
  const double center = mean_of_base(blocks);
  const Estimate found = estimate_of(blocks, all_rows(blocks.size()), center, dimensions);
  const bool in_replicates = design.replicates > 1;
  const std::vector<Estimate> others = in_replicates ? without_each_replicate(design, finite, center)
                                                     : bootstrapped(blocks, center, dimensions, bootstrap, seed);
  out.variance = found.variance;
  for (std::size_t i = 0; i < dimensions; ++i) {
    const auto interval_of = [&](std::vector<double> Estimate::*index) -> Interval {
      if (others.empty()) return {-kInfinity, kInfinity};
      std::vector<double> values;
      for (const Estimate& estimate : others) values.push_back((estimate.*index)[i]);
      return in_replicates ? jackknife_interval((found.*index)[i], values, confidence)
                           : percentile_interval(std::move(values), confidence);
    };
    out.indices.push_back(
        {found.first[i], found.total[i], interval_of(&Estimate::first), interval_of(&Estimate::total)});
  }
  return out;
}

}  // namespace unbruised::studies

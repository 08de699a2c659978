#include "studies/statistics/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace unbruised::studies {
namespace {

enum Stream : std::uint64_t { kBase = 11, kOrder = 12, kDirection = 13, kBootstrap = 14 };

constexpr std::size_t kMorrisReplicates = 500;

std::vector<std::size_t> shuffled(std::size_t count, std::uint64_t seed, std::uint64_t stream) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) {
    const double random = unit_random(seed, stream, i);
    std::swap(order[i - 1], order[static_cast<std::size_t>(random * static_cast<double>(i))]);
  }
  return order;
}

bool has_nan(std::span<const double> values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); });
}

/// Answers of one base sample: f(A), f(B), f(AB_1) ... f(AB_k), centred.
using Block = std::span<const double>;

struct Indices {
  double first;
  double total;
};

/// First order after Saltelli 2010, total after Jansen 1999, of the blocks drawn.
Indices indices_of(const std::vector<std::vector<double>>& blocks, std::span<const std::size_t> drawn, std::size_t k) {
  double sum = 0.0;
  double squares = 0.0;
  double first = 0.0;
  double total = 0.0;
  for (const std::size_t i : drawn) {
    const Block f = blocks[i];
    sum += f[0] + f[1];
    squares += f[0] * f[0] + f[1] * f[1];
    first += f[1] * (f[2 + k] - f[0]);
    total += (f[0] - f[2 + k]) * (f[0] - f[2 + k]);
  }
  const auto n = static_cast<double>(drawn.size());
  const double variance = squares / (2.0 * n) - (sum / (2.0 * n)) * (sum / (2.0 * n));
  if (!(variance > 0.0)) return {0.0, 0.0};
  return {first / n / variance, total / (2.0 * n) / variance};
}

}  // namespace

UnitDesign morris_design(std::size_t trajectories, std::size_t dimensions, std::size_t levels, std::uint64_t seed) {
  UnitDesign design{dimensions, {}};
  design.values.reserve(trajectories * (dimensions + 1) * dimensions);
  const std::size_t jump = levels / 2;
  const auto middle = [levels](std::size_t level) {
    return (static_cast<double>(level) + 0.5) / static_cast<double>(levels);
  };
  for (std::size_t t = 0; t < trajectories; ++t) {
    std::vector<std::size_t> level(dimensions);
    for (std::size_t k = 0; k < dimensions; ++k) {
      const double random = unit_random(derived_seed(seed, kBase), t, k);
      level[k] = static_cast<std::size_t>(random * static_cast<double>(levels));
    }
    const auto put = [&] {
      for (const std::size_t l : level) design.values.push_back(middle(l));
    };
    put();
    for (const std::size_t k : shuffled(dimensions, derived_seed(seed, kOrder), t)) {
      // From the lower half only up, from the upper half only down: the jump stays on the grid.
      level[k] = level[k] < jump ? level[k] + jump : level[k] - jump;
      put();
    }
  }
  return design;
}

MorrisResult morris_effects(const UnitDesign& design, std::span<const double> answers, double confidence,
                            std::uint64_t seed) {
  const std::size_t n = design.dimensions;
  const std::size_t length = n + 1;
  std::vector<std::vector<double>> effects(n);
  MorrisResult out;
  for (std::size_t first = 0; first + length <= answers.size(); first += length) {
    if (has_nan(answers.subspan(first, length))) continue;
    ++out.used;
    for (std::size_t step = first; step + 1 < first + length; ++step) {
      for (std::size_t k = 0; k < n; ++k) {
        const double moved = design.at(step + 1, k) - design.at(step, k);
        if (moved != 0.0) effects[k].push_back((answers[step + 1] - answers[step]) / moved);
      }
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    MorrisEffect effect;
    const std::vector<double>& own = effects[k];
    const auto count = static_cast<double>(own.size());
    for (const double e : own) effect.mean += e / count;
    for (const double e : own) effect.mean_absolute += std::abs(e) / count;
    for (const double e : own) effect.standard_deviation += (e - effect.mean) * (e - effect.mean);
    effect.standard_deviation = own.size() < 2 ? 0.0 : std::sqrt(effect.standard_deviation / (count - 1.0));
    if (!own.empty()) {
      effect.mean_absolute_interval = bootstrap_interval(
          own.size(), kMorrisReplicates, derived_seed(seed, kBootstrap + k), confidence,
          [&own](std::span<const std::size_t> drawn) {
            double sum = 0.0;
            for (const std::size_t i : drawn) sum += std::abs(own[i]);
            return sum / static_cast<double>(drawn.size());
          });
    }
    out.effects.push_back(effect);
  }
  return out;
}

UnitDesign sobol_index_design(std::size_t base_samples, std::size_t dimensions, DesignKind kind,
                              std::uint64_t seed) {
  // A and B are the two halves of one design in twice the dimensions.
  const UnitDesign base = unit_design(kind, base_samples, 2 * dimensions, derived_seed(seed, kBase));
  UnitDesign design{dimensions, {}};
  design.values.reserve(base_samples * (dimensions + 2) * dimensions);
  for (std::size_t i = 0; i < base_samples; ++i) {
    // column < dimensions: AB_column; dimensions: A; dimensions + 1: B
    const auto put = [&](std::size_t column) {
      for (std::size_t k = 0; k < dimensions; ++k) {
        const bool from_b = column == dimensions + 1 || column == k;
        design.values.push_back(base.at(i, from_b ? dimensions + k : k));
      }
    };
    put(dimensions);
    put(dimensions + 1);
    for (std::size_t column = 0; column < dimensions; ++column) put(column);
  }
  return design;
}

SobolResult sobol_indices(const UnitDesign& design, std::span<const double> answers, std::size_t replicates,
                          double confidence, std::uint64_t seed) {
  const std::size_t n = design.dimensions;
  const std::size_t length = n + 2;
  std::vector<std::vector<double>> blocks;
  double sum = 0.0;
  for (std::size_t first = 0; first + length <= answers.size(); first += length) {
    const Block block = answers.subspan(first, length);
    if (has_nan(block)) continue;
    blocks.emplace_back(block.begin(), block.end());
    sum += block[0] + block[1];
  }
  SobolResult out;
  out.used = blocks.size();
  out.indices.resize(n);
  if (blocks.empty()) return out;
  // Centred answers: the first-order estimator is a difference of products and loses digits to a large mean.
  const double mean = sum / (2.0 * static_cast<double>(blocks.size()));
  for (std::vector<double>& block : blocks) {
    for (double& f : block) f -= mean;
    out.variance += (block[0] * block[0] + block[1] * block[1]) / (2.0 * static_cast<double>(blocks.size()));
  }
  std::vector<std::size_t> all(blocks.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (std::size_t k = 0; k < n; ++k) {
    const Indices found = indices_of(blocks, all, k);
    const std::uint64_t own_seed = derived_seed(seed, kBootstrap + k);
    out.indices[k].first = found.first;
    out.indices[k].total = found.total;
    out.indices[k].first_interval =
        bootstrap_interval(blocks.size(), replicates, own_seed, confidence,
                           [&](std::span<const std::size_t> drawn) { return indices_of(blocks, drawn, k).first; });
    out.indices[k].total_interval =
        bootstrap_interval(blocks.size(), replicates, own_seed, confidence,
                           [&](std::span<const std::size_t> drawn) { return indices_of(blocks, drawn, k).total; });
  }
  return out;
}

}  // namespace unbruised::studies

#include "core/contact/patch_traction.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/linear_table.hpp"

namespace unbruised {
namespace {

constexpr std::size_t kRatios = 6;
/// Between the rows, which begin at 0.
constexpr double kRatioStep = 0.1;

struct TractionRow {
  double peak;  ///< von Mises stress / p0 without traction
  std::array<double, TractionFactor::kSteps> factor;
};

/// Of patch_stress over depths of 0.05 to 0.57 of the radius in the plane of symmetry, for Poisson ratios of 0,
/// 0.1 ... 0.5. `patch_traction_test` computes it again.
constexpr std::array<TractionRow, kRatios> kTable = {{
    {0.7696,
     {1.0000, 1.0013, 1.0053, 1.0121, 1.0215, 1.0338, 1.0490, 1.0674, 1.1113, 1.1886, 1.2690, 1.3518, 1.4367,
      1.5231, 1.6110, 1.7000, 1.7900}},
    {0.7171,
     {1.0000, 1.0014, 1.0058, 1.0129, 1.0230, 1.0360, 1.0520, 1.0712, 1.1110, 1.1989, 1.2896, 1.3823, 1.4767,
      1.5726, 1.6697, 1.7678, 1.8668}},
    {0.6673,
     {1.0000, 1.0016, 1.0063, 1.0141, 1.0251, 1.0393, 1.0567, 1.0774, 1.1122, 1.2117, 1.3135, 1.4172, 1.5222,
      1.6285, 1.7357, 1.8439, 1.9527}},
    {0.6200,
     {1.0000, 1.0018, 1.0070, 1.0159, 1.0284, 1.0444, 1.0640, 1.0873, 1.1170, 1.2294, 1.3437, 1.4595, 1.5763,
      1.6941, 1.8126, 1.9319, 2.0515}},
    {0.5752,
     {1.0000, 1.0021, 1.0084, 1.0189, 1.0337, 1.0527, 1.0761, 1.1039, 1.1364, 1.2583, 1.3866, 1.5158, 1.6456,
      1.7760, 1.9069, 2.0381, 2.1695}},
    {0.5327,
     {1.0000, 1.0026, 1.0106, 1.0241, 1.0430, 1.0678, 1.0988, 1.1367, 1.1832, 1.3152, 1.4578, 1.6006, 1.7437,
      1.8869, 2.0303, 2.1738, 2.3174}},
}};

}  // namespace

double hertz_peak_stress(double poisson_ratio) {
  const BetweenEntries row(poisson_ratio, kRatioStep, kRatios);
  return row.of(kTable[row.at].peak, kTable[row.at + 1].peak);
}

TractionFactor TractionFactor::of_curved(double poisson_ratio) {
  const BetweenEntries row(poisson_ratio, kRatioStep, kRatios);
  TractionFactor curved;
  for (std::size_t i = 0; i < kSteps; ++i) {
    curved.factor_[i] = row.of(kTable[row.at].factor[i], kTable[row.at + 1].factor[i]);
  }
  return curved;
}

TractionFactor TractionFactor::of_flat() {
  TractionFactor flat;
  for (std::size_t i = 0; i < kSteps; ++i) {
    const double t = kStep * static_cast<double>(i);
    flat.factor_[i] = std::sqrt(1.0 + 3.0 * t * t);
  }
  return flat;
}

double TractionFactor::at(double traction_over_pressure) const {
  return BetweenEntries(std::max(0.0, traction_over_pressure), kStep, kSteps).in(factor_);
}

Lane TractionFactor::at(const Lane& traction_over_pressure) const {
  Lane factor(1.0);
  for (int lane = 0; lane < kLanes; ++lane) factor.set(lane, at(traction_over_pressure[lane]));
  return factor;
}

}  // namespace unbruised

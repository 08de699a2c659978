#include "core/body/true_masses.hpp"

#include <algorithm>

#include <Eigen/Dense>

#include "core/scenario/true_shape.hpp"

namespace unbruised {
namespace {

/// Mean square of the places along an axis over the extent's square.
double mean_square_share(const TrueShape& shape, std::size_t axis) {
  int round_axes = 0;
  for (std::size_t d = 0; d < 3; ++d) round_axes += shape.is_round(d) ? 1 : 0;
  if (!shape.is_round(axis)) return 1.0 / 12.0;
  return round_axes == 3 ? 1.0 / 20.0 : 1.0 / 16.0;
}

/// What a particle counts for mass and moments: 1 and the squares of its place from the centre over the extents.
std::vector<Eigen::Vector4d> counts_of(const LatticeParameters& parameters, const Lattice& lattice) {
  std::vector<Eigen::Vector4d> counts;
  for (const auto& position_m : lattice.position_m) {
    Eigen::Vector4d count(1.0, 0.0, 0.0, 0.0);
    for (std::size_t d = 0; d < 3; ++d) {
      const double q = (position_m[d] - lattice.center_m[d]) / parameters.size_m[d];
      count[static_cast<Eigen::Index>(d) + 1] = q * q;
    }
    counts.push_back(count);
  }
  return counts;
}

/// Factors 1 / (c . counts) of the masses: the least change, by sum m log, that meets the wanted sums. Every c on
/// the way leaves all of them positive.
class Factors {
 public:
  Factors(const std::vector<double>& mass_kg, const std::vector<Eigen::Vector4d>& counts,
          const Eigen::Vector4d& wanted)
      : mass_kg_(mass_kg), counts_(counts), wanted_(wanted) {}

  /// Newton's method; a step that does not come nearer is halved, until none does: that is rounding.
  [[nodiscard]] std::vector<double> solve() const {
    Eigen::Vector4d c(1.0, 0.0, 0.0, 0.0);
    double missing = slope(c).norm();
    for (bool nearer = true; nearer;) {
      nearer = false;
      const Eigen::Vector4d way = curvature(c).ldlt().solve(slope(c));
      for (double stretch = 1.0; !nearer && stretch > kLeastStretch; stretch *= 0.5) {
        const Eigen::Vector4d next = c + stretch * way;
        if (!leaves_positive(next) || !(slope(next).norm() < missing)) continue;
        nearer = true;
        c = next;
        missing = slope(c).norm();
      }
    }
    std::vector<double> factors;
    for (const Eigen::Vector4d& count : counts_) factors.push_back(1.0 / c.dot(count));
    return factors;
  }

 private:
  static constexpr double kLeastStretch = 1e-3;

  [[nodiscard]] Eigen::Vector4d slope(const Eigen::Vector4d& c) const {
    Eigen::Vector4d sum = -wanted_;
    for (std::size_t p = 0; p < counts_.size(); ++p) sum += mass_kg_[p] / c.dot(counts_[p]) * counts_[p];
    return sum;
  }
  [[nodiscard]] Eigen::Matrix4d curvature(const Eigen::Vector4d& c) const {
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    for (std::size_t p = 0; p < counts_.size(); ++p) {
      const double factor = 1.0 / c.dot(counts_[p]);
      sum += mass_kg_[p] * factor * factor * counts_[p] * counts_[p].transpose();
    }
    return sum;
  }
  [[nodiscard]] bool leaves_positive(const Eigen::Vector4d& c) const {
    return std::all_of(counts_.begin(), counts_.end(), [&c](const auto& count) { return c.dot(count) > 0.0; });
  }

  const std::vector<double>& mass_kg_;
  const std::vector<Eigen::Vector4d>& counts_;
  Eigen::Vector4d wanted_;
};

}  // namespace

std::vector<double> true_masses(const LatticeParameters& parameters, const Lattice& lattice) {
  const TrueShape shape(parameters);
  double mass_kg = 0.0;
  for (const double of_particle : lattice.mass_kg) mass_kg += of_particle;
  Eigen::Vector4d wanted(mass_kg, 0.0, 0.0, 0.0);
  for (std::size_t d = 0; d < 3; ++d) {
    wanted[static_cast<Eigen::Index>(d) + 1] = mass_kg * mean_square_share(shape, d);
  }
  std::vector<double> masses = Factors(lattice.mass_kg, counts_of(parameters, lattice), wanted).solve();
  for (std::size_t p = 0; p < masses.size(); ++p) masses[p] *= lattice.mass_kg[p];
  return masses;
}

}  // namespace unbruised

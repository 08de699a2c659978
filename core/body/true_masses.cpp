#include "core/body/true_masses.hpp"

#include <algorithm>

#include "core/door/eigen.hpp"
#include "core/scenario/true_shape.hpp"

namespace unbruised {
namespace {

/// The axis along which the centre of mass is off the middle; 3: none.
std::size_t lopsided_axis(const TrueShape& shape) {
  std::size_t axis = 0;
  while (axis < 3 && shape.is_mirrored(axis)) ++axis;
  return axis;
}

template <int n>
using Vector = Eigen::Matrix<double, n, 1>;

/// A mesh is lopsided along all axes and has products of its places along two.
constexpr int kAllMoments = 10;
int moment_count(const TrueShape& shape) {
  const std::size_t lopsided = lopsided_axis(shape);
  if (lopsided == 3) return 4;
  return lopsided == 0 && !shape.is_mirrored(1) && !shape.is_mirrored(2) ? kAllMoments : 5;
}

/// What a particle counts for mass and moments: 1, the squares of its place from the centre over the extents, and
/// with a fifth number that place along a lopsided axis, with ten that along all and the products of two.
template <int n>
std::vector<Vector<n>> counts_of(const LatticeParameters& parameters, const Lattice& lattice,
                                 std::size_t lopsided) {
  std::vector<Vector<n>> counts;
  for (const auto& position_m : lattice.position_m) {
    Vector<n> count = Vector<n>::Zero();
    count[0] = 1.0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double q = (position_m[d] - lattice.center_m[d]) / parameters.size_m[d];
      count[static_cast<Eigen::Index>(d) + 1] = q * q;
      if (n == 5 && d == lopsided) count[n - 1] = q;
      if constexpr (n == kAllMoments) {
        const std::size_t next = (d + 1) % 3;
        const double other = (position_m[next] - lattice.center_m[next]) / parameters.size_m[next];
        count[static_cast<Eigen::Index>(d) + 4] = q;
        count[static_cast<Eigen::Index>(d) + 7] = q * other;
      }
    }
    counts.push_back(count);
  }
  return counts;
}

/// Factors 1 / (c . counts) of the masses: the least change, by sum m log, that meets the wanted sums. Every c on
/// the way leaves all of them positive.
template <int n>
class Factors {
 public:
  Factors(const std::vector<double>& mass_kg, const std::vector<Vector<n>>& counts, const Vector<n>& wanted)
      : mass_kg_(mass_kg), counts_(counts), wanted_(wanted) {}

  /// Newton's method; a step that does not come nearer is halved, until none does: that is rounding.
  [[nodiscard]] std::vector<double> solve() const {
    Vector<n> c = Vector<n>::Zero();
    c[0] = 1.0;
    double missing = slope(c).norm();
    for (bool nearer = true; nearer;) {
      nearer = false;
      const Vector<n> way = curvature(c).ldlt().solve(slope(c));
      for (double stretch = 1.0; !nearer && stretch > kLeastStretch; stretch *= 0.5) {
        const Vector<n> next = c + stretch * way;
        if (!leaves_positive(next) || !(slope(next).norm() < missing)) continue;
        nearer = true;
        c = next;
        missing = slope(c).norm();
      }
    }
    std::vector<double> factors;
    for (const Vector<n>& count : counts_) factors.push_back(1.0 / c.dot(count));
    return factors;
  }

 private:
  static constexpr double kLeastStretch = 1e-3;

  [[nodiscard]] Vector<n> slope(const Vector<n>& c) const {
    Vector<n> sum = -wanted_;
    for (std::size_t p = 0; p < counts_.size(); ++p) sum += mass_kg_[p] / c.dot(counts_[p]) * counts_[p];
    return sum;
  }
  [[nodiscard]] Eigen::Matrix<double, n, n> curvature(const Vector<n>& c) const {
    Eigen::Matrix<double, n, n> sum = Eigen::Matrix<double, n, n>::Zero();
    for (std::size_t p = 0; p < counts_.size(); ++p) {
      const double factor = 1.0 / c.dot(counts_[p]);
      sum += mass_kg_[p] * factor * factor * counts_[p] * counts_[p].transpose();
    }
    return sum;
  }
  [[nodiscard]] bool leaves_positive(const Vector<n>& c) const {
    return std::all_of(counts_.begin(), counts_.end(), [&c](const auto& count) { return c.dot(count) > 0.0; });
  }

  const std::vector<double>& mass_kg_;
  const std::vector<Vector<n>>& counts_;
  Vector<n> wanted_;
};

template <int n>
std::vector<double> factors(const TrueShape& shape, const LatticeParameters& parameters, const Lattice& lattice,
                            double mass_kg) {
  const std::size_t lopsided = lopsided_axis(shape);
  Vector<n> wanted = Vector<n>::Zero();
  wanted[0] = mass_kg;
  for (std::size_t d = 0; d < 3; ++d) {
    wanted[static_cast<Eigen::Index>(d) + 1] = mass_kg * shape.mean_square_share(d);
    if (n == 5 && d == lopsided) {
      wanted[n - 1] = mass_kg * shape.center_of_mass_m()[d] / parameters.size_m[d];
    }
    if constexpr (n == kAllMoments) {
      const std::size_t next = (d + 1) % 3;
      wanted[static_cast<Eigen::Index>(d) + 4] = mass_kg * shape.center_of_mass_m()[d] / parameters.size_m[d];
      wanted[static_cast<Eigen::Index>(d) + 7] = mass_kg * shape.mean_product_share(d, next);
    }
  }
  return Factors<n>(lattice.mass_kg, counts_of<n>(parameters, lattice, lopsided), wanted).solve();
}

}  // namespace

std::vector<double> true_masses(const LatticeParameters& parameters, const Lattice& lattice) {
  const TrueShape shape(parameters);
  double mass_kg = 0.0;
  for (const double of_particle : lattice.mass_kg) mass_kg += of_particle;
  const int moments = moment_count(shape);
  std::vector<double> masses = moments == 4             ? factors<4>(shape, parameters, lattice, mass_kg)
                               : moments == kAllMoments ? factors<kAllMoments>(shape, parameters, lattice, mass_kg)
                                                        : factors<5>(shape, parameters, lattice, mass_kg);
  for (std::size_t p = 0; p < masses.size(); ++p) masses[p] *= lattice.mass_kg[p];
  return masses;
}

}  // namespace unbruised

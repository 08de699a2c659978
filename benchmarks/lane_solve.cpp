/// @file
/// The triangular solves alone, against the multiply-add peak of the core and against CHOLMOD, and the choice of
/// SIMD type and lane width behind core/lanes/lane.hpp. Everything is measured in turns, so that a disturbance of
/// the machine meets all contenders alike.

#include "core/algebra/lane_solve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/cube512_scene.hpp"
#include "benchmarks/fma_peak.hpp"
#include "benchmarks/pack_types.hpp"
#include "benchmarks/stopwatch.hpp"
#include "core/algebra/lane_solve_kernels.hpp"
#include "core/algebra/shifted_entries.hpp"
#include "core/algebra/sparse_cholesky.hpp"
#include "core/algebra/supernodal_cholesky.hpp"
#include "core/body/lattice.hpp"
#include "core/body/lattice_stiffness.hpp"
#include "core/body/static_solver.hpp"
#include "core/integration/wilson_theta.hpp"
#include "core/lanes/lane.hpp"

namespace unbruised::benchmarks {
namespace {

constexpr int kTurns = 10;
constexpr int kSamplesPerTurn = 5;
constexpr int kManyRightHandSides = 32;
/// Different orders of summation in a well-conditioned solve; a wrong row or lane is off by far more.
constexpr double kLargestDifference = 1e-10;
/// Of a solve in single precision, whose round-off is 6e-8 and is multiplied by the condition of the matrix.
constexpr double kLargestSingleDifference = 1e-3;

/// One product's A = K + a0 M + a1 C, its factor in both layouts, and a right-hand side with its solution.
struct Problem {
  std::string name;
  std::size_t particle_count = 0;
  std::unique_ptr<SparseCholesky> cholesky;
  SupernodalFactor factor;
  Samples cholesky_time, factor_time;  ///< of making them, the ordering with both
  std::vector<double> right_hand_side, solution;

  [[nodiscard]] std::size_t size() const { return right_hand_side.size(); }
  /// Useful flops of one solve: a multiply and an add per entry of L, forwards and backwards.
  [[nodiscard]] double useful_flops() const { return 4.0 * static_cast<double>(factor.entry_count); }
};

/// The matrix that core factors for this product (core/simulation/model.cpp).
SymmetricMatrix effective_stiffness(const LatticeParameters& product, const Lattice& lattice,
                                    const WilsonTheta& w) {
  BlockMatrix K = assemble_stiffness(
      lattice, cell_stiffness(product.youngs_modulus_Pa, product.poisson_ratio, lattice.cell_extent_m));
  std::vector<int> freedom(3 * lattice.position_m.size());
  for (std::size_t i = 0; i < freedom.size(); ++i) freedom[i] = static_cast<int>(i);
  for (double& value : K.value) value *= 1.0 + w.a1 * product.relaxation_time_s.value();
  return symmetric_from_entries(static_cast<int>(freedom.size()),
                                shifted_entries(K, lattice.mass_kg, w.a0, freedom));
}

std::optional<Problem> make_problem(std::string name, const LatticeParameters& product) {
  const Lattice lattice = build_lattice(product);
  Problem problem;
  problem.name = std::move(name);
  problem.particle_count = lattice.position_m.size();
  std::string error;
  const WilsonTheta w(1e-3, 1.4);
  const SymmetricMatrix matrix = effective_stiffness(product, lattice, w);
  std::optional<SupernodalFactor> factor;
  for (int sample = 0; sample < kSamplesPerTurn; ++sample) {
    problem.cholesky_time.add(seconds_of([&] { problem.cholesky = SparseCholesky::factor(matrix, error); }));
    problem.factor_time.add(seconds_of([&] { factor = factor_supernodes(matrix, error); }));
  }
  if (!problem.cholesky) {
    std::fprintf(stderr, "%s: %s\n", problem.name.c_str(), error.c_str());
    return std::nullopt;
  }
  if (!factor) return std::nullopt;
  problem.factor = std::move(*factor);
  problem.factor.round_values();
  problem.right_hand_side.resize(3 * problem.particle_count);
  for (std::size_t i = 0; i < problem.size(); ++i) problem.right_hand_side[i] = 1.0 + static_cast<double>(i % 7);
  problem.solution = problem.cholesky->solve(problem.right_hand_side);
  return problem;
}

/// A 50 x 71 x 50 mm ellipsoid of ripe kiwi flesh (configs/products/kiwi_ripe.toml) in cells of 4 mm.
LatticeParameters kiwi() {
  LatticeParameters product;
  product.shape = Shape::ellipsoid;
  product.size_m = {0.050, 0.071, 0.050};
  product.cell_size_m = 0.004;
  product.mass_kg = 0.095;
  product.youngs_modulus_Pa = 0.288e6;
  product.poisson_ratio = 0.35;
  product.relaxation_time_s = 0.2 / (2.0 * std::numbers::pi * 50.0);
  return product;
}

/// One row of a table: something that can be timed again and again.
struct Contender {
  std::string name;
  int width = 1;                       ///< right-hand sides per call
  std::function<double()> measure_s;   ///< one call, timed
  std::function<double()> difference;  ///< largest relative difference to the reference solution; empty: none
  double largest_difference = kLargestDifference;
  double peak = 1.0;  ///< multiply-adds of its precision over those of double precision
  Samples samples = {};

  [[nodiscard]] double best_us() const { return 1e6 * samples.best_s() / width; }
  [[nodiscard]] double median_us() const { return 1e6 * samples.median_s() / width; }
};

void measure_in_turns(std::vector<Contender>& contenders) {
  for (int turn = 0; turn < kTurns; ++turn) {
    for (Contender& contender : contenders) {
      contender.measure_s();  // caches and predictors belong to this contender now
      for (int i = 0; i < kSamplesPerTurn; ++i) contender.samples.add(contender.measure_s());
    }
  }
}

Contender peak() {
  const auto measure_s = [] {
    volatile double result = 0.0;
    return seconds_of([&] { result = FmaPeak::run(); });
  };
  return {"multiply-add peak", 1, measure_s, {}};
}

Contender cholmod_one(const Problem& problem) {
  return {"CHOLMOD, 1 right-hand side",
          1,
          [&problem] {
            std::vector<double> x;
            return seconds_of([&] { x = problem.cholesky->solve(problem.right_hand_side); });
          },
          {}};
}

Contender cholmod_many(const Problem& problem) {
  std::vector<double> b;
  for (int i = 0; i < kManyRightHandSides; ++i) {
    b.insert(b.end(), problem.right_hand_side.begin(), problem.right_hand_side.end());
  }
  return {"CHOLMOD, 32 right-hand sides",
          kManyRightHandSides,
          [&problem, b = std::move(b)] {
            std::vector<double> x;
            return seconds_of([&] { x = problem.cholesky->solve_many(b, kManyRightHandSides); });
          },
          {}};
}

/// `Width` right-hand sides in elimination order, lane innermost; lane l holds (1 + l / 10) times the problem's.
template <class Number>
class LaneVector {
 public:
  LaneVector(const Problem& problem, int width)
      : problem_(problem), width_(static_cast<std::size_t>(width)), x_(problem.size() * width_) {}

  Number* data() { return x_.data(); }
  void fill() {
    for_each([&](std::size_t at, int freedom, double scale) {
      x_[at] = static_cast<Number>(scale * problem_.right_hand_side[static_cast<std::size_t>(freedom)]);
    });
  }
  /// Largest difference to the reference solution / largest entry of that.
  [[nodiscard]] double difference() const {
    double difference = 0.0, largest = 0.0;
    for_each([&](std::size_t at, int freedom, double scale) {
      const double wanted = scale * problem_.solution[static_cast<std::size_t>(freedom)];
      const double error = std::abs(static_cast<double>(x_[at]) - wanted);
      difference = std::isnan(error) ? HUGE_VAL : std::max(difference, error);
      largest = std::max(largest, std::abs(wanted));
    });
    return difference / largest;
  }

 private:
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t row = 0; row < problem_.size(); ++row) {
      for (std::size_t lane = 0; lane < width_; ++lane) {
        visit(row * width_ + lane, problem_.factor.permutation[row], 1.0 + 0.1 * static_cast<double>(lane));
      }
    }
  }

  const Problem& problem_;
  std::size_t width_;
  std::vector<Number, LaneAllocator<Number>> x_;
};

/// A contender that solves in place with `solve(factor, x)`.
template <class Number = double, class Solve>
Contender lanes(std::string name, int width, const Problem& problem, Solve solve) {
  auto x = std::make_shared<LaneVector<Number>>(problem, width);
  return {std::move(name), width,
          [x, &problem, solve] {
            x->fill();
            return seconds_of([&] { solve(problem.factor, x->data()); });
          },
          [x] { return x->difference(); }};
}

template <class Pack>
Contender pack(std::string name, const Problem& problem) {
  return lanes(std::move(name), Pack::size, problem, [](const SupernodalFactor& factor, double* x) {
    for (const Supernode& s : factor.supernode) kernels::forward_supernode<Pack>(factor, s, x);
    for (std::size_t i = factor.supernode.size(); i-- > 0;) {
      kernels::backward_supernode<Pack>(factor, factor.supernode[i], x);
    }
  });
}

template <int Width>
void add_packs(const Problem& problem, std::vector<Contender>& contenders) {
  contenders.push_back(pack<OpenMpPack<Width>>("omp simd arrays", problem));
#if UNBRUISED_HAS_XSIMD
  contenders.push_back(pack<XsimdPack<Width>>("xsimd", problem));
#endif
  contenders.push_back(pack<LanePack<Width>>("std::experimental::simd", problem));
}

/// The first rows of a problem's table.
enum Row { kPeak, kCholmodOne, kCholmodMany, kLaneSolve, kSingleSolve };

std::vector<Contender> make_contenders(const Problem& problem) {
  std::vector<Contender> contenders = {peak(), cholmod_one(problem), cholmod_many(problem)};
  contenders.push_back(lanes("lane solve", kLanes, problem, [](const SupernodalFactor& factor, double* x) {
    solve_forward(factor, x);
    solve_backward(factor, x);
  }));
  contenders.push_back(
      lanes<float>("in single precision", kLanes, problem, [](const SupernodalFactor& factor, float* x) {
        solve_forward(factor, x);
        solve_backward(factor, x);
      }));
  contenders.back().largest_difference = kLargestSingleDifference;
  contenders.back().peak = 2.0;
  add_packs<8>(problem, contenders);
  add_packs<16>(problem, contenders);
  add_packs<24>(problem, contenders);
  add_packs<32>(problem, contenders);
  return contenders;
}

void print_table(const Problem& problem, const std::vector<Contender>& contenders, double peak_flops_s) {
  std::printf("  %-30s %5s %12s %12s %9s %8s %12s\n", "", "width", "best us/rhs", "median", "GFlop/s", "of peak",
              "difference");
  for (std::size_t row = kCholmodOne; row < contenders.size(); ++row) {
    const Contender& c = contenders[row];
    const double flops_s = 1e6 * problem.useful_flops() / c.best_us();
    std::printf("  %-30s %5d %12.2f %12.2f %9.1f %7.1f%%", c.name.c_str(), c.width, c.best_us(), c.median_us(),
                1e-9 * flops_s, 100.0 * flops_s / (c.peak * peak_flops_s));
    if (c.difference) {
      std::printf(" %12.1e\n", c.difference());
    } else {
      std::printf(" %12s\n", "reference");
    }
    if (row == kSingleSolve) std::printf("  the same kernels with other packs and widths:\n");
  }
}

void print_problem(const Problem& problem) {
  const SupernodalFactor& factor = problem.factor;
  std::printf("\n%s: %zu particles, %d freedoms; L: %zu entries, %zu stored (%.2f MB) in %zu supernodes\n",
              problem.name.c_str(), problem.particle_count, factor.size, factor.entry_count, factor.value.size(),
              1e-6 * static_cast<double>(factor.value.size() * sizeof(double)), factor.supernode.size());
  const double ours_s = problem.factor_time.best_s(), cholmod_s = problem.cholesky_time.best_s();
  std::printf("  ordered and factored in %.1f ms, %.2f of CHOLMOD's simplicial %.1f ms in the same run\n",
              1e3 * ours_s, ours_s / cholmod_s, 1e3 * cholmod_s);
}

/// @return false when a solution is wrong or a rate impossible.
bool compare(const Problem& problem) {
  std::vector<Contender> contenders = make_contenders(problem);
  measure_in_turns(contenders);
  const Samples& peak_samples = contenders[kPeak].samples;
  const double peak_flops_s = FmaPeak::kFlops / peak_samples.best_s();
  print_problem(problem);
  std::printf("  multiply-add peak of one core in this run: %.1f GFlop/s best, %.1f median\n", 1e-9 * peak_flops_s,
              1e-9 * FmaPeak::kFlops / peak_samples.median_s());
  print_table(problem, contenders, peak_flops_s);
  const double lane_us = contenders[kLaneSolve].best_us();
  std::printf(
      "  lane solve executes %.2f times the useful flops (zeros stored in supernodes): %.1f %% of the peak\n",
      problem.factor.solve_flops() / problem.useful_flops(),
      1e8 * problem.factor.solve_flops() / lane_us / peak_flops_s);
  std::printf("  lane solve is %.2f times as fast per right-hand side as CHOLMOD with 1, %.2f times as with %d\n",
              contenders[kCholmodOne].best_us() / lane_us, contenders[kCholmodMany].best_us() / lane_us,
              kManyRightHandSides);

  bool sound = true;
  for (const Contender& c : contenders) {
    const bool wrong = c.difference && !(c.difference() < c.largest_difference);
    const bool impossible =
        c.difference && 1e6 * problem.factor.solve_flops() / c.best_us() >= c.peak * peak_flops_s;
    if (wrong) std::fprintf(stderr, "%s, width %d: the solution is wrong\n", c.name.c_str(), c.width);
    if (impossible) std::fprintf(stderr, "%s, width %d: faster than the peak\n", c.name.c_str(), c.width);
    sound = sound && !wrong && !impossible;
  }
  return sound;
}

int run() {
  std::printf(
      "Triangular solves, forward and backward; times per right-hand side, best and median of %d samples.\n",
      kTurns * kSamplesPerTurn);
  std::printf("GFlop/s are useful ones: 4 x entries of L per right-hand side, stored zeros not counted.\n");
  std::printf("Native vectors hold %zu doubles; the lane width of this build is %d.\n", FmaPeak::Vector::size(),
              kLanes);
  if (!UNBRUISED_HAS_XSIMD) std::printf("xsimd is not installed (libxsimd-dev): its rows are missing.\n");
  bool sound = true;
  for (const auto& [name, product] : {std::pair{"cube512", cube512_product()}, std::pair{"kiwi, 4 mm", kiwi()}}) {
    const std::optional<Problem> problem = make_problem(name, product);
    sound = problem && compare(*problem) && sound;
    std::fflush(stdout);
  }
  return sound ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace unbruised::benchmarks

int main() { return unbruised::benchmarks::run(); }

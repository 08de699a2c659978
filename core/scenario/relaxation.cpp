#include "core/scenario/relaxation.hpp"

#include <algorithm>
#include <cmath>

namespace unbruised {
namespace {

/// Shares that are written with some digits add up to 1 within this.
constexpr double kRounding = 1e-9;

template <class Parameters>
std::vector<RelaxationBranch> written_branches(const Parameters& p) {
  std::vector<RelaxationBranch> branches;
  const std::size_t count = std::min(p.prony_modulus.size(), p.prony_time_s.size());
  for (std::size_t i = 0; i < count; ++i) branches.push_back({p.prony_modulus[i], p.prony_time_s[i]});
  return branches;
}

/// By what a modulus that is written has to be multiplied to be the instantaneous one.
template <class Parameters>
double instantaneous_factor(const Parameters& p) {
  if (p.prony_from != PronyFrom::long_term) return 1.0;
  const double share = long_term_share(written_branches(p));
  return share > 0.0 ? 1.0 / share : 1.0;
}

template <class Parameters>
bool ends_soft(const Parameters& p) {
  return long_term_share(relaxation_branches(p)) == 0.0;
}

}  // namespace

std::vector<RelaxationBranch> burgers_branches(double flow_time_s, double recovery_share, double recovery_time_s) {
  // Under a closure that is held the force is a sum of two exponentials, whose rates solve p2 r^2 - p1 r + 1 = 0.
  const double c1 = flow_time_s, c2 = recovery_time_s * recovery_share, k2 = recovery_share;  // all over k1
  const double p1 = c1 + c1 / k2 + c2 / k2, p2 = c1 * c2 / k2, q1 = c1, q2 = p2;
  const double A = std::sqrt(p1 * p1 - 4.0 * p2);
  const double slow = 2.0 / (p1 + A), fast = (p1 + A) / (2.0 * p2);
  return {{(q1 - q2 * slow) / A, 1.0 / slow}, {(q2 * fast - q1) / A, 1.0 / fast}};
}

std::vector<RelaxationBranch> relaxation_branches(const LatticeParameters& p) {
  if (p.burgers_flow_time_s && p.burgers_recovery_modulus && p.burgers_recovery_time_s) {
    return burgers_branches(*p.burgers_flow_time_s, *p.burgers_recovery_modulus, *p.burgers_recovery_time_s);
  }
  return written_branches(p);
}

std::vector<RelaxationBranch> relaxation_branches(const NetworkSpring& p) {
  if (p.burgers_flow_N_s_m && p.burgers_recovery_N_m && p.burgers_recovery_N_s_m) {
    return burgers_branches(*p.burgers_flow_N_s_m / p.stiffness_N_m, *p.burgers_recovery_N_m / p.stiffness_N_m,
                            *p.burgers_recovery_N_s_m / *p.burgers_recovery_N_m);
  }
  return written_branches(p);
}

double long_term_share(std::span<const RelaxationBranch> branches) {
  double share = 1.0;
  for (const RelaxationBranch& branch : branches) share -= branch.share;
  return share > kRounding ? share : 0.0;
}

double instantaneous_modulus_Pa(const LatticeParameters& product) {
  return instantaneous_factor(product) * product.youngs_modulus_Pa;
}

double instantaneous_modulus_Pa(const LatticeParameters& product, double youngs_modulus_Pa) {
  return youngs_modulus_Pa * (instantaneous_modulus_Pa(product) / product.youngs_modulus_Pa);
}
double instantaneous_stiffness_N_m(const NetworkSpring& spring) {
  return instantaneous_factor(spring) * spring.stiffness_N_m;
}

bool flows(const LatticeParameters& product) { return ends_soft(product); }
bool flows(const NetworkParameters& product) {
  return std::ranges::any_of(product.spring, [](const NetworkSpring& spring) { return ends_soft(spring); });
}

}  // namespace unbruised

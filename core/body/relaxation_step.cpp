#include "core/body/relaxation_step.hpp"

#include <cmath>

namespace unbruised {

double RelaxationStep::flow_time_s() const {
  double sum = 0.0;
  for (const BranchStep& b : branch) sum += b.share * b.time_s;
  return sum;
}

RelaxationStep relaxation_step(std::span<const RelaxationBranch> branches, const WilsonTheta& w) {
  RelaxationStep step;
  step.long_term = step.stiffness_theta = long_term_share(branches);
  for (const auto& [share, tau] : branches) {
    const double h_theta = w.theta * w.dt;
    const BranchStep branch{.share = share,
                            .time_s = tau,
                            .keep_theta = std::exp(-h_theta / tau),
                            .gain_theta = -std::expm1(-h_theta / tau) * tau / h_theta,
                            .keep = std::exp(-w.dt / tau),
                            .gain = -std::expm1(-w.dt / tau) * tau / w.dt};
    step.stiffness_theta += share * branch.gain_theta;
    step.branch.push_back(branch);
  }
  return step;
}

}  // namespace unbruised

#include "core/material/lattice_relaxation.hpp"

#include "core/door/require.hpp"

namespace unbruised {

LatticeRelaxation::LatticeRelaxation(const BodyModel& body) : step_(body.relaxation) {
  const std::size_t freedoms = 3 * body.particle_count;
  require(!step_.branch.empty(), "LatticeRelaxation: nothing fades");
  q_.assign(step_.branch.size(), LaneArray(freedoms));
  for (LaneArray* rows : {&remembered_, &u_start_, &stressed_}) *rows = LaneArray(freedoms);
}

void LatticeRelaxation::load(int lane) {
  for (LaneArray& q : q_) q.clear_lane(lane);
  work_.set(lane, 0.0);
  power_.set(lane, 0.0);
  last_step_s_.set(lane, 0.0);
}

void LatticeRelaxation::settle(int lane, const LaneArray& u) {
  if (!step_.flows()) return;
  for (LaneArray& q : q_) {
    for (std::size_t i = 0; i < u.rows(); ++i) q.at(i, lane) = u.at(i, lane);
  }
}

void LatticeRelaxation::begin_step(const LaneArray& u) {
  double of_u = 0.0;
  for (const BranchStep& b : step_.branch) of_u -= b.share * b.gain_theta;
  for (std::size_t i = 0; i < u.rows(); ++i) {
    const Lane at_start = u.get(i);
    Lane remembered = Lane(of_u) * at_start, stressed = Lane(step_.long_term) * at_start;
    for (std::size_t k = 0; k < q_.size(); ++k) {
      const BranchStep& b = step_.branch[k];
      const Lane q = q_[k].get(i);
      remembered += Lane(b.share * b.keep_theta) * q;
      stressed += Lane(b.share) * q;
    }
    remembered_.put(i, remembered);
    stressed_.put(i, stressed);
    u_start_.put(i, at_start);
  }
}

void LatticeRelaxation::end_step(const LaneArray& u, const Mask& running) {
  for (std::size_t i = 0; i < u.rows(); ++i) {
    const Lane moved = u.get(i) - u_start_.get(i);
    for (std::size_t k = 0; k < q_.size(); ++k) {
      const BranchStep& b = step_.branch[k];
      const Lane q = q_[k].get(i);
      q_[k].put(i, select(running, Lane(b.keep) * q + Lane(b.gain) * moved, q));
    }
  }
}

void LatticeRelaxation::book_power(double time_step_s, const LaneArray& rate, const LaneArray& stiffness_rate,
                                   const LaneArray& plastic_load, const Mask& running) {
  Lane power(0.0);
  for (std::size_t i = 0; i < rate.rows(); ++i) {
    power += stressed_.get(i) * stiffness_rate.get(i) - plastic_load.get(i) * rate.get(i);
  }
  // By the trapezoid rule over time.
  work_ += select(running, Lane(0.5) * (last_step_s_ + Lane(time_step_s)) * power, Lane(0.0));
  last_step_s_ = select(running, Lane(time_step_s), last_step_s_);
  power_ = select(running, power, power_);
}

std::vector<double> LatticeRelaxation::flowed_m(int lane, const LaneArray& u) const {
  std::vector<double> flowed(u.rows());
  const double whole = step_.flow_time_s();
  for (std::size_t i = 0; i < flowed.size(); ++i) {
    flowed[i] = u.at(i, lane);
    for (std::size_t k = 0; k < q_.size(); ++k) {
      const BranchStep& b = step_.branch[k];
      flowed[i] -= b.share * b.time_s / whole * q_[k].at(i, lane);
    }
  }
  return flowed;
}

}  // namespace unbruised

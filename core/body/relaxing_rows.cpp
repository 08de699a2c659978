#include "core/body/relaxing_rows.hpp"

#include "core/door/require.hpp"

namespace unbruised {

RelaxingRows::RelaxingRows(const RelaxationStep& step, std::size_t rows) : step_(step) {
  require(!step_.branch.empty(), "RelaxingRows: nothing fades");
  q_.assign(step_.branch.size(), LaneArray(rows));
  for (LaneArray* each : {&remembered_, &u_start_, &stressed_}) *each = LaneArray(rows);
}

void RelaxingRows::load(int lane) {
  for (LaneArray& q : q_) q.clear_lane(lane);
}

void RelaxingRows::settle(int lane, const LaneArray& u) {
  if (!step_.flows()) return;
  for (LaneArray& q : q_) {
    for (std::size_t i = 0; i < u.rows(); ++i) q.at(i, lane) = u.at(i, lane);
  }
}

void RelaxingRows::begin_step(const LaneArray& u) {
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

void RelaxingRows::end_step(const LaneArray& u, const Mask& running) {
  for (std::size_t i = 0; i < u.rows(); ++i) {
    const Lane moved = u.get(i) - u_start_.get(i);
    for (std::size_t k = 0; k < q_.size(); ++k) {
      const BranchStep& b = step_.branch[k];
      const Lane q = q_[k].get(i);
      q_[k].put(i, select(running, Lane(b.keep) * q + Lane(b.gain) * moved, q));
    }
  }
}

std::vector<double> RelaxingRows::flowed_m(int lane, const LaneArray& u) const {
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

#include "core/material/spring_plasticity.hpp"

#include <algorithm>
#include <cmath>

#include "core/body/body_state.hpp"
#include "core/door/require.hpp"

namespace unbruised {
namespace {

/// Converged when a further solve would move a spring's plastic elongation by less than this share of its length.
constexpr double kTolerance = 1e-9;

/// Return mapping: the plastic elongation by which a spring with the elastic force `trial` flows, >= 0.
/// @param share of its stiffness, with which that force falls as it flows
template <class T>
T flow_of(const SpringGeometry& spring, double share, const T& trial, const T& accumulated) {
  using std::abs;
  using std::max;
  const T k(spring.stiffness);
  const T excess = abs(trial) - T(spring.yield_force) - T(spring.hardening_ratio) * k * accumulated;
  return max(excess, T(0.0)) / (k * T(share + spring.hardening_ratio));
}

/// Elongation of a spring since it was mounted. @param u_m displacements, [3n]
double elongation_m(const SpringGeometry& spring, const std::vector<double>& u_m) {
  const auto a = 3 * static_cast<std::size_t>(spring.a), b = 3 * static_cast<std::size_t>(spring.b);
  double elongation = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    elongation += spring.direction[axis] * (u_m[b + axis] - u_m[a + axis]);
  }
  return elongation;
}

}  // namespace

SpringPlasticity::SpringPlasticity(const BodyModel& body, const WilsonTheta& wilson)
    : body_(body), springs_(body.springs) {
  std::size_t branches = 0;
  for (std::size_t s = 0; s < springs_.size(); ++s) {
    if (!std::isfinite(springs_[s].yield_force) && springs_[s].branch.empty()) continue;
    followed_.push_back(static_cast<int>(s));
    step_.push_back(relaxation_step(springs_[s].branch, wilson));
    first_branch_.push_back(branches);
    branches += springs_[s].branch.size();
    flows_ = flows_ || springs_[s].flows();
  }
  relaxes_ = branches > 0;
  for (LaneArray* rows :
       {&elongation_, &elongation_theta_, &accumulated_, &accumulated_theta_, &stretch_, &past_}) {
    *rows = LaneArray(followed_.size());
  }
  q_ = LaneArray(branches);
  load_ = LaneArray(3 * body.particle_count);
  load_theta_ = LaneArray(3 * body.particle_count);
}

void SpringPlasticity::load(int lane, const Scenario& scenario) {
  require(is_lane(lane), "SpringPlasticity::load: there is no such lane");
  for (LaneArray* rows : {&elongation_, &elongation_theta_, &accumulated_, &accumulated_theta_, &load_,
                          &load_theta_, &stretch_, &q_}) {
    rows->clear_lane(lane);
  }
  clear_account(lane);
  relaxed_.set(lane, 0.0);
  const BodyState begin = written_state(scenario.product, body_);
  for (std::size_t i = 0; i < followed_.size(); ++i) yield_as_mounted(lane, i, begin.displacement_m);
}

void SpringPlasticity::settle(int lane, const LaneArray& u) {
  for (std::size_t i = 0; relaxes_ && i < followed_.size(); ++i) {
    const SpringGeometry& spring = springs_[followed_[i]];
    const double stretch = spring.initial_elongation + elongation(spring, u)[lane] - elongation_.at(i, lane);
    stretch_.at(i, lane) = stretch;
    for (std::size_t k = 0; k < spring.branch.size(); ++k) q_.at(first_branch_[i] + k, lane) = stretch;
  }
}

Lane SpringPlasticity::elongation(const SpringGeometry& spring, const LaneArray& u) const {
  const auto a = 3 * static_cast<std::size_t>(spring.a), b = 3 * static_cast<std::size_t>(spring.b);
  Lane elongation(0.0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    elongation += Lane(spring.direction[axis]) * (u.get(b + axis) - u.get(a + axis));
  }
  return elongation;
}

/// Adds a force to the load at t + theta dt, on b along the spring.
void SpringPlasticity::pull(const SpringGeometry& spring, const Lane& force) {
  const auto a = 3 * static_cast<std::size_t>(spring.a), b = 3 * static_cast<std::size_t>(spring.b);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Lane part = Lane(spring.direction[axis]) * force;
    load_theta_.put(b + axis, load_theta_.get(b + axis) + part);
    load_theta_.put(a + axis, load_theta_.get(a + axis) - part);
  }
}

/// What is remembered is a load, and so is what the stiffness at t + theta dt lacks of the force that a spring is
/// mounted with.
void SpringPlasticity::begin_step(const LaneArray& /*u*/) {
  if (!relaxes_) return;
  load_theta_.fill(0.0);
  for (std::size_t i = 0; i < followed_.size(); ++i) {
    const SpringGeometry& spring = springs_[followed_[i]];
    const RelaxationStep& step = step_[i];
    Lane past(0.0);
    for (std::size_t k = 0; k < step.branch.size(); ++k) {
      const BranchStep& b = step.branch[k];
      past += Lane(b.share) *
              (Lane(b.keep_theta) * q_.get(first_branch_[i] + k) - Lane(b.gain_theta) * stretch_.get(i));
    }
    past_.put(i, past);
    const Lane mounted((1.0 - step.stiffness_theta) * spring.initial_elongation);
    pull(spring, Lane(spring.stiffness) * (Lane(step.stiffness_theta) * elongation_.get(i) - past + mounted));
  }
}

/// What is mounted beyond its yield force has flowed before the clock starts: nothing of it is booked.
void SpringPlasticity::yield_as_mounted(int lane, std::size_t i, const std::vector<double>& begin_m) {
  const SpringGeometry& spring = springs_[followed_[i]];
  const double trial = spring.stiffness * (spring.initial_elongation + elongation_m(spring, begin_m));
  const double flow = flow_of(spring, 1.0, trial, 0.0);
  if (flow == 0.0) return;
  const double signed_flow = trial < 0.0 ? -flow : flow;
  for (LaneArray* rows : {&elongation_, &elongation_theta_}) rows->at(i, lane) = signed_flow;
  for (LaneArray* rows : {&accumulated_, &accumulated_theta_}) rows->at(i, lane) = flow;
  largest_plastic_.set(lane, std::max(largest_plastic_[lane], flow / spring.rest_length));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double force = spring.direction[axis] * spring.stiffness * signed_flow;
    for (LaneArray* rows : {&load_, &load_theta_}) {
      const auto a = 3 * static_cast<std::size_t>(spring.a) + axis;
      const auto b = 3 * static_cast<std::size_t>(spring.b) + axis;
      rows->at(b, lane) += force;
      rows->at(a, lane) -= force;
    }
  }
}

void SpringPlasticity::archive(LaneArchive& lane) {
  Material::archive(lane);
  lane(elongation_, elongation_theta_, accumulated_, accumulated_theta_, load_, load_theta_);
  lane(stretch_, q_, relaxed_);
}

Mask SpringPlasticity::update(const LaneArray& u_theta, const Mask& active) {
  require(u_theta.rows() == load_.rows(), "SpringPlasticity::update: displacements of another body");
  Mask pending(false);
  for (std::size_t i = 0; i < followed_.size(); ++i) {
    const SpringGeometry& spring = springs_[followed_[i]];
    if (!std::isfinite(spring.yield_force)) continue;
    const double share = step_[i].stiffness_theta;
    const Lane k(spring.stiffness);
    Lane stretch = Lane(spring.initial_elongation) + (elongation(spring, u_theta) - elongation_.get(i));
    if (relaxes_) stretch = Lane(share) * stretch + past_.get(i);
    const Lane trial = k * stretch;
    const Lane flow = flow_of(spring, share, trial, accumulated_.get(i));
    const Lane signed_flow = select(trial < Lane(0.0), -flow, flow);
    const Lane before = elongation_theta_.get(i);
    const Lane after = select(active, elongation_.get(i) + signed_flow, before);
    elongation_theta_.put(i, after);
    accumulated_theta_.put(i, select(active, accumulated_.get(i) + flow, accumulated_theta_.get(i)));
    const Lane change = after - before;
    pending = pending | (active & (abs(change) > Lane(kTolerance * spring.rest_length)));
    pull(spring, k * Lane(share) * change);
  }
  return pending;
}

void SpringPlasticity::end_step(const LaneArray& u, const WilsonTheta& w, const Mask& running) {
  for (std::size_t i = 0; i < followed_.size(); ++i) {
    const SpringGeometry& spring = springs_[followed_[i]];
    if (std::isfinite(spring.yield_force)) {
      take_over(w, running, i, elongation_, elongation_theta_);
      const Lane before = accumulated_.get(i);
      const Lane after = take_over(w, running, i, accumulated_, accumulated_theta_);
      const Lane stored =
          Lane(0.5 * spring.hardening_ratio * spring.stiffness) * (after * after - before * before);
      hardening_energy_ += stored;
      plastic_work_ += stored + Lane(spring.yield_force) * (after - before);
      largest_plastic_ = max(largest_plastic_, after / Lane(spring.rest_length));
    }
    if (relaxes_) end_branches(i, u, w, running);
  }
  for (std::size_t i = 0; i < load_.rows(); ++i) take_over(w, running, i, load_, load_theta_);
}

/// Moves what a spring remembers to t + dt, and books what that costs: exact for a stretch linear over the step,
/// where int q dt = tau (change of stretch - change of q).
void SpringPlasticity::end_branches(std::size_t i, const LaneArray& u, const WilsonTheta& w, const Mask& running) {
  const SpringGeometry& spring = springs_[followed_[i]];
  const Lane before = stretch_.get(i);
  const Lane after = Lane(spring.initial_elongation) + elongation(spring, u) - elongation_.get(i);
  const Lane change = after - before;
  stretch_.put(i, select(running, after, before));
  for (std::size_t k = 0; k < step_[i].branch.size(); ++k) {
    const BranchStep& b = step_[i].branch[k];
    const std::size_t row = first_branch_[i] + k;
    const Lane q = q_.get(row);
    const Lane next = Lane(b.keep) * q + Lane(b.gain) * change;
    const Lane work = Lane(b.time_s / w.dt) * (change - (next - q)) * change;
    const Lane lost = Lane(b.share * spring.stiffness) * (work - Lane(0.5) * (next * next - q * q));
    relaxed_ += select(running, lost, Lane(0.0));
    q_.put(row, select(running, next, q));
  }
}

double SpringPlasticity::self_energy(int lane, const LaneArray& /*u*/) const {
  double energy = 0.0;
  for (std::size_t i = 0; i < followed_.size(); ++i) {
    const double e = elongation_.at(i, lane);
    const SpringGeometry& spring = springs_[followed_[i]];
    energy += spring.stiffness * e * (0.5 * e - spring.initial_elongation);
    if (step_[i].branch.empty()) continue;
    const double x = stretch_.at(i, lane);
    double faded = 0.5 * (step_[i].long_term - 1.0) * x * x;
    for (std::size_t k = 0; k < step_[i].branch.size(); ++k) {
      const double q = q_.at(first_branch_[i] + k, lane);
      faded += 0.5 * step_[i].branch[k].share * q * q;
    }
    energy += spring.stiffness * faded;
  }
  return energy;
}

template <class Force>
std::vector<double> SpringPlasticity::load_of(const Force& force_N) const {
  std::vector<double> load(3 * body_.particle_count, 0.0);
  for (std::size_t i = 0; i < followed_.size(); ++i) {
    const SpringGeometry& spring = springs_[followed_[i]];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double part = spring.direction[axis] * force_N(i);
      load[3 * static_cast<std::size_t>(spring.b) + axis] += part;
      load[3 * static_cast<std::size_t>(spring.a) + axis] -= part;
    }
  }
  return load;
}

std::vector<double> SpringPlasticity::plastic_load_N(int lane) const {
  if (!relaxes_) return of_lane(load_, lane);
  return load_of([&](std::size_t i) { return springs_[followed_[i]].stiffness * elongation_.at(i, lane); });
}

LastingShape SpringPlasticity::lasting(int lane, const LaneArray& /*u*/) const {
  if (!relaxes_) return {of_lane(load_, lane), {}};
  return {load_of([&](std::size_t i) {
            const SpringGeometry& spring = springs_[followed_[i]];
            double kept = elongation_.at(i, lane);
            if (spring.flows()) {
              kept += stretch_.at(i, lane);
              for (std::size_t k = 0; k < step_[i].branch.size(); ++k) {
                const BranchStep& b = step_[i].branch[k];
                kept -= b.share * b.time_s / step_[i].flow_time_s() * q_.at(first_branch_[i] + k, lane);
              }
            }
            return spring.rest_share * spring.stiffness * kept;
          }),
          {}};
}

}  // namespace unbruised

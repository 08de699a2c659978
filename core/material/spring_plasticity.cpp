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
template <class T>
T flow_of(const SpringGeometry& spring, const T& trial, const T& accumulated) {
  using std::abs;
  using std::max;
  const T k(spring.stiffness);
  const T excess = abs(trial) - T(spring.yield_force) - T(spring.hardening_ratio) * k * accumulated;
  return max(excess, T(0.0)) / (k * T(1.0 + spring.hardening_ratio));
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

SpringPlasticity::SpringPlasticity(const BodyModel& body) : body_(body), springs_(body.springs) {
  for (std::size_t s = 0; s < springs_.size(); ++s) {
    if (std::isfinite(springs_[s].yield_force)) yielding_spring_.push_back(static_cast<int>(s));
  }
  for (LaneArray* rows : {&elongation_, &elongation_theta_, &accumulated_, &accumulated_theta_}) {
    *rows = LaneArray(yielding_spring_.size());
  }
  load_ = LaneArray(3 * body.particle_count);
  load_theta_ = LaneArray(3 * body.particle_count);
}

void SpringPlasticity::load(int lane, const Scenario& scenario) {
  require(is_lane(lane), "SpringPlasticity::load: there is no such lane");
  for (LaneArray* rows :
       {&elongation_, &elongation_theta_, &accumulated_, &accumulated_theta_, &load_, &load_theta_}) {
    rows->clear_lane(lane);
  }
  clear_account(lane);
  const BodyState begin = written_state(scenario.product, body_);
  for (std::size_t i = 0; i < yielding_spring_.size(); ++i) yield_as_mounted(lane, i, begin.displacement_m);
}

/// What is mounted beyond its yield force has flowed before the clock starts: nothing of it is booked.
void SpringPlasticity::yield_as_mounted(int lane, std::size_t i, const std::vector<double>& begin_m) {
  const SpringGeometry& spring = springs_[yielding_spring_[i]];
  const double trial = spring.stiffness * (spring.initial_elongation + elongation_m(spring, begin_m));
  const double flow = flow_of(spring, trial, 0.0);
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
}

Mask SpringPlasticity::update(const LaneArray& u_theta, const Mask& active) {
  require(u_theta.rows() == load_.rows(), "SpringPlasticity::update: displacements of another body");
  Mask pending(false);
  for (std::size_t i = 0; i < yielding_spring_.size(); ++i) {
    const SpringGeometry& spring = springs_[yielding_spring_[i]];
    const auto a = 3 * static_cast<std::size_t>(spring.a);
    const auto b = 3 * static_cast<std::size_t>(spring.b);
    Lane elongation(0.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      elongation += Lane(spring.direction[axis]) * (u_theta.get(b + axis) - u_theta.get(a + axis));
    }
    const Lane k(spring.stiffness);
    const Lane trial = k * (Lane(spring.initial_elongation) + (elongation - elongation_.get(i)));
    const Lane flow = flow_of(spring, trial, accumulated_.get(i));
    const Lane signed_flow = select(trial < Lane(0.0), -flow, flow);
    const Lane before = elongation_theta_.get(i);
    const Lane after = select(active, elongation_.get(i) + signed_flow, before);
    elongation_theta_.put(i, after);
    accumulated_theta_.put(i, select(active, accumulated_.get(i) + flow, accumulated_theta_.get(i)));
    const Lane change = after - before;
    pending = pending | (active & (abs(change) > Lane(kTolerance * spring.rest_length)));
    const Lane force = k * change;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Lane part = Lane(spring.direction[axis]) * force;
      load_theta_.put(b + axis, load_theta_.get(b + axis) + part);
      load_theta_.put(a + axis, load_theta_.get(a + axis) - part);
    }
  }
  return pending;
}

void SpringPlasticity::end_step(const WilsonTheta& w, const Mask& running) {
  for (std::size_t i = 0; i < yielding_spring_.size(); ++i) {
    const SpringGeometry& spring = springs_[yielding_spring_[i]];
    take_over(w, running, i, elongation_, elongation_theta_);
    const Lane before = accumulated_.get(i);
    const Lane after = take_over(w, running, i, accumulated_, accumulated_theta_);
    const Lane stored = Lane(0.5 * spring.hardening_ratio * spring.stiffness) * (after * after - before * before);
    hardening_energy_ += stored;
    plastic_work_ += stored + Lane(spring.yield_force) * (after - before);
    largest_plastic_ = max(largest_plastic_, after / Lane(spring.rest_length));
  }
  for (std::size_t i = 0; i < load_.rows(); ++i) take_over(w, running, i, load_, load_theta_);
}

double SpringPlasticity::self_energy(int lane) const {
  double energy = 0.0;
  for (std::size_t i = 0; i < yielding_spring_.size(); ++i) {
    const double e = elongation_.at(i, lane);
    const SpringGeometry& spring = springs_[yielding_spring_[i]];
    energy += spring.stiffness * e * (0.5 * e - spring.initial_elongation);
  }
  return energy;
}

std::vector<double> SpringPlasticity::plastic_load_N(int lane) const { return of_lane(load_, lane); }

}  // namespace unbruised

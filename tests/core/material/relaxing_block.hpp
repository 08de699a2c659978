#pragma once

/// @file
/// A block whose stiffness fades, held at its side -x and pulled along x at its side +x, without a simulator
/// around it: whatever the shape, its displacement is that of an elastic block times the creep of its material.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/body/body_lanes.hpp"
#include "core/material/material.hpp"

namespace unbruised::testing {

/// The carrot of Xia et al. 2021 as issue and literature have it: two branches.
inline const std::vector<double> kCarrotModulus = {0.218, 0.233}, kCarrotTime_s = {1.68, 26.3};

inline LatticeParameters small_block() {
  LatticeParameters block;
  block.size_m = {0.02, 0.01, 0.01};
  block.cell_size_m = 0.005;
  block.density_kg_m3 = 1000.0;
  block.youngs_modulus_Pa = 3e6;
  block.poisson_ratio = 0.3;
  block.relaxation_time_s = 0.0;
  return block;
}

class HeldBlock {
 public:
  HeldBlock(const LatticeParameters& product, double time_step_s)
      : w_(time_step_s, 1.4), model_(build(product, w_)), body_(model_, w_), material_(make_material(model_, w_)) {
    load_.assign(3 * model_.particle_count, 0.0);
    Scenario scenario;
    scenario.product = product;
    const std::vector<double> zero(load_.size(), 0.0);
    material_->load(kLane, scenario);
    body_.load(kLane, {zero, zero, zero, {}}, {0.0, 0.0, 0.0});
    material_->settle(kLane, body_.u());
    all_.set(kLane, true);
  }

  /// @param force_N at t + theta dt, all of it
  void step(double force_N) {
    const auto& face = model_.lattice->side[1];
    for (const SurfacePoint& point : face) {
      load_[3 * static_cast<std::size_t>(point.node)] = force_N / static_cast<double>(face.size());
    }
    material_->begin_step(body_.u());
    body_.begin_step(all_, material_->remembered());
    material_->book_power(body_.rate(), body_.stiffness_rate(), all_);
    body_.add_forces(kLane, load_);
    Mask pending = all_;
    for (int round = 0; round < 100 && any(pending); ++round) {
      body_.start_solve(material_->load_theta());
      body_.finish_solve(all_);
      pending = material_->update(body_.u_theta(), all_);
    }
    body_.advance(all_);
    material_->end_step(body_.u(), w_, all_);
    ++steps_;
  }

  [[nodiscard]] double time_s() const { return steps_ * w_.dt; }
  /// Mean displacement of the pulled side along x.
  [[nodiscard]] double way_m() const {
    const auto& face = model_.lattice->side[1];
    double sum = 0.0;
    for (const SurfacePoint& point : face) sum += body_.u().at(3 * static_cast<std::size_t>(point.node), kLane);
    return sum / static_cast<double>(face.size());
  }
  [[nodiscard]] const WilsonTheta& wilson() const { return w_; }
  [[nodiscard]] const Material& material() const { return *material_; }
  [[nodiscard]] const BodyLanes& body() const { return body_; }
  [[nodiscard]] double relaxed_J() const { return material_->relaxed_J(kLane, body_.u()); }
  /// Of the material: elastic energy that is still there.
  [[nodiscard]] double elastic_J() const {
    const std::vector<double> plastic = material_->plastic_load_N(kLane);
    std::vector<double> u(plastic.size()), force(plastic.size());
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = body_.u().at(i, kLane);
    multiply(model_.K, u, force);
    double energy = material_->self_energy(kLane, body_.u());
    for (std::size_t i = 0; i < u.size(); ++i) energy += u[i] * (0.5 * force[i] - plastic[i]);
    return energy;
  }
  static constexpr int kLane = 5;

 private:
  static BodyModel build(const LatticeParameters& product, const WilsonTheta& w) {
    std::string error;
    auto body = build_held_body(product, w, error);
    if (!body) throw std::runtime_error(error);
    return std::move(*body);
  }

  WilsonTheta w_;
  BodyModel model_;
  BodyLanes body_;
  std::unique_ptr<Material> material_;
  std::vector<double> load_;
  Mask all_{false};
  int steps_ = 0;
};

/// Creep of two branches with a long-term modulus under a unit force that is there from t = 0 on, over the answer
/// at once: with the rates r of g_inf + sum g s / (s + 1 / tau) = 0 at s = -r, J = 1 / g_inf - sum c exp(-r t).
class TwoBranchCreep {
 public:
  TwoBranchCreep(double g1, double t1, double g2, double t2) : g_inf_(1.0 - g1 - g2) {
    // s^2 + b s + c = 0.
    const double b = g_inf_ * (1.0 / t1 + 1.0 / t2) + g1 / t2 + g2 / t1, c = g_inf_ / (t1 * t2);
    const double root = std::sqrt(b * b - 4.0 * c);
    rate_[0] = 0.5 * (b - root);
    rate_[1] = 0.5 * (b + root);
    for (int i = 0; i < 2; ++i) {
      // J's transform is (s + 1/t1) (s + 1/t2) / (s (s + r1) (s + r2)): its residues at -r.
      const double s = -rate_[i], other = rate_[1 - i];
      weight_[i] = (s + 1.0 / t1) * (s + 1.0 / t2) / (s * (s + other));
    }
  }
  [[nodiscard]] double at(double time_s) const {
    return 1.0 / g_inf_ + weight_[0] * std::exp(-rate_[0] * time_s) + weight_[1] * std::exp(-rate_[1] * time_s);
  }

 private:
  double g_inf_, rate_[2], weight_[2];
};

}  // namespace unbruised::testing

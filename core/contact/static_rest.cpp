#include "core/contact/static_rest.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/layer_law.hpp"
#include "core/door/eigen.hpp"

namespace unbruised {
namespace {

/// Passes over the touching places of the support; a few suffice.
constexpr int kMaxPasses = 100;

}  // namespace

SupportRest::SupportRest(const StaticSolver& statics, const ContactModel& contact)
    : statics_(statics), contact_(contact) {
  std::vector<std::size_t> freedoms;  // of their particles, along the support's normal; candidates go by particle
  for (std::size_t c = 0; c < contact.candidate.size(); ++c) {
    const double share = upright_share(contact, contact.candidate[c]);
    if (contact.candidate[c].surface != kSupport || !(share > 0.0)) continue;
    support_candidate_.push_back(static_cast<int>(c));
    share_.push_back(share);
    const std::size_t along = 3 * static_cast<std::size_t>(contact.candidate[c].node) + 2;
    if (freedoms.empty() || freedoms.back() != along) freedoms.push_back(along);
    node_.push_back(freedoms.size() - 1);
  }
  node_count_ = freedoms.size();
  compliance_ = statics.compliance(freedoms);
}

LayerSecant SupportRest::layer(std::size_t i, double layer_stiffness_N_m3, double penetration_m) const {
  LayerSecant secant = layer_at(candidate(i), layer_stiffness_N_m3, penetration_m);
  secant.stiffness *= share_[i];
  return secant;
}

SupportRest::Layers SupportRest::pressed_in(double weight_N, double layer_stiffness_N_m3) const {
  const std::size_t k = support_candidate_.size();
  Layers layers{layer_stiffness_N_m3, std::vector<double>(k, 0.0), std::vector<double>(k),
                std::vector<LayerSecant>(k)};
  // By the depth at which the layer of the whole body's footprint would carry it, at least.
  double area = 0.0, lowest_m = candidate(0).surface_m;
  for (std::size_t i = 0; i < k; ++i) {
    area += candidate(i).area_m2;
    lowest_m = std::min(lowest_m, candidate(i).surface_m + candidate(i).least_relief_m);
  }
  for (std::size_t i = 0; i < k; ++i) {
    layers.penetration_m[i] =
        4.0 * weight_N / (area * layer_stiffness_N_m3) + std::max(0.0, lowest_m) - candidate(i).surface_m;
    layers.secant[i] = layer(i, layer_stiffness_N_m3, layers.penetration_m[i]);
  }
  return layers;
}

void SupportRest::solve_forces(const std::vector<double>& free_m, Layers& layers) const {
  std::vector<std::size_t> active;
  for (std::size_t i = 0; i < layers.secant.size(); ++i) {
    if (layers.secant[i].touching > 0) active.push_back(i);
  }
  const auto count = static_cast<Eigen::Index>(active.size());
  Eigen::MatrixXd A(count, count);
  Eigen::VectorXd b(count);
  for (Eigen::Index r = 0; r < count; ++r) {
    const std::size_t i = active[static_cast<std::size_t>(r)];
    for (Eigen::Index c = 0; c < count; ++c) {
      A(r, c) = compliance(i, active[static_cast<std::size_t>(c)]);
    }
    A(r, r) += 1.0 / layers.secant[i].stiffness;
    b[r] = -(candidate(i).surface_m + free_m[freedom(i)] + layers.secant[i].relief);
  }
  const Eigen::VectorXd x = A.ldlt().solve(b);
  std::fill(layers.force_N.begin(), layers.force_N.end(), 0.0);
  for (Eigen::Index r = 0; r < count; ++r) layers.force_N[active[static_cast<std::size_t>(r)]] = x[r];
}

bool SupportRest::press(const std::vector<double>& free_m, Layers& layers) const {
  const std::size_t k = layers.secant.size();
  std::vector<std::size_t> pressed;
  for (std::size_t j = 0; j < k; ++j) {
    if (layers.force_N[j] != 0.0) pressed.push_back(j);
  }
  bool changed = false;
  for (std::size_t i = 0; i < k; ++i) {
    layers.penetration_m[i] = -(candidate(i).surface_m + free_m[freedom(i)]);
    for (const std::size_t j : pressed) layers.penetration_m[i] -= compliance(i, j) * layers.force_N[j];
    const LayerSecant next = layer(i, layers.stiffness_N_m3, layers.penetration_m[i]);
    changed = changed || next.touching != layers.secant[i].touching;
    layers.secant[i] = next;
  }
  // Nothing touches: the guess lifted the body off; press the lowest places again.
  if (std::all_of(layers.secant.begin(), layers.secant.end(),
                  [](const LayerSecant& l) { return l.touching == 0; })) {
    for (std::size_t i = 0; i < k; ++i) {
      layers.secant[i] = layer(i, layers.stiffness_N_m3, 1e-6 - candidate(i).surface_m);
    }
  }
  return changed;
}

StaticRest SupportRest::under_gravity(double gravity_m_s2, double layer_stiffness_N_m3,
                                      std::span<const double> worn_N) const {
  const std::vector<double>& mass_kg = statics_.mass_kg();
  const std::size_t size = 3 * mass_kg.size();
  const std::size_t k = support_candidate_.size();
  StaticRest rest;
  rest.displacement_m.assign(size, 0.0);
  rest.normal_force_N.assign(contact_.candidate.size(), 0.0);
  rest.penetration_m.assign(contact_.candidate.size(), 0.0);
  if (k == 0 || gravity_m_s2 <= 0.0) return rest;
  double weight = 0.0;
  for (double mass : mass_kg) weight += mass * gravity_m_s2;
  Layers layers = pressed_in(weight, layer_stiffness_N_m3);
  std::vector<double> load(size, 0.0);
  for (int round = 0; round <= kStaticRefinements; ++round) {
    for (std::size_t i = 0; i < size; ++i) {
      load[i] = statics_.shift_1_s2() * mass_kg[i / 3] * rest.displacement_m[i];
      if (i % 3 == 2) load[i] -= mass_kg[i / 3] * gravity_m_s2;
      if (!worn_N.empty()) load[i] += worn_N[i];
    }
    const std::vector<double> free = statics_.shifted_solve(load);
    for (int pass = 0; pass < kMaxPasses; ++pass) {
      solve_forces(free, layers);
      if (!press(free, layers)) break;
    }
    for (std::size_t i = 0; i < k; ++i) load[freedom(i)] += std::max(0.0, layers.force_N[i]);
    rest.displacement_m = statics_.shifted_solve(load);
  }
  for (std::size_t i = 0; i < k; ++i) {
    const auto at = static_cast<std::size_t>(support_candidate_[i]);
    rest.normal_force_N[at] = std::max(0.0, layers.force_N[i]);
    rest.penetration_m[at] = layers.penetration_m[i];
  }
  return rest;
}

}  // namespace unbruised

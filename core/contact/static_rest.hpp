#pragma once

/// @file
/// The state in which a product lies on its support before anything happens.

#include <span>
#include <vector>

#include "core/body/static_solver.hpp"
#include "core/contact/contact_model.hpp"
#include "core/contact/layer_law.hpp"

namespace unbruised {

/// The static state of a product that lies on the support.
struct StaticRest {
  std::vector<double> displacement_m;  ///< [3n]
  std::vector<double> normal_force_N;  ///< per contact candidate, zero but on the support
  std::vector<double> penetration_m;   ///< of the particle into the layer of the support, per contact candidate
};

/// Equilibrium on a frictionless support with a compliant layer. Immutable once built.
class SupportRest {
 public:
  /// Both have to outlive this.
  SupportRest(const StaticSolver& statics, const ContactModel& contact);

  /// @param gravity_m_s2 magnitude along -z
  /// @param layer_stiffness_N_m3 stiffness of the support's layer per area
  /// @param worn_N of what has flowed within the product, in balance, [3n]; empty: nothing has
  [[nodiscard]] StaticRest under_gravity(double gravity_m_s2, double layer_stiffness_N_m3,
                                         std::span<const double> worn_N = {}) const;

 private:
  /// The support's layer under each of its candidates.
  struct Layers {
    double stiffness_N_m3;
    std::vector<double> force_N, penetration_m;
    std::vector<LayerSecant> secant;
  };
  [[nodiscard]] const ContactCandidate& candidate(std::size_t i) const {
    return contact_.candidate[static_cast<std::size_t>(support_candidate_[i])];
  }
  /// Its normal freedom.
  [[nodiscard]] std::size_t freedom(std::size_t i) const {
    return 3 * static_cast<std::size_t>(candidate(i).node) + 2;
  }
  /// How far the particle of candidate i moves per force on that of candidate j.
  [[nodiscard]] double compliance(std::size_t i, std::size_t j) const {
    return compliance_[node_[i] * node_count_ + node_[j]];
  }
  [[nodiscard]] LayerSecant layer(std::size_t i, double layer_stiffness_N_m3, double penetration_m) const;
  /// A body pressed into the layer, to start from.
  [[nodiscard]] Layers pressed_in(double weight_N, double layer_stiffness_N_m3) const;
  /// Forces of the touching layers' secants. @param free_m displacement without them
  void solve_forces(const std::vector<double>& free_m, Layers& layers) const;
  /// Moves the layers to where the forces press them. @return does another set of places touch?
  bool press(const std::vector<double>& free_m, Layers& layers) const;

  const StaticSolver& statics_;
  const ContactModel& contact_;
  std::vector<int> support_candidate_;  ///< candidates on the support
  std::vector<double> share_;           ///< of each one's area that faces the support
  std::vector<std::size_t> node_;       ///< of each one: which of their particles carries it
  std::size_t node_count_ = 0;
  std::vector<double> compliance_;  ///< of the shifted matrix in the normal freedoms of these, [node_count, .]
};

}  // namespace unbruised

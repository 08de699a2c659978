#pragma once

/// @file
/// The patches of contacts as wholes: modes of force over each surface, by which everything that touches answers
/// at once to the change of one force (docs/theory.md, "Contact at long steps").
///
/// At long steps a product gives way to the net forces of its patches more than to all else, and the answer of a
/// whole patch to every local change is what makes sweeps many. So contact c is updated with the matrix
/// A - A Z (Z' A Z)^-1 Z' A in place of A = W + D, D the compliance of the layers. Z are the modes: of each of the
/// forces N, T1, T2 on a surface {1, a, b} over the contacts that are pressed (of T1, T2: that stick as well), a
/// and b their places on its face.
///
/// A force is the contact's own and what the modes add; "amplitudes" are those of the modes.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/contact/contact_model.hpp"
#include "core/lanes/lane.hpp"

namespace unbruised {

class PatchModes {
 public:
  static constexpr std::size_t kForces = 3, kShapes = 3;  ///< N, T1, T2; 1, a, b

  /// The model has to outlive this. @throws std::logic_error where it has surfaces besides the pads of a jaw and
  /// the support, or places that touch
  explicit PatchModes(const ContactModel& model);

  /// What touches in the present step, as ContactSweep lists it; nothing is a member of the modes yet.
  void list(std::span<const int> active_node, std::span<const int> near_candidate);
  /// Whose normal force, and whose tangents, belong to the modes of its surface.
  void set_member(std::size_t candidate, const Mask& pressed, const Mask& sticks);
  /// Lanes in which they do.
  [[nodiscard]] Mask is_member(std::size_t candidate, std::size_t of) const {
    return weight_.get(weight_row(candidate, of)) > Lane(0.0);
  }
  /// By how much pad p goes back per force on pad q, at `[p][q]` [m/N].
  using Fingers = std::array<std::array<Lane, kJawFingers>, kJawFingers>;
  /// Takes in the members of `lanes`, their layers and the fingers.
  /// @param give compliance of a candidate's layer along N, T1, T2: kForces rows each [m/N]
  void prepare(const Mask& lanes, const LaneArray& give, const Fingers& fingers);

  /// Lets the modes answer where a candidate's own force `of` grows by `by`.
  [[gnu::always_inline]] void answer(std::size_t candidate, std::size_t of, const Lane& by) {
    const double* row = answer_.row(kModes * (kForces * candidate + of));
    for (std::size_t m = first_; m < end_; ++m) amplitude_[m] -= load(row + m * kLanes) * by;
  }
  /// What the modes add to a force of a candidate.
  [[nodiscard, gnu::always_inline]] Lane force(std::size_t candidate, std::size_t of) const {
    const Shape& shape = shape_[candidate];
    const std::size_t m = first_mode(candidate, of);
    return weight_.get(weight_row(candidate, of)) *
           (amplitude_[m] + Lane(shape[1]) * amplitude_[m + 1] + Lane(shape[2]) * amplitude_[m + 2]);
  }
  /// To the sum of the normal forces on a pad.
  [[nodiscard, gnu::always_inline]] Lane pad_force(std::size_t pad) const {
    const std::size_t m = kPerSurface * pad;
    return net_[pad][0] * amplitude_[m] + net_[pad][1] * amplitude_[m + 1] + net_[pad][2] * amplitude_[m + 2];
  }
  /// To the displacement of a contact node along an axis.
  [[nodiscard, gnu::always_inline]] Lane displacement(std::size_t node, std::size_t axis) const {
    const double* row = moves_.row(kModes * (3 * node + axis));
    Lane sum(0.0);
    for (std::size_t m = first_; m < end_; ++m) sum += load(row + m * kLanes) * amplitude_[m];
    return sum;
  }
  /// One over what a candidate keeps of a change of its own force.
  [[nodiscard, gnu::always_inline]] Lane inverse_kept(std::size_t candidate, std::size_t of) const {
    return inverse_kept_.get(kForces * candidate + of);
  }
  /// The compliance that a force of a candidate meets where it would meet this one alone [m/N].
  [[nodiscard, gnu::always_inline]] Lane felt(std::size_t candidate, std::size_t of, const Lane& alone) const {
    return (alone - answered_.get(kForces * candidate + of)) * inverse_kept(candidate, of);
  }

  void clear() { amplitude_.fill(Lane(0.0)); }
  /// Starts from what forces do by the body. @param node_force rows 3 x contact node + axis
  void start_residual(const LaneArray& node_force);
  /// Adds by how much a candidate's layer is pressed, or sheared, less than its force asks for, as if forces did
  /// nothing by the body [m].
  void add_residual(std::size_t candidate, std::size_t of, const Lane& lacks_m);
  /// The amplitudes that leave nothing of it in the modes; none outside `lanes`.
  void take_residual(const Mask& lanes);

 private:
  using Shape = std::array<double, kShapes>;
  static constexpr std::size_t kPerSurface = kForces * kShapes;
  static constexpr std::size_t kModes = kPerSurface * kFirstCellSurface;
  using Amplitudes = std::array<Lane, kModes>;
  using Members = std::array<std::array<Lane, 2>, kFirstCellSurface>;  ///< how many, by normal force, by tangents

  [[nodiscard]] std::size_t first_mode(std::size_t candidate, std::size_t of) const {
    return kPerSurface * surface_[candidate] + kShapes * of;
  }
  static std::size_t weight_row(std::size_t candidate, std::size_t of) { return 2 * candidate + (of > 0 ? 1 : 0); }
  /// Row of what a force of a candidate is moved by, in `moves_`.
  [[nodiscard]] std::size_t moved_row(std::size_t candidate, std::size_t of) const;
  void note_changes(const LaneArray& give, const Fingers& fingers);
  void find_moves(std::size_t surface, const Mask& lanes);
  void find_matrix(const Mask& lanes);
  void factor(const Mask& lanes, const Members& members);
  void find_answers(const Mask& lanes);
  void solve(Amplitudes& x) const;

  const ContactModel& model_;
  std::vector<Shape> shape_;          ///< of a candidate: 1, a, b
  std::vector<std::size_t> surface_;  ///< of a candidate
  std::vector<int> node_, near_;      ///< of the present step
  std::size_t first_ = 0, end_ = 0;   ///< modes of the surfaces that something is near
  LaneArray weight_;                  ///< 2 rows a candidate: 1 of members, 0 of others
  // What the rest stands for.
  Mask stale_{true};                             ///< for something else
  std::array<Mask, kFirstCellSurface> moved_{};  ///< for other members of a surface
  LaneArray stood_, given_;                      ///< weights; compliance of members' layers
  Fingers fingers_{};
  LaneArray moves_;          ///< W Z: kModes rows a freedom of a contact node
  LaneArray matrix_, work_;  ///< factor of Z' A Z: kModes x kModes, lower
  Amplitudes inverse_pivot_, amplitude_, residual_;
  std::array<std::array<Lane, kShapes>, kJawFingers> net_;  ///< normal force of a pad per amplitude
  LaneArray answer_;  ///< (Z' A Z)^-1 Z' A: kModes rows a force of a candidate
  LaneArray inverse_kept_, answered_;
};

}  // namespace unbruised

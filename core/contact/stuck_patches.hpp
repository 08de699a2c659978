#pragma once

/// @file
/// What is pressed and sticks, as one linear system (docs/theory.md, "Contact at long steps"). On layers that are
/// straight lines the forces of such contacts solve (W + D + E G E') f = what the layers lack: W the compliance of
/// the product, D that of the layers, E the sums of the pads' normal forces, G how the fingers give way to them.
///
/// W + D is factored once for all steps and lanes that have the same contacts and layers. A layer's compliance is
/// taken with a few bits for that, and what it is off is made good by repeating the solve. Solves are in single
/// precision: they find changes of forces, which sweeps look at again. A patch is a function of what it is asked
/// for alone, so that no lane's bits depend on which others have asked before.

#include <array>
#include <cstddef>
#include <list>
#include <span>
#include <vector>

#include "core/algebra/supernodes.hpp"
#include "core/contact/contact_model.hpp"
#include "core/contact/patch_modes.hpp"
#include "core/lanes/lane.hpp"
#include "core/lanes/single_lanes.hpp"

namespace unbruised {

class StuckPatches {
 public:
  static constexpr std::size_t kForces = PatchModes::kForces;  ///< N, T1, T2

  /// The model has to outlive this. It has no surfaces besides the pads of a jaw and the support.
  explicit StuckPatches(const ContactModel& model);

  /// More contacts than these are not factored: a factor takes too long, and too much memory.
  static constexpr double kMostContacts = 300.0;

  /// Finds the changes of forces that leave layers lacking nothing, in `lanes`.
  /// @param near candidates, ascending; all others carry nothing
  /// @param give compliance of the layer along N, T1, T2, kForces rows each; 0: the candidate carries nothing
  /// [m/N]
  /// @param largest_force_N of the contacts: changes to a tenth of a millionth of it are enough
  /// @param rows by how much a layer is pressed, or sheared, less than its force asks for, kForces rows each [m];
  /// becomes the changes [N]
  /// @return how often each lane's system was solved; 0: it has no solution, and its rows mean nothing
  Lane solve(std::span<const int> near, const LaneArray& give, const PatchModes::Fingers& fingers,
             const Mask& lanes, const Lane& largest_force_N, LaneArray& rows);

 private:
  /// What touches, with how stiff layers.
  struct Patch {
    std::vector<int> candidate;  ///< ascending
    std::vector<double> give;    ///< of all candidates along the normal and across, 0 of others [m/N]
    SupernodalFactor factor;     ///< of W + D, rounded; empty: it has none
    std::array<std::vector<double>, kJawFingers> by_pad;                     ///< (W + D)^-1 E
    std::array<std::array<double, kJawFingers>, kJawFingers> pads_by_pad{};  ///< E' (W + D)^-1 E

    [[nodiscard]] std::size_t freedoms() const { return kForces * candidate.size(); }
  };
  /// Of the i-th member.
  [[nodiscard]] const ContactCandidate& member(const Patch& patch, std::size_t i) const {
    return model_.candidate[static_cast<std::size_t>(patch.candidate[i])];
  }
  void list(std::span<const int> near, const LaneArray& give);
  [[nodiscard]] Mask fits(const Patch& patch, std::span<const int> near) const;
  [[nodiscard]] Patch make(std::span<const int> near, int lane) const;
  void factor(Patch& patch) const;
  Lane solve(const Patch& patch, const LaneArray& give, const PatchModes::Fingers& fingers, const Mask& lanes,
             const Lane& largest_force_N, LaneArray& rows);
  void solve_once(const Patch& patch, const PatchModes::Fingers& fingers, const Mask& lanes);

  const ContactModel& model_;
  std::list<Patch> patch_;  ///< the last used ones, that first
  LaneArray few_bits_;      ///< of the compliances, as a patch has them
  Lane count_{0.0};         ///< of contacts that carry something
  SingleArray x_;           ///< of the present patch, kForces rows a member
  LaneArray sum_;           ///< the same
};

}  // namespace unbruised

// Contacts that stick, as one linear system: its solution put back into it.

#include "core/contact/stuck_patches.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "core/simulation/model_parts.hpp"
#include "tests/core/simulation/scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

constexpr std::size_t kForces = StuckPatches::kForces;

/// A lane's system, and what its layers lack.
struct System {
  const ContactModel& model;
  std::vector<double> give;  ///< of each candidate's forces; 0: the candidate is open
  std::vector<double> lack;
  double finger = 0.0;  ///< both go back by so much per force on themselves, half as far per force on the other

  [[nodiscard]] std::size_t axis(std::size_t row) const {
    const int surface = model.candidate[row / kForces].surface;
    return static_cast<std::size_t>(row % kForces == 0 ? normal_axis(surface)
                                                       : tangent_axes(surface)[row % kForces - 1]);
  }
  [[nodiscard]] double sign(std::size_t row) const {
    return row % kForces == 0 ? normal_sign(model.candidate[row / kForces].surface) : 1.0;
  }
  [[nodiscard]] bool presses_pad(std::size_t row) const {
    return row % kForces == 0 && is_pad(model.candidate[row / kForces].surface);
  }
  /// How far a layer is from what its force asks for.
  [[nodiscard]] double rest(std::size_t row, const std::vector<double>& force) const {
    const std::size_t m = model.node_count();
    double sum = give[row] * force[row];
    for (std::size_t k = 0; k < force.size(); ++k) {
      const auto to = static_cast<std::size_t>(model.candidate[row / kForces].contact_node),
                 from = static_cast<std::size_t>(model.candidate[k / kForces].contact_node);
      sum += sign(row) * sign(k) * force[k] * model.compliance[9 * (to * m + from) + 3 * axis(row) + axis(k)];
      if (!presses_pad(row) || !presses_pad(k)) continue;
      const bool same = model.candidate[row / kForces].surface == model.candidate[k / kForces].surface;
      sum += (same ? 1.0 : 0.5) * finger * force[k];
    }
    return lack[row] - sum;
  }
};

class StuckPatchesTest : public ::testing::Test {
 protected:
  std::shared_ptr<const Model> built = build(small_box());
  const ContactModel& model = built->parts().contact;
  std::size_t rows = kForces * model.candidate.size();
  std::vector<int> near = std::vector<int>(model.candidate.size());

  void SetUp() override { std::iota(near.begin(), near.end(), 0); }

  /// Layers that differ from contact to contact by some per cent, some contacts open.
  System system(double softer, std::size_t every) const {
    System made{model, std::vector<double>(rows, 0.0), std::vector<double>(rows, 0.0), 2e-4};
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t c = row / kForces;
      if (every > 0 && c % every == 0) continue;
      made.give[row] = softer * (row % kForces == 0 ? 1e-4 : 3e-4) * (1.0 + 0.002 * static_cast<double>(c));
      made.lack[row] = 1e-5 * std::sin(static_cast<double>(row) + softer);
    }
    return made;
  }
  /// Solves each in a lane. @return forces of each, all 0 where there is no solution
  std::vector<std::vector<double>> solve(StuckPatches& patches, const std::vector<System>& systems) const {
    LaneArray give(rows), changes(rows);
    PatchModes::Fingers fingers;
    for (auto& row : fingers) row.fill(Lane(0.0));
    Mask lanes(false);
    for (std::size_t lane = 0; lane < systems.size(); ++lane) {
      const auto at = static_cast<int>(lane);
      lanes.set(at, true);
      for (std::size_t row = 0; row < rows; ++row) {
        give.at(row, at) = systems[lane].give[row];
        changes.at(row, at) = systems[lane].lack[row];
      }
      for (std::size_t p = 0; p < kJawFingers; ++p) {
        for (std::size_t q = 0; q < kJawFingers; ++q) {
          fingers[p][q].set(at, (p == q ? 1.0 : 0.5) * systems[lane].finger);
        }
      }
    }
    const Lane solves = patches.solve(near, give, fingers, lanes, Lane(kLargest_N), changes);
    std::vector<std::vector<double>> forces(systems.size(), std::vector<double>(rows, 0.0));
    for (std::size_t lane = 0; lane < systems.size(); ++lane) {
      EXPECT_GT(solves[static_cast<int>(lane)], 0.0);
      for (std::size_t row = 0; row < rows; ++row) {
        if (systems[lane].give[row] > 0.0) forces[lane][row] = changes.at(row, static_cast<int>(lane));
      }
    }
    return forces;
  }

  static constexpr double kLargest_N = 1.0;
};

TEST_F(StuckPatchesTest, LeaveLayersNothingToAskFor) {
  const std::vector<System> systems = {system(1.0, 0), system(1.05, 0), system(1.0, 3), system(7.0, 4)};
  StuckPatches patches(model);
  const std::vector<std::vector<double>> forces = solve(patches, systems);
  for (std::size_t lane = 0; lane < systems.size(); ++lane) {
    double largest = 0.0;
    for (std::size_t row = 0; row < rows; ++row) {
      if (!(systems[lane].give[row] > 0.0)) continue;
      largest = std::max(largest, std::abs(forces[lane][row]));
      // The last change was below 1e-7 of the largest force, and an eighth of it is left at most.
      const double as_force_N = systems[lane].rest(row, forces[lane]) / systems[lane].give[row];
      EXPECT_LT(std::abs(as_force_N), 1e-7 * kLargest_N) << lane << " " << row;
    }
    EXPECT_GT(largest, 1e-3) << lane;
  }
}

TEST_F(StuckPatchesTest, SayTheSameWhateverWasAskedBefore) {
  const System wanted = system(1.02, 3);
  StuckPatches fresh(model), used(model);
  const auto alone = solve(fresh, {wanted});
  // More patches than are kept.
  for (int i = 0; i < 40; ++i) solve(used, {system(1.0 + 0.3 * i, 0), system(1.0, 5)});
  const auto after = solve(used, {system(1.0, 0), wanted, system(1.3, 3)});
  EXPECT_EQ(alone[0], after[1]);
}

}  // namespace
}  // namespace unbruised

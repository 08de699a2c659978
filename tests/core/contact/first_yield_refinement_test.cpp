// The upper end of the kiwi's grip window does not depend on the cell size: its patch area comes from elasticity,
// its force from the simulation, so this guards the force and the metric, not the area (docs/validation.md).

#include <gtest/gtest.h>

#include "tests/core/contact/kiwi_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

TEST(FirstYield, OfTheKiwiAtTheShippedCellSizeIsThatOfAFinerLattice) {
  const double shipped = yield_force_N(kiwi_grip(0.005), 3.0, 9.0);
  const double fine = yield_force_N(kiwi_grip(0.05 / 14), 3.0, 9.0);
  EXPECT_NEAR(shipped, fine, 0.15 * fine);
  std::cout << "[ measured ] first yield at 5 mm: " << shipped << " N, at 3.57 mm: " << fine << " N\n";
}

TEST(FirstYield, InTheCellsOfTheLatticeComesDownTowardsThatOfThePatch) {
  // What the lattice itself says, cell by cell: late while a cell averages the peak away, less so when finer.
  const auto first_flow_N = [](double cell_size_m) {
    for (const ScenarioResult& grip : run_grips(kiwi_grip(cell_size_m), 4.0, 16.0)) {
      if (grip.metrics[Metric::plastic_strain_max] > 0.0) return grip.metrics[Metric::peak_finger_force_N];
    }
    return std::nan("");
  };
  const double coarse = first_flow_N(0.00625), shipped = first_flow_N(0.005), fine = first_flow_N(0.05 / 14);
  const double patch = yield_force_N(kiwi_grip(0.005), 3.0, 9.0);
  EXPECT_LT(shipped, coarse);
  EXPECT_LT(fine, shipped);
  EXPECT_GT(fine, patch);
}

}  // namespace
}  // namespace unbruised
